/* validate_records - see validate_records.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/validate_records.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/tree/record_ranges.h"

PLT_INLINED int validate(const plt_header *header, const plt_record *records, uint32_t first,
                         uint32_t count, plt_fault *fault) {
    const uint32_t triangles = header->info.triangles;
    const uint32_t offset =
        plt_header_section(header, PLT_SECTION_TRIANGLES)->offset + first * PLT_RECORD_BYTES;
    plt_between box[3];
    plt_between_set(box, header->info.lo, header->info.hi);
    for (const plt_record *r = records, *end = records + count; r < end; r++) {
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

int plt_records_validate(const plt_header *header, const plt_record *records, plt_fault *fault) {
    return validate(header, records, 0, header->info.triangles, fault);
}

#if PLT_WITH_VERTICES
int plt_records_validate_some(const plt_header *header, const plt_record *records, uint32_t first,
                              uint32_t count, plt_fault *fault) {
    return validate(header, records, first, count, fault);
}
#endif
