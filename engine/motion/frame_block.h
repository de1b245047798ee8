/* frame_block - some vertices of a frame: how far each has moved since the frame before
 *
 * Coordinates are whole numbers of 12 to 21 bits on a lattice, or the 32 bits of a float in the
 * order of floats. A block holds of 64 vertices (the last of fewer) the least difference on each
 * axis, and what each vertex's is above that, in as many bits as the largest takes (frame of
 * reference). Arithmetic is modulo the coordinate's bits, so whatever a block holds gives
 * coordinates in range, and floats alone are looked at. SPEC.md, section 4.15.
 *
 * Source: J. Goldstein, R. Ramakrishnan, U. Shaft, "Compressing Relations and Indexes", 1998 (frame
 * of reference).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_FRAME_BLOCK_H
#define PLT_MOTION_FRAME_BLOCK_H

#include <stdint.h>

#include "engine/base/between.h"
#include "engine/base/bits.h"
#include "engine/image/items.h"
#include "engine/tree/vertices.h"

enum {
    PLT_FRAME_CHECK_BYTES = 4,
    PLT_FRAME_WIDTH_BITS = 6,  /* of each axis */
    PLT_FRAME_FLOAT_BITS = 32, /* of a coordinate that is a float */
    PLT_FRAME_HEAD_MOST = 19,  /* bytes: check, widths and least differences */
    PLT_FRAME_BLOCK_MOST = 788 /* bytes */
};

/* Bit of a block where the differences of vertices begin. */
static inline uint32_t plt_frame_head_bits(uint32_t word_bits) {
    return 8 * PLT_FRAME_CHECK_BYTES + 3 * (PLT_FRAME_WIDTH_BITS + word_bits);
}

static inline uint32_t plt_frame_width(const unsigned char *block, uint32_t axis) {
    return plt_bits_get(block, 8 * PLT_FRAME_CHECK_BYTES + PLT_FRAME_WIDTH_BITS * axis,
                        PLT_FRAME_WIDTH_BITS);
}

/* Bytes of such a block, a multiple of 4. */
static inline uint32_t plt_frame_bytes_for(uint32_t vertices, uint32_t word_bits, uint32_t widths) {
    return (plt_frame_head_bits(word_bits) + vertices * widths + 31) / 32 * 4;
}

/* Bytes of the block whose first PLT_FRAME_HEAD_MOST bytes can be read; 0: it has widths of
 * more bits than a coordinate. */
uint32_t plt_frame_block_bytes(const unsigned char *block, uint32_t vertices, uint32_t word_bits);

/* What its check has to be, block `index` of frame `frame`: so a block in another's place, or what
 * was there before it came, is noticed, too. */
uint32_t plt_frame_block_check(const unsigned char *block, uint32_t bytes, uint32_t frame,
                               uint32_t index);

/* Moves the vertices; with `is_key` from 0. */
void plt_frame_block_apply(const unsigned char *block, plt_frame_vertex *vertex, uint32_t vertices,
                           uint32_t word_bits, int is_key);

/* All floats of some vertices are numbers within 2^40. */
int plt_frame_floats_valid(const plt_frame_vertex *vertex, uint32_t vertices);

#endif
