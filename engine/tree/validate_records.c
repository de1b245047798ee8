/* validate_records - see validate_records.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/validate_records.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/tree/record_ranges.h"

int plt_records_validate(const plt_header *header, const plt_record *records, plt_fault *fault) {
    const uint32_t triangles = header->info.triangles;
    const uint32_t offset = plt_header_section(header, PLT_SECTION_TRIANGLES)->offset;
    plt_between box[3];
    plt_between_set(box, header->info.lo, header->info.hi);
    for (const plt_record *r = records, *end = records + triangles; r < end; r++) {
        const uint32_t *word = plt_record_outside(box, r);
        if (word != NULL) {
            return plt_broken(fault, PLT_I5_CORNERS, offset + 4 * (uint32_t)(word - records->word),
                              "a corner lies outside the scene's box");
        }
        if (!plt_is_id_word(plt_get_u32(&r->word[9]), triangles, header->info.has_checks)) {
            return plt_broken(fault, PLT_I7_ID_WORDS,
                              offset + 4 * (uint32_t)(&r->word[9] - records->word),
                              "a triangle's id word is out of range");
        }
    }
    return PLT_OK;
}
