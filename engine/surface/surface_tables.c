/* surface_tables - see surface_tables.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface/surface_tables.h"

#if PLT_WITH_SURFACE

uint32_t plt_surface_value(const plt_surface_tables *t, uint32_t bits, uint32_t split,
                           const uint32_t key[3], const uint32_t corner_key[3]) {
    uint32_t value = split;
    if (t->position.third > 0) {
        value = plt_retrieval_value(&t->position, bits, key);
    }
    if (value == split && t->corner.third > 0) {
        value = plt_retrieval_value(&t->corner, bits, corner_key);
    }
    return value;
}

#endif
