/* block_survey - see block_survey.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/block_survey.h"

#include "engine/image/fault.h"

enum rule {
    SOUND = 0,
    RULE_SIZES = 10,      /* the parts fit the block's sizes and the section */
    RULE_KINDS = 11,      /* n - 1 inner children, in breadth-first order */
    RULE_FRAME = 12,      /* the frame is a box inside the scene's */
    RULE_CHECK = 13,      /* both parts' checks are right */
    RULE_GEOMETRY = 14,   /* counts, strips and vertices fit the geometry part */
    RULE_UNITS = 15,      /* every unit begins a strip and has at most 2 K triangles */
    RULE_REFERENCES = 16, /* references name vertices already met */
    RULE_LINKS = 17,      /* links lead forward, to each block once */
    RULE_COUNTS = 18,     /* the header's counts are the blocks' */
    RULE_VERTICES = 21    /* vertices lie inside the frame */
};

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

static int frame_is_inside(const plt_lattice_box *f, const plt_lattice_box *scene) {
    int inside = 1;
    for (int a = 0; a < 3; a++) {
        inside &= f->lo[a] >= scene->lo[a] && f->lo[a] <= f->hi[a] && f->hi[a] <= scene->hi[a];
    }
    return inside;
}

static int checks_are_right(const plt_block *b) {
    if (plt_get_u32(b->bytes) >> 16 != plt_block_check(b->bytes, b->node_bytes, 2)) {
        return 0;
    }
    return b->geometry_bytes == 0 ||
           plt_get_u32(b->geometry + 4) >> 16 == plt_block_check(b->geometry, b->geometry_bytes, 6);
}

/* Each string begins where the one before ends; all must end inside the part. Counts are bounded
 * first, so that no position overflows. */
static int geometry_fits(const plt_geometry *g, const plt_block *b) {
    const uint64_t bits = 8ull * b->geometry_bytes;
    if (g->triangles > PLT_BLOCK_TRIANGLES_MOST || g->turns > bits || g->news > bits ||
        g->refs > bits || g->slots < g->vertices || g->news_ones != g->vertices) {
        return 0;
    }
    return g->positions + (uint64_t)g->vertices * g->vertex_bits <= bits;
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

static int vertices_are_inside(const plt_geometry *g, const plt_lattice_box *frame) {
    int inside = 1;
    for (uint32_t v = 0; v < g->vertices; v++) {
        uint32_t position[3];
        plt_unit_vertex(g, v, position);
        for (int a = 0; a < 3; a++) {
            inside &= position[a] <= frame->hi[a]; /* never below: it is added to lo */
        }
    }
    return inside;
}

/* Units follow each other without gaps and each begins a strip. */
static int units_are_sound(const plt_geometry *g, const plt_block *b) {
    uint32_t unit = 0, pairs = 0, triangle = 0;
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) != PLT_SLOT_UNIT) {
            continue;
        }
        const int pair = (int)(b->pair[slot >> 5] >> (slot & 31) & 1u);
        if (triangle >= g->triangles || !plt_bits_get(g->bytes, g->starts + triangle, 1)) {
            return 0;
        }
        uint32_t count;
        plt_unit_find(g, unit, pairs, pair, &count);
        triangle += count;
        unit++;
        pairs += (uint32_t)pair;
    }
    return triangle == g->triangles;
}

/* Float geometry has nothing but counts here. */
static int counts_rule(const plt_block *b, uint32_t k) {
    plt_geometry g;
    plt_geometry_open_counts(&g, b, k);
    return g.starts <= 8 * b->geometry_bytes ? SOUND : RULE_GEOMETRY;
}

static int geometry_rule(const plt_block *b, const plt_lattice_box *frame, uint32_t k, int floats) {
    plt_geometry g;
    if (b->units == 0) {
        return b->geometry_bytes == 0 ? SOUND : RULE_GEOMETRY;
    }
    if (b->geometry_bytes < PLT_GEOMETRY_HEADER_BYTES) {
        return RULE_GEOMETRY;
    }
    if (floats) {
        return counts_rule(b, k);
    }
    plt_geometry_open(&g, b, frame, k);
    if (!geometry_fits(&g, b)) {
        return RULE_GEOMETRY;
    }
    if (!units_are_sound(&g, b)) {
        return RULE_UNITS;
    }
    if (!references_are_known(&g)) {
        return RULE_REFERENCES;
    }
    return vertices_are_inside(&g, frame) ? SOUND : RULE_VERTICES;
}

int plt_block_is_sound(const unsigned char *bytes, uint32_t limit, const plt_block_tree *tree) {
    plt_block b;
    plt_lattice_box frame;
    const uint32_t bits = tree->lattice.bits;
    if (limit < PLT_BLOCK_HEADER_BYTES ||
        limit < plt_block_parts_bytes((plt_get_u32(bytes) & 63) + 1, 0, bits)) {
        return RULE_SIZES;
    }
    plt_block_open(&b, bytes, bits);
    if (b.node_bytes > limit || b.geometry_bytes > limit - b.node_bytes) {
        return RULE_SIZES;
    }
    if (!kinds_form_a_tree(&b)) {
        return RULE_KINDS;
    }
    plt_block_frame(&b, bits, &frame);
    if (!frame_is_inside(&frame, &tree->box)) {
        return RULE_FRAME;
    }
    return checks_are_right(&b)
               ? geometry_rule(&b, &frame, tree->leaf_triangles, tree->records != NULL)
               : RULE_CHECK;
}

/* A switch: a table of pointers would be data that start-up has to fill in. */
static const char *what_is_wrong(int rule) {
    switch (rule) {
    case RULE_SIZES:
        return "a block's parts do not fit its sizes";
    case RULE_KINDS:
        return "a block's nodes form no tree";
    case RULE_FRAME:
        return "a block's frame is no box inside the scene's";
    case RULE_CHECK:
        return "a block is damaged (check)";
    case RULE_GEOMETRY:
        return "a block's geometry does not fit its size";
    case RULE_UNITS:
        return "a unit of triangles does not begin a strip or is too long";
    case RULE_REFERENCES:
        return "a triangle names a vertex before it is there";
    case RULE_VERTICES:
        return "a vertex lies outside its block's frame";
    case RULE_LINKS:
        return "a link leads back, astray or twice to a block";
    default:
        return "the header's counts are not the blocks'";
    }
}

static int broken(plt_fault *fault, int rule, uint32_t address) {
    return plt_broken(fault, (uint8_t)rule, address, what_is_wrong(rule));
}

/* Depth of every node of a block, and the deepest into `info`. */
static void node_depths(const plt_block *b, uint32_t depth, uint16_t *depths, plt_info *info) {
    depths[0] = (uint16_t)(depth + 1);
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) == PLT_SLOT_INNER) {
            depths[1 + plt_block_rank(b, PLT_SLOT_INNER, slot)] = (uint16_t)(depths[slot / 2] + 1);
        }
    }
    for (uint32_t i = 0; i < b->nodes; i++) {
        info->depth_stack_entries =
            depths[i] > info->depth_stack_entries ? depths[i] : info->depth_stack_entries;
    }
}

/* Takes a block that the walk arrives at for the first time into the counts. */
static int arrive(const plt_block_tree *tree, const plt_block_frame_of_survey *f, plt_info *info,
                  plt_fault *fault) {
    const int rule = plt_block_is_sound(tree->bytes + f->address, tree->used - f->address, tree);
    if (rule != SOUND) {
        return broken(fault, rule, f->address);
    }
    plt_block b;
    plt_block_open(&b, tree->bytes + f->address, tree->lattice.bits);
    info->treelets++;
    info->nodes += b.nodes;
    info->intermediate_lists += b.pairs;
    info->leaf_lists += b.units - b.pairs;
    info->node_bytes += b.node_bytes;
    info->triangle_bytes += b.geometry_bytes;
    if (b.units > 0) {
        plt_geometry g;
        plt_geometry_open_counts(&g, &b, tree->leaf_triangles);
        if (g.first_triangle != info->triangles) {
            return broken(fault, RULE_COUNTS, f->address);
        }
        info->triangles += g.triangles;
    }
    return PLT_OK;
}

/* The edge with the lowest address above f->last; its number of nodes above
 * into `depth`. PLT_MISS: none is left. */
static uint32_t next_edge(const plt_block_tree *tree, const plt_block_frame_of_survey *f,
                          uint32_t *depth, plt_info *info) {
    plt_block b;
    uint16_t depths[PLT_BLOCK_NODES_MOST];
    uint32_t best = PLT_MISS;
    plt_block_open(&b, tree->bytes + f->address, tree->lattice.bits);
    node_depths(&b, f->depth, depths, info);
    for (uint32_t slot = 0; slot < 2 * b.nodes; slot++) {
        if (plt_block_kind(&b, slot) != PLT_SLOT_EDGE) {
            continue;
        }
        const uint32_t link = plt_block_edge(&b, plt_block_rank(&b, PLT_SLOT_EDGE, slot));
        const uint32_t address = plt_block_address(link);
        if (address > f->last && (best == PLT_MISS || address < plt_block_address(best))) {
            best = link;
            *depth = depths[slot / 2];
        }
    }
    return best;
}

static int walk(const plt_block_tree *tree, plt_block_frame_of_survey *frames, plt_info *info,
                plt_fault *fault) {
    uint32_t level = 0, expected = 0, edges = 0;
    frames[0].address = frames[0].depth = 0;
    frames[0].node_bytes = plt_block_node_bytes(tree->root);
    for (int first = 1;;) {
        plt_block_frame_of_survey *f = &frames[level];
        if (first) {
            plt_block b;
            const int status = f->address == expected ? arrive(tree, f, info, fault)
                                                      : broken(fault, RULE_LINKS, f->address);
            if (status != PLT_OK) {
                return status;
            }
            plt_block_open(&b, tree->bytes + f->address, tree->lattice.bits);
            if (f->node_bytes != b.node_bytes) {
                return broken(fault, RULE_LINKS, f->address);
            }
            expected += (b.node_bytes + b.geometry_bytes + 7u) & ~7u;
            edges += b.edges;
            f->last = f->address;
        }
        uint32_t depth = 0;
        const uint32_t link = next_edge(tree, f, &depth, info);
        first = link != PLT_MISS;
        if (!first) {
            if (level-- == 0) {
                break;
            }
            continue;
        }
        f->last = plt_block_address(link);
        if (depth >= PLT_DEPTH_MAX || level + 1 == PLT_DEPTH_MAX) {
            return plt_limit(fault, "the tree is deeper than PLT_DEPTH_MAX");
        }
        if (f->last >= tree->used) {
            return broken(fault, RULE_LINKS, f->address);
        }
        frames[++level].address = f->last;
        frames[level].depth = depth;
        frames[level].node_bytes = plt_block_node_bytes(link);
    }
    return expected == tree->used && edges + 1 == info->treelets
               ? PLT_OK
               : broken(fault, RULE_LINKS, expected);
}

int plt_block_survey(const plt_block_tree *tree, plt_block_frame_of_survey *frames, plt_info *info,
                     plt_fault *fault) {
    info->nodes = info->node_slots = info->leaf_lists = info->intermediate_lists = 0;
    info->treelets = info->triangles = info->node_bytes = info->triangle_bytes = 0;
    info->local_stack_entries = info->global_stack_entries = info->depth_stack_entries = 0;
    if (tree->root == PLT_MISS) {
        return tree->used == 0 ? PLT_OK : broken(fault, RULE_LINKS, 0);
    }
    if (plt_block_address(tree->root) != 0 || tree->used == 0) {
        return broken(fault, RULE_LINKS, 0);
    }
    const int status = walk(tree, frames, info, fault);
    info->node_slots = info->nodes;
    info->node_bytes = tree->used - info->triangle_bytes;
    return status == PLT_OK && info->depth_stack_entries > PLT_DEPTH_MAX
               ? plt_limit(fault, "the tree is deeper than PLT_DEPTH_MAX")
               : status;
}
