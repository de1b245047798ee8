/* bvh_structure - see bvh_structure.h
 *
 * A frame is a new tree, in the memory of the last one.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bvh/bvh_structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/base/triangle_set.h"
#include "host_tools/baselines/bvh/bvh_pair.h"
#include "host_tools/baselines/bvh/bvh_ranged.h"

enum variant { PAIR, RANGED };

typedef struct bvh_structure {
    unsigned variant;
    binary_options build;
    packet_steps steps;
    uint8_t has_bits; /* masks of active rays, not ranges */
    triangle_set triangles;
    binary_tree tree;   /* of PAIR only while it is built */
    bvh_pair_tree pair; /* of PAIR */
    packet_state packet;
    int is_whole; /* 0: memory ran out, and there is no tree to trace */
    char name[64];
} bvh_structure;

static int out_of_memory(bvh_structure *b, fail *f) {
    b->is_whole = 0;
    return fail_set(f, b->name, "%u triangles: out of memory for a hierarchy; leave some out",
                    (unsigned)b->triangles.count);
}

static int build(bvh_structure *b, const mesh *m, fail *f) {
    b->is_whole = triangle_set_fill(&b->triangles, m) == 0 &&
                  binary_tree_build(&b->tree, b->triangles.record, b->triangles.count,
                                    &b->triangles.box, &b->build) == 0;
    if (b->is_whole && b->variant == PAIR && m->triangles > 0) {
        b->is_whole = bvh_pair_make(&b->pair, &b->tree) == 0;
        binary_tree_free(&b->tree);
    }
    return b->is_whole ? 0 : out_of_memory(b, f);
}

static void close_bvh(void *self) {
    bvh_structure *b = self;
    triangle_set_free(&b->triangles);
    binary_tree_free(&b->tree);
    bvh_pair_free(&b->pair);
    packet_close(&b->packet);
    heap_drop(b);
}

/* What was not chosen is as the thesis has it, or as Wald et al. have it. */
static void choose(bvh_structure *b, const structure_options *o) {
    const int is_wald = b->variant == RANGED;
    const uint8_t *c = o->choice;
    const int has_sah = c[STRUCTURE_SPLITS] != 0 ? c[STRUCTURE_SPLITS] == STRUCTURE_SAH : is_wald;
    b->build.splits = has_sah ? PLT_SPLIT_SAH : PLT_SPLIT_MEDIAN;
    b->build.leaf = c[STRUCTURE_LEAF] != 0 ? c[STRUCTURE_LEAF] : is_wald ? 4 : 1;
    b->build.by_cost = (uint8_t)(is_wald && has_sah);
    b->steps.early = c[STRUCTURE_EARLY] != 0 ? c[STRUCTURE_EARLY] == 1 : is_wald;
    b->steps.frustum = c[STRUCTURE_FRUSTUM] != 0 ? c[STRUCTURE_FRUSTUM] == 1 : is_wald;
    b->has_bits = c[STRUCTURE_MASKS] == STRUCTURE_BITS;
}

static void *open_bvh(unsigned variant, const mesh *m, const structure_options *o, const char *name,
                      fail *f) {
    bvh_structure *b = heap_get_zeroed(sizeof *b);
    if (b == NULL) {
        return NULL;
    }
    b->variant = variant;
    strncpy(b->name, name, sizeof b->name - 1);
    choose(b, o);
    if (packet_open(&b->packet, o->packet_side) != 0) {
        out_of_memory(b, f);
        close_bvh(b);
        return NULL;
    }
    if (build(b, m, f) != 0) {
        close_bvh(b);
        return NULL;
    }
    return b;
}

static int move_bvh(void *self, const mesh *m, fail *f) {
    return build(self, m, f);
}

static void trace_packet(bvh_structure *b) {
    if (b->variant == PAIR) {
        bvh_pair_trace(&b->pair, &b->packet, b->steps);
    } else if (b->has_bits) {
        bvh_trace_bits(&b->tree, &b->packet, b->steps);
    } else {
        bvh_trace_range(&b->tree, &b->packet, b->steps);
    }
}

static int trace_bvh(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                     fail *f) {
    bvh_structure *b = self;
    const uint32_t most = b->packet.side * b->packet.side;
    if (!b->is_whole) {
        return out_of_memory(b, f);
    }
    if (b->triangles.count == 0) {
        packet_store_misses(hits, count, any);
        b->packet.counts.rays += count;
        return 0;
    }
    for (uint32_t i = 0; i < count; i += most) {
        const uint32_t left = count - i, now = left < most ? left : most;
        if (packet_begin(&b->packet, &b->triangles.box, rays + i, now, any)) {
            trace_packet(b);
        }
        packet_store(&b->packet, hits + i);
    }
    return 0;
}

static void count_nodes(const bvh_structure *b, structure_statistics *to) {
    if (b->variant == PAIR) {
        to->nodes = b->pair.nodes;
        to->leaves = b->pair.lists;
        to->bytes = (uint64_t)b->pair.nodes * sizeof *b->pair.node;
        to->thesis_bytes = (uint64_t)b->pair.nodes * BVH_PAIR_THESIS_BYTES;
    } else {
        to->nodes = b->tree.nodes - b->tree.leaves;
        to->leaves = b->tree.leaves;
        to->bytes = to->thesis_bytes = (uint64_t)b->tree.nodes * sizeof *b->tree.node;
    }
    to->references = b->triangles.count;
    to->triangle_bytes = (uint64_t)b->triangles.count * sizeof(plt_record);
    to->build_work = b->tree.work;
}

static void count_bvh(const void *self, structure_statistics *to) {
    const bvh_structure *b = self;
    packet_counts_put(&b->packet.counts, to);
    count_nodes(b, to);
}

static void forget_bvh(void *self) {
    ((bvh_structure *)self)->packet.counts = (packet_counts){.rays = 0};
}

static const structure_switch pair_switches[] = {
    STRUCTURE_SPLIT_SWITCHES,   STRUCTURE_LEAF_SWITCHES, STRUCTURE_EARLY_SWITCHES,
    STRUCTURE_FRUSTUM_SWITCHES, STRUCTURE_SIDE_SWITCHES, STRUCTURE_SIDE_16_SWITCH,
    {NULL, NULL, 0, 0}};

static const structure_switch ranged_switches[] = {
    STRUCTURE_SPLIT_SWITCHES, STRUCTURE_LEAF_SWITCHES,    STRUCTURE_MASK_SWITCHES,
    STRUCTURE_EARLY_SWITCHES, STRUCTURE_FRUSTUM_SWITCHES, STRUCTURE_SIDE_SWITCHES,
    STRUCTURE_SIDE_16_SWITCH, {NULL, NULL, 0, 0}};

#define BVH_KIND(NAME, VARIANT, SWITCHES, ABOUT)                                                   \
    {                                                                                              \
        .name = NAME, .about = ABOUT, .variant = VARIANT, .open = open_bvh, .move = move_bvh,      \
        .trace = trace_bvh, .count = count_bvh, .forget = forget_bvh, .close = close_bvh,          \
        .switches = SWITCHES                                                                       \
    }

const structure_kind structure_bvh =
    BVH_KIND("bvh", PAIR, pair_switches,
             "the thesis's hierarchy of two boxes per node, by spatial median, unoptimised");
const structure_kind structure_wbvh =
    BVH_KIND("wbvh", RANGED, ranged_switches,
             "hierarchy of one box per node after Wald, Boulos and Shirley: 1 to 4 triangles per "
             "leaf by the surface area heuristic, early hit, frustum, ranges");
