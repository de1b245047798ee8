/* wave_compact - the wave over compact blocks
 *
 * A block is never opened (memory/block_cache.h): a ray that comes to one takes the node that it
 * visits from the bytes as they lie (raw_block.h). A node's planes are the children's own, as over
 * thesis nodes, so six distances are enough (wave_binary.h); but children's boxes are decoded from
 * their parent's, which has to lie on the stack beside the interval. A ray at an edge waits twice:
 * until the next block's link is known, and until its bytes are there.
 *
 * A visit has no branch that depends on its ray; check_branches.sh counts the jumps.
 *
 * Stack: entry 0 is the end. A node on level d (the root's is 1) is visited with at most d - 1
 * entries above it, and two are stored: depth + 2 entries are enough. A block's root takes the
 * place of the edge that led to it.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave_compact.h"

#if PLT_WITH_WAVE_COMPACT

#include "engine/base/small_stack.h"
#include "engine/trace/leaf_compact.h"
#include "engine/trace/ray_block.h"
#include "engine/trace/wave_binary.h"
#include "engine/trace/wave_leaf_compact.h"
#include "engine/tree/compact/raw_block.h"

/* What waits: its box in lattice coordinates, where the ray is in it (wave_binary.h), and below. */
typedef struct entry {
    float lo[3], hi[3];
    float inside[2];
    uint64_t what;
} entry;

/* `what`: the link of the block in bits 0 .. 31, the nodes of the block less one above, then which
 * node, and of a leaf or an edge which slot; and what it is. */
enum { NODES_SHIFT = 32, NODE_SHIFT = 40, SLOT_SHIFT = 48, KIND_SHIFT = 56 };
enum { IS_NODE = 0, IS_LEAF = 1, IS_EDGE = 3, IS_END = 5 };

static const uint64_t end = (uint64_t)IS_END << KIND_SHIFT;

/* A ray in flight, its stack behind it. */
typedef struct compact_ray {
    plt_binary_ray binary;
    float up[4], down[4]; /* how far inside the parent's box the planes of the node are */
    uint32_t mins, maxs;  /* whose they are */
    uint32_t pad[6];
} compact_ray;

_Static_assert(sizeof(compact_ray) == sizeof(plt_wave_ray) + PLT_WAVE_COMPACT_BYTES &&
                   sizeof(entry) == PLT_WAVE_COMPACT_ENTRY_BYTES,
               "what plt_wave_stack_bytes counts with");

static const float cut[8][4] = PLT_BINARY_CUT(1, 2, 4);
static const uint8_t axis_bit[3] = {1, 2, 4};

/* Where a child's planes are its own, by the bits of the right one. */
static const float own[8][4] = {
#define OWN(owners, bit) ((owners) & (bit) ? PLT_ENDLESS : 0.0f)
#define ROW(owners)                                                                                \
    { OWN(owners, 1), OWN(owners, 2), OWN(owners, 4), 0.0f }
    ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5), ROW(6), ROW(7)};

/* What is added for both children of a node, by their bits a (0 and 1) and m (2 and 3): kind, slot
 * and for the second node. */
#define KIND(a, m) ((uint64_t)((a) ? (m) ? IS_EDGE : IS_NODE : IS_LEAF) << KIND_SHIFT)
#define BIT(x, bit) ((x) >> (bit)&1)
#define INNER(x) ((uint64_t)(BIT(x, 0) && !BIT(x, 2)) << NODE_SHIFT)
#define KINDS(x)                                                                                   \
    {                                                                                              \
        KIND(BIT(x, 0), BIT(x, 2)),                                                                \
            KIND(BIT(x, 1), BIT(x, 3)) + INNER(x) + ((uint64_t)1 << SLOT_SHIFT)                    \
    }
static const uint64_t kinds[16][2] = {
    KINDS(0), KINDS(1), KINDS(2),  KINDS(3),  KINDS(4),  KINDS(5),  KINDS(6),  KINDS(7),
    KINDS(8), KINDS(9), KINDS(10), KINDS(11), KINDS(12), KINDS(13), KINDS(14), KINDS(15)};

typedef struct run {
    const plt_block_tree *tree;
    const unsigned char *masks; /* of a block at address 0 */
    plt_wave_found *found;
    plt_wave_lists on;
    plt_wave_ray **cross, **enter; /* rays at an edge; and at a block */
    size_t crossing, entering;
} run;

static inline compact_ray *whole(plt_wave_ray *r) {
    return (compact_ray *)(void *)r;
}

static inline entry *stack_of(compact_ray *r) {
    return (entry *)(void *)(r + 1);
}

/* What the ray is at lies just above the top of its stack. */
static inline entry *at_hand(const compact_ray *r) {
    return r->binary.ray.top;
}

static inline uint32_t link_of(uint64_t what) {
    return (uint32_t)what;
}

static inline uint32_t nodes_of(uint64_t what) {
    return (uint32_t)(what >> NODES_SHIFT & 63u) + 1;
}

static inline uint32_t node_of(uint64_t what) {
    return (uint32_t)(what >> NODE_SHIFT) & 63u;
}

static inline uint32_t slot_of(uint64_t what) {
    return (uint32_t)(what >> SLOT_SHIFT) & 127u;
}

static inline uint32_t kind_of(uint64_t what) {
    return (uint32_t)(what >> KIND_SHIFT);
}

/* Takes the top of the stack. Rays at anything but a node go to one list, from which they are
 * parted. */
static inline void go_on(run *k, compact_ray *r) {
    const entry *e = at_hand(r) - 1;
    r->binary.ray.top = at_hand(r) - 1;
    plt_wave_enlist(&k->on, &r->binary.ray, kind_of(e->what) & 1u);
}

/* ---- nodes ---------------------------------------------------------------------- */

/* As in format_compact.h. */
static inline f4 plane_step(f4 extent) {
    const f4 quotient = f4_mul(f4_add(extent, f4_all(254.0f)), f4_all(1.0f / 255.0f));
    const f4 magic = f4_all(8388608.0f);
    const f4 steps = f4_sub(f4_add(f4_sub(quotient, f4_all(0.498f)), magic), magic);
    return f4_max(steps, f4_all(1.0f));
}

/* Decodes a node's planes, and tests both children. */
static inline void test_children(const run *k, compact_ray *r, plt_wave_found *to) {
    const entry *e = at_hand(r);
    const plt_lattice *l = &k->tree->lattice;
    const uint64_t what = e->what;
    const uint32_t nodes = nodes_of(what), node = node_of(what);
    const unsigned char *masks = k->masks + plt_block_address(link_of(what));
    const unsigned char *owner = masks + 2 * plt_raw_mask_bytes(nodes);
    const unsigned char *plane = masks + plt_raw_planes_at(nodes) + 6 * node;
    const uint32_t owners = plt_bits_get(owner, 5 * node, 5) << 1 | 1u;
    const f4 lo = f4_load(e->lo), hi = f4_load(e->hi), step = plane_step(f4_sub(hi, lo));
    const f4 up = f4_mul(f4_of_bytes(plane), step), down = f4_mul(f4_of_bytes(plane + 3), step);
    r->mins = owners & 7u;
    r->maxs = owners >> 3;
    f4_store(r->up, up);
    f4_store(r->down, down);
    plt_binary_find(
        plt_binary_intervals(&r->binary, e->inside, cut, plt_lattice_planes(l, f4_add(lo, up)),
                             plt_lattice_planes(l, f4_sub(hi, down)), owners & 7u, owners >> 3),
        to);
}

/* A child, its planes as far inside its parent's as they are its own. */
static inline void push_one(entry *to, f4 lo, f4 hi, const float inside[2], uint64_t what) {
    f4_store(to->lo, lo); /* each fourth lane is overwritten by what comes next */
    f4_store(to->hi, hi);
    memcpy(to->inside, inside, sizeof to->inside);
    to->what = what;
}

/* Children that are met go onto the stack, the nearer one on top. */
static inline void push(const run *k, compact_ray *r, const plt_wave_found *from) {
    entry *e = at_hand(r);
    const uint64_t what = e->what;
    const uint32_t nodes = nodes_of(what), node = node_of(what);
    const unsigned char *a = k->masks + plt_block_address(link_of(what));
    const unsigned char *m = a + plt_raw_mask_bytes(nodes);
    const uint32_t both = (a[node >> 2] | (uint32_t)m[node >> 2] << 8) >> 2 * (node & 3u);
    const uint64_t *kind = kinds[(both & 3u) | (both >> 6 & 12u)];
    const uint32_t rank = plt_raw_rank(u4_andnot(u4_load_bytes(a), u4_load_bytes(m)), 2 * node) + 1;
    const uint64_t base = (what & (((uint64_t)1 << NODE_SHIFT) - 1)) |
                          (uint64_t)(rank | node << (SLOT_SHIFT - NODE_SHIFT + 1)) << NODE_SHIFT;
    const f4 lo = f4_load(e->lo), hi = f4_load(e->hi);
    const f4 up = f4_load_16(r->up), down = f4_load_16(r->down);
    const uint32_t left = plt_binary_place[from->row];
    push_one(e + left, f4_add(lo, f4_min(up, f4_load(own[r->mins ^ 7u]))),
             f4_sub(hi, f4_min(down, f4_load(own[r->maxs ^ 7u]))), &from->at[0], base + kind[0]);
    push_one(e + (left ^ 1u), f4_add(lo, f4_min(up, f4_load(own[r->mins]))),
             f4_sub(hi, f4_min(down, f4_load(own[r->maxs]))), &from->at[2], base + kind[1]);
    r->binary.ray.top = e + plt_binary_ones[from->row];
}

/* In two halves, as in wave_bvh4.c. */
PLT_WAVE_LOOP static void visit_all(run *shared) {
    run k = *shared; /* so that counts stay in registers */
    plt_wave_ray **const list = k.on.list[PLT_WAVE_VISIT];
    const size_t count = k.on.on[PLT_WAVE_VISIT];
    for (size_t i = 0; i < count; i++) {
        test_children(&k, whole(list[i]), &k.found[i]);
    }
    k.on.on[PLT_WAVE_VISIT] = 0;
    for (size_t i = 0; i < count; i++) {
        compact_ray *r = whole(list[i]);
        push(&k, r, &k.found[i]);
        go_on(&k, r);
    }
    *shared = k;
}

/* ---- from block to block ---------------------------------------------------------- */

/* Parts rays at leaves, at edges, and those that are done; asks for geometry. */
static void part(run *k) {
    plt_wave_ray **const test = k->on.list[PLT_WAVE_TEST], **const done = k->on.list[PLT_WAVE_DONE];
    const size_t count = k->on.on[PLT_WAVE_TEST];
    size_t tests = 0, ends = 0, edges = k->crossing;
    for (size_t i = 0; i < count; i++) {
        compact_ray *r = whole(test[i]);
        const uint64_t what = at_hand(r)->what;
        const uint32_t kind = kind_of(what), link = link_of(what);
        const unsigned char *at =
            k->tree->bytes + plt_block_address(link) + plt_block_node_bytes(link);
        plt_prefetch(at);
        plt_prefetch(at + 64);
        test[tests] = k->cross[edges] = done[ends] = &r->binary.ray;
        tests += kind == IS_LEAF;
        edges += kind == IS_EDGE;
        ends += kind == IS_END;
    }
    k->on.on[PLT_WAVE_TEST] = tests;
    k->on.on[PLT_WAVE_DONE] = ends;
    k->crossing = edges;
}

/* Finds the blocks behind edges, and asks for them. */
static void cross_all(run *k) {
    for (size_t i = 0; i < k->crossing; i++) {
        compact_ray *r = whole(k->cross[i]);
        entry *e = at_hand(r);
        const uint32_t nodes = nodes_of(e->what);
        const unsigned char *at = k->masks + plt_block_address(link_of(e->what));
        const uint32_t edge = plt_raw_rank(plt_raw_masks_get(at, nodes).edge, slot_of(e->what));
        e->what = plt_get_u32(at + plt_raw_links_at(nodes) + 4 * edge);
        at = k->tree->bytes + plt_block_address(link_of(e->what));
        plt_prefetch(at);
        plt_prefetch(at + 64);
        plt_prefetch(at + 128);
        k->enter[k->entering++] = &r->binary.ray;
    }
    k->crossing = 0;
}

/* The exact box of a block's root. */
static inline void read_bounds(const unsigned char *block, uint32_t bits, entry *e) {
    float lo[4], hi[4];
    if (bits <= 16) {
        f4_store(lo, f4_of_halves(block + PLT_BLOCK_HEADER_BYTES));
        f4_store(hi, f4_of_halves(block + PLT_BLOCK_HEADER_BYTES + 6));
    } else {
        plt_lattice_box bounds;
        plt_block_bounds_at(block, bits, &bounds);
        plt_lattice_spread(&bounds, lo, hi);
    }
    memcpy(e->lo, lo, sizeof e->lo);
    memcpy(e->hi, hi, sizeof e->hi);
}

static void enter_all(run *k) {
    for (size_t i = 0; i < k->entering; i++) {
        compact_ray *r = whole(k->enter[i]);
        entry *e = at_hand(r);
        const unsigned char *block = k->tree->bytes + plt_block_address(link_of(e->what));
        read_bounds(block, k->tree->lattice.bits, e);
        e->what |= (uint64_t)(plt_raw_nodes(block) - 1) << NODES_SHIFT;
        k->on.list[PLT_WAVE_VISIT][k->on.on[PLT_WAVE_VISIT]++] = &r->binary.ray;
    }
    k->entering = 0;
}

/* ---- leaves ----------------------------------------------------------------------- */

/* Drops what lies behind the new hit. */
static inline void cull(compact_ray *r) {
    const float tmax = r->binary.ray.tmax[0];
    entry *kept = stack_of(r) + 1;
    for (const entry *at = kept; at < at_hand(r); at++) {
        const entry e = *at;
        *kept = e;
        kept += e.inside[0] <= tmax;
    }
    r->binary.ray.top = kept;
    plt_binary_end(&r->binary);
}

/* As plt_ray_block, but for the words. */
static int test_block(const run *k, compact_ray *r, const plt_wave_job *job,
                      const plt_wave_leaf_run *leaf, uint32_t number, plt_bvh4_block *b) {
    block_edges e;
    const unsigned met = plt_block_edges(&r->binary.ray, b, &e);
    const unsigned may = met != 0 ? met & plt_block_may_be_nearer(&r->binary.ray, b) : 0;
    if (may == 0) {
        return 0;
    }
    plt_wave_leaf_words(k->tree, leaf, number, b);
    return plt_block_hits(&r->binary.ray, b, job, may);
}

/* Returns how many blocks of four triangles they were. */
static uint32_t test_leaf(const run *k, compact_ray *r, const plt_wave_job *job) {
    _Alignas(16) plt_bvh4_block block[PLT_WAVE_LEAF_BLOCKS_MOST];
    const uint64_t what = at_hand(r)->what;
    const plt_wave_leaf leaf = {link_of(what), nodes_of(what), slot_of(what)};
    const plt_wave_leaf_run found = plt_wave_leaf_load(k->tree, &leaf, block);
    const uint32_t blocks = (found.count + 3) / 4;
    for (uint32_t i = 0; i < blocks; i++) {
        if (test_block(k, r, job, &found, i, &block[i])) {
            cull(r);
        }
    }
    return blocks;
}

PLT_APART_ON_SMALL_STACKS static void test_all(run *k, const plt_wave_job *job) {
    const size_t count = k->on.on[PLT_WAVE_TEST];
    k->on.on[PLT_WAVE_TEST] = 0;
    for (size_t i = 0; i < count; i++) {
        compact_ray *r = whole(k->on.list[PLT_WAVE_TEST][i]);
        job->traversal->stats.triangle_tests += test_leaf(k, r, job);
        go_on(k, r);
    }
}

/* ---- rays ------------------------------------------------------------------------ */

/* The next ray, where one is done. */
static int take(run *k, plt_wave_job *job, compact_ray *r) {
    const entry none = {{0, 0, 0}, {0, 0, 0}, {-PLT_ENDLESS, -PLT_ENDLESS}, end};
    if (!plt_wave_take(job, &r->binary.ray)) {
        return 0;
    }
    entry *e = stack_of(r);
    plt_binary_set(&r->binary, axis_bit);
    e[0] = e[1] = none;
    r->binary.ray.top = &e[1];
    if (k->tree->root == PLT_LINK_NONE) {
        go_on(k, r);
        return 1;
    }
    e[1].what = k->tree->root;
    plt_binary_root(&r->binary, &job->traversal->scene->box, e[1].inside);
    k->enter[k->entering++] = &r->binary.ray;
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

static void leave(plt_wave *w, const run *k) {
    plt_wave_lists_keep(w, &k->on);
    w->on[PLT_WAVE_CROSS] = (uint32_t)k->crossing;
    w->on[PLT_WAVE_ENTER] = (uint32_t)k->entering;
}

int plt_wave_compact(plt_wave_job *job) {
    const uint64_t before = job->traversal->stats.node_visits;
    plt_wave *w = job->wave;
    const plt_block_tree *tree = &job->traversal->scene->compact;
    run k = {.tree = tree,
             .masks = tree->bytes + plt_raw_masks_at(tree->lattice.bits),
             .found = w->found,
             .on = plt_wave_lists_get(w),
             .crossing = w->on[PLT_WAVE_CROSS],
             .entering = w->on[PLT_WAVE_ENTER],
             .cross = w->list[PLT_WAVE_CROSS],
             .enter = w->list[PLT_WAVE_ENTER]};
    plt_wave_fill(w, job, &k.on);
    take_all(&k, job);
    while (k.on.on[PLT_WAVE_VISIT] + k.on.on[PLT_WAVE_TEST] + k.crossing + k.entering > 0) {
        if (plt_wave_waits(job) || plt_wave_is_over(job, before)) {
            leave(w, &k);
            return PLT_MORE;
        }
        enter_all(&k);
        job->traversal->stats.node_visits += k.on.on[PLT_WAVE_VISIT];
        job->traversal->stats.group_tests += k.on.on[PLT_WAVE_VISIT];
        visit_all(&k);
        part(&k);
        cross_all(&k);
        test_all(&k, job);
        take_all(&k, job);
    }
    leave(w, &k);
    return plt_wave_waits(job) ? PLT_MORE : PLT_OK;
}

#endif
