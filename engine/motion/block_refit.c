/* block_refit - see block_refit.h
 *
 * Boxes are whole numbers below 2^21 in four lanes of floats, which hold them exactly; quotients
 * are cut off exactly, too: one that is no whole number is farther from the next than rounding
 * goes (1/8225 below 256, 1/255 below 8225).
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/block_refit.h"

#include <string.h>

#include "engine/base/small_stack.h"
#include "engine/lanes/lanes.h"
#include "engine/tree/compact/turns.h"

typedef struct slot_box {
    f4 lo, hi;
} slot_box;

/* What of a block is in hand. */
typedef struct refitting {
    const plt_block_tree *tree;
    plt_slot_boxes *boxes;
    unsigned char *ids; /* NULL: there are none */
    plt_block block;
    plt_geometry geometry;
    unsigned char *geometry_bytes;
} refitting;

static inline slot_box box_at(const plt_slot_boxes *boxes, uint32_t slot) {
    const slot_box b = {f4_load(boxes->lo[slot]), f4_load(boxes->hi[slot])};
    return b;
}

static inline void put_box(plt_slot_boxes *boxes, uint32_t slot, slot_box b) {
    f4_store(boxes->lo[slot], b.lo);
    f4_store(boxes->hi[slot], b.hi);
}

static inline slot_box joined(slot_box a, slot_box b) {
    const slot_box both = {f4_min(a.lo, b.lo), f4_max(a.hi, b.hi)};
    return both;
}

/* ---- positions -------------------------------------------------------------------- */

/* Bits that go one behind the other into bytes, from a bit on, with what is in front of it. */
typedef struct bit_writer {
    unsigned char *at;
    uint64_t pending;
    uint32_t bits; /* of them, below 32 */
} bit_writer;

static inline bit_writer writer_at(unsigned char *bytes, uint32_t at) {
    bit_writer w = {bytes + (at >> 3), 0, at & 7};
    w.pending = *w.at & plt_low_bits(w.bits);
    return w;
}

static inline void write_bits(bit_writer *w, uint32_t value, uint32_t bits) {
    w->pending |= (uint64_t)value << w->bits;
    w->bits += bits;
    if (w->bits >= 32) {
        plt_put_u32(w->at, (uint32_t)w->pending);
        w->at += 4;
        w->pending >>= 32;
        w->bits -= 32;
    }
}

/* What follows in the last byte stays. */
static void finish_bits(bit_writer *w) {
    for (; w->bits >= 8; w->bits -= 8, w->pending >>= 8) {
        *w->at++ = (unsigned char)w->pending;
    }
    if (w->bits > 0) {
        *w->at = (unsigned char)(w->pending | (*w->at & ~plt_low_bits(w->bits)));
    }
}

/* Those of the block, whose first has number `first` among those of all blocks. */
PLT_APART_ON_SMALL_STACKS static void put_positions(const refitting *r, const plt_block_numbers *n,
                                                    uint32_t first) {
    const plt_geometry *g = &r->geometry;
    const uint32_t bits = r->tree->lattice.bits, width = n->index_bits;
    bit_writer w = writer_at(r->geometry_bytes, g->positions);
    const uint64_t begin = (uint64_t)first * width;
    const unsigned char *number = n->number + (size_t)(begin >> 3);
    uint32_t at = (uint32_t)(begin & 7);
    for (uint32_t v = 0; v < g->vertices; v++, at += width) {
        const uint32_t *word = n->vertex[plt_bits_get(number, at, width)].word;
        write_bits(&w, word[0], bits);
        write_bits(&w, word[1], bits);
        write_bits(&w, word[2], bits);
    }
    finish_bits(&w);
}

/* ---- leaves ----------------------------------------------------------------------- */

static slot_box box_of_leaf(const plt_leaf *leaf) {
    f4 lo = f4_of_u4(u4_load(leaf->vertex[0].number)), hi = lo;
    for (uint32_t i = 1; i < leaf->vertices; i++) {
        const f4 p = f4_of_u4(u4_load(leaf->vertex[i].number));
        lo = f4_min(lo, p);
        hi = f4_max(hi, p);
    }
    const slot_box box = {lo, hi};
    return box;
}

/* The next leaf, which begins at `at`; that goes on behind it. */
PLT_APART_ON_SMALL_STACKS static slot_box fit_leaf(const refitting *r, plt_leaf_place *at,
                                                   uint32_t leaf_number, int pair) {
    plt_leaf leaf;
    plt_leaf_read_next(&r->geometry, at, leaf_number, pair, &leaf);
    if (r->ids != NULL) {
        plt_leaf_turn(&r->geometry, at, &leaf, r->ids, r->tree->ids.bits);
    }
    plt_leaf_pass(&r->geometry, at, &leaf);
    return box_of_leaf(&leaf);
}

/* ---- nodes ------------------------------------------------------------------------ */

PLT_APART_ON_SMALL_STACKS static slot_box box_of_edge(const refitting *r, uint32_t slot) {
    const plt_block *b = &r->block;
    const uint32_t link = plt_block_edge(b, plt_block_rank(b, PLT_SLOT_EDGE, slot));
    plt_lattice_box bounds;
    float lo[4], hi[4];
    plt_block_bounds_at(r->tree->bytes + plt_block_address(link), r->tree->lattice.bits, &bounds);
    plt_lattice_spread(&bounds, lo, hi);
    const slot_box box = {f4_load(lo), f4_load(hi)};
    return box;
}

/* Boxes of leaves and edges, and who leads to whom. */
PLT_APART_ON_SMALL_STACKS static void fit_slots(refitting *r) {
    const plt_block *b = &r->block;
    plt_leaf_place at = {0, 0, 0, 0};
    uint32_t leaf = 0, inner = 0;
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        switch (plt_block_kind(b, slot)) {
        case PLT_SLOT_INNER:
            r->boxes->slot_of[++inner] = (uint8_t)slot;
            break;
        case PLT_SLOT_EDGE:
            put_box(r->boxes, slot, box_of_edge(r, slot));
            break;
        default:
            put_box(r->boxes, slot,
                    fit_leaf(r, &at, leaf++, (int)(b->pair[slot >> 5] >> (slot & 31) & 1u)));
            break;
        }
    }
}

/* Children come behind their parents. The box of the root. */
PLT_APART_ON_SMALL_STACKS static slot_box join_nodes(refitting *r) {
    plt_slot_boxes *boxes = r->boxes;
    for (uint32_t node = r->block.nodes; --node > 0;) {
        put_box(boxes, boxes->slot_of[node],
                joined(box_at(boxes, 2 * node), box_at(boxes, 2 * node + 1)));
    }
    return joined(box_at(boxes, 0), box_at(boxes, 1));
}

PLT_APART_ON_SMALL_STACKS static void put_bounds(unsigned char *bytes, uint32_t bits,
                                                 const plt_lattice_box *bounds) {
    const uint32_t width = plt_block_bounds_width(bits);
    unsigned char *at = bytes + PLT_BLOCK_HEADER_BYTES;
    memset(at, 0, plt_block_bounds_bytes(bits));
    for (uint32_t a = 0; a < 3; a++) {
        plt_bits_put(at, a * width, width, bounds->lo[a]);
        plt_bits_put(at, (a + 3) * width, width, bounds->hi[a]);
    }
}

/* Widths of planes' steps (plt_block_step). */
static inline f4 steps_of(slot_box b) {
    const f4 extent = f4_add(f4_sub(b.hi, b.lo), f4_all(254.0f));
    return f4_max(f4_of_u4(u4_of_f4(f4_div(extent, f4_all(255.0f)))), f4_all(1.0f));
}

static inline f4 whole_steps(f4 distance, f4 step) {
    return f4_of_u4(u4_of_f4(f4_div(distance, step)));
}

/* The planes of a node whose box is decoded as `parent`, six bytes at `plane`; both children's
 * boxes become what they are decoded as. Its owners, without that of x min, which is the right
 * child's always. */
static uint32_t fit_node(unsigned char *plane, slot_box parent, slot_box child[2]) {
    const f4 step = steps_of(parent);
    const m4 right_lo = m4_or(f4_lt(child[0].lo, child[1].lo), m4_bits(1));
    const m4 right_hi = f4_lt(child[1].hi, child[0].hi);
    const f4 q_lo =
        whole_steps(f4_sub(f4_select(right_lo, child[1].lo, child[0].lo), parent.lo), step);
    const f4 q_hi =
        whole_steps(f4_sub(parent.hi, f4_select(right_hi, child[1].hi, child[0].hi)), step);
    const f4 lo = f4_add(parent.lo, f4_mul(q_lo, step));
    const f4 hi = f4_sub(parent.hi, f4_mul(q_hi, step));
    uint32_t low[4], high[4];
    u4_store(low, u4_of_f4(q_lo));
    u4_store(high, u4_of_f4(q_hi));
    for (int a = 0; a < 3; a++) {
        plane[a] = (unsigned char)low[a];
        plane[3 + a] = (unsigned char)high[a];
    }
    child[0].lo = f4_select(right_lo, parent.lo, lo);
    child[1].lo = f4_select(right_lo, lo, parent.lo);
    child[0].hi = f4_select(right_hi, parent.hi, hi);
    child[1].hi = f4_select(right_hi, hi, parent.hi);
    return (m4_mask(right_lo) >> 1 & 3u) | (m4_mask(right_hi) & 7u) << 2;
}

/* From the root down: exact boxes of children become those that a traversal decodes. */
PLT_APART_ON_SMALL_STACKS static void fit_nodes(refitting *r, unsigned char *bytes, slot_box root) {
    const plt_block *b = &r->block;
    plt_slot_boxes *boxes = r->boxes;
    unsigned char *planes = bytes + (b->planes - b->bytes);
    unsigned char *owners = bytes + (b->owners - b->bytes);
    bit_writer w = writer_at(owners, 0);
    for (uint32_t node = 0; node < b->nodes; node++) {
        slot_box child[2] = {box_at(boxes, 2 * node), box_at(boxes, 2 * node + 1)};
        const slot_box parent = node == 0 ? root : box_at(boxes, boxes->slot_of[node]);
        write_bits(&w, fit_node(planes + 6 * node, parent, child), 5);
        put_box(boxes, 2 * node, child[0]);
        put_box(boxes, 2 * node + 1, child[1]);
    }
    finish_bits(&w);
}

/* ---- blocks ----------------------------------------------------------------------- */

static void numbers_of(slot_box b, plt_lattice_box *to) {
    uint32_t lo[4], hi[4];
    u4_store(lo, u4_of_f4(b.lo));
    u4_store(hi, u4_of_f4(b.hi));
    for (int a = 0; a < 3; a++) {
        to->lo[a] = lo[a];
        to->hi[a] = hi[a];
    }
}

static void open_geometry(refitting *r, unsigned char *bytes) {
    plt_lattice_box frame = {{0}, {0}};
    plt_block_tree_frame(r->tree, &frame);
    plt_geometry_open(&r->geometry, &r->block, &frame, r->tree->leaf_triangles);
    r->geometry_bytes = bytes + r->block.node_bytes;
}

void plt_block_refit_all(const plt_block_refit *job, plt_block_tree *tree, unsigned char *blocks,
                         unsigned char *ids, const plt_block_numbers *numbers) {
    refitting r = {.tree = tree, .boxes = job->boxes, .ids = ids};
    uint32_t first = job->vertices;
    for (uint32_t i = job->blocks; i-- > 0;) {
        unsigned char *bytes = blocks + job->address[i];
        plt_lattice_box bounds;
        plt_block_open(&r.block, bytes, tree->lattice.bits);
        if (r.block.leaves > 0) {
            open_geometry(&r, bytes);
            first -= r.geometry.vertices;
            put_positions(&r, numbers, first);
        }
        fit_slots(&r);
        const slot_box root = join_nodes(&r);
        numbers_of(root, &bounds);
        put_bounds(bytes, tree->lattice.bits, &bounds);
        fit_nodes(&r, bytes, root);
        tree->box = bounds;
    }
}

void plt_block_refit_open(plt_block_refit *r, void *room, const plt_block_tree *tree) {
    plt_block b;
    plt_geometry g;
    r->boxes = room;
    r->address = (uint32_t *)(void *)(r->boxes + 1);
    r->blocks = r->vertices = 0;
    for (uint32_t at = 0; at < tree->used; at += plt_block_bytes(&b)) {
        r->address[r->blocks++] = at;
        plt_block_open(&b, tree->bytes + at, tree->lattice.bits);
        if (b.leaves > 0) {
            plt_geometry_open_counts(&g, &b, tree->leaf_triangles);
            r->vertices += g.vertices;
        }
    }
}
