/* bph_structure - see bph_structure.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bph/bph_structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/base/triangle_set.h"
#include "host_tools/baselines/bph/bph_refit.h"
#include "host_tools/baselines/bph/bph_trace.h"

typedef struct bph_structure {
    bph_tree tree;
    bph_tracing *tracing;
    uint32_t triangles;
    uint32_t packet; /* rays */
    uint64_t build_work;
    int is_whole; /* 0: memory ran out, and there is no tree to trace */
    char name[64];
} bph_structure;

static int out_of_memory(bph_structure *b, fail *f) {
    bph_tree_free(&b->tree);
    b->is_whole = 0;
    return fail_set(f, b->name, "%u triangles: out of memory for a hierarchy; leave some out",
                    (unsigned)b->triangles);
}

/* From triangles to a binary BVH, and from that to planes. -1: no memory. */
static int convert(bph_structure *b, triangle_set *set) {
    const bph_way *way = &b->tracing->way;
    const binary_options how = {.splits = way->splits,
                                .leaf = (uint8_t)way->format.most,
                                .by_cost = way->format.has_counts};
    binary_tree binary = {.node = NULL};
    int status = binary_tree_build(&binary, set->record, set->count, &set->box, &how);
    bph_tree_free(&b->tree);
    if (status == 0 && set->count > 0) {
        status = bph_convert(&b->tree, &binary, &way->format) == BPH_CONVERTED ? 0 : -1;
    }
    b->build_work += binary.work;
    binary_tree_free(&binary);
    return status;
}

static int build(bph_structure *b, const mesh *m, fail *f) {
    bph_tracing *t = b->tracing;
    triangle_set set = {.record = NULL};
    int status = triangle_set_fill(&set, m);
    status = status == 0 ? convert(b, &set) : -1;
    triangle_set_free(&set);
    heap_drop(t->stack);
    t->stack = heap_get(bph_trace_entries(&b->tree) * sizeof *t->stack);
    t->tree = &b->tree;
    b->is_whole = status == 0 && t->stack != NULL;
    return b->is_whole ? 0 : out_of_memory(b, f);
}

static void close_bph(void *self) {
    bph_structure *b = self;
    if (b->tracing != NULL) {
        heap_drop(b->tracing->stack);
    }
    heap_drop(b->tracing);
    bph_tree_free(&b->tree);
    heap_drop(b);
}

static void *open_bph(unsigned variant, const mesh *m, const structure_options *o, const char *name,
                      fail *f) {
    bph_structure *b = heap_get_zeroed(sizeof *b);
    (void)variant;
    if (b == NULL) {
        return NULL;
    }
    const uint32_t given = o->packet_side > 0 ? o->packet_side : 8;
    const uint32_t side = given < BPH_SIDE ? given : BPH_SIDE;
    b->packet = o->one_by_one ? 1 : side * side;
    strncpy(b->name, name, sizeof b->name - 1);
    b->tracing = heap_get_zeroed(sizeof *b->tracing);
    if (b->tracing == NULL) {
        close_bph(b);
        return NULL;
    }
    b->tracing->way = bph_way_of(o);
    b->triangles = (uint32_t)m->triangles;
    if (build(b, m, f) != 0) {
        close_bph(b);
        return NULL;
    }
    return b;
}

static int move_bph(void *self, const mesh *m, fail *f) {
    bph_structure *b = self;
    if (b->tracing->way.rebuilds || !b->is_whole) {
        return build(b, m, f);
    }
    if (m->triangles > 0) {
        triangle_set_move(b->tree.record, b->tree.records, m);
        if (bph_refit(&b->tree) == BPH_REFIT_NO_MEMORY) {
            return out_of_memory(b, f);
        }
    }
    return 0;
}

/* Rays that hit nothing, whatever there is, are not in the packet. */
static void trace_packet(bph_structure *b, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    bph_tracing *t = b->tracing;
    bph_packet *p = &t->packet;
    uint16_t of[BPH_RAYS];
    p->count = 0;
    for (uint32_t i = 0; i < count; i++) {
        lone_ray_store_miss(&hits[i], t->any);
        of[p->count] = (uint16_t)i;
        p->count += lone_ray_set(&p->ray[p->count], &b->tree.box, &rays[i]) != 0;
    }
    if (p->count > 0) {
        bph_packet_begin(p);
        bph_trace(t);
    }
    for (uint32_t i = 0; i < p->count; i++) {
        lone_ray_store(&p->ray[i], &hits[of[i]], t->any);
    }
}

static int trace_bph(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                     fail *f) {
    bph_structure *b = self;
    if (!b->is_whole) {
        return out_of_memory(b, f);
    }
    b->tracing->any = any;
    b->tracing->counts.rays += count;
    for (uint32_t i = 0; i < count; i += b->packet) {
        const uint32_t left = count - i, now = left < b->packet ? left : b->packet;
        if (b->tree.records > 0) {
            trace_packet(b, rays + i, hits + i, now);
        } else {
            for (uint32_t n = 0; n < now; n++) {
                lone_ray_store_miss(&hits[i + n], any);
            }
        }
    }
    return 0;
}

static void count_bph(const void *self, structure_statistics *to) {
    const bph_structure *b = self;
    const bph_tally *t = &b->tracing->tally;
    packet_counts_put(&b->tracing->counts, to);
    to->triangle_tests = t->tests;
    to->box_tests = t->distances;
    to->early_tests = t->early_tests;
    to->early_hits = t->early_hits;
    to->frustum_tests = t->frustum_tests;
    to->frustum_misses = t->frustum_exits;
    to->reconstructions = t->reconstructions;
    to->recomputed = t->recomputed;
    to->plane_matches = t->matches;
    to->build_work = b->build_work;
    to->bytes = to->thesis_bytes = bph_tree_bytes(&b->tree);
    to->triangle_bytes = (uint64_t)b->tree.records * sizeof(plt_record);
    to->nodes = b->tree.nodes;
    to->leaves = b->tree.lists + b->tree.intermediates;
    to->intermediates = b->tree.intermediates;
    to->references = b->tree.records;
}

static void forget_bph(void *self) {
    bph_structure *b = self;
    b->tracing->counts = (packet_counts){.rays = 0};
    b->tracing->tally = (bph_tally){.tests = 0};
}

const structure_kind structure_bph = {
    .name = "bph",
    .about = "the thesis's Bounding Plane Hierarchy, with all of its switches",
    .open = open_bph,
    .move = move_bph,
    .trace = trace_bph,
    .count = count_bph,
    .forget = forget_bph,
    .close = close_bph,
    .switches = bph_switches,
    .suits = bph_switches_suit};
