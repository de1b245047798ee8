/* validate_records - see validate_records.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/validate_records.h"

#include "engine/base/between.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/lanes/unroll.h"

/* Of the corners of a record the first word that lies outside the scene's box, or NULL. */
static inline const uint32_t *outside(const plt_between box[3], const plt_record *record) {
    PLT_UNROLLED for (uint32_t k = 0; k < 9; k += 3) {
        PLT_UNROLLED for (uint32_t a = 0; a < 3; a++) {
            if (!plt_is_between(&box[a], &record->word[k + a])) {
                return &record->word[k + a];
            }
        }
    }
    return NULL;
}

/* An id below `triangles`, which is at most 2^27, no unused bit, and a rotation of 0, 1 or 2. */
static inline int is_id_word(uint32_t word, uint32_t triangles) {
    return (word & (PLT_PRIMITIVE_UNUSED | PLT_PRIMITIVE_ID_MASK)) < triangles &&
           plt_primitive_rotation(word) <= 2;
}

int plt_records_validate(const plt_header *header, const plt_record *records, plt_fault *fault) {
    const uint32_t triangles = header->info.triangles;
    const uint32_t offset = plt_header_section(header, PLT_SECTION_TRIANGLES)->offset;
    plt_between box[3];
    plt_between_set(box, header->info.lo, header->info.hi);
    for (const plt_record *r = records, *end = records + triangles; r < end; r++) {
        const uint32_t *word = outside(box, r);
        if (word != NULL) {
            return plt_broken(fault, PLT_I5_CORNERS, offset + 4 * (uint32_t)(word - records->word),
                              "a corner lies outside the scene's box");
        }
        if (!is_id_word(plt_get_u32(&r->word[9]), triangles)) {
            return plt_broken(fault, PLT_I7_ID_WORDS,
                              offset + 4 * (uint32_t)(&r->word[9] - records->word),
                              "a triangle's id word is out of range");
        }
    }
    return PLT_OK;
}
