/* record_ranges - is what a record holds in range?
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_RECORD_RANGES_H
#define PLT_TREE_RECORD_RANGES_H

#include "engine/base/between.h"
#include "engine/lanes/unroll.h"
#include "engine/tree/record.h"

/* Of the corners of a record the first word that lies outside the scene's box, or NULL. */
static inline const uint32_t *plt_record_outside(const plt_between box[3],
                                                 const plt_record *record) {
    PLT_UNROLLED for (uint32_t k = 0; k < 9; k += 3) {
        PLT_UNROLLED for (uint32_t a = 0; a < 3; a++) {
            if (!plt_is_between(&box[a], &record->word[k + a])) {
                return &record->word[k + a];
            }
        }
    }
    return NULL;
}

/* An id below `triangles`, which is at most 2^27, no unused bit, unless those hold checks, and a
 * rotation of 0, 1 or 2. */
static inline int plt_is_id_word(uint32_t word, uint32_t triangles, int has_checks) {
    const uint32_t unused = has_checks ? 0 : PLT_PRIMITIVE_UNUSED;
    return (word & (unused | PLT_PRIMITIVE_ID_MASK)) < triangles &&
           plt_primitive_rotation(word) <= 2;
}

#endif
