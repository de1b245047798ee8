/* test_mesh_hostile - readers and bytes that are not to be trusted
 *
 * The oracle, for every file whatever it holds: reading ends, within
 * memory in proportion to the file; it either returns a valid mesh, or
 * fails with one line that begins with the path, and leaves the mesh as
 * it was.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/readers.h"
#include "host_tools/mesh/recipe.h"
#include "tests/hostile/mesh_files.h"

typedef int (*reader_call)(mesh *, const input *, mesh_report *, fail *);

static int read_recipe(mesh *m, const input *in, mesh_report *report, fail *f) {
    return recipe_read(m, in, 0, report, f);
}

/* A small file of each kind: what is cut and flipped. */
typedef struct sample {
    const char *path;
    reader_call read;
    int text_end_matters; /* any cut makes it incomplete */
    blob file;
} sample;

enum { SAMPLES = 9 };
static sample samples[SAMPLES];

static const float POINTS[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
static const uint32_t FACES[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

static void make_ply_binary(blob *b, int big) {
    put_text(b, "ply\nformat ");
    put_text(b, big ? "binary_big_endian" : "binary_little_endian");
    put_text(b,
             " 1.0\ncomment a tetrahedron\nelement face 4\nproperty uchar red\n"
             "property list uchar int vertex_indices\nelement vertex 4\nproperty double x\n"
             "property float y\nproperty float z\nproperty list ushort short n\n"
             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n");
    for (int i = 0; i < 4; i++) {
        put_number(b, 255, 1, big);
        put_number(b, 3, 1, big);
        for (int k = 0; k < 3; k++) {
            put_number(b, FACES[i][k], 4, big);
        }
    }
    for (int i = 0; i < 4; i++) {
        put_double(b, (double)POINTS[i][0], big);
        put_float(b, POINTS[i][1], big);
        put_float(b, POINTS[i][2], big);
        put_number(b, 1, 2, big);
        put_number(b, 7, 2, big);
    }
    static const uint32_t STRIP[] = {0, 1, 2, UINT32_MAX, 3, 2, 1};
    put_number(b, 7, 4, big);
    for (int i = 0; i < 7; i++) {
        put_number(b, STRIP[i], 4, big);
    }
}

static void make_ply_ascii(blob *b) {
    put_text(b,
             "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement vertex 4\r\nproperty float x\r\n"
             "property double y\r\nproperty float32 z\r\nproperty list uchar float q\r\n"
             "element face 2\r\nproperty list uchar int vertex_index\r\nend_header\r\n"
             "0 0 0 0\r\n1.5 -2e3 nan 1 9\r\n0 1 0 2 8 8\r\n0 0 1 0\r\n"
             "4 0 1 2 3\r\n3 2 1 0");
}

static void make_stl_binary(blob *b) {
    char head[80] = "solid binary";
    put(b, head, sizeof head);
    put_number(b, 4, 4, 0);
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 12; k++) {
            put_float(b, k < 3 ? 0 : POINTS[FACES[i][(k - 3) / 3]][k % 3], 0);
        }
        put_number(b, 0, 2, 0);
    }
}

static void make_samples(void) {
    static const char *const PATHS[SAMPLES] = {
        MESH_FOLDER "little.ply", MESH_FOLDER "big.ply",     MESH_FOLDER "ascii.ply",
        MESH_FOLDER "binary.stl", MESH_FOLDER "ascii.stl",   MESH_FOLDER "hostile.obj",
        MESH_FOLDER "recipe.txt", MESH_FOLDER "no_name_obj", MESH_FOLDER "no_name_stl",
    };
    static const reader_call READERS[SAMPLES] = {ply_read,    ply_read, ply_read,
                                                 stl_read,    stl_read, obj_read,
                                                 read_recipe, obj_read, stl_read};
    for (int i = 0; i < SAMPLES; i++) {
        samples[i].path = PATHS[i];
        samples[i].read = READERS[i];
        samples[i].text_end_matters = i < 2 || i == 3 || i == 8;
    }
    make_ply_binary(&samples[0].file, 0);
    make_ply_binary(&samples[1].file, 1);
    make_ply_ascii(&samples[2].file);
    make_stl_binary(&samples[3].file);
    put_text(&samples[4].file,
             "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
             "vertex 1e1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid x\n");
    put_text(&samples[5].file,
             "# x\nv 0 0 0\nv 1 0 0 1\r\nv 0 1e0 0\nvn 1 1 1\nf 1/1 2//2 3/3/3\n"
             "f -1 -2 \\\n-3 1\no x\n");
    put_text(&samples[6].file, "# x\nsub.obj 4 0 1 0\nsub_{}.obj*3+1 1 2 3 4 90 45 # y\n");
    samples[7].file = samples[5].file;
    make_stl_binary(&samples[8].file);
    const char *sub = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    file_write(MESH_FOLDER "sub.obj", sub, strlen(sub));
    file_write(MESH_FOLDER "sub_001.obj", sub, strlen(sub));
}

static unsigned long failures, successes; /* since begin() */

static void begin(const char *sentence) {
    test(sentence);
    failures = successes = 0;
}

/* So many files at least must have been refused, and so many read. */
static void both_happened(unsigned long refused, unsigned long read) {
    CHECK(failures >= refused && successes >= read, "%lu refused, %lu read", failures, successes);
}

static void check_text(const char *path, const fail *f) {
    const size_t length = strlen(path);
    CHECK(strncmp(f->text, path, length) == 0 && strncmp(f->text + length, ": ", 2) == 0 &&
              f->text[length + 2],
          "'%s' does not name %s", f->text, path);
    CHECK(strchr(f->text, ';') && f->text[strlen(f->text) - 1] != ';', "no remedy: '%s'", f->text);
    int controls = 0;
    for (const char *c = f->text; *c; c++) {
        controls += (unsigned char)*c < 0x20 || *c == 0x7f;
    }
    CHECK(controls == 0, "control characters in '%s'", f->text);
}

/* `m` held one triangle before the call. */
static void check_result(const char *path, size_t size, int result, const mesh *m, const fail *f) {
    CHECK(mesh_is_valid(m), "%s: not valid", path);
    CHECK(m->vertex_room + m->triangle_room <= 12 * size + 100, "%s: room for %zu and %zu of %zu",
          path, m->vertex_room, m->triangle_room, size);
    if (result == 0) {
        successes++;
        CHECK(f->text[0] == '\0', "success says '%s'", f->text);
        CHECK(m->vertices >= 3 && m->triangles >= 1, "%s: lost what was there", path);
    } else {
        failures++;
        CHECK(result == -1, "returned %d", result);
        CHECK(m->vertices == 3 && m->triangles == 1 && m->vertex[3] == 7 && m->triangle[2] == 2,
              "%s: the mesh changed", path);
        check_text(path, f);
    }
}

static mesh one_triangle(void) {
    mesh m = {0};
    fail f = {{0}};
    mesh_add_vertex(&m, 0, 0, 0, &f);
    mesh_add_vertex(&m, 7, 0, 0, &f);
    mesh_add_vertex(&m, 0, 7, 0, &f);
    mesh_add_triangle(&m, 0, 1, 2, &f);
    return m;
}

/* The bytes lie in a block of just their size, as `input_read` makes it,
 * so that the address sanitizer sees any step past them. */
static int feed(const sample *s, const void *bytes, size_t size, int wanted) {
    input in = {.path = s->path, .bytes = malloc(size + 1), .size = size};
    memcpy(in.bytes, bytes, size);
    in.bytes[size] = 0;
    mesh m = one_triangle();
    mesh_report report = {.repair = wanted};
    fail f = {{0}};
    const int result = s->read(&m, &in, &report, &f);
    check_result(s->path, size, result, &m, &f);
    mesh_free(&m);
    input_free(&in);
    return result;
}

static void cuts(void) {
    begin("Files cut at every byte are read or refused in one line, and the mesh is kept");
    for (int i = 0; i < SAMPLES; i++) {
        const sample *s = &samples[i];
        for (size_t size = 1; size < s->file.size; size++) {
            for (int wanted = 0; wanted < 2; wanted++) {
                const int result = feed(s, s->file.bytes, size, wanted);
                /* Whole triangles of a binary STL are read, whatever its count says. */
                const int may_be_read =
                    !s->text_end_matters || (s->read == stl_read && size >= 84 && size % 50 == 34);
                CHECK(result == -1 || may_be_read, "%s cut at %zu was read", s->path, size);
            }
        }
        CHECK(feed(s, s->file.bytes, s->file.size, 1) == 0, "%s whole", s->path);
    }
    both_happened(3000, 100);
}

static void cuts_on_disk(void) {
    begin("The same through files, where the format is to be found first");
    mesh_report report = {0};
    for (int i = 0; i < SAMPLES; i++) {
        const sample *s = &samples[i];
        for (size_t size = 0; size < s->file.size; size += size < 100 ? 1 : 7) {
            blob b = s->file;
            b.size = size;
            mesh m = one_triangle();
            fail f;
            const int result = read_blob(&m, s->path, &b, &report, &f);
            check_result(s->path, size, result, &m, &f);
            CHECK(size > 0 || result == -1, "an empty file was read");
            mesh_free(&m);
        }
    }
    both_happened(500, 50);
}

static void flips(void) {
    begin("Files with any one byte changed to anything are read or refused");
    for (int i = 0; i < SAMPLES; i++) {
        const sample *s = &samples[i];
        const int step = s->read == read_recipe ? 5 : 1; /* it opens files each time */
        blob b = s->file;
        for (size_t at = 0; at < b.size; at++) {
            const unsigned char was = b.bytes[at];
            for (int value = (int)at % step; value < 256; value += step) {
                b.bytes[at] = (unsigned char)value;
                feed(s, b.bytes, b.size, value & 1);
            }
            b.bytes[at] = was;
        }
    }
    both_happened(100000, 100000);
}

static void flips_to_zero(void) {
    begin("Whole runs of zero and of 255 bytes anywhere are read or refused");
    for (int i = 0; i < SAMPLES; i++) {
        const sample *s = &samples[i];
        for (size_t at = 0; at < s->file.size; at++) {
            for (int k = 0; k < 8; k++) {
                blob b = s->file;
                const size_t left = b.size - at, run = (size_t)4 << k / 2;
                memset(b.bytes + at, k % 2 ? 255 : 0, run < left ? run : left);
                feed(s, b.bytes, b.size, k / 2 & 1);
            }
        }
    }
    both_happened(5000, 1000);
}

static void doublings(void) {
    begin("Any run of bytes left out or written twice is read or refused");
    for (int i = 0; i < SAMPLES; i++) {
        const sample *s = &samples[i];
        for (size_t at = 0; at < s->file.size; at++) {
            for (size_t run = 1; run <= 27; run += 13) {
                const size_t end = at + run < s->file.size ? at + run : s->file.size;
                blob less = {.size = 0}, more = {.size = 0};
                put(&less, s->file.bytes, at);
                put(&less, s->file.bytes + end, s->file.size - end);
                put(&more, s->file.bytes, end);
                put(&more, s->file.bytes + at, s->file.size - at);
                if (less.size > 0) {
                    feed(s, less.bytes, less.size, (int)(at & 1));
                }
                feed(s, more.bytes, more.size, (int)(at & 1));
            }
        }
    }
    both_happened(1000, 500);
}

static void garbage(void) {
    begin("Random bytes after the head of any format are read or refused");
    uint32_t seed = 12345;
    for (int round = 0; round < 3000; round++) {
        const sample *s = &samples[round % SAMPLES];
        blob b = s->file;
        const size_t kept = (size_t)round / SAMPLES % (b.size + 1);
        b.size = b.size + 200 > sizeof b.bytes ? b.size : b.size + 200;
        for (size_t i = kept; i < b.size; i++) {
            seed = seed * 1664525u + 1013904223u;
            b.bytes[i] = (unsigned char)(seed >> 24);
        }
        feed(s, b.bytes, b.size, round & 1);
    }
    both_happened(1000, 100);
}

static void long_lines(void) {
    begin("Lines, words and paths of a megabyte end in one short line, or are read");
    enum { LONG = 1 << 20 };
    static const char *const HEADS[] = {
        "ply\nformat ascii 1.0\nelement ",
        "ply\nformat ascii 1.0\ncomment ",
        "ply\n",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 ",
        "v 0 0 ",
        "v 1 2 3\nf 1 1 1 ",
        "# ",
        "",
    };
    static const char FILLS[] = {'a', '1', '-', ' ', '\\', '\r', '\n', '\0', '.', '\x7f'};
    char *bytes = malloc(LONG);
    for (size_t head = 0; head < sizeof HEADS / sizeof HEADS[0]; head++) {
        for (size_t fill = 0; fill < sizeof FILLS; fill++) {
            memset(bytes, FILLS[fill], LONG);
            memcpy(bytes, HEADS[head], strlen(HEADS[head]));
            for (int i = 2; i < SAMPLES; i += i == 2 ? 2 : 1) {
                feed(&samples[i], bytes, LONG, (int)fill & 1);
            }
        }
    }
    free(bytes);
    both_happened(100, 10);
}

static void long_paths(void) {
    test("A path of 3000 bytes shows its end, and the remedy is still there");
    char path[3001];
    memset(path, 'a', 3000);
    path[3000] = '\0';
    mesh m = {0};
    mesh_report report = {0};
    fail f = {{0}};
    CHECK(mesh_read(&m, path, 0, &report, &f) == -1, "read");
    CHECK(strncmp(f.text, "...aaaa", 7) == 0, "%s", f.text);
    CHECK(strstr(f.text, "; check the path"), "%s", f.text);
}

int main(void) {
    mesh_folder();
    make_samples();
    cuts();
    cuts_on_disk();
    flips();
    flips_to_zero();
    doublings();
    garbage();
    long_lines();
    long_paths();
    return test_done();
}
