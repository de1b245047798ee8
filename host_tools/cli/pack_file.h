/* pack_file - what pack knows of one of its files
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_FILE_H
#define PACK_FILE_H
#include "host_tools/mesh/mesh.h"
#include "host_tools/mesh/precision.h"
#include "host_tools/mesh/weld_near.h"

typedef struct pack_file {
    const char *path;
    size_t first, end; /* its triangles */
    size_t vertices;
    mesh_report report;
    precision moved;  /* by single precision */
    int centre_helps; /* --centre would move nothing that matters */
    weld_near_result welded;
    uint64_t open_edges, open_left; /* left: with this distance welded; 0: none helps */
    double open_distance;
    int edges_unknown;     /* memory for them was not given */
    uint64_t without_area; /* triangles */
} pack_file;

#endif
