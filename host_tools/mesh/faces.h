/* faces - from the file's vertex indices to triangles of the mesh
 *
 * SPDX-License-Identifier: MIT */
#ifndef FACES_H
#define FACES_H
#include "host_tools/mesh/intake.h"

/* Triangulates faces of more than three corners as their outlines demand, drops faces with a
 * corner that is bad or missing, and makes the rest name vertices of the mesh. Triangles keep
 * the order of the file. -1 when memory is out. */
int faces_resolve(intake *in);

#endif
