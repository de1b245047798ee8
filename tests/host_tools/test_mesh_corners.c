/* test_mesh_corners - normals, colours and texture coordinates of PLY and OBJ, corner by corner,
 * and smoothing
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "engine/base/float_bits.h"
#include "host_tools/mesh/smooth.h"
#include "tests/hostile/mesh_files.h"
#include "tests/reference/shapes.h"

#define OBJ MESH_FOLDER "corners.obj"
#define PLY MESH_FOLDER "corners.ply"
#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
#define MORE "0 0 0 0 0 1 0 0 0 0\n0 0 0 0 0 1 0 0 0 0\n3 0 1 2\n"
#define HEADER(type)                                                                               \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"                \
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"                  \
    "property " type " red\nproperty " type " green\nproperty " type                               \
    " blue\n"                                                                                      \
    "property " type                                                                               \
    " alpha\nelement face 1\nproperty list uchar int vertex_indices\n"                             \
    "end_header\n"

static mesh_corners c;

static mesh read_corners(const char *path, const char *text, int repair, mesh_report *report,
                         fail *f) {
    mesh m = {.corners = &c};
    corners_free(&c);
    c = (mesh_corners){.wants_normals = 1, .wants_colours = 1, .wants_texcoords = 1};
    *report = (mesh_report){.repair = repair};
    file_write(path, text, strlen(text));
    mesh_read(&m, path, 0, report, f);
    return m;
}

static mesh must_read(const char *path, const char *text) {
    mesh_report report;
    fail f = {""};
    mesh m = read_corners(path, text, 0, &report, &f);
    CHECK(f.text[0] == '\0', "%s", f.text);
    return m;
}

static void must_fail(const char *path, const char *text, const char *sentence) {
    mesh_report report;
    fail f = {""};
    mesh m = read_corners(path, text, 0, &report, &f);
    CHECK(strstr(f.text, sentence) != NULL, "'%s', not '%s'", f.text, sentence);
    CHECK(m.triangles == 0 && m.vertices == 0, "something was left");
    mesh_free(&m);
}

/* Whether a corner has that normal, to 1e-4. */
static void has_normal(size_t at, double x, double y, double z) {
    double n[3];
    const double length = sqrt(x * x + y * y + z * z);
    CHECK(c.normal != NULL && at < 3 * c.triangles, "corner %zu is not there", at);
    corner_direction(c.normal[at], n);
    CHECK(fabs(n[0] - x / length) + fabs(n[1] - y / length) + fabs(n[2] - z / length) < 1e-4,
          "corner %zu: (%g %g %g) for (%g %g %g)", at, n[0], n[1], n[2], x, y, z);
}

static void has_colour(size_t at, uint32_t red, uint32_t green, uint32_t blue) {
    CHECK(c.colour != NULL && at < 3 * c.triangles, "corner %zu is not there", at);
    CHECK(c.colour[at] == corner_colour(red, green, blue), "corner %zu: %08x", at, c.colour[at]);
}

static void has_texcoord(size_t at, double u, double v) {
    CHECK(c.texcoord[1] != NULL && at < 3 * c.triangles, "corner %zu is not there", at);
    CHECK(c.texcoord[0][at] == corner_texcoord(u) && c.texcoord[1][at] == corner_texcoord(v),
          "corner %zu: (%g %g) for (%g %g)", at, (double)plt_float_of(c.texcoord[0][at]),
          (double)plt_float_of(c.texcoord[1][at]), u, v);
}

static void has_no_texcoord(size_t at) {
    CHECK(c.texcoord[0] == NULL ||
              (c.texcoord[0][at] == CORNER_NO_TEXCOORD && c.texcoord[1][at] == CORNER_NO_TEXCOORD),
          "corner %zu has some", at);
}

static void reads_obj(void) {
    test("OBJ: a corner has the normal that it names, by number or counted back, wherever it is");
    mesh m = must_read(OBJ,
                       "v 0 0 0 0.2 0.4 1\nv 1 0 0 1 0.2 0.4 1\nv 1 1 0 0 0 0\n"
                       "vn 0 0 5\nf 1//1 2//-1 3//2\nvn 1 2 3\nf 3 2//1 1//\n");
    has_normal(0, 0, 0, 1);
    has_normal(1, 0, 0, 1);
    has_normal(2, 1, 2, 3);
    has_normal(4, 0, 0, 1);
    CHECK(c.normal[3] == CORNER_NO_NORMAL && c.normal[5] == CORNER_NO_NORMAL, "it names none");
    CHECK(c.normals == 4 && c.colours == 6, "%llu and %llu", (unsigned long long)c.normals,
          (unsigned long long)c.colours);
    has_colour(0, 51, 102, 255);
    has_colour(1, 51, 102, 255); /* behind a weight */
    has_colour(2, 0, 0, 0);
    has_colour(3, 0, 0, 0);
    mesh_free(&m);
}

static void reads_obj_textures(void) {
    test("OBJ: ... and the texture coordinates, of one number to three, whatever their size");
    mesh m = must_read(OBJ, SQUARE
                       "vt 0.25 0.5\nvt 0.75 # one\nvn 0 0 1\nf 1/1/1 2/2 3/-2/1 4//1\n"
                       "vt -3 17.5 2\nvt -0 65536\nf 1/4 2/3/1 3\n");
    CHECK(m.triangles == 3 && c.texcoords == 7, "%zu triangles, %llu", m.triangles,
          (unsigned long long)c.texcoords);
    static const double due[4][2] = {{0.25, 0.5}, {0.75, 0}, {0.25, 0.5}, {NAN, NAN}};
    for (size_t i = 0; i < 6; i++) { /* of the square, however it is cut */
        if (m.triangle[i] == 3) {
            has_no_texcoord(i);
        } else {
            has_texcoord(i, due[m.triangle[i]][0], due[m.triangle[i]][1]);
        }
        if (m.triangle[i] == 1) {
            CHECK(c.normal[i] == CORNER_NO_NORMAL, "corner %zu names no normal", i);
        } else {
            has_normal(i, 0, 0, 1);
        }
    }
    has_texcoord(6, 0, 65536);
    has_texcoord(7, -3, 17.5);
    has_no_texcoord(8);
    CHECK(c.normals == 6, "%llu", (unsigned long long)c.normals);
    mesh_free(&m);
    m = must_read(OBJ, SQUARE "vt 0 0\nvt 0 1\nvt 1 1\nf 1 2 3\n");
    CHECK(c.texcoords == 0, "those that no corner names are somebody's");
    mesh_free(&m);
}

static void refuses_obj_textures(void) {
    test("OBJ: texture coordinates that are none, or not there, are refused, with their line");
    must_fail(OBJ, SQUARE "vt nan 0\n",
              "line 5: the texture coordinates (nan 0) are not finite or beyond +-65536; correct "
              "them, or use pack --repair to do without them");
    must_fail(OBJ, SQUARE "vt 0 -inf\n", "line 5: the texture coordinates (0 -inf)");
    must_fail(OBJ, SQUARE "vt 65536.1 0\n", "line 5: the texture coordinates (65536.1 0)");
    must_fail(OBJ, SQUARE "vt\n", "line 5: a coordinate is missing; correct the line");
    must_fail(OBJ, SQUARE "vt 1 x\n", "line 5: 'x' where a coordinate belongs");
    must_fail(OBJ, SQUARE "vt 0 0\nf 1/1 2/1 3/2\nf 1 2 3\n",
              "line 6: uses texture coordinate 2, which is not among the 1 texture coordinates; "
              "correct it, or use pack --repair to do without it");
    must_fail(OBJ, SQUARE "vt 0 0\nf 1/1 2/-2 3/1\n",
              "line 6: uses texture coordinate -2, which is not among the 1 texture coordinates so "
              "far; correct it, or use pack --repair to do without it");
    must_fail(OBJ, SQUARE "vt 0 0\nf 1/1 2/0 3/1\n", "line 6: uses texture coordinate 0, which");
    must_fail(OBJ, SQUARE "vt 0 0\nf 1/1 2/y/1 3/1\n",
              "line 6: '2/y/1' where a texture coordinate's number belongs; correct the line");
    mesh_report report;
    fail f = {""};
    mesh m = read_corners(OBJ, SQUARE "vt nan 0\nvt 2 3\nf 1/1 2/2 3/9\n", 1, &report, &f);
    CHECK(f.text[0] == '\0' && m.triangles == 1, "%s", f.text);
    CHECK(report.count[REPORT_BAD_TEXTURES] == 1, "%llu",
          (unsigned long long)report.count[REPORT_BAD_TEXTURES]);
    has_no_texcoord(0);
    has_texcoord(1, 2, 3);
    has_no_texcoord(2);
    mesh_free(&m);
}

#define TEXTURED(u, v, list)                                                                       \
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float " u                                   \
    "\nproperty float x\n"                                                                         \
    "property float y\nproperty float z\nproperty double " v "\nelement face 2\n" list             \
    "end_header\n"
#define INDICES "property list uchar int vertex_indices\n"
#define TEXCOORDS "property list uchar float texcoord\n"
#define CORNERS "0 0 0 0 0\n2 1 0 0 0.5\n-1 1 1 0 0.25\n7 0 1 0 0.75\n"

static void reads_ply_textures(void) {
    test("PLY: texture coordinates of vertices, by each of their names");
    static const char *const TEXTS[] = {
        TEXTURED("u", "v", INDICES), TEXTURED("s", "t", INDICES), TEXTURED("S0", "T0", INDICES),
        TEXTURED("texture_u", "texture_v", INDICES), TEXTURED("texture_s", "texture_t", INDICES)};
    for (size_t i = 0; i < 5; i++) {
        char text[600];
        snprintf(text, sizeof text, "%s" CORNERS "4 0 1 2 3\n3 2 0 1\n", TEXTS[i]);
        mesh m = must_read(PLY, text);
        static const double due[4][2] = {{0, 0}, {2, 0.5}, {-1, 0.25}, {7, 0.75}};
        CHECK(m.triangles == 3 && c.texcoords == 9, "%zu triangles", m.triangles);
        for (size_t k = 0; k < 9; k++) {
            has_texcoord(k, due[m.triangle[k]][0], due[m.triangle[k]][1]);
        }
        mesh_free(&m);
    }
}

static void reads_ply_lists(void) {
    test("PLY: texture coordinates of a face's corners, before its vertices and behind; none, too");
    static const char *const TEXTS[] = {TEXTURED("u", "v", INDICES TEXCOORDS) CORNERS
                                        "4 0 1 2 3 8 0 1 2 3 4 5 6 7\n3 2 0 1 6 9 8 7 6 5 4\n",
                                        TEXTURED("u", "v", TEXCOORDS INDICES) CORNERS
                                        "8 0 1 2 3 4 5 6 7 4 0 1 2 3\n6 9 8 7 6 5 4 3 2 0 1\n",
                                        TEXTURED("u", "v", INDICES TEXCOORDS) CORNERS
                                        "4 0 1 2 3 0\n3 2 0 1 6 9 8 7 6 5 4\n"};
    for (size_t i = 0; i < 3; i++) {
        mesh m = must_read(PLY, TEXTS[i]);
        CHECK(m.triangles == 3 && c.texcoords == (i < 2 ? 9 : 3), "%zu triangles", m.triangles);
        for (size_t k = 0; k < 6; k++) {
            if (i < 2) {
                has_texcoord(k, 2 * m.triangle[k], 2 * m.triangle[k] + 1);
            } else {
                has_no_texcoord(k);
            }
        }
        for (size_t k = 0; k < 3; k++) {
            has_texcoord(6 + k, 9.0 - 2 * (double)k, 8.0 - 2 * (double)k);
        }
        mesh_free(&m);
    }
}

static void refuses_ply_textures(void) {
    test("PLY: lists of other lengths, and numbers that are none, are refused, with the face");
    static const char ODD[] = TEXTURED("u", "v", INDICES TEXCOORDS) CORNERS
        "3 0 1 2 5 0 1 2 3 4\n3 2 0 1 8 9 8 7 6 5 4 3 2\n";
    must_fail(PLY, ODD,
              "line 17, face 0: 5 numbers in its list texcoord, where its corners need 6; correct "
              "it, or use pack --repair to do without it");
    must_fail(PLY,
              TEXTURED("u", "v", INDICES TEXCOORDS) CORNERS
              "3 0 1 2 6 0 1 2 3 4 5\n3 2 0 1 8 9 8 7 6 5 4 3 2\n",
              "line 18, face 1: 8 numbers in its list texcoord, where its corners need 6");
    must_fail(PLY,
              TEXTURED("u", "v", INDICES TEXCOORDS) CORNERS
              "3 0 1 2 6 0 1 2 nan 4 5\n3 2 0 1 6 9 8 7 6 5 4\n",
              "line 17, face 0: the texture coordinates (2 nan) are not finite");
    mesh_report report;
    fail f = {""};
    mesh m = read_corners(PLY, ODD, 1, &report, &f);
    CHECK(f.text[0] == '\0' && m.triangles == 2, "%s", f.text);
    has_texcoord(0, 0, 1);
    has_texcoord(1, 2, 3);
    has_no_texcoord(2);
    has_texcoord(3, 9, 8);
    has_texcoord(5, 5, 4);
    CHECK(report.count[REPORT_TEXTURES] == 4, "those of vertices are left out: %llu",
          (unsigned long long)report.count[REPORT_TEXTURES]);
    mesh_free(&m);
}

/* Their numbers are not those of vertices. */
static void reads_unnamed(void) {
    test("OBJ: normals that no corner names are nobody's");
    mesh m = must_read(OBJ, "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\nf 1 2 3\n");
    for (size_t i = 0; i < 3; i++) {
        CHECK(c.normal == NULL || c.normal[i] == CORNER_NO_NORMAL, "corner %zu has one", i);
    }
    CHECK(c.normals == 0 && m.triangles == 1, "%llu", (unsigned long long)c.normals);
    mesh_free(&m);
}

/* A dart is filled from its notch, not from its first corner. */
static void reads_polygons(void) {
    test("OBJ: corners of polygons keep their normals, however they are cut");
    mesh m = must_read(OBJ,
                       "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\n"
                       "vn 1 1 1\nf 2//2 3//3 4//4 1//1\nf 1 2 3\n");
    static const double due[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    CHECK(m.triangles == 3, "%zu triangles", m.triangles);
    for (size_t i = 0; i < 6; i++) {
        const double *n = due[m.triangle[i]];
        has_normal(i, n[0], n[1], n[2]);
    }
    for (size_t i = 6; i < 9; i++) {
        CHECK(c.normal[i] == CORNER_NO_NORMAL, "corner %zu names one", i);
    }
    mesh_free(&m);
}

static void refuses_obj(void) {
    test("OBJ: normals and colours that are none are refused, with their line");
    must_fail(
        OBJ, SQUARE "vn 0 0 nan\nf 1//1 2//1 3//1\n",
        "line 5: the normal (0 0 nan) is not finite or has no length; correct it, or use pack "
        "--repair to do without it");
    must_fail(OBJ, SQUARE "vn 0 0 0\nf 1//1 2//1 3//1\n", "line 5: the normal (0 0 0)");
    must_fail(OBJ, SQUARE "vn inf 0 0\n", "line 5: the normal (inf 0 0)");
    must_fail(OBJ, SQUARE "vn 0 0\n", "line 5: a coordinate is missing; correct the line");
    must_fail(OBJ, SQUARE "vn 0 0 1\nf 1//1 2//1 3//2\nf 1 2 3\n",
              "line 6: uses normal 2, which is not among the 1 normals; correct it, or use pack "
              "--repair to do without it");
    must_fail(OBJ, SQUARE "vn 0 0 1\nf 1//1 2//-2 3//1\n",
              "line 6: uses normal -2, which is not among the 1 normals so far; correct it, or use "
              "pack --repair to do without it");
    must_fail(OBJ, SQUARE "vn 0 0 1\nf 1//1 2//0 3//1\n", "line 6: uses normal 0, which");
    must_fail(OBJ, SQUARE "vn 0 0 1\nf 1//1 2//x 3//1\n",
              "line 6: '2//x' where a normal's number belongs; correct the line");
    must_fail(OBJ, "v 0 0 0 1 0 1.5\n",
              "line 1: the colour (1 0 1.5) is not of 0 to 1 each; correct it, or use pack "
              "--repair to do without it");
    must_fail(OBJ, "v 0 0 0 -0.1 0 1\n", "line 1: the colour (-0.1 0 1)");
}

static void repairs(void) {
    test("With repair they are left out, and counted; corners that name them have none");
    mesh_report report;
    fail f = {""};
    mesh m = read_corners(OBJ, SQUARE "v 0 0 0 7 7 7\nvn 0 0 0\nvn 0 0 1\nf 1//1 2//2 3//9\n", 1,
                          &report, &f);
    CHECK(f.text[0] == '\0' && m.triangles == 1, "%s", f.text);
    CHECK(report.count[REPORT_BAD_NORMALS] == 1 && report.count[REPORT_BAD_COLOURS] == 1,
          "%llu and %llu", (unsigned long long)report.count[REPORT_BAD_NORMALS],
          (unsigned long long)report.count[REPORT_BAD_COLOURS]);
    CHECK(c.normal[0] == CORNER_NO_NORMAL && c.normal[2] == CORNER_NO_NORMAL, "it has one");
    has_normal(1, 0, 0, 1);
    mesh_free(&m);
}

static void reads_ply(void) {
    test("PLY: normals and colours of vertices, of uchar, ushort and float");
    static const struct {
        const char *type, *most;
    } TYPES[] = {{"uchar", "255"}, {"ushort", "65535"}, {"float", "1"}, {"double", "1"}};
    for (size_t i = 0; i < 4; i++) {
        char text[900], header[600];
        snprintf(header, sizeof header, "%s",
                 i == 0   ? HEADER("uchar")
                 : i == 1 ? HEADER("ushort")
                 : i == 2 ? HEADER("float")
                          : HEADER("double"));
        snprintf(text, sizeof text,
                 "%s0 0 0 0 0 2 %s 0 0 0\n1 0 0 0 3 4 0 %s 0 0\n"
                 "1 1 0 -1 0 0 0 0 %s 0\n3 2 0 1\n",
                 header, TYPES[i].most, TYPES[i].most, TYPES[i].most);
        mesh m = must_read(PLY, text);
        has_normal(0, -1, 0, 0);
        has_normal(1, 0, 0, 1);
        has_normal(2, 0, 3, 4);
        has_colour(0, 0, 0, 255);
        has_colour(1, 255, 0, 0);
        has_colour(2, 0, 255, 0);
        mesh_free(&m);
    }
}

static void refuses_ply(void) {
    test("PLY: the same mistakes are refused, with the vertex");
    must_fail(PLY, HEADER("uchar") "0 0 0 0 0 1 0 0 0 0\n1 0 0 0 0 1 0 300 0 0\n" MORE,
              "line 18, vertex 1: the colour (0 300 0) is not of 0 to 255 each; correct it, or "
              "use pack --repair to do without it");
    must_fail(PLY, HEADER("float") "0 0 0 0 0 0 0 0 0 0\n" MORE,
              "line 17, vertex 0: the normal (0 0 0) is not finite or has no length");
    must_fail(PLY, HEADER("float") "0 0 0 0 0 1 0 0 2 0\n" MORE,
              "line 17, vertex 0: the colour (0 0 2) is not of 0 to 1 each");
}

static void reads_no_others(void) {
    test("What nobody wants, and colours of other types, are counted as left out");
    mesh_report report;
    fail f = {""};
    const char *rest = "0 0 0 0 0 1 9 0 0 0\n1 0 0 0 0 1 0 0 0 0\n1 1 0 0 0 1 0 0 0 0\n3 0 1 2\n";
    char text[900];
    snprintf(text, sizeof text, "%s%s", HEADER("int"), rest);
    mesh m = read_corners(PLY, text, 0, &report, &f);
    CHECK(report.count[REPORT_COLOURS] == 3 && report.count[REPORT_NORMALS] == 0, "%llu, %llu",
          (unsigned long long)report.count[REPORT_COLOURS],
          (unsigned long long)report.count[REPORT_NORMALS]);
    CHECK(c.colour == NULL && c.colours == 0, "there are colours");
    mesh_free(&m);
    m = (mesh){0};
    report = (mesh_report){0};
    CHECK(mesh_read(&m, PLY, 0, &report, &f) == 0, "%s", f.text);
    CHECK(report.count[REPORT_COLOURS] == 3 && report.count[REPORT_NORMALS] == 3, "not counted");
    mesh_free(&m);
}

static void turns(void) {
    test("A recipe turns normals with their mesh; meshes that have none leave theirs alone");
    static const char QUARTER[] =
        "plain.obj 1 0 0 0\ncorners.obj 1 0 0 0 90 0\nplain.obj 1 5 0 0\n";
    file_write(MESH_FOLDER "plain.obj", SQUARE "f 1 2 3\n", sizeof SQUARE "f 1 2 3\n" - 1);
    file_write(OBJ, SQUARE "vn 0 1 0\nf 1//1 2//1 3//1\n",
               sizeof SQUARE "vn 0 1 0\nf 1//1 2//1 3//1\n" - 1);
    mesh m = must_read(MESH_FOLDER "corners.txt", QUARTER);
    CHECK(m.triangles == 3 && c.normals == 3, "%zu triangles", m.triangles);
    CHECK(corners_want_normals(&c, m.triangles) == 0, "no memory");
    for (size_t i = 0; i < 9; i++) {
        if (i / 3 == 1) {
            has_normal(i, 0, 0, 1);
        } else {
            CHECK(c.normal[i] == CORNER_NO_NORMAL, "corner %zu has one", i);
        }
    }
    mesh_free(&m);
}

/* ---- smoothing --------------------------------------------------------------------------- */

static void smooth(const mesh *m, double degrees) {
    corners_free(&c);
    CHECK(mesh_smooth(m, degrees, &c) == 0, "no memory");
}

static void smooths_cube(void) {
    test("A cube's corners point along its diagonals, or below its crease along its sides");
    mesh m = {0};
    shape_cube(&m);
    smooth(&m, 90.001);
    for (size_t i = 0; i < 36; i++) { /* weights are angles: how sides are cut does not matter */
        const float *p = m.vertex + 3 * (size_t)m.triangle[i];
        has_normal(i, (double)p[0], (double)p[1], (double)p[2]);
    }
    smooth(&m, 89.9);
    for (size_t i = 0; i < 36; i++) {
        double n[3];
        corner_direction(c.normal[i], n);
        CHECK(fmax(fabs(n[0]), fmax(fabs(n[1]), fabs(n[2]))) > 0.99999, "corner %zu", i);
    }
    mesh_free(&m);
}

/* A fan of `sides` triangles around the top of a cone. */
static void smooths_fans(void) {
    test("The tip of a cone points up, of however many triangles");
    static const unsigned SIDES[] = {3, 64, 65, 5000};
    for (size_t k = 0; k < 4; k++) {
        mesh m = {0};
        fail f = {""};
        const unsigned n = SIDES[k];
        mesh_add_vertex(&m, 0, 1, 0, &f);
        for (unsigned i = 0; i < n; i++) {
            const double angle = 6.283185307179586 * i / n;
            mesh_add_vertex(&m, (float)cos(angle), 0, (float)-sin(angle), &f);
        }
        for (uint32_t i = 0; i < n; i++) {
            mesh_add_triangle(&m, 0, 1 + i, 1 + (i + 1) % n, &f);
        }
        smooth(&m, 180);
        double up[3];
        corner_direction(c.normal[0], up);
        CHECK(up[1] > 0.9999, "%u sides: (%g %g %g)", n, up[0], up[1], up[2]);
        mesh_free(&m);
    }
}

static void smooths_slivers(void) {
    test("Triangles without area give nothing to others, and have no normal of their own");
    mesh m = {0};
    fail f = {""};
    mesh_add_vertex(&m, 0, 0, 0, &f);
    mesh_add_vertex(&m, 1, 0, 0, &f);
    mesh_add_vertex(&m, 1, 1, 0, &f);
    mesh_add_vertex(&m, 2, 0, 0, &f);
    mesh_add_triangle(&m, 0, 1, 2, &f);
    mesh_add_triangle(&m, 0, 1, 3, &f);
    mesh_add_triangle(&m, 0, 0, 2, &f);
    smooth(&m, 180);
    for (size_t i = 0; i < 9; i++) {
        if (i < 3) {
            has_normal(i, 0, 0, 1);
        } else {
            CHECK(c.normal[i] == CORNER_NO_NORMAL, "corner %zu has one", i);
        }
    }
    mesh_free(&m);
    m = (mesh){0}; /* two sides of one sheet cancel out: each has its own */
    mesh_add_vertex(&m, 0, 0, 0, &f);
    mesh_add_vertex(&m, 1, 0, 0, &f);
    mesh_add_vertex(&m, 1, 1, 0, &f);
    mesh_add_triangle(&m, 0, 1, 2, &f);
    mesh_add_triangle(&m, 0, 2, 1, &f);
    smooth(&m, 180);
    for (size_t i = 0; i < 6; i++) {
        has_normal(i, 0, 0, i < 3 ? 1 : -1);
    }
    mesh_free(&m);
}

int main(void) {
    mesh_folder();
    reads_obj();
    reads_obj_textures();
    reads_unnamed();
    reads_polygons();
    refuses_obj();
    refuses_obj_textures();
    repairs();
    reads_ply();
    refuses_ply();
    reads_ply_textures();
    reads_ply_lists();
    refuses_ply_textures();
    reads_no_others();
    turns();
    smooths_cube();
    smooths_fans();
    smooths_slivers();
    corners_free(&c);
    return test_done();
}
