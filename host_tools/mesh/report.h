/* report - what a mesh file held and the mesh does not, or not as it was written
 *
 * Readers count; whoever asked for the mesh says it, in one line per kind.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_REPORT_H
#define MESH_REPORT_H
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "host_tools/mesh/count_list.h"

typedef enum report_item {
    /* Left out, as nothing traces it. */
    REPORT_SMALL_FACES, /* of fewer than 3 corners */
    REPORT_POINTS,
    REPORT_LINES,
    REPORT_CURVES, /* and free-form surfaces */
    REPORT_COLOURS,
    REPORT_NORMALS,
    REPORT_TEXTURES,     /* texture coordinates */
    REPORT_MATERIALS,    /* uses of one */
    REPORT_ELEMENTS,     /* of PLY, of other names */
    REPORT_UNREAD_LINES, /* of OBJ, of no known keyword or of one that runs something */
    /* Read otherwise than written. */
    REPORT_OVERLAPPING,   /* faces that no triangles fill without overlap */
    REPORT_MISCOUNTED,    /* triangles by which the count of a binary STL is off */
    REPORT_SWAPPED,       /* triangles of a binary STL in big-endian order */
    REPORT_UNENDED,       /* solids of an STL without endsolid */
    REPORT_UNKNOWN_LINES, /* of a PLY header */
    REPORT_LOOSE_BYTES,   /* behind the data */
    /* Dropped because `repair` was asked for. */
    REPORT_BAD_FACES,    /* using a bad vertex or a missing one, or of too few corners */
    REPORT_BAD_VERTICES, /* NaN, infinite or too large: replaced by 0, used by nothing */
    REPORT_BAD_NORMALS,  /* of no length, or not finite; counted if they are wanted */
    REPORT_BAD_COLOURS,  /* out of range; likewise */
    REPORT_BAD_TEXTURES, /* texture coordinates; likewise */
    REPORT_ITEMS,
} report_item;

/* Single precision may move a corner so far, in lengths of its shortest edge, without a word. */
#define REPORT_MOVED_MOST 1e-3

/* Of binary STL whose count of triangles is not what their size holds. */
typedef struct report_miscount {
    uint64_t files, counted, held; /* triangles, of all of them */
} report_miscount;

typedef struct mesh_report {
    int repair;  /* asked for: drop what cannot be traced; else it is refused */
    int centred; /* asked for: recipes place meshes from their wide coordinates */
    uint64_t count[REPORT_ITEMS];
    report_miscount miscount;
    double moved;       /* greatest distance a corner moved in single precision, in lengths of its
                         * shortest edge; of meshes that recipes placed */
    uint64_t vanished;  /* triangles an edge of which lost its length so */
    uint64_t sequences; /* of files that a recipe names, a frame of which was read */
} mesh_report;

void report_add_miscount(mesh_report *r, report_miscount more);

/* The words of the item as a key: "small_faces". */
const char *report_key(report_item item);

/* Adds one item to a list, if there is any: of those that are left out, or dropped. */
void report_count(const mesh_report *r, report_item item, count_list *to);

/* Writes the sentence number `line` about the file `path`: 0 when there is none for it, -1
 * when there are no more, else 1. Count `line` from 0. */
int report_line(const mesh_report *r, unsigned line, const char *path, fail *to);

#endif
