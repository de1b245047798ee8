/* job - what the firmware is to do, read from its parameters
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_JOB_H
#define PLT_BOARD_JOB_H

#include "engine/planelet.h"

typedef struct job {
    plt_frame frame;
    plt_options options;
    uint32_t visits; /* per step of the main loop */
    uint32_t shown;  /* if options.movable: the frame of the image's sequence */
    unsigned given;  /* bit 0 eye, 1 look, 2 up, 3 tan: in the parameters */
} job;

/* Reads all but the camera's defaults; `*arena_bytes` shrinks to what
 * arena= asks for. On a wrong parameter prints a line and returns -1. */
int job_read(job *j, const char *parameters, size_t *arena_bytes);

/* Sets what the parameters left open of the camera: the scene's box in view, from
 * the front, right and above. (`planelet render` fits its view more closely, in
 * double; it gives its camera to the firmware as bits, see tests/qemu.) */
void job_set_camera(job *j, const plt_info *info);

#endif
