/* mtl - a Wavefront library of materials
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_MTL_H
#define MESH_MTL_H
#include "host_tools/base/input.h"
#include "host_tools/mesh/materials.h"

/* Reads a library; lines that are wrong are troubles. -1: memory is out. */
int mtl_read(mesh_materials *m, const input *in);

/* Reads libraries whose names stand in the file `path`, beside it, with blanks between; all of it
 * is one name if there is such a file. One that cannot be read is a trouble. -1: memory is out. */
int mtl_read_beside(mesh_materials *m, const char *path, const char *names, size_t length);

#endif
