/* breakdown - see breakdown.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/breakdown.h"

#include <string.h>

#include "engine/engine.h"
#include "engine/tree/compact/leaf.h"

const char *const breakdown_names[PARTS] = {
    "planes",           "owners",           "kinds",  "links",  "frames",     "headers",
    "padding",          "geometry_headers", "counts", "strips", "references", "positions",
    "geometry_padding", "number_checks",    "numbers"};

static void count_nodes(const plt_block *b, uint32_t bits, breakdown *to) {
    const double masks = 2.0 * ((2 * b->nodes + 7) / 8), owners = (5 * b->nodes + 7) / 8;
    to->bytes[PART_PLANES] += 6.0 * b->nodes;
    to->bytes[PART_OWNERS] += owners;
    to->bytes[PART_KINDS] += masks;
    to->bytes[PART_LINKS] += 4.0 * b->edges;
    to->bytes[PART_BOUNDS] += plt_block_bounds_bytes(bits);
    to->bytes[PART_HEADERS] += PLT_BLOCK_HEADER_BYTES;
    const uint32_t size = plt_block_bytes(b);
    to->bytes[PART_PADDING] += (double)(size - b->geometry_bytes) -
                               (double)plt_block_parts_bytes(b->nodes, b->edges, bits);
}

static void count_geometry(const plt_block_tree *tree, const plt_block *b, breakdown *to) {
    plt_geometry g;
    plt_lattice_box bounds;
    plt_geometry_open_counts(&g, b, tree->leaf_triangles);
    to->of_one_mesh += g.mesh != 0;
    if (tree->leaf_kind == PLT_LEAF_RECORDS) {
        to->bytes[PART_GEOMETRY_HEADERS] += PLT_GEOMETRY_HEADER_BYTES;
        to->bytes[PART_COUNTS] += (g.starts - g.counts) / 8.0;
        to->bytes[PART_GEOMETRY_PADDING] += b->geometry_bytes - g.starts / 8.0;
        return;
    }
    plt_block_bounds(b, tree->lattice.bits, &bounds);
    plt_block_tree_frame(tree, &bounds);
    plt_geometry_open(&g, b, &bounds, tree->leaf_triangles);
    const double turns = (double)plt_turn_bits(tree) * g.triangles;
    const double end = g.positions + (double)g.vertices * g.vertex_bits + turns;
    to->bytes[PART_GEOMETRY_HEADERS] += PLT_GEOMETRY_HEADER_BYTES;
    to->bytes[PART_COUNTS] += (g.starts - g.counts) / 8.0;
    to->bytes[PART_STRIPS] += (g.refs - g.starts + turns) / 8.0;
    to->bytes[PART_REFERENCES] += (g.positions - g.refs) / 8.0;
    to->bytes[PART_POSITIONS] += (double)g.vertices * g.vertex_bits / 8.0;
    const double check = tree->ids_check_bytes;
    to->bytes[PART_ID_CHECKS] += check;
    to->bytes[PART_GEOMETRY_PADDING] += b->geometry_bytes - check - end / 8.0;
}

void breakdown_count(const plt_engine *engine, breakdown *b) {
    const plt_block_tree *tree = &engine->scene.compact;
    const plt_info *info = plt_engine_info(engine);
    memset(b, 0, sizeof *b);
    for (uint32_t at = 0; at < tree->used;) {
        plt_block block;
        plt_block_open(&block, tree->bytes + at, tree->lattice.bits);
        count_nodes(&block, tree->lattice.bits, b);
        if (block.geometry_bytes > 0) {
            count_geometry(tree, &block, b);
        }
        at += plt_block_bytes(&block);
    }
    b->bytes[PART_POSITIONS] +=
        tree->leaf_kind == PLT_LEAF_RECORDS ? (double)info->triangles * PLT_RECORD_BYTES : 0.0;
    b->bytes[PART_PRIMITIVE_IDS] = (double)info->triangles * info->primitive_id_bits / 8.0;
}
