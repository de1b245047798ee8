/* ply_header - what a PLY file says it holds
 *
 * Keeps: every element's properties lie in `property`; element names are
 * distinct, and so are the property names of an element.
 *
 * Source: G. Turk, The PLY Polygon File Format, 1994.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLY_HEADER_H
#define PLY_HEADER_H
#include "host_tools/base/input.h"
#include "host_tools/mesh/scan.h"

enum { PLY_ELEMENTS_MAX = 32, PLY_PROPERTIES_MAX = 1024 };

typedef enum ply_type {
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_INT64,
    PLY_UINT64,
    PLY_FLOAT32,
    PLY_FLOAT64,
} ply_type;

typedef enum ply_format { PLY_NO_FORMAT, PLY_ASCII, PLY_LITTLE, PLY_BIG } ply_format;

typedef struct ply_property {
    word name;
    ply_type type; /* of the value, or of a list's values */
    ply_type count_type;
    int is_list;
} ply_property;

typedef struct ply_element {
    word name;
    uint64_t count;
    size_t line;
    ply_property *property;
    size_t properties;
} ply_element;

typedef struct ply_header {
    ply_format format;
    ply_element element[PLY_ELEMENTS_MAX];
    size_t elements;
    ply_property property[PLY_PROPERTIES_MAX];
    size_t properties;
    size_t unknown_lines;
    scan data; /* begins after the header */
} ply_header;

size_t ply_type_bytes(ply_type type);

/* `h` keeps pointing into `in->bytes`. Refuses counts for which the bytes
 * after the header are too few. */
int ply_header_read(ply_header *h, const input *in, fail *f);

#endif
