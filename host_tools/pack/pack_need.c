/* pack_need - see pack_need.h
 *
 * Each function follows the one that allocates; tests/host_tools/test_pack_need.c compares them.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/pack_need.h"

#include "engine/builder/blocks.h"
#include "engine/builder/build.h"
#include "engine/image/header.h"
#include "engine/image/items.h"
#include "host_tools/mesh/position_table.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/list_tree.h"
#include "host_tools/pack/pack_treelets.h"
#include "host_tools/pack/quality.h"

enum { SMALL_THINGS = 4096 }; /* heads of blocks, and what rounds them up */

static uint64_t greater(uint64_t a, uint64_t b) {
    return a > b ? a : b;
}

static uint64_t node_bytes(uint32_t triangles, uint32_t treelet_nodes) {
    const uint32_t bound = plt_build_nodes_bound(triangles);
    return (uint64_t)plt_build_slots_bound(bound, treelet_nodes) * PLT_NODE_BYTES;
}

static uint64_t scratch_bytes(uint32_t triangles, uint32_t treelet_nodes) {
    return plt_build_scratch_bytes(plt_build_nodes_bound(triangles), treelet_nodes);
}

static uint32_t count32(uint64_t triangles) {
    return triangles > PLT_INDEX_MAX ? PLT_INDEX_MAX : (uint32_t)triangles;
}

/* Another image, and what it takes to choose its slots. */
static uint64_t forming_bytes(const pack_options *o, uint32_t triangles) {
    const uint32_t nodes = plt_build_nodes_bound(triangles);
    const uint64_t each = PLT_NODE_BYTES + (o->checks ? 1 : 0);
    return PLT_HEADER_BYTES + (uint64_t)triangles * PLT_RECORD_BYTES +
           each * pack_treelets_slots(o, nodes) + pack_treelets_bytes(o, nodes) + SMALL_THINGS;
}

/* ---- thesis nodes (pack.c) ------------------------------------------------------------------- */

uint64_t pack_need_thesis(const pack_options *o, int is_high, const pack_counts *n) {
    const uint32_t triangles = count32(n->triangles);
    const int builds = o->build == PLT_BUILD_HOST;
    const int forms = pack_treelets_differ(o);
    const uint32_t treelet = forms ? 1 : o->treelet_nodes;
    const uint64_t nodes = node_bytes(triangles, treelet);
    const uint64_t image = PLT_HEADER_BYTES + (uint64_t)triangles * PLT_RECORD_BYTES +
                           (builds ? nodes + (o->checks ? nodes / PLT_NODE_BYTES : 0) : 0) +
                           SMALL_THINGS;
    const uint64_t kept = n->held - (o->spend != NULL ? n->mesh : 0);
    uint64_t building = builds ? scratch_bytes(triangles, treelet) : 0;
    building = building + (is_high ? quality_bytes(triangles) : 0);
    building = greater(building, forms ? forming_bytes(o, triangles) : 0);
    return image + greater(n->held, kept + building);
}

/* ---- compact blocks (pack_compact.c) --------------------------------------------------------- */

/* Vertices on the lattice, while slivers are mended, and while positions are counted. */
static uint64_t moving(const pack_counts *n) {
    const uint64_t table = position_table_bytes(n->vertices);
    const uint64_t mending = 8 * n->vertices + greater(table, 4 * n->vertices + 12 * n->triangles);
    return greater(mending, table);
}

static uint64_t improving(uint32_t triangles) {
    return 2 * (uint64_t)triangles + 44 * (uint64_t)triangles + node_bytes(triangles, 64) +
           scratch_bytes(triangles, 64) + quality_bytes(triangles);
}

static uint64_t blocks(const compact_options *o, uint32_t triangles) {
    const uint64_t behind = o->floats ? PLT_RECORD_BYTES : o->numbers ? 4 : 0;
    const uint64_t order = o->floats || o->numbers ? 4 : 0;
    const uint64_t lists = (o->meshes > 1 ? 2 : 0) + (o->quality != NULL ? 2 : 0) + order;
    return image_size_room_blocks(triangles) + plt_blocks_scratch_bytes(triangles) +
           triangles * (behind + lists);
}

uint64_t pack_need_compact(const compact_options *o, const pack_counts *n) {
    const uint32_t triangles = count32(n->triangles);
    const uint64_t width =
        plt_corner_width(o->tolerance > 0 ? PLT_LATTICE_BITS_MOST : o->lattice_bits);
    const uint64_t lattice = n->triangles * (o->floats ? 6 * width + 4 : 9 * width + 5);
    const uint64_t snapping =
        n->held + (o->floats ? lattice : 12 * n->vertices + greater(moving(n), lattice));
    const uint64_t kept = n->held - (o->spend != NULL && !o->floats ? n->mesh : 0) + lattice;
    uint64_t building =
        o->build == PLT_BUILD_HOST ? blocks(o, triangles) : PLT_HEADER_BYTES + lattice;
    building = greater(building, o->quality != NULL ? improving(triangles) : 0);
    return greater(snapping, kept + building) + SMALL_THINGS;
}
