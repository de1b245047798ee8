/* treelets_structure - see treelets_structure.h
 *
 * A frame is a new tree.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/treelets/treelets_structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/treelets/treelet_bph.h"
#include "host_tools/baselines/treelets/treelet_orders.h"

const uint32_t treelets_sizes[TREELETS_SIZES] = {2, 3, 7, 8, 16, 64, 256, 512, 10000};

enum { SIZE_64 = 6 };

typedef struct treelets_structure {
    treelet_bph_options options;
    treelet_bph tree;
    treelet_tracing tracing;
    packet_state packet;
    uint64_t work;
    int is_whole; /* 0: memory ran out, and there is no tree to trace */
    char name[64];
} treelets_structure;

/* What a switch of a group chose, or else. */
static uint8_t chosen(const structure_options *o, unsigned group, uint8_t otherwise) {
    return o->choice[group] != 0 ? (uint8_t)(o->choice[group] - 1) : otherwise;
}

static void choose(treelets_structure *s, const structure_options *o) {
    const uint8_t leaf = o->choice[STRUCTURE_LEAF];
    const uint8_t order = chosen(o, TREELETS_ORDER, TREELET_FIGURE);
    s->options.splits =
        o->choice[STRUCTURE_SPLITS] == STRUCTURE_SAH ? PLT_SPLIT_SAH : PLT_SPLIT_MEDIAN;
    s->options.leaf_triangles = leaf != 0 ? leaf : 1;
    s->options.wish.size = treelets_sizes[chosen(o, TREELETS_SIZE, SIZE_64 - 1)];
    s->options.wish.fill = chosen(o, TREELETS_FILL, TREELET_FILL_BFS);
    s->options.wish.slots = chosen(o, TREELETS_SLOTS, TREELET_SLOTS_THESIS);
    s->options.edges = (enum node_edges)chosen(o, TREELETS_BIT, NODE_EDGES_PARITY);
    s->tracing.order = (enum treelet_order)order;
    s->tracing.tests_again = (uint8_t)(chosen(o, TREELETS_AGAIN, order <= TREELET_MIRRORED) == 0);
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

static int trace_packets(treelets_structure *s, const plt_ray *rays, plt_hit *hits, uint32_t count,
                         int any, fail *f) {
    const uint32_t most = s->packet.side * s->packet.side;
    s->tracing.nodes = &s->tree.nodes;
    s->tracing.packet = &s->packet;
    for (uint32_t i = 0; i < count; i += most) {
        const uint32_t left = count - i, now = left < most ? left : most;
        if (packet_begin(&s->packet, &s->tree.nodes.box, rays + i, now, any) &&
            treelet_trace(&s->tracing) != 0) {
            s->is_whole = 0;
            return fail_set(f, s->name,
                            "out of memory for edges that wait; choose smaller treelets");
        }
        packet_store(&s->packet, hits + i);
    }
    return 0;
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
    return trace_packets(s, rays, hits, count, any, f);
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
    {"tl2", "treelets of 2 nodes", TREELETS_SIZE, 1},
    {"tl3", "of 3", TREELETS_SIZE, 2},
    {"tl7", "of 7", TREELETS_SIZE, 3},
    {"tl8", "of 8", TREELETS_SIZE, 4},
    {"tl16", "of 16", TREELETS_SIZE, 5},
    {"tl64", "of 64", TREELETS_SIZE, SIZE_64},
    {"tl256", "of 256", TREELETS_SIZE, 7},
    {"tl512", "of 512", TREELETS_SIZE, 8},
    {"tl10k", "of 10,000", TREELETS_SIZE, 9},
    {"figure", "edges as they come, the last first, as the thesis's Figure 4.2 has it",
     TREELETS_ORDER, TREELET_FIGURE + 1},
    {"text", "likewise, near children first within a treelet, as its text has it", TREELETS_ORDER,
     TREELET_TEXT + 1},
    {"mirrored", "likewise, far ones first, so that near edges are on top", TREELETS_ORDER,
     TREELET_MIRRORED + 1},
    {"sorted", "the edges of a treelet by distance", TREELETS_ORDER, TREELET_SORTED + 1},
    {"leaf-first", "likewise, and leaves before nodes", TREELETS_ORDER, TREELET_LEAF_FIRST + 1},
    {"heap", "of all edges that wait the nearest", TREELETS_ORDER, TREELET_HEAP + 1},
    {"depth", "depth first across treelets", TREELETS_ORDER, TREELET_DEPTH + 1},
    {"again", "what comes off a stack is tested again", TREELETS_AGAIN, 1},
    {"once", "it is not", TREELETS_AGAIN, 2},
    {"bfs", "treelets fill breadth first", TREELETS_FILL, TREELET_FILL_BFS + 1},
    {"area", "with the largest boxes", TREELETS_FILL, TREELET_FILL_AREA + 1},
    {"full", "so that few stay incomplete", TREELETS_FILL, TREELET_FILL_FULL + 1},
    {"share", "incomplete ones last, where they fit exactly, else where most is free",
     TREELETS_SLOTS, TREELET_SLOTS_THESIS + 1},
    {"newest", "as they come, into the newest block with room", TREELETS_SLOTS,
     TREELET_SLOTS_NEWEST + 1},
    {"apart", "into blocks of their own", TREELETS_SLOTS, TREELET_SLOTS_NONE + 1},
    {"come", "as they come, where they fit exactly, else where most is free", TREELETS_SLOTS,
     TREELET_SLOTS_COME + 1},
    {"parity", "edges are told by the thesis's bit, which alternates", TREELETS_BIT,
     NODE_EDGES_PARITY + 1},
    {"direct", "by the engine's, which says it", TREELETS_BIT, NODE_EDGES_DIRECT + 1},
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
