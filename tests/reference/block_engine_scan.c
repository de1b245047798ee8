/* block_engine_scan - what the engine's own functions read from compact blocks
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/block_engine_scan.h"
#include "tests/reference/block_slots.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/lattice.h"
#include "engine/tree/compact/leaf.h"
#include "engine/tree/primitive_id.h"
#include "tests/reference/leaf_corners.h"

/* The image, and the current block. */
typedef struct scan_source {
    const unsigned char *blocks, *second; /* sections; the second may be missing */
    const decoded_header *header;
    plt_lattice lattice;
    plt_block block;
    plt_geometry geometry;
} scan_source;

static int has_floats(const scan_source *source) {
    return source->header->geometry_format == 0;
}

/* Elements that an array of `count` has room for. */
static size_t room_of(size_t count) {
    size_t room = 64;
    while (room < count) {
        room *= 2;
    }
    return room;
}

/* Returns the array with room for `more` elements after its `count`; the new ones are 0. */
static void *grow(void *array, uint32_t count, uint32_t more, size_t element_bytes) {
    const size_t room = room_of((size_t)count + more);
    if (array == NULL || room != room_of(count)) {
        array = realloc(array, room * element_bytes);
    }
    if (array == NULL) {
        fprintf(stderr, "block_engine_scan: out of memory\n");
        exit(1);
    }
    memset((char *)array + count * element_bytes, 0, more * element_bytes);
    return array;
}

/* Rotates the least corner to the front; the winding stays. */
static void rotate_to_least(uint32_t to[3][3], uint32_t corner[3][3]) {
    uint64_t key[3];
    int least = 0;
    for (int c = 0; c < 3; c++) {
        key[c] = (uint64_t)corner[c][0] << 42 | (uint64_t)corner[c][1] << 21 | corner[c][2];
        least = key[c] < key[least] ? c : least;
    }
    for (int c = 0; c < 3; c++) {
        memcpy(to[c], corner[(least + c) % 3], sizeof to[c]);
    }
}

static void add_lattice_triangle(engine_scan *scan, const scan_source *source,
                                 uint32_t corner[3][3]) {
    const uint32_t index = scan->triangles++;
    engine_triangle *triangle = &scan->triangle[index];
    const plt_primitive_ids numbers = {source->second, source->header->primitive_id_bits, 0};
    const uint32_t word = plt_primitive_word_find(numbers.bits != 0 ? &numbers : NULL, index);
    triangle->primitive_id = plt_primitive_id(word);
    triangle->rotation = plt_primitive_rotation(word);
    rotate_to_least(triangle->corner, corner);
    for (int i = 0; i < 9; i++) {
        triangle->point[i / 3][i % 3] =
            plt_lattice_float(&source->lattice, i % 3, triangle->corner[i / 3][i % 3]);
    }
}

static void add_record(engine_scan *scan, const scan_source *source) {
    const uint32_t index = scan->triangles++;
    const unsigned char *record = source->second + 40 * (size_t)index;
    engine_triangle *triangle = &scan->triangle[index];
    for (uint32_t i = 0; i < 9; i++) {
        triangle->point[i / 3][i % 3] = plt_get_float(record + 4 * i);
    }
    triangle->primitive_id = plt_primitive_id(plt_get_u32(record + 36));
    triangle->rotation = plt_primitive_rotation(plt_get_u32(record + 36));
}

static void add_leaf(engine_scan *scan, const scan_source *source, engine_child *child,
                     uint32_t slot) {
    const uint32_t pairs = block_pairs(&source->block, slot);
    const int is_pair = (source->block.pair[slot / 32] >> slot % 32 & 1u) != 0;
    const uint32_t first =
        plt_leaf_find(&source->geometry, child->rank, pairs, is_pair, &child->count);
    uint32_t corner[PLT_LEAF_TRIANGLES_MOST][3][3];
    child->first = source->geometry.first_triangle + first;
    scan->triangle = grow(scan->triangle, scan->triangles, child->count, sizeof *scan->triangle);
    if (!has_floats(source)) {
        leaf_corners(&source->geometry, first, child->count, corner);
    }
    for (uint32_t t = 0; t < child->count; t++) {
        if (has_floats(source)) {
            add_record(scan, source);
        } else {
            add_lattice_triangle(scan, source, corner[t]);
        }
    }
}

/* Adds both children of a node; `box` is its own box, and `below` gets theirs
 * where they are nodes of this block. */
static void add_children(engine_scan *scan, const scan_source *source, uint32_t node,
                         plt_lattice_box below[PLT_BLOCK_NODES_MOST]) {
    plt_lattice_box box[2];
    block_children(&source->block, node, &below[node], box);
    for (uint32_t c = 0; c < 2; c++) {
        const uint32_t slot = 2 * node + c;
        engine_child *child = &scan->child[scan->children++];
        child->kind = plt_block_kind(&source->block, slot);
        child->rank = plt_block_rank(&source->block, child->kind, slot);
        child->box = box[c];
        plt_lattice_to_box(&source->lattice, &box[c], &child->floats);
        if (child->kind == PLT_SLOT_INNER) {
            below[child->rank + 1] = box[c];
        } else if (child->kind == PLT_SLOT_EDGE) {
            child->link = plt_block_edge(&source->block, child->rank);
        } else {
            add_leaf(scan, source, child, slot);
        }
    }
}

/* Only blocks with leaves have a geometry part to open. */
static void open_geometry(scan_source *source, engine_block *block) {
    plt_geometry *g = &source->geometry;
    if (source->block.leaves == 0) {
        return;
    }
    if (has_floats(source)) {
        plt_geometry_open_counts(g, &source->block, source->header->leaf_triangles);
    } else {
        plt_geometry_open(g, &source->block, &block->bounds, source->header->leaf_triangles);
    }
    block->first_triangle = g->first_triangle;
    block->triangles = g->triangles;
    block->vertices = g->vertices;
    block->mesh = g->mesh;
}

static uint32_t add_block(engine_scan *scan, scan_source *source, uint32_t address) {
    plt_block *open = &source->block;
    plt_lattice_box below[PLT_BLOCK_NODES_MOST];
    plt_block_open(open, source->blocks + address, source->lattice.bits);
    scan->block = grow(scan->block, scan->blocks, 1, sizeof *scan->block);
    scan->child = grow(scan->child, scan->children, 2 * open->nodes, sizeof *scan->child);
    engine_block *block = &scan->block[scan->blocks++];
    *block = (engine_block){.address = address,
                            .node_bytes = open->node_bytes,
                            .geometry_bytes = open->geometry_bytes,
                            .nodes = open->nodes,
                            .edges = open->edges,
                            .leaves = open->leaves,
                            .pairs = open->pairs};
    plt_block_bounds(open, source->lattice.bits, &block->bounds);
    open_geometry(source, block);
    below[0] = block->bounds;
    for (uint32_t node = 0; node < open->nodes; node++) {
        add_children(scan, source, node, below);
    }
    return address + (open->node_bytes + open->geometry_bytes + 7) / 8 * 8;
}

void engine_scan_make(engine_scan *scan, const unsigned char *image, const decoded_header *header) {
    scan_source source = {.header = header};
    source.blocks = image + header->section[0].offset;
    source.second = header->sections > 1 ? image + header->section[1].offset : NULL;
    memcpy(source.lattice.origin, header->origin, sizeof header->origin);
    source.lattice.step = header->step;
    source.lattice.bits = header->lattice_bits;
    memset(scan, 0, sizeof *scan);
    const uint32_t end = header->node_bytes + header->triangle_bytes;
    for (uint32_t address = 0; address < end;) {
        address = add_block(scan, &source, address);
    }
}

void engine_scan_free(engine_scan *scan) {
    free(scan->block);
    free(scan->child);
    free(scan->triangle);
}
