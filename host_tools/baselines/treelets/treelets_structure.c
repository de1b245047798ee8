/* treelets_structure - see treelets_structure.h
 *
 * A frame is a new tree.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/treelets/treelets_structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/treelets/treelet_bph.h"
#include "host_tools/baselines/treelets/treelets_choice.h"

typedef struct treelets_structure {
    treelet_bph_options options;
    treelet_bph tree;
    treelet_tracing tracing;
    packet_state packet;
    uint64_t work;
    int is_whole; /* 0: memory ran out, and there is no tree to trace */
    char name[64];
} treelets_structure;

static void choose(treelets_structure *s, const structure_options *o) {
    const uint8_t leaf = o->choice[STRUCTURE_LEAF], bit = o->choice[TREELETS_BIT];
    s->options.splits =
        o->choice[STRUCTURE_SPLITS] == STRUCTURE_SAH ? PLT_SPLIT_SAH : PLT_SPLIT_MEDIAN;
    s->options.leaf_triangles = leaf != 0 ? leaf : 1;
    s->options.edges = bit != 0 ? (enum node_edges)(bit - 1) : NODE_EDGES_PARITY;
    treelets_choose(o, &s->options.wish, &s->tracing);
}

static int build(treelets_structure *s, const mesh *m, fail *f) {
    treelet_bph_free(&s->tree);
    s->is_whole = treelet_bph_make(&s->tree, m, &s->options, s->name, f) == 0;
    s->work += m->triangles;
    return s->is_whole ? 0 : -1;
}

static void close_treelets(void *self) {
    treelets_structure *s = self;
    treelet_bph_free(&s->tree);
    treelet_tracing_free(&s->tracing);
    packet_close(&s->packet);
    heap_drop(s);
}

static void *open_treelets(unsigned variant, const mesh *m, const structure_options *o,
                           const char *name, fail *f) {
    treelets_structure *s = heap_get_zeroed(sizeof *s);
    (void)variant;
    if (s == NULL) {
        return NULL;
    }
    strncpy(s->name, name, sizeof s->name - 1);
    choose(s, o);
    if (packet_open(&s->packet, o->packet_side) != 0 || build(s, m, f) != 0) {
        close_treelets(s);
        return NULL;
    }
    return s;
}

static int move_treelets(void *self, const mesh *m, fail *f) {
    return build(self, m, f);
}

static int trace_treelets(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                          fail *f) {
    treelets_structure *s = self;
    if (!s->is_whole) {
        return fail_set(f, s->name, "out of memory for treelets; leave out triangles");
    }
    if (s->tree.image.info.triangles == 0) {
        packet_store_misses(hits, count, any);
        s->packet.counts.rays += count;
        return 0;
    }
    s->tracing.nodes = &s->tree.nodes;
    s->tracing.packet = &s->packet;
    if (treelet_trace_packets(&s->tracing, rays, hits, count, any) != 0) {
        s->is_whole = 0;
        return fail_set(f, s->name, "out of memory for edges that wait; choose smaller treelets");
    }
    return 0;
}

static void count_treelets(const void *self, structure_statistics *to) {
    const treelets_structure *s = self;
    const plt_info *info = &s->tree.image.info;
    packet_counts_put(&s->packet.counts, to);
    to->nodes = info->nodes;
    to->leaves = info->leaf_lists + info->intermediate_lists;
    to->bytes = (uint64_t)s->tree.blocks * s->tree.size * sizeof(plt_node);
    to->thesis_bytes = to->bytes; /* Table 5.1 and the overhead of Table 5.5 */
    to->references = info->triangles;
    to->triangle_bytes = (uint64_t)info->triangles * sizeof(plt_record);
    to->build_work = s->work;
}

static void forget_treelets(void *self) {
    treelets_structure *s = self;
    s->packet.counts = (packet_counts){.rays = 0};
    s->tracing.entered = 0;
}

static const structure_switch switches[] = {
    STRUCTURE_SPLIT_SWITCHES,
    STRUCTURE_LEAF_SWITCHES,
    STRUCTURE_SIDE_SWITCHES,
    STRUCTURE_SIDE_16_SWITCH,
    TREELETS_SWITCHES,
    {"parity-bit", "edges are told by the thesis's bit, which alternates", TREELETS_BIT,
     NODE_EDGES_PARITY + 1},
    {"direct-bit", "by the engine's, which says it", TREELETS_BIT, NODE_EDGES_DIRECT + 1},
    {NULL, NULL, 0, 0}};

const structure_kind structure_treelets = {
    .name = "treelets",
    .about = "the thesis's hierarchy of planes, by spatial median, in treelets of 64 nodes",
    .open = open_treelets,
    .move = move_treelets,
    .trace = trace_treelets,
    .count = count_treelets,
    .forget = forget_treelets,
    .close = close_treelets,
    .switches = switches};
