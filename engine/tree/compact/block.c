/* block - see block.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/compact/block.h"

#include "engine/planelet_crc32.h"

/* Word `w` of a mask of `bits` bits that starts at `bytes`. */
static uint32_t mask_word(const unsigned char *bytes, uint32_t bits, uint32_t w) {
    return bits <= 32 * w ? 0 : plt_get_u32(bytes + 4 * w) & plt_low_bits(bits - 32 * w);
}

static uint32_t running_ranks(const uint32_t mask[4], uint32_t words, uint8_t before[4]) {
    uint32_t count = 0;
    for (uint32_t w = 0; w < words; w++) {
        before[w] = (uint8_t)count;
        count += plt_count_bits(mask[w]);
    }
    return count;
}

void plt_block_open(plt_block *b, const unsigned char *bytes, uint32_t bits) {
    const uint32_t head = plt_get_u32(bytes);
    const uint32_t slots = 2 * ((head & 63) + 1), words = (slots + 31) / 32;
    const unsigned char *mask_a = bytes + PLT_BLOCK_HEADER_BYTES + plt_block_bounds_bytes(bits);
    const unsigned char *mask_b = mask_a + (slots + 7) / 8;
    b->bytes = bytes;
    b->nodes = slots / 2;
    b->geometry_bytes = (head >> 6 & 0x3FF) * 8;
    for (uint32_t w = 0; w < words; w++) {
        const uint32_t a = mask_word(mask_a, slots, w), m = mask_word(mask_b, slots, w);
        b->mask[PLT_SLOT_INNER][w] = a & ~m;
        b->mask[PLT_SLOT_EDGE][w] = a & m;
        b->pair[w] = m & ~a;
    }
    const uint32_t inners =
        running_ranks(b->mask[PLT_SLOT_INNER], words, b->before[PLT_SLOT_INNER]);
    b->edges = running_ranks(b->mask[PLT_SLOT_EDGE], words, b->before[PLT_SLOT_EDGE]);
    b->pairs = running_ranks(b->pair, words, b->pairs_before);
    b->leaves = slots - inners - b->edges;
    b->owners = mask_b + (slots + 7) / 8;
    b->planes = b->owners + (5 * b->nodes + 7) / 8;
    b->links = b->planes + 6 * b->nodes;
    b->node_bytes = plt_block_nodes_bytes(b->nodes, b->edges, bits);
    b->geometry = bytes + b->node_bytes;
}

void plt_block_bounds_at(const unsigned char *bytes, uint32_t bits, plt_lattice_box *bounds) {
    const uint32_t width = plt_block_bounds_width(bits);
    const unsigned char *at = bytes + PLT_BLOCK_HEADER_BYTES;
    for (uint32_t a = 0; a < 3; a++) {
        bounds->lo[a] = plt_bits_get(at, a * width, width);
        bounds->hi[a] = plt_bits_get(at, (a + 3) * width, width);
    }
}

void plt_block_apply(const plt_lattice_box *box, const unsigned char plane[6], uint32_t owners,
                     plt_lattice_box child[2]) {
    for (uint32_t a = 0; a < 3; a++) {
        const uint32_t step = plt_block_step(box->hi[a] - box->lo[a]);
        const uint32_t lo = box->lo[a] + plane[a] * step, hi = box->hi[a] - plane[3 + a] * step;
        const uint32_t right_lo = owners >> a & 1u, right_hi = owners >> (3 + a) & 1u;
        child[0].lo[a] = right_lo ? box->lo[a] : lo;
        child[1].lo[a] = right_lo ? lo : box->lo[a];
        child[0].hi[a] = right_hi ? box->hi[a] : hi;
        child[1].hi[a] = right_hi ? hi : box->hi[a];
    }
}

static uint16_t halves(uint32_t crc) {
    return (uint16_t)(crc ^ crc >> 16);
}

uint16_t plt_block_ids_check(const unsigned char *ids, uint32_t bytes) {
    return halves(plt_crc32(0, ids, bytes));
}

uint16_t plt_block_check(const unsigned char *part, uint32_t bytes, uint32_t check_at) {
    const unsigned char zero[2] = {0, 0};
    uint32_t crc = plt_crc32(0, part, check_at);
    crc = plt_crc32(crc, zero, 2);
    return halves(plt_crc32(crc, part + check_at + 2, bytes - check_at - 2));
}
