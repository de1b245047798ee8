/* validate_records - see validate_records.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/validate_records.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"

/* False for NaN. */
static int is_inside(const plt_info *info, int axis, float x) {
    return x >= info->lo[axis] && x <= info->hi[axis];
}

int plt_records_validate(const plt_header *header, const plt_record *records, plt_fault *fault) {
    const plt_info *info = &header->info;
    const plt_section *section = plt_header_section(header, PLT_SECTION_TRIANGLES);
    for (uint32_t i = 0; i < info->triangles; i++) {
        const uint32_t at = section->offset + i * PLT_RECORD_BYTES;
        for (int k = 0; k < 9; k++) {
            if (!is_inside(info, k % 3, plt_get_float(&records[i].word[k]))) {
                return plt_broken(fault, PLT_I5_CORNERS, at + 4 * (uint32_t)k,
                                  "a corner lies outside the scene's box");
            }
        }
        const uint32_t word = plt_get_u32(&records[i].word[9]);
        if (plt_primitive_id(word) >= info->triangles || plt_primitive_rotation(word) > 2 ||
            (word & PLT_PRIMITIVE_UNUSED) != 0) {
            return plt_broken(fault, PLT_I7_ID_WORDS, at + 36,
                              "a triangle's id word is out of range");
        }
    }
    return PLT_OK;
}
