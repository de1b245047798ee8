/* margins - how far off a pixel may be, for one camera and frame
 *
 * Triangles are projected in single precision; what is looked at around their pixels is
 * wider by these margins, so that no ray is left out that the exact test would find a hit
 * for. Proof: DESIGN.md, section 7.7.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_MARGINS_H
#define PLT_SHADE_MARGINS_H

#include "engine/shade/camera.h"

/* Width and height together of a triangle whose corners are all near the square that it meets, in
 * pixels. */
#define PLT_SMALL_SIZE 128.0f

typedef struct plt_margins {
    float pixels; /* between a projected corner and a ray, in pixels */
#if PLT_WITH_SAMPLES
    float reach; /* `pixels`, and as far as samples are beside their lines */
#endif
    float bias;             /* of coordinates in pixels: PLT_LINE_FIRST and plt_margins_reach */
    float edge, edge_least; /* of edge functions: times width and height, and added to that */
#if PLT_WITH_SAMPLES
    float small_edge, small_growth; /* of a small triangle, instead of `edge`: of the smallest,
                                     * and how much it grows with width and height */
#endif
    int32_t lines; /* twice plt_margins_reach, as plt_lines_between takes it off */
    float corner;  /* farthest corner from a square's first pixel that is projected, in pixels */
    float size;    /* width and height of a triangle that needs no look at its corners, in pixels */
    float depth;   /* of a corner whose x alone says that it is beside a square */
    float plane;   /* of a plane through the eye and an edge, times the corners' distances */
    float row_w[3];   /* w: of q = corner - eye, depth in directions through pixels */
    float det;        /* right . (down x direction), of every pixel */
    float step;       /* between the directions of two pixels */
    float direction;  /* 3 * the longest through a pixel; above that to a projected corner */
    float t, shape;   /* of 1 / t: a share of itself, and one that depends on the shape */
    uint8_t all_deep; /* all corners in the scene's box are beyond `depth`; `project` */
    uint8_t project;  /* 0: the field is too wide or too narrow, nothing is projected */
} plt_margins;

/* Between a projected corner and the line of pixels that a ray is of. */
static inline float plt_margins_reach(const plt_margins *m) {
#if PLT_WITH_SAMPLES
    return m->reach;
#else
    return m->pixels;
#endif
}

/* A row of the projection times q. Where the machine multiplies and adds at once, with a rounding
 * less than the margins are for. */
static inline float plt_along(const float q[3], const float row[3]) {
#if defined(__ARM_FEATURE_FMA) || defined(__FMA__)
    return __builtin_fmaf(q[2], row[2], __builtin_fmaf(q[1], row[1], q[0] * row[0]));
#else
    return q[0] * row[0] + q[1] * row[1] + q[2] * row[2];
#endif
}

/* `scene`: the box of all triangles; `reach`: of rays from the eye. */
void plt_margins_set(plt_margins *m, const plt_view *view, const plt_frame *frame, uint32_t side,
                     const plt_box *scene, float reach);

#endif
