/* validate_block - see validate_block.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/compact/validate_block.h"

/* Node i + 1 needs a parent among nodes 0 .. i. */
static int kinds_form_a_tree(const plt_block *b) {
    uint32_t inner = 0;
    for (uint32_t i = 0; i < b->nodes; i++) {
        inner += plt_block_kind(b, 2 * i) == PLT_SLOT_INNER;
        inner += plt_block_kind(b, 2 * i + 1) == PLT_SLOT_INNER;
        if (i + 1 < b->nodes && inner < i + 1) {
            return 0;
        }
    }
    return inner == b->nodes - 1;
}

static int bounds_are_inside(const plt_lattice_box *f, const plt_lattice_box *scene) {
    int inside = 1;
    for (int a = 0; a < 3; a++) {
        inside &= f->lo[a] >= scene->lo[a] && f->lo[a] <= f->hi[a] && f->hi[a] <= scene->hi[a];
    }
    return inside;
}

static int check_is_right(const unsigned char *part, uint32_t bytes, uint32_t check_at,
                          uint32_t salt) {
    return plt_get_u32(part + check_at - 2) >> 16 ==
           (plt_block_check(part, bytes, check_at) ^ salt);
}

/* Each string begins where the one before ends; all must end inside the part, in front of the check
 * of ids. Counts are bounded first, so that no position overflows. */
static int geometry_fits(const plt_geometry *g, const plt_block *b, const plt_block_tree *tree) {
    const uint64_t bits = 8ull * (b->geometry_bytes - tree->ids_check_bytes);
    if (g->triangles > PLT_BLOCK_TRIANGLES_MOST || g->swaps > bits || g->news > bits ||
        g->refs > bits || g->slots < g->vertices || g->news_ones != g->vertices) {
        return 0;
    }
    return g->positions + (uint64_t)g->vertices * g->vertex_bits +
               plt_turn_bits(tree) * g->triangles <=
           bits;
}

static int references_are_known(const plt_geometry *g) {
    uint32_t rank = 0;
    for (uint32_t slot = 0; slot < g->slots; slot++) {
        if (plt_bits_get(g->bytes, g->news + slot, 1)) {
            rank++;
        } else if (plt_bits_get(g->bytes, g->refs + (slot - rank) * g->ref_bits, g->ref_bits) >=
                   rank) {
            return 0;
        }
    }
    return 1;
}

static int vertices_are_inside(const plt_geometry *g, const plt_lattice_box *bounds) {
    int inside = 1;
    for (uint32_t v = 0; v < g->vertices; v++) {
        uint32_t position[3];
        plt_leaf_vertex(g, v, position);
        for (int a = 0; a < 3; a++) {
            inside &= position[a] <= bounds->hi[a];
            inside &= !PLT_WITH_BLOCK_MOTION || position[a] >= bounds->lo[a]; /* else it is added */
        }
    }
    return inside;
}

/* Leaves follow each other without gaps and each begins a strip. */
static int leaves_are_valid(const plt_geometry *g, const plt_block *b) {
    uint32_t leaf = 0, pairs = 0, triangle = 0;
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) != PLT_SLOT_LEAF) {
            continue;
        }
        const int pair = (int)(b->pair[slot >> 5] >> (slot & 31) & 1u);
        if (triangle >= g->triangles || !plt_bits_get(g->bytes, g->starts + triangle, 1)) {
            return 0;
        }
        uint32_t count;
        plt_leaf_find(g, leaf, pairs, pair, &count);
        triangle += count;
        leaf++;
        pairs += (uint32_t)pair;
    }
    return triangle == g->triangles;
}

/* Float geometry has nothing but counts here. */
static int counts_rule(const plt_block *b, uint32_t k) {
    plt_geometry g;
    plt_geometry_open_counts(&g, b, k);
    return g.starts <= 8 * b->geometry_bytes ? PLT_BLOCK_VALID : PLT_I14_GEOMETRY;
}

/* Of a part whose check is right. */
static int strings_rule(const plt_block *b, const plt_lattice_box *bounds,
                        const plt_block_tree *tree) {
    plt_geometry g;
    plt_lattice_box frame = *bounds;
    plt_block_tree_frame(tree, &frame);
    plt_geometry_open(&g, b, &frame, tree->leaf_triangles);
    if (!geometry_fits(&g, b, tree)) {
        return PLT_I14_GEOMETRY;
    }
    if (!leaves_are_valid(&g, b)) {
        return PLT_I15_LEAVES;
    }
    if (!references_are_known(&g)) {
        return PLT_I16_REFERENCES;
    }
    return vertices_are_inside(&g, bounds) ? PLT_BLOCK_VALID : PLT_I21_VERTICES;
}

int plt_block_validate_geometry(const plt_block *b, const plt_block_tree *tree) {
    plt_lattice_box bounds;
    if (b->geometry_bytes > 0 &&
        !check_is_right(b->geometry, b->geometry_bytes, 6, plt_block_tree_salt(tree))) {
        return PLT_I13_CHECK;
    }
    if (b->leaves == 0) {
        return b->geometry_bytes == 0 ? PLT_BLOCK_VALID : PLT_I14_GEOMETRY;
    }
    if (b->geometry_bytes < PLT_GEOMETRY_HEADER_BYTES) {
        return PLT_I14_GEOMETRY;
    }
    if (tree->leaf_kind == PLT_LEAF_RECORDS) {
        return counts_rule(b, tree->leaf_triangles);
    }
    plt_block_bounds(b, tree->lattice.bits, &bounds);
    return strings_rule(b, &bounds, tree);
}

int plt_block_validate_nodes(plt_block *b, const unsigned char *bytes, uint32_t there,
                             uint32_t limit, const plt_block_tree *tree) {
    plt_lattice_box bounds;
    const uint32_t bits = tree->lattice.bits;
    if (there < PLT_BLOCK_HEADER_BYTES ||
        there < plt_block_parts_bytes((plt_get_u32(bytes) & 63) + 1, 0, bits)) {
        return PLT_I10_SIZES;
    }
    plt_block_open(b, bytes, bits);
    if (b->node_bytes > there || there > limit || b->geometry_bytes > limit - b->node_bytes) {
        return PLT_I10_SIZES;
    }
    if (!kinds_form_a_tree(b)) {
        return PLT_I11_KINDS;
    }
    plt_block_bounds(b, bits, &bounds);
    if (!bounds_are_inside(&bounds, &tree->box)) {
        return PLT_I12_BOUNDS;
    }
    return check_is_right(bytes, b->node_bytes, 2, plt_block_tree_salt(tree)) ? PLT_BLOCK_VALID
                                                                              : PLT_I13_CHECK;
}

int plt_block_validate(const unsigned char *bytes, uint32_t limit, const plt_block_tree *tree) {
    plt_block b;
    const int rule = plt_block_validate_nodes(&b, bytes, limit, limit, tree);
    return rule == PLT_BLOCK_VALID ? plt_block_validate_geometry(&b, tree) : rule;
}

uint32_t plt_block_depths(const plt_block *b, uint16_t depth[PLT_BLOCK_NODES_MOST]) {
    uint32_t deepest = 1;
    depth[0] = 1;
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) == PLT_SLOT_INNER) {
            const uint32_t node = 1 + plt_block_rank(b, PLT_SLOT_INNER, slot);
            depth[node] = (uint16_t)(depth[slot / 2] + 1);
            deepest = depth[node] > deepest ? depth[node] : deepest;
        }
    }
    return deepest;
}

/* A switch: a table of pointers would be data that start-up has to fill in. */
const char *plt_block_rule_message(int rule) {
    switch (rule) {
    case PLT_I10_SIZES:
        return "a block's parts do not fit its sizes";
    case PLT_I11_KINDS:
        return "a block's nodes form no tree";
    case PLT_I12_BOUNDS:
        return "a block's bounds are no box inside the scene's";
    case PLT_I13_CHECK:
        return "a block is damaged (check)";
    case PLT_I14_GEOMETRY:
        return "a block's geometry does not fit its size";
    case PLT_I15_LEAVES:
        return "a leaf does not begin a strip or is too long";
    case PLT_I16_REFERENCES:
        return "a triangle names a vertex before it is there";
    case PLT_I21_VERTICES:
        return "a vertex lies outside its block's bounds";
    case PLT_I17_LINKS:
        return "a link leads back, astray or twice to a block";
    default:
        return "the header's counts are not the blocks'";
    }
}
