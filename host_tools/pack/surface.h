/* surface - adds normals, colours and texture coordinates to a finished image (SPEC.md, 4.18, 4.19,
 * 4.21)
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_H
#define SURFACE_H
#include "host_tools/mesh/corners.h"
#include "host_tools/pack/pack.h"
#include "host_tools/pack/surface_stats.h"

/* Of an image without a sequence or instances, if compact with build host and primitive ids. `c` is
 * by primitive id; what it does not have the image does not get. -1, and the image with less than
 * all of it: memory is out, or it gets too large. */
int surface_add(packed *image, const mesh_corners *c, const char *name, surface_stats *stats,
                fail *f);

#endif
