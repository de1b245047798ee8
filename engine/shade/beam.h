/* beam - a square of pixels, traced as one beam
 *
 * All rays start at the eye and their directions lie in one box, the beam. Nodes are tested
 * against the beam alone; a triangle is projected once, and only pixels that it may cover are
 * looked at. Where it surely covers one, and surely nearer than what is there, it is taken with a
 * bound of its t; else the exact test of one ray (trace/triangle_ray.h) decides. So a pixel has the
 * triangle that plt_trace would find, and plt_beam_settle gives its t, bit for bit.
 *
 * Invariant: what the beam leaves out no ray of it would have hit (DESIGN.md, section 7.7).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_BEAM_H
#define PLT_SHADE_BEAM_H

#include "engine/shade/margins.h"
#include "engine/trace/traversal.h"
#include "engine/trace/triangle_ray.h"
#include "engine/tree/record.h"

/* The nearest hit of a pixel so far. 8 bytes. Its t is exact, or, with PLT_PIXEL_BOUND, no less
 * than that and more by no more than PLT_PIXEL_SLACK of it. */
typedef struct plt_pixel {
    float t;         /* PLT_VIEW_FAR: none */
    uint32_t record; /* PLT_MISS: none */
} plt_pixel;

#define PLT_PIXEL_BOUND 0x80000000u /* in `record`; indices have 27 bits */
#define PLT_PIXEL_SLACK 0x1p-6f

static inline uint32_t plt_pixel_record(const plt_pixel *p) {
    return p->record & ~PLT_PIXEL_BOUND;
}

/* The least t at which some ray may enter a box, minus the greatest at which some may leave
 * it, and what the box leads to. 12 bytes. */
typedef struct plt_beam_entry {
    float enter, minus_leave;
    uint32_t link;
} plt_beam_entry;

/* A plane of a box bounds where rays enter it or where they leave it: t = (plane - org) *
 * factor, in the latter case its negative. */
typedef struct plt_beam_plane {
    float org, factor;
    uint32_t leaves; /* 0 or 1 */
} plt_beam_plane;

typedef struct plt_beam {
    const plt_view *view;
    const plt_record *records;
    plt_pixel *pixel; /* [row * side + column], behind this */
    plt_margins margins;
    plt_ray_origin origin;
    /* of the current square */
    plt_pixels square;
    uint32_t columns, rows;      /* inside the frame */
    float first[3];              /* direction of its first pixel */
    float row_x[3], row_y[3];    /* x, y: of q = corner - eye, times w, in pixels */
    float end_x, end_y;          /* its last column and row */
    plt_beam_plane plane[6];     /* lo x, y, z, hi x, y, z */
    float far;                   /* no pixel has a hit behind it */
    uint32_t open;               /* pixels without a hit */
    uint8_t is_mixed, is_stored; /* rays differ in sign; a pixel has a new hit */
} plt_beam;

/* Bytes of a beam and, behind it, the pixels of side^2 rays. */
static inline size_t plt_beam_bytes(unsigned side) {
    return sizeof(plt_beam) + (size_t)side * side * sizeof(plt_pixel);
}

_Static_assert(sizeof(plt_beam) + 4 * sizeof(plt_pixel) <=
                   sizeof(plt_group_slabs) + sizeof(plt_group_rays),
               "a beam fits where the groups of a packet do, of any size");

/* Starts a frame of a scene of thesis nodes or a list; `b` is the front of
 * plt_beam_bytes(side). */
void plt_beam_init(plt_beam *b, const plt_view *view, const plt_frame *frame,
                   const plt_scene *scene, uint32_t side);

/* Starts a square, and counts it and its `rays`. */
void plt_beam_begin(plt_beam *b, const plt_pixels *square, plt_traversal *t, uint32_t rays);

/* Works off stack entries, as plt_traverse. */
int plt_beam_trace(plt_beam *b, plt_traversal *t, uint32_t visits);

/* Makes the t of a pixel that has a hit exact. */
void plt_beam_settle(plt_beam *b, uint32_t x, uint32_t y);

/* Whether no pixel has a hit. Then they may not have been set up at all. */
static inline int plt_beam_is_empty(const plt_beam *b) {
    return b->open == b->columns * b->rows;
}

/* Colours of the square; `sky`: of each row where nothing is hit, 3 bytes; rows of pixels are
 * `row_bytes` apart. */
void plt_beam_shade(const plt_beam *b, const plt_frame *frame, const uint8_t *sky, uint8_t *rgb,
                    uint32_t row_bytes);

/* ---- between the files of the beam --------------------------------------------- */

/* Puts the root on the stack. */
void plt_beam_push_root(plt_beam *b, plt_traversal *t);

/* Tests the triangles of so many lists in a row, and gives their hits to the pixels. Returns how
 * many there were. `single`: 1 if every triangle counts as a list, 0. */
uint32_t plt_beam_lists(plt_beam *b, uint32_t first, uint32_t lists, uint32_t single);

#endif
