/* grid_state - how far a packet, or a beam, is on its way through a grid
 *
 * A packet goes through a grid in *turns*, one for each axis and direction that is the largest of
 * any of its rays; a turn in *bundles*, its groups as long as they are close together; a bundle
 * slice after slice. A *slice* is a layer of cells across the turn's axis.
 *
 * Depth is what has been gone along the axis from the turn's plane; coordinates are
 * relative to the least corner of the scene's box. A *bound* is linear in depth, and rays that
 * belong to it are never below it, from depth 0 to `length`; there are four, for both axes x and y
 * after the turn's: x, y, -x and -y.
 *
 * A beam (shade/beam_grid.c) goes slice after slice, too, and is not taken apart.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_GRID_STATE_H
#define PLT_TRACE_GRID_STATE_H

#include <string.h>

#include "engine/grid/slices.h"
#include "engine/trace/traversal.h"

#if PLT_WITH_GROUPS

/* Four groups, or four quads of groups, side by side. */
enum { PLT_GRID_QUADS = (PLT_GROUPS_MAX + 3) / 4, PLT_GRID_SIXTEENS = (PLT_GROUPS_MAX + 15) / 16 };

/* Of four groups, or quads; [bound][lane]. Those without rays are at PLT_BOX_FAR. */
typedef struct plt_grid_bounds {
    float base[4][4], rate[4][4]; /* at depth 0, and for each step of 1 */
} plt_grid_bounds;

/* Of all groups of a quad; [bound]. */
typedef struct plt_grid_quad {
    float base[4], end[4]; /* at depths 0 and length */
} plt_grid_quad;

/* What is left out, for figures alone (tests/measure). */
enum plt_grid_without {
    PLT_GRID_WITHOUT_MAILBOX = 1,
    PLT_GRID_WITHOUT_CULLING = 2, /* of triangles beside the frustum, or beside groups */
    PLT_GRID_WITHOUT_GROUPS = 4,  /* of triangles beside groups */
    PLT_GRID_WITHOUT_RECTANGLES = 8,
    PLT_GRID_WITHOUT_MACRO = 16 /* of slabs whose macro cells are empty */
};

typedef struct plt_grid_turn {
    int x, y, z;        /* axes; z is the turn's */
    float sign;         /* 1, or -1: rays run down along z */
    float plane;        /* at depth 0, as a coordinate of the scene */
    float length;       /* bounds hold up to here, all of the grid */
    float margin;       /* what anything is moved by, to be sure */
    float close;        /* of one origin: triangles so deep are looked at by slopes; PLT_BOX_FAR */
    float offset[4][4]; /* what makes coordinates, or minus them, reach towards a bound: the scene's
                           least corner and the margin; each in all lanes */
    plt_mask groups;    /* with rays */
    uint32_t next;      /* group that the next bundle begins with */
    uint8_t lanes_left; /* of group `next`, if its rays go one by one */
} plt_grid_turn;

typedef struct plt_grid_bundle {
    plt_mask groups; /* those that may still hit something, as far as is known */
    unsigned first;  /* its lowest group */
    float base[4], rate[4];
    plt_grid_bounds all; /* the same in all lanes */
    float soonest;       /* depth up to which all of its groups seek hits */
    int32_t slice, last, step;
    int32_t slab;   /* of macro cells: it was looked at; -1: none */
    uint32_t stamp; /* in the mailbox: triangles that it has met */
} plt_grid_bundle;
#endif

#if PLT_WITH_BEAMS
/* The rays of a beam as the grid sees them. */
typedef struct plt_grid_beam {
    int x, y, z;    /* axes; z is the one along which its rays run, mostly */
    float sign;     /* 1, or -1: they run down along z; 0: some do and some do not, or hardly */
    float slope[4]; /* along x and y per step along z: the least, and minus the greatest */
    float quickest; /* no ray gets further along z in a t of 1 */
    float margin;   /* what anything is moved by, to be sure */
    int32_t slice, step, left; /* the next, and how many there are from there */
} plt_grid_beam;
#endif

typedef struct plt_grid_state {
    uint32_t stamp; /* the last in the mailbox */
#if PLT_WITH_BEAMS
    plt_grid_beam beam;
#endif
#if PLT_WITH_GROUPS
    plt_grid_turn turn;
    plt_grid_bundle bundle;          /* groups 0: there is none */
    unsigned turns;                  /* begun: 0 .. 6 */
    uint8_t without;                 /* enum plt_grid_without */
    uint8_t lanes[PLT_GROUPS_MAX];   /* of the turn */
    float from[4 * PLT_GRID_QUADS];  /* depth at which a group begins ... */
    float until[4 * PLT_GRID_QUADS]; /* ... and up to which it seeks hits */
    plt_grid_bounds group[PLT_GRID_QUADS];
    plt_grid_bounds quad[PLT_GRID_SIXTEENS];
    plt_grid_bounds sixteen; /* of packets of more than 16 groups */
    plt_grid_quad ends[PLT_GRID_QUADS];
#endif
} plt_grid_state;

/* The mailbox lies behind the state: of each record the last bundle or beam that met it. */
static inline uint32_t *plt_grid_mailbox(plt_grid_state *s) {
    return (uint32_t *)(void *)(s + 1);
}

static inline plt_grid_state *plt_grid_state_of(const plt_traversal *t) {
    return (plt_grid_state *)t->state;
}

/* A number that is not in the mailbox, of so many records; 0 is what an empty one has. */
static inline uint32_t plt_grid_next_stamp(plt_grid_state *s, uint32_t records) {
    if (++s->stamp == 0) {
        memset(plt_grid_mailbox(s), 0, records * sizeof(uint32_t));
        s->stamp = 1;
    }
    return s->stamp;
}

static inline void plt_grid_state_clear(plt_grid_state *s, uint32_t records) {
    memset(s, 0, sizeof *s);
    memset(plt_grid_mailbox(s), 0, records * sizeof(uint32_t));
}

#if PLT_WITH_GROUPS
/* Four bounds of x and y. */
static inline f4 plt_grid_four(float x, float y, float minus_x, float minus_y) {
    const float four[4] = {x, y, minus_x, minus_y};
    return f4_load(four);
}
#endif

#endif
