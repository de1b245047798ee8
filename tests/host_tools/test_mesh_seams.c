/* test_mesh_seams - open edges are counted as they are, and welding closes seams
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/open_edges.h"
#include "host_tools/mesh/weld_near.h"
#include "tests/hostile/mesh_files.h"

static uint64_t count_open(const mesh *m) {
    open_edges o;
    CHECK(open_edges_find(&o, m, 0, m->triangles) == 0, "out of memory");
    const uint64_t count = o.count;
    for (size_t i = 0; i < 2 * count; i++) {
        CHECK(o.vertex[i] < m->vertices, "vertex %u", o.vertex[i]);
    }
    open_edges_free(&o);
    return count;
}

/* A closed surface, side x side squares of two triangles wrapped to a torus, each triangle
 * with vertices of its own, moved by up to `jitter`. */
static mesh torus(unsigned side, double jitter) {
    mesh m = {0};
    fail f = {{0}};
    uint32_t seed = 1;
    for (unsigned i = 0; i < 2 * side * side; i++) {
        const unsigned x = i / 2 % side, y = i / 2 / side;
        for (unsigned k = 0; k < 3; k++) {
            static const unsigned U[2][3] = {{0, 1, 1}, {0, 1, 0}},
                                  V[2][3] = {{0, 0, 1}, {0, 1, 1}};
            const double a = 6.283185307179586 * ((x + U[i % 2][k]) % side) / side;
            const double b = 6.283185307179586 * ((y + V[i % 2][k]) % side) / side;
            seed = seed * 1664525u + 1013904223u;
            const double j = jitter * ((seed >> 8) / 8388608.0 - 1);
            mesh_add_vertex(&m, (float)((2 + cos(b)) * cos(a) + j),
                            (float)((2 + cos(b)) * sin(a) + j), (float)(sin(b) + j), &f);
        }
        mesh_add_triangle(&m, 3 * i, 3 * i + 1, 3 * i + 2, &f);
    }
    return m;
}

static void counts(void) {
    test(
        "Edges of one triangle are open: of none in a torus, of its rim in a surface cut out of "
        "it");
    mesh m = torus(24, 0);
    CHECK(count_open(&m) == 0, "%llu", (unsigned long long)count_open(&m));
    m.triangles -= 1;
    CHECK(count_open(&m) == 3, "%llu", (unsigned long long)count_open(&m));
    m.triangles -= 47; /* the last row */
    CHECK(count_open(&m) == 48, "%llu", (unsigned long long)count_open(&m));
    mesh_free(&m);
}

static void ignores_what_is_no_edge(void) {
    test("Signs of zero and triangles with equal corners open nothing");
    mesh m = torus(24, 0);
    fail f = {{0}};
    for (size_t i = 0; i < 3 * m.vertices; i += 2) {
        m.vertex[i] = m.vertex[i] == 0 ? -m.vertex[i] : m.vertex[i];
    }
    mesh_add_triangle(&m, 0, 0, 7, &f);
    mesh_add_triangle(&m, 9, 9, 9, &f);
    CHECK(count_open(&m) == 0, "%llu", (unsigned long long)count_open(&m));
    mesh_free(&m);
}

static void welds(void) {
    test("A torus in pieces is closed by the distance that is suggested, and moves no further");
    mesh m = torus(24, 1e-6);
    open_edges o;
    double distance;
    uint64_t left;
    CHECK(open_edges_find(&o, &m, 0, m.triangles) == 0, "out of memory");
    CHECK(o.count == 3 * m.triangles, "%llu", (unsigned long long)o.count);
    CHECK(weld_near_suggest(&m, 0, m.triangles, &o, &distance, &left) == 0, "out of memory");
    CHECK(distance > 1e-7 && distance < 2e-5 && left == 0, "%g leaves %llu", distance,
          (unsigned long long)left);
    open_edges_free(&o);
    mesh before = torus(24, 1e-6);
    weld_near_result r;
    CHECK(weld_near(&m, 0, m.triangles, distance, &r) == 0, "out of memory");
    CHECK(count_open(&m) == left, "%llu", (unsigned long long)count_open(&m));
    CHECK(r.moved > m.triangles && r.collapsed == 0, "%llu", (unsigned long long)r.moved);
    for (size_t i = 0; i < 3 * m.triangles; i++) {
        double far2 = 0;
        for (size_t axis = 0; axis < 3; axis++) {
            const double d = (double)m.vertex[3 * (size_t)m.triangle[i] + axis] -
                             (double)before.vertex[3 * (size_t)before.triangle[i] + axis];
            far2 += d * d;
        }
        CHECK(far2 <= distance * distance, "corner %zu moved by %g", i, sqrt(far2));
    }
    CHECK(weld_near(&m, 0, m.triangles, 4e-6, &r) == 0, "out of memory");
    CHECK(count_open(&m) == 0, "%llu", (unsigned long long)count_open(&m));
    mesh_free(&m);
    mesh_free(&before);
}

static void suggests_nothing(void) {
    test("No distance is suggested for a border, nor one that would take triangles' area");
    mesh m = torus(24, 0);
    open_edges o;
    double distance = 1;
    uint64_t left;
    m.triangles -= 48;
    CHECK(open_edges_find(&o, &m, 0, m.triangles) == 0, "out of memory");
    CHECK(weld_near_suggest(&m, 0, m.triangles, &o, &distance, &left) == 0, "out of memory");
    CHECK(distance == 0 && left == o.count, "%g", distance);
    open_edges_free(&o);
    mesh_free(&m);
}

static void collapses(void) {
    test("Triangles smaller than the distance lose their area and are counted; order is no matter");
    mesh m = torus(24, 0);
    weld_near_result r;
    CHECK(weld_near(&m, 0, m.triangles, 0.5, &r) == 0, "out of memory");
    CHECK(r.collapsed > 0 && r.moved > 0, "%llu", (unsigned long long)r.collapsed);
    mesh_free(&m);
    m = torus(8, 0); /* a distance beyond all: one point, and no endless search */
    CHECK(weld_near(&m, 0, m.triangles, 1e30, &r) == 0, "out of memory");
    CHECK(r.collapsed == m.triangles, "%llu", (unsigned long long)r.collapsed);
    CHECK(weld_near(&m, 0, m.triangles, 1e-40, &r) == 0, "out of memory");
    mesh_free(&m);
    m = torus(150, 1e-6); /* a distance in which no double counts the cells */
    CHECK(weld_near(&m, 0, m.triangles, 1e-310, &r) == 0, "out of memory");
    CHECK(r.collapsed == 0 && r.moved == 0, "%llu", (unsigned long long)r.moved);
    mesh_free(&m);
}

static void dense_points(void) {
    test("A hundred thousand open corners within one cell end in bounded work");
    mesh m = {0};
    fail f = {{0}};
    uint32_t seed = 1;
    for (uint32_t i = 0; i < 100000; i++) {
        for (int k = 0; k < 3; k++) {
            seed = seed * 1664525u + 1013904223u;
            const float x = (float)(seed >> 8) * 1e-14f;
            mesh_add_vertex(&m, x, x * x, (float)i * 1e-12f, &f);
        }
        mesh_add_triangle(&m, 3 * i, 3 * i + 1, 3 * i + 2, &f);
    }
    mesh_add_vertex(&m, 1e6f, 0, 0, &f);
    mesh_add_triangle(&m, 0, 1, (uint32_t)m.vertices - 1, &f);
    open_edges o;
    double distance = 1;
    uint64_t left;
    CHECK(open_edges_find(&o, &m, 0, m.triangles) == 0, "out of memory");
    CHECK(o.count > 100000, "%llu", (unsigned long long)o.count);
    CHECK(weld_near_suggest(&m, 0, m.triangles, &o, &distance, &left) == 0, "out of memory");
    CHECK(distance == 0, "%g", distance);
    open_edges_free(&o);
    mesh_free(&m);
}

/* Triangles of which each two share a spoke's outer side, from one of two hubs: a seam runs
 * along every spoke. */
static mesh wheel(unsigned pairs, float apart) {
    mesh m = {0};
    fail f = {{0}};
    mesh_add_vertex(&m, 0, 0, 0, &f);
    mesh_add_vertex(&m, 0, 0, apart, &f);
    for (unsigned i = 0; i < 2 * pairs; i++) {
        const double angle = 6.283185307179586 * i / (2 * pairs);
        mesh_add_vertex(&m, (float)cos(angle), (float)sin(angle), 0, &f);
    }
    for (unsigned i = 0; i < pairs; i++) {
        mesh_add_triangle(&m, 0, 2 + 2 * i, 3 + 2 * i, &f);
        mesh_add_triangle(&m, 1, 3 + 2 * i, 2 + 2 * i, &f);
    }
    return m;
}

static void many_ends(void) {
    test("Thousands of open edges that end in one position do not hide the seam there");
    mesh m = wheel(2000, 1e-6f);
    open_edges o;
    double distance;
    uint64_t left;
    CHECK(open_edges_find(&o, &m, 0, m.triangles) == 0, "out of memory");
    CHECK(o.count == 8000, "%llu", (unsigned long long)o.count);
    CHECK(weld_near_suggest(&m, 0, m.triangles, &o, &distance, &left) == 0, "out of memory");
    CHECK(distance > 1e-6 && distance < 1e-5 && left == 0, "%g leaves %llu", distance,
          (unsigned long long)left);
    open_edges_free(&o);
    mesh_free(&m);
}

int main(void) {
    mesh_folder();
    counts();
    ignores_what_is_no_edge();
    welds();
    suggests_nothing();
    collapses();
    dense_points();
    many_ends();
    return test_done();
}
