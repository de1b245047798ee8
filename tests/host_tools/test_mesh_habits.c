/* test_mesh_habits - what real programs write is read, and what is left out is counted
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hostile/mesh_files.h"

#define PLY MESH_FOLDER "habit.ply"
#define OBJ MESH_FOLDER "habit.obj"
#define STL MESH_FOLDER "habit.stl"

/* Reads with nothing repaired; checks the counts of two triangles of a square. */
static mesh_report square_of(const char *path, const blob *b) {
    mesh m = {0};
    mesh_report report = {0};
    fail f;
    CHECK(read_blob(&m, path, b, &report, &f) == 0, "%s", f.text);
    CHECK(m.vertices == 4 && m.triangles == 2, "%zu vertices, %zu triangles", m.vertices,
          m.triangles);
    mesh_free(&m);
    return report;
}

static mesh_report square(const char *path, const char *text) {
    blob b = {.size = 0};
    put_text(&b, text);
    return square_of(path, &b);
}

/* Checks one count, and that all others are 0. */
static void only(const mesh_report *r, report_item item, uint64_t count) {
    for (int i = 0; i < REPORT_ITEMS; i++) {
        const uint64_t expected = i == (int)item ? count : 0;
        CHECK(r->count[i] == expected, "%s: %llu, not %llu", report_key((report_item)i),
              (unsigned long long)r->count[i], (unsigned long long)expected);
    }
}

static void nothing(const mesh_report *r) {
    only(r, REPORT_ITEMS, 0);
}

/* ---- STL ------------------------------------------------------------------------------------- */

#define SQUARE                                                                                     \
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"          \
    "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n"         \
    "endloop\nendfacet\n"

static void upper(char *text) {
    for (char *c = text; *c; c++) {
        *c = (char)(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c);
    }
}

static void stl_in_any_case(void) {
    test("ASCII STL is read in capitals and in mixed case");
    char text[] = "solid a\n" SQUARE "endsolid a\n";
    upper(text);
    mesh_report r = square(STL, text);
    nothing(&r);
    r = square(MESH_FOLDER "habit_no_name", text);
    nothing(&r);
    r = square(STL, "Solid\n" SQUARE "EndSolid\n");
    nothing(&r);
}

static void stl_with_fillers(void) {
    test("Blanks, comments, zero bytes and 0x1A around ASCII STL do not hide it");
    static const char HEADS[][40] = {"", "\n\t \r\n", "# by hand\n", "; x\n// y\n", "\0\0\x1a"};
    static const size_t HEAD_SIZES[] = {0, 5, 10, 9, 3};
    static const char TAILS[][40] = {"", "\n\n \n", "# the end", "\x1a", "\0\0\0\0"};
    static const size_t TAIL_SIZES[] = {0, 4, 9, 1, 4};
    for (int head = 0; head < 5; head++) {
        for (int tail = 0; tail < 5; tail++) {
            blob b = {.size = 0};
            put(&b, HEADS[head], HEAD_SIZES[head]);
            put_text(&b, "solid\n" SQUARE "endsolid\n");
            put(&b, TAILS[tail], TAIL_SIZES[tail]);
            const mesh_report r = square_of(STL, &b);
            nothing(&r);
        }
    }
    const mesh_report r = square(STL, "solid\n# between\n" SQUARE "; facets\nendsolid\n");
    nothing(&r);
}

static void stl_without_end(void) {
    test("\"end solid\" ends a solid, and a missing endsolid is counted");
    mesh_report r = square(STL, "solid\n" SQUARE "end solid\n");
    nothing(&r);
    r = square(STL, "solid\n" SQUARE);
    only(&r, REPORT_UNENDED, 1);
}

static void stl_of_several(void) {
    test("Several solids are one mesh, whether they end or not");
    mesh m = {0};
    mesh_report r = {0};
    fail f;
    CHECK(read_text(&m, STL, "solid one\n" SQUARE "solid two\n" SQUARE "endsolid\nsolid\nendsolid",
                    &r, &f) == 0,
          "%s", f.text);
    CHECK(m.triangles == 4, "%zu", m.triangles);
    only(&r, REPORT_UNENDED, 1);
    mesh_free(&m);
    must_fail_text(STL, "solid one\nsolid two\n" SQUARE "endsolid",
                   "line 2: the file ends where 'facet or endsolid' belongs; get it again");
    must_fail_text(STL, "solid\n",
                   "line 1: the file ends where 'facet or endsolid' belongs; get it again");
}

static void stl_text_speaks_of_lines(void) {
    test("Text that is no STL is refused at its line, never by a count of triangles");
    must_fail_text(STL,
                   "hello\nworld, this is a text of more than eighty-four bytes: it is not "
                   "binary, and has no solid.\n",
                   "line 1: 'hello' where 'solid' belongs; correct it");
    must_fail_text(STL, "v 0 0 0\n", "line 1: 'v' where 'solid' belongs; correct it");
}

/* Not the square, and with a failure that speaks of a line. */
static void fails_at_line(const blob *b, int line) {
    mesh m = {0};
    mesh_report report = {0};
    fail f;
    char where[80];
    snprintf(where, sizeof where, STL ": line %d: ", line);
    CHECK(read_blob(&m, STL, b, &report, &f) == -1, "read");
    CHECK(strncmp(f.text, where, strlen(where)) == 0, "%s", f.text);
    mesh_free(&m);
}

static void stl_text_with_control_bytes(void) {
    test("Control bytes between solids, at the end and in names leave an ASCII STL text");
    static const struct {
        const char *bytes;
        size_t size;
    } GAPS[] = {{"\x1a", 1},       {"\x1a\r\n", 3},        {"\n\x1a\n", 3},
                {"\0\0\0\0\n", 5}, {" \0 \x1a \r\n\0", 8}, {"\n# of old\n\x1a;\n", 13}};
    static char padding[512];
    for (size_t i = 0; i < sizeof GAPS / sizeof GAPS[0]; i++) {
        for (int named = 0; named < 2; named++) {
            blob b = {.size = 0};
            put(&b, GAPS[i].bytes, GAPS[i].size);
            put_text(&b, "solid a\nendsolid\n");
            put(&b, GAPS[i].bytes, GAPS[i].size);
            put_text(&b, "solid b\n" SQUARE "endsolid");
            put(&b, GAPS[i].bytes, GAPS[i].size);
            mesh_report r = square_of(named ? STL : MESH_FOLDER "habit_no_name", &b);
            nothing(&r);
        }
    }
    blob b = {.size = 0};
    put_text(&b, "solid a\nendsolid a\n");
    put(&b, padding, sizeof padding);
    put_text(&b, "solid b\n" SQUARE);
    put(&b, padding, sizeof padding);
    mesh_report r = square_of(STL, &b);
    only(&r, REPORT_UNENDED, 1);
    r = square(STL, "solid \x01 name \x02\x03\n" SQUARE "endsolid \x01 name\n");
    nothing(&r);
    r = square(STL,
               "solid \x80\xff\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\n" SQUARE);
    only(&r, REPORT_UNENDED, 1);
}

static void stl_text_that_is_damaged(void) {
    test("A control byte within a facet is refused at its line");
    static const char *const TEXTS[] = {
        "solid a\n" SQUARE "facet normal 0 \x01 0\nouter loops",
        "solid a\x01\x02\n" SQUARE "\x01\n",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\x01 0\nvertex 1 0 0\nvertex 1 1 0\n",
    };
    static const int LINES[] = {17, 16, 4};
    for (int i = 0; i < 3; i++) {
        blob b = {.size = 0};
        put_text(&b, TEXTS[i]);
        fails_at_line(&b, LINES[i]);
    }
}

/* `count` says so; `held` triangles are there, of the square, over and over. */
static blob binary(uint32_t count, unsigned held, int big) {
    static const float CORNERS[2][9] = {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}};
    blob b = {.size = 0};
    const char head[80] = "by a program";
    put(&b, head, sizeof head);
    put_number(&b, count, 4, big);
    for (unsigned i = 0; i < held; i++) {
        for (int k = 0; k < 3; k++) {
            put_float(&b, 0, big);
        }
        for (int k = 0; k < 9; k++) {
            put_float(&b, CORNERS[i % 2][k], big);
        }
        put_number(&b, 0, 2, 0);
    }
    return b;
}

static void stl_that_is_binary(void) {
    test("A binary STL whose header begins as text does is binary, also when it miscounts");
    static const char *const HEADS[] = {
        "solid",
        "solid name\nfacet normal 0 0 1\n",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nend",
        "solid a\nendsolid a\n",
        "solid by a program that pads its header with blanks                             ",
    };
    for (size_t i = 0; i < sizeof HEADS / sizeof HEADS[0]; i++) {
        for (uint32_t count = 1; count < 4; count++) {
            blob b = binary(count, 2, 0);
            memset(b.bytes, 0, 80);
            memcpy(b.bytes, HEADS[i], strlen(HEADS[i]));
            const mesh_report r = square_of(STL, &b);
            only(&r, REPORT_MISCOUNTED, count != 2);
        }
    }
}

static void stl_with_loose_bytes(void) {
    test(
        "Repair reads what the size holds when the count is smaller; where nothing is held it "
        "is not named");
    blob b = binary(0, 2, 0);
    put(&b, "abc", 3);
    must_fail_blob(STL, &b,
                   "byte 80: its count of triangles says 0, but the file holds 2 and 3 bytes more; "
                   "use pack --repair to read what it holds");
    mesh m = {0};
    mesh_report r = {.repair = 1};
    fail f;
    CHECK(read_blob(&m, STL, &b, &r, &f) == 0, "%s", f.text);
    CHECK(m.triangles == 2 && r.count[REPORT_MISCOUNTED] == 2 && r.count[REPORT_LOOSE_BYTES] == 3,
          "%zu triangles", m.triangles);
    CHECK(r.miscount.files == 1 && r.miscount.counted == 0 && r.miscount.held == 2, "numbers");
    mesh_free(&m);
    b = binary(0, 0, 0);
    put(&b, "abc", 3);
    must_fail_blob(STL, &b, "byte 84: a triangle takes 50 bytes, but 3 follow; get the file again");
}

static void stl_that_miscounts(void) {
    test("The size of a whole binary STL outranks its count; big-endian ones are turned round");
    static const uint32_t COUNTS[] = {0, 1, 3, 6, UINT32_MAX};
    static const uint64_t OFF[] = {2, 1, 1, 4, UINT32_MAX - 2};
    for (int i = 0; i < 5; i++) {
        const blob b = binary(COUNTS[i], 2, 0);
        mesh_report r = square_of(STL, &b);
        only(&r, REPORT_MISCOUNTED, OFF[i]);
        r = square_of(MESH_FOLDER "habit_no_name", &b);
        only(&r, REPORT_MISCOUNTED, OFF[i]);
    }
    blob b = binary(2, 2, 1);
    mesh_report r = square_of(STL, &b);
    only(&r, REPORT_SWAPPED, 2);
    b = binary(2, 2, 0);
    b.bytes[84 + 49] = 0x80;
    r = square_of(STL, &b);
    only(&r, REPORT_COLOURS, 1);
}

/* ---- PLY ------------------------------------------------------------------------------------- */

#define CORNERS_OF(type)                                                                           \
    "element vertex 4\nproperty " type " x\nproperty " type " y\nproperty " type " z\n"
#define POINTS "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
#define HEAD "ply\nformat ascii 1.0\n"

static void ply_of_64_bits(void) {
    test("PLY int64 and uint64 are read, as coordinates, counts and corners, to the last bit");
    mesh_report r =
        square(PLY, HEAD CORNERS_OF("int64") "element face 2\n"
                                             "property list uint64 int64 vertex_indices\n"
                                             "end_header\n" POINTS "3 0 1 2\n3 0 2 3\n");
    nothing(&r);
    for (int big = 0; big < 2; big++) {
        blob b = {.size = 0};
        put_text(&b, big ? "ply\nformat binary_big_endian 1.0\n"
                         : "ply\nformat binary_little_endian 1.0\n");
        put_text(&b,
                 "element vertex 3\nproperty int64 x\nproperty uint64 y\nproperty int64 z\n"
                 "element face 1\nproperty list int64 uint64 vertex_index\nend_header\n");
        /* 2^39 + 2^15 is a middle between two floats; the bit below makes it go up. */
        const int64_t x[3] = {-5, (1LL << 39) + (1LL << 15), (1LL << 39) + (1LL << 15) + 1};
        for (int i = 0; i < 3; i++) {
            put_number(&b, (uint64_t)x[i], 8, big);
            put_number(&b, (uint64_t)i * 7, 8, big);
            put_number(&b, 0, 8, big);
        }
        put_number(&b, 3, 8, big);
        for (uint64_t i = 0; i < 3; i++) {
            put_number(&b, i, 8, big);
        }
        mesh m = must_read_blob(PLY, &b);
        check_vertices(&m, (const float[]){-5, 0, 0, 549755813888.0f, 7, 0, 549755879424.0f, 14, 0},
                       3);
        check_triangles(&m, (const uint32_t[]){0, 1, 2}, 1);
        mesh_free(&m);
    }
}

static void ply_with_small_faces(void) {
    test("Faces of one and two corners are passed over and counted");
    const mesh_report r =
        square(PLY, HEAD CORNERS_OF("double") "element face 4\n"
                                              "property list uint8 int32 vertex_indices\n"
                                              "end_header\n" POINTS
                                              "1 0\n2 0 1\n3 0 1 2\n3 0 2 3\n");
    only(&r, REPORT_SMALL_FACES, 2);
}

static void ply_with_more_in_it(void) {
    test("Header lines of no keyword and bytes behind the data are passed over and counted");
    mesh_report r = square(PLY, HEAD "generator by hand\n" CORNERS_OF(
                                    "float") "element face 2\n"
                                             "property list uchar int vertex_index\nunits mm\n"
                                             "end_header\n" POINTS "3 0 1 2\n3 0 2 3\n");
    only(&r, REPORT_UNKNOWN_LINES, 2);
    r = square(PLY, HEAD CORNERS_OF("float") "element face 1\n"
                                             "property list uchar int vertex_index\n"
                                             "end_header\n" POINTS "4 0 1 2 3\n\nmore\n");
    only(&r, REPORT_LOOSE_BYTES, 5);
    blob b = {.size = 0};
    put_text(&b,
             "ply\nformat binary_little_endian 1.0\nelement face 2\n"
             "property list uchar uchar vertex_index\n" CORNERS_OF("uchar") "end_header\n");
    put(&b, "\3\0\1\2\3\0\2\3\0\0\0\1\0\0\1\1\0\0\1\0", 20);
    r = square_of(PLY, &b);
    nothing(&r);
    put_text(&b, "\n");
    r = square_of(PLY, &b);
    nothing(&r); /* a line end is not worth a word */
    put_text(&b, "tail");
    r = square_of(PLY, &b);
    only(&r, REPORT_LOOSE_BYTES, 5);
}

static void ply_attributes(void) {
    test("Normals, colours, texture coordinates and lines of a PLY are counted");
    const mesh_report r = square(
        PLY, HEAD CORNERS_OF("float") "property float nx\nproperty float ny\nproperty float nz\n"
                                      "property float s\nproperty float t\nproperty uchar red\n"
                                      "element edge 3\nproperty int vertex1\nproperty int vertex2\n"
                                      "element face 2\nproperty list uchar int vertex_index\n"
                                      "property uchar red\nelement camera 1\nproperty int n\n"
                                      "end_header\n"
                                      "0 0 0 0 0 1 0 0 9\n1 0 0 0 0 1 0 0 9\n1 1 0 0 0 1 0 0 9\n"
                                      "0 1 0 0 0 1 0 0 9\n0 1\n1 2\n2 3\n3 0 1 2 7\n"
                                      "3 0 2 3 7\n1\n");
    CHECK(r.count[REPORT_NORMALS] == 4 && r.count[REPORT_TEXTURES] == 4, "of vertices");
    CHECK(r.count[REPORT_COLOURS] == 6, "%llu", (unsigned long long)r.count[REPORT_COLOURS]);
    CHECK(r.count[REPORT_LINES] == 3 && r.count[REPORT_ELEMENTS] == 1, "of other elements");
}

static void ply_of_other_types(void) {
    test("A body that does not fit the types of the header is refused, in every mode");
    blob b = {.size = 0};
    put_text(&b, "ply\nformat binary_little_endian 1.0\n" CORNERS_OF(
                     "float") "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                              "element face 2\nproperty list uchar int vertex_index\nend_header\n");
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 6; k++) {
            put_float(&b, k < 3 ? (float)(i >> k & 1) : 0.5f, 0); /* colours as floats */
        }
    }
    for (uint32_t i = 0; i < 2; i++) {
        put_number(&b, 3, 1, 0);
        for (uint32_t k = 0; k < 3; k++) {
            put_number(&b, i + k, 4, 0);
        }
    }
    must_fail_blob(PLY, &b,
                   "line 3: the body does not fit the types of the header, by which a vertex takes "
                   "15 bytes: it takes 24; write the mesh as ASCII PLY or OBJ");
    mesh m = {0};
    mesh_report report = {.repair = 1};
    fail f;
    CHECK(read_blob(&m, PLY, &b, &report, &f) == -1, "repaired");
    mesh_free(&m);
}

static void ply_of_short_lines(void) {
    test("Values may go on in the next line; when that ends badly, the first such line is named");
    mesh_report r = square(PLY, HEAD CORNERS_OF("float") "element face 2\n"
                                                         "property list uchar int vertex_index\n"
                                                         "end_header\n"
                                                         "0 0\n0\n1 0\n0\n1\n1 0\n0 1 0\n"
                                                         "3 0 1\n2\n3 0 2 3\n");
    nothing(&r);
    must_fail_text(PLY,
                   HEAD CORNERS_OF("float") "property float nx\nproperty float ny\n"
                                            "property float nz\nelement face 2\n"
                                            "property list uchar int vertex_index\nend_header\n"
                                            "0.00 0 0\n1.00 0 0\n1.00 1 0\n0.00 1 0\n"
                                            "3 0 1 2\n3 0 2 3\n",
                   "line 13: fewer values than the header declares for a vertex; correct the "
                   "header or the lines");
}

/* ---- OBJ ------------------------------------------------------------------------------------- */

static void obj_that_joins(void) {
    test("A joining backslash may have blanks behind it");
    const mesh_report r = square(OBJ,
                                 "v 0 0 0\nv 1 0 \\  \n0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\t\r\n3 \\ "
                                 "\r\n 4\n");
    nothing(&r);
}

static void obj_attributes(void) {
    test("What an OBJ draws beside faces is counted");
    const mesh_report r =
        square(OBJ,
               "mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 1\nv 0 1 0 1 0.5 0.5 0.5\n"
               "vt 0 0\nvn 0 0 1\nvn 0 1 0\nusemtl red\nf 1 2 3\nf 1 3 4\nf 1 2\np 1\nl 1 2 3\n"
               "l 1 2\ncurv 0 1 1 2\n");
    CHECK(r.count[REPORT_COLOURS] == 2, "%llu", (unsigned long long)r.count[REPORT_COLOURS]);
    CHECK(r.count[REPORT_TEXTURES] == 1 && r.count[REPORT_NORMALS] == 2, "vt, vn");
    CHECK(r.count[REPORT_MATERIALS] == 1 && r.count[REPORT_CURVES] == 1, "usemtl, curv");
    CHECK(r.count[REPORT_POINTS] == 1 && r.count[REPORT_LINES] == 2, "p, l");
    CHECK(r.count[REPORT_SMALL_FACES] == 1, "f of two");
}

static void obj_of_old_keywords(void) {
    test("fo is f, and lines of other old keywords and of none are known by what they draw");
    mesh_report r = square(OBJ, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nfo 1 2 3\nfo 1/1 \\\n3 4\n");
    nothing(&r);
    r = square(OBJ,
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nF 1 2 3\nfaces 1 2 3\n"
               "call x\ncsh ls\n");
    only(&r, REPORT_UNREAD_LINES, 4);
    r = square(OBJ,
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nbzp 1 2\nbsp 1 2\ncdc 1 2\n"
               "cdp 1 2\ncurv 0 1 \\\n 1 2\n");
    only(&r, REPORT_CURVES, 5);
    r = square(OBJ,
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nbevel on\nc_interp on\nd_interp on\n"
               "shadow_obj a\ntrace_obj a\nctech cparm 1\nstech cparma 1 1\nres 1 1\n"
               "parm u 0 \\\n 0.5 \\\n 1\ng C:\\a\\\nf 1 2 3\no C:\\\nf 1 3 4\n");
    nothing(&r);
}

/* Two triangles, two lines and a quad: faces as a program that keeps lines among them writes. */
static void ply_of_mixed_faces(void) {
    test("Binary faces of 2, 3 and 4 corners are read, whatever size that gives the file");
    for (int lines = 0; lines < 40; lines++) {
        blob b = {.size = 0};
        char head[400];
        snprintf(head, sizeof head,
                 "ply\nformat binary_little_endian 1.0\n" CORNERS_OF(
                     "float") "property uchar red\nelement face %d\n"
                              "property list uchar int vertex_index\nend_header\n",
                 1 + lines);
        put_text(&b, head);
        for (int i = 0; i < 4; i++) {
            put_float(&b, (float)(i == 1 || i == 2), 0);
            put_float(&b, (float)(i / 2), 0);
            put_float(&b, 0, 0);
            put_number(&b, 9, 1, 0);
        }
        for (int i = 0; i < lines; i++) {
            put_number(&b, 2, 1, 0);
            put_number(&b, 0, 4, 0);
            put_number(&b, 1, 4, 0);
        }
        put_number(&b, 4, 1, 0);
        for (uint32_t i = 0; i < 4; i++) {
            put_number(&b, i, 4, 0);
        }
        const mesh_report r = square_of(PLY, &b);
        CHECK(r.count[REPORT_SMALL_FACES] == (uint64_t)lines, "%d lines", lines);
        /* The last vertex number is missing: that is what is said. */
        b.bytes[b.size - 4] = 7;
        mesh m = {0};
        mesh_report none = {0};
        fail f;
        CHECK(read_blob(&m, PLY, &b, &none, &f) == -1, "read");
        CHECK(strstr(f.text, "uses vertex 7, which is not among the 4") != NULL, "%s", f.text);
        mesh_free(&m);
    }
}

/* ---- polygons -------------------------------------------------------------------------------- */

static double area_of(const mesh *m) {
    double area = 0;
    for (size_t i = 0; i < m->triangles; i++) {
        const float *p[3];
        for (size_t k = 0; k < 3; k++) {
            p[k] = m->vertex + 3 * (size_t)m->triangle[3 * i + k];
        }
        area += 0.5 * ((double)(p[1][0] - p[0][0]) * (double)(p[2][1] - p[0][1]) -
                       (double)(p[1][1] - p[0][1]) * (double)(p[2][0] - p[0][0]));
        CHECK((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
                      (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]) >
                  0,
              "triangle %zu is turned", i);
    }
    return area;
}

static void concave_faces(void) {
    test("A concave face keeps its area, wherever it begins, in each format");
    static const char *const L[6] = {"2 0 0", "2 1 0", "1 1 0", "1 2 0", "0 2 0", "0 0 0"};
    for (int start = 0; start < 6; start++) {
        char ply[600] = HEAD
            "element face 1\nproperty list uchar int vertex_indices\n"
            "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
            "end_header\n6 0 1 2 3 4 5\n";
        char obj[600] = "f 1 2 3 4 5 6\n", stl[600] = "solid\nfacet normal 0 0 1\nouter loop\n";
        for (int i = 0; i < 6; i++) {
            sprintf(ply + strlen(ply), "%s\n", L[(start + i) % 6]);
            sprintf(obj + strlen(obj), "v %s\n", L[(start + i) % 6]);
            sprintf(stl + strlen(stl), "vertex %s\n", L[(start + i) % 6]);
        }
        strcat(stl, "endloop\nendfacet\nendsolid\n");
        const char *const path[3] = {PLY, OBJ, STL}, *const text[3] = {ply, obj, stl};
        for (int i = 0; i < 3; i++) {
            mesh m = must_read_text(path[i], text[i]);
            CHECK(m.triangles == 4 && m.vertices == 6, "%zu triangles", m.triangles);
            CHECK(area_of(&m) == 3, "%s from %d: %g", path[i], start, area_of(&m));
            mesh_free(&m);
        }
    }
}

/* A house of 20 x 10 with a notch of 4 x `depth`, from corner `start` on, in a national grid. */
static void check_notch(const char *type, double depth, int start) {
    const double at[8][2] = {{0, 0},           {20, 0},         {20, 10}, {12, 10},
                             {12, 10 - depth}, {8, 10 - depth}, {8, 10},  {0, 10}};
    char text[900];
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\nelement vertex 8\nproperty %s x\nproperty %s y\n"
             "property %s z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n",
             type, type, type);
    for (int i = 0; i < 8; i++) {
        const double *p = at[(start + i) % 8];
        sprintf(text + strlen(text), "%.17g %.17g 0\n", 500000 + p[0], 5000000 + p[1]);
    }
    strcat(text, "8 0 1 2 3 4 5 6 7\n");
    mesh m = must_read_text(PLY, text);
    double area = 0;
    for (size_t i = 0; i < m.triangles; i++) {
        double p[3][2];
        for (int k = 0; k < 6; k++) {
            p[k / 2][k % 2] = mesh_wide(&m, m.triangle[3 * i + (size_t)k / 2], k % 2);
        }
        area += fabs((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
                     (p[2][0] - p[0][0]) * (p[1][1] - p[0][1])) /
                2;
    }
    CHECK(fabs(area - (200 - 4 * depth)) < 1e-6, "%g deep from %d: area %.9g", depth, start, area);
    mesh_free(&m);
}

static void far_faces(void) {
    test("A notch far from the origin stays one, in doubles and in whole numbers");
    for (int start = 0; start < 8; start++) {
        check_notch("double", 0.2, start);
        check_notch("double", 1.1, start);
        check_notch("float", 1, start);
        check_notch("int", 2, start);
    }
}

static void crossing_faces(void) {
    test("A face that crosses itself is a fan, and counted; convex faces are fans");
    mesh m = {0};
    mesh_report r = {0};
    fail f;
    CHECK(read_text(&m, OBJ, "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\nf 1 3 2 4\n", &r,
                    &f) == 0,
          "%s", f.text);
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 0, 2, 3, 0, 2, 1, 0, 1, 3}, 4);
    only(&r, REPORT_OVERLAPPING, 1);
    mesh_free(&m);
}

static void sentences(void) {
    test("Every count has a sentence that holds the number, or none when all are 0");
    mesh_report r = {0};
    fail f = {{0}};
    for (unsigned line = 0; report_line(&r, line, "x", &f) >= 0; line++) {
        CHECK(f.text[0] == '\0', "'%s' of nothing", f.text);
    }
    for (int item = 0; item < REPORT_ITEMS; item++) {
        int said = 0;
        mesh_report one = {0};
        one.count[item] = 4711;
        if (item == REPORT_MISCOUNTED) { /* said by both numbers that differ by it */
            report_add_miscount(&one, (report_miscount){1, 4711, 0});
        }
        int more = 0;
        for (unsigned line = 0; more >= 0; line++) {
            fail sentence = {{0}};
            more = report_line(&one, line, "x", &sentence);
            said += more > 0 && strstr(sentence.text, "4711") != NULL;
        }
        CHECK(said == 1, "%s is said %d times", report_key((report_item)item), said);
    }
}

static void says_miscount(const mesh_report *r, const char *expected) {
    fail said = {{0}};
    int found = 0, more = 0;
    for (unsigned line = 0; more >= 0; line++) {
        more = report_line(r, line, "x", &said);
        found |= more > 0 && strcmp(said.text, expected) == 0;
    }
    CHECK(found, "'%s', not '%s'", said.text, expected);
}

static void miscount_sentences(void) {
    test("A wrong count is said beside what the size holds, of one file and of several");
    blob b = binary(6, 4, 0);
    mesh m = {0};
    mesh_report r = {0};
    fail f;
    CHECK(read_blob(&m, STL, &b, &r, &f) == 0, "%s", f.text);
    says_miscount(&r, "x: read whole: its count says 6 triangles, its size holds 4");
    b = binary(1, 2, 0);
    CHECK(read_blob(&m, STL, &b, &r, &f) == 0, "%s", f.text);
    says_miscount(&r, "x: read whole: the counts of 2 files say 7 triangles, their sizes hold 6");
    CHECK(r.count[REPORT_MISCOUNTED] == 3, "%llu", (unsigned long long)r.count[REPORT_MISCOUNTED]);
    mesh_free(&m);
}

int main(void) {
    mesh_folder();
    stl_in_any_case();
    stl_with_fillers();
    stl_without_end();
    stl_of_several();
    stl_text_speaks_of_lines();
    stl_text_with_control_bytes();
    stl_text_that_is_damaged();
    stl_that_is_binary();
    stl_with_loose_bytes();
    stl_that_miscounts();
    ply_of_64_bits();
    ply_with_small_faces();
    ply_with_more_in_it();
    ply_attributes();
    ply_of_other_types();
    ply_of_mixed_faces();
    ply_of_short_lines();
    obj_that_joins();
    obj_attributes();
    obj_of_old_keywords();
    concave_faces();
    far_faces();
    crossing_faces();
    sentences();
    miscount_sentences();
    return test_done();
}
