/* faces - see faces.h
 *
 * A fan of the corners 0 .. n - 1 holds them all: (0, 1, 2), (0, 2, 3) and so on. It is
 * where a face waits until all vertices of the file are known.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/faces.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/mesh/polygon.h"

typedef struct outline {
    uint32_t *vertex;    /* of each corner, of the file; owned */
    double (*corner)[3]; /* where they are; owned */
    uint32_t *triangle;  /* 3 corners each; owned */
    uint32_t corners, room;
    polygon scratch;
} outline;

static int is_bad(const intake *in, uint32_t vertex) {
    return vertex / 8 < in->bad_bytes && (in->bad[vertex / 8] >> vertex % 8 & 1);
}

static int are_good(const intake *in, const uint32_t *vertex, size_t corners) {
    const size_t count = in->m->vertices - in->first_vertex;
    for (size_t k = 0; k < corners; k++) {
        if (vertex[k] >= count || is_bad(in, vertex[k])) {
            return 0;
        }
    }
    return 1;
}

static int make_room(outline *o, uint32_t corners) {
    if (corners <= o->room) {
        return 0;
    }
    const size_t room = (size_t)corners + corners / 2;
    uint32_t *vertex = realloc(o->vertex, room * sizeof *vertex);
    o->vertex = vertex ? vertex : o->vertex;
    double(*corner)[3] = realloc(o->corner, room * sizeof *corner);
    o->corner = corner ? corner : o->corner;
    uint32_t *triangle = realloc(o->triangle, 3 * room * sizeof *triangle);
    o->triangle = triangle ? triangle : o->triangle;
    if (!vertex || !corner || !triangle) {
        return -1;
    }
    o->room = (uint32_t)(room < UINT32_MAX ? room : UINT32_MAX);
    return 0;
}

/* The corners of the face whose fan begins with triangle `first`. */
static void unfold(outline *o, const mesh *m, const intake_face *face) {
    const uint32_t *fan = m->triangle + 3 * face->first;
    o->corners = face->corners;
    o->vertex[0] = fan[0];
    o->vertex[1] = fan[1];
    for (uint32_t k = 2; k < face->corners; k++) {
        o->vertex[k] = fan[3 * (size_t)(k - 2) + 2];
    }
}

/* Writes the face's triangles from triangle `to` on. */
static int fill(outline *o, intake *in, size_t to) {
    const mesh *m = in->m;
    for (uint32_t k = 0; k < o->corners; k++) {
        for (int axis = 0; axis < 3; axis++) {
            o->corner[k][axis] = mesh_wide(m, in->first_vertex + o->vertex[k], axis);
        }
    }
    const int kind =
        polygon_triangulate(&o->scratch, (const double(*)[3])o->corner, o->corners, o->triangle);
    if (kind == POLYGON_NO_MEMORY) {
        return -1;
    }
    in->count[REPORT_OVERLAPPING] += kind == POLYGON_OVERLAPS;
    for (size_t i = 0; i < 3 * ((size_t)o->corners - 2); i++) {
        m->triangle[3 * to + i] = (uint32_t)in->first_vertex + o->vertex[o->triangle[i]];
    }
    return 0;
}

/* Moves the triangle `from` to `*to`, unless it is dropped. */
static void resolve_triangle(intake *in, size_t from, size_t *to) {
    const uint32_t *t = in->m->triangle + 3 * from;
    if (!are_good(in, t, 3)) {
        in->count[REPORT_BAD_FACES]++;
        return;
    }
    for (size_t k = 0; k < 3; k++) {
        in->m->triangle[3 * *to + k] = t[k] + (uint32_t)in->first_vertex;
    }
    ++*to;
}

static int resolve_face(intake *in, outline *o, const intake_face *face, size_t *to) {
    if (make_room(o, face->corners) != 0) {
        return -1;
    }
    unfold(o, in->m, face);
    if (!are_good(in, o->vertex, o->corners)) {
        in->count[REPORT_BAD_FACES]++;
        return 0;
    }
    const int status = fill(o, in, *to);
    *to += o->corners - 2;
    return status;
}

int faces_resolve(intake *in) {
    outline o = {0};
    mesh *m = in->m;
    size_t kept = in->first_triangle, next = 0;
    int status = 0;
    for (size_t i = in->first_triangle; i < m->triangles && status == 0;) {
        if (next < in->faces && in->face[next].first == i) {
            i += in->face[next].corners - 2;
            status = resolve_face(in, &o, &in->face[next++], &kept);
        } else {
            resolve_triangle(in, i++, &kept);
        }
    }
    polygon_free(&o.scratch);
    free(o.vertex);
    free(o.corner);
    free(o.triangle);
    if (status == 0) {
        m->triangles = kept;
    }
    return status;
}
