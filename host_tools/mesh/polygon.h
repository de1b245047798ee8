/* polygon - a face of many corners as triangles
 *
 * SPDX-License-Identifier: MIT */
#ifndef POLYGON_H
#define POLYGON_H
#include "host_tools/mesh/polygon_ears.h"
#include "host_tools/mesh/polygon_sweep.h"

/* Scratch that grows; zero-initialised; freed by polygon_free. */
typedef struct polygon {
    double (*point)[2]; /* the outline in its plane, then what is outside of it */
    size_t room;
    polygon_sweep sweep;
    polygon_ears ears;
    int wide; /* set by the caller: corners are doubles, whose rounding is no matter */
} polygon;

enum polygon_kind { POLYGON_FILLED, POLYGON_OVERLAPS, POLYGON_NO_MEMORY };

/* Triangulates the outline of n >= 3 corners, seen along its normal: `to` receives n - 2
 * triangles, three indices of corners each, that turn the same way as the outline.
 *
 * The fan (0, i, i + 1) where that fills the outline: all convex faces, with whatever
 * repeated or collinear corners. What single precision cannot tell from convex is.
 * Otherwise triangles that fill it without overlap, also where it touches itself, as a
 * hole does that is joined by an edge there and back.
 * POLYGON_OVERLAPS and the fan if it crosses itself or winds around twice;
 * POLYGON_NO_MEMORY and the fan if memory is out.
 *
 * Simple outlines take O(n log n). Those that touch themselves take about that, and are
 * given up as POLYGON_OVERLAPS when all outlines of one scratch together have taken
 * 2^25 + 2^10 steps per corner: a file of hostile faces takes linear time. About 300 bytes
 * per corner. Corners are finite and within 2^41. The result is the same on every machine. */
int polygon_triangulate(polygon *p, const double (*corner)[3], uint32_t n, uint32_t *to);
void polygon_free(polygon *p);

#endif
