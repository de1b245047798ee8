/* test_mesh_seams - open edges are counted as they are, and welding closes seams
 *
 * SPDX-License-Identifier: MIT */
#include <time.h>

#include "host_tools/mesh/near_grid.h"
#include "host_tools/mesh/open_edges.h"
#include "host_tools/mesh/weld_near.h"
#include "tests/hostile/mesh_files.h"

static uint64_t count_open(const mesh *m) {
    open_edges o;
    CHECK(open_edges_find(&o, m, 0, m->triangles) == 0, "out of memory");
    const uint64_t count = o.count;
    CHECK((o.ends == 0) == (count == 0) && o.ends <= 2 * count, "%zu ends", o.ends);
    for (size_t i = 0; i < o.ends; i++) {
        CHECK(o.end[i] < m->vertices && (i == 0 || o.end[i] > o.end[i - 1]), "vertex %u", o.end[i]);
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

/* ---- distances below the floats' own -------------------------------------------------------- */

static float random_coordinate(uint32_t *seed, double scale) {
    *seed = *seed * 1664525u + 1013904223u;
    return (float)(((*seed >> 8) / 8388608.0 - 1) * scale);
}

static void tiny_distances(void) {
    test("Below the distance of floats only equal positions are near, and each is found at once");
    enum { COUNT = 20000 };
    static float position[3 * (COUNT + 1)];
    static const double distances[] = {1e-310, 5e-324, 1e-60, 1e-30, 1e-17};
    uint32_t seed = 1;
    for (size_t d = 0; d < sizeof distances / sizeof distances[0]; d++) {
        near_grid g;
        double far;
        for (size_t i = 0; i < 3 * COUNT; i++) {
            position[i] = random_coordinate(&seed, 10);
        }
        memcpy(position + 3 * (size_t)COUNT, position + 3 * (size_t)(COUNT / 2), 12);
        CHECK(near_grid_begin(&g, position, distances[d], COUNT) == 0, "out of memory");
        for (uint32_t i = 0; i < COUNT; i++) {
            CHECK(near_grid_find(&g, i, &far) == NEAR_GRID_NONE, "%g: %u", distances[d], i);
            near_grid_add(&g, i);
        }
        CHECK(near_grid_find(&g, COUNT, &far) == COUNT / 2 && far == 0, "%g", distances[d]);
        CHECK(g.steps < 4 * (uint64_t)COUNT, "%g: %llu", distances[d], (unsigned long long)g.steps);
        near_grid_free(&g);
    }
}

/* The first of the nearest of the points before `vertex`. */
static uint32_t search_all(const float *position, uint32_t vertex, double distance) {
    uint32_t found = NEAR_GRID_NONE;
    double nearest = distance;
    for (uint32_t i = 0; i < vertex; i++) {
        double far2 = 0;
        for (size_t axis = 0; axis < 3; axis++) {
            const double d = (double)position[3 * (size_t)i + axis] -
                             (double)position[3 * (size_t)vertex + axis];
            far2 += d * d;
        }
        if (sqrt(far2) < nearest || (sqrt(far2) == nearest && found == NEAR_GRID_NONE)) {
            nearest = sqrt(far2);
            found = i;
        }
    }
    return found;
}

static void mixed_distances(void) {
    test("Points far along one axis and near 0 along the others are found as by looking at all");
    enum { COUNT = 1500 };
    static float position[3 * COUNT];
    static const double distances[] = {3e-3, 2e-9, 1e-12, 1e-16, 1e-17, 1e-20};
    uint32_t seed = 7, found = 0;
    for (size_t d = 0; d < sizeof distances / sizeof distances[0]; d++) {
        near_grid g;
        double far;
        for (size_t i = 0; i < COUNT; i++) { /* on ten planes, and on x = 0 */
            position[3 * i] = (float)(i % 11) * 0.1f;
            position[3 * i + 1] = random_coordinate(&seed, 3 * distances[d]);
            position[3 * i + 2] = random_coordinate(&seed, 3 * distances[d]);
        }
        CHECK(near_grid_begin(&g, position, distances[d], COUNT) == 0, "out of memory");
        for (uint32_t i = 0; i < COUNT; i++) {
            const uint32_t expected = search_all(position, i, distances[d]);
            CHECK(near_grid_find(&g, i, &far) == expected, "%g: %u", distances[d], i);
            found += expected != NEAR_GRID_NONE;
            near_grid_add(&g, i);
        }
        near_grid_free(&g);
    }
    CHECK(found > COUNT, "%u", found);
}

/* ---- many files --------------------------------------------------------------------------- */

/* Processor time to look for a distance in the first `parts` of a mesh, of 3 triangles each,
 * and to weld them. */
static double seconds_for(mesh *m, size_t parts) {
    const clock_t began = clock();
    for (size_t i = 0; i < parts; i++) {
        open_edges o;
        double distance;
        uint64_t left;
        weld_near_result r;
        CHECK(open_edges_find(&o, m, 3 * i, 3 * i + 3) == 0, "out of memory");
        CHECK(weld_near_suggest(m, 3 * i, 3 * i + 3, &o, &distance, &left) == 0, "out of memory");
        CHECK(distance > 0 && left < o.count, "%g leaves %llu", distance, (unsigned long long)left);
        CHECK(weld_near(m, 3 * i, 3 * i + 3, distance, &r) == 0, "out of memory");
        open_edges_free(&o);
    }
    return (double)(clock() - began) / CLOCKS_PER_SEC;
}

static void many_files(void) {
    test("A file of few triangles takes no longer among a hundred thousand of other files");
    enum { PARTS = 1000 };
    mesh alone = torus(240, 1e-6), among = torus(240, 1e-6);
    alone.vertices = 9 * PARTS;
    alone.triangles = 3 * PARTS;
    const double little = seconds_for(&alone, PARTS), much = seconds_for(&among, PARTS);
    CHECK(much < 4 * little + 0.02, "%g s, and alone %g s", much, little);
    mesh_free(&alone);
    mesh_free(&among);
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
    tiny_distances();
    mixed_distances();
    many_files();
    return test_done();
}
