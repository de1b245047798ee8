/* intake - where every reader's vertices and faces are checked, once
 *
 * Keeps: after `intake_finish` every vertex is finite and within
 * +-PLT_COORD_MAX, every index below the number of vertices, and the
 * triangles stand in the order of the file, degenerate ones included. A face whose corners
 * are not all there is left out whole.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/intake.h"

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
    } else if (c->corners >= 3 && !c->is_strip) {
        result = add_triangle(in, c->first, c->last, vertex);
    } else if (c->corners >= 3) {
        const int is_flipped = c->corners % 2 == 0;
        result = is_flipped ? add_triangle(in, c->last, c->before, vertex)
                            : add_triangle(in, c->before, c->last, vertex);
    }
    c->before = c->last;
    c->last = vertex;
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

int intake_finish(intake *in) {
    const size_t count = intake_vertices(in);
    int status = 0;
    if (!in->report->repair && in->furthest >= (int64_t)count) {
        status = fail_missing(in, &in->furthest_at, in->furthest_written, count);
    } else if (faces_resolve(&in->unresolved, in->m, in->count) != 0) {
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
    return 0;
}

void intake_undo(intake *in) {
    in->m->vertices = in->unresolved.first_vertex;
    in->m->triangles = in->unresolved.first_triangle;
    faces_free(&in->unresolved);
}
