/* surface_pages - adds normals, colours and texture coordinates to a finished image, page by page
 * (SPEC.md, 4.23)
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_PAGES_H
#define SURFACE_PAGES_H
#include "host_tools/pack/surface.h"

/* As surface_add. `shift`: a page has 2^shift triangles at most, 6 .. 12; fewer where it would be
 * too large. */
enum { SURFACE_PAGES_USUAL = 11 };
int surface_pages_add(packed *image, const mesh_corners *c, uint32_t shift, const char *name,
                      surface_stats *stats, fail *f);

#endif
