/* test_mesh_ply - the PLY reader and writer, value by value
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hostile/mesh_files.h"

#define FILE_NAME MESH_FOLDER "case.ply"
#define XYZ "property float x\nproperty float y\nproperty float z\n"
#define FACES "property list uchar int vertex_indices\n"

static const float SQUARE[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
static const uint32_t FAN[] = {0, 1, 2, 0, 2, 3};

static void reads_ascii(void) {
    test("An ASCII polygon becomes a fan around its first corner");
    mesh m = must_read_text(FILE_NAME,
                            "ply\nformat ascii 1.0\nelement vertex 4\n" XYZ "element face 1\n" FACES
                            "end_header\n"
                            "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    check_vertices(&m, SQUARE, 4);
    check_triangles(&m, FAN, 2);
    mesh_free(&m);
}

static void put_square(blob *b, int big, const char *line_end) {
    static const char *const LINES[] = {
        "ply",
        NULL,
        "element vertex 4",
        "property float x",
        "property float y",
        "property float z",
        "element face 1",
        "property list uchar int vertex_indices",
        "end_header",
    };
    for (size_t i = 0; i < sizeof LINES / sizeof LINES[0]; i++) {
        const char *format =
            big ? "format binary_big_endian 1.0" : "format binary_little_endian 1.0";
        put_text(b, LINES[i] ? LINES[i] : format);
        put_text(b, line_end);
    }
    for (int i = 0; i < 12; i++) {
        put_float(b, SQUARE[i], big);
    }
    put_number(b, 4, 1, big);
    for (uint32_t i = 0; i < 4; i++) {
        put_number(b, i, 4, big);
    }
}

static void reads_binary(void) {
    test("Both binary orders with LF, CRLF and CR headers give the same mesh");
    static const char *const ENDS[] = {"\n", "\r\n", "\r"};
    for (int i = 0; i < 6; i++) {
        blob b = {.size = 0};
        put_square(&b, i % 2, ENDS[i / 2]);
        mesh m = must_read_blob(FILE_NAME, &b);
        check_vertices(&m, SQUARE, 4);
        check_triangles(&m, FAN, 2);
        mesh_free(&m);
    }
}

static void keeps_line_feed_data(void) {
    test("Data that begins with a line feed byte after a CR header is data");
    blob b = {.size = 0};
    put_text(&b,
             "ply\rformat binary_little_endian 1.0\relement vertex 1\r"
             "property uchar x\rproperty uchar y\rproperty uchar z\rend_header\r\n\r ");
    mesh m = must_read_blob(FILE_NAME, &b);
    check_vertices(&m, (const float[]){10, 13, 32}, 1);
    mesh_free(&m);
}

static void skips_the_rest(void) {
    test("Other elements, other properties and lists are passed over, in any order");
    mesh m =
        must_read_text(FILE_NAME,
                       "ply\nformat ascii 1.0\ncomment one\nobj_info two\n"
                       "element camera 2\nproperty list uchar float view\nproperty double f\n"
                       "element face 2\nproperty uchar red\n"
                       "property list int uint vertex_index\nproperty list uchar float texcoord\n"
                       "element vertex 3\nproperty uchar red\nproperty float z\n"
                       "property list uchar int n\nproperty float x\nproperty float y\n"
                       "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
                       "3 1 2 3 4.5\n0 1e400\n"
                       "9 3 0 1 2 2 0.5 0.5\n8 3 2 1 0 0\n"
                       "255 3 2 77 78 1 2\n255 6 0 4 5\n255 9 1 1 7 8\n"
                       "0 1\n\n\n");
    check_vertices(&m, (const float[]){1, 2, 3, 4, 5, 6, 7, 8, 9}, 3);
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 2, 1, 0}, 2);
    mesh_free(&m);
}

static void skips_binary_lists(void) {
    test("Binary lists before, between and after the positions are passed over");
    for (int big = 0; big < 2; big++) {
        blob b = {.size = 0};
        put_text(&b, "ply\nformat ");
        put_text(&b, big ? "binary_big_endian" : "binary_little_endian");
        put_text(&b,
                 " 1.0\nelement vertex 1\nproperty list ushort double a\nproperty float x\n"
                 "property list int uchar b\nproperty float y\nproperty float z\n"
                 "property list uchar short c\nend_header\n");
        put_number(&b, 2, 2, big);
        put_double(&b, 1.5, big);
        put_double(&b, 2.5, big);
        put_float(&b, 1, big);
        put_number(&b, 3, 4, big);
        put_text(&b, "abc");
        put_float(&b, 2, big);
        put_float(&b, 3, big);
        put_number(&b, 0, 1, big);
        mesh m = must_read_blob(FILE_NAME, &b);
        check_vertices(&m, (const float[]){1, 2, 3}, 1);
        mesh_free(&m);
    }
}

/* One vertex with x = y = z = `bits` of type `name`. */
static float read_typed(const char *name, uint64_t bits, size_t size, int big) {
    blob b = {.size = 0};
    char header[400];
    snprintf(header, sizeof header,
             "ply\nformat %s 1.0\nelement vertex 1\nproperty %s x\nproperty %s y\n"
             "property %s z\nend_header\n",
             big ? "binary_big_endian" : "binary_little_endian", name, name, name);
    put_text(&b, header);
    for (int i = 0; i < 3; i++) {
        put_number(&b, bits, size, big);
    }
    mesh m = must_read_blob(FILE_NAME, &b);
    const float x = m.vertices == 1 ? m.vertex[2] : NAN;
    mesh_free(&m);
    return x;
}

static void reads_all_types(void) {
    test("All sixteen type names are read, signed and unsigned, in both orders");
    static const struct {
        const char *name;
        uint64_t bits;
        size_t size;
        float value;
    } TYPES[] = {
        {"char", 0xfe, 1, -2},
        {"int8", 0x80, 1, -128},
        {"uchar", 0xfe, 1, 254},
        {"uint8", 0x80, 1, 128},
        {"short", 0xfffe, 2, -2},
        {"int16", 0x8001, 2, -32767},
        {"ushort", 0xfffe, 2, 65534},
        {"uint16", 0x0102, 2, 258},
        {"int", 0xfffffffe, 4, -2},
        {"int32", 0x01000000, 4, 16777216},
        {"uint", 0xffffff00, 4, 4294967040.0f},
        {"uint32", 0x80000000, 4, 2147483648.0f},
        {"float", 0xbf800000, 4, -1},
        {"float32", 0x00000001, 4, 1.40129846e-45f},
        {"double", 0xbff8000000000000, 8, -1.5f},
        {"float64", 0x3fb999999999999a, 8, 0.1f},
    };
    for (size_t i = 0; i < 2 * sizeof TYPES / sizeof TYPES[0]; i++) {
        const int big = i % 2 == 1;
        const float x = read_typed(TYPES[i / 2].name, TYPES[i / 2].bits, TYPES[i / 2].size, big);
        CHECK(x == TYPES[i / 2].value, "%s is %.9g", TYPES[i / 2].name, (double)x);
    }
}

static void reads_float_indices(void) {
    test("Vertex numbers may be of a floating type when they are whole");
    mesh m = must_read_text(FILE_NAME, "ply\nformat ascii 1.0\nelement vertex 3\n" XYZ
                                       "element face 1\nproperty list uchar float vertex_indices\n"
                                       "end_header\n0 0 0\n1 0 0\n1 1 0\n3 0.0 1e0 2\n");
    check_triangles(&m, (const uint32_t[]){0, 1, 2}, 1);
    mesh_free(&m);
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement vertex 3\n" XYZ
                   "element face 1\nproperty list uchar int vertex_indices\n"
                   "end_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2.5\n",
                   "line 13, face 0: '2.5' where a whole number belongs; correct it");
}

static void reads_strips(void) {
    test("Triangle strips alternate their winding and start again after -1");
    mesh m = must_read_text(FILE_NAME, "ply\nformat ascii 1.0\nelement vertex 6\n" XYZ
                                       "element tristrips 1\n"
                                       "property list int int vertex_indices\nend_header\n"
                                       "0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n5 0 0\n"
                                       "12 0 1 2 3 4 -1 -1 5 4 3 2 -1\n");
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 2, 1, 3, 2, 3, 4, 5, 4, 3, 3, 4, 2}, 5);
    mesh_free(&m);
}

static void keeps_degenerate(void) {
    test("Triangles with a repeated corner or without area keep their number");
    mesh m = must_read_text(FILE_NAME,
                            "ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 3\n" FACES
                            "end_header\n"
                            "0 0 0\n1 0 0\n2 0 0\n3 0 0 1\n3 0 1 2\n3 2 2 2\n");
    check_triangles(&m, (const uint32_t[]){0, 0, 1, 0, 1, 2, 2, 2, 2}, 3);
    mesh_free(&m);
}

static void joins_lines(void) {
    test("A value may stand on a later line, a value too many may not");
    mesh m = must_read_text(FILE_NAME, "ply\nformat ascii 1.0\nelement vertex 2\n" XYZ
                                       "end_header\n0 0\n0\n\n1\n0 0");
    CHECK(m.vertices == 2, "%zu vertices", m.vertices);
    mesh_free(&m);
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement vertex 3\n" XYZ
                   "end_header\n"
                   "0.0 0 0\n1.0 0\n2.0 0 0\n",
                   "line 9: fewer values than the header declares for a vertex; "
                   "correct the header or the lines");
}

#define LIE "the file is cut short: get it again"

static void refuses_lies(void) {
    test("Counts that the bytes cannot hold are refused before anything is allocated");
    static const char *const FORMATS[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    for (int i = 0; i < 3; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "ply\nformat %s 1.0\nelement vertex 4000000000\n" XYZ "end_header\n0 0 0\n",
                 FORMATS[i]);
        mesh m = {0};
        mesh_report report = {0};
        fail f;
        CHECK(read_text(&m, FILE_NAME, text, &report, &f) == -1, "read");
        CHECK(m.vertex_room == 0 && m.vertex == NULL, "room for %zu", m.vertex_room);
        mesh_free(&m);
    }
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n" XYZ
                   "end_header\n0 0 0\n",
                   "line 3: 9223372036854775807 elements 'vertex' need at least 6 bytes each, "
                   "but 6 bytes follow the header; " LIE);
    must_fail_text(FILE_NAME,
                   "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" XYZ
                   "element face 9\n" FACES "end_header\n0123456789ab12345678",
                   "line 7: 9 elements 'face' need at least 1 bytes each, "
                   "but 20 bytes follow the header; " LIE);
    must_fail_text(FILE_NAME,
                   "ply\nformat binary_big_endian 1.0\nelement vertex 0\n" XYZ
                   "element face 1\nproperty list int int vertex_indices\nend_header\n"
                   "\x7f\xff\xff\xff",
                   "face 0 at byte 164: a list of 2147483647 values, but 0 bytes follow; "
                   "the file is damaged: get it again");
    must_fail_text(FILE_NAME,
                   "ply\nformat binary_big_endian 1.0\nelement vertex 0\n" XYZ
                   "element face 1\nproperty list char int vertex_indices\nend_header\n\xff",
                   "face 0 at byte 165: a list of -1 values, but 0 bytes follow; "
                   "the file is damaged: get it again");
}

static void passes_empty_elements(void) {
    test("Four billion elements without properties take no time and no room");
    mesh m = must_read_text(FILE_NAME,
                            "ply\nformat ascii 1.0\nelement nothing 4000000000\n"
                            "element vertex 1\n" XYZ "end_header\n1 2 3\n");
    CHECK(m.vertices == 1, "%zu vertices", m.vertices);
    mesh_free(&m);
    m = must_read_text(FILE_NAME,
                       "ply\nformat binary_little_endian 1.0\n"
                       "element vertex 4000000000\nend_header\n");
    CHECK(m.vertices == 0 && m.vertex_room == 0, "%zu vertices", m.vertices);
    mesh_free(&m);
}

static void refuses_headers(void) {
    test("A header that cannot be right is refused with the line and the remedy");
    must_fail_text(FILE_NAME, "plx\n",
                   "line 1: does not begin with 'ply'; give it the name of its true format");
    must_fail_text(FILE_NAME, "ply\nformat ascii 1.0\nelement vertex 1\n" XYZ,
                   "line 6: the header has no end_header; the file is cut short: get it again");
    must_fail_text(FILE_NAME, "ply\nelement vertex 0\n" XYZ "end_header\n",
                   "line 6: the header names no format; add one");
    must_fail_text(FILE_NAME, "ply\nformat ascii 2.0\nend_header\n",
                   "line 2: unknown format 'ascii 2.0'; write it as ascii, "
                   "binary_little_endian or binary_big_endian 1.0");
    must_fail_text(FILE_NAME, "ply\nformat ascii 1.0\nformat ascii 1.0\nend_header\n",
                   "line 3: a second format; remove one");
    must_fail_text(FILE_NAME, "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n",
                   "line 3: element 'vertex' has no count; write one");
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement vertex 0\nelement vertex 0\nend_header\n",
                   "line 4: a second element 'vertex'; rename one");
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement vertex 0\n" XYZ "property int x\nend_header\n",
                   "line 7: a second property 'x'; rename one");
    must_fail_text(FILE_NAME, "ply\nformat ascii 1.0\nproperty int x\nend_header\n",
                   "line 3: a property before any element; reorder the header");
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n",
                   "line 4: unknown type 'half'; use one from char to double");
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement a 1\nproperty list float int x\nend_header\n",
                   "line 4: a list counted in fractions; use an integer type");
    must_fail_text(FILE_NAME, "ply\nformat ascii 1.0\nelement a 1\nproperty int\nend_header\n",
                   "line 4: a property without a name; write one");
    must_fail_text(FILE_NAME, "ply\nformat ascii 1.0\nproprety float x\nend_header\n",
                   "line 3: 'proprety' in the header looks like a misspelt keyword; correct it, or "
                   "make the line a comment");
    must_fail_text(FILE_NAME, "ply\nformat ascii 1.0\nelement vertex 1 2\nend_header\n",
                   "line 3: more words than expected; remove them");
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                   "property float y\nend_header\n0 0\n",
                   "line 3: the vertices lack x, y or z; add them");
    must_fail_text(FILE_NAME,
                   "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int v\n"
                   "end_header\n0\n",
                   "line 3: 'face' has no list vertex_indices; rename one");
}

#define BAD_TAIL                                                                                   \
    "is not finite or beyond +-2^40; correct it or its unit, or use pack --repair to drop it"

static void refuses_bad_vertices(void) {
    test("A vertex that is not finite or too large is refused where it stands");
    static const struct {
        const char *text, *shown;
    } BAD[] = {
        {"nan 0 0", "(nan 0 0)"},    {"0 inf 0", "(0 inf 0)"},
        {"0 0 -1e39", "(0 0 -inf)"}, {"0 1.0995117e12 0", "(0 1.09951e+12 0)"},
        {"1e400 0 0", "(inf 0 0)"},
    };
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        char text[400], expected[400];
        snprintf(text, sizeof text,
                 "ply\nformat ascii 1.0\nelement vertex 2\n" XYZ "end_header\n1 1 1\n%s\n",
                 BAD[i].text);
        snprintf(expected, sizeof expected, "line 9, vertex 1: the vertex %s " BAD_TAIL,
                 BAD[i].shown);
        must_fail_text(FILE_NAME, text, expected);
    }
    blob b = {.size = 0};
    put_text(&b,
             "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty double x\n"
             "property double y\nproperty double z\nend_header\n");
    const size_t header = b.size;
    for (int i = 0; i < 6; i++) {
        put_double(&b, i == 4 ? 1e300 : 0, 0);
    }
    char expected[400];
    snprintf(expected, sizeof expected, "vertex 1 at byte %zu: the vertex (0 inf 0) " BAD_TAIL,
             header + 24);
    must_fail_blob(FILE_NAME, &b, expected);
}

static void accepts_the_bound(void) {
    test("A vertex at exactly +-2^40 is read");
    mesh m = must_read_text(FILE_NAME, "ply\nformat ascii 1.0\nelement vertex 1\n" XYZ
                                       "end_header\n1099511627776 -1099511627776 -0\n");
    check_vertices(&m, (const float[]){PLT_COORD_MAX, -PLT_COORD_MAX, -0.0f}, 1);
    mesh_free(&m);
}

#define TRIO                                                                                       \
    "ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 3\n" FACES                       \
    "end_header\n0 0 0\n1 0 0\n0 1 0\n"

static void refuses_bad_corners(void) {
    test("A corner without a vertex is refused where it stands");
    must_fail_text(FILE_NAME, TRIO "3 0 1 2\n3 0 1 3\n3 0 1 2\n",
                   "line 14, face 1: uses vertex 3, which is not among the 3 vertices; "
                   "use pack --repair to drop it");
    must_fail_text(FILE_NAME, TRIO "3 0 1 2\n3 0 -1 2\n3 0 1 2\n",
                   "line 14, face 1: uses vertex -1, which is not among the 3 vertices; "
                   "use pack --repair to drop it");
}

static void repairs(void) {
    test("Repair drops and counts what cannot be traced, and keeps the order");
    mesh m = {0};
    mesh_report report = {.repair = 1};
    fail f;
    const char *text = "ply\nformat ascii 1.0\nelement face 6\n" FACES "element vertex 4\n" XYZ
                       "end_header\n"
                       "3 0 1 2\n3 0 1 3\n3 2 1 0\n3 0 1 99\n1 0\n4 1 1 -5 2\n"
                       "0 0 0\n1 0 0\n0 1 0\nnan 1 1\nleft over\n";
    CHECK(read_text(&m, FILE_NAME, text, &report, &f) == 0, "%s", f.text);
    check_vertices(&m, (const float[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0}, 4);
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 2, 1, 0}, 2);
    CHECK(report.count[REPORT_BAD_VERTICES] == 1, "%llu",
          (unsigned long long)report.count[REPORT_BAD_VERTICES]);
    CHECK(report.count[REPORT_BAD_FACES] == 3, "%llu",
          (unsigned long long)report.count[REPORT_BAD_FACES]); /* a quad is one */
    CHECK(report.count[REPORT_SMALL_FACES] == 1, "%llu",
          (unsigned long long)report.count[REPORT_SMALL_FACES]);
    CHECK(report.count[REPORT_LOOSE_BYTES] == 10, "%llu",
          (unsigned long long)report.count[REPORT_LOOSE_BYTES]);
    mesh_free(&m);
}

static void appends(void) {
    test("A second file is appended; a failing one leaves the mesh as it was");
    const char *good = TRIO "3 0 1 2\n3 0 2 1\n3 1 1 1\n";
    mesh m = must_read_text(FILE_NAME, good);
    mesh_report report = {0};
    fail f;
    CHECK(read_text(&m, FILE_NAME, good, &report, &f) == 0, "%s", f.text);
    CHECK(read_text(&m, FILE_NAME, TRIO "3 0 1 2\n3 0 1 2\n3 0 1 7\n", &report, &f) == -1, "read");
    check_vertices(&m, (const float[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0}, 6);
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 0, 2, 1, 1, 1, 1, 3, 4, 5, 3, 5, 4, 4, 4, 4},
                    6);
    mesh_free(&m);
}

static void writes(void) {
    test("Written PLY reads back bit by bit, a quarter of a million triangles");
    enum { SIDE = 354 };
    mesh m = {0}, back = {0};
    mesh_report report = {0};
    fail f = {{0}};
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        const uint32_t bits = (i * 2654435761u & 0x807fffff) | (i % 150 << 23);
        float x;
        memcpy(&x, &bits, sizeof x);
        mesh_add_vertex(&m, x, -x, (float)i, &f);
    }
    for (uint32_t i = 0; i + SIDE + 1 < SIDE * SIDE; i++) {
        mesh_add_triangle(&m, i, i + 1, i + SIDE, &f);
        mesh_add_triangle(&m, i + 1, i + SIDE + 1, i + SIDE, &f);
    }
    CHECK(mesh_write_ply(&m, MESH_FOLDER "written.ply", &f) == 0, "%s", f.text);
    CHECK(mesh_read(&back, MESH_FOLDER "written.ply", 0, &report, &f) == 0, "%s", f.text);
    CHECK(back.vertices == SIDE * SIDE && back.triangles == m.triangles, "%zu", back.triangles);
    CHECK(back.vertices == m.vertices &&
              memcmp(back.vertex, m.vertex, m.vertices * 3 * sizeof(float)) == 0,
          "vertices differ");
    CHECK(back.triangles == m.triangles &&
              memcmp(back.triangle, m.triangle, m.triangles * 3 * sizeof(uint32_t)) == 0,
          "triangles differ");
    CHECK(mesh_write_ply(&m, MESH_FOLDER "missing/a.ply", &f) == -1, "written");
    CHECK(strncmp(f.text, MESH_FOLDER "missing/a.ply: cannot create", 30) == 0, "%s", f.text);
    mesh_free(&m);
    mesh_free(&back);
}

int main(void) {
    mesh_folder();
    reads_ascii();
    reads_binary();
    keeps_line_feed_data();
    skips_the_rest();
    skips_binary_lists();
    reads_all_types();
    reads_float_indices();
    reads_strips();
    keeps_degenerate();
    joins_lines();
    refuses_lies();
    passes_empty_elements();
    refuses_headers();
    refuses_bad_vertices();
    accepts_the_bound();
    refuses_bad_corners();
    repairs();
    appends();
    writes();
    return test_done();
}
