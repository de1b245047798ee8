/* opening - see opening.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/opening.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/planelet_crc32.h"

int plt_opening_arena_error(const plt_opening *o) {
    return plt_arena_short(o->fault, 0);
}

void *plt_opening_cut(const plt_opening *o, enum plt_part part) {
    const uint64_t bytes = o->layout->bytes[part];
    return bytes > SIZE_MAX ? NULL : plt_arena_cut(o->arena, (size_t)bytes);
}

static int check_sum(const plt_opening *o, const plt_section *s, const void *bytes) {
    return plt_crc32(0, bytes, s->bytes) == s->crc
               ? PLT_OK
               : plt_refused(o->fault, PLT_R13_SECTION_CRC, s->offset,
                             "a section is damaged (checksum)");
}

int plt_opening_copy(const plt_opening *o, const plt_section *s, void **bytes) {
    *bytes = plt_arena_cut(o->arena, s->bytes);
    if (*bytes == NULL) {
        return plt_opening_arena_error(o);
    }
    const int status = plt_fetch(o->source, s->offset, *bytes, s->bytes, o->fault);
    return status == PLT_OK ? check_sum(o, s, *bytes) : status;
}

int plt_opening_section(const plt_opening *o, const plt_section *s, const void **bytes) {
    if (o->source->mapped != NULL) {
        *bytes = (const unsigned char *)o->source->mapped + s->offset;
        return check_sum(o, s, *bytes);
    }
    void *copy = NULL;
    const int status = plt_opening_copy(o, s, &copy);
    *bytes = copy;
    return status;
}
