/* baseline_render - frames by a structure of host_tools/baselines
 *
 * Rays, hits and colours are the engine's, bit for bit: so are the frames. Tiles of 16x16 pixels
 * are traced in Z order, so that packets are squares; pixels behind the frame's edge are no rays.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINE_RENDER_H
#define BASELINE_RENDER_H

#include "engine/tree/record.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/baseline.h"
#include "host_tools/picture/picture.h"

/* Where the triangles of an engine are; all zero: nowhere yet. */
typedef struct baseline_colours {
    const plt_record *record; /* the engine's */
    uint32_t *place;          /* owned: of each id its record */
} baseline_colours;

int baseline_colours_make(baseline_colours *c, const plt_engine *engine, const char *name, fail *f);
void baseline_colours_free(baseline_colours *c);

/* A frame into a picture of its size, with a camera that the engine takes. Adds to `seconds` what
 * the processor took, and to `bar`, which has come to `done`, each tile. */
int baseline_render(const baseline *b, const baseline_colours *c, const plt_frame *frame,
                    picture *to, double *seconds, progress *bar, uint64_t done, fail *f);

#endif
