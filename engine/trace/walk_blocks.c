/* walk_blocks - see walk_blocks.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/walk_blocks.h"

#include "engine/trace/boxes.h"
#include "engine/trace/triangle.h"
#include "engine/trace/walk.h"

static void count_fetch(plt_walker *w, uint32_t place, uint32_t bytes) {
    w->stats.bytes_fetched += bytes;
    if (!(w->touched[place / 32] >> place % 32 & 1u)) {
        w->touched[place / 32] |= 1u << place % 32;
        w->stats.bytes_touched_once += bytes;
    }
}

/* Makes the block behind `link` the one in hand. */
static void take_block(plt_walker *w, uint32_t link) {
    plt_block_walker *b = &w->blocks;
    if (link == b->link) {
        return;
    }
    const uint32_t address = plt_block_address(link);
    plt_block_open(&b->block, b->tree.bytes + address, b->tree.lattice.bits);
    b->link = link;
    b->geometry_open = 0;
    w->stats.treelet_fetches++;
    count_fetch(w, address / 8, b->block.node_bytes);
}

static void take_geometry(plt_walker *w) {
    plt_block_walker *b = &w->blocks;
    plt_lattice_box frame;
    if (b->geometry_open) {
        return;
    }
    if (b->tree.records != NULL) {
        plt_geometry_open_counts(&b->geometry, &b->block, b->tree.leaf_triangles);
    } else {
        plt_block_frame(&b->block, b->tree.lattice.bits, &frame);
        plt_geometry_open(&b->geometry, &b->block, &frame, b->tree.leaf_triangles);
    }
    b->geometry_open = 1;
    count_fetch(w, plt_block_address(b->link) / 8 + 1, b->block.geometry_bytes);
}

static void set_box(plt_block_entry *to, const plt_lattice_box *box) {
    for (int a = 0; a < 3; a++) {
        to->lo[a] = (float)(int32_t)box->lo[a];
        to->hi[a] = (float)(int32_t)box->hi[a];
    }
    to->lo[3] = to->hi[3] = 0.0f;
}

void plt_walk_blocks_begin(plt_walker *w) {
    plt_block_walker *b = &w->blocks;
    plt_block_entry *root = &b->stack[0];
    set_box(root, &b->tree.box);
    root->child.link = b->tree.root;
    root->child.what = PLT_SLOT_EDGE;
    root->groups = w->packet.active;
    w->waiting = w->packet.active != 0 && b->tree.root != PLT_MISS;
    b->link = PLT_MISS;
}

/* Lattice numbers to planes of the scene: exact product, one rounding. */
static inline f4 planes_of(const plt_block_walker *b, f4 numbers) {
    return f4_add(f4_load(b->origin), f4_mul(f4_all(b->tree.lattice.step), numbers));
}

static plt_mask meet(const plt_walker *w, const plt_block_entry *e, plt_mask groups) {
    float lo[4], hi[4];
    plt_box box;
    f4_store(lo, planes_of(&w->blocks, f4_load(e->lo)));
    f4_store(hi, planes_of(&w->blocks, f4_load(e->hi)));
    for (int a = 0; a < 3; a++) {
        box.lo[a] = lo[a];
        box.hi[a] = hi[a];
    }
    return plt_box_groups(&w->packet, &box, groups);
}

/* Corners in canonical order (record.h): the least first. */
static void canonical(const plt_lattice *l, const uint32_t corner[3][3], float to[3][3]) {
    unsigned least = 0;
    uint64_t least_key = ~0ull;
    for (unsigned c = 0; c < 3; c++) {
        const uint64_t key =
            (uint64_t)corner[c][0] << 42 | (uint64_t)corner[c][1] << 21 | corner[c][2];
        least = key < least_key ? c : least;
        least_key = key < least_key ? key : least_key;
    }
    for (unsigned c = 0; c < 3; c++) {
        const uint32_t *from = corner[(least + c) % 3];
        for (int a = 0; a < 3; a++) {
            to[c][a] = plt_lattice_float(l, a, from[a]);
        }
    }
}

static float longest_side(const plt_lattice *l, const plt_block_entry *e) {
    float longest = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float side = e->hi[a] - e->lo[a];
        longest = side > longest ? side : longest;
    }
    return l->step * (longest + 1.0f); /* floats of corners were rounded */
}

static void test_unit(plt_walker *w, const plt_block_entry *at) {
    plt_block_walker *b = &w->blocks;
    uint32_t corner[PLT_UNIT_TRIANGLES_MOST][3][3];
    plt_triangle t;
    const uint32_t what = at->child.what, unit = what >> 8 & 0xFFu;
    take_block(w, at->child.link);
    take_geometry(w);
    const uint32_t first = plt_unit_first(&b->geometry, unit, what >> 16 & 0xFFu);
    const uint32_t count = plt_unit_count(&b->geometry, unit, (int)(what >> 24));
    if (b->tree.records == NULL) {
        plt_unit_corners(&b->geometry, first, count, corner);
    }
    t.longest = longest_side(&b->tree.lattice, at);
    t.numbers = b->tree.numbers.bytes == NULL ? NULL : &b->tree.numbers;
    plt_mask groups = at->groups;
    w->stats.triangle_tests += (uint64_t)count * plt_mask_count(groups);
    for (uint32_t i = 0; i < count; i++) {
        t.number = b->geometry.first_triangle + first + i;
        if (b->tree.records != NULL) {
            plt_record_corners(&b->tree.records[t.number], t.corner);
            t.number = plt_get_u32(&b->tree.records[t.number].word[9]);
        } else {
            canonical(&b->tree.lattice, (const uint32_t(*)[3])corner[i], t.corner);
        }
        if (w->packet.any) {
            groups &= w->packet.active;
        }
        plt_triangle_groups(&w->packet, &t, groups);
    }
}

/* What both slots of node `node` lead to. Both are worked out before it is known
 * which are met, without a branch: the time is hidden behind the box tests. All
 * slots before are inner, edges or units, so two counts give three ranks. */
static inline void describe(const plt_block_walker *w, uint32_t node, plt_block_child to[2]) {
    const plt_block *b = &w->block;
    const uint32_t word = node >> 4, shift = node << 1 & 31, below = plt_low_bits(shift);
    const uint32_t inner = b->mask[PLT_SLOT_INNER][word], edge = b->mask[PLT_SLOT_EDGE][word];
    uint32_t inners = b->before[PLT_SLOT_INNER][word] + plt_count_bits(inner & below);
    uint32_t edges = b->before[PLT_SLOT_EDGE][word] + plt_count_bits(edge & below);
    uint32_t pairs = b->pairs_before[word] + plt_count_bits(b->pair[word] & below);
    uint32_t units = 2 * node - inners - edges;
    for (uint32_t c = 0; c < 2; c++) {
        const uint32_t is_inner = inner >> (shift + c) & 1u, is_edge = edge >> (shift + c) & 1u;
        const uint32_t is_unit = 1u - is_inner - is_edge;
        const uint32_t is_pair = b->pair[word] >> (shift + c) & 1u;
        const uint32_t number = ((0u - is_inner) & (inners + 1)) | ((0u - is_unit) & units);
        const uint32_t link = plt_block_edge(b, edges); /* in the block or close behind */
        to[c].link = ((0u - is_edge) & link) | ((is_edge - 1u) & w->link);
        to[c].what = is_edge * PLT_SLOT_EDGE | is_unit * PLT_SLOT_UNIT | number << 8 | pairs << 16 |
                     is_pair << 24;
        plt_prefetch(w->tree.bytes + plt_block_address(to[c].link));
        inners += is_inner;
        edges += is_edge;
        units += is_unit;
        pairs += is_pair;
    }
}

static inline uint32_t kind_of(const plt_block_entry *e) {
    return e->child.what & 0xFFu;
}

static inline uint32_t number_of(const plt_block_entry *e) {
    return e->child.what >> 8 & 0xFFu;
}

/* Enters the block behind an edge: its frame is tighter than the box that led
 * here. 0: nothing meets it. */
static int enter(plt_walker *w, plt_block_entry *at) {
    plt_lattice_box frame;
    take_block(w, at->child.link);
    plt_block_frame(&w->blocks.block, w->blocks.tree.lattice.bits, &frame);
    set_box(at, &frame);
    at->child.what = PLT_SLOT_INNER; /* node 0 */
    at->groups = meet(w, at, at->groups);
    return at->groups != 0;
}

/* max(1, (e + 254) / 255 rounded down), three axes at once: the quotient is at
 * least 1 / 255 from any whole number that it is not, and below 2^14, so that the
 * product is on the right side after 0.498 is taken off; adding 2^23 rounds. */
static inline f4 plane_step(f4 extent) {
    const f4 quotient = f4_mul(f4_add(extent, f4_all(254.0f)), f4_all(1.0f / 255.0f));
    const f4 magic = f4_all(8388608.0f);
    const f4 whole = f4_sub(f4_add(f4_sub(quotient, f4_all(0.498f)), magic), magic);
    return f4_max(whole, f4_all(1.0f));
}

/* Both children's boxes, as plt_block_apply (block.h). */
static inline void decode(const plt_block *b, const plt_block_entry *at, f4 lo[2], f4 hi[2]) {
    const unsigned char *plane = b->planes + 6 * number_of(at);
    /* xmin is always the right child's: five bits are stored. */
    const uint32_t owners = plt_bits_get(b->owners, 5 * number_of(at), 5) << 1 | 1u;
    const float from_lo[4] = {plane[0], plane[1], plane[2], 0.0f};
    const float from_hi[4] = {plane[3], plane[4], plane[5], 0.0f};
    const f4 old_lo = f4_load(at->lo), old_hi = f4_load(at->hi);
    const f4 step = plane_step(f4_sub(old_hi, old_lo));
    const f4 new_lo = f4_add(old_lo, f4_mul(f4_load(from_lo), step));
    const f4 new_hi = f4_sub(old_hi, f4_mul(f4_load(from_hi), step));
    const m4 right_lo = m4_bits(owners & 7u), right_hi = m4_bits(owners >> 3);
    lo[0] = f4_select(right_lo, old_lo, new_lo);
    lo[1] = f4_select(right_lo, new_lo, old_lo);
    hi[0] = f4_select(right_hi, old_hi, new_hi);
    hi[1] = f4_select(right_hi, new_hi, old_hi);
}

static inline void set_entry(plt_block_entry *to, f4 lo, f4 hi, const plt_block_child *child,
                             plt_mask groups) {
    f4_store(to->lo, lo);
    f4_store(to->hi, hi);
    to->child = *child;
    to->groups = groups;
}

/* Visits the node `at`; goes on to the nearer child that is met. 0: none is. */
static int visit(plt_walker *w, plt_block_entry *at) {
    plt_block_walker *b = &w->blocks;
    f4 lo[2], hi[2];
    float plane_lo[2][4], plane_hi[2][4];
    const float *const los[2] = {plane_lo[0], plane_lo[1]}, *const his[2] = {plane_hi[0],
                                                                             plane_hi[1]};
    plt_mask hit[2];
    plt_block_child child[2];
    take_block(w, at->child.link);
    describe(b, number_of(at), child);
    decode(&b->block, at, lo, hi);
    for (int c = 0; c < 2; c++) {
        f4_store(plane_lo[c], planes_of(b, lo[c]));
        f4_store(plane_hi[c], planes_of(b, hi[c]));
    }
    plt_box_pair(&w->packet, los, his, at->groups, hit);
    w->stats.node_visits++;
    w->stats.group_tests += 2 * plt_mask_count(at->groups);
    uint32_t near = (uint32_t)plt_walk_nearer(&w->packet, los, his);
    near ^= (uint32_t)(hit[near] == 0);
    if (hit[0] != 0 && hit[1] != 0) {
        set_entry(&b->stack[w->waiting++], lo[near ^ 1], hi[near ^ 1], &child[near ^ 1],
                  hit[near ^ 1]);
    }
    set_entry(at, lo[near], hi[near], &child[near], hit[near]);
    return hit[near] != 0;
}

/* From an entry down to a unit that is met, or to nothing. Returns the visits. */
static uint32_t descend(plt_walker *w, plt_block_entry *at) {
    for (uint32_t visits = 0;; visits++) {
        if (kind_of(at) == PLT_SLOT_UNIT) {
            test_unit(w, at);
            return visits;
        }
        if (kind_of(at) == PLT_SLOT_EDGE && !enter(w, at)) {
            return visits + 1;
        }
        if (!visit(w, at)) {
            return visits + 1;
        }
    }
}

uint32_t plt_walk_blocks(plt_walker *w, uint32_t visits) {
    while (w->waiting > 0 && visits > 0) {
        plt_block_entry at = w->blocks.stack[--w->waiting];
        at.groups &= w->packet.active;
        if (kind_of(&at) != PLT_SLOT_EDGE) { /* an edge is tested against its block's frame */
            at.groups = meet(w, &at, at.groups);
        }
        const uint32_t used = at.groups == 0 ? 1 : 1 + descend(w, &at);
        visits -= used < visits ? used : visits;
        if (w->packet.active == 0) {
            w->waiting = 0;
        }
    }
    return visits;
}
