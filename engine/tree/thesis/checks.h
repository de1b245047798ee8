/* checks - of thesis nodes and of float records, which may come part by part
 *
 * A treelet may begin in any slot, and is fetched up to where it is not known to end. So nodes have
 * a check of 8 bits each, in a section of their own. Records are fetched by pages, whose check of
 * 16 bits lies in two bits of each id word that are unused otherwise (primitive_id.h): it takes no
 * bytes and no transfer. Scenes that are read whole are checked by the CRC of each section alone.
 *
 * Both are bits of the CRC-32, chosen so that one wrong bit is always noticed (test_tree_node), and
 * others but for one in 2^8 or 2^16. SPEC.md, section 4.14.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_CHECKS_H
#define PLT_TREE_THESIS_CHECKS_H

#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"

/* The check of a node. */
uint8_t plt_node_check(const plt_node *node);

/* That of PLT_PAGE_RECORDS records, and in *held the one that they hold. */
uint16_t plt_page_check(const plt_record *page, uint16_t *held);

/* Record `i` of a page holds these bits of its check. */
static inline uint32_t plt_page_check_bits(uint32_t check, uint32_t i) {
    return (check >> 2 * i & 3u) << PLT_PRIMITIVE_UNUSED_SHIFT;
}

#endif
