/* mesh_single - one mesh of one file: the reader for it by content, then by name
 *
 * Below recipes, which are made of single meshes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_SINGLE_H
#define MESH_SINGLE_H
#include "host_tools/base/input.h"
#include "host_tools/mesh/mesh.h"

/* Reads the bytes of `path`; "-" is standard input, and then named so. `in` is for
 * input_free. */
int mesh_open(input *in, const char *path, fail *f);

/* A `.txt` that is no mesh. */
int mesh_is_recipe(const input *in);

/* Appends the PLY, OBJ or STL in `in` to `m`. */
int mesh_read_bytes(mesh *m, const input *in, mesh_report *report, fail *f);

/* Both for a file that must not be a recipe. */
int mesh_read_single(mesh *m, const char *path, mesh_report *report, fail *f);

#endif
