/* build - see build.h
 *
 * A stack of ranges that wait, left child on top: nodes come out depth first. A range whose two
 * halves are both lists becomes an intermediate node: nothing but its parent's link (thesis,
 * section 3.2).
 *
 * Stack bound: one waiting range per level, so PLT_DEPTH_MAX + 1. Depth bound:
 * a range that could not be finished by halving in the levels that are left
 * after one more free split is halved by count.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/build.h"

#include "engine/base/arena.h"
#include "engine/builder/split.h"
#include "engine/tree/thesis/treelets.h"

/* Steps that nobody else takes cost less code. */
#if PLT_WITH_REBUILD
#define PLT_BUILD_STEP
#else
#define PLT_BUILD_STEP static
#endif

#define NO_PARENT 0xFFFFFFFFu

typedef struct pending {
    plt_box box;
    uint32_t begin, end;
    uint32_t parent; /* node that links here, NO_PARENT for the root */
    uint16_t depth;  /* inner nodes above */
    uint8_t child;
} pending;

typedef struct splitting {
    plt_split_bins bins;
    pending stack[PLT_DEPTH_MAX + 1];
    uint32_t waiting;
} splitting;

uint32_t plt_build_slots_bound(uint32_t nodes, uint32_t treelet_nodes) {
    return plt_treelet_slots_bound(nodes, treelet_nodes);
}

size_t plt_build_scratch_bytes(uint32_t nodes, uint32_t treelet_nodes) {
    const size_t treelets = plt_treelet_scratch_bytes(nodes, treelet_nodes);
    return treelets > sizeof(splitting) ? treelets : sizeof(splitting);
}

static void set_last_bits(plt_record *records, uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; i++) {
        plt_record_set_last(&records[i], i + 1 == end);
    }
}

static void link_from_parent(plt_build_job *job, const pending *p, uint32_t link) {
    if (p->parent == NO_PARENT) {
        job->root = link;
    } else {
        plt_node_relink(&job->nodes[p->parent], p->child, link);
    }
}

static void push_children(splitting *s, const pending *p, uint32_t middle, const plt_box box[2],
                          uint32_t node) {
    for (int c = 1; c >= 0; c--) {
        const pending child = {box[c], c == 0 ? p->begin : middle, c == 0 ? middle : p->end,
                               node,   (uint16_t)(p->depth + 1),   (uint8_t)c};
        s->stack[s->waiting++] = child;
    }
}

/* Makes the range a list, an intermediate node or a node with two more ranges to do. */
static int build_range(plt_build_job *job, splitting *s, const pending *p) {
    if (p->end - p->begin <= job->leaf_triangles) {
        set_last_bits(job->records, p->begin, p->end);
        link_from_parent(job, p, plt_link_make(p->begin, PLT_LINK_LEAF));
        return PLT_OK;
    }
    plt_record_items items = {job->records, &s->bins};
    const plt_split_range range = {p->begin, p->end, p->depth, job->leaf_triangles, job->splits};
    plt_box box[2];
    const uint32_t middle = plt_split_records(&items, &range, &p->box, box);
    if (middle - p->begin <= job->leaf_triangles && p->end - middle <= job->leaf_triangles) {
        set_last_bits(job->records, p->begin, middle);
        set_last_bits(job->records, middle, p->end);
        link_from_parent(job, p, plt_link_make(p->begin, PLT_LINK_LEAF | PLT_LINK_TWO));
        return PLT_OK;
    }
    if (job->nodes_used == job->room) {
        return PLT_ERR_ARENA;
    }
    const uint32_t node = job->nodes_used++;
    plt_node_encode(&job->nodes[node], &p->box, box);
    link_from_parent(job, p, plt_link_make(node, 0));
    push_children(s, p, middle, box, node);
    return PLT_OK;
}

PLT_BUILD_STEP int plt_build_begin(plt_build_job *job) {
    splitting *s = job->scratch;
    job->nodes_used = job->node_slots = 0;
    job->root = PLT_LINK_NONE;
    if (plt_levels_needed(job->count, job->leaf_triangles) >= PLT_DEPTH_MAX) {
        return PLT_ERR_LIMIT;
    }
    if (job->scratch_bytes < sizeof *s) {
        return PLT_ERR_ARENA;
    }
    const pending root = {job->box, 0, job->count, NO_PARENT, 0, 0};
    s->stack[0] = root;
    s->waiting = job->count > 0;
    return PLT_OK;
}

PLT_BUILD_STEP int plt_build_split(plt_build_job *job, uint32_t triangles) {
    splitting *s = job->scratch;
    uint32_t seen = 0;
    while (s->waiting > 0) {
        if (seen >= triangles) {
            return PLT_MORE;
        }
        const pending p = s->stack[--s->waiting];
        const int status = build_range(job, s, &p);
        if (status != PLT_OK) {
            return status;
        }
        seen += p.end - p.begin;
    }
    return PLT_OK;
}

PLT_BUILD_STEP int plt_build_treelets(plt_build_job *job) {
    if (job->nodes_used == 0) {
        return PLT_OK;
    }
    if (job->scratch_bytes < plt_treelet_scratch_bytes(job->nodes_used, job->treelet_nodes)) {
        return PLT_ERR_ARENA;
    }
    plt_treelet_job t = {.nodes = job->nodes,
                         .count = job->nodes_used,
                         .room = job->room,
                         .treelet_nodes = job->treelet_nodes,
                         .scratch = job->scratch};
    const int status = plt_treelets_form(&t);
    job->node_slots = t.node_slots;
    job->root = plt_link_make(t.root, 0);
    return status;
}

int plt_build(plt_build_job *job) {
    job->box = plt_records_box(job->records, 0, job->count);
    int status = plt_build_begin(job);
    if (status == PLT_OK) {
        do {
            status = plt_build_split(job, UINT32_MAX);
        } while (status == PLT_MORE);
    }
    return status == PLT_OK ? plt_build_treelets(job) : status;
}
