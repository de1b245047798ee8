/* job - what the firmware is to do, read from its parameters
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_JOB_H
#define PLT_BOARD_JOB_H

#include "engine/planelet.h"

typedef struct job {
    plt_frame frame;
    plt_options options;
#if PLT_WITH_WHITTED
    plt_lighting lighting; /* of PLT_SHADE_WHITTED */
#endif
    uint32_t visits; /* per step of the main loop */
    unsigned given;  /* bit 0 eye, 1 look, 2 up, 3 tan: in the parameters */
} job;

/* Reads all but the camera's defaults, and the program's own `more_keys`, which may be there too;
 * `*arena_bytes` shrinks to what arena= asks for. On a wrong parameter prints a line and returns
 * -1. */
int job_read(job *j, const char *parameters, const char *more_keys, size_t *arena_bytes);

/* An item that may be absent, of a key of the program's own: an integer, or one of several words,
 * whose index *choice becomes. 0: absent, and nothing has changed; 1: read; -1: wrong, and a line
 * says so. */
int job_u32(const char *parameters, const char *key, uint32_t least, uint32_t most,
            uint32_t *value);
int job_word(const char *parameters, const char *key, const char *const *words, unsigned count,
             uint8_t *choice);

/* Sets what the parameters left open of the camera: the scene's box in view, from
 * the front, right and above. (`planelet render` fits its view more closely, in
 * double, and asks rays what is seen; it gives its camera to the firmware as bits, see
 * tests/qemu and DESIGN.md, 9.3.) */
void job_set_camera(job *j, const plt_info *info);

#endif
