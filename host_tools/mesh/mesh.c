/* mesh - triangles with shared vertices: memory
 *
 * Keeps: vertices <= vertex_room and triangles <= triangle_room; fewer than
 * 2^32 - 1 vertices: UINT32_MAX is never a vertex index. `wide`, when there is one, has
 * room for as many vertices as `vertex`.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/mesh.h"
#include "host_tools/base/heap.h"

static const size_t VERTICES_MAX = UINT32_MAX - 1;
static const size_t TRIANGLES_MAX = UINT32_MAX - 1;

/* Room for `needed` items of `item_bytes`: half as much again as before.
 * Adding one by one then takes linear time. */
static void *grow(void *items, size_t *room, size_t needed, size_t item_bytes) {
    const size_t half_more = *room + *room / 2 + 16;
    const size_t more = needed > half_more ? needed : half_more;
    if (more > SIZE_MAX / item_bytes) {
        return NULL;
    }
    void *grown = heap_resize(items, (uint64_t)more * item_bytes);
    if (grown) {
        *room = more;
    }
    return grown;
}

static int fail_memory(const mesh *m, fail *f) {
    return fail_set(f, NULL, "out of memory at vertex %zu; split the mesh", m->vertices);
}

static int reserve_vertices(mesh *m, size_t more, fail *f) {
    if (more <= m->vertex_room - m->vertices) {
        return 0;
    }
    if (more > VERTICES_MAX - m->vertices) {
        return fail_set(f, NULL, "more than 2^32 - 2 vertices; split the mesh");
    }
    size_t room = m->vertex_room;
    float *vertex = grow(m->vertex, &room, m->vertices + more, 3 * sizeof *m->vertex);
    if (!vertex) {
        return fail_memory(m, f);
    }
    m->vertex = vertex;
    if (m->wide) {
        double *wide = room > SIZE_MAX / 24 ? NULL : heap_resize(m->wide, (uint64_t)room * 24);
        if (!wide) {
            return fail_memory(m, f);
        }
        m->wide = wide;
    }
    m->vertex_room = room;
    return 0;
}

static int reserve_triangles(mesh *m, size_t more, fail *f) {
    if (more <= m->triangle_room - m->triangles) {
        return 0;
    }
    if (more > TRIANGLES_MAX - m->triangles) {
        return fail_set(f, NULL, "more than 2^32 - 2 triangles; split the mesh");
    }
    uint32_t *triangle =
        grow(m->triangle, &m->triangle_room, m->triangles + more, 3 * sizeof *m->triangle);
    if (!triangle) {
        return fail_set(f, NULL, "out of memory at triangle %zu; split the mesh", m->triangles);
    }
    m->triangle = triangle;
    return 0;
}

int mesh_reserve(mesh *m, size_t vertices, size_t triangles, fail *f) {
    return reserve_vertices(m, vertices, f) != 0 ? -1 : reserve_triangles(m, triangles, f);
}

int mesh_add_vertex(mesh *m, float x, float y, float z, fail *f) {
    if (m->vertices == m->vertex_room && reserve_vertices(m, 1, f) != 0) {
        return -1;
    }
    float *v = m->vertex + 3 * m->vertices++;
    v[0] = x;
    v[1] = y;
    v[2] = z;
    for (int axis = 0; axis < 3 && m->wide; axis++) {
        m->wide[3 * (m->vertices - 1) + (size_t)axis] = (double)v[axis];
    }
    return 0;
}

int mesh_widen(mesh *m, fail *f) {
    if (m->wide) {
        return 0;
    }
    if (m->vertex_room > SIZE_MAX / 24 || !(m->wide = heap_get(m->vertex_room * 24))) {
        return fail_memory(m, f);
    }
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        m->wide[i] = (double)m->vertex[i];
    }
    return 0;
}

int mesh_add_real(mesh *m, const real p[3], fail *f) {
    if (mesh_add_vertex(m, p[0].single, p[1].single, p[2].single, f) != 0) {
        return -1;
    }
    int is_exact = 1;
    for (int axis = 0; axis < 3; axis++) {
        is_exact &= p[axis].wide == (double)p[axis].single;
    }
    if (!is_exact && mesh_widen(m, f) != 0) {
        m->vertices--;
        return -1;
    }
    for (int axis = 0; axis < 3 && m->wide; axis++) {
        m->wide[3 * (m->vertices - 1) + (size_t)axis] = p[axis].wide;
    }
    return 0;
}

int mesh_add_triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c, fail *f) {
    if (m->triangles == m->triangle_room && reserve_triangles(m, 1, f) != 0) {
        return -1;
    }
    uint32_t *t = m->triangle + 3 * m->triangles++;
    t[0] = a;
    t[1] = b;
    t[2] = c;
    return 0;
}

static void shrink(void **items, uint64_t bytes) {
    void *fewer = bytes > 0 && *items != NULL ? heap_resize(*items, bytes) : NULL;
    *items = fewer != NULL ? fewer : *items;
}

void mesh_fit(mesh *m) {
    void *vertex = m->vertex, *wide = m->wide, *triangle = m->triangle;
    shrink(&vertex, 12 * (uint64_t)m->vertices);
    shrink(&wide, 24 * (uint64_t)m->vertices);
    shrink(&triangle, 12 * (uint64_t)m->triangles);
    m->vertex = vertex;
    m->wide = wide;
    m->triangle = triangle;
    m->vertex_room = m->vertices;
    m->triangle_room = m->triangles;
}

vertex_range mesh_vertices_of(const mesh *m, size_t first, size_t end) {
    size_t low = m->vertices, high = 0;
    for (size_t i = 3 * first; i < 3 * end; i++) {
        const size_t v = m->triangle[i];
        low = v < low ? v : low;
        high = v >= high ? v + 1 : high;
    }
    return (vertex_range){low, high > low ? high - low : 0};
}

void mesh_free(mesh *m) {
    heap_drop(m->vertex);
    heap_drop(m->wide);
    heap_drop(m->triangle);
    *m = (mesh){0};
}
