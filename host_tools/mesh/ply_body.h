/* ply_body - whether the body of a binary PLY can be of the types in its header
 *
 * Some programs write colours as floats under a header that says uchar.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLY_BODY_H
#define PLY_BODY_H
#include "host_tools/mesh/ply_header.h"

/* Fails when the file has just the size that it would have if all properties of one byte were
 * floats, or all floats doubles, and its faces triangles or quads. For a file that has failed
 * already, or has bytes behind the data: others may have such a size by chance. */
int ply_body_check(const ply_header *h, const input *in, fail *f);

#endif
