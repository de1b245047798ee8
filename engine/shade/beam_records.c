/* beam_records - the store of a beam: records that pixels have
 *
 * A record of the store is free unless a pixel has it. They are given out in order, without those
 * that are marked; at the end marks are set anew, on records that a pixel has, and it begins from
 * the front. There are half as many more as pixels, so that this costs little. Marks that are left
 * over from another square, or are what the memory happened to hold, only make it happen sooner.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"

#if PLT_BEAMS_STORE

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

plt_record *plt_beam_free_record(plt_beam *b) {
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

#endif
