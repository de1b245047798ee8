/* bph_planes - rays against the planes of a box, or against those that a child owns
 *
 * A child's box is its parent's with the planes put in that it owns, and each of those lies within.
 * So clipping the parent's interval by them gives what the whole box would, bit for bit:
 * distances are monotone in the plane, and of near ones the greatest counts, of far ones the least.
 * A node has six planes, each of one child: both children take six distances together, where whole
 * boxes take twelve.
 *
 * Distances are those of lone_ray.h, so no box is left out that has a hit.
 *
 * Source: Karrenberg 2007, section 3.5 and figure 3.7; Kay and Kajiya, "Ray tracing complex
 * scenes", 1986; Boulos, Wald and Shirley, "Geometric and arithmetic culling methods for entire ray
 * packets", 2006 (the hull, by interval arithmetic).
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BPH_PLANES_H
#define BASELINES_BPH_PLANES_H

#include "engine/tree/thesis/node.h"
#include "host_tools/baselines/bph/bph_packet.h"

typedef struct bph_plane {
    float at;
    uint8_t axis, is_max;
} bph_plane;

typedef struct bph_planes {
    bph_plane plane[6];
    uint32_t count;
} bph_planes;

/* Where rays enter and leave; empty where from > to. */
typedef struct bph_intervals {
    float from[BPH_RAYS], to[BPH_RAYS];
} bph_intervals;

bph_planes bph_planes_of_box(const plt_box *box);
bph_planes bph_planes_owned(const plt_node *node, int child);

/* A ray's interval, cut by all of them; whether something is left of it. */
int bph_planes_cut(const bph_planes *b, const bph_packet *p, uint32_t ray, float *from, float *to);

/* Those of rays first .. last, from `in` to `out`; is_mixed: signs are looked at ray by ray. `out`
 * may be `in`. */
void bph_planes_cut_all(const bph_planes *b, const bph_packet *p, uint32_t first, uint32_t last,
                        int is_mixed, const bph_intervals *in, bph_intervals *out);

/* Of `rays` those whose interval is not empty. */
bph_set bph_intervals_left(const bph_intervals *of, const bph_set *rays);

/* None of the packet's rays, whose signs are equal, meets the planes' box. */
int bph_planes_miss(const bph_planes *b, const bph_packet *p);

#endif
