/* mtl_map - a line of a Wavefront library that names a picture
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_MTL_MAP_H
#define MESH_MTL_MAP_H
#include "host_tools/mesh/materials.h"
#include "host_tools/mesh/scan.h"

/* A line whose first word is `key` names a picture: 0: it does not. What we have no use for is
 * kept in m->maps_left. */
int mtl_map_is(mesh_materials *m, word key);

/* The rest of a line of map_Kd: options, and a file beside `path`, the library. 1, or 0: there is
 * no file's name. -1: memory is out. */
int mtl_map_read(mesh_materials *m, material_map *to, scan *text, const char *path);

#endif
