/* intake - where every reader's vertices and faces are checked, once
 *
 * Keeps: after `intake_finish` every vertex is finite and within
 * +-PLT_COORD_MAX, every index below the number of vertices, and the
 * triangles stand in the order of the file, degenerate ones included. A face whose corners
 * are not all there is left out whole.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/intake.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/mesh/position.h"

static const uint32_t MISSING = UINT32_MAX; /* a mesh has fewer vertices */

intake intake_begin(mesh *m, const char *path, mesh_report *report, fail *f) {
    return (intake){
        .m = m,
        .path = path,
        .report = report,
        .f = f,
        .declared = INTAKE_UNKNOWN,
        .unresolved = {.first_vertex = m->vertices, .first_triangle = m->triangles},
        .furthest = -1,
        .named = {CORNER_UNNAMED, CORNER_UNNAMED},
        .furthest_named = {-1, -1},
    };
}

static int fail_at(intake *in, const location *at, const char *text) {
    const unsigned long long number = at->number;
    if (at->line && at->what) {
        return fail_set(in->f, in->path, "line %zu, %s %llu: %s", at->line, at->what, number, text);
    }
    if (at->line) {
        return fail_set(in->f, in->path, "line %zu: %s", at->line, text);
    }
    if (at->what) {
        return fail_set(in->f, in->path, "%s %llu at byte %zu: %s", at->what, number, at->byte,
                        text);
    }
    return fail_set(in->f, in->path, "byte %zu: %s", at->byte, text);
}

int intake_fail(intake *in, const char *format, ...) {
    char text[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return fail_at(in, &in->at, text);
}

/* Room for one more vertex and triangle, or a failure with the path. */
static int make_room(intake *in) {
    fail inner;
    inner.text[0] = '\0';
    if (mesh_reserve(in->m, 1, 1, &inner) != 0) {
        return fail_set(in->f, in->path, "%s", inner.text);
    }
    return 0;
}

static int fail_memory(intake *in) {
    return fail_set(in->f, in->path, "out of memory; split the mesh");
}

size_t intake_vertices(const intake *in) {
    return in->m->vertices - in->unresolved.first_vertex;
}

static int is_valid(const real p[3]) {
    return coordinate_is_valid((double)p[0].single) && coordinate_is_valid((double)p[1].single) &&
           coordinate_is_valid((double)p[2].single);
}

int intake_vertex(intake *in, const real p[3]) {
    static const real NOWHERE[3] = {{0, 0}, {0, 0}, {0, 0}};
    mesh *m = in->m;
    if (m->vertices == m->vertex_room && make_room(in) != 0) {
        return -1;
    }
    if (!is_valid(p)) {
        if (!in->report->repair) {
            return intake_fail(in,
                               "the vertex (%g %g %g) is not finite or beyond +-2^40; correct "
                               "it or its unit, or use pack --repair to drop it",
                               (double)p[0].single, (double)p[1].single, (double)p[2].single);
        }
        if (faces_mark_bad(&in->unresolved, intake_vertices(in)) != 0) {
            return fail_memory(in);
        }
        in->count[REPORT_BAD_VERTICES]++;
        p = NOWHERE;
    }
    fail inner = {{0}};
    return mesh_add_real(m, p, &inner) == 0 ? 0 : fail_set(in->f, in->path, "%s", inner.text);
}

static int fail_missing(intake *in, const location *at, int64_t written, uint64_t count) {
    char text[160];
    snprintf(text, sizeof text,
             "uses vertex %lld, which is not among the %llu vertices; "
             "use pack --repair to drop it",
             (long long)written, (unsigned long long)count);
    return fail_at(in, at, text);
}

static void note_furthest(intake *in, int64_t vertex, int64_t written) {
    const size_t here = intake_vertices(in);
    if (vertex >= (int64_t)here && vertex > in->furthest) {
        in->furthest = vertex;
        in->furthest_written = written;
        in->furthest_at = in->at;
    }
}

/* What a triangle's corners name goes beside them. */
static int add_named(intake *in, const chain *c) {
    const size_t at = 3 * (in->m->triangles - in->unresolved.first_triangle);
    int status = 0;
    for (int kind = 0; kind < CORNER_NAMES; kind++) {
        const uint32_t named[3] = {c->named_first[kind], c->named_last[kind], in->named[kind]};
        for (size_t k = 0; k < 3 && in->furthest_named[kind] >= 0 && status == 0; k++) {
            status = corner_list_put(&in->corners.named[kind], at + k, named[k], CORNER_UNNAMED);
        }
    }
    return status;
}

static int add_triangle(intake *in, uint32_t a, uint32_t b, uint32_t c) {
    mesh *m = in->m;
    if (m->triangles == m->triangle_room && make_room(in) != 0) {
        return -1;
    }
    return mesh_add_triangle(m, a, b, c, in->f);
}

static int add_corner(intake *in, chain *c, uint32_t vertex) {
    int result = 0;
    c->corners++;
    if (c->corners == 1) {
        c->first = vertex;
        memcpy(c->named_first, in->named, sizeof c->named_first);
    } else if (c->corners >= 3 && !c->is_strip) {
        if (add_named(in, c) != 0) {
            return fail_memory(in);
        }
        result = add_triangle(in, c->first, c->last, vertex);
    } else if (c->corners >= 3) {
        const int is_flipped = c->corners % 2 == 0;
        result = is_flipped ? add_triangle(in, c->last, c->before, vertex)
                            : add_triangle(in, c->before, c->last, vertex);
    }
    c->before = c->last;
    c->last = vertex;
    memcpy(c->named_last, in->named, sizeof c->named_last);
    return result;
}

chain intake_chain(const intake *in, int is_strip) {
    return (chain){.first_triangle = in->m->triangles, .is_strip = is_strip};
}

int intake_corner(intake *in, chain *c, int64_t vertex, int64_t written) {
    if (c->is_strip && vertex == -1) {
        c->corners = 0;
        return 0;
    }
    uint32_t number = MISSING;
    if (vertex >= 0 && (uint64_t)vertex < in->declared) {
        note_furthest(in, vertex, written);
        number = vertex < MISSING ? (uint32_t)vertex : MISSING;
    } else if (!in->report->repair) {
        const uint64_t here = intake_vertices(in);
        return fail_missing(in, &in->at, written,
                            in->declared == INTAKE_UNKNOWN ? here : in->declared);
    }
    return add_corner(in, c, number);
}

int intake_polygon_end(intake *in, const chain *c) {
    if (c->corners > UINT32_MAX) {
        return intake_fail(in, "a face of more than 2^32 - 1 corners; split it");
    }
    if (c->corners > 3) {
        const uint32_t corners = (uint32_t)c->corners;
        const int status = faces_add_fan(&in->unresolved, c->first_triangle, corners);
        return status == 0 ? 0 : fail_memory(in);
    }
    in->count[REPORT_SMALL_FACES] += c->corners < 3;
    return 0;
}

/* ---- normals, colours and texture coordinates ------------------------------------------------ */

int intake_wants_normals(const intake *in) {
    return in->m->corners && in->m->corners->wants_normals;
}

int intake_wants_colours(const intake *in) {
    return in->m->corners && in->m->corners->wants_colours;
}

int intake_wants_texcoords(const intake *in) {
    return in->m->corners && in->m->corners->wants_texcoords;
}

int intake_normal(intake *in, const double n[3]) {
    const double most = fmax(fabs(n[0]), fmax(fabs(n[1]), fabs(n[2])));
    const int good = isfinite(n[0]) && isfinite(n[1]) && isfinite(n[2]) && most > 0;
    if (!good && !in->report->repair) {
        return intake_fail(in,
                           "the normal (%g %g %g) is not finite or has no length; correct it, or "
                           "use pack --repair to do without it",
                           n[0], n[1], n[2]);
    }
    in->count[REPORT_BAD_NORMALS] += !good;
    const uint32_t item = good ? corner_normal(n) : CORNER_NO_NORMAL;
    return corner_list_put(&in->corners.normal, in->corners.normal.count, item, CORNER_NO_NORMAL) ==
                   0
               ? 0
               : fail_memory(in);
}

int intake_colour(intake *in, const double c[3], double most) {
    int good = 1;
    for (int i = 0; i < 3; i++) {
        good &= c[i] >= 0 && c[i] <= most;
    }
    if (!good && !in->report->repair) {
        return intake_fail(in,
                           "the colour (%g %g %g) is not of 0 to %g each; correct it, or use pack "
                           "--repair to do without it",
                           c[0], c[1], c[2], most);
    }
    in->count[REPORT_BAD_COLOURS] += !good;
    uint32_t part[3] = {0, 0, 0};
    for (int i = 0; i < 3 && good; i++) {
        part[i] = (uint32_t)(c[i] / most * 255 + 0.5);
    }
    const uint32_t item = good ? corner_colour(part[0], part[1], part[2]) : CORNER_NO_COLOUR;
    return corner_list_put(&in->corners.colour, intake_vertices(in) - 1, item, CORNER_NO_COLOUR) ==
                   0
               ? 0
               : fail_memory(in);
}

static int put_texcoord(intake *in, uint32_t u, uint32_t v) {
    corner_list *list = in->corners.texcoord;
    return corner_list_put(&list[0], list[0].count, u, CORNER_NO_TEXCOORD) == 0 &&
                   corner_list_put(&list[1], list[1].count, v, CORNER_NO_TEXCOORD) == 0
               ? 0
               : fail_memory(in);
}

int intake_no_texcoord(intake *in) {
    return put_texcoord(in, CORNER_NO_TEXCOORD, CORNER_NO_TEXCOORD);
}

int intake_texcoord(intake *in, const double t[2]) {
    const int good = fabs(t[0]) <= CORNER_TEXCOORD_MOST && fabs(t[1]) <= CORNER_TEXCOORD_MOST;
    if (!good && !in->report->repair) {
        return intake_fail(in,
                           "the texture coordinates (%g %g) are not finite or beyond +-65536; "
                           "correct them, or use pack --repair to do without them",
                           t[0], t[1]);
    }
    in->count[REPORT_BAD_TEXTURES] += !good;
    return good ? put_texcoord(in, corner_texcoord(t[0]), corner_texcoord(t[1]))
                : intake_no_texcoord(in);
}

/* ---- and corners that name them -------------------------------------------------------------- */

static const char *const NAMES[CORNER_NAMES][2] = {{"normal", "normals"},
                                                   {"texture coordinate", "texture coordinates"}};

static size_t count_of(const intake *in, int kind) {
    return kind == NAMED_NORMAL ? in->corners.normal.count : in->corners.texcoord[0].count;
}

void intake_name(intake *in, int kind, int64_t number) {
    in->named[kind] = number < CORNER_UNNAMED ? (uint32_t)number : CORNER_UNNAMED - 1;
    if (number > in->furthest_named[kind]) {
        in->furthest_named[kind] = number;
        in->furthest_named_at[kind] = in->at;
    }
}

int intake_name_written(intake *in, int kind, int64_t written) {
    const int64_t here = (int64_t)count_of(in, kind);
    if (written != 0 && written >= -here) {
        intake_name(in, kind, written > 0 ? written - 1 : here + written);
        return 0;
    }
    if (in->report->repair) {
        return 0;
    }
    return intake_fail(in,
                       "uses %s %lld, which is not among the %lld %s so far; correct "
                       "it, or use pack --repair to do without it",
                       NAMES[kind][0], (long long)written, (long long)here, NAMES[kind][1]);
}

static int are_names_missing(const intake *in, int kind) {
    return !in->report->repair && in->furthest_named[kind] >= (int64_t)count_of(in, kind);
}

static int fail_name(intake *in, int kind) {
    char text[200];
    snprintf(text, sizeof text,
             "uses %s %lld, which is not among the %zu %s; correct it, or use pack "
             "--repair to do without it",
             NAMES[kind][0], (long long)in->furthest_named[kind] + 1, count_of(in, kind),
             NAMES[kind][1]);
    return fail_at(in, &in->furthest_named_at[kind], text);
}

/* The last faces may name none. */
static int end_names(intake *in, int kind) {
    corner_list *named = &in->corners.named[kind];
    const size_t all = 3 * (in->m->triangles - in->unresolved.first_triangle);
    if (named->count > 0 && named->count < all &&
        corner_list_put(named, all - 1, CORNER_UNNAMED, CORNER_UNNAMED) != 0) {
        return -1;
    }
    in->unresolved.named[kind] = named->count > 0 ? named->item : NULL;
    return 0;
}

/* Triangles become those of the mesh, and what their corners have, too. */
static int resolve(intake *in) {
    const size_t vertex = in->unresolved.first_vertex, triangle = in->unresolved.first_triangle;
    for (int kind = 0; kind < CORNER_NAMES; kind++) {
        if (end_names(in, kind) != 0) {
            return -1;
        }
    }
    return faces_resolve(&in->unresolved, in->m, in->count) == 0
               ? intake_corners_finish(&in->corners, in->m, vertex, triangle)
               : -1;
}

int intake_finish(intake *in) {
    const size_t count = intake_vertices(in);
    int status = 0;
    if (!in->report->repair && in->furthest >= (int64_t)count) {
        status = fail_missing(in, &in->furthest_at, in->furthest_written, count);
    } else if (are_names_missing(in, NAMED_NORMAL)) {
        status = fail_name(in, NAMED_NORMAL);
    } else if (are_names_missing(in, NAMED_TEXCOORD)) {
        status = fail_name(in, NAMED_TEXCOORD);
    } else if (resolve(in) != 0) {
        status = fail_memory(in);
    }
    if (status != 0) {
        intake_undo(in);
        return -1;
    }
    for (int i = 0; i < REPORT_ITEMS; i++) {
        in->report->count[i] += in->count[i];
    }
    faces_free(&in->unresolved);
    intake_corners_free(&in->corners);
    return 0;
}

void intake_undo(intake *in) {
    intake_corners_free(&in->corners);
    in->m->vertices = in->unresolved.first_vertex;
    in->m->triangles = in->unresolved.first_triangle;
    faces_free(&in->unresolved);
}
