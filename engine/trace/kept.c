/* kept - see kept.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/kept.h"

#if PLT_WITH_PAGES

#include "engine/tree/compact/block_record.h"

void plt_kept_init(plt_kept *kept, uint32_t rays) {
    for (uint32_t i = 0; i < rays; i++) {
        plt_put_u32(&kept[i].record.word[9], PLT_PRIMITIVE_ID_MASK); /* no id is that large */
        kept[i].index = 0;
    }
}

#if PLT_WITH_GROUPS

/* The first ray from `ray` on whose hit is of another triangle than what it keeps; rays of groups
 * that are not in the mask are passed. `end`: there is none. */
static uint32_t next_new(const plt_kept *kept, const plt_packet *p, plt_mask groups, uint32_t ray,
                         uint32_t end) {
    for (; ray < end; ray++) {
        const uint32_t id = p->rays[ray / 4].id[ray % 4];
        if ((groups >> ray / 4 & 1u) != 0 && id != PLT_MISS &&
            id != plt_primitive_id(plt_get_u32(&kept[ray].record.word[9]))) {
            return ray;
        }
    }
    return end;
}

void plt_keep_records(plt_kept *kept, const plt_packet *p, const plt_record *records,
                      uint32_t index, uint32_t count, plt_mask groups) {
    const uint32_t end = 4 * (plt_mask_last(groups) + 1);
    for (uint32_t k = next_new(kept, p, groups, 0, end); k < end;
         k = next_new(kept, p, groups, k + 1, end)) {
        const uint32_t id = p->rays[k / 4].id[k % 4];
        for (uint32_t i = 0; i < count; i++) {
            if (plt_primitive_id(plt_get_u32(&records[i].word[9])) == id) {
                kept[k].record = records[i];
                kept[k].index = index + i;
                break;
            }
        }
    }
}

#if PLT_WITH_COMPACT
static uint32_t word_of(const plt_block_tree *tree, uint32_t index) {
    return plt_primitive_word_find(tree->ids.bytes != NULL ? &tree->ids : NULL, index);
}

void plt_keep_strips(plt_kept *kept, const plt_packet *p, const plt_block_tree *tree,
                     const plt_geometry *g, const plt_leaf_run *run, plt_mask groups) {
    const uint32_t end = 4 * (plt_mask_last(groups) + 1), first = g->first_triangle + run->first;
    plt_leaf leaf;
    uint32_t k = next_new(kept, p, groups, 0, end);
    if (k < end) {
        plt_leaf_read(g, run->first, run->count, &leaf);
    }
    for (; k < end; k = next_new(kept, p, groups, k + 1, end)) {
        const uint32_t id = p->rays[k / 4].id[k % 4];
        for (uint32_t i = 0; i < run->count; i++) {
            const uint32_t word = word_of(tree, first + i);
            if (plt_primitive_id(word) == id) {
                plt_leaf_record(&tree->lattice, &leaf, i, &kept[k].record);
                plt_put_u32(&kept[k].record.word[9], word);
                kept[k].index = first + i;
                break;
            }
        }
    }
}
#endif

#endif
#endif
