/* mesh_target - what the libFuzzer targets of the mesh readers have in common
 *
 * `mesh_target_try` reads a file in memory four times: into an empty mesh and behind a
 * triangle that is already there, each with and without repair. Promised, whatever the
 * bytes are (mesh.h, readers.h, report.h):
 *
 *   - all vertices are finite and within +-2^40, all indices are below `vertices`, and a
 *     wide coordinate is finite and at most one float away from its float;
 *   - on failure the mesh and the report are as they were, bit for bit;
 *   - a failure is one line that begins with the file's name, and so are the report's lines;
 *   - the second reading gives what the first gave, and counts the same;
 *   - repair changes nothing in a file that needs none, and says what it has dropped;
 *   - vertices and triangles are at most as many as the file has bytes;
 *   - read for its normals and colours, too, it has directions and colours, or is refused.
 *
 * What is done with a mesh that was read is in mesh_use.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_TARGET_H
#define MESH_TARGET_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/base/input.h"
#include "host_tools/mesh/readers.h"
#include "host_tools/mesh/recipe.h"
#include "host_tools/mesh/smooth.h"
#include "tests/fuzz/mesh_use.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* ---- the readers ---------------------------------------------------------------- */

typedef int mesh_reader(mesh *m, const input *in, mesh_report *report, fail *f);

static inline int mesh_target_recipe(mesh *m, const input *in, mesh_report *report, fail *f) {
    return recipe_read(m, in, 7, report, f);
}

/* How to read: the same for both readings of a pair. */
typedef struct mesh_way {
    int repair, centred;
    int wide; /* the triangle that is there has coordinates no float can hold */
} mesh_way;

/* Before the second reading: it must be added to. */
static inline mesh_report used_report(mesh_way way) {
    mesh_report r = {
        .repair = way.repair, .centred = way.centred, .moved = 0x1p-2, .vanished = 1000};
    for (uint64_t i = 0; i < REPORT_ITEMS; i++) {
        r.count[i] = 5 * i + 1;
    }
    return r;
}

/* ---- one reading ------------------------------------------------------------------- */

typedef struct reading {
    mesh m;
    mesh_report report, before;
    fail f;
    int status;
} reading;

static inline int same_report(const mesh_report *a, const mesh_report *b) {
    return a->repair == b->repair && a->centred == b->centred &&
           memcmp(a->count, b->count, sizeof a->count) == 0 &&
           memcmp(&a->moved, &b->moved, sizeof a->moved) == 0 && a->vanished == b->vanished;
}

static inline void add_old_triangle(mesh *m, int wide) {
    static const real ZERO = {0, 0}, THIRD = {1.0f / 3, 1.0 / 3}, HALF = {0.5f, 0.5};
    const real *x = wide ? &THIRD : &HALF;
    fail f = {""};
    const int status = mesh_add_real(m, (const real[]){*x, ZERO, ZERO}, &f) |
                       mesh_add_real(m, (const real[]){ZERO, HALF, ZERO}, &f) |
                       mesh_add_real(m, (const real[]){ZERO, ZERO, *x}, &f) |
                       mesh_add_triangle(m, 2, 0, 1, &f);
    promise(status == 0, "memory for one triangle", f.text);
}

static inline void check_failure(const reading *r, const mesh *old, const char *path) {
    promise(r->m.vertices == old->vertices && r->m.triangles == old->triangles,
            "a failure leaves something in the mesh", r->f.text);
    promise(same_report(&r->report, &r->before), "a failure is in the report", r->f.text);
    promise(one_line_about(r->f.text, path), "no line about the file", r->f.text);
}

static inline void check_lines(const mesh_report *r, const char *path) {
    int more = 0;
    for (unsigned line = 0; line < 50 && more >= 0; line++) {
        fail said = {""};
        more = report_line(r, line, path, &said);
        promise(more <= 0 || one_line_about(said.text, path), "a report of no lines", said.text);
    }
    promise(more < 0, "a report without an end", path);
}

static inline void read_once(reading *r, mesh_reader *reader, const input *in, mesh_way way,
                             int behind) {
    mesh old = {0};
    memset(r, 0, sizeof *r);
    r->report = (mesh_report){.repair = way.repair, .centred = way.centred};
    if (behind) {
        r->report = used_report(way);
        add_old_triangle(&r->m, way.wide);
        add_old_triangle(&old, way.wide);
    }
    r->before = r->report;
    r->status = reader(&r->m, in, &r->report, &r->f);
    promise(r->status == 0 || r->status == -1, "an unknown status", in->path);
    promise(same_start(&r->m, &old), "the old mesh changed", in->path);
    promise(mesh_holds(&r->m), "a mesh without its invariant", in->path);
    if (r->status == 0) {
        promise(r->f.text[0] == '\0', "a failure that is none", r->f.text);
        check_lines(&r->report, in->path);
    } else {
        check_failure(r, &old, in->path);
    }
    mesh_free(&old);
}

/* ---- two readings ---------------------------------------------------------------------- */

/* What `b` has added to the report that was there is what `a` counted. */
static inline int added_report(const mesh_report *a, const reading *b) {
    int same = b->report.vanished - b->before.vanished == a->vanished &&
               !(b->report.moved < a->moved) &&
               !(b->report.moved > fmax(a->moved, b->before.moved));
    for (int i = 0; i < REPORT_ITEMS; i++) {
        same &= b->report.count[i] - b->before.count[i] == a->count[i];
    }
    return same;
}

/* `b` was read behind `vertices` and `triangles` that were there. */
static inline int same_mesh(const mesh *a, const mesh *b, size_t vertices, size_t triangles) {
    if (b->vertices - vertices != a->vertices || b->triangles - triangles != a->triangles) {
        return 0;
    }
    int same = a->vertices == 0 ||
               memcmp(a->vertex, b->vertex + 3 * vertices, 3 * a->vertices * sizeof(float)) == 0;
    for (size_t i = 0; i < 3 * a->vertices; i++) {
        const double x = mesh_wide(a, i / 3, (int)(i % 3));
        const double y = mesh_wide(b, vertices + i / 3, (int)(i % 3));
        same &= memcmp(&x, &y, sizeof x) == 0;
    }
    for (size_t i = 0; i < 3 * a->triangles; i++) {
        same &= a->triangle[i] + vertices == b->triangle[3 * triangles + i];
    }
    return same;
}

/* Reads twice; the mesh in `first` is the caller's. */
static inline void read_twice(reading *first, mesh_reader *reader, const input *in, mesh_way way) {
    reading second;
    read_once(first, reader, in, way, 0);
    read_once(&second, reader, in, way, 1);
    promise(first->status == second.status && strcmp(first->f.text, second.f.text) == 0,
            "the second reading says something else", second.f.text);
    if (first->status == 0) {
        promise(added_report(&first->report, &second), "two reports differ", in->path);
        promise(same_mesh(&first->m, &second.m, 3, 1), "the second reading gives another mesh",
                in->path);
    }
    mesh_free(&second.m);
}

static inline uint64_t dropped(const mesh_report *r) {
    return r->count[REPORT_BAD_FACES] + r->count[REPORT_BAD_VERTICES];
}

/* `plain` without repair, `repaired` with it. */
static inline void check_repair(const reading *plain, const reading *repaired, const char *path) {
    if (plain->status == 0) {
        mesh_report r = plain->report;
        r.repair = repaired->report.repair;
        promise(dropped(&r) == 0, "a repair that was not asked for", path);
        promise(repaired->status == 0, "repair refuses what is read without", repaired->f.text);
        promise(same_report(&r, &repaired->report), "repair where nothing needs it", path);
        promise(same_mesh(&plain->m, &repaired->m, 0, 0), "repair changes a good mesh", path);
    } else if (repaired->status == 0) {
        /* a missing corner of a point, a line or a short strip takes no triangle with it */
        promise(dropped(&repaired->report) > 0 || repaired->report.count[REPORT_LOOSE_BYTES] > 0 ||
                    strstr(plain->f.text, "uses vertex") != NULL,
                "repair does not say what it did", plain->f.text);
    }
}

/* ---- the target ---------------------------------------------------------------------- */

static inline void check_size(const mesh *m, size_t size) {
    promise(m->vertices <= size && m->triangles <= size, "more than a file can hold", "");
    promise(m->vertex_room <= 2 * size + 64 && m->triangle_room <= 2 * size + 64,
            "more memory than the file asks for", "");
}

/* What is tried of many ways: the same for the same bytes. */
static inline unsigned choice_of(const uint8_t *data, size_t size) {
    uint32_t h = 2166136261u;
    for (size_t i = 0; i < size; i++) {
        h = (h ^ data[i]) * 16777619u;
    }
    return h >> 8;
}

/* `members`: what the file names counts too, and its size says nothing. */
/* Of every corner: a normal is a direction or none, a colour is one or none, and texture
 * coordinates are two numbers or none. */
static inline int corners_hold(const mesh *m, const mesh_corners *c) {
    int holds = (c->normal == NULL && c->colour == NULL && c->texcoord[0] == NULL) ||
                c->triangles >= m->triangles;
    holds &= (c->texcoord[0] == NULL) == (c->texcoord[1] == NULL);
    for (size_t i = 0; i < 3 * m->triangles && holds; i++) {
        double n[3] = {1, 0, 0};
        if (c->normal != NULL && c->normal[i] != CORNER_NO_NORMAL) {
            corner_direction(c->normal[i], n);
        }
        const double squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        holds &= squared > 0.999 && squared < 1.001;
        holds &=
            c->colour == NULL || c->colour[i] == CORNER_NO_COLOUR || c->colour[i] >> 24 == 0xFF;
        for (int a = 0; a < 2 && c->texcoord[0] != NULL && c->texcoord[1] != NULL; a++) {
            const float x = plt_float_of(c->texcoord[a][i]);
            holds &= c->texcoord[a][i] == CORNER_NO_TEXCOORD
                         ? c->texcoord[!a][i] == c->texcoord[a][i]
                         : fabsf(x) <= 65536.0f;
        }
    }
    return holds;
}

/* The same file by someone who wants normals and colours, and then makes some. */
static inline void read_corners(mesh_reader *reader, const input *in, int repair) {
    mesh_corners c = {.wants_normals = 1, .wants_colours = 1, .wants_texcoords = 1};
    mesh m = {.corners = &c};
    mesh_report report = {.repair = repair};
    fail f = {""};
    const int status = reader(&m, in, &report, &f);
    promise(status == 0 || (m.triangles == 0 && m.vertices == 0), "something was left", in->path);
    promise(status == 0 || one_line_about(f.text, in->path), f.text, in->path);
    promise(status != 0 || (mesh_holds(&m) && corners_hold(&m, &c)), "corners", in->path);
    if (status == 0 && m.triangles < 2000 && mesh_smooth(&m, 40, &c) == 0) {
        promise(corners_hold(&m, &c), "smooth corners", in->path);
    }
    mesh_free(&m);
    corners_free(&c);
}

static inline void mesh_target_try(mesh_reader *reader, const char *path, const uint8_t *data,
                                   size_t size, int members) {
    const unsigned choice = choice_of(data, size);
    mesh_way way = {.centred = choice % 2, .wide = choice / 2 % 2};
    input in = {.path = path, .bytes = malloc(size + 1), .size = size};
    reading plain, repaired;
    if (size == 0) { /* input_read refuses it */
        free(in.bytes);
        return;
    }
    memcpy(in.bytes, data, size);
    in.bytes[size] = 0;
    read_twice(&plain, reader, &in, way);
    way.repair = 1;
    read_twice(&repaired, reader, &in, way);
    promise(memcmp(in.bytes, data, size) == 0 && in.bytes[size] == 0, "the file changed", path);
    check_repair(&plain, &repaired, path);
    if (!members) {
        check_size(&plain.m, size);
        check_size(&repaired.m, size);
    }
    read_corners(reader, &in, 0);
    read_corners(reader, &in, 1);
    if (repaired.status == 0) {
        mesh_use(&repaired.m, choice / 4);
    }
    mesh_free(&plain.m);
    mesh_free(&repaired.m);
    free(in.bytes);
}

#endif
