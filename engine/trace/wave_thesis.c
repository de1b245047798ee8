/* wave_thesis - the wave over thesis nodes
 *
 * A node gives its children six planes, and each one belongs to one of them. Beside it a child
 * has its parent's, so the interval in which a ray is in the child is that in its parent, cut
 * by the planes that are the child's own: near planes of a child lie within those of its
 * parent, and distances are monotone (DESIGN.md, section 7.3), so that the greatest of them is
 * the same number as over all six of the child's box. Six distances instead of twelve, and no
 * box on the stack.
 *
 * Stack: entry 0 is the end. A node on level d (the root's is 1) is visited with at most d - 1
 * entries above it, and two are stored: depth + 2 entries are enough. Leaves have branches,
 * as lists of records end where they say.
 *
 * Source: Karrenberg 2007, section 3.5 (intervals); the wave is ours.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave_thesis.h"

#include <string.h>

#include "engine/trace/ray_block.h"
#include "engine/tree/record.h"

#define ENDLESS __builtin_inff()

/* What waits: where the ray is in its box, both ends such that greater is narrower. */
typedef struct entry {
    float enter, minus_leave;
    uint32_t link; /* of thesis/link.h, or PLT_LINK_NONE: the end */
    uint32_t pad;
} entry;

/* A ray in flight, its stack behind it. */
typedef struct thesis_ray {
    plt_wave_ray ray;
    float near_org[4], far_org[4], rdir[4]; /* x y z; the fourth means nothing */
    float interval[4];                      /* enter twice, minus leave twice */
    float range[4];                         /* tmin twice, minus tmax twice */
    uint32_t negative;                      /* signs of dir, as owner bits: 4 is x */
    uint32_t pad[3];
} thesis_ray;

_Static_assert(sizeof(thesis_ray) == sizeof(plt_wave_ray) + PLT_WAVE_THESIS_BYTES &&
                   sizeof(entry) == 16,
               "what plt_wave_stack_bytes counts with");

/* What min leaves of planes x y z for the left child, by three owner bits: those of the right
 * child become -infinity. */
static const float cut[8][4] = {
#define KEPT(owners, bit) ((owners) & (bit) ? -ENDLESS : ENDLESS)
#define CUT(owners)                                                                                \
    { KEPT(owners, 4), KEPT(owners, 2), KEPT(owners, 1), -ENDLESS }
    CUT(0), CUT(1), CUT(2), CUT(3), CUT(4), CUT(5), CUT(6), CUT(7)};

/* By which children are met, and whether the right one is farther: how far above the top of
 * the stack the left one goes, the nearest last. The right one goes to the other place. */
static const uint8_t place_of_left[8] = {0, 0, 1, 0, 0, 0, 1, 1};
static const uint8_t ones[4] = {0, 1, 1, 2};

typedef struct run {
    const plt_tree *tree;
    const unsigned char *base[2]; /* of nodes, of records */
    plt_wave_found *found;
    plt_wave_lists on;
} run;

static const uint32_t bytes_of[2] = {PLT_NODE_BYTES, PLT_RECORD_BYTES};

static inline entry *stack_of(thesis_ray *r) {
    return (entry *)(void *)(r + 1);
}

static inline thesis_ray *whole(plt_wave_ray *r) {
    return (thesis_ray *)(void *)r;
}

static inline uint32_t link_of(const thesis_ray *r) {
    return (uint32_t)r->ray.next;
}

/* Takes the top of the stack, puts the ray on the list of what that is, and asks for it: a
 * node's line, or those of four records. */
static inline void go_on(run *k, thesis_ray *r) {
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
    r->interval[0] = r->interval[1] = e->enter;
    r->interval[2] = r->interval[3] = e->minus_leave;
    plt_wave_enlist(&k->on, &r->ray, is_leaf);
}

/* ---- nodes ---------------------------------------------------------------------- */

/* Four words of the image. */
static inline f4 words_of(const uint32_t word[4]) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    return f4_load((const float *)(const void *)word);
#else
    uint32_t own[4];
    for (int i = 0; i < 4; i++) {
        own[i] = plt_get_u32(&word[i]);
    }
    return f4_load((const float *)(const void *)own);
#endif
}

/* Where the ray enters both children, and minus where it leaves them. */
static inline f4 intervals(const plt_node *node, const thesis_ray *r) {
    const f4 rdir = f4_load_16(r->rdir), lo = words_of(&node->word[0]),
             hi = words_of(&node->word[3]);
    const m4 negative = f4_lt(rdir, f4_zero());
    const f4 near = f4_mul(f4_sub(f4_select(negative, hi, lo), f4_load_16(r->near_org)), rdir);
    const f4 far = f4_mul(f4_sub(f4_load_16(r->far_org), f4_select(negative, lo, hi)), rdir);
    const uint32_t mins = plt_node_link(node, 0) >> 2 & 7u;
    const uint32_t maxs = plt_node_link(node, 1) >> 2 & 7u;
    const uint32_t swapped = (mins ^ maxs) & r->negative;
    const uint32_t nears = mins ^ swapped, fars = maxs ^ swapped;
    f4 row[4] = {f4_min(near, f4_load(cut[nears])), f4_min(near, f4_load(cut[nears ^ 7u])),
                 f4_min(far, f4_load(cut[fars])), f4_min(far, f4_load(cut[fars ^ 7u]))};
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    const f4 inside = f4_max(f4_load_16(r->interval), f4_load_16(r->range));
    return f4_max(f4_max(f4_max(row[0], row[1]), row[2]), inside);
}

/* Where the ray enters both children and minus where it leaves them, and which are met. */
static inline void test_children(const plt_node *node, const thesis_ray *r, plt_wave_found *to) {
    const f4 at = intervals(node, r);
    const f4 leave = f4_neg(f4_rotate(f4_rotate(at)));
    const unsigned order = m4_mask(f4_lt(at, f4_rotate(at))) & 1u;
    f4_store(to->at, at);
    to->met = m4_mask(f4_le(at, leave)) & 3u;
    to->row = to->met | order << 2;
}

/* Children that are met go onto the stack, the nearer one on top. */
static inline void push(const plt_node *node, thesis_ray *r, const plt_wave_found *from) {
    const uint32_t left = place_of_left[from->row];
    entry *stack = r->ray.top;
    stack[left].enter = from->at[0];
    stack[left].minus_leave = from->at[2];
    stack[left].link = plt_node_link(node, 0);
    stack[left ^ 1u].enter = from->at[1];
    stack[left ^ 1u].minus_leave = from->at[3];
    stack[left ^ 1u].link = plt_node_link(node, 1);
    r->ray.top = stack + ones[from->met];
}

/* In two halves, as in wave_bvh4.c. */
PLT_WAVE_LOOP static void visit_all(run *shared) {
    run k = *shared; /* so that counts stay in registers */
    plt_wave_ray **const list = k.on.list[PLT_WAVE_VISIT];
    const plt_node *const nodes = k.tree->nodes;
    const size_t count = k.on.on[PLT_WAVE_VISIT];
    for (size_t i = 0; i < count; i++) {
        const thesis_ray *r = whole(list[i]);
        test_children(&nodes[plt_link_index(link_of(r))], r, &k.found[i]);
    }
    k.on.on[PLT_WAVE_VISIT] = 0;
    for (size_t i = 0; i < count; i++) {
        thesis_ray *r = whole(list[i]);
        push(&nodes[plt_link_index(link_of(r))], r, &k.found[i]);
        go_on(&k, r);
    }
    *shared = k;
}

/* ---- leaves ----------------------------------------------------------------------- */

/* The longest sides of four triangles' boxes. */
static inline f4 longest_of(const plt_bvh4_block *b) {
    f4 side[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 p = f4_load(b->corner[0][a]), q = f4_load(b->corner[1][a]),
                 s = f4_load(b->corner[2][a]);
        side[a] = f4_sub(f4_max(f4_max(p, q), s), f4_min(f4_min(p, q), s));
    }
    return f4_max(f4_max(side[0], side[1]), side[2]);
}

/* Up to four records of a leaf, that has so many lists left from `record` on; returns how
 * many there are. Lanes without one are as in bvh4.h. */
static inline unsigned load_records(const plt_record *record, uint32_t *lists, plt_bvh4_block *b) {
    f4 row[3][4];
    float longest[4];
    unsigned count = 0;
    PLT_UNROLLED for (unsigned lane = 0; lane < 4; lane++) {
        const plt_record *at = *lists > 0 ? &record[lane] : record;
        count += *lists > 0;
        *lists -= *lists > 0 && plt_record_is_last(at);
        row[0][lane] = words_of(&at->word[0]);
        row[1][lane] = words_of(&at->word[4]);
        row[2][lane] = words_of(&at->word[6]);
    }
    PLT_UNROLLED for (unsigned i = 0; i < 3; i++) {
        f4_transpose(&row[i][0], &row[i][1], &row[i][2], &row[i][3]);
    }
    PLT_UNROLLED for (unsigned i = 0; i < 4; i++) {
        f4_store(b->corner[i / 3][i % 3], row[0][i]);
        f4_store(b->corner[(i + 4) / 3][(i + 4) % 3], row[1][i]);
    }
    f4_store(b->corner[2][2], row[2][2]);
    f4_store((float *)(void *)b->word, row[2][3]); /* bits are moved, not computed with */
    f4_store(longest, longest_of(b));
    for (unsigned lane = 0; lane < 4; lane++) {
        b->longest[lane] = lane < count ? longest[lane] : -ENDLESS;
    }
    return count;
}

/* Drops what lies behind the new hit. */
static inline void cull(thesis_ray *r) {
    entry *stack = stack_of(r);
    const float tmax = r->ray.tmax[0];
    entry *kept = stack + 1;
    for (const entry *at = kept; at < (const entry *)r->ray.top; at++) {
        const entry e = *at;
        *kept = e;
        kept += e.enter <= tmax;
    }
    r->ray.top = kept;
    r->range[2] = r->range[3] = -tmax;
}

/* Tests all records of a leaf; returns how many blocks they were. */
static uint32_t test_leaf(const run *k, thesis_ray *r, const plt_wave_job *job) {
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

static void test_all(run *k, const plt_wave_job *job) {
    const size_t count = k->on.on[PLT_WAVE_TEST];
    k->on.on[PLT_WAVE_TEST] = 0;
    for (size_t i = 0; i < count; i++) {
        thesis_ray *r = whole(k->on.list[PLT_WAVE_TEST][i]);
        job->traversal->stats.triangle_tests += test_leaf(k, r, job);
        go_on(k, r);
    }
}

/* ---- rays ------------------------------------------------------------------------ */

static void set_axes(thesis_ray *r) {
    r->negative = 0;
    for (int a = 0; a < 3; a++) {
        r->near_org[a] = r->ray.near_org[a][0];
        r->far_org[a] = r->ray.far_org[a][0];
        r->rdir[a] = r->ray.rdir[a][0];
        r->negative |= (uint32_t)(r->rdir[a] < 0.0f) << (2 - a);
    }
    r->near_org[3] = r->far_org[3] = r->rdir[3] = 1.0f;
    r->range[0] = r->range[1] = r->ray.tmin[0];
    r->range[2] = r->range[3] = -r->ray.tmax[0];
}

/* Where the ray is in the scene's box. */
static entry root_entry(const thesis_ray *r, const plt_box *box, uint32_t link) {
    entry e = {-ENDLESS, -ENDLESS, link, 0};
    for (int a = 0; a < 3; a++) {
        const int negative = r->rdir[a] < 0.0f;
        const float n = ((negative ? box->hi[a] : box->lo[a]) - r->near_org[a]) * r->rdir[a];
        const float f = (r->far_org[a] - (negative ? box->lo[a] : box->hi[a])) * r->rdir[a];
        e.enter = n > e.enter ? n : e.enter;
        e.minus_leave = f > e.minus_leave ? f : e.minus_leave;
    }
    return e;
}

/* The next ray, where one is done. */
static int take(run *k, plt_wave_job *job, thesis_ray *r) {
    const entry end = {-ENDLESS, -ENDLESS, PLT_LINK_NONE, 0};
    if (!plt_wave_take(job, &r->ray)) {
        return 0;
    }
    set_axes(r);
    stack_of(r)[0] = end;
    stack_of(r)[1] = root_entry(r, &job->traversal->scene->box, k->tree->root);
    r->ray.top = &stack_of(r)[2];
    go_on(k, r);
    return 1;
}

static void take_all(run *k, plt_wave_job *job) {
    const size_t count = k->on.on[PLT_WAVE_DONE];
    k->on.on[PLT_WAVE_DONE] = 0;
    for (size_t i = 0; i < count; i++) {
        take(k, job, whole(k->on.list[PLT_WAVE_DONE][i]));
    }
}

void plt_wave_thesis(plt_wave_job *job) {
    const plt_tree *tree = &job->traversal->scene->thesis;
    const plt_wave *w = job->wave;
    run k = {tree,
             {(const unsigned char *)tree->nodes, (const unsigned char *)tree->records},
             w->found,
             plt_wave_no_lists(w)};
    for (uint32_t i = 0; i < w->rays_in_flight; i++) {
        if (!take(&k, job, whole(plt_wave_slot(w, i)))) {
            break;
        }
    }
    while (k.on.on[PLT_WAVE_VISIT] + k.on.on[PLT_WAVE_TEST] > 0) {
        job->traversal->stats.node_visits += k.on.on[PLT_WAVE_VISIT];
        job->traversal->stats.group_tests += k.on.on[PLT_WAVE_VISIT];
        visit_all(&k);
        plt_wave_part(&k.on, PLT_LINK_NONE);
        test_all(&k, job);
        take_all(&k, job);
    }
}
