/* test_mesh_precision - what single precision costs is measured, and --centre avoids it
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/precision.h"
#include "tests/hostile/mesh_files.h"

#define FILE_NAME MESH_FOLDER "far.obj"
#define RECIPE MESH_FOLDER "far.txt"

static const double NOWHERE[3] = {0, 0, 0};

/* A slab of 1 x 0.4 x 1 in the metres of a national grid. */
static const char SLAB[] =
    "v 500000.10 4500000.30 100\nv 500001.10 4500000.30 100\n"
    "v 500000.10 4500000.70 101\nv 500001.10 4500000.70 101\n"
    "f 1 2 3\nf 2 4 3\n";

static void measures(void) {
    test("A slab far from the origin loses edges in single precision, and none at its centre");
    mesh m = must_read_text(FILE_NAME, SLAB);
    CHECK(m.wide != NULL, "no wide coordinates");
    CHECK(m.wide[0] == 500000.10 && m.wide[10] == 4500000.70, "%.17g %.17g", m.wide[0], m.wide[10]);
    const precision p = precision_of(&m, 0, m.triangles, NOWHERE);
    /* 4500000.3 and 4500000.7 are both 4500000.5 in single precision; 100 and 101 stay. */
    CHECK(p.moved > 0.2 && p.moved < 0.21, "%g", p.moved);
    CHECK(precision_matters(&p), "%g", p.relative);
    double centre[3];
    precision_centre(&m, centre);
    CHECK(centre[0] == 500000.10 / 2 + 500001.10 / 2 && centre[2] == 100.5, "%.17g", centre[0]);
    const precision q = precision_of(&m, 0, m.triangles, centre);
    CHECK(q.moved < 1e-7 && q.vanished == 0 && !precision_matters(&q), "%g", q.moved);
    fail f = {{0}};
    CHECK(precision_settle(&m, centre, FILE_NAME, &f) == 0, "%s", f.text);
    CHECK(m.wide == NULL, "still wide");
    CHECK(m.vertex[1] == (float)(4500000.30 - centre[1]), "%.9g", (double)m.vertex[1]);
    mesh_free(&m);
}

static void counts_triangles(void) {
    test("Triangles that lose an edge are counted; exact meshes cost nothing");
    mesh m = must_read_text(FILE_NAME,
                            "v 1000000 0 0\nv 1000000.01 0 0\nv 1000001 5 0\n"
                            "v 1000002 5 0\nf 1 2 3\nf 3 2 4\n");
    precision p = precision_of(&m, 0, 2, NOWHERE);
    CHECK(p.vanished == 1, "%llu", (unsigned long long)p.vanished);
    p = precision_of(&m, 1, 2, NOWHERE);
    CHECK(p.vanished == 0, "%llu", (unsigned long long)p.vanished);
    mesh_free(&m);
    m = must_read_text(FILE_NAME, "v 0.5 0 0\nv 16777216 0 1\nv -3e6 5 0\nf 1 2 3\n");
    CHECK(m.wide == NULL, "wide coordinates of floats");
    p = precision_of(&m, 0, 1, NOWHERE);
    CHECK(p.moved == 0 && p.relative == 0, "%g", p.moved);
    mesh_free(&m);
}

static void keeps_floats(void) {
    test("A mesh that is not moved keeps the floats nearest to its text, not to its doubles");
    /* Above the middle between 1 and its neighbour by less than a double shows. */
    mesh m = must_read_text(FILE_NAME,
                            "v 1.00000005960464477539062500001 0 0\nv 0 1 0\nv 0 0 1\n"
                            "f 1 2 3\n");
    fail f = {{0}};
    CHECK(m.vertex[0] == 1.00000012f, "%.9g", (double)m.vertex[0]);
    CHECK(precision_settle(&m, NOWHERE, FILE_NAME, &f) == 0, "%s", f.text);
    CHECK(m.vertex[0] == 1.00000012f, "%.9g", (double)m.vertex[0]);
    mesh_free(&m);
}

static void notices_the_smallest_edges(void) {
    test("Edges whose squares are 0 in double are noticed when their corners fall together");
    mesh m = must_read_text(FILE_NAME, "v 0 0 0\nv 1e-170 0 0\nv 0 1 0\nf 1 2 3\n");
    precision p = precision_of(&m, 0, 1, NOWHERE);
    CHECK(p.vanished == 1, "%llu vanished", (unsigned long long)p.vanished);
    CHECK(p.moved == 1e-170 && p.relative == 1, "%g, %g of an edge", p.moved, p.relative);
    mesh_free(&m);
    m = must_read_text(FILE_NAME, "v 0 0 0\nv 0 1e-310 0\nv 0 1 0\nf 1 2 3\n");
    p = precision_of(&m, 0, 1, NOWHERE);
    CHECK(p.vanished == 1 && p.relative == 1, "%g of an edge", p.relative);
    mesh_free(&m);
    m = must_read_text(FILE_NAME, "v 0 1e-310 0\nv 0 1e-310 0\nv 0 1 0\nf 1 2 3\n");
    p = precision_of(&m, 0, 1, NOWHERE);
    CHECK(p.vanished == 0, "an edge without length lost one");
    mesh_free(&m);
}

static void refuses_far_origins(void) {
    test("An origin from which the mesh reaches beyond 2^40 is refused; unused vertices may");
    mesh m = must_read_text(FILE_NAME, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1e12 0 0\nf 1 2 3\n");
    fail f = {{0}};
    const double far[3] = {1.2e12, 0, 0}, half[3] = {-6e11, 0, 0};
    CHECK(precision_settle(&m, far, FILE_NAME, &f) == -1, "moved");
    CHECK(strstr(f.text, "beyond +-2^40; use --centre") != NULL, "%s", f.text);
    fail g = {{0}};
    CHECK(precision_settle(&m, half, FILE_NAME, &g) == 0, "%s", g.text);
    CHECK(m.vertex[9] == 0 && m.vertex[0] == 6e11f, "%g", (double)m.vertex[9]);
    CHECK(mesh_is_valid(&m), "not valid");
    mesh_free(&m);
}

static void places_wide(void) {
    test("A recipe places floats and says what they lost, or with --centre the doubles");
    file_write(MESH_FOLDER "slab.obj", SLAB, strlen(SLAB));
    mesh m = {0};
    mesh_report report = {0}, centred = {.centred = 1};
    fail f;
    CHECK(read_text(&m, RECIPE, "slab.obj 10 0 0 0\n", &report, &f) == 0, "%s", f.text);
    CHECK(report.moved > 0.1, "%g", report.moved);
    CHECK(m.vertex[1] == m.vertex[7], "the slab is not flat");
    mesh_free(&m);
    CHECK(read_text(&m, RECIPE, "slab.obj 10 0 0 0\n", &centred, &f) == 0, "%s", f.text);
    CHECK(centred.moved == 0, "%g", centred.moved);
    const double high = mesh_wide(&m, 2, 1) - mesh_wide(&m, 0, 1);
    CHECK(fabs(high - 4) < 1e-8, "%.17g", high); /* of 4.5e6 a double keeps 1e-9 */
    mesh_free(&m);
}

static void places_exact_floats(void) {
    test("With --centre a recipe's position costs floats nothing, whatever they are read behind");
    static const char flat[] = "v 0 0 0\nv 0.125 0 0\nv 0 0.125 1\nf 1 2 3\n";
    file_write(MESH_FOLDER "flat.obj", flat, strlen(flat));
    mesh alone = {0}, behind = must_read_text(FILE_NAME, SLAB);
    mesh_report report = {.centred = 1};
    fail f;
    const size_t first = behind.vertices;
    CHECK(read_text(&alone, RECIPE, "flat.obj 1 4194304 0 1e8\n", &report, &f) == 0, "%s", f.text);
    CHECK(read_text(&behind, RECIPE, "flat.obj 1 4194304 0 1e8\n", &report, &f) == 0, "%s", f.text);
    for (size_t i = 0; i < 9; i++) {
        const double x = mesh_wide(&alone, i / 3, (int)(i % 3));
        CHECK(x == mesh_wide(&behind, first + i / 3, (int)(i % 3)), "coordinate %zu: %.17g", i, x);
    }
    CHECK(mesh_wide(&alone, 2, 2) - mesh_wide(&alone, 0, 2) == 1, "%.17g", mesh_wide(&alone, 2, 2));
    mesh_free(&alone);
    mesh_free(&behind);
}

static void appends_wide(void) {
    test("Wide coordinates begin at the first vertex that needs them, and go on");
    mesh m = must_read_text(FILE_NAME, "v 1 2 3\nv 4 5 6\nv 7 8 9\nf 1 2 3\n");
    CHECK(m.wide == NULL, "wide");
    mesh_report report = {0};
    fail f;
    CHECK(read_text(&m, FILE_NAME, SLAB, &report, &f) == 0, "%s", f.text);
    CHECK(m.wide != NULL && m.wide[4] == 5 && m.wide[9] == 500000.10, "lost");
    for (int i = 0; i < 1000; i++) {
        CHECK(mesh_add_vertex(&m, (float)i, 0.1f, 0, &f) == 0, "%s", f.text);
    }
    CHECK(m.wide[3 * 507] == 500 && m.wide[3 * 507 + 1] == (double)0.1f, "%g", m.wide[3 * 507]);
    mesh_free(&m);
}

int main(void) {
    mesh_folder();
    measures();
    counts_triangles();
    keeps_floats();
    notices_the_smallest_edges();
    refuses_far_origins();
    places_wide();
    places_exact_floats();
    appends_wide();
    return test_done();
}
