/* packet_counts - what is counted of packets, as the thesis counts it
 *
 * Source: Karrenberg 2007, section 5.4, Table 5.4.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PACKET_COUNTS_H
#define BASELINES_PACKET_COUNTS_H

#include <stdint.h>

#include "host_tools/baselines/base/structure_types.h"

typedef struct packet_counts {
    uint64_t rays;    /* that were asked for, rays or not */
    uint64_t packets; /* with at least one ray */
    uint64_t signs;   /* of those: all rays point to the same sides along all axes */
    /* A packet against a node, whichever planes that has; against a triangle. Of its rays those
     * that were masked out. */
    uint64_t nodes, node_rays, node_rays_out;
    uint64_t triangles, triangle_rays, triangle_rays_out;
    /* What it took: four rays against a box or a node's planes, or against a triangle; boxes that
     * the first active rays met, or that the frustum missed. */
    uint64_t group_tests, triangle_tests, early_hits, frustum_misses;
} packet_counts;

static inline void packet_count_node(packet_counts *c, uint32_t rays, uint32_t active) {
    c->nodes++;
    c->node_rays += rays;
    c->node_rays_out += rays - active;
}

static inline void packet_count_triangles(packet_counts *c, uint32_t triangles, uint32_t rays,
                                          uint32_t active) {
    c->triangles += triangles;
    c->triangle_rays += (uint64_t)rays * triangles;
    c->triangle_rays_out += (uint64_t)(rays - active) * triangles;
}

/* What a kind whose rays go in packets says of them. */
static inline void packet_counts_put(const packet_counts *c, structure_statistics *to) {
    to->rays = c->rays;
    to->node_visits = c->nodes;
    to->box_tests = c->group_tests;
    to->triangle_tests = c->triangle_tests;
    to->packets = c->packets;
    to->one_sign = c->signs;
    to->packet_nodes = c->nodes;
    to->rays_at_nodes = c->node_rays;
    to->masked_at_nodes = c->node_rays_out;
    to->packet_triangles = c->triangles;
    to->rays_at_triangles = c->triangle_rays;
    to->masked_at_triangles = c->triangle_rays_out;
    to->early_hits = c->early_hits;
    to->frustum_misses = c->frustum_misses;
}

#endif
