/* beam_store - triangles of compact blocks that pixels may have, as records
 *
 * A record of the store is free unless a pixel has it. They are given out in order, without those
 * that are marked; at the end marks are set anew, on records that a pixel has, and it begins from
 * the front. There are half as many more as pixels, so that this costs little. Marks that are left
 * over from another square, or are what the memory happened to hold, only make it happen sooner.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/lanes/unroll.h"
#include "engine/shade/beam.h"
#include "engine/tree/canonical.h"

/* PLT_RECORD_LAST is the mark, as no list has a record of the store. */
static void mark(plt_beam *b) {
    const plt_pixel *end = b->pixel + b->square.side * b->rows;
    for (uint32_t i = 0; i < plt_beam_store_records(b->square.side); i++) {
        plt_record_set_last(&b->store[i], 0);
    }
    for (const plt_pixel *p = b->pixel; p < end; p++) {
        if (p->record != PLT_MISS) {
            plt_record_set_last(&b->store[plt_pixel_record(p)], 1);
        }
    }
    b->next = 0;
}

static plt_record *free_record(plt_beam *b) {
    const uint32_t records = plt_beam_store_records(b->square.side);
    for (;;) {
        while (b->next < records) {
            plt_record *r = &b->store[b->next++];
            if (!plt_record_is_last(r)) {
                return r;
            }
        }
        mark(b);
    }
}

const plt_record *plt_beam_store(plt_beam *b, const plt_leaf *leaf, uint32_t triangle,
                                 uint32_t index) {
    plt_record *r = free_record(b);
    const uint32_t *position[3];
    uint64_t key[3];
    PLT_UNROLLED for (unsigned c = 0; c < 3; c++) {
        position[c] = leaf->vertex[plt_leaf_corner(leaf, triangle, c)].number;
        key[c] = plt_lattice_key(position[c]);
    }
    uint32_t from = plt_canonical_first(key[1] < key[0], key[2] < key[0], key[2] < key[1]);
    for (unsigned c = 0; c < 3; c++) {
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            plt_put_float(&r->word[3 * c + (unsigned)a],
                          plt_lattice_float(&b->tree->lattice, a, position[from][a]));
        }
        from = from < 2 ? from + 1 : 0;
    }
    const plt_primitive_ids *ids = b->tree->ids.bytes == NULL ? NULL : &b->tree->ids;
    plt_put_u32(&r->word[9], plt_primitive_word_find(ids, index));
    return r;
}
