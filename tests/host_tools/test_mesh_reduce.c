/* test_mesh_reduce - fewer triangles by vertex clustering: how many, and still closed
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/mesh/reduce.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

static int same(const mesh *a, const mesh *b) {
    return a->triangles == b->triangles && a->vertices == b->vertices &&
           (a->vertices == 0 || memcmp(a->vertex, b->vertex, 12 * a->vertices) == 0) &&
           (a->triangles == 0 || memcmp(a->triangle, b->triangle, 12 * a->triangles) == 0);
}

static mesh reduced(const mesh *m, size_t most) {
    mesh to = shape_copy(m);
    fail f = {""};
    CHECK(mesh_reduce(&to, most, "test", &f) == 0, "%s", f.text);
    CHECK(to.triangles > 0, "to %zu: nothing is left", most);
    return to;
}

/* The number in "use --reduce N or more" when so few would leave nothing; else `most`. The
 * mesh that is refused stays as it is. */
static size_t enough(const mesh *m, size_t most) {
    mesh to = shape_copy(m);
    fail f = {""};
    size_t proposed = most;
    if (mesh_reduce(&to, most, "test", &f) != 0) {
        const char *remedy = strstr(f.text, "; use --reduce ");
        proposed = remedy != NULL ? strtoul(remedy + 15, NULL, 10) : 0;
        CHECK(strncmp(f.text, "test: --reduce ", 15) == 0, "%s", f.text);
        CHECK(proposed > most && proposed <= m->triangles, "to %zu: %s", most, f.text);
        CHECK(same(&to, m), "changed");
    }
    mesh_free(&to);
    return proposed;
}

static int compare_keys(const void *a, const void *b) {
    return memcmp(a, b, 8);
}

/* Edges that are not there as often in one direction as in the other. */
static size_t open_edges(const mesh *m) {
    size_t open = 0, count = 3 * m->triangles;
    uint32_t(*edge[2])[2];
    for (int reversed = 0; reversed < 2; reversed++) {
        edge[reversed] = malloc(count * sizeof *edge[reversed] + 1);
        for (size_t e = 0; e < count; e++) {
            const uint32_t from = m->triangle[e], to = m->triangle[e - e % 3 + (e + 1) % 3];
            edge[reversed][e][0] = reversed ? to : from;
            edge[reversed][e][1] = reversed ? from : to;
        }
        qsort(edge[reversed], count, sizeof *edge[reversed], compare_keys);
    }
    for (size_t e = 0; e < count; e++) {
        open += memcmp(edge[0][e], edge[1][e], sizeof *edge[0]) != 0;
    }
    free(edge[0]);
    free(edge[1]);
    return open;
}

static double volume(const mesh *m) {
    double sum = 0.0;
    for (uint32_t i = 0; i < m->triangles; i++) {
        const float *p = shape_corner(m, i, 0), *q = shape_corner(m, i, 1),
                    *r = shape_corner(m, i, 2);
        for (int a = 0; a < 3; a++) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            sum += (double)p[a] * ((double)q[b] * (double)r[c] - (double)q[c] * (double)r[b]);
        }
    }
    return sum / 6.0;
}

/* Three vertices each, all within the box of the mesh. */
static void check_triangles(const mesh *was, const mesh *m, const char *name) {
    float lo[3], hi[3], low[3], high[3];
    shape_box(was, lo, hi);
    for (size_t i = 0; i < m->triangles; i++) {
        const uint32_t *t = m->triangle + 3 * i;
        CHECK(t[0] != t[1] && t[1] != t[2] && t[0] != t[2], "%s: a corner twice", name);
        CHECK(t[0] < m->vertices && t[1] < m->vertices && t[2] < m->vertices, "%s", name);
    }
    shape_box(m, low, high);
    for (int a = 0; a < 3 && m->vertices > 0; a++) {
        CHECK(low[a] >= lo[a] && high[a] <= hi[a], "%s: outside, axis %d", name, a);
    }
}

static void reduce_to(const mesh *m, const char *name, size_t most, double share, int closed) {
    mesh a = reduced(m, most), b = reduced(m, most);
    CHECK(a.triangles <= most && (double)a.triangles >= share * (double)most,
          "%s to %zu: %zu triangles", name, most, a.triangles);
    CHECK(same(&a, &b), "%s to %zu differs the second time", name, most);
    check_triangles(m, &a, name);
    if (closed) {
        const double is = volume(&a), was = volume(m);
        CHECK(open_edges(&a) == 0, "%s to %zu: %zu edges are open", name, most, open_edges(&a));
        CHECK(most < 2000 || fabs(is - was) < 0.1 * was, "%s to %zu: volume %g, was %g", name, most,
              is, was);
    }
    mesh_free(&a);
    mesh_free(&b);
}

static void every_count(mesh *m, const char *name, double share, int closed) {
    static const size_t most[] = {1, 4, 30, 100, 500, 1000, 2000, 3000, 3900};
    CHECK(!closed || open_edges(m) == 0, "%s was not closed", name);
    for (size_t i = 0; i < sizeof most / sizeof most[0] && most[i] < m->triangles; i++) {
        const size_t least = enough(m, most[i]);
        CHECK(most[i] < 30 || least == most[i], "%s to %zu is refused", name, most[i]);
        reduce_to(m, name, least, most[i] < 100 ? 0.0 : share, closed);
    }
    mesh_free(m);
}

/* As many as there are, or more: nothing moves. */
static void not_less(void) {
    mesh m = {0};
    shape_icosphere(&m, 2);
    for (size_t more = 0; more < 2; more++) {
        mesh all = reduced(&m, m.triangles + more);
        CHECK(same(&all, &m), "changed");
        mesh_free(&all);
    }
    mesh_free(&m);
}

/* From the number proposed on, whatever is asked for leaves something. */
static void check_remedy(mesh *m, const char *name, size_t most, size_t wanted) {
    const size_t least = enough(m, most);
    CHECK(wanted == 0 || least == wanted, "%s to %zu: %zu proposed", name, most, least);
    for (size_t n = least; n < least + 40; n++) {
        mesh a = reduced(m, n);
        CHECK(a.triangles <= n || n > m->triangles, "%s to %zu: %zu triangles", name, n,
              a.triangles);
        mesh_free(&a);
    }
    mesh_free(m);
}

static void too_few(void) {
    mesh m = {0};
    fail f = {""};
    shape_cube(&m);
    check_remedy(&m, "cube", 1, 12);
    shape_cube(&m);
    check_remedy(&m, "cube", 11, 12);
    shape_icosphere(&m, 3);
    check_remedy(&m, "icosphere", 1, 0);
    CHECK(scene_knot(&m, 4000, &f) == 0, "%s", f.text);
    check_remedy(&m, "knot", 1, 0);
    shape_icosphere(&m, 2); /* two, so far apart that each is one cell of the finest grid */
    shape_transform(&m, 1.0f, 1.0e8f, 0, 0);
    shape_icosphere(&m, 2);
    check_remedy(&m, "parts", 100, m.triangles);
}

/* Two spheres, apart: both are still there. */
static void parts(void) {
    mesh m = {0};
    shape_icosphere(&m, 3);
    shape_transform(&m, 1.0f, 1000, 0, 0);
    shape_icosphere(&m, 3);
    mesh a = reduced(&m, 500);
    size_t left = 0;
    for (uint32_t i = 0; i < a.triangles; i++) {
        left += shape_corner(&a, i, 0)[0] < 500;
    }
    CHECK(a.triangles >= 450 && left > 100 && left < a.triangles - 100, "%zu of %zu", left,
          a.triangles);
    mesh_free(&a);
    mesh_free(&m);
}

/* The same, whatever else is far away: vertices that no triangle uses, and triangles
 * without area, of which one at a sphere's corner has two corners there. */
static void stray(void) {
    static const float far[3][3] = {{1.0e9f, 0, 0}, {2.0e9f, 0, 0}, {3.0e9f, 0, 0}};
    mesh m = {0};
    fail f = {""};
    shape_icosphere(&m, 4);
    mesh a = reduced(&m, 500);
    for (uint32_t i = 0; i < 3; i++) {
        mesh_add_vertex(&m, far[i][0], far[i][1], far[i][2], &f);
        if (i == 0) {
            mesh b = reduced(&m, 500);
            CHECK(same(&a, &b), "%zu triangles, not %zu", b.triangles, a.triangles);
            mesh_free(&b);
        }
    }
    const uint32_t v = (uint32_t)m.vertices;
    mesh_add_triangle(&m, v - 3, v - 2, v - 1, &f);
    mesh_add_triangle(&m, v - 1, v - 1, v - 1, &f);
    mesh_add_triangle(&m, 0, 0, v - 1, &f);
    mesh b = reduced(&m, 500);
    CHECK(same(&a, &b), "%zu triangles, not %zu", b.triangles, a.triangles);
    mesh_free(&a);
    mesh_free(&b);
    mesh_free(&m);
}

/* Piles of one triangle; and one point, in which there is nothing to hit. */
static void nothing_to_reduce(void) {
    mesh m = {0};
    fail f = {""};
    mesh_add_vertex(&m, 1, 2, 3, &f);
    for (int i = 0; i < 5; i++) {
        mesh_add_triangle(&m, 0, 0, 0, &f);
    }
    CHECK(mesh_reduce(&m, 2, "point", &f) != 0, "%zu triangles of a point", m.triangles);
    CHECK(strcmp(f.text, "point: none of its 5 triangles has an area; leave out --reduce") == 0,
          "%s", f.text);
    mesh_free(&m);
    shape_coincident(&m, 40);
    check_remedy(&m, "pile", 10, 0);
}

int main(void) {
    mesh m = {0};
    fail f = {""};
    test("a closed mesh has at most so many triangles, not many less, and stays closed");
    shape_icosphere(&m, 4);
    every_count(&m, "icosphere", 0.9, 1);
    CHECK(scene_knot(&m, 4000, &f) == 0, "%s", f.text);
    every_count(&m, "knot", 0.9, 1);
    shape_needles(&m, 1000);
    every_count(&m, "needles", 0.0, 1);
    test("so has one that is open, or a soup");
    CHECK(scene_terrain(&m, 4000, &f) == 0, "%s", f.text);
    every_count(&m, "terrain", 0.9, 0);
    shape_soup(&m, 4000, 0.3f, 1);
    every_count(&m, "soup", 0.9, 0);
    test("a mesh of no more than that stays as it is");
    not_less();
    test("vertices that no triangle uses and triangles without area far away change nothing");
    stray();
    test("parts stay parts");
    parts();
    test(
        "what would leave nothing is refused with a number that leaves something, as does any "
        "above it");
    too_few();
    test("... and so are piles of one triangle, or points without another number");
    nothing_to_reduce();
    return test_done();
}
