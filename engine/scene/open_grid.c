/* open_grid - scenes of float records, whatever tree is over them; cells come later (open.c)
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/open_formats.h"
#include "engine/tree/validate_records.h"

#if PLT_WITH_GRID

int plt_open_grid(const plt_opening *o, const plt_header *header,
                  struct plt_compact_build **build) {
    (void)build;
    const void *bytes = NULL;
    int status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_TRIANGLES), &bytes);
    const plt_record *records = bytes;
    if (status == PLT_OK) {
        status = plt_records_validate(header, records, o->fault);
    }
    o->scene->gridded.records = records;
    o->scene->gridded.count = header->info.triangles;
    return status;
}

#endif
