/* compact_thesis - see compact_thesis.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/compact_thesis.h"
#include "tests/reference/block_slots.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/image/header.h"
#include "engine/planelet_crc32.h"
#include "engine/tree/thesis/validate.h"
#include "host_tools/base/heap.h"
#include "tests/reference/leaf_corners.h"

typedef struct converting {
    const plt_block_tree *tree;
    plt_node *nodes;
    plt_record *records;
    uint32_t nodes_used, records_used;
} converting;

typedef struct subtree {
    uint32_t link;
    plt_box box; /* exact */
} subtree;

/* The primitive id word of a record (SPEC.md, 4.4) from the entry of a triangle (4.12), read
 * bit by bit and not as the engine does. */
static uint32_t primitive_id_word(const plt_primitive_ids *ids, uint32_t index) {
    uint32_t entry = 0;
    for (uint32_t i = 0; i < ids->bits; i++) {
        const uint64_t at = (uint64_t)index * ids->bits + i;
        entry |= (uint32_t)(ids->bytes[at / 8] >> at % 8 & 1) << i;
    }
    const uint32_t id = entry / 4, rotation = entry % 4;
    return id + rotation * 0x20000000u;
}

static void set_record(const converting *c, plt_record *r, const uint32_t corner[3][3],
                       uint32_t index, int last) {
    const plt_lattice *l = &c->tree->lattice;
    int least = 0;
    for (int i = 1; i < 3; i++) {
        int a = 0;
        while (a < 2 && corner[i][a] == corner[least][a]) {
            a++;
        }
        least = corner[i][a] < corner[least][a] ? i : least;
    }
    for (int k = 0; k < 9; k++) {
        plt_put_float(&r->word[k], plt_lattice_float(l, k % 3, corner[(least + k / 3) % 3][k % 3]));
    }
    const plt_primitive_ids *ids = &c->tree->ids;
    plt_put_u32(&r->word[9], ids->bytes != NULL ? primitive_id_word(ids, index) : index);
    plt_record_set_last(r, last);
}

/* A leaf's triangles as one list, or as two in a row. */
static subtree leaf(converting *c, const plt_block *b, uint32_t slot) {
    plt_geometry g;
    plt_lattice_box bounds;
    uint32_t corner[PLT_LEAF_TRIANGLES_MOST][3][3];
    const int pair = (int)(b->pair[slot >> 5] >> (slot & 31) & 1u);
    const uint32_t number = plt_block_rank(b, PLT_SLOT_LEAF, slot), k = c->tree->leaf_triangles;
    plt_block_bounds(b, c->tree->lattice.bits, &bounds);
    plt_geometry_open(&g, b, &bounds, k);
    uint32_t count;
    const uint32_t first = plt_leaf_find(&g, number, block_pairs(b, slot), pair, &count);
    subtree s = {plt_link_make(c->records_used, PLT_LINK_LEAF | (pair ? PLT_LINK_TWO : 0)),
                 plt_box_empty()};
    leaf_corners(&g, first, count, corner);
    for (uint32_t i = 0; i < count; i++) {
        plt_record *r = &c->records[c->records_used++];
        set_record(c, r, (const uint32_t(*)[3])corner[i], g.first_triangle + first + i,
                   i + 1 == count || (pair && i + 1 == k));
        const plt_box box = plt_record_box(r);
        plt_box_add(&s.box, &box);
    }
    return s;
}

static subtree convert(converting *c, const plt_block *b, uint32_t node) {
    const uint32_t index = c->nodes_used++;
    subtree child[2], s = {plt_link_make(index, PLT_LINK_OUT), plt_box_empty()};
    for (uint32_t i = 0; i < 2; i++) {
        const uint32_t slot = 2 * node + i;
        plt_block below;
        switch (plt_block_kind(b, slot)) {
        case PLT_SLOT_INNER:
            child[i] = convert(c, b, 1 + plt_block_rank(b, PLT_SLOT_INNER, slot));
            break;
        case PLT_SLOT_EDGE:
            plt_block_open(&below,
                           c->tree->bytes + plt_block_address(plt_block_edge(
                                                b, plt_block_rank(b, PLT_SLOT_EDGE, slot))),
                           c->tree->lattice.bits);
            child[i] = convert(c, &below, 0);
            break;
        default:
            child[i] = leaf(c, b, slot);
        }
        plt_box_add(&s.box, &child[i].box);
    }
    const plt_box boxes[2] = {child[0].box, child[1].box};
    plt_node_encode(&c->nodes[index], &s.box, boxes);
    plt_node_relink(&c->nodes[index], 0, child[0].link);
    plt_node_relink(&c->nodes[index], 1, child[1].link);
    return s;
}

static packed assemble(const converting *c, plt_header *h) {
    packed image = {.size = 0};
    unsigned char header[PLT_HEADER_BYTES];
    plt_header_write(header, h);
    image.size = h->info.image_bytes;
    image.bytes = heap_get_aligned(image.size);
    memset(image.bytes, 0, image.size);
    unsigned char *nodes = image.bytes + h->section[0].offset;
    unsigned char *records = image.bytes + h->section[1].offset;
    memcpy(nodes, c->nodes, c->nodes_used * sizeof *c->nodes);
    memcpy(records, c->records, c->records_used * sizeof *c->records);
    h->section[0].crc = plt_crc32(0, nodes, h->section[0].bytes);
    h->section[1].crc = plt_crc32(0, records, h->section[1].bytes);
    plt_header_write(image.bytes, h);
    image.info = h->info;
    return image;
}

packed compact_as_thesis(const plt_block_tree *tree, const plt_info *info) {
    converting c = {.tree = tree,
                    .nodes = malloc(info->nodes * sizeof *c.nodes),
                    .records = malloc(info->triangles * sizeof *c.records)};
    plt_block root;
    plt_fault fault = {0, 0, 0, 0, NULL};
    plt_validate_level levels[PLT_VALIDATE_LEVELS];
    plt_block_open(&root, tree->bytes, tree->lattice.bits);
    const subtree all = convert(&c, &root, 0);
    plt_header h = {.info = {.triangles = c.records_used,
                             .node_slots = c.nodes_used,
                             .treelet_nodes = 1,
                             .leaf_triangles = info->leaf_triangles},
                    .root = all.link & ~PLT_LINK_OUT};
    const plt_tree thesis = {.nodes = c.nodes,
                             .records = c.records,
                             .node_slots = c.nodes_used,
                             .records_count = c.records_used,
                             .treelet_nodes = 1,
                             .root = h.root};
    memcpy(h.info.lo, all.box.lo, sizeof h.info.lo);
    memcpy(h.info.hi, all.box.hi, sizeof h.info.hi);
    if (plt_tree_validate(&thesis, levels, &h.info, &fault) != PLT_OK) {
        printf("FAIL a compact tree as thesis nodes: %s\n", fault.message);
        exit(1);
    }
    const packed image = assemble(&c, &h);
    free(c.nodes);
    free(c.records);
    return image;
}
