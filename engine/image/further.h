/* further - sections behind those of tree and triangles: what hits are shaded by
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_IMAGE_FURTHER_H
#define PLT_IMAGE_FURTHER_H

#include "engine/image/header.h"

#if PLT_WITH_FURTHER

enum { PLT_FURTHER_HEAD = 16, PLT_FURTHER_ENTRY = 16 };

/* Bytes of the table of so many, padding included. */
static inline uint32_t plt_further_table_bytes(uint32_t count) {
    return (PLT_FURTHER_HEAD + count * PLT_FURTHER_ENTRY + PLT_SECTION_ALIGN - 1) &
           ~(PLT_SECTION_ALIGN - 1u);
}

/* The check of such a table: its CRC-32 from byte 4 on. */
uint32_t plt_further_check(const unsigned char *table, uint32_t bytes);

/* After plt_header_read: reads the table, if there is one, and checks it (R17). Fills in `further`,
 * and the bytes that the info has of each. */
int plt_further_read(const plt_source *source, plt_header *header, plt_fault *fault);

/* NULL: the image has none of that kind. */
const plt_section *plt_further_section(const plt_header *header, uint32_t kind);

/* Sets *bytes to where the section lies in a mapped image, or to `room`, which it is copied to.
 * PLT_OK, PLT_ERR_SOURCE, or PLT_ERR_IMAGE: R13. */
int plt_further_load(const plt_source *source, const plt_section *section, unsigned char *room,
                     const unsigned char **bytes, plt_fault *fault);

/* What fills a section up behind `used` bytes of it is less than PLT_SECTION_ALIGN, and 0. */
int plt_further_is_full(const plt_section *section, const unsigned char *bytes, uint64_t used);

#endif
#endif
