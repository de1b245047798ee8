/* treelet_trees_structure - see treelet_trees_structure.h
 *
 * A frame is a new tree.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/treelet_trees/treelet_trees_structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/base/triangle_set.h"
#include "host_tools/baselines/treelet_trees/treelet_trees.h"
#include "host_tools/baselines/treelets/treelets_choice.h"

typedef struct treelet_structure {
    binary_options build;
    treelet_wish wish;
    enum treelet_form form;
    triangle_set triangles;
    treelet_trees tree;
    treelet_tracing tracing;
    packet_state packet;
    uint64_t work;
    int is_whole; /* 0: memory ran out, and there is no tree to trace */
    char name[64];
} treelet_structure;

static int out_of_memory(treelet_structure *s, fail *f) {
    s->is_whole = 0;
    return fail_set(f, s->name, "%u triangles: out of memory for a hierarchy; leave some out",
                    (unsigned)s->triangles.count);
}

static int build(treelet_structure *s, const mesh *m, fail *f) {
    binary_tree t = {.node = NULL};
    treelet_trees_free(&s->tree);
    int status = triangle_set_fill(&s->triangles, m);
    if (status == 0) {
        status = binary_tree_build(&t, s->triangles.record, s->triangles.count, &s->triangles.box,
                                   &s->build);
    }
    if (status == 0 && t.nodes > 0) {
        status = treelet_trees_make(&s->tree, &t, s->form, &s->wish);
    }
    s->work += t.work;
    s->is_whole = status == 0;
    binary_tree_free(&t);
    return status == 0 ? 0 : out_of_memory(s, f);
}

static void close_trees(void *self) {
    treelet_structure *s = self;
    treelet_trees_free(&s->tree);
    treelet_tracing_free(&s->tracing);
    triangle_set_free(&s->triangles);
    packet_close(&s->packet);
    heap_drop(s);
}

static void choose(treelet_structure *s, const structure_options *o) {
    const uint8_t *c = o->choice;
    s->build.splits = c[STRUCTURE_SPLITS] == STRUCTURE_SAH ? PLT_SPLIT_SAH : PLT_SPLIT_MEDIAN;
    s->build.by_grid = s->form == TREELET_BIH && c[STRUCTURE_SPLITS] == 0;
    s->build.leaf = c[STRUCTURE_LEAF] != 0 ? c[STRUCTURE_LEAF] : 1;
    treelets_choose(o, &s->wish, &s->tracing);
}

static void *open_trees(unsigned variant, const mesh *m, const structure_options *o,
                        const char *name, fail *f) {
    treelet_structure *s = heap_get_zeroed(sizeof *s);
    if (s == NULL) {
        return NULL;
    }
    s->form = (enum treelet_form)variant;
    strncpy(s->name, name, sizeof s->name - 1);
    choose(s, o);
    if (packet_open(&s->packet, o->packet_side) != 0) {
        out_of_memory(s, f);
        close_trees(s);
        return NULL;
    }
    if (build(s, m, f) != 0) {
        close_trees(s);
        return NULL;
    }
    return s;
}

static int move_trees(void *self, const mesh *m, fail *f) {
    return build(self, m, f);
}

static int trace_trees(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                       fail *f) {
    treelet_structure *s = self;
    if (!s->is_whole) {
        return out_of_memory(s, f);
    }
    if (s->triangles.count == 0) {
        packet_store_misses(hits, count, any);
        s->packet.counts.rays += count;
        return 0;
    }
    s->tracing.nodes = &s->tree.nodes;
    s->tracing.packet = &s->packet;
    return treelet_trace_packets(&s->tracing, rays, hits, count, any) == 0 ? 0
                                                                           : out_of_memory(s, f);
}

static void count_trees(const void *self, structure_statistics *to) {
    const treelet_structure *s = self;
    packet_counts_put(&s->packet.counts, to);
    to->nodes = s->tree.inner;
    to->leaves = s->tree.leaves;
    to->bytes = (uint64_t)s->tree.blocks * s->tree.size * treelet_form_words(s->form) * 4;
    to->thesis_bytes = to->bytes; /* and what slots without a node take beside Table 5.5 */
    to->references = s->triangles.count;
    to->triangle_bytes = (uint64_t)s->triangles.count * sizeof(plt_record);
    to->build_work = s->work;
}

static void forget_trees(void *self) {
    treelet_structure *s = self;
    s->packet.counts = (packet_counts){.rays = 0};
    s->tracing.entered = 0;
}

static const structure_switch switches[] = {STRUCTURE_SPLIT_SWITCHES, STRUCTURE_LEAF_SWITCHES,
                                            STRUCTURE_SIDE_SWITCHES,  STRUCTURE_SIDE_16_SWITCH,
                                            TREELETS_SWITCHES,        {NULL, NULL, 0, 0}};

#define TREES_KIND(NAME, FORM, ABOUT)                                                              \
    {                                                                                              \
        .name = NAME, .about = ABOUT, .variant = FORM, .open = open_trees, .move = move_trees,     \
        .trace = trace_trees, .count = count_trees, .forget = forget_trees, .close = close_trees,  \
        .switches = switches                                                                       \
    }

const structure_kind structure_bvh_treelets =
    TREES_KIND("bvh-treelets", TREELET_BVH, "the hierarchy of two boxes in treelets of 64 nodes");
const structure_kind structure_bkd_treelets =
    TREES_KIND("bkd-treelets", TREELET_BKD, "the B-KD tree, likewise");
const structure_kind structure_bih_treelets =
    TREES_KIND("bih-treelets", TREELET_BIH, "the bounding interval hierarchy, likewise");
