/* checks - see checks.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/checks.h"

#include "engine/tree/compact/leaf.h"
#include "engine/tree/thesis/checks.h"

void checks_put_records(plt_record *record, uint32_t records) {
    for (plt_record *page = record; page < record + records; page += PLT_PAGE_RECORDS) {
        uint16_t none;
        const uint32_t check = plt_page_check(page, &none);
        for (uint32_t i = 0; i < PLT_PAGE_RECORDS; i++) {
            const uint32_t word = plt_get_u32(&page[i].word[9]) & ~PLT_PRIMITIVE_UNUSED;
            plt_put_u32(&page[i].word[9], word | plt_page_check_bits(check, i));
        }
    }
}

void checks_put_nodes(unsigned char *to, const plt_node *node, uint32_t nodes) {
    for (uint32_t i = 0; i < nodes; i++) {
        to[i] = plt_node_check(&node[i]);
    }
}

/* Of the block that is open, whose geometry part is at `part`. */
static void put_block_check(unsigned char *part, const plt_block *block, const unsigned char *ids,
                            const plt_info *info) {
    plt_geometry g;
    plt_geometry_open_counts(&g, block, info->leaf_triangles);
    const uint64_t begin = (uint64_t)g.first_triangle * info->primitive_id_bits / 8;
    const uint64_t end =
        (((uint64_t)g.first_triangle + g.triangles) * info->primitive_id_bits + 7) / 8;
    const uint32_t check = plt_block_ids_check(ids + begin, (uint32_t)(end - begin));
    unsigned char *tail = part + block->geometry_bytes - PLT_IDS_CHECK_BYTES;
    tail[0] = (unsigned char)check;
    tail[1] = (unsigned char)(check >> 8);
    const uint32_t word = plt_get_u32(part + 4) & 0xFFFFu;
    plt_put_u32(part + 4, word | (uint32_t)plt_block_check(part, block->geometry_bytes, 6) << 16);
}

void checks_put_ids(unsigned char *blocks, const unsigned char *ids, const plt_header *header) {
    const plt_info *info = &header->info;
    const uint32_t used = info->node_bytes + info->triangle_bytes;
    for (uint32_t at = 0; at < used;) {
        plt_block block;
        plt_block_open(&block, blocks + at, info->lattice_bits);
        if (block.geometry_bytes > 0) {
            put_block_check(blocks + at + block.node_bytes, &block, ids, info);
        }
        at += plt_block_bytes(&block);
    }
}
