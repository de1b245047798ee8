/* structure_types - what every structure is asked for, and what it counts
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_STRUCTURE_TYPES_H
#define BASELINES_STRUCTURE_TYPES_H

#include <stdint.h>

/* Since structure_open, or, of rays, since structure_forget. What is not counted is 0. */
typedef struct structure_statistics {
    uint64_t rays;
    uint64_t node_visits; /* nodes, or cells, and leaves but those of bvh, bph and treelets, which
                           * are links; of packets once per packet */
    uint64_t box_tests;   /* planes or boxes that a ray, or four rays, were held against */
    uint64_t triangle_tests; /* a ray, or four rays, against a triangle */
    uint64_t sieved;         /* triangles put aside by less than a test */
    uint64_t build_work;     /* triangles of ranges or cells that were split, once each time */
    uint64_t bytes;          /* now: nodes, and what leads from them to triangles */
    uint64_t thesis_bytes;   /* now: the same as Table 5.1 counts it (BASELINES.md) */
    uint64_t triangle_bytes; /* now: the triangles themselves, and what belongs to each */
    uint32_t nodes;          /* now: inner ones */
    uint32_t leaves;         /* now: that are not empty */
    uint32_t unsplit;        /* now: left until a ray comes */
    uint32_t references;     /* now: of leaves to triangles */
    uint32_t strays;         /* now: likewise, of triangles that are not in them (kd_stray.h) */
    /* Of packets, as the thesis counts them (section 5.4, Table 5.4). A packet meets a node when it
     * is held against its planes, a triangle when it is held against that, however many of its rays
     * are: rays_at_* are those of the packets, masked_at_* those of them that were masked out. */
    uint64_t packets;  /* with at least one ray */
    uint64_t one_sign; /* of those, that go one way along each axis */
    uint64_t packet_nodes, rays_at_nodes, masked_at_nodes;
    uint64_t packet_triangles, rays_at_triangles, masked_at_triangles;
    uint64_t early_hits;     /* boxes that the first active rays met, and so no other was asked */
    uint64_t frustum_misses; /* that the hull of all rays missed, likewise */
    /* Of a BPH (bph_trace.h). */
    uint64_t early_tests, frustum_tests;
    uint64_t reconstructions; /* boxes of children, where an early hit had left rays unknown */
    uint64_t recomputed;      /* boxes of an intermediate node's lists, from their triangles */
    uint64_t plane_matches;   /* planes matched with near and far, for a packet or a ray */
    uint32_t intermediates;   /* now: intermediate nodes, which are leaves */
} structure_statistics;

/* What switches choose, each its group of values; 0: as the kind does it by itself. A kind's own
 * groups begin at STRUCTURE_OWN. */
enum structure_choice {
    STRUCTURE_SPLITS,  /* enum structure_splits */
    STRUCTURE_LEAF,    /* triangles of a leaf */
    STRUCTURE_SIDE,    /* rays along a packet's side; 1: rays go one by one */
    STRUCTURE_MASKS,   /* enum structure_masks */
    STRUCTURE_EARLY,   /* 1: early hit test, 2: none */
    STRUCTURE_FRUSTUM, /* 1: frustum test, 2: none */
    STRUCTURE_OWN,
    STRUCTURE_CHOICES = STRUCTURE_OWN + 10
};

enum structure_splits { STRUCTURE_MEDIAN = 1, STRUCTURE_SAH = 2 };
enum structure_masks { STRUCTURE_RANGE = 1, STRUCTURE_BITS = 2 };

typedef struct structure_options {
    uint8_t packet_side; /* of those that have packets; 0: 8 */
    uint8_t
        one_by_one; /* 1: all rays are traced for themselves by those that can; 0: as they look */
    uint8_t choice[STRUCTURE_CHOICES];
} structure_options;

/* One of a kind's switches: a name, a phrase, and what it chooses. Of a group one may be given. */
typedef struct structure_switch {
    const char *name, *about;
    uint8_t group; /* enum structure_choice, or a kind's own */
    uint8_t value; /* above 0 */
} structure_switch;

/* Those that mean the same for every kind that has them. */
#define STRUCTURE_SPLIT_SWITCHES                                                                   \
    {"median", "splits in the spatial median, as the thesis does", STRUCTURE_SPLITS,               \
     STRUCTURE_MEDIAN},                                                                            \
    {                                                                                              \
        "sah", "splits by the surface area heuristic", STRUCTURE_SPLITS, STRUCTURE_SAH             \
    }
#define STRUCTURE_LEAF_SWITCHES                                                                    \
    {"leaf-1", "one triangle per leaf", STRUCTURE_LEAF, 1},                                        \
        {"leaf-2", "two triangles per leaf at most", STRUCTURE_LEAF, 2},                           \
        {"leaf-3", "three triangles per leaf at most", STRUCTURE_LEAF, 3}, {                       \
        "leaf-4", "four triangles per leaf at most", STRUCTURE_LEAF, 4                             \
    }
#define STRUCTURE_SIDE_SWITCHES                                                                    \
    {"2x2", "packets of 4 rays", STRUCTURE_SIDE, 2},                                               \
        {"4x4", "packets of 16 rays", STRUCTURE_SIDE, 4}, {                                        \
        "8x8", "packets of 64 rays", STRUCTURE_SIDE, 8                                             \
    }
#define STRUCTURE_SIDE_16_SWITCH                                                                   \
    { "16x16", "packets of 256 rays", STRUCTURE_SIDE, 16 }
#define STRUCTURE_SINGLE_SWITCH                                                                    \
    { "single", "rays one by one", STRUCTURE_SIDE, 1 }
#define STRUCTURE_MASK_SWITCHES                                                                    \
    {"range", "rays from the first active group to the last", STRUCTURE_MASKS, STRUCTURE_RANGE}, { \
        "bits", "active rays alone, by a mask of all", STRUCTURE_MASKS, STRUCTURE_BITS             \
    }
#define STRUCTURE_EARLY_SWITCHES                                                                   \
    {"early", "where the first active rays meet a box, no other is asked", STRUCTURE_EARLY, 1}, {  \
        "no-early", "every active ray is", STRUCTURE_EARLY, 2                                      \
    }
#define STRUCTURE_FRUSTUM_SWITCHES                                                                 \
    {"frustum", "where the hull of all rays misses a box, no ray is asked", STRUCTURE_FRUSTUM, 1}, \
    {                                                                                              \
        "no-frustum", "active rays are", STRUCTURE_FRUSTUM, 2                                      \
    }

#endif
