/* faces - see faces.h
 *
 * A fan of the corners 0 .. n - 1 holds them all: (0, 1, 2), (0, 2, 3) and so on. It is
 * where a face waits until all vertices of the file are known.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/faces.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/polygon.h"

typedef struct outline {
    uint32_t *vertex;              /* of each corner, of the file; owned */
    uint32_t *named[CORNER_NAMES]; /* of each corner, what mesh_faces has of it; owned */
    double (*corner)[3];           /* where they are; owned */
    uint32_t *triangle;            /* 3 corners each; owned */
    uint32_t corners, room;
    polygon scratch;
} outline;

int faces_add_fan(mesh_faces *f, size_t first, uint32_t corners) {
    if (f->fans == f->room) {
        const size_t room = f->room * 2 + 16;
        face_fan *fan = heap_resize(f->fan, (uint64_t)room * sizeof *fan);
        if (!fan) {
            return -1;
        }
        f->fan = fan;
        f->room = room;
    }
    f->fan[f->fans++] = (face_fan){first, corners};
    return 0;
}

int faces_mark_bad(mesh_faces *f, size_t vertex) {
    const size_t byte = vertex / 8;
    if (byte >= f->bad_bytes) {
        const size_t bytes = byte * 2 + 64;
        unsigned char *bad = heap_resize(f->bad, bytes);
        if (!bad) {
            return -1;
        }
        memset(bad + f->bad_bytes, 0, bytes - f->bad_bytes);
        f->bad = bad;
        f->bad_bytes = bytes;
    }
    f->bad[byte] |= (unsigned char)(1u << vertex % 8);
    return 0;
}

void faces_free(mesh_faces *f) {
    heap_drop(f->bad); /* not `named`, which is the intake's */
    heap_drop(f->fan);
    *f = (mesh_faces){0};
}

/* ---- resolving ------------------------------------------------------------------------------- */

typedef struct resolving {
    const mesh_faces *f;
    mesh *m;
    uint64_t *count;
    outline o;
    size_t kept; /* where the next triangle goes */
} resolving;

static int is_bad(const mesh_faces *f, uint32_t vertex) {
    return vertex / 8 < f->bad_bytes && (f->bad[vertex / 8] >> vertex % 8 & 1);
}

static int are_good(const resolving *r, const uint32_t *vertex, size_t corners) {
    const size_t count = r->m->vertices - r->f->first_vertex;
    for (size_t k = 0; k < corners; k++) {
        if (vertex[k] >= count || is_bad(r->f, vertex[k])) {
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
    uint32_t *vertex = heap_resize(o->vertex, (uint64_t)room * sizeof *vertex);
    o->vertex = vertex ? vertex : o->vertex;
    double(*corner)[3] = heap_resize(o->corner, (uint64_t)room * sizeof *corner);
    o->corner = corner ? corner : o->corner;
    int has_names = 1;
    for (int k = 0; k < CORNER_NAMES; k++) {
        uint32_t *named = heap_resize(o->named[k], (uint64_t)room * sizeof *named);
        o->named[k] = named ? named : o->named[k];
        has_names &= named != NULL;
    }
    uint32_t *triangle = heap_resize(o->triangle, 3 * (uint64_t)room * sizeof *triangle);
    o->triangle = triangle ? triangle : o->triangle;
    if (!vertex || !corner || !has_names || !triangle) {
        return -1;
    }
    o->room = (uint32_t)(room < UINT32_MAX ? room : UINT32_MAX);
    return 0;
}

/* The corners of the face whose fan it is. */
static void unfold(const uint32_t *triangle, uint32_t corners, uint32_t *to) {
    to[0] = triangle[0];
    to[1] = triangle[1];
    for (uint32_t k = 2; k < corners; k++) {
        to[k] = triangle[3 * (size_t)(k - 2) + 2];
    }
}

static void unfold_fan(resolving *r, const face_fan *fan) {
    const size_t first = r->f->first_triangle;
    r->o.corners = fan->corners;
    unfold(r->m->triangle + 3 * fan->first, fan->corners, r->o.vertex);
    for (int k = 0; k < CORNER_NAMES; k++) {
        if (r->f->named[k]) {
            unfold(r->f->named[k] + 3 * (fan->first - first), fan->corners, r->o.named[k]);
        }
    }
}

/* Those of a face's triangles, of which none goes further back than it came from. */
static void take_materials(const resolving *r, size_t from, size_t count) {
    uint16_t *of = r->m->materials != NULL ? r->m->materials->of : NULL;
    for (size_t i = 0; i < count && of != NULL && from < r->m->materials->filled; i++) {
        of[r->kept + i] = of[from];
    }
}

/* Corner `corner` of the next triangle names what is in from[kind][at]. */
static void take_names(const resolving *r, size_t corner, uint32_t *const from[CORNER_NAMES],
                       size_t at) {
    for (int k = 0; k < CORNER_NAMES; k++) {
        if (r->f->named[k]) {
            r->f->named[k][3 * (r->kept - r->f->first_triangle) + corner] = from[k][at];
        }
    }
}

static int fill(resolving *r, size_t from) {
    outline *o = &r->o;
    const uint32_t base = (uint32_t)r->f->first_vertex;
    for (uint32_t k = 0; k < o->corners; k++) {
        for (int axis = 0; axis < 3; axis++) {
            o->corner[k][axis] = mesh_wide(r->m, (size_t)base + o->vertex[k], axis);
        }
    }
    const int kind =
        polygon_triangulate(&o->scratch, (const double(*)[3])o->corner, o->corners, o->triangle);
    if (kind == POLYGON_NO_MEMORY) {
        return -1;
    }
    r->count[REPORT_OVERLAPPING] += kind == POLYGON_OVERLAPS;
    for (size_t i = 0; i < 3 * ((size_t)o->corners - 2); i++) {
        r->m->triangle[3 * r->kept + i] = base + o->vertex[o->triangle[i]];
        take_names(r, i, o->named, o->triangle[i]);
    }
    take_materials(r, from, o->corners - 2);
    r->kept += o->corners - 2;
    return 0;
}

static void resolve_triangle(resolving *r, size_t from) {
    const uint32_t *t = r->m->triangle + 3 * from;
    if (!are_good(r, t, 3)) {
        r->count[REPORT_BAD_FACES]++;
        return;
    }
    for (size_t k = 0; k < 3; k++) {
        r->m->triangle[3 * r->kept + k] = t[k] + (uint32_t)r->f->first_vertex;
        take_names(r, k, r->f->named, 3 * (from - r->f->first_triangle) + k);
    }
    take_materials(r, from, 1);
    r->kept++;
}

static int resolve_fan(resolving *r, const face_fan *fan) {
    if (make_room(&r->o, fan->corners) != 0) {
        return -1;
    }
    unfold_fan(r, fan);
    if (!are_good(r, r->o.vertex, r->o.corners)) {
        r->count[REPORT_BAD_FACES]++;
        return 0;
    }
    return fill(r, fan->first);
}

int faces_resolve(const mesh_faces *f, mesh *m, uint64_t count[REPORT_ITEMS]) {
    resolving r = {.f = f, .m = m, .count = count, .kept = f->first_triangle};
    size_t next = 0;
    int status = 0;
    for (size_t i = f->first_triangle; i < m->triangles && status == 0;) {
        if (next < f->fans && f->fan[next].first == i) {
            i += f->fan[next].corners - 2;
            status = resolve_fan(&r, &f->fan[next++]);
        } else {
            resolve_triangle(&r, i++);
        }
    }
    if (status == 0) {
        m->triangles = r.kept;
    }
    polygon_free(&r.o.scratch);
    heap_drop(r.o.vertex);
    for (int k = 0; k < CORNER_NAMES; k++) {
        heap_drop(r.o.named[k]);
    }
    heap_drop(r.o.corner);
    heap_drop(r.o.triangle);
    return status;
}
