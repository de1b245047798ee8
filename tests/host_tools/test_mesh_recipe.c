/* test_mesh_recipe - scenes put together from meshes
 *
 * SPDX-License-Identifier: MIT */
#include <unistd.h>

#include "tests/hostile/mesh_files.h"

#define FOLDER MESH_FOLDER "recipe/"
#define RECIPE FOLDER "scene.txt"

/* x from 1 to 3, y from 10 to 11, z from -2 to 2: sides 2, 1, 4. */
static const char WEDGE[] = "v 1 10 -2\nv 3 10 2\nv 1 11 2\nv 99 99 99\nf 1 2 3\n";

static void write_text(const char *path, const char *text) {
    file_write(path, text, strlen(text));
}

static void make_files(void) {
    mesh_folder();
    mkdir(FOLDER, 0777);
    mkdir(FOLDER "deeper", 0777);
    write_text(FOLDER "wedge.obj", WEDGE);
    write_text(FOLDER "flat.obj", "v 5 5 5\nf 1 1 1\n");
    write_text(FOLDER "bare.obj", "v 5 5 5\nv 6 6 6\nv 7 5 5\n");
    write_text(FOLDER "broken.obj", "v 5 5\n");
    write_text(FOLDER "bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\n");
    write_text(FOLDER "other.txt", "wedge.obj 1 0 0 0\n");
    for (int i = 0; i < 12; i++) {
        char path[200], text[200];
        snprintf(path, sizeof path, FOLDER "deeper/step_%03d_.obj", i);
        snprintf(text, sizeof text, "v 0 0 0\nv 100 0 0\nv 0 %d 0\nf 1 2 3\n", i + 1);
        write_text(path, text);
    }
}

static void expect_first(const char *line, const float expected[9]) {
    mesh m = must_read_text(RECIPE, line);
    CHECK(m.vertices == 4 && m.triangles == 1, "%zu vertices", m.vertices);
    for (size_t i = 0; i < 9 && m.vertices == 4; i++) {
        CHECK(m.vertex[i] == expected[i], "'%s': coordinate %zu is %.9g, not %.9g", line, i,
              (double)m.vertex[i], (double)expected[i]);
    }
    mesh_free(&m);
}

static void positions(void) {
    test("The longest side gets the size, the centre of the base its position");
    expect_first("wedge.obj 4 0 0 0", (const float[]){-1, 0, -2, 1, 0, 2, -1, 1, 2});
    expect_first("wedge.obj 8 10 20 30\n", (const float[]){8, 20, 26, 12, 20, 34, 8, 22, 34});
    expect_first("  wedge.obj\t4.0  -1e0 .5 +2 # here",
                 (const float[]){-2, 0.5f, 0, 0, 0.5f, 4, -2, 1.5f, 4});
}

static void quarters(void) {
    test("Quarters of the circle are exact, first about x, then about y");
    expect_first("wedge.obj 4 0 0 0 0 0", (const float[]){-1, 0, -2, 1, 0, 2, -1, 1, 2});
    expect_first("wedge.obj 4 0 0 0 90 0", (const float[]){-1, 4, -0.5f, 1, 0, -0.5f, -1, 0, 0.5f});
    expect_first("wedge.obj 4 0 0 0 -270 360",
                 (const float[]){-1, 4, -0.5f, 1, 0, -0.5f, -1, 0, 0.5f});
    expect_first("wedge.obj 4 0 0 0 0 90", (const float[]){-2, 0, 1, 2, 0, -1, 2, 1, 1});
    expect_first("wedge.obj 4 0 0 0 0 180", (const float[]){1, 0, 2, -1, 0, -2, 1, 1, -2});
    expect_first("wedge.obj 4 0 0 0 90 90", (const float[]){-0.5f, 4, 1, -0.5f, 0, -1, 0.5f, 0, 1});
}

static void rotates_freely(void) {
    test("A rotation by 30 degrees about y keeps the box's centre and its longest side");
    mesh m = must_read_text(RECIPE, "wedge.obj 4 1 2 3 0 30");
    float low[3] = {1e9f, 1e9f, 1e9f}, high[3] = {-1e9f, -1e9f, -1e9f};
    for (size_t i = 0; i < 9 && m.vertices == 4; i++) {
        low[i % 3] = fminf(low[i % 3], m.vertex[i]);
        high[i % 3] = fmaxf(high[i % 3], m.vertex[i]);
    }
    CHECK(fabsf(high[0] - low[0] - 4) < 1e-6f, "%g wide", (double)(high[0] - low[0]));
    CHECK(fabsf(high[2] + low[2] - 6) < 1e-6f, "centre z %g", (double)(high[2] + low[2]) / 2);
    CHECK(fabsf(high[0] + low[0] - 2) < 1e-6f, "centre x %g", (double)(high[0] + low[0]) / 2);
    CHECK(low[1] == 2, "base %g", (double)low[1]);
    /* The diagonal from (1, 10, -2) to (3, 10, 2), rotated, spans the width. */
    const double c = sqrt(0.75), s = 0.5, width = 2 * c + 4 * s;
    const double x = 4, z = (4 * c - 2 * s) * 4 / width;
    CHECK(m.vertices == 4 && fabs((double)(m.vertex[3] - m.vertex[0]) - x) < 1e-6, "x");
    CHECK(m.vertices == 4 && fabs((double)(m.vertex[5] - m.vertex[2]) - z) < 1e-6, "z");
    mesh_free(&m);
}

static void adds_lines(void) {
    test("Lines add up in order; comments, blank lines and CRLF change nothing");
    mesh m = must_read_text(RECIPE,
                            "# two wedges\r\n\r\nwedge.obj 4 0 0 0\r\n"
                            "  # between\r\nwedge.obj 4 0 0 0 0 180\r\n");
    check_triangles(&m, (const uint32_t[]){0, 1, 2, 4, 5, 6}, 2);
    CHECK(m.vertices == 8 && m.vertex[0] == -1 && m.vertex[12] == 1, "%zu vertices", m.vertices);
    mesh_free(&m);
}

/* The height of the one triangle, 100 wide. */
static float height_of(const char *text, unsigned frame) {
    mesh m = {0};
    mesh_report report = {0};
    fail f = {{0}};
    write_text(RECIPE, text);
    CHECK(mesh_read(&m, RECIPE, frame, &report, &f) == 0, "%s", f.text);
    const float height = m.vertices == 3 ? m.vertex[7] : -1;
    mesh_free(&m);
    return height;
}

static void chooses_frames(void) {
    test("A sequence gives frame (frame + start) modulo N");
    const char *plain = "deeper/step_{}_.obj*12 100 0 0 0\n";
    CHECK(height_of(plain, 0) == 1, "frame 0");
    CHECK(height_of(plain, 11) == 12, "frame 11");
    CHECK(height_of(plain, 12) == 1, "frame 12");
    CHECK(height_of(plain, 4294967295u) == 4294967295u % 12 + 1, "frame 2^32 - 1");
    const char *late = "deeper/step_{}_.obj*12+10 100 0 0 0\n";
    CHECK(height_of(late, 0) == 11, "frame 0 + 10");
    CHECK(height_of(late, 2) == 1, "frame 2 + 10");
    CHECK(height_of("deeper/step_{}_.obj*3+9223372036854775807 100 0 0 0\n", 1) == 3, "far start");
}

static void finds_paths(void) {
    test("Paths are relative to the recipe; absolute ones are not");
    char here[2000], text[3000];
    CHECK(getcwd(here, sizeof here) != NULL, "no directory");
    snprintf(text, sizeof text, "%s/" FOLDER "wedge.obj 4 0 0 0\n", here);
    mesh m = must_read_text(FOLDER "deeper/scene.txt", text);
    CHECK(m.triangles == 1, "%zu triangles", m.triangles);
    mesh_free(&m);
    m = must_read_text(FOLDER "deeper/scene.txt", "../wedge.obj 4 0 0 0\n");
    CHECK(m.triangles == 1, "%zu triangles", m.triangles);
    mesh_free(&m);
}

#define NUMBERS "line 1: a size and a position are missing; write FILE SIZE X Y Z"
#define ANGLES "line 1: only two angles may follow FILE SIZE X Y Z; correct them"
#define SEQUENCE "line 1: a sequence has both {} and *N; write name_{}.ply*N"
#define FRAMES "line 1: '*' needs the number of frames after it; write 1 to 1000"

static void refuses_lines(void) {
    test("A line that cannot be read is refused with its number and the remedy");
    must_fail_text(RECIPE, "wedge.obj\n", NUMBERS);
    must_fail_text(RECIPE, "wedge.obj 4 0 0\n", NUMBERS);
    must_fail_text(RECIPE, "wedge.obj 4 0 zero 0\n", NUMBERS);
    must_fail_text(RECIPE, "wedge.obj nan 0 0 0\n", NUMBERS);
    must_fail_text(RECIPE, "wedge.obj 4 0 0 # 0\n", NUMBERS);
    must_fail_text(RECIPE, "wedge.obj 4 0 0 0 90\n", ANGLES);
    must_fail_text(RECIPE, "wedge.obj 4 0 0 0 90 0 0\n", ANGLES);
    must_fail_text(RECIPE, "wedge.obj 0 0 0 0\n", "line 1: the size is not above 0; correct it");
    must_fail_text(RECIPE, "wedge.obj -4 0 0 0\n", "line 1: the size is not above 0; correct it");
    must_fail_text(RECIPE, "deeper/step_{}_.obj 4 0 0 0\n", SEQUENCE);
    must_fail_text(RECIPE, "wedge.obj*3 4 0 0 0\n", SEQUENCE);
    must_fail_text(RECIPE, "deeper/step_{}_.obj*0 4 0 0 0\n", FRAMES);
    must_fail_text(RECIPE, "deeper/step_{}_.obj*1001 4 0 0 0\n", FRAMES);
    must_fail_text(RECIPE, "deeper/step_{}_.obj* 4 0 0 0\n", FRAMES);
    must_fail_text(RECIPE, "deeper/step_{}_.obj*12x 4 0 0 0\n", FRAMES);
    must_fail_text(RECIPE, "deeper/step_{}_.obj*12+x 4 0 0 0\n",
                   "line 1: '+' needs the first frame after it; write a whole number from 0");
}

static void refuses_files(void) {
    test("A mesh that cannot be used is named together with the recipe's line");
    must_fail_text(RECIPE, "\nmissing.obj 4 0 0 0\n",
                   "line 2: " FOLDER
                   "missing.obj: cannot open: No such file or directory; "
                   "check the spelling and the directory you are in");
    must_fail_text(RECIPE, "broken.obj 4 0 0 0\n",
                   "line 1: " FOLDER
                   "broken.obj: line 1: a coordinate is missing; "
                   "correct the line");
    must_fail_text(RECIPE, "other.txt 4 0 0 0\n",
                   "line 1: " FOLDER
                   "other.txt: is a recipe inside a recipe; "
                   "write its lines there");
    must_fail_text(RECIPE, "scene.txt 4 0 0 0\n",
                   "line 1: " FOLDER
                   "scene.txt: is a recipe inside a recipe; "
                   "write its lines there");
    must_fail_text(RECIPE, "flat.obj 4 0 0 0\n",
                   "line 1: " FOLDER "flat.obj: has no extent to scale; leave it out");
    must_fail_text(RECIPE, "bare.obj 4 0 0 0\n",
                   "line 1: " FOLDER
                   "bare.obj: 3 vertices, no triangles: nothing to place; leave it out");
    must_fail_text(RECIPE, "wedge.obj 4 1e13 0 0\n",
                   "line 1: " FOLDER
                   "wedge.obj: its position is beyond +-2^40; "
                   "choose smaller numbers");
    must_fail_text(RECIPE, "deeper 4 0 0 0\n",
                   "line 1: " FOLDER "deeper: is a directory; name a file in it");
}

static void leaves_all(void) {
    test("A failing recipe leaves the mesh and the repair counts as they were");
    mesh m = must_read_text(RECIPE, "wedge.obj 4 0 0 0\n");
    mesh_report report = {.repair = 1,
                          .count = {[REPORT_BAD_VERTICES] = 5, [REPORT_BAD_FACES] = 6}};
    fail f;
    CHECK(read_text(&m, RECIPE, "bad.obj 1 0 0 0\nmissing.obj 1 0 0 0\n", &report, &f) == -1,
          "read");
    CHECK(m.vertices == 4 && m.triangles == 1, "%zu vertices", m.vertices);
    CHECK(report.count[REPORT_BAD_VERTICES] == 5 && report.count[REPORT_BAD_FACES] == 6, "counted");
    CHECK(read_text(&m, RECIPE, "bad.obj 1 0 0 0\n", &report, &f) == 0, "%s", f.text);
    CHECK(m.vertices == 8 && m.triangles == 2, "%zu vertices", m.vertices);
    CHECK(report.count[REPORT_BAD_VERTICES] == 6 && report.count[REPORT_BAD_FACES] == 7,
          "not counted");
    mesh_free(&m);
}

int main(void) {
    make_files();
    positions();
    quarters();
    rotates_freely();
    adds_lines();
    chooses_frames();
    finds_paths();
    refuses_lines();
    refuses_files();
    leaves_all();
    return test_done();
}
