/* checks - see checks.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/thesis/checks.h"

#include "engine/planelet_crc32.h"

/* With the lowest or the highest eight bits of the checksum one wrong bit of the 256 might not be
 * seen. */
enum { NODE_CHECK_SHIFT = 16 };

uint8_t plt_node_check(const plt_node *node) {
    return (uint8_t)(plt_crc32(0, node, sizeof *node) >> NODE_CHECK_SHIFT);
}

uint16_t plt_page_check(const plt_record *page, uint16_t *held) {
    uint32_t crc = 0, bits = 0;
    for (uint32_t i = 0; i < PLT_PAGE_RECORDS; i++) {
        const uint32_t word = plt_get_u32(&page[i].word[9]);
        plt_record without = page[i];
        plt_put_u32(&without.word[9], word & ~PLT_PRIMITIVE_UNUSED);
        crc = plt_crc32(crc, &without, sizeof without);
        bits |= (word >> PLT_PRIMITIVE_UNUSED_SHIFT & 3u) << 2 * i;
    }
    *held = (uint16_t)bits;
    return (uint16_t)(crc ^ crc >> 16);
}
