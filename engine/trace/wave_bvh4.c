/* wave_bvh4 - the wave over the wide form
 *
 * A step has no branch that depends on a ray: what a link leads to is arithmetic, children
 * are sorted by a table. The one branch of a test of triangles is taken where they may be
 * met. tests/check/check_branches.sh counts the jumps.
 *
 * Stack: entry 0 is PLT_BVH4_NONE, nearer than any hit. A node on level d (the root's is 1) is
 * visited with at most 3 (d - 1) entries above it, and four are stored; so 3 * depth + 2
 * entries are enough.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave_bvh4.h"

#include <string.h>

#include "engine/trace/child_order.h"
#include "engine/trace/ray_block.h"
#include "engine/tree/bvh4.h"

/* Something that waits, and where the ray enters it. */
typedef uint32_t entry[2]; /* link, bits of t */

/* What a run of the wave works with, apart from the rays themselves. */
typedef struct run {
    plt_wave *w;
    const plt_bvh4_node *nodes;
    size_t on[PLT_WAVE_STEPS]; /* how many are on each list */
} run;

static inline entry *stack_of(plt_wave_ray *r) {
    return (entry *)(void *)(r + 1);
}

/* Puts a ray on the list of what is next for it, and asks for that: two lines of a node; of a
 * block's PLT_BVH4_BLOCK_HOT_BYTES the first three and the last, which may be a fourth. */
static inline void enlist(run *k, plt_wave_ray *r, uint32_t place, uint32_t link) {
    const size_t is_leaf = link >> 31, is_done = link == PLT_BVH4_NONE;
    const unsigned char *at = plt_bvh4_at(k->nodes, link), *third = at + 64 * is_leaf;
    plt_prefetch(at);
    plt_prefetch(at + 64);
    plt_prefetch(third + 64);
    plt_prefetch(third + PLT_BVH4_BLOCK_HOT_BYTES - 1 - 64);
    r->link = link;
    plt_wave_enlist(k->w, k->on, place, is_leaf, is_done);
}

/* The planes of four children, so many bytes into a node. */
static inline f4 planes_at(const unsigned char *node, size_t bytes) {
    return f4_load_16((const float *)(const void *)(node + bytes));
}

/* Tests all four children: where the ray enters those that are met, -1 for others, and how
 * many are met. */
static inline void test_children(const unsigned char *node, const plt_wave_ray *r,
                                 plt_wave_visited *to) {
    f4 near = f4_load_16(r->tmin), far = f4_load_16(r->tmax);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 rdir = f4_load_16(r->rdir[a]);
        const f4 n = f4_sub(planes_at(node, r->near[a]), f4_load_16(r->near_org[a]));
        const f4 f = f4_sub(planes_at(node, r->far[a]), f4_load_16(r->far_org[a]));
        near = f4_max(f4_mul(n, rdir), near);
        far = f4_min(f4_mul(f, rdir), far);
    }
    const m4 met = f4_le(near, far);
    const f4 key = f4_select(met, near, f4_all(-1.0f));
    f4_store(to->at, key);
    to->met = m4_mask(met);
    to->row = plt_descending(key);
}

/* Children that are met go onto the stack, the nearest on top, and it is taken off again. */
static inline uint32_t push(const unsigned char *node, plt_wave_ray *r,
                            const plt_wave_visited *from) {
    const uint32_t *link = ((const plt_bvh4_node *)(const void *)node)->link;
    const uint32_t top = r->top, left = plt_ones[from->met] - 1u;
    entry *stack = stack_of(r) + top;
    f4_store_pairs(stack, plt_descending_rows[from->row], u4_load(link), f4_load(from->at));
    r->top = top + left;
    return stack[(int32_t)left][0];
}

/* First all tests, then all that follows from them: a machine that looks only so many
 * instructions ahead has more rays in view of half a step than of a whole one. */
PLT_WAVE_LOOP static void visit_all(run *shared) {
    run k = *shared; /* so that counts stay in registers */
    unsigned char *const first = k.w->first;
    plt_wave_visited *const visited = k.w->visited;
    const size_t count = k.on[PLT_WAVE_VISIT];
    for (size_t i = 0; i < count; i++) {
        const plt_wave_ray *r =
            (const plt_wave_ray *)(const void *)(first + k.w->list[PLT_WAVE_VISIT][i]);
        test_children(plt_bvh4_at(k.nodes, r->link), r, &visited[i]);
    }
    k.on[PLT_WAVE_VISIT] = 0;
    for (size_t i = 0; i < count; i++) {
        const uint32_t place = k.w->list[PLT_WAVE_VISIT][i];
        plt_wave_ray *r = (plt_wave_ray *)(void *)(first + place);
        enlist(&k, r, place, push(plt_bvh4_at(k.nodes, r->link), r, &visited[i]));
    }
    *shared = k;
}

/* Drops what lies behind the new hit. */
static inline void cull(plt_wave_ray *r) {
    entry *stack = stack_of(r);
    const float tmax = r->tmax[0];
    uint32_t kept = 1;
    for (uint32_t i = 1; i < r->top; i++) {
        float t;
        memcpy(&t, &stack[i][1], sizeof t);
        memcpy(stack[kept], stack[i], sizeof stack[kept]);
        kept += t <= tmax;
    }
    r->top = kept;
}

/* The block behind it, or what waits on top of the stack. */
static inline uint32_t after_block(plt_wave_ray *r) {
    const uint32_t more = 0u - ((r->link >> PLT_BVH4_MORE_SHIFT & PLT_BVH4_MORE_MOST) != 0);
    const uint32_t following = r->link + PLT_BVH4_BLOCK_GRAINS - (1u << PLT_BVH4_MORE_SHIFT);
    r->top -= 1u + more;
    return (following & more) | (stack_of(r)[r->top][0] & ~more);
}

static void test_all(run *k, const plt_wave_job *job) {
    const size_t count = k->on[PLT_WAVE_TEST];
    k->on[PLT_WAVE_TEST] = 0;
    for (size_t i = 0; i < count; i++) {
        const uint32_t place = k->w->list[PLT_WAVE_TEST][i];
        plt_wave_ray *r = plt_wave_at(k->w, place);
        const plt_bvh4_block *b =
            (const plt_bvh4_block *)(const void *)plt_bvh4_at(k->nodes, r->link);
        if (plt_ray_block(r, b, job->rays, job->any)) {
            cull(r);
        }
        enlist(k, r, place, after_block(r));
    }
}

/* The next ray, where one is done. */
static int take(run *k, plt_wave_job *job, uint32_t place, uint32_t root) {
    plt_wave_ray *r = plt_wave_at(k->w, place);
    const entry none = {PLT_BVH4_NONE, 0xFF800000u}; /* -infinity */
    if (!plt_wave_take(job, r)) {
        return 0;
    }
    memcpy(stack_of(r)[0], none, sizeof none);
    r->top = 1;
    enlist(k, r, place, root);
    return 1;
}

static void take_all(run *k, plt_wave_job *job, uint32_t root) {
    const size_t count = k->on[PLT_WAVE_DONE];
    k->on[PLT_WAVE_DONE] = 0;
    for (size_t i = 0; i < count; i++) {
        const uint32_t place = k->w->list[PLT_WAVE_DONE][i];
        plt_wave_write(job, plt_wave_at(k->w, place));
        take(k, job, place, root);
    }
}

void plt_wave_bvh4(plt_wave_job *job) {
    plt_traversal *t = job->traversal;
    const plt_bvh4 *tree = t->scene->bvh4;
    run k = {job->wave, tree->nodes, {0, 0, 0}};
    for (uint32_t i = 0; i < k.w->rays_in_flight; i++) {
        if (!take(&k, job, i * k.w->ray_bytes, tree->root)) {
            break;
        }
    }
    while (k.on[PLT_WAVE_VISIT] + k.on[PLT_WAVE_TEST] + k.on[PLT_WAVE_DONE] > 0) {
        t->stats.node_visits += k.on[PLT_WAVE_VISIT];
        t->stats.group_tests += k.on[PLT_WAVE_VISIT];
        visit_all(&k);
        t->stats.triangle_tests += k.on[PLT_WAVE_TEST];
        test_all(&k, job);
        take_all(&k, job, tree->root);
    }
}
