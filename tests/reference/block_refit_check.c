/* block_refit_check - see block_refit_check.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/block_refit_check.h"

#include <string.h>

#include "tests/reference/shapes.h"

typedef struct checking {
    const plt_block_tree *tree;
    const mesh *m;
    block_refit_facts facts;
} checking;

typedef struct checked_block {
    plt_block b;
    plt_geometry g;
    plt_lattice_box exact[2 * PLT_BLOCK_NODES_MOST]; /* of each slot */
} checked_block;

static void broken(checking *c, const char *sentence) {
    c->facts.sentence = c->facts.broken++ == 0 ? sentence : c->facts.sentence;
}

static plt_lattice_box empty(void) {
    const plt_lattice_box b = {{UINT32_MAX, UINT32_MAX, UINT32_MAX}, {0, 0, 0}};
    return b;
}

static void add(plt_lattice_box *to, const uint32_t lo[3], const uint32_t hi[3]) {
    for (int a = 0; a < 3; a++) {
        to->lo[a] = lo[a] < to->lo[a] ? lo[a] : to->lo[a];
        to->hi[a] = hi[a] > to->hi[a] ? hi[a] : to->hi[a];
    }
}

/* The mesh's corner, as bits. */
static int is_corner(const checking *c, uint32_t triangle, unsigned corner, const uint32_t q[3]) {
    const float *due = shape_corner(c->m, triangle, corner);
    float is[3];
    for (int a = 0; a < 3; a++) {
        is[a] = plt_lattice_float(&c->tree->lattice, a, q[a]);
    }
    return memcmp(is, due, sizeof is) == 0;
}

/* Triangle `i` of a leaf is where the mesh has that of its id, rotated as it says. */
static void check_triangle(checking *c, const plt_leaf *leaf, uint32_t i, uint32_t index) {
    const uint32_t word = plt_primitive_word_find(&c->tree->ids, index);
    const uint32_t *q[3];
    unsigned first = 0;
    for (unsigned k = 0; k < 3; k++) {
        q[k] = leaf->vertex[plt_leaf_corner(leaf, i, k)].number;
        first = plt_lattice_key(q[k]) < plt_lattice_key(q[first]) ? k : first;
    }
    if (plt_primitive_id(word) >= c->m->triangles || plt_primitive_rotation(word) > 2) {
        broken(c, "an id that is not there");
        return;
    }
    for (unsigned j = 0; j < 3; j++) { /* mesh corner j is canonical corner (rotation + j) % 3 */
        if (!is_corner(c, plt_primitive_id(word), j,
                       q[(first + plt_primitive_rotation(word) + j) % 3])) {
            broken(c, "a triangle is not where its frame says");
            return;
        }
    }
}

static plt_lattice_box check_leaf(checking *c, checked_block *at, uint32_t slot) {
    plt_lattice_box box = empty();
    plt_leaf leaf;
    uint32_t pairs = 0, leaves = 0, count = 0;
    for (uint32_t s = 0; s < slot; s++) {
        leaves += plt_block_kind(&at->b, s) == PLT_SLOT_LEAF;
        pairs += at->b.pair[s >> 5] >> (s & 31) & 1u;
    }
    const int pair = (int)(at->b.pair[slot >> 5] >> (slot & 31) & 1u);
    const uint32_t first = plt_leaf_find(&at->g, leaves, pairs, pair, &count);
    plt_leaf_read(&at->g, first, count, &leaf);
    for (uint32_t i = 0; i < count; i++) {
        if (c->tree->ids.bytes != NULL) {
            check_triangle(c, &leaf, i, at->g.first_triangle + first + i);
        }
        for (unsigned k = 0; k < 3; k++) {
            const uint32_t *q = leaf.vertex[plt_leaf_corner(&leaf, i, k)].number;
            add(&box, q, q);
        }
    }
    c->facts.triangles += count;
    return box;
}

static plt_lattice_box check_block(checking *c, uint32_t address);

static plt_lattice_box exact_of(checking *c, checked_block *at, uint32_t node) {
    plt_lattice_box box = empty();
    for (uint32_t slot = 2 * node; slot < 2 * node + 2; slot++) {
        plt_lattice_box *to = &at->exact[slot];
        switch (plt_block_kind(&at->b, slot)) {
        case PLT_SLOT_INNER:
            *to = exact_of(c, at, 1 + plt_block_rank(&at->b, PLT_SLOT_INNER, slot));
            break;
        case PLT_SLOT_EDGE:
            *to = check_block(c, plt_block_address(plt_block_edge(
                                     &at->b, plt_block_rank(&at->b, PLT_SLOT_EDGE, slot))));
            break;
        default:
            *to = check_leaf(c, at, slot);
        }
        add(&box, to->lo, to->hi);
    }
    return box;
}

static int contains(const plt_lattice_box *around, const plt_lattice_box *b) {
    int good = 1;
    for (int a = 0; a < 3; a++) {
        good &= around->lo[a] <= b->lo[a] && around->hi[a] >= b->hi[a];
    }
    return good;
}

/* What planes and owners of a node shall be. */
static void check_code(checking *c, const plt_lattice_box *box, const plt_lattice_box exact[2],
                       const unsigned char *plane, uint32_t owners) {
    for (uint32_t a = 0; a < 3; a++) {
        const uint32_t e = box->hi[a] - box->lo[a], step = e <= 255 ? 1 : (e + 254) / 255;
        const uint32_t right_lo = a == 0 || exact[1].lo[a] > exact[0].lo[a];
        const uint32_t right_hi = exact[1].hi[a] < exact[0].hi[a];
        if (plane[a] != (exact[right_lo].lo[a] - box->lo[a]) / step ||
            plane[3 + a] != (box->hi[a] - exact[right_hi].hi[a]) / step) {
            broken(c, "a plane is not the tightest");
        }
        if ((owners >> a & 1u) != right_lo || (owners >> (3 + a) & 1u) != right_hi) {
            broken(c, "an owner is the other child");
        }
        c->facts.loose += a == 0 && exact[0].lo[0] > exact[1].lo[0];
    }
}

static void check_node(checking *c, const checked_block *at, uint32_t node, plt_lattice_box box) {
    const unsigned char *plane = at->b.planes + 6 * (size_t)node;
    const uint32_t owners = plt_bits_get(at->b.owners, 5 * node, 5) << 1 | 1u;
    plt_lattice_box child[2];
    check_code(c, &box, &at->exact[2 * node], plane, owners);
    plt_block_apply(&box, plane, owners, child);
    for (uint32_t k = 0; k < 2; k++) {
        const uint32_t slot = 2 * node + k;
        if (!contains(&child[k], &at->exact[slot])) {
            broken(c, "a box does not contain what is below it");
        }
        if (plt_block_kind(&at->b, slot) == PLT_SLOT_INNER) {
            check_node(c, at, 1 + plt_block_rank(&at->b, PLT_SLOT_INNER, slot), child[k]);
        }
    }
    c->facts.nodes++;
}

static plt_lattice_box check_block(checking *c, uint32_t address) {
    checked_block at;
    plt_lattice_box bounds, frame = {{0}, {0}};
    plt_block_open(&at.b, c->tree->bytes + address, c->tree->lattice.bits);
    plt_block_bounds(&at.b, c->tree->lattice.bits, &bounds);
    if (at.b.leaves > 0) {
        plt_block_tree_frame(c->tree, &frame);
        plt_geometry_open(&at.g, &at.b, &frame, c->tree->leaf_triangles);
    }
    const plt_lattice_box exact = exact_of(c, &at, 0);
    if (memcmp(&exact, &bounds, sizeof exact) != 0) {
        broken(c, "bounds are not the exact box");
    }
    check_node(c, &at, 0, bounds);
    c->facts.blocks++;
    return exact;
}

block_refit_facts block_refit_check(const plt_block_tree *tree, const mesh *m) {
    checking c = {.tree = tree, .m = m, .facts = {.sentence = "all is well"}};
    const plt_lattice_box box = check_block(&c, plt_block_address(tree->root));
    if (memcmp(&box, &tree->box, sizeof box) != 0) {
        broken(&c, "the scene's box is not the root's");
    }
    return c.facts;
}
