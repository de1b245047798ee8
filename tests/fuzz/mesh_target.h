/* mesh_target - what the libFuzzer targets of the mesh readers have in common
 *
 * `mesh_target_try` reads a file in memory four times: into an empty mesh and behind a
 * triangle that is already there, each with and without repair. Promised, whatever the
 * bytes are (mesh.h, readers.h):
 *
 *   - all vertices are finite and within +-2^40, all indices are below `vertices`;
 *   - on failure the mesh and the report are as they were, bit for bit;
 *   - a failure is one line that begins with the file's name;
 *   - the second reading gives what the first gave;
 *   - repair changes nothing in a file that needs none;
 *   - vertices and triangles are at most as many as the file has bytes.
 *
 * A small mesh goes on to reduction and packing: those succeed, or fail with a sentence,
 * and what they made keeps its own promises; images open and are traced.
 *
 * The only calls of the readers are in the first section.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_TARGET_H
#define MESH_TARGET_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/planelet_config.h"
#include "host_tools/base/input.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/mesh/readers.h"
#include "host_tools/mesh/recipe.h"
#include "host_tools/mesh/reduce.h"
#include "host_tools/pack/pack.h"
#include "tests/hostile/images.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* ---- the readers ---------------------------------------------------------------- */

typedef mesh_repair mesh_report;

static inline mesh_report mesh_report_of(int repair) {
    return (mesh_report){.wanted = repair};
}

static inline int mesh_report_same(const mesh_report *a, const mesh_report *b) {
    return a->wanted == b->wanted && a->bad_vertices == b->bad_vertices &&
           a->bad_triangles == b->bad_triangles;
}

static inline int mesh_report_empty(const mesh_report *r) {
    return r->bad_vertices == 0 && r->bad_triangles == 0;
}

typedef int mesh_reader(mesh *m, const input *in, mesh_report *report, fail *f);

static inline int mesh_target_recipe(mesh *m, const input *in, mesh_report *report, fail *f) {
    return recipe_read(m, in, 7, report, f);
}

/* ---- promises ---------------------------------------------------------------------- */

static inline void promise(int kept, const char *sentence, const char *detail) {
    if (!kept) {
        fprintf(stderr, "%s: %s\n", sentence, detail);
        abort();
    }
}

static inline int mesh_holds(const mesh *m) {
    int holds = m->vertices <= m->vertex_room && m->triangles <= m->triangle_room;
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        holds &= fabsf(m->vertex[i]) <= PLT_COORD_MAX; /* false for NaN */
    }
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        holds &= m->triangle[i] < m->vertices;
    }
    return holds;
}

static inline int one_line_about(const char *text, const char *path) {
    const size_t length = strlen(path);
    for (const char *c = text; *c != '\0'; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            return 0;
        }
    }
    return strncmp(text, path, length) == 0 && strncmp(text + length, ": ", 2) == 0 &&
           text[length + 2] != '\0';
}

/* One reading, and what it gave. */
typedef struct reading {
    mesh m;
    mesh_report report;
    fail f;
    int status;
} reading;

/* The first `vertices` and `triangles` of both are the same. */
static inline int same_start(const mesh *a, const mesh *b, size_t vertices, size_t triangles) {
    return a->vertices >= vertices && b->vertices >= vertices && a->triangles >= triangles &&
           b->triangles >= triangles &&
           (vertices == 0 || memcmp(a->vertex, b->vertex, 12 * vertices) == 0) &&
           (triangles == 0 || memcmp(a->triangle, b->triangle, 12 * triangles) == 0);
}

static inline void add_old_triangle(mesh *m) {
    fail f = {""};
    const int status = mesh_add_vertex(m, 1.5f, 0, 0, &f) | mesh_add_vertex(m, 0, 2.5f, 0, &f) |
                       mesh_add_vertex(m, 0, 0, 3.5f, &f) | mesh_add_triangle(m, 2, 0, 1, &f);
    promise(status == 0, "memory for one triangle", f.text);
}

static inline void read_once(reading *r, mesh_reader *reader, const input *in, int repair,
                             int behind) {
    mesh old = {0};
    memset(r, 0, sizeof *r);
    r->report = mesh_report_of(repair);
    if (behind) {
        add_old_triangle(&r->m);
        add_old_triangle(&old);
    }
    r->status = reader(&r->m, in, &r->report, &r->f);
    promise(r->status == 0 || r->status == -1, "an unknown status", in->path);
    promise(same_start(&r->m, &old, old.vertices, old.triangles), "the old mesh changed", in->path);
    promise(mesh_holds(&r->m), "a mesh without its invariant", in->path);
    if (r->status == 0) {
        promise(r->f.text[0] == '\0', "a failure that is none", r->f.text);
    } else {
        const mesh_report none = mesh_report_of(repair);
        promise(r->m.vertices == old.vertices && r->m.triangles == old.triangles,
                "a failure leaves something in the mesh", r->f.text);
        promise(mesh_report_same(&r->report, &none), "a failure is in the report", r->f.text);
        promise(one_line_about(r->f.text, in->path), "no line about the file", r->f.text);
    }
    mesh_free(&old);
}

/* `b` was read behind `vertices` and `triangles` that were there. */
static inline int same_mesh(const mesh *a, const mesh *b, size_t vertices, size_t triangles) {
    if (b->vertices - vertices != a->vertices || b->triangles - triangles != a->triangles) {
        return 0;
    }
    int same =
        a->vertices == 0 || memcmp(a->vertex, b->vertex + 3 * vertices, 12 * a->vertices) == 0;
    for (size_t i = 0; i < 3 * a->triangles; i++) {
        same &= a->triangle[i] + vertices == b->triangle[3 * triangles + i];
    }
    return same;
}

/* Reads twice; the mesh in `first` is the caller's. */
static inline void read_twice(reading *first, mesh_reader *reader, const input *in, int repair) {
    reading second;
    read_once(first, reader, in, repair, 0);
    read_once(&second, reader, in, repair, 1);
    promise(first->status == second.status && strcmp(first->f.text, second.f.text) == 0,
            "the second reading says something else", second.f.text);
    promise(mesh_report_same(&first->report, &second.report), "two reports differ", in->path);
    promise(first->status != 0 || same_mesh(&first->m, &second.m, 3, 1),
            "the second reading gives another mesh", in->path);
    mesh_free(&second.m);
}

/* ---- what a mesh is for ------------------------------------------------------------ */

enum { MESH_TARGET_TRIANGLES = 64, MESH_TARGET_VERTICES = 256 }; /* the most that are packed */

static inline const char *mesh_target_trace(plt_engine *e) {
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    const plt_info *info = plt_engine_info(e);
    hostile_rays(rays, info);
    plt_trace(e, rays, hits, HOSTILE_RAYS, 0);
    for (unsigned i = 0; i < HOSTILE_RAYS; i++) {
        if (hits[i].triangle != PLT_MISS &&
            !(hits[i].triangle < info->source_triangles && hits[i].t >= 0.0f)) {
            return "a hit is out of range";
        }
    }
    return NULL;
}

static inline void check_packed(int status, packed *image, const fail *f) {
    const hostile_config config = {0, 0, 2};
    if (status != 0) {
        promise(one_line_about(f->text, "mesh"), "no line about the mesh", f->text);
        return;
    }
    const hostile_result r = hostile_try_by(image->bytes, image->size, config, mesh_target_trace);
    promise(r.status == PLT_OK, "a packed image is refused", r.fault.message);
    promise(r.sentence == NULL, "a packed image", r.sentence);
    pack_free(image);
}

static inline void pack_all(const mesh *m, unsigned choice) {
    packed image;
    lattice_loss loss;
    fail f = {""};
    const pack_options thesis = {.splits = (uint8_t)(choice & 1),
                                 .build = (uint8_t)(choice / 2 % 3),
                                 .leaf_triangles = 1u << choice % 3,
                                 .treelet_nodes = 1 + choice % 64};
    check_packed(pack_mesh(&image, m, &thesis, "mesh", &f), &image, &f);
    const compact_options compact = {
        .splits = (uint8_t)(choice & 1),
        .build = choice % 5 == 4 ? PLT_BUILD_DEVICE : PLT_BUILD_HOST,
        .lattice_bits = (uint8_t)(12 + choice % 10),
        .numbers = choice % 4 < 2,
        .floats = choice % 5 == 3,
        .leaf_triangles = 1u << choice % 3,
    };
    f.text[0] = '\0';
    check_packed(pack_compact(&image, m, &compact, "mesh", &loss, &f), &image, &f);
}

static inline void use_mesh(mesh *m, unsigned choice) {
    if (m->triangles > MESH_TARGET_TRIANGLES || m->vertices > MESH_TARGET_VERTICES) {
        return;
    }
    pack_all(m, choice);
    const size_t most = 1 + m->triangles / 2;
    fail f = {""};
    promise(mesh_reduce(m, most, "mesh", &f) == 0, "a mesh cannot be reduced", f.text);
    promise(m->triangles <= most, "reduction leaves too many triangles", "");
    promise(mesh_holds(m), "reduction loses the invariant", "");
    pack_all(m, choice / 3);
}

/* ---- the target ---------------------------------------------------------------------- */

static inline void check_size(const mesh *m, size_t size) {
    promise(m->vertices <= size && m->triangles <= size, "more than a file can hold", "");
    promise(m->vertex_room <= 2 * size + 64 && m->triangle_room <= 2 * size + 64,
            "more memory than the file asks for", "");
}

/* `members`: what the file names counts too, and its size says nothing. */
static inline void mesh_target_try(mesh_reader *reader, const char *path, const uint8_t *data,
                                   size_t size, int members) {
    input in = {.path = path, .bytes = malloc(size + 1), .size = size};
    reading plain, repaired;
    if (size == 0) { /* input_read refuses it */
        free(in.bytes);
        return;
    }
    memcpy(in.bytes, data, size);
    in.bytes[size] = 0;
    read_twice(&plain, reader, &in, 0);
    read_twice(&repaired, reader, &in, 1);
    promise(memcmp(in.bytes, data, size) == 0 && in.bytes[size] == 0, "the file changed", path);
    if (plain.status == 0) {
        promise(mesh_report_empty(&plain.report), "a repair that was not asked for", path);
        promise(repaired.status == 0, "repair refuses what is read without", repaired.f.text);
        promise(same_mesh(&plain.m, &repaired.m, 0, 0) || !mesh_report_empty(&repaired.report),
                "repair changes a mesh and does not say so", path);
        promise(mesh_report_empty(&repaired.report), "repair where there is nothing to repair",
                path);
    }
    if (!members) {
        check_size(&plain.m, size);
        check_size(&repaired.m, size);
    }
    if (repaired.status == 0) {
        use_mesh(&repaired.m, (unsigned)size);
    }
    mesh_free(&plain.m);
    mesh_free(&repaired.m);
    free(in.bytes);
}

#endif
