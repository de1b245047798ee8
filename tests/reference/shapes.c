/* shapes - see shapes.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/shapes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void must(int status, const fail *f) {
    if (status != 0) {
        printf("FAIL a test's mesh: %s\n", f->text);
        exit(1);
    }
}

static uint32_t vertex(mesh *m, float x, float y, float z) {
    fail f = {""};
    must(mesh_add_vertex(m, x, y, z, &f), &f);
    return (uint32_t)m->vertices - 1;
}

static void triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    fail f = {""};
    must(mesh_add_triangle(m, a, b, c, &f), &f);
}

static void loose(mesh *m, const float p[9]) {
    const uint32_t a = vertex(m, p[0], p[1], p[2]);
    const uint32_t b = vertex(m, p[3], p[4], p[5]);
    triangle(m, a, b, vertex(m, p[6], p[7], p[8]));
}

void shape_soup(mesh *m, uint32_t triangles, float size, uint64_t seed) {
    random_state r = {seed};
    for (uint32_t i = 0; i < triangles; i++) {
        float p[9];
        for (int a = 0; a < 3; a++) {
            p[a] = random_float(&r, -1.0f, 1.0f);
            p[3 + a] = p[a] + random_float(&r, -size, size);
            p[6 + a] = p[a] + random_float(&r, -size, size);
        }
        loose(m, p);
    }
}

void shape_sheet(mesh *m, uint32_t side, int axis) {
    const uint32_t first = (uint32_t)m->vertices;
    for (uint32_t i = 0; i <= side; i++) {
        for (uint32_t k = 0; k <= side; k++) {
            float p[3] = {0.0f, 0.0f, 0.0f};
            p[(axis + 1) % 3] = (float)i / (float)side * 2.0f - 1.0f;
            p[(axis + 2) % 3] = (float)k / (float)side * 2.0f - 1.0f;
            vertex(m, p[0], p[1], p[2]);
        }
    }
    for (uint32_t i = 0; i < side; i++) {
        for (uint32_t k = 0; k < side; k++) {
            const uint32_t a = first + i * (side + 1) + k, b = a + side + 1;
            triangle(m, a, b, b + 1);
            triangle(m, a, b + 1, a + 1);
        }
    }
}

void shape_cube(mesh *m) {
    static const uint8_t face[12][3] = {{2, 6, 7}, {2, 7, 3}, {0, 1, 5}, {0, 5, 4},
                                        {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},
                                        {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    const uint32_t first = (uint32_t)m->vertices;
    for (unsigned i = 0; i < 8; i++) {
        vertex(m, i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
    }
    for (unsigned i = 0; i < 12; i++) {
        triangle(m, first + face[i][0], first + face[i][1], first + face[i][2]);
    }
}

static uint32_t on_sphere(mesh *m, double x, double y, double z) {
    const double length = sqrt(x * x + y * y + z * z);
    return vertex(m, (float)(x / length), (float)(y / length), (float)(z / length));
}

static void icosahedron(mesh *m) {
    static const uint8_t face[20][3] = {
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    const double g = (1.0 + sqrt(5.0)) / 2.0;
    const uint32_t first = (uint32_t)m->vertices;
    for (int a = 0; a < 3; a++) { /* the golden rectangles of z, x and y */
        for (int i = 0; i < 4; i++) {
            const double one = (i & 1) ? 1.0 : -1.0, gold = (i & 2) ? -g : g;
            const double p[3] = {a == 0 ? one : (a == 1 ? 0.0 : gold),
                                 a == 0 ? gold : (a == 1 ? one : 0.0),
                                 a == 0 ? 0.0 : (a == 1 ? gold : one)};
            on_sphere(m, p[0], p[1], p[2]);
        }
    }
    for (unsigned i = 0; i < 20; i++) {
        triangle(m, first + face[i][0], first + face[i][1], first + face[i][2]);
    }
}

/* The middle of the edge a b: searched for among the vertices since `first`. */
static uint32_t middle(mesh *m, size_t first, uint32_t a, uint32_t b) {
    const float *p = m->vertex + 3 * (size_t)a, *q = m->vertex + 3 * (size_t)b;
    mesh one = {0};
    on_sphere(&one, (double)p[0] + (double)q[0], (double)p[1] + (double)q[1],
              (double)p[2] + (double)q[2]);
    const float x = one.vertex[0], y = one.vertex[1], z = one.vertex[2];
    mesh_free(&one);
    for (size_t i = first; i < m->vertices; i++) {
        const float *v = m->vertex + 3 * i;
        if (v[0] == x && v[1] == y && v[2] == z) {
            return (uint32_t)i;
        }
    }
    return vertex(m, x, y, z);
}

void shape_icosphere(mesh *m, unsigned levels) {
    icosahedron(m);
    size_t first_triangle = m->triangles - 20;
    for (unsigned level = 0; level < levels; level++) {
        const size_t count = m->triangles - first_triangle, first = m->vertices;
        for (size_t i = 0; i < count; i++) {
            uint32_t *t = m->triangle + 3 * (first_triangle + i);
            const uint32_t a = t[0], b = t[1], c = t[2];
            const uint32_t ab = middle(m, first, a, b), bc = middle(m, first, b, c),
                           ca = middle(m, first, c, a);
            t[0] = ab;
            t[1] = bc;
            t[2] = ca;
            triangle(m, a, ab, ca);
            triangle(m, b, bc, ab);
            triangle(m, c, ca, bc);
        }
    }
}

void shape_needles(mesh *m, uint32_t sides) {
    const uint32_t first = (uint32_t)m->vertices;
    const double radius = 0.001;
    for (uint32_t i = 0; i < sides; i++) {
        const double angle = 6.283185307179586 * i / sides;
        vertex(m, (float)(radius * cos(angle)), 0.0f, (float)(radius * sin(angle)));
    }
    const uint32_t top = vertex(m, 0.0f, 1.0f, 0.0f), bottom = vertex(m, 0.0f, -1.0f, 0.0f);
    for (uint32_t i = 0; i < sides; i++) {
        const uint32_t a = first + i, b = first + (i + 1) % sides;
        triangle(m, b, a, top);
        triangle(m, a, b, bottom);
    }
}

void shape_coincident(mesh *m, uint32_t copies) {
    static const float p[9] = {-1, -1, 0, 1, -1, 0, 0, 1, 0.5f};
    static const float q[9] = {-1, -1, 1, 1, -1, 1, 0, 1, 1.5f};
    for (uint32_t i = 0; i < copies; i++) {
        loose(m, p);
    }
    loose(m, q);
    loose(m, q);
}

void shape_degenerate(mesh *m) {
    static const float p[8][9] = {
        {0, 0, 0, 0, 0, 0, 0, 0, 0},                           /* a point */
        {-1, 0, 0, 0, 0, 0, 1, 0, 0},                          /* a line along x */
        {-1, -1, -1, 0, 0, 0, 1, 1, 1},                        /* a diagonal line */
        {-1, 0.5f, 0, 1, 0.5f, 0, -1, 0.5f, 0},                /* two equal corners */
        {-1, -1, 0.5f, 1, -1, 0.5f, 0, 1, 0.5f},               /* proper */
        {0, -1, -1, 0, 1, -1, 0, 0, 1},                        /* proper, x = 0 */
        {0, 0, 0, 1e-30f, 0, 0, 0, 1e-30f, 0},                 /* its normal vanishes */
        {0.3f, 0.3f, 0.3f, 0.9f, 0.3f, 0.3f, 0.6f, 0.3f, 0.3f} /* a line, unordered */
    };
    for (int i = 0; i < 8; i++) {
        loose(m, p[i]);
    }
}

void shape_exponential(mesh *m, uint32_t triangles) {
    for (uint32_t i = 0; i < triangles; i++) {
        const float s = ldexpf(1.0f, -(int)(i % 120));
        const float p[9] = {s, s, s, 1.5f * s, s, 1.25f * s, s, 1.5f * s, s};
        loose(m, p);
    }
}

void shape_transform(mesh *m, float scale, float x, float y, float z) {
    const float move[3] = {x, y, z};
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        m->vertex[i] = m->vertex[i] * scale + move[i % 3];
    }
}

void shape_box(const mesh *m, float lo[3], float hi[3]) {
    for (int a = 0; a < 3; a++) {
        lo[a] = m->vertices ? m->vertex[a] : 0.0f;
        hi[a] = lo[a];
        for (size_t i = 0; i < m->vertices; i++) {
            const float x = m->vertex[3 * i + (size_t)a];
            lo[a] = x < lo[a] ? x : lo[a];
            hi[a] = x > hi[a] ? x : hi[a];
        }
    }
}

mesh shape_copy(const mesh *m) {
    mesh copy = {0};
    for (size_t i = 0; i < m->vertices; i++) {
        const float *p = m->vertex + 3 * i;
        vertex(&copy, p[0], p[1], p[2]);
    }
    for (size_t i = 0; i < m->triangles; i++) {
        const uint32_t *t = m->triangle + 3 * i;
        triangle(&copy, t[0], t[1], t[2]);
    }
    return copy;
}
