/* painted - see painted.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/painted.h"

#include <string.h>

#include "host_tools/base/heap.h"

int painted_are(painted *p, unsigned paint, fail *f) {
    uint8_t *larger = heap_resize(p->paint, p->m.triangles);
    if (larger == NULL) {
        return fail_set(f, "the scene", "out of memory; close other programs");
    }
    p->paint = larger;
    memset(p->paint + p->filled, (int)paint, p->m.triangles - p->filled);
    p->filled = p->m.triangles;
    return 0;
}

int painted_quad(painted *p, const double corner[4][3], unsigned paint, fail *f) {
    const uint32_t first = (uint32_t)p->m.vertices;
    int wrong = 0;
    for (int i = 0; i < 4 && !wrong; i++) {
        const double *c = corner[i];
        wrong = mesh_add_vertex(&p->m, (float)c[0], (float)c[1], (float)c[2], f);
    }
    return wrong || mesh_add_triangle(&p->m, first, first + 1, first + 2, f) ||
                   mesh_add_triangle(&p->m, first, first + 2, first + 3, f)
               ? -1
               : painted_are(p, paint, f);
}

void painted_free(painted *p) {
    mesh_free(&p->m);
    heap_drop(p->paint);
}
