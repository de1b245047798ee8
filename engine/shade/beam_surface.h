/* beam_surface - what the colours of a triangle's pixels have in common
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_BEAM_SURFACE_H
#define PLT_SHADE_BEAM_SURFACE_H

#include "engine/shade/beam.h"
#include "engine/shade/surface.h"

/* The triangle that was shaded last. */
typedef struct shaded {
    uint32_t record, id;
    plt_surface surface;
} shaded;

static inline void set_shaded(shaded *s, const plt_record *records, uint32_t record) {
    float corner[3][3], normal[3];
    plt_record_corners(&records[record], corner);
    plt_hit_normal((const float(*)[3])corner, normal);
    plt_surface_set(&s->surface, normal);
    s->record = record;
    s->id = plt_primitive_id(plt_get_u32(&records[record].word[9]));
}

#endif
