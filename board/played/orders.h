/* orders - what the firmware is to play, and in steps of what size
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_ORDERS_H
#define PLT_BOARD_ORDERS_H

#include "board/job.h"

typedef struct orders {
    job picture; /* frame, camera, options, visits per plt_render_step */
    size_t arena_bytes;
    uint32_t first, end;  /* frames first .. end - 1 of the image's sequence; end 0: to its last */
    uint32_t blocks;      /* per plt_sequence_step */
    uint32_t triangles;   /* per plt_rebuild_step, of which there is one per frame */
    uint8_t rebuild_when; /* enum plt_rebuild_when */
    const char *parameters;
} orders;

/* On a wrong parameter prints a line and returns -1. */
int orders_read(orders *o, const char *parameters, size_t arena_bytes);

#endif
