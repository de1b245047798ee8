/* painted - a mesh whose triangles each have a paint, a number below 256
 *
 * SPDX-License-Identifier: MIT */
#ifndef PAINTED_H
#define PAINTED_H
#include "host_tools/mesh/mesh.h"

typedef struct painted {
    mesh m;
    uint8_t *paint; /* of each triangle */
    size_t filled;  /* triangles that have theirs */
} painted;

/* Triangles that came since the last call have that paint. -1: out of memory. */
int painted_are(painted *p, unsigned paint, fail *f);
/* Four corners, counter-clockwise from outside. */
int painted_quad(painted *p, const double corner[4][3], unsigned paint, fail *f);
void painted_free(painted *p);

#endif
