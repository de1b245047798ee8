/* frame_scenes - scenes and cameras whose frames show what packets and beams leave out
 *
 * Cameras anywhere over triangles large, small and odd, and views straight down on grids, whose
 * corners and edges lie on pixels, so that no sieve is sure of them. Packets of every size, trees
 * of several, in either order.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_FRAME_SCENES_H
#define REFERENCE_FRAME_SCENES_H

#include "engine/scene/scene.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"

typedef struct frame_scenes {
    uint32_t side_most;                             /* pixels along the side of a frame */
    void (*set)(plt_frame *frame, random_state *r); /* shader, samples, background */
    /* Each of them; scene->engine NULL: tiny limits have no room for it. */
    void (*each)(const rig *scene, const plt_frame *frame, const char *what);
} frame_scenes;

void frame_scenes_anywhere(const frame_scenes *s);
void frame_scenes_down(const frame_scenes *s);

/* The record of a triangle that is in the scene. */
const plt_record *frame_scenes_record(const plt_scene *scene, uint32_t id);

#endif
