/* primitive_id - which triangle of the packed mesh this is
 *
 * An id word holds the primitive id, the triangle's index in packing order, in bits
 * 0 .. 26 and its rotation in bits 29 and 30: which corner of the canonical order
 * (canonical.h) came first in the packed mesh. Float records carry the word. Lattice
 * geometry keeps the words in a section of their own, packed to as few bits as they
 * take, and they are read only for hits. Without them a triangle's id is its index in
 * the image, and its rotation 0.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_PRIMITIVE_ID_H
#define PLT_TREE_PRIMITIVE_ID_H

#include <stddef.h>
#include <stdint.h>

#include "engine/base/bytes.h"

#define PLT_PRIMITIVE_ROTATION_SHIFT 29
#define PLT_PRIMITIVE_ID_MASK 0x07FFFFFFu
#define PLT_PRIMITIVE_UNUSED_SHIFT 27
#define PLT_PRIMITIVE_UNUSED 0x18000000u /* bits 27 and 28: 0, or of a check (thesis/checks.h) */

/* A section of the image: entry i is `bits` bits at bit i * bits, the rotation in
 * the lowest two, then the id; least significant bit first. PLT_BITS_BEHIND bytes
 * behind the last entry may be read. */
typedef struct plt_primitive_ids {
    const unsigned char *bytes;
    uint32_t bits;  /* 2 .. 29 */
    uint32_t first; /* byte of the section that `bytes` begins with; 0: all of it is there */
} plt_primitive_ids;

static inline uint32_t plt_primitive_id(uint32_t word) {
    return word & PLT_PRIMITIVE_ID_MASK;
}

static inline uint32_t plt_primitive_rotation(uint32_t word) {
    return word >> PLT_PRIMITIVE_ROTATION_SHIFT & 3u;
}

/* The id word of the triangle of that index; `ids` may be NULL. */
static inline uint32_t plt_primitive_word_find(const plt_primitive_ids *ids, uint32_t index) {
    if (ids == NULL) {
        return index;
    }
    const uint64_t at = (uint64_t)index * ids->bits;
    const unsigned char *byte = ids->bytes + ((at >> 3) - ids->first);
    const uint64_t word = (uint64_t)plt_get_u32(byte + 4) << 32 | plt_get_u32(byte);
    const uint32_t entry = (uint32_t)(word >> (at & 7)) & ((1u << ids->bits) - 1u);
    return entry >> 2 | (entry & 3u) << PLT_PRIMITIVE_ROTATION_SHIFT;
}

#endif
