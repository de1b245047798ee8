/* items - the items of an image's sections: sizes and limits that SPEC.md gives
 *
 * What the header is checked against, and what tree/ lays its structures out by.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_IMAGE_ITEMS_H
#define PLT_IMAGE_ITEMS_H

#include <stdint.h>

#include "engine/base/bits.h"

#define PLT_NODE_BYTES 32                     /* a thesis node */
#define PLT_RECORD_BYTES 40                   /* a float record */
#define PLT_PAGE_RECORDS 8u                   /* records that are streamed, and checked, together */
#define PLT_INDEX_MAX ((1u << 27) - 1u)       /* of nodes and of triangles */
#define PLT_LINK_NONE 0xFFFFFFFFu             /* no link: the root of a scene without triangles */
#define PLT_BLOCK_NODES_MOST 64               /* of a compact block */
#define PLT_BLOCKS_BYTES_MAX (8u * 0xFFFFFFu) /* of all blocks: addresses are 24 bits, times 8 */

#define PLT_FRAME_BLOCK 64u /* vertices of a frame that are coded together */

/* Of images with instances: a body and where its box is in it, a matrix, what a frame of matrices
 * begins with, and how many there may be. */
enum {
    PLT_BODY_BYTES = 48,
    PLT_BODY_RESERVED = 20,
    PLT_BODY_BOX = 24,
    PLT_MATRIX_BYTES = 48,
    PLT_MATRICES_HEAD = 4,
    PLT_INSTANCES_MOST = 65536
};
#define PLT_PLACED_MOST 0xFFFFFFFEu /* triangles of all instances */

/* Bits of a vertex's number in the topology of a sequence. */
static inline uint32_t plt_index_bits(uint32_t vertices) {
    return plt_bits_for(vertices - 1);
}

/* Bytes of a coordinate in a section of lattice corners. */
static inline uint32_t plt_corner_width(uint32_t lattice_bits) {
    return lattice_bits <= 16 ? 2 : 4;
}

/* Bytes of a triangle there: three corners, x y z each. */
static inline uint32_t plt_corners_bytes(uint32_t lattice_bits) {
    return 9 * plt_corner_width(lattice_bits);
}

#endif
