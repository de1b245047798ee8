/* ground - a flat slab: the smallest scene there is
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/scenes.h"

#define HALF 10.0f
#define THICK 0.5f

/* Corner i: bit 0 is +x, bit 1 is the top, bit 2 is +z. */
static const uint8_t faces[12][3] = {
    {2, 6, 7}, {2, 7, 3}, /* top */
    {0, 1, 5}, {0, 5, 4}, /* bottom */
    {0, 4, 6}, {0, 6, 2}, /* -x */
    {1, 3, 7}, {1, 7, 5}, /* +x */
    {0, 2, 3}, {0, 3, 1}, /* -z */
    {4, 5, 7}, {4, 7, 6}, /* +z */
};

static int add(mesh *m, uint32_t first, fail *f) {
    for (unsigned i = 0; i < 8; i++) {
        if (mesh_add_vertex(m, i & 1 ? HALF : -HALF, i & 2 ? 0.0f : -THICK, i & 4 ? HALF : -HALF,
                            f)) {
            return -1;
        }
    }
    for (unsigned i = 0; i < 12; i++) {
        if (mesh_add_triangle(m, first + faces[i][0], first + faces[i][1], first + faces[i][2],
                              f)) {
            return -1;
        }
    }
    return 0;
}

int scene_ground(mesh *m, fail *f) {
    const size_t vertices = m->vertices, triangles = m->triangles;
    if (add(m, (uint32_t)vertices, f) == 0) {
        return 0;
    }
    m->vertices = vertices;
    m->triangles = triangles;
    return -1;
}
