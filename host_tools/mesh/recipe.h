/* recipe - a scene put together from meshes, one per line
 *
 * SPDX-License-Identifier: MIT */
#ifndef RECIPE_H
#define RECIPE_H
#include "host_tools/base/input.h"
#include "host_tools/mesh/mesh.h"

/* Appends the meshes of the recipe in `in` to `m`, of sequences their frame `frame`; the
 * contract is that of readers.h. */
int recipe_read(mesh *m, const input *in, unsigned frame, mesh_report *report, fail *f);

#endif
