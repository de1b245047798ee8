/* wave_thesis - the wave over thesis nodes
 *
 * Stack: entry 0 is the end. A node on level d (the root's is 1) is visited with at most d - 1
 * entries above it, and two are stored: depth + 2 entries are enough. Leaves have branches,
 * as lists of records end where they say.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave_thesis.h"

#include <string.h>

#include "engine/base/small_stack.h"
#include "engine/trace/leaf_block.h"
#include "engine/trace/ray_block.h"
#include "engine/trace/wave_binary.h"
#include "engine/tree/record.h"

/* What waits, and where the ray is in its box (wave_binary.h). */
typedef struct entry {
    float inside[2]; /* enter, minus leave */
    uint32_t link;   /* of thesis/link.h, or PLT_LINK_NONE: the end */
    uint32_t pad;
} entry;

_Static_assert(sizeof(entry) == PLT_WAVE_THESIS_ENTRY_BYTES,
               "what plt_wave_stack_bytes counts with");

static const float cut[8][4] = PLT_BINARY_CUT(4, 2, 1);
static const uint8_t axis_bit[3] = {4, 2, 1};

typedef struct run {
    const plt_tree *tree;
    const unsigned char *base[2]; /* of nodes, of records */
    plt_wave_found *found;
    plt_wave_lists on;
} run;

static const uint32_t bytes_of[2] = {PLT_NODE_BYTES, PLT_RECORD_BYTES};

static inline entry *stack_of(plt_binary_ray *r) {
    return (entry *)(void *)(r + 1);
}

static inline plt_binary_ray *whole(plt_wave_ray *r) {
    return (plt_binary_ray *)(void *)r;
}

static inline uint32_t link_of(const plt_binary_ray *r) {
    return (uint32_t)r->ray.next;
}

/* Takes the top of the stack, puts the ray on the list of what that is, and asks for it: a
 * node's line, or those of four records. */
static inline void go_on(run *k, plt_binary_ray *r) {
    const entry *e = (const entry *)r->ray.top - 1;
    const uint32_t link = e->link;
    const size_t is_leaf = link & PLT_LINK_LEAF, is_done = link == PLT_LINK_NONE;
    const size_t index = plt_link_index(link) & (is_done - 1);
    const unsigned char *at = k->base[is_leaf] + index * bytes_of[is_leaf];
    plt_prefetch(at);
    plt_prefetch(at + 64 * is_leaf);
    plt_prefetch(at + 128 * is_leaf);
    r->ray.next = link;
    r->ray.top = (entry *)r->ray.top - 1;
    plt_wave_enlist(&k->on, &r->ray, is_leaf);
}

/* ---- nodes ---------------------------------------------------------------------- */

static inline void test_children(const plt_node *node, const plt_binary_ray *r,
                                 plt_wave_found *to) {
    const uint32_t mins = plt_node_link(node, 0) >> 2 & 7u;
    const uint32_t maxs = plt_node_link(node, 1) >> 2 & 7u;
    const entry *e = r->ray.top;
    plt_binary_find(plt_binary_intervals(r, e->inside, cut, plt_words(&node->word[0]),
                                         plt_words(&node->word[3]), mins, maxs),
                    to);
}

/* Children that are met go onto the stack, the nearer one on top. */
static inline void push(const plt_node *node, plt_binary_ray *r, const plt_wave_found *from) {
    const uint32_t left = plt_binary_place[from->row];
    entry *stack = r->ray.top;
    memcpy(stack[left].inside, &from->at[0], sizeof stack->inside);
    stack[left].link = plt_node_link(node, 0);
    memcpy(stack[left ^ 1u].inside, &from->at[2], sizeof stack->inside);
    stack[left ^ 1u].link = plt_node_link(node, 1);
    r->ray.top = stack + plt_binary_ones[from->row];
}

/* In two halves, as in wave_bvh4.c. */
PLT_WAVE_LOOP static void visit_all(run *shared) {
    run k = *shared; /* so that counts stay in registers */
    plt_wave_ray **const list = k.on.list[PLT_WAVE_VISIT];
    const plt_node *const nodes = k.tree->nodes;
    const size_t count = k.on.on[PLT_WAVE_VISIT];
    for (size_t i = 0; i < count; i++) {
        const plt_binary_ray *r = whole(list[i]);
        test_children(&nodes[plt_link_index(link_of(r))], r, &k.found[i]);
    }
    k.on.on[PLT_WAVE_VISIT] = 0;
    for (size_t i = 0; i < count; i++) {
        plt_binary_ray *r = whole(list[i]);
        push(&nodes[plt_link_index(link_of(r))], r, &k.found[i]);
        go_on(&k, r);
    }
    *shared = k;
}

/* ---- leaves ----------------------------------------------------------------------- */

/* Up to four records of a leaf, that has so many lists left from `record` on; returns how
 * many there are. */
PLT_APART_ON_SMALL_STACKS static unsigned load_records(const plt_record *record, uint32_t *lists,
                                                       plt_bvh4_block *b) {
    const plt_record *at[4];
    unsigned count = 0;
    PLT_UNROLLED for (unsigned lane = 0; lane < 4; lane++) {
        at[lane] = *lists > 0 ? &record[lane] : record;
        count += *lists > 0;
        *lists -= *lists > 0 && plt_record_is_last(at[lane]);
    }
    plt_block_of_records(b, at, count);
    return count;
}

/* Drops what lies behind the new hit. */
static inline void cull(plt_binary_ray *r) {
    entry *stack = stack_of(r);
    const float tmax = r->ray.tmax[0];
    entry *kept = stack + 1;
    for (const entry *at = kept; at < (const entry *)r->ray.top; at++) {
        const entry e = *at;
        *kept = e;
        kept += e.inside[0] <= tmax;
    }
    r->ray.top = kept;
    plt_binary_end(r);
}

/* Tests all records of a leaf; returns how many blocks they were. */
static uint32_t test_leaf(const run *k, plt_binary_ray *r, const plt_wave_job *job) {
    _Alignas(16) plt_bvh4_block b;
    const plt_record *record = &k->tree->records[plt_link_index(link_of(r))];
    uint32_t lists = plt_link_lists(link_of(r)), blocks = 0;
    for (; lists > 0; blocks++) {
        record += load_records(record, &lists, &b);
        if (plt_ray_block(&r->ray, &b, job)) {
            cull(r);
        }
    }
    return blocks;
}

PLT_APART_ON_SMALL_STACKS static void test_all(run *k, const plt_wave_job *job) {
    const size_t count = k->on.on[PLT_WAVE_TEST];
    k->on.on[PLT_WAVE_TEST] = 0;
    for (size_t i = 0; i < count; i++) {
        plt_binary_ray *r = whole(k->on.list[PLT_WAVE_TEST][i]);
        job->traversal->stats.triangle_tests += test_leaf(k, r, job);
        go_on(k, r);
    }
}

/* ---- rays ------------------------------------------------------------------------ */

/* The next ray, where one is done. */
static int take(run *k, plt_wave_job *job, plt_binary_ray *r) {
    const entry end = {{-PLT_ENDLESS, -PLT_ENDLESS}, PLT_LINK_NONE, 0};
    if (!plt_wave_take(job, &r->ray)) {
        return 0;
    }
    plt_binary_set(r, axis_bit);
    stack_of(r)[0] = stack_of(r)[1] = end;
    stack_of(r)[1].link = k->tree->root;
    plt_binary_root(r, &job->traversal->scene->box, stack_of(r)[1].inside);
    r->ray.top = &stack_of(r)[2];
    go_on(k, r);
    return 1;
}

/* Those that find no ray stay on the list: there may be one when others were looked at. */
static void take_all(run *k, plt_wave_job *job) {
    size_t count = k->on.on[PLT_WAVE_DONE];
    while (count > 0 && take(k, job, whole(k->on.list[PLT_WAVE_DONE][count - 1]))) {
        count--;
    }
    k->on.on[PLT_WAVE_DONE] = count;
}

int plt_wave_thesis(plt_wave_job *job) {
    const plt_tree *tree = &job->traversal->scene->thesis;
    const uint64_t before = job->traversal->stats.node_visits;
    plt_wave *w = job->wave;
    run k = {tree,
             {(const unsigned char *)tree->nodes, (const unsigned char *)tree->records},
             w->found,
             plt_wave_lists_get(w)};
    plt_wave_fill(w, job, &k.on);
    take_all(&k, job);
    while (k.on.on[PLT_WAVE_VISIT] + k.on.on[PLT_WAVE_TEST] > 0) {
        if (plt_wave_waits(job) || plt_wave_is_over(job, before)) {
            plt_wave_lists_keep(w, &k.on);
            return PLT_MORE;
        }
        job->traversal->stats.node_visits += k.on.on[PLT_WAVE_VISIT];
        job->traversal->stats.group_tests += k.on.on[PLT_WAVE_VISIT];
        visit_all(&k);
        plt_wave_part(&k.on, PLT_LINK_NONE);
        test_all(&k, job);
        take_all(&k, job);
    }
    plt_wave_lists_keep(w, &k.on);
    return plt_wave_waits(job) ? PLT_MORE : PLT_OK;
}
