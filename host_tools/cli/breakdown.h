/* breakdown - where the bytes of compact blocks go
 *
 * SPDX-License-Identifier: MIT */
#ifndef BREAKDOWN_H
#define BREAKDOWN_H
#include "engine/planelet.h"

enum breakdown_part {
    PART_PLANES,
    PART_OWNERS,
    PART_KINDS,
    PART_LINKS,
    PART_BOUNDS,
    PART_HEADERS, /* of the node parts */
    PART_PADDING, /* of whole blocks */
    PART_GEOMETRY_HEADERS,
    PART_COUNTS,
    PART_STRIPS, /* start, swap and new-vertex bits */
    PART_REFERENCES,
    PART_POSITIONS,
    PART_GEOMETRY_PADDING,
    PART_ID_CHECKS,
    PART_PRIMITIVE_IDS,
    PARTS
};

typedef struct breakdown {
    double bytes[PARTS];
    uint32_t of_one_mesh; /* blocks that say which mesh all their triangles are of */
} breakdown;

/* Keys of planelet info --json: they keep their first names. */
extern const char *const breakdown_names[PARTS];

/* Of an opened engine whose scene is compact; the parts' sum is the sections'
 * size less what follows the last block. */
void breakdown_count(const plt_engine *engine, breakdown *b);

#endif
