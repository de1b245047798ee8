/* test_mesh_obj - the OBJ reader, value by value
 *
 * SPDX-License-Identifier: MIT */
#include <locale.h>

#include "tests/hostile/mesh_files.h"

#define FILE_NAME MESH_FOLDER "case.obj"
#define THREE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

static const float CORNERS[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};

static void expect_triangles(const char *text, const uint32_t *expected, size_t triangles) {
    mesh m = must_read_text(FILE_NAME, text);
    check_triangles(&m, expected, triangles);
    mesh_free(&m);
}

static void reads_corners(void) {
    test("All four forms of a corner name the same vertex");
    static const char *const FACES[] = {"f 1 2 3\n", "f 1/9 2/8 3/7\n", "f 1/9/9 2/8/8 3/7/7\n",
                                        "f 1//4 2//5 3//6\n", "f +1 2/ 3//\n"};
    for (size_t i = 0; i < sizeof FACES / sizeof FACES[0]; i++) {
        char text[200];
        snprintf(text, sizeof text, THREE "%s", FACES[i]);
        mesh m = must_read_text(FILE_NAME, text);
        check_vertices(&m, CORNERS, 3);
        check_triangles(&m, (const uint32_t[]){0, 1, 2}, 1);
        mesh_free(&m);
    }
}

static void reads_polygons(void) {
    test("Polygons become fans, in the order of the file");
    expect_triangles(THREE "v 5 5 5\nv 6 6 6\nf 1 2 3 4 5\nf 5 4 3\n",
                     (const uint32_t[]){0, 1, 2, 0, 2, 3, 0, 3, 4, 4, 3, 2}, 4);
}

static void reads_relative(void) {
    test("Negative numbers count back from the last vertex so far");
    expect_triangles(THREE "f -3 -2 -1\nv 9 9 9\nf -1 -4 2\n", (const uint32_t[]){0, 1, 2, 3, 0, 1},
                     2);
}

static void reads_forward(void) {
    test("A face may stand before its vertices");
    expect_triangles("f 3 2 1\n" THREE, (const uint32_t[]){2, 1, 0}, 1);
    must_fail_text(FILE_NAME, "f 3 2 1\nf 1 9 2\nf 4 1 1\n" THREE,
                   "line 2: uses vertex 9, which is not among the 3 vertices; "
                   "use pack --repair to drop it");
}

static void reads_lines(void) {
    test("CRLF, CR, a byte order mark, blank lines and comments change nothing");
    expect_triangles(
        "\xef\xbb\xbf# head\r\n\r\nv 0 0 0\r\nv\t1 0 0 \r\nv 0 1 0\r\n"
        "f 1 2 3 # face\r\n",
        (const uint32_t[]){0, 1, 2}, 1);
    expect_triangles("v 0 0 0\rv 1 0 0\r  v 0 1 0\r\rf 1 2 3", (const uint32_t[]){0, 1, 2}, 1);
}

static void joins_lines(void) {
    test("A backslash joins lines, but not after a comment or an ignored line");
    mesh m = must_read_text(FILE_NAME,
                            "# C:\\path\\\nv 0 0 0\nv 1\\\n 0 0\r\nv 0 1\\\r\n\\\r\n0\n"
                            "mtllib C:\\here\\\nf 1 \\\n 2 3\\\n 1\n");
    check_vertices(&m, CORNERS, 3);
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 0, 2, 0}, 2);
    mesh_free(&m);
}

static void ignores_the_rest(void) {
    test("Weights, colours and all other keywords are passed over");
    mesh m = must_read_text(FILE_NAME,
                            "mtllib a.mtl\no thing\ng one two\nv 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\n"
                            "v 0 1 0 what ever\nvn 0 0 nan\nvt 0 0\nvp 1\ns off\nusemtl red\n"
                            "l 1 2\np 3\ncurv 0 1 2\nunheard-of \x80\xff\nf 1 2 3\nend\n");
    check_vertices(&m, CORNERS, 3);
    check_triangles(&m, (const uint32_t[]){0, 1, 2}, 1);
    mesh_free(&m);
}

static void keeps_degenerate(void) {
    test("Triangles with a repeated corner keep their number");
    expect_triangles(THREE "f 1 1 2\nf 1 2 3\nf 3 3 3\n",
                     (const uint32_t[]){0, 0, 1, 0, 1, 2, 2, 2, 2}, 3);
}

static void ignores_the_locale(void) {
    test("The locale changes no number (decimal comma, where one is installed)");
    static const char *const NAMES[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "C.UTF-8", "C"};
    size_t i = 0;
    while (i < 4 && !setlocale(LC_ALL, NAMES[i])) {
        i++;
    }
    printf("    locale %s\n", NAMES[i]);
    mesh m = must_read_text(FILE_NAME, "v 0.5 -1.25e-40 3.4028234663852886e+10\n");
    check_vertices(&m, (const float[]){0.5f, -1.25e-40f, 3.4028234663852886e+10f}, 1);
    mesh_free(&m);
    setlocale(LC_ALL, "C");
}

static void refuses(void) {
    test("What cannot be read is refused with the line and the remedy");
    must_fail_text(FILE_NAME, "v 0 0\n", "line 1: a coordinate is missing; correct the line");
    must_fail_text(FILE_NAME, THREE "v 0 0,5 0\n",
                   "line 4: '0,5' where a coordinate belongs; correct the line");
    must_fail_text(FILE_NAME, THREE "v 0 0x1p3 0\n",
                   "line 4: '0x1p3' where a coordinate belongs; correct the line");
    must_fail_text(FILE_NAME, THREE "\nf 1 2 x\n",
                   "line 5: 'x' where a vertex number belongs; correct the line");
    must_fail_text(FILE_NAME, THREE "f 1 2 /3\n",
                   "line 4: '/3' where a vertex number belongs; correct the line");
    must_fail_text(FILE_NAME, THREE "f 1 2 0\n",
                   "line 4: uses vertex 0, which is not among the 3 vertices; "
                   "use pack --repair to drop it");
    must_fail_text(FILE_NAME, THREE "f 1 2 -4\n",
                   "line 4: uses vertex -4, which is not among the 3 vertices; "
                   "use pack --repair to drop it");
    must_fail_text(FILE_NAME, THREE "f 1 2 99999999999999999999\n",
                   "line 4: uses vertex 9223372036854775807, which is not among the 3 vertices; "
                   "use pack --repair to drop it");
    must_fail_text(FILE_NAME, "v 0 0 0\nv 0 1e13 0\n",
                   "line 2: the vertex (0 1e+13 0) is not finite or beyond +-2^40; "
                   "correct it or its unit, or use pack --repair to drop it");
    must_fail_text(FILE_NAME, "hello\nworld\n",
                   "line 2: no line up to here is one of OBJ; check the file's format");
    must_fail_text(FILE_NAME, THREE "\x01\x02\n",
                   "line 4: '\?\?' is no text; check that this is an OBJ file");
}

static void repairs(void) {
    test("Repair drops and counts what cannot be traced");
    mesh m = {0};
    mesh_report report = {.repair = 1};
    fail f;
    const char *text = THREE
        "v nan 0 0\nf 1 2 3\nf 1 2 4\nf 0 1 2\nf 1 2\nf 1 2 5 3\n"
        "f 99999999999 1 2\nf 3 2 -9\nf 3 2 1\n";
    CHECK(read_text(&m, FILE_NAME, text, &report, &f) == 0, "%s", f.text);
    CHECK(m.vertices == 4 && m.vertex[9] == 0, "%zu vertices", m.vertices);
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 2, 1, 0}, 2);
    CHECK(report.count[REPORT_BAD_VERTICES] == 1, "%llu",
          (unsigned long long)report.count[REPORT_BAD_VERTICES]);
    CHECK(report.count[REPORT_BAD_FACES] == 5, "%llu",
          (unsigned long long)report.count[REPORT_BAD_FACES]); /* a quad is one */
    CHECK(report.count[REPORT_SMALL_FACES] == 1, "%llu",
          (unsigned long long)report.count[REPORT_SMALL_FACES]);
    mesh_free(&m);
}

static void found_by_content(void) {
    test("The content decides before the name, the name before a guess");
    mesh m = must_read_text(MESH_FOLDER "no_name", "# comment\n\n" THREE "f 1 2 3\n");
    CHECK(m.triangles == 1, "%zu triangles", m.triangles);
    mesh_free(&m);
    m = must_read_text(MESH_FOLDER "case.OBJ", "#\nunknown\n" THREE "f 1 2 3\n");
    CHECK(m.triangles == 1, "%zu triangles", m.triangles);
    mesh_free(&m);
    m = must_read_text(FILE_NAME,
                       "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\n"
                       "property int y\nproperty int z\nend_header\n1 2 3\n");
    CHECK(m.vertices == 1, "%zu vertices", m.vertices);
    mesh_free(&m);
    must_fail_text(MESH_FOLDER "no_name", "hello\n",
                   "is neither PLY nor OBJ nor STL, and no .txt recipe; convert it");
}

int main(void) {
    mesh_folder();
    reads_corners();
    reads_polygons();
    reads_relative();
    reads_forward();
    reads_lines();
    joins_lines();
    ignores_the_rest();
    keeps_degenerate();
    ignores_the_locale();
    refuses();
    repairs();
    found_by_content();
    return test_done();
}
