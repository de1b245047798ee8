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

#if PLT_WITH_MIXES
/* Apart: one for all, as what makes it fast is long. */
void plt_shaded_set(shaded *s, const plt_record *records, uint32_t record);
#endif

#endif
