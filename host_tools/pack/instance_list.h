/* instance_list - a text that says which meshes are bodies, and where instances of them are
 *
 *     body NAME MESH                    # a mesh in its own coordinates
 *     instance NAME BODY
 *     frame K INSTANCE AX AY AZ A  BX BY BZ B  CX CY CZ C
 *
 * The matrix has three rows: x' = AX x + AY y + AZ z + A, and so on. MESH is relative to the text,
 * names have no blanks. Frames count from 0 without gaps; an instance that a frame does not name
 * stays where it was, and is where its body is before the first. `frame K` alone moves nothing.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_INSTANCE_LIST_H
#define PACK_INSTANCE_LIST_H
#include "engine/instances/placed.h"
#include "host_tools/base/input.h"

typedef struct instance_name {
    const char *text; /* in the input, without a zero byte after it */
    size_t length;
    size_t line;
} instance_name;

/* A line that gives a matrix. */
typedef struct instance_setting {
    uint32_t frame, instance;
    size_t line;
    float matrix[PLT_MATRIX_FLOATS];
} instance_setting;

typedef struct instance_list {
    input in;
    instance_name *body, *mesh; /* by body; owned */
    instance_name *instance;    /* owned */
    uint32_t *body_of;          /* by instance; owned */
    instance_setting *setting;  /* by frame; owned */
    uint32_t bodies, instances;
    size_t settings;
    uint32_t frames; /* at least 1 */
    size_t room[3];  /* of bodies, instances, settings */
} instance_list;

/* Reads the text; "-" is standard input. Whatever happens, the list is to be freed. */
int instance_list_read(instance_list *l, const char *path, fail *f);

/* The path of a body's mesh: from base/heap.h, NULL when memory is out. */
char *instance_list_mesh(const instance_list *l, uint32_t body);

void instance_list_free(instance_list *l);

#endif
