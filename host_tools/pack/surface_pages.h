/* surface_pages - adds normals and colours to a finished image, page by page (SPEC.md, 4.21)
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_PAGES_H
#define SURFACE_PAGES_H
#include "host_tools/pack/surface.h"

/* As surface_add, instead of it; further sections that the image has are of lower kinds. */
int surface_pages_add(packed *image, const mesh_corners *c, const char *name, surface_stats *stats,
                      fail *f);

#endif
