/* wave_bvh4 - the wave over the wide form
 *
 * A step has no branch that depends on a ray: what a link leads to is arithmetic, children
 * are sorted by a table, and triangles are tested in passes, each over the rays that the one
 * before left. Only the last, over rays that may have a nearer hit, has branches.
 * tests/check/check_branches.sh counts the jumps.
 *
 * Stack: entry 0 is PLT_BVH4_NONE, nearer than any hit. A node on level d (the root's is 1) is
 * visited with at most 3 (d - 1) entries above it, and four are stored; so 3 * depth + 2
 * entries are enough.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave_bvh4.h"

#include <string.h>

#include "engine/base/small_stack.h"
#include "engine/trace/child_order.h"
#include "engine/trace/ray_block.h"
#include "engine/tree/bvh4.h"

/* Rounds of visits to one of all else: of a list's end a branch is mispredicted, and the others
 * are short. Three are no faster: fewer and fewer rays are still at nodes. */
enum { VISITS_IN_A_ROW = 2 };

/* Something that waits, and where the ray enters it. */
typedef uint32_t entry[2]; /* link, bits of t */

/* What a run of the wave works with, apart from the rays themselves. */
typedef struct run {
    const plt_bvh4_node *nodes;
    plt_wave_found *found;
    plt_wave_lists on;
} run;

static inline entry *stack_of(plt_wave_ray *r) {
    return (entry *)(void *)(r + 1);
}

/* Puts a ray on the list of what is next for it, and asks for that: two lines of a node, or three
 * of a block. */
static inline void enlist(run *k, plt_wave_ray *r, uint32_t link) {
    const size_t is_leaf = link & PLT_BVH4_LEAF;
    const uintptr_t at = plt_bvh4_at(k->nodes, link);
    plt_prefetch((const void *)at);
    plt_prefetch((const void *)(at + 64));
    plt_prefetch((const void *)(at + 64 + 64 * is_leaf));
    r->next = at;
    plt_wave_enlist(&k->on, r, is_leaf);
}

/* The planes of four children, so many bytes into a node. */
static inline f4 planes_at(const plt_bvh4_node *node, size_t bytes) {
    return f4_load_16((const float *)(const void *)((const char *)node + bytes));
}

/* Where the ray enters all four children and where it leaves them. */
typedef struct stay {
    f4 near, far;
} stay;

static inline stay stay_in(const plt_bvh4_node *node, const plt_wave_ray *r) {
    stay s = {f4_load_16(r->tmin), f4_load_16(r->tmax)};
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 rdir = f4_load_16(r->rdir[a]);
        const f4 n = f4_sub(planes_at(node, r->at.near[a]), f4_load_16(r->near_org[a]));
        const f4 f = f4_sub(planes_at(node, r->at.far[a]), f4_load_16(r->far_org[a]));
        s.near = f4_max(f4_mul(n, rdir), s.near);
        s.far = f4_min(f4_mul(f, rdir), s.far);
    }
    return s;
}

/* ---- the nearest hit: children are sorted ------------------------------------------ */

/* Tests all four children: where the ray enters those that are met, -1 for others, and which
 * are met. */
static inline void test_children(const plt_bvh4_node *node, const plt_wave_ray *r,
                                 plt_wave_found *to) {
    const stay s = stay_in(node, r);
    const m4 met = f4_le(s.near, s.far);
    const f4 key = f4_select(met, s.near, f4_all(-1.0f));
    f4_store(to->at, key);
    to->met = m4_mask(met);
    to->row = plt_descending(key);
}

/* Children that are met go onto the stack, the nearest on top, and it is taken off again. */
static inline uint32_t push(plt_wave_ray *r, const plt_wave_found *from) {
    const plt_child_order *order = &plt_child_orders;
    const ptrdiff_t left = order->ones_less_one[from->met];
    const uint32_t *link = plt_bvh4_node_at(r->next)->link;
    entry *stack = r->top;
    f4_store_pairs(stack, order->descending[from->row], u4_load(link), f4_load(from->at));
    r->top = stack + left;
    return stack[left][0];
}

/* First all tests, then all that follows from them: a machine that looks only so many
 * instructions ahead has more rays in view of half a step than of a whole one. */
PLT_WAVE_LOOP static void visit_all(run *shared) {
    run k = *shared; /* so that counts stay in registers */
    plt_wave_ray **const list = k.on.list[PLT_WAVE_VISIT];
    const size_t count = k.on.on[PLT_WAVE_VISIT];
    for (size_t i = 0; i < count; i++) {
        const plt_wave_ray *r = list[i];
        test_children(plt_bvh4_node_at(r->next), r, &k.found[i]);
    }
    k.on.on[PLT_WAVE_VISIT] = 0;
    for (size_t i = 0; i < count; i++) {
        plt_wave_ray *r = list[i];
        enlist(&k, r, push(r, &k.found[i]));
    }
    *shared = k;
}

/* Drops what lies behind the new hit. */
static inline void cull(plt_wave_ray *r) {
    const float tmax = r->tmax[0];
    entry *kept = stack_of(r) + 1;
    for (entry *at = kept; at < (entry *)r->top; at++) {
        float t;
        memcpy(&t, &(*at)[1], sizeof t);
        memcpy(kept, at, sizeof *kept);
        kept += t <= tmax;
    }
    r->top = kept;
}

/* ---- any hit: children are not ------------------------------------------------------ */

/* Children that are met go onto the stack as they lie in their node, and the last one is taken off
 * again. Where the ray enters them nobody asks: its first hit ends it. */
static inline uint32_t push_any(plt_wave_ray *r, unsigned met) {
    const uint8_t *to = plt_child_places[met];
    const ptrdiff_t left = (ptrdiff_t)to[0] - 1;
    const uint32_t *link = plt_bvh4_node_at(r->next)->link;
    entry *stack = r->top;
    stack[0][0] = link[0];
    stack[to[1]][0] = link[1];
    stack[to[2]][0] = link[2];
    stack[to[3]][0] = link[3];
    r->top = stack + left;
    return stack[left][0];
}

PLT_WAVE_LOOP static void visit_all_any(run *shared) {
    run k = *shared;
    plt_wave_ray **const list = k.on.list[PLT_WAVE_VISIT];
    const size_t count = k.on.on[PLT_WAVE_VISIT];
    for (size_t i = 0; i < count; i++) {
        const stay s = stay_in(plt_bvh4_node_at(list[i]->next), list[i]);
        k.found[i].met = m4_mask(f4_le(s.near, s.far));
    }
    k.on.on[PLT_WAVE_VISIT] = 0;
    for (size_t i = 0; i < count; i++) {
        plt_wave_ray *r = list[i];
        enlist(&k, r, push_any(r, k.found[i].met));
    }
    *shared = k;
}

/* ---- triangles --------------------------------------------------------------------------- */

/* Goes on to the block behind it, or to what waits on top of the stack. */
static inline void leave_block(run *k, plt_wave_ray *r) {
    const uint32_t one = 1u << PLT_BVH4_MORE_SHIFT;
    const uint32_t link = (uint32_t)(r->next - (uintptr_t)k->nodes);
    const uint32_t more = 0u - ((link & PLT_BVH4_MORE_MOST * one) != 0);
    const uint32_t following = link + (uint32_t)sizeof(plt_bvh4_block) - one;
    entry *top = (entry *)r->top - 1;
    const uint32_t waits = (*top)[0];
    r->top = top - (int32_t)more;
    enlist(k, r, (following & more) | (waits & ~more));
}

/* Rays at triangles that they may meet, at the end of the list of those that are done. */
PLT_WAVE_LOOP static size_t test_edges(const run *k, plt_wave_ray **met, size_t count) {
    plt_wave_ray **const list = k->on.list[PLT_WAVE_TEST];
    plt_wave_found *const found = k->found;
    size_t meet = 0;
    for (size_t i = 0; i < count; i++) {
        plt_wave_ray *r = list[i];
        block_edges e;
        const unsigned may = plt_block_edges(r, plt_bvh4_block_at(r->next), &e);
        met[meet] = r;
        found[meet].met = may;
        meet += may != 0;
    }
    return meet;
}

/* Of those, the ones that may have a nearer hit there. */
static inline size_t test_distances(run *k, plt_wave_ray **met, size_t count) {
    size_t nearer = 0;
    for (size_t i = 0; i < count; i++) {
        plt_wave_ray *r = met[i];
        const unsigned may = plt_block_may_be_nearer(r, plt_bvh4_block_at(r->next));
        met[nearer] = r;
        k->found[nearer].met = may & k->found[i].met;
        nearer += k->found[nearer].met != 0;
    }
    return nearer;
}

/* What waits and can be no nearer than the new hit; of any hit nothing can. */
static inline void drop(plt_wave_ray *r, int any) {
    if (any) {
        r->top = stack_of(r) + 1;
    } else {
        cull(r);
    }
}

/* A pass for each question, over the rays that the one before left, instead of branches. */
PLT_APART_ON_SMALL_STACKS static void test_all(run *k, const plt_wave_job *job) {
    const size_t count = k->on.on[PLT_WAVE_TEST];
    plt_wave_ray **const met = k->on.list[PLT_WAVE_DONE] + k->on.on[PLT_WAVE_DONE];
    const size_t nearer = test_distances(k, met, test_edges(k, met, count));
    for (size_t i = 0; i < nearer; i++) {
        plt_wave_ray *r = met[i];
        const plt_bvh4_block *b = plt_bvh4_block_at(r->next);
        if (plt_block_hits(r, b, job, k->found[i].met)) {
            drop(r, job->any);
        }
    }
    k->on.on[PLT_WAVE_TEST] = 0;
    for (size_t i = 0; i < count; i++) {
        plt_wave_ray *r = k->on.list[PLT_WAVE_TEST][i];
        leave_block(k, r);
    }
}

/* The next ray, where one is done. */
static int take(run *k, plt_wave_job *job, plt_wave_ray *r, uint32_t root) {
    const entry none = {PLT_BVH4_NONE, 0xFF800000u}; /* -infinity */
    if (!plt_wave_take(job, r)) {
        return 0;
    }
    memcpy(stack_of(r)[0], none, sizeof none);
    r->top = &stack_of(r)[1];
    enlist(k, r, root);
    return 1;
}

/* Those that find no ray stay on the list: there may be one when others were looked at. */
static void take_all(run *k, plt_wave_job *job, uint32_t root) {
    size_t count = k->on.on[PLT_WAVE_DONE];
    while (count > 0 && take(k, job, k->on.list[PLT_WAVE_DONE][count - 1], root)) {
        count--;
    }
    k->on.on[PLT_WAVE_DONE] = count;
}

int plt_wave_bvh4(plt_wave_job *job) {
    plt_traversal *t = job->traversal;
    const uint64_t before = t->stats.node_visits;
    plt_wave *w = job->wave;
    const plt_bvh4 *tree = t->scene->bvh4;
    run k = {tree->nodes, w->found, plt_wave_lists_get(w)};
    plt_wave_fill(w, job, &k.on);
    take_all(&k, job, tree->root);
    while (k.on.on[PLT_WAVE_VISIT] + k.on.on[PLT_WAVE_TEST] > 0) {
        if (plt_wave_waits(job) || plt_wave_is_over(job, before)) {
            plt_wave_lists_keep(w, &k.on);
            return PLT_MORE;
        }
        for (int i = 0; i < VISITS_IN_A_ROW; i++) {
            t->stats.node_visits += k.on.on[PLT_WAVE_VISIT];
            t->stats.group_tests += k.on.on[PLT_WAVE_VISIT];
            if (job->any) {
                visit_all_any(&k);
            } else {
                visit_all(&k);
            }
        }
        plt_wave_part(&k.on, plt_bvh4_at(k.nodes, PLT_BVH4_NONE));
        t->stats.triangle_tests += k.on.on[PLT_WAVE_TEST];
        test_all(&k, job);
        take_all(&k, job, tree->root);
    }
    plt_wave_lists_keep(w, &k.on);
    return plt_wave_waits(job) ? PLT_MORE : PLT_OK;
}
