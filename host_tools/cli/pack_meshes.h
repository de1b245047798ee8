/* pack_meshes - from the files of a pack command to one mesh, and a word about all that is lost
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_MESHES_H
#define PACK_MESHES_H
#include "host_tools/cli/pack_file.h"

typedef struct pack_meshes {
    /* Asked for. */
    unsigned frame; /* of a recipe's sequences */
    int has_frame;  /* a later one was asked for, so there must be one */
    int repair;
    int centre;      /* move the middle of the box to 0; else `shift` is subtracted */
    double shift[3]; /* what is subtracted, in the end */
    double weld;     /* vertices as near as this become one; 0: none */
    size_t most;     /* triangles; 0: any number */
    /* Made of it; freed by pack_meshes_free. */
    mesh m;
    pack_file *file;
    size_t *mesh_end; /* first triangle after each file; NULL when there are fewer triangles now */
    int files;
    size_t triangles; /* of the mesh that is packed, whose arrays may be gone by then */
} pack_meshes;

/* Reads the files and moves them as asked for. Fails when there is nothing to trace. */
int pack_meshes_read(pack_meshes *p, char **path, int files, fail *f);

/* Then welds, looks for open edges and reduces, as asked for. Where --memory does not suffice
 * for the edges, the files say so. Fails when nothing is left to trace. */
int pack_meshes_prepare(pack_meshes *p, fail *f);

/* Says on standard error what was lost on the way: one line each. For a pack that succeeded:
 * a failure has one line of its own. */
void pack_meshes_say(const pack_meshes *p);
void pack_meshes_free(pack_meshes *p);

#endif
