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
#include "engine/shade/sampling.h"
#include "engine/trace/traversal.h"
#include "engine/trace/triangle_ray.h"
#include "engine/tree/compact/block_tree.h"
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

#define PLT_PLANE_LEAST 7.8886090522101181e-31f /* 2^-100: what underflow takes of a plane */

/* The least t at which some ray may enter a box, minus the greatest at which some may leave
 * it, and what the box leads to: of thesis nodes. 12 bytes. */
typedef struct plt_beam_entry {
    float enter, minus_leave;
    uint32_t link;
} plt_beam_entry;

/* The same of compact blocks, whose planes are relative to the box: in lattice coordinates.
 * 40 bytes; where scenes are streamed, 44. */
typedef struct plt_beam_block_entry {
    uint32_t lo[3];
    float enter;
    uint32_t hi[3];
#if PLT_WITH_STREAMED_COMPACT
    float end; /* of a streamed scene: where the subtree of its block ends (plt_stream_end) */
#endif
    uint32_t link, target; /* plt_block_target */
    float minus_leave;
} plt_beam_block_entry;

/* A plane of a box bounds where rays enter it or where they leave it: t = (plane - org) *
 * factor, in the latter case its negative. */
typedef struct plt_beam_plane {
    float org, factor;
    uint32_t leaves; /* 0 or 1 */
} plt_beam_plane;

/* Triangles that are no records become some when a pixel may have them. */
#define PLT_BEAMS_STORE (PLT_WITH_COMPACT || PLT_WITH_VERTICES)

typedef struct plt_beam {
    const plt_view *view;
    const plt_record *records;
    plt_pixel *pixel; /* [row * side + column], behind this */
    plt_margins margins;
    plt_ray_origin origin;
    /* of the current square */
    plt_pixels square;
    uint32_t columns, rows;  /* inside the frame */
    float first[3];          /* direction of its first pixel */
    float row_x[3];          /* x + margins.bias: of q = corner - eye, times w, in pixels */
    float row_y[3];          /* y likewise */
    int32_t end_x, end_y;    /* its last column and row, as numbers of lines.h */
    plt_beam_plane plane[6]; /* lo x, y, z, hi x, y, z */
    int8_t doubt, doubt_leaf;
    float far;                     /* no pixel has a hit behind it */
    uint32_t open;                 /* pixels without a hit */
    uint8_t is_mixed, is_stored;   /* rays differ in sign; a pixel has a new hit */
    int8_t node_doubt, leaf_doubt; /* plt_beam_hides */
#if PLT_WITH_COMPACT
    float box_x[3], box_y[3];   /* of x and y alone: boxes are projected by them */
    const plt_block_tree *tree; /* that leaves of the current block are read by */
#endif
#if PLT_BEAMS_STORE
    plt_record *store; /* of strips, or vertices: `records` is that, behind the pixels */
    uint32_t next;     /* where to look for a record of it that no pixel has */
#endif
#if PLT_BEAMS_STORE && PLT_WITH_PAGES
    uint32_t *index; /* in the image, of records of the store; NULL: nobody asks */
#endif
} plt_beam;

/* Of a record that pixels have. Without pages 0. */
static inline uint32_t plt_beam_image_index(const plt_beam *b, uint32_t record) {
#if PLT_BEAMS_STORE && PLT_WITH_PAGES
    return b->index != NULL ? b->index[record] : record;
#else
    (void)b;
    return PLT_WITH_PAGES ? record : 0;
#endif
}

/* Bytes of a beam and, behind it, the pixels of side^2 rays. */
static inline size_t plt_beam_bytes(unsigned side) {
    return sizeof(plt_beam) + (size_t)side * side * sizeof(plt_pixel);
}

_Static_assert(sizeof(plt_beam) + 4 * sizeof(plt_pixel) <=
                   sizeof(plt_group_slabs) + sizeof(plt_group_rays),
               "a beam fits where the groups of a packet do, of any size");

/* The store has more records than there are pixels, so some can be used again. */
static inline uint32_t plt_beam_store_records(unsigned side) {
    return side * side + side * side / 2;
}

/* Bytes of a beam over compact blocks, or vertices. */
static inline size_t plt_beam_blocks_bytes(unsigned side) {
    return plt_beam_bytes(side) + plt_beam_store_records(side) * sizeof(plt_record);
}

/* Where there are groups, too, a beam over compact blocks is of so many rays along a side at
 * least, else it would take more than they do. */
#define PLT_BEAM_BLOCKS_LEAST 4

_Static_assert(sizeof(plt_beam) + 16 * sizeof(plt_pixel) + 24 * sizeof(plt_record) <=
                   4 * (sizeof(plt_group_slabs) + sizeof(plt_group_rays)),
               "it fits where the groups do");

/* Sets up what the format keeps from square to square; where there are groups, plt_state_init
 * does. */
void plt_beam_state_init(plt_traversal *t);

/* Starts a frame; `b` is the front of plt_beam_bytes(side), or plt_beam_blocks_bytes(side). */
void plt_beam_init(plt_beam *b, const plt_view *view, const plt_frame *frame,
                   const plt_scene *scene, uint32_t side);

/* Starts a square, and counts it and its `rays`. */
void plt_beam_begin(plt_beam *b, const plt_pixels *square, plt_traversal *t, uint32_t rays);

/* Works off stack entries, as plt_traverse; of a streamed scene a fetch may fail. */
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

#if PLT_WITH_SAMPLES || PLT_WITH_DIAGRAMS
/* The same of samples, and of distances: rows of `sky` and of `rgb` are of pixels. Adaptive: also
 * sets s->mixed. */
void plt_beam_mix(plt_beam *b, plt_sampling *s, const uint8_t *sky, uint8_t *rgb,
                  uint32_t row_bytes);
#endif

/* ---- between the files of the beam --------------------------------------------- */

/* Of components of directions. */
typedef struct plt_beam_range {
    float least, most;
} plt_beam_range;

/* How rays from `origin` with directions in a box meet planes. 0: the directions have no length,
 * and the rays meet nothing. */
int plt_beam_planes(plt_beam_plane plane[6], const plt_ray_origin *origin,
                    const plt_beam_range range[3]);

/* Puts the root on the stack. */
void plt_beam_push_root(plt_beam *b, plt_traversal *t);

/* What is counted while stack entries are worked off. */
typedef struct plt_beam_counts {
    uint32_t nodes, triangles;
} plt_beam_counts;

/* May some pixel have a hit in the box of an entry, no farther than what it has? The beam as a
 * whole meets boxes that none of its rays does. */
int plt_beam_sees(const plt_beam *b, const plt_beam_block_entry *entry);

/* Surely not: asked where it pays. `doubt` learns how often boxes are hidden. */
int plt_beam_hides(const plt_beam *b, int8_t *doubt, const plt_beam_block_entry *entry);

/* Works off stack entries of thesis nodes, over records and over vertices. */
plt_beam_counts plt_beam_trace_nodes(plt_beam *b, plt_traversal *t, uint32_t visits);
plt_beam_counts plt_beam_trace_vertices(plt_beam *b, plt_traversal *t, uint32_t visits);

/* Of compact blocks, resident and streamed (beam_blocks.h): sets up what is kept from square to
 * square; puts the root on the stack, if there is one; works off stack entries, with PLT_OK or what
 * a fetch failed with. */
#define PLT_BEAM_BLOCKS_DECLARED(name)                                                             \
    void plt_beam_##name##_init(plt_traversal *t);                                                 \
    void plt_beam_##name##_push(plt_beam *b, plt_traversal *t, const plt_beam_entry *root);        \
    int plt_beam_##name##_trace(plt_beam *b, plt_traversal *t, uint32_t visits,                    \
                                plt_beam_counts *counts);
PLT_BEAM_BLOCKS_DECLARED(resident)
PLT_BEAM_BLOCKS_DECLARED(streamed)
#undef PLT_BEAM_BLOCKS_DECLARED

/* Of grids (beam_grid.c): sets up what is kept from square to square; starts at the first slice
 * that the beam may reach, if there is one; works off slices. */
void plt_beam_grid_init(plt_traversal *t);
void plt_beam_grid_push(const plt_beam *b, plt_traversal *t);
plt_beam_counts plt_beam_grid_trace(plt_beam *b, plt_traversal *t, uint32_t visits);

/* Which way the beam goes through a grid: all of `g` but slice, step and left. */
struct plt_grid_beam;
void plt_beam_grid_slopes(struct plt_grid_beam *g, const plt_beam *b);

/* Triangles that were met have `stamp` in the mailbox; how many were met first here. */
typedef struct plt_beam_marks {
    uint32_t *mailbox, stamp, met;
} plt_beam_marks;

/* Tests the triangles that references are of, each once. Stops at one that is a crowded cell's
 * (PLT_GRID_CROWDED): returns how many come before that. */
uint32_t plt_beam_references(plt_beam *b, const uint32_t *reference, uint32_t count,
                             plt_beam_marks *marks);

/* No pixel is open any more: sets `far` to the greatest t. */
void plt_beam_update_far(plt_beam *b);

/* Tests the triangles of so many lists in a row, and gives their hits to the pixels. Returns how
 * many there were. `single`: 1 if every triangle counts as a list, 0. */
uint32_t plt_beam_lists(plt_beam *b, uint32_t first, uint32_t lists, uint32_t single);

/* Tests triangles first .. first + count - 1 of a block, at most PLT_LEAF_TRIANGLES_MOST. */
void plt_beam_strips(plt_beam *b, const plt_geometry *geometry, uint32_t first, uint32_t count);

/* A record of the store that no pixel has, not marked (beam_records.c); for the caller to fill. */
plt_record *plt_beam_free_record(plt_beam *b);

/* Makes a triangle of a leaf, `index` in the image, a record of the store. It stays one until the
 * next is made, and as long as a pixel has it. */
const plt_record *plt_beam_store(plt_beam *b, const plt_leaf *leaf, uint32_t triangle,
                                 uint32_t index);

/* Tests a triangle exactly: for a pixel of the square, or for all that it is not surely outside
 * of, as planes through the eye and its edges tell. */
void plt_beam_test_pixel(plt_beam *b, const plt_record *record, uint32_t x, uint32_t y);
void plt_beam_test_planes(plt_beam *b, const plt_record *record);

/* Pixels of the square, both ends included. */
typedef struct plt_beam_part {
    uint32_t left, right, top, bottom;
} plt_beam_part;

#if PLT_WITH_SAMPLES
/* plt_beam_test_planes where a pixel has several samples, for those pixels of the square that have
 * any in `part` (beam_samples.c). */
void plt_beam_test_samples(plt_beam *b, const plt_record *record, const plt_beam_part *part);
#endif

/* A triangle that is not projected. */
static inline void plt_beam_test_unprojected(plt_beam *b, const plt_record *record) {
#if PLT_WITH_SAMPLES
    if (b->view->across > 1) {
        const plt_beam_part all = {0, b->columns - 1, 0, b->rows - 1};
        plt_beam_test_samples(b, record, &all);
        return;
    }
#endif
    plt_beam_test_planes(b, record);
}

static inline void plt_beam_take(plt_beam *b, plt_pixel *pixel, float t, uint32_t record) {
    b->open -= pixel->record == PLT_MISS;
    b->is_stored = 1;
    pixel->t = t;
    pixel->record = record;
}

/* Moves one end of the interval of an entry to a plane at `at`. */
static inline void plt_beam_bound(plt_beam_entry *e, const plt_beam_plane *plane, float at) {
    const float t = (at - plane->org) * plane->factor;
    float *to = plane->leaves ? &e->minus_leave : &e->enter;
    *to = t > *to ? t : *to;
}

static inline int plt_beam_meets(const plt_beam *b, float enter, float minus_leave) {
    return enter <= -minus_leave && enter <= b->far;
}

#endif
