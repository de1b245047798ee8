/* materials_room - see materials_room.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/materials_room.h"

#include "engine/image/further.h"

#if PLT_WITH_MATERIALS

int plt_materials_room_set(const plt_engine *e, const plt_header *h,
                           void *const part[PLT_PARTS_COUNT], plt_materials *to, plt_fault *fault) {
    const plt_section *s = plt_further_section(h, PLT_SECTION_MATERIALS);
    const unsigned char *bytes;
    if (s == NULL) {
        return PLT_OK;
    }
    const int status = plt_further_load(&e->source, s, part[PLT_PART_MATERIALS], &bytes, fault);
    return status != PLT_OK ? status
                            : plt_materials_read(to, bytes, s->bytes, h->info.source_triangles,
                                                 s->offset, fault);
}

#endif
