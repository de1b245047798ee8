/* between - see between.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/between.h"

size_t between_differs(const mesh *a, const mesh *b) {
    if (a->vertices != b->vertices || a->triangles != b->triangles) {
        return 0;
    }
    for (size_t i = 0; i < 3 * a->triangles; i++) {
        if (a->triangle[i] != b->triangle[i]) {
            return i / 3;
        }
    }
    return SIZE_MAX;
}

/* One division: x * whole / whole is x, as both are exact in a double. */
static float on_the_way(float a, float b, unsigned part, unsigned whole) {
    const double sum = (double)a * (whole - part) + (double)b * part;
    return (float)(sum / whole);
}

int between_make(mesh *m, const mesh *a, const mesh *b, unsigned part, unsigned whole, fail *f) {
    if (mesh_reserve(m, a->vertices, a->triangles, f) != 0) {
        return -1;
    }
    for (size_t i = 0; i < a->vertices; i++) {
        float p[3];
        for (size_t k = 0; k < 3; k++) {
            p[k] = on_the_way(a->vertex[3 * i + k], b->vertex[3 * i + k], part, whole);
        }
        if (mesh_add_vertex(m, p[0], p[1], p[2], f) != 0) {
            return -1;
        }
    }
    for (size_t i = 0; i < a->triangles; i++) {
        const uint32_t *t = a->triangle + 3 * i;
        if (mesh_add_triangle(m, t[0], t[1], t[2], f) != 0) {
            return -1;
        }
    }
    return 0;
}
