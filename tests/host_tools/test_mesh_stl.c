/* test_mesh_stl - the STL reader, value by value
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hostile/mesh_files.h"

#define FILE_NAME MESH_FOLDER "case.stl"
#define FACET(a, b, c)                                                                             \
    "facet normal 0 0 1\n outer loop\n  vertex " a "\n  vertex " b "\n  vertex " c                 \
    "\n endloop\nendfacet\n"

static const float CORNERS[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
static const uint32_t PAIR[] = {0, 1, 2, 2, 1, 3};

/* `head` fills the first 80 bytes, `count` is what byte 80 says. */
static blob binary(const char *head, uint32_t count, const float (*triangle)[9], size_t triangles) {
    blob b = {.size = 0};
    char name[80] = {0};
    memcpy(name, head, strlen(head));
    put(&b, name, sizeof name);
    put_number(&b, count, 4, 0);
    for (size_t i = 0; i < triangles; i++) {
        for (int k = 0; k < 3; k++) {
            put_float(&b, NAN, 0);
        }
        for (int k = 0; k < 9; k++) {
            put_float(&b, triangle[i][k], 0);
        }
        put_number(&b, 0xffff, 2, 0);
    }
    return b;
}

static const float TWO[2][9] = {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 0, 1, 0, 0, 1, 1, 0}};

static void reads_binary(void) {
    test("A binary file is read and welded, also when it begins with solid");
    static const char *const HEADS[] = {"", "solid", "solid name\nfacet normal 0 0 1\n"};
    static const char *const NAMES[] = {FILE_NAME, MESH_FOLDER "stl_no_name"};
    for (int i = 0; i < 6; i++) {
        const blob b = binary(HEADS[i / 2], 2, TWO, 2);
        mesh m = must_read_blob(NAMES[i % 2], &b);
        check_vertices(&m, CORNERS, 4);
        check_triangles(&m, PAIR, 2);
        mesh_free(&m);
    }
}

static void reads_ascii(void) {
    test("An ASCII file is read and welded, whatever its line ends and its name");
    static const char *const FORMS[] = {
        "solid\n" FACET("0 0 0", "1 0 0", "0 1 0") FACET("0 1 0", "1 0 0", "1 1 0") "endsolid\n",
        "  solid facet vertex endsolid\r\n" FACET("0 0 0", "1 0 0", "0 1 0")
            FACET("0 1 0", "1 0 0", "1 1 0") "endsolid facet vertex",
        "solid a\nfacet normal nan nan nan outer loop vertex 0 0 0 vertex 1e0 0 0 vertex 0 1 0 "
        "endloop endfacet endsolid a\n\nsolid b\n" FACET("0 1 0", "1 0 0", "1 1 0") "endsolid b\n",
    };
    static const char *const NAMES[] = {FILE_NAME, MESH_FOLDER "stl_no_name"};
    for (int i = 0; i < 6; i++) {
        mesh m = must_read_text(NAMES[i % 2], FORMS[i / 2]);
        check_vertices(&m, CORNERS, 4);
        check_triangles(&m, PAIR, 2);
        mesh_free(&m);
    }
}

static void welds_bits(void) {
    test("Only equal bits are welded: 0 and -0, 1 and its neighbour stay apart");
    mesh m = must_read_text(FILE_NAME, "solid\n" FACET("0 0 0", "1 0 0", "1 0 -0.0")
                                           FACET("1.00000012 0 0", "1.0 0 0", "0 0 0") "endsolid");
    check_vertices(&m, (const float[]){0, 0, 0, 1, 0, 0, 1, 0, -0.0f, 1.00000012f, 0, 0}, 4);
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 3, 1, 0}, 2);
    mesh_free(&m);
}

static void keeps_degenerate(void) {
    test("Triangles that collapse to a point or a line keep their number");
    mesh m = must_read_text(FILE_NAME, "solid\n" FACET("7 7 7", "7 7 7", "7 7 7")
                                           FACET("0 0 0", "1 0 0", "7 7 7") "endsolid");
    check_triangles(&m, (const uint32_t[]){0, 0, 0, 1, 2, 0}, 2);
    mesh_free(&m);
}

/* A grid of `side` by `side` squares of two triangles each. */
static void welds_many(void) {
    test("A grid of 131,072 triangles welds to its 66,049 corners");
    enum { SIDE = 256 };
    const size_t triangles = 2 * SIDE * SIDE, size = 84 + 50 * triangles;
    unsigned char *bytes = calloc(1, size);
    const uint32_t count = (uint32_t)triangles;
    memcpy(bytes + 80, &count, 4);
    for (size_t i = 0; i < triangles; i++) {
        const size_t square = i / 2;
        for (size_t k = 0; k < 3; k++) {
            const size_t corner = i % 2 ? 3 - k : k;
            const float position[3] = {(float)(square % SIDE + corner % 2),
                                       (float)(square / SIDE + corner / 2), 0.5f};
            memcpy(bytes + 84 + 50 * i + 12 + 12 * k, position, 12);
        }
    }
    file_write(FILE_NAME, bytes, size);
    free(bytes);
    mesh m = {0};
    mesh_report report = {0};
    fail f = {{0}};
    CHECK(mesh_read(&m, FILE_NAME, 0, &report, &f) == 0, "%s", f.text);
    CHECK(m.vertices == (SIDE + 1) * (SIDE + 1), "%zu vertices", m.vertices);
    CHECK(m.triangles == triangles, "%zu triangles", m.triangles);
    for (size_t i = 0; i < m.triangles; i++) {
        for (size_t k = 0; k < 3; k++) {
            const size_t corner = i % 2 ? 3 - k : k, square = i / 2;
            const float *v = m.vertex + 3 * (size_t)m.triangle[3 * i + k];
            CHECK(v[0] == (float)(square % SIDE + corner % 2) &&
                      v[1] == (float)(square / SIDE + corner / 2) && v[2] == 0.5f,
                  "triangle %zu corner %zu at %g %g", i, k, (double)v[0], (double)v[1]);
        }
    }
    mesh_free(&m);
}

static void refuses_binary(void) {
    test("A binary file of the wrong size is refused with both sizes");
    blob b = binary("", 3, TWO, 2);
    b.size = 183;
    must_fail_blob(FILE_NAME, &b,
                   "byte 80: 3 triangles take 234 bytes, but the file has 183; "
                   "it is cut short or no STL: get it again");
    b = binary("", UINT32_MAX, TWO, 2);
    b.size = 183;
    must_fail_blob(FILE_NAME, &b,
                   "byte 80: 4294967295 triangles take 214748364834 bytes, but the file has 183; "
                   "it is cut short or no STL: get it again");
    b = binary("", 1, TWO, 2);
    b.size = 183;
    must_fail_blob(FILE_NAME, &b,
                   "byte 134: 49 bytes more than the triangle count at byte 80 says; "
                   "remove them or use pack --repair to ignore them");
    b.size = 184;
    b.size = 83;
    must_fail_blob(FILE_NAME, &b,
                   "byte 83: ends inside the 84 byte header of a binary STL; get it again");
}

static void refuses_bad_vertices(void) {
    test("A vertex that is not finite or too large is refused where it stands");
    float triangle[2][9];
    memcpy(triangle, TWO, sizeof triangle);
    triangle[1][4] = INFINITY;
    const blob b = binary("", 2, (const float(*)[9])triangle, 2);
    must_fail_blob(FILE_NAME, &b,
                   "triangle 1 at byte 134: the vertex (1 inf 0) is not finite or beyond +-2^40; "
                   "correct it or its unit, or use pack --repair to drop it");
    must_fail_text(FILE_NAME, "solid\n" FACET("0 0 0", "1e20 0 0", "0 1 0") "endsolid\n",
                   "line 5: the vertex (1e+20 0 0) is not finite or beyond +-2^40; "
                   "correct it or its unit, or use pack --repair to drop it");
}

static void refuses_ascii(void) {
    test("ASCII that breaks off or strays is refused with the line");
    must_fail_text(FILE_NAME, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n",
                   "line 4: the file ends where 'a number' belongs; get it again");
    must_fail_text(FILE_NAME, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n",
                   "line 4: 'zero' where 'a number' belongs; correct it");
    must_fail_text(FILE_NAME, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nfacet\n",
                   "line 5: 'facet' where 'vertex' belongs; correct it");
    must_fail_text(FILE_NAME,
                   "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nendloop\n",
                   "line 6: a face of 2 corners; use pack --repair to drop it");
    must_fail_text(FILE_NAME, "solid\nhello\n",
                   "line 2: 'hello' where 'facet or endsolid' belongs; correct it");
    must_fail_text(FILE_NAME, "solid\nendsolid\nhello\n",
                   "line 3: 'hello' where 'solid' belongs; correct it");
}

static void repairs(void) {
    test("Repair drops triangles with a bad corner, which welds with no good one");
    mesh m = {0};
    mesh_report report = {.repair = 1};
    fail f;
    CHECK(read_text(&m, FILE_NAME,
                    "solid\n" FACET("nan 0 0", "1 0 0", "0 0 0") FACET("0 0 0", "1 0 0", "0 1 0")
                        FACET("nan 0 0", "inf 0 0", "0 0 0") "endsolid\n",
                    &report, &f) == 0,
          "%s", f.text);
    check_vertices(&m, (const float[]){0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, 6);
    check_triangles(&m, (const uint32_t[]){2, 1, 3}, 1);
    CHECK(report.count[REPORT_BAD_VERTICES] == 3, "%llu",
          (unsigned long long)report.count[REPORT_BAD_VERTICES]);
    CHECK(report.count[REPORT_BAD_FACES] == 2, "%llu",
          (unsigned long long)report.count[REPORT_BAD_FACES]);
    mesh_free(&m);
}

static void empty_solids(void) {
    test("A file without triangles is an empty mesh");
    mesh m = must_read_text(FILE_NAME, "solid\nendsolid\n");
    CHECK(m.vertices == 0 && m.triangles == 0, "%zu triangles", m.triangles);
    mesh_free(&m);
    const blob b = binary("", 0, TWO, 0);
    m = must_read_blob(FILE_NAME, &b);
    CHECK(m.vertices == 0 && m.triangles == 0, "%zu triangles", m.triangles);
    mesh_free(&m);
}

static void appends(void) {
    test("Corners are welded within a file, not with what the mesh had");
    const blob b = binary("", 2, TWO, 2);
    mesh m = must_read_blob(FILE_NAME, &b);
    mesh_report report = {0};
    fail f;
    CHECK(read_blob(&m, FILE_NAME, &b, &report, &f) == 0, "%s", f.text);
    CHECK(m.vertices == 8, "%zu vertices", m.vertices);
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7}, 4);
    mesh_free(&m);
}

int main(void) {
    mesh_folder();
    reads_binary();
    reads_ascii();
    welds_bits();
    keeps_degenerate();
    welds_many();
    refuses_binary();
    refuses_bad_vertices();
    refuses_ascii();
    repairs();
    empty_solids();
    appends();
    return test_done();
}
