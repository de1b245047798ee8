/* ply_value - single values of a PLY file, of any type and format
 *
 * All functions return 0, or -1 with a failure at the element being read.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLY_VALUE_H
#define PLY_VALUE_H
#include "host_tools/mesh/intake.h"
#include "host_tools/mesh/ply_header.h"

typedef struct ply_reader {
    const ply_header *header;
    const unsigned char *bytes; /* of the whole file */
    scan data;                  /* what is still to be read */
    size_t short_line;          /* ASCII: the first that ends inside a vertex */
    uint64_t short_vertices;    /* and how many vertices go on in another line */
    intake in;
} ply_reader;

int ply_coordinate(ply_reader *r, ply_type type, real *value);

/* INTAKE_MISSING for a float that is not whole: lists of vertex numbers
 * may be of any type. */
int ply_integer(ply_reader *r, ply_type type, int64_t *value);

/* The count of a list, which the bytes that follow can hold. */
int ply_count(ply_reader *r, const ply_property *p, uint64_t *count);

int ply_skip(ply_reader *r, const ply_property *p);

#endif
