/* frames - renders a frame step by step and checks every pixel
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_FRAMES_H
#define REFERENCE_FRAMES_H

#include "engine/planelet.h"

typedef struct frame_result {
    int status;     /* of plt_render_begin, else PLT_OK */
    uint8_t *rgb;   /* width * height pixels, rows top down; free() it */
    uint64_t hash;  /* board/hash.h, of these bytes; 0 after a failure */
    uint32_t wrong; /* pixels that were not painted exactly once */
    uint32_t tiles;
    uint64_t steps, most_visits; /* node visits of the longest step */
} frame_result;

frame_result frame_render(plt_engine *engine, const plt_frame *frame, uint32_t visits);

/* Only the hash; `rgb` is freed. */
uint64_t frame_hash(plt_engine *engine, const plt_frame *frame, uint32_t visits);

plt_frame frame_of(const float eye[3], const float look[3], uint16_t width, uint16_t height,
                   uint8_t shader);

#endif
