/* ply_attributes - what a PLY element holds beside positions and corners, as counts
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLY_ATTRIBUTES_H
#define PLY_ATTRIBUTES_H
#include "host_tools/mesh/ply_header.h"
#include "host_tools/mesh/report.h"

/* Adds the colours, normals, texture coordinates, materials and lines of all items of `e`. */
void ply_count_attributes(const ply_element *e, uint64_t count[REPORT_ITEMS]);

#endif
