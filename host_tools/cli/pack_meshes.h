/* pack_meshes - from the files of a pack command to one mesh, and a word about all that is lost
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_MESHES_H
#define PACK_MESHES_H
#include "host_tools/mesh/mesh.h"
#include "host_tools/mesh/precision.h"
#include "host_tools/mesh/weld_near.h"

/* What became of one file. */
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
    uint64_t without_area; /* triangles */
} pack_file;

typedef struct pack_meshes {
    /* Asked for. */
    unsigned frame; /* of a recipe's sequences */
    int repair;
    int centre;      /* move the middle of the box to 0; else `shift` is subtracted */
    double shift[3]; /* what is subtracted, in the end */
    double weld;     /* vertices as near as this become one; 0: none */
    size_t most;     /* triangles; 0: any number */
    /* Made of it; freed by pack_meshes_free. */
    mesh m;
    pack_file *file;
    size_t *mesh_end; /* first triangle after each file; NULL when reduced */
    int files;
} pack_meshes;

/* Reads the files, moves, welds and reduces as asked for. Fails when nothing is left to
 * trace. */
int pack_meshes_read(pack_meshes *p, char **path, int files, fail *f);

/* Says on standard error what was lost on the way: one line each. For a pack that succeeded:
 * a failure has one line of its own. */
void pack_meshes_say(const pack_meshes *p);
void pack_meshes_free(pack_meshes *p);

#endif
