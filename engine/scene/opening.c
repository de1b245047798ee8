/* opening - see opening.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/opening.h"

#include "engine/base/crc32_long.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/planelet_crc32.h"

int plt_opening_arena_error(const plt_opening *o) {
    return plt_arena_short(o->fault, 0);
}

void *plt_opening_cut(const plt_opening *o, enum plt_part part) {
    return plt_arena_cut(o->arena, o->layout->bytes[part]);
}

/* More scratch makes sums no faster. */
enum { SCRATCH_WORDS_MOST = 4096 };

/* What is free of the arena is scratch: what runs will be cut from it. */
static uint32_t crc_of(const plt_opening *o, const void *bytes, size_t count) {
    const plt_arena *a = o->arena;
    const size_t words = (a->bytes - a->used) / 4;
    return plt_crc32_long(bytes, count, (uint32_t *)(void *)(a->base + a->used),
                          words < SCRATCH_WORDS_MOST ? words : SCRATCH_WORDS_MOST);
}

static int check_sum(const plt_opening *o, const plt_section *s, const void *bytes) {
    return crc_of(o, bytes, s->bytes) == s->crc
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

#if PLT_WITH_VERTICES
int plt_opening_mapped(const plt_opening *o, const plt_section *s, const void **bytes) {
    *bytes = (const unsigned char *)o->source->mapped + s->offset;
    return check_sum(o, s, *bytes);
}
#endif

int plt_opening_section(const plt_opening *o, const plt_section *s, const void **bytes) {
    if (o->source->mapped != NULL && !(PLT_WITH_MOTION && o->movable)) {
        *bytes = (const unsigned char *)o->source->mapped + s->offset;
        return check_sum(o, s, *bytes);
    }
    void *copy = NULL;
    const int status = plt_opening_copy(o, s, &copy);
    *bytes = copy;
    return status;
}
