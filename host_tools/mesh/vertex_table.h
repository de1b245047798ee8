/* vertex_table - finds the vertex that has the same bits
 *
 * Only equal bits are the same, of the numbers as the file has them: 0 and -0 stay apart, and
 * so do positions that are merely close. Expected cost: one probe or two.
 *
 * SPDX-License-Identifier: MIT */
#ifndef VERTEX_TABLE_H
#define VERTEX_TABLE_H
#include "host_tools/mesh/mesh.h"

typedef struct vertex_table {
    const mesh *m;
    uint32_t *slot; /* vertex index + 1 in `m`; 0: free */
    size_t slots;   /* 0 or a power of 2, at least twice `used` */
    size_t used;
} vertex_table;

/* The slot of the vertex with these bits: it holds that vertex's index + 1,
 * or 0, and then the caller stores one and counts it in `used`. NULL when
 * memory is out. The slot stays until the next call. */
uint32_t *vertex_table_find(vertex_table *t, const real position[3]);
void vertex_table_free(vertex_table *t);

#endif
