/* surface_data - see surface_data.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface/surface_data.h"

#if PLT_WITH_SURFACE

#include "engine/base/bytes.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/further.h"

static int refused(const plt_section *s, plt_fault *fault) {
    return plt_refused(fault, PLT_R18_SURFACE, s->offset,
                       "a section of normals or colours is not as large as its tables");
}

static int set_normals(plt_surface_data *d, const plt_section *s, const unsigned char *bytes,
                       plt_fault *fault) {
    if (!plt_surface_fills(s, plt_normals_bytes(bytes))) {
        return refused(s, fault);
    }
    plt_surface_tables_set(&d->normals, bytes, bytes + PLT_NORMALS_HEAD, PLT_NORMAL_BITS);
    d->has_normals = 1;
    return PLT_OK;
}

static int set_colours(plt_surface_data *d, const plt_section *s, const unsigned char *bytes,
                       plt_fault *fault) {
    const uint32_t palette = plt_get_u32(bytes + 16);
    const uint32_t rest =
        plt_get_u32(bytes + 20) | plt_get_u32(bytes + 24) | plt_get_u32(bytes + 28);
    if (palette < 1 || palette > PLT_PALETTE_MOST || rest != 0 ||
        !plt_surface_fills(s, plt_colours_bytes(bytes, palette))) {
        return refused(s, fault);
    }
    d->palette = bytes + PLT_COLOURS_HEAD;
    d->palette_count = palette;
    plt_surface_tables_set(&d->colours, bytes, d->palette + palette * PLT_PALETTE_BYTES,
                           plt_colour_bits(palette));
    d->has_colours = 1;
    return PLT_OK;
}

int plt_surface_data_set(plt_surface_data *d, const plt_header *h, const unsigned char *normals,
                         const unsigned char *colours, plt_fault *fault) {
    int status = PLT_OK;
    d->has_normals = d->has_colours = 0;
    if (normals != NULL) {
        status = set_normals(d, plt_further_section(h, PLT_SECTION_NORMALS), normals, fault);
    }
    if (status == PLT_OK && colours != NULL) {
        status = set_colours(d, plt_further_section(h, PLT_SECTION_COLOURS), colours, fault);
    }
    return status;
}

#endif
