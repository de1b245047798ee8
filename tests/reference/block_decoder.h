/* block_decoder - a second reader of compact scene images, from SPEC.md alone
 *
 * Shares nothing with the engine, so a mistake in either shows. Plain and slow: one bit at a
 * time, every rank counted again. Reads images of build host with lattice geometry or float
 * records, and reports what is wrong with any other. The lattice is the scene's quantisation
 * grid.
 *
 * Nodes, leaves and triangles are in the order of the image: blocks by address, in a block
 * nodes by number and leaves by slot. So a triangle's index is its image index.
 *
 * Source: SPEC.md, sections 2 to 4 and the invariants I10 to I21.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_BLOCK_DECODER_H
#define REFERENCE_BLOCK_DECODER_H
#include <stddef.h>
#include <stdint.h>

enum decoded_kind { DECODED_INNER, DECODED_EDGE, DECODED_LEAF, DECODED_PAIR };

/* Lattice coordinates; the floats are those of section 4.7. */
typedef struct decoded_box {
    int32_t lo[3], hi[3];
    float float_lo[3], float_hi[3];
} decoded_box;

typedef struct decoded_child {
    enum decoded_kind kind;
    uint32_t which; /* inner: index of a node; edge: of a block; else of a leaf */
    decoded_box box;
} decoded_child;

typedef struct decoded_node {
    uint32_t block; /* index */
    decoded_box box;
    decoded_child child[2];
} decoded_node;

typedef struct decoded_leaf {
    uint32_t block, slot;
    uint32_t first, triangles; /* index of the first triangle, how many */
} decoded_leaf;

typedef struct decoded_triangle {
    int32_t corner[3][3]; /* canonical order; 0 with float records */
    float point[3][3];
    uint32_t primitive_id, rotation; /* without primitive ids: image index, 0 */
} decoded_triangle;

typedef struct decoded_block {
    uint32_t address, nodes_bytes, geometry_bytes, takes_bytes;
    uint32_t first_node, nodes, first_leaf, leaves, first_triangle, triangles;
    uint32_t edges, vertices, mesh, strips;
    uint32_t depth; /* nodes above its root */
    decoded_box bounds;
} decoded_block;

typedef struct decoded_section {
    uint32_t kind, offset, bytes, crc;
} decoded_section;

typedef struct decoded_header {
    uint32_t major, minor, bytes, image_bytes, crc;
    uint32_t triangles, nodes, node_slots, leaf_lists, intermediate_lists, treelets, treelet_nodes;
    uint32_t leaf_triangles, local_stack, global_stack, depth_stack;
    uint32_t root_link;
    float lo[3], hi[3];
    uint32_t splits, build, node_format, geometry_format, sections;
    decoded_section section[2];
    float origin[3], step;
    uint32_t lattice_bits, lattice_lo[3], lattice_hi[3];
    uint32_t source_triangles, primitive_id_bits, node_bytes, triangle_bytes;
    uint32_t id_checks; /* 1: geometry parts end with a check of their ids */
} decoded_header;

typedef struct decoded_image {
    decoded_header header;
    decoded_block *block;
    decoded_node *node;
    decoded_leaf *leaf;
    decoded_triangle *triangle;
    uint32_t blocks, nodes, leaves, pairs, triangles;
    uint32_t depth;  /* nodes on the longest path */
    char wrong[200]; /* empty, or the first error */
} decoded_image;

/* Returns 0, or -1 with `wrong` set. block_decode_free frees the arrays in either case. Running
 * out of memory ends the program. */
int block_decode(decoded_image *image, const unsigned char *bytes, size_t size);
void block_decode_free(decoded_image *image);

/* Lattice coordinate `number` on `axis` as a float. */
float block_decode_float(const decoded_header *header, int axis, int32_t number);

/* Only header, sections and their checksums; the first half of block_decode. */
int block_decode_header(decoded_image *image, const unsigned char *bytes, size_t size);

/* Sets `wrong` unless it is already set; returns -1. */
int block_decode_wrong(decoded_image *image, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
