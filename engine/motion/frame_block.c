/* frame_block - see frame_block.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/frame_block.h"

#include "engine/planelet.h"
#include "engine/planelet_crc32.h"

_Static_assert((PLT_FRAME_BLOCK * 96 + 146 + 31) / 32 * 4 == PLT_FRAME_BLOCK_MOST,
               "64 vertices of three whole floats");

uint32_t plt_frame_block_bytes(const unsigned char *block, uint32_t vertices, uint32_t word_bits) {
    uint32_t sum = 0;
    for (uint32_t a = 0; a < 3; a++) {
        const uint32_t width = plt_frame_width(block, a);
        if (width > word_bits) {
            return 0;
        }
        sum += width;
    }
    return plt_frame_bytes_for(vertices, word_bits, sum);
}

uint32_t plt_frame_block_check(const unsigned char *block, uint32_t bytes, uint32_t frame,
                               uint32_t index) {
    unsigned char place[8];
    plt_put_u32(place, frame);
    plt_put_u32(place + 4, index);
    return plt_crc32(plt_crc32(0, place, sizeof place), block + PLT_FRAME_CHECK_BYTES,
                     bytes - PLT_FRAME_CHECK_BYTES);
}

/* One axis on the lattice: `above` bits from bit `at` on. */
static void move_on_lattice(const unsigned char *block, uint32_t at, uint32_t width, uint32_t least,
                            uint32_t *word, uint32_t vertices, uint32_t keep, uint32_t mask) {
    for (uint32_t i = 0; i < vertices; i++, word += 3, at += width) {
        *word = ((*word & keep) + least + plt_bits_short(block, at, width)) & mask;
    }
}

static void move_floats(const unsigned char *block, uint32_t at, uint32_t width, uint32_t least,
                        uint32_t *word, uint32_t vertices, uint32_t keep) {
    for (uint32_t i = 0; i < vertices; i++, word += 3, at += width) {
        const uint32_t was = plt_float_order(*word) & keep;
        *word = plt_float_order(was + least + plt_bits_get(block, at, width));
    }
}

void plt_frame_block_apply(const unsigned char *block, plt_frame_vertex *vertex, uint32_t vertices,
                           uint32_t word_bits, int is_key) {
    const uint32_t mask = plt_low_bits(word_bits), keep = is_key ? 0 : mask;
    uint32_t at = plt_frame_head_bits(word_bits);
    for (uint32_t a = 0; a < 3; a++) {
        const uint32_t least_at = 8 * PLT_FRAME_CHECK_BYTES + 3 * PLT_FRAME_WIDTH_BITS;
        const uint32_t least = plt_bits_get(block, least_at + word_bits * a, word_bits);
        const uint32_t width = plt_frame_width(block, a);
        uint32_t *word = &vertex->word[a];
        if (word_bits == PLT_FRAME_FLOAT_BITS) {
            move_floats(block, at, width, least, word, vertices, keep);
        } else {
            move_on_lattice(block, at, width, least, word, vertices, keep, mask);
        }
        at += vertices * width;
    }
}

int plt_frame_floats_valid(const plt_frame_vertex *vertex, uint32_t vertices) {
    static const float lo[3] = {-PLT_COORD_MAX, -PLT_COORD_MAX, -PLT_COORD_MAX};
    static const float hi[3] = {PLT_COORD_MAX, PLT_COORD_MAX, PLT_COORD_MAX};
    plt_between range[3];
    int good = 1;
    plt_between_set(range, lo, hi);
    for (uint32_t i = 0; i < vertices; i++) {
        for (uint32_t a = 0; a < 3; a++) {
            const uint32_t order = plt_float_order(vertex[i].word[a]);
            good &= order - range[0].least <= range[0].span;
        }
    }
    return good;
}
