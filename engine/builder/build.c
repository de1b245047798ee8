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
#if PLT_WITH_SUBTREES
    uint32_t budget; /* nodes that it may take, if they are counted */
#endif
} pending;

typedef struct splitting {
    plt_split_bins bins;
    pending stack[PLT_DEPTH_MAX + 1];
    uint32_t waiting;
#if PLT_WITH_REBUILD
    uint32_t is_long; /* a range is split in steps: */
    pending range;
    plt_split_job job;
#endif
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

#if PLT_WITH_SUBTREES
/* Fewest nodes that `count` triangles take: every leaf link but one leads to 2 K. */
static uint32_t least_nodes(const plt_build_job *job, uint32_t count) {
    return (count - 1) / (2 * job->leaf_triangles);
}

/* What the split of a range leaves over goes to both sides by their triangles. */
static uint32_t budget_of(const plt_build_job *job, const pending *p, uint32_t middle, int child) {
    const uint32_t left = middle - p->begin, right = p->end - middle;
    const uint32_t least = least_nodes(job, left), both = least + least_nodes(job, right);
    const uint32_t rest = p->budget > both + 1 ? p->budget - 1 - both : 0;
    const float part = (float)(int32_t)left / (float)(int32_t)(left + right);
    const uint32_t about = (uint32_t)(int32_t)((float)(int32_t)rest * part);
    const uint32_t share = about < rest ? about : rest;
    return child == 0 ? least + share : both - least + rest - share;
}

/* A split that its range has not enough nodes for gives way to one that takes the fewest: on one
 * side whole leaf links of 2 K triangles, about half of them all. That is as deep as halves are. */
static uint32_t keep_to_budget(const plt_build_job *job, plt_record_items *items, const pending *p,
                               uint32_t middle, plt_box box[2]) {
    const uint32_t most = job->leaf_triangles, left = middle - p->begin, right = p->end - middle;
    const uint32_t count = left + right, links = least_nodes(job, count) + 1;
    const int is_node = left > most || right > most;
    if (job->is_paced && is_node &&
        p->budget < 1 + least_nodes(job, left) + least_nodes(job, right)) {
        const uint32_t take = count <= 2 * most ? count / 2 : (links + 1) / 2 * 2 * most;
        return plt_split_records_at(items, p->begin, p->begin + take, p->end, &p->box, box);
    }
    return middle;
}
#endif

static void push_children(const plt_build_job *job, splitting *s, const pending *p, uint32_t middle,
                          const plt_box box[2], uint32_t node) {
    for (int c = 1; c >= 0; c--) {
        const pending child = {
            .box = box[c],
            .begin = c == 0 ? p->begin : middle,
            .end = c == 0 ? middle : p->end,
            .parent = node,
            .depth = (uint16_t)(p->depth + 1),
#if PLT_WITH_SUBTREES
            .budget = budget_of(job, p, middle, c),
#endif
            .child = (uint8_t)c
        };
        s->stack[s->waiting++] = child;
    }
    (void)job;
}

static void make_list(plt_build_job *job, const pending *p) {
    set_last_bits(job->records, p->begin, p->end);
    link_from_parent(job, p, plt_link_make(p->begin, PLT_LINK_LEAF));
}

/* The range has been split: it is an intermediate node, or a node with two more ranges to do. */
static int make_node(plt_build_job *job, splitting *s, const pending *p, uint32_t middle,
                     plt_box box[2]) {
#if PLT_WITH_SUBTREES
    plt_record_items items = {job->records, &s->bins};
    middle = keep_to_budget(job, &items, p, middle, box);
#endif
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
#if PLT_WITH_SUBTREES
    job->depth_max = p->depth >= job->depth_max ? p->depth + 1u : job->depth_max;
#endif
    plt_node_encode(&job->nodes[node], &p->box, box);
    link_from_parent(job, p, plt_link_make(node, 0));
    push_children(job, s, p, middle, box, node);
    return PLT_OK;
}

static plt_split_range range_of(const plt_build_job *job, const pending *p) {
    const plt_split_range r = {p->begin, p->end, p->depth, job->leaf_triangles, job->splits};
    return r;
}

/* Makes the range a list, or splits it. */
static int build_range(plt_build_job *job, splitting *s, const pending *p) {
    if (p->end - p->begin <= job->leaf_triangles) {
        make_list(job, p);
        return PLT_OK;
    }
    plt_record_items items = {job->records, &s->bins};
    const plt_split_range range = range_of(job, p);
    plt_box box[2];
    const uint32_t middle = plt_split_records(&items, &range, &p->box, box);
    return make_node(job, s, p, middle, box);
}

#if PLT_WITH_REBUILD
/* Triangles of a range that is not divided. */
#define UNDIVIDED 64u

/* Goes on with a long range. */
static int split_some(plt_build_job *job, splitting *s, uint32_t *left) {
    plt_record_items items = {job->records, &s->bins};
    const int status = plt_split_records_some(&items, &s->job, left);
    if (status == PLT_OK) {
        s->is_long = 0;
        return make_node(job, s, &s->range, s->job.middle, s->job.child);
    }
    return status;
}

static void begin_long(plt_build_job *job, splitting *s, const pending *p) {
    s->is_long = 1;
    s->range = *p;
    s->job.range = range_of(job, p);
    s->job.box = p->box;
    plt_split_records_begin(&s->job);
}

/* A range is looked at twice, so `left` counts triangles twice. */
static int split_next(plt_build_job *job, splitting *s, uint32_t *left) {
    if (!s->is_long) {
        const pending p = s->stack[--s->waiting];
        const uint32_t count = p.end - p.begin;
        if (count <= UNDIVIDED || count <= *left / 2) {
            *left -= 2 * count < *left ? 2 * count : *left;
            return build_range(job, s, &p);
        }
        begin_long(job, s, &p);
    }
    return split_some(job, s, left);
}
#else
static int split_next(plt_build_job *job, splitting *s, uint32_t *left) {
    const pending p = s->stack[--s->waiting];
    (void)left;
    return build_range(job, s, &p);
}
#endif

PLT_BUILD_STEP int plt_build_begin(plt_build_job *job) {
    splitting *s = job->scratch;
    job->nodes_used = job->node_slots = 0;
    job->root = PLT_LINK_NONE;
#if PLT_WITH_SUBTREES
    const uint32_t depth = job->depth;
#else
    const uint32_t depth = 0;
#endif
    if (plt_levels_needed(job->count, job->leaf_triangles) + depth >= PLT_DEPTH_MAX) {
        return PLT_ERR_LIMIT;
    }
    if (job->scratch_bytes < sizeof *s) {
        return PLT_ERR_ARENA;
    }
    const pending root = {
        .box = job->box,
        .end = job->count,
        .parent = NO_PARENT,
#if PLT_WITH_SUBTREES
        .budget = job->room,
#endif
        .depth = (uint16_t)depth
    };
    s->stack[0] = root;
    s->waiting = job->count > 0;
#if PLT_WITH_REBUILD
    s->is_long = 0;
#endif
    return PLT_OK;
}

static int is_split(const splitting *s) {
#if PLT_WITH_REBUILD
    return s->waiting == 0 && !s->is_long;
#else
    return s->waiting == 0;
#endif
}

PLT_BUILD_STEP int plt_build_split(plt_build_job *job, uint32_t triangles) {
    splitting *s = job->scratch;
    uint32_t left = triangles < UINT32_MAX / 2 ? 2 * triangles : UINT32_MAX;
    while (!is_split(s)) {
        const int status = left > 0 ? split_next(job, s, &left) : PLT_MORE;
        if (status != PLT_OK) {
            return status;
        }
    }
    return PLT_OK;
}

static plt_treelet_job treelets_of(const plt_build_job *job) {
    const plt_treelet_job t = {.nodes = job->nodes,
                               .count = job->nodes_used,
                               .room = job->room,
                               .treelet_nodes = job->treelet_nodes,
                               .scratch = job->scratch};
    return t;
}

static int has_scratch(const plt_build_job *job) {
    return job->scratch_bytes >= plt_treelet_scratch_bytes(job->nodes_used, job->treelet_nodes);
}

static int form_treelets(plt_build_job *job) {
    if (job->nodes_used == 0) {
        return PLT_OK;
    }
    if (!has_scratch(job)) {
        return PLT_ERR_ARENA;
    }
    plt_treelet_job t = treelets_of(job);
    const int status = plt_treelets_form(&t);
    job->node_slots = t.node_slots;
    job->root = plt_link_make(t.root, 0);
    return status;
}

#if PLT_WITH_REBUILD
int plt_build_treelets_begin(plt_build_job *job) {
    if (job->nodes_used > 0 && !has_scratch(job)) {
        return PLT_ERR_ARENA;
    }
    if (job->nodes_used > 0) {
        const plt_treelet_job t = treelets_of(job);
        plt_treelets_begin(&job->treelets, &t);
    }
    return PLT_OK;
}

int plt_build_treelets(plt_build_job *job, uint32_t nodes) {
    const int status = job->nodes_used == 0 ? PLT_OK : plt_treelets_step(&job->treelets, nodes);
    if (status == PLT_OK && job->nodes_used > 0) {
        job->node_slots = job->treelets.blocks * job->treelet_nodes;
        job->root = plt_link_make(job->treelets.root, 0);
    }
    return status;
}
#endif

int plt_build(plt_build_job *job) {
    job->box = plt_records_box(job->records, 0, job->count);
    int status = plt_build_begin(job);
    if (status == PLT_OK) {
        do {
            status = plt_build_split(job, UINT32_MAX);
        } while (status == PLT_MORE);
    }
    return status == PLT_OK ? form_treelets(job) : status;
}
