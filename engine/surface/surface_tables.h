/* surface_tables - what corners have: by position, and where that does not tell, by triangle
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SURFACE_SURFACE_TABLES_H
#define PLT_SURFACE_SURFACE_TABLES_H

#include "engine/base/bytes.h"
#include "engine/image/header.h"
#include "engine/surface/retrieval.h"

#if PLT_WITH_SURFACE

typedef struct plt_surface_tables {
    plt_retrieval position, corner;
} plt_surface_tables;

/* Bytes of the entries of both, as the first 16 bytes of a section say. */
static inline uint64_t plt_surface_tables_bytes(const unsigned char *head, uint32_t bits) {
    return plt_retrieval_bytes(plt_get_u32(head + 4), bits) +
           plt_retrieval_bytes(plt_get_u32(head + 12), bits);
}

/* Both, one behind the other from `entries` on, which are all there. */
static inline void plt_surface_tables_set(plt_surface_tables *t, const unsigned char *head,
                                          const unsigned char *entries, uint32_t bits) {
    t->position.seed = plt_get_u32(head);
    t->position.third = plt_get_u32(head + 4);
    t->corner.seed = plt_get_u32(head + 8);
    t->corner.third = plt_get_u32(head + 12);
    t->position.entry = entries;
    t->corner.entry = entries + plt_retrieval_bytes(t->position.third, bits);
}

/* Whether so many bytes, with padding, are all of a section. */
static inline int plt_surface_fills(const plt_section *s, uint64_t used) {
    return used <= s->bytes && s->bytes - used < PLT_SECTION_ALIGN;
}

/* The value of a corner, of 1 to 32 bits; `split` says that its position does not tell, or that
 * nothing does. */
uint32_t plt_surface_value(const plt_surface_tables *t, uint32_t bits, uint32_t split,
                           const uint32_t key[3], const uint32_t corner_key[3]);

#endif
#endif
