/* walk_blocks - see walk_blocks.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/walk_blocks.h"

#include "engine/trace/boxes.h"
#include "engine/trace/walk.h"
#include "engine/trace/walk_unit.h"

static void count_fetch(plt_walker *w, uint32_t place, uint32_t bytes) {
    w->stats.bytes_fetched += bytes;
    if (!(w->touched[place / 32] >> place % 32 & 1u)) {
        w->touched[place / 32] |= 1u << place % 32;
        w->stats.bytes_touched_once += bytes;
    }
}

/* Makes the block behind `link` the one in hand. */
static inline plt_opened_block *take_block(plt_walker *w, uint32_t link) {
    plt_block_walker *b = &w->blocks;
    if (b->in_hand != NULL && link == b->in_hand->link) {
        return b->in_hand;
    }
    b->in_hand = plt_block_cache_find(b->open, &b->tree, link);
    b->geometry_in_hand = 0;
    w->stats.treelet_fetches++;
    count_fetch(w, plt_block_address(link) / 8, b->in_hand->block.node_bytes);
    return b->in_hand;
}

static void test_unit(plt_walker *w, const plt_block_entry *at) {
    plt_opened_block *o = take_block(w, at->child.link);
    if (!o->geometry_open) {
        plt_opened_block_geometry(o, &w->blocks.tree);
    }
    if (!w->blocks.geometry_in_hand) {
        w->blocks.geometry_in_hand = 1;
        count_fetch(w, plt_block_address(o->link) / 8 + 1, o->block.geometry_bytes);
    }
    plt_walk_leaf_strips(w, o, at);
}

void plt_walk_blocks_begin(plt_walker *w) {
    plt_block_walker *b = &w->blocks;
    plt_block_entry *root = &b->stack[0];
    plt_lattice_spread(&b->tree.box, root->lo, root->hi);
    root->child.link = b->tree.root;
    root->child.what = PLT_SLOT_EDGE;
    root->groups = w->packet.active;
    w->waiting = w->packet.active != 0 && b->tree.root != PLT_MISS;
    b->in_hand = NULL;
}

static plt_mask meet(const plt_walker *w, const plt_block_entry *e, plt_mask groups) {
    float lo[4], hi[4];
    f4_store(lo, plt_block_planes(&w->blocks, f4_load(e->lo)));
    f4_store(hi, plt_block_planes(&w->blocks, f4_load(e->hi)));
    return plt_box_groups(&w->packet, lo, hi, groups);
}

/* What slot `slot` of the block in hand leads to. */
static inline plt_block_child child_of(const plt_opened_block *o, uint32_t slot) {
    const plt_block *b = &o->block;
    const uint32_t word = slot >> 5, bit = 1u << (slot & 31), below = bit - 1u;
    const uint32_t inner = b->mask[PLT_SLOT_INNER][word], edge = b->mask[PLT_SLOT_EDGE][word];
    const uint32_t inners = b->before[PLT_SLOT_INNER][word] + plt_count_bits(inner & below);
    plt_block_child child = {o->link, PLT_SLOT_INNER | (inners + 1) << 8};
    if (inner & bit) {
        return child;
    }
    const uint32_t edges = b->before[PLT_SLOT_EDGE][word] + plt_count_bits(edge & below);
    if (edge & bit) {
        child.link = plt_block_edge(b, edges);
        child.what = PLT_SLOT_EDGE;
        return child;
    }
    const uint32_t pair = b->pair[word];
    const uint32_t pairs = b->pairs_before[word] + plt_count_bits(pair & below);
    child.what = PLT_SLOT_LEAF | (slot - inners - edges) << 8 | pairs << 16 |
                 (uint32_t)((pair & bit) != 0) << 24;
    return child;
}

/* Asks for the blocks behind node `node` before it is known whether they are met. */
static inline void ask_for_edges(const plt_block_tree *tree, const plt_block *b, uint32_t node) {
    const uint32_t word = node >> 4, shift = node << 1 & 31, edge = b->mask[PLT_SLOT_EDGE][word];
    if ((edge >> shift & 3u) == 0) {
        return;
    }
    const uint32_t edges =
        b->before[PLT_SLOT_EDGE][word] + plt_count_bits(edge & plt_low_bits(shift));
    for (uint32_t i = 0; i < plt_count_bits(edge >> shift & 3u); i++) {
        plt_prefetch(tree->bytes + plt_block_address(plt_block_edge(b, edges + i)));
    }
}

static inline uint32_t kind_of(const plt_block_entry *e) {
    return e->child.what & 0xFFu;
}

static inline uint32_t number_of(const plt_block_entry *e) {
    return e->child.what >> 8 & 0xFFu;
}

/* Goes into the block behind an edge. The frame of a tree that was packed is no larger
 * than the box that led here; a larger one costs tests, never hits. */
static void enter(plt_walker *w, plt_block_entry *at) {
    const plt_opened_block *o = take_block(w, at->child.link);
    at->child.what = PLT_SLOT_INNER; /* node 0 */
    f4_store(at->lo, f4_load(o->lo));
    f4_store(at->hi, f4_load(o->hi));
}

/* The same when the box that led here has just been tested. Of many groups the frame
 * rarely turns any away; of one it does often enough to be asked. 0: it has. */
static inline int enter_tested(plt_walker *w, plt_block_entry *at) {
    enter(w, at);
    if ((at->groups & (at->groups - 1)) == 0) {
        at->groups = meet(w, at, at->groups);
    }
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
    const f4 old_lo = f4_load(at->lo), old_hi = f4_load(at->hi);
    const f4 step = plane_step(f4_sub(old_hi, old_lo));
    const f4 new_lo = f4_add(old_lo, f4_mul(f4_of_bytes(plane), step));
    const f4 new_hi = f4_sub(old_hi, f4_mul(f4_of_bytes(plane + 3), step));
    const m4 right_lo = m4_bits(owners & 7u), right_hi = m4_bits(owners >> 3);
    lo[0] = f4_select(right_lo, old_lo, new_lo);
    lo[1] = f4_select(right_lo, new_lo, old_lo);
    hi[0] = f4_select(right_hi, old_hi, new_hi);
    hi[1] = f4_select(right_hi, new_hi, old_hi);
}

static inline void set_entry(plt_block_entry *to, f4 lo, f4 hi, plt_block_child child,
                             plt_mask groups) {
    f4_store(to->lo, lo);
    f4_store(to->hi, hi);
    to->child = child;
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
    const uint32_t node = number_of(at);
    const plt_opened_block *o = take_block(w, at->child.link);
    ask_for_edges(&b->tree, &o->block, node);
    decode(&o->block, at, lo, hi);
    for (int c = 0; c < 2; c++) {
        f4_store(plane_lo[c], plt_block_planes(b, lo[c]));
        f4_store(plane_hi[c], plt_block_planes(b, hi[c]));
    }
    plt_box_pair(&w->packet, los, his, at->groups, hit);
    w->stats.node_visits++;
    w->stats.group_tests += 2 * plt_mask_count(at->groups);
    uint32_t near = (uint32_t)plt_walk_nearer(&w->packet, los, his);
    near ^= (uint32_t)(hit[near] == 0);
    if (hit[0] != 0 && hit[1] != 0) {
        const uint32_t far = near ^ 1;
        set_entry(&b->stack[w->waiting++], lo[far], hi[far], child_of(o, 2 * node + far), hit[far]);
    }
    set_entry(at, lo[near], hi[near], child_of(o, 2 * node + near), hit[near]);
    return hit[near] != 0;
}

/* From an entry down to a unit that is met, or to nothing. Returns the visits. */
static uint32_t descend(plt_walker *w, plt_block_entry *at) {
    for (uint32_t visits = 0;; visits++) {
        if (kind_of(at) == PLT_SLOT_LEAF) {
            test_unit(w, at);
            return visits;
        }
        if (kind_of(at) == PLT_SLOT_EDGE && !enter_tested(w, at)) {
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
        if (at.groups != 0 && kind_of(&at) == PLT_SLOT_EDGE) {
            enter(w, &at);
        }
        at.groups = meet(w, &at, at.groups);
        const uint32_t used = at.groups == 0 ? 1 : 1 + descend(w, &at);
        visits -= used < visits ? used : visits;
        if (w->packet.active == 0) {
            w->waiting = 0;
        }
    }
    return visits;
}
