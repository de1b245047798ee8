/* mesh_use - what a mesh goes through after it was read, and what is promised of that
 *
 * A small mesh is looked at, moved, welded, reduced and packed, as pack does (precision.h,
 * open_edges.h, weld_near.h, reduce.h, pack.h):
 *
 *   - what precision costs is a finite number; a mesh that can be moved is, and one that
 *     cannot stays as it was;
 *   - welding changes nothing but corners, and a suggested distance does what is said of it;
 *   - reduction leaves 1 to as many triangles as wanted, or fails, changes nothing, and
 *     names a number that it then can leave;
 *   - an image is what its header says, opens and is traced.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_USE_H
#define MESH_USE_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/planelet_config.h"
#include "host_tools/mesh/open_edges.h"
#include "host_tools/mesh/precision.h"
#include "host_tools/mesh/reduce.h"
#include "host_tools/mesh/weld_near.h"
#include "host_tools/pack/pack.h"
#include "tests/hostile/images.h"

/* ---- promises ---------------------------------------------------------------------- */

static inline void promise(int kept, const char *sentence, const char *detail) {
    if (!kept) {
        fprintf(stderr, "%s: %s\n", sentence, detail);
        abort();
    }
}

/* Of a coordinate. False for NaN. */
static inline int wide_holds(double wide, float single) {
    const float narrowed = (float)wide;
    return isfinite(wide) && narrowed >= nextafterf(single, -INFINITY) &&
           narrowed <= nextafterf(single, INFINITY);
}

static inline int mesh_holds(const mesh *m) {
    int holds = m->vertices <= m->vertex_room && m->triangles <= m->triangle_room;
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        holds &= fabsf(m->vertex[i]) <= PLT_COORD_MAX; /* false for NaN */
        holds &= m->wide == NULL || wide_holds(m->wide[i], m->vertex[i]);
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

/* `m` begins with all that `old` holds, the wide coordinates too. */
static inline int same_start(const mesh *m, const mesh *old) {
    int same = m->vertices >= old->vertices && m->triangles >= old->triangles;
    for (size_t i = 0; same && i < 3 * old->vertices; i++) {
        const double x = mesh_wide(m, i / 3, (int)(i % 3)), y = mesh_wide(old, i / 3, (int)(i % 3));
        same = memcmp(&m->vertex[i], &old->vertex[i], sizeof(float)) == 0 &&
               memcmp(&x, &y, sizeof x) == 0;
    }
    return same &&
           (old->triangles == 0 || memcmp(m->triangle, old->triangle, 12 * old->triangles) == 0);
}

static inline int same_whole(const mesh *a, const mesh *b) {
    return a->vertices == b->vertices && a->triangles == b->triangles && same_start(a, b);
}

static inline void *copied(const void *from, size_t bytes) {
    void *to = malloc(bytes + 1);
    promise(to != NULL, "memory for a copy", "");
    if (bytes > 0) {
        memcpy(to, from, bytes);
    }
    return to;
}

static inline mesh mesh_copy(const mesh *m) {
    return (mesh){
        .vertex = copied(m->vertex, 12 * m->vertices),
        .wide = m->wide != NULL ? copied(m->wide, 24 * m->vertices) : NULL,
        .triangle = copied(m->triangle, 12 * m->triangles),
        .vertices = m->vertices,
        .triangles = m->triangles,
        .vertex_room = m->vertices,
        .triangle_room = m->triangles,
    };
}

/* ---- precision -------------------------------------------------------------------- */

static inline void check_precision(const mesh *m, const double origin[3]) {
    const precision p = precision_of(m, 0, m->triangles, origin);
    promise(p.moved >= 0 && isfinite(p.moved) && p.relative >= 0 && isfinite(p.relative),
            "a move that is no number", "");
    promise(p.vanished <= m->triangles, "more triangles vanish than there are", "");
}

/* Moves a copy; `reaches`: it must come out. */
static inline void try_origin(const mesh *m, const double origin[3], int reaches) {
    mesh moved = mesh_copy(m);
    fail f = {""};
    const int finite = isfinite(origin[0]) && isfinite(origin[1]) && isfinite(origin[2]);
    if (finite && fabs(origin[0]) + fabs(origin[1]) + fabs(origin[2]) < 1e18) {
        check_precision(m, origin);
    }
    if (precision_settle(&moved, origin, "mesh", &f) == 0) {
        promise(moved.wide == NULL && mesh_holds(&moved), "moving loses the invariant", "");
        promise(moved.vertices == m->vertices && moved.triangles == m->triangles, "moving loses",
                "");
    } else {
        promise(!reaches, "a mesh cannot be moved", f.text);
        promise(one_line_about(f.text, "mesh"), "no line about the mesh", f.text);
        promise(same_whole(&moved, m), "a move that fails moves something", f.text);
    }
    mesh_free(&moved);
}

/* Leaves the mesh moved to an origin that it can be moved to. */
static inline void settle_mesh(mesh *m, unsigned choice) {
    static const double ODD[][3] = {{0.1, -1e-40, 7e5},        {-1099511627776.0, 0, 0},
                                    {1099511627776.0, 1, 0.5}, {1e300, -1e300, 0},
                                    {(double)NAN, 0, 0},       {0, HUGE_VAL, 0},
                                    {4.9e-324, 0, -0.0},       {16777217, 16777217, 16777217}};
    static const double NOWHERE[3] = {0, 0, 0};
    double centre[3];
    fail f = {""};
    precision_centre(m, centre);
    for (int axis = 0; axis < 3; axis++) {
        promise(fabs(centre[axis]) <= 1.0000002 * (double)PLT_COORD_MAX, "a centre far off", "");
    }
    try_origin(m, NOWHERE, 1);
    try_origin(m, centre, 0);
    try_origin(m, ODD[choice % 8], 0);
    if (choice / 8 % 2 == 0 || precision_settle(m, centre, "mesh", &f) != 0) {
        promise(precision_settle(m, NOWHERE, "mesh", &f) == 0, "a mesh cannot stay", f.text);
    }
}

/* ---- seams ------------------------------------------------------------------------- */

static inline uint64_t count_open(const mesh *m) {
    open_edges o;
    promise(open_edges_find(&o, m, 0, m->triangles) == 0, "memory for edges", "");
    promise(o.count <= 3 * m->triangles, "more open edges than edges", "");
    for (size_t i = 0; i < o.ends; i++) {
        promise(o.end[i] < m->vertices, "an edge of no vertex", "");
    }
    const uint64_t count = o.count;
    open_edges_free(&o);
    return count;
}

/* Welds a copy: how many edges are then open. */
static inline uint64_t open_after(const mesh *m, double distance, weld_near_result *result) {
    mesh welded = mesh_copy(m);
    promise(weld_near(&welded, 0, m->triangles, distance, result) == 0, "memory to weld", "");
    promise(mesh_holds(&welded) && welded.vertices == m->vertices, "welding loses", "");
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        promise(memcmp(&welded.vertex[i], &m->vertex[i], 4) == 0, "welding moves vertices", "");
    }
    promise(result->moved < m->vertices + 1 && result->collapsed <= m->triangles,
            "welding counts too much", "");
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        const float *p = m->vertex + 3 * (size_t)m->triangle[i];
        const float *q = m->vertex + 3 * (size_t)welded.triangle[i];
        double far2 = 0;
        for (int axis = 0; axis < 3; axis++) {
            far2 += ((double)p[axis] - (double)q[axis]) * ((double)p[axis] - (double)q[axis]);
        }
        promise(sqrt(far2) <= distance, "a corner goes further than was wished", "");
    }
    const uint64_t open = count_open(&welded);
    mesh_free(&welded);
    return open;
}

static inline void check_suggestion(const mesh *m) {
    open_edges o;
    double distance = -1;
    uint64_t left = 0;
    promise(open_edges_find(&o, m, 0, m->triangles) == 0, "memory for edges", "");
    promise(weld_near_suggest(m, 0, m->triangles, &o, &distance, &left) == 0, "memory", "");
    promise(distance >= 0 && isfinite(distance), "a distance that is none", "");
    promise(distance > 0 ? left < o.count : left == o.count, "a suggestion that closes none", "");
    if (distance > 0) {
        char text[40];
        weld_near_result result;
        snprintf(text, sizeof text, "%.0e", distance); /* as pack says it */
        promise(open_after(m, strtod(text, NULL), &result) == left, "other edges stay open", text);
        promise(result.collapsed == 0, "a suggestion that takes an area", text);
    }
    open_edges_free(&o);
}

static inline void weld_all(const mesh *m, unsigned choice) {
    static const double DISTANCE[] = {1e-30, 1e-6, 1e-3, 0.5, 3, 1e9, 1e30, 4.9e-324, 1e308};
    weld_near_result result;
    check_suggestion(m);
    open_after(m, DISTANCE[choice % 9], &result);
    open_after(m, DISTANCE[choice / 9 % 9], &result);
}

/* ---- reduction ------------------------------------------------------------------------- */

/* What a failure says can be left; 0: nothing. */
static inline size_t remedy_of(const fail *f) {
    static const char use[] = "use --reduce ";
    const char *at = strstr(f->text, use);
    return at != NULL ? (size_t)strtoull(at + sizeof use - 1, NULL, 10) : 0;
}

/* Reduces a copy, which is the caller's. */
static inline mesh reduced(const mesh *m, size_t most, int must) {
    mesh to = mesh_copy(m);
    fail f = {""};
    if (mesh_reduce(&to, most, "mesh", &f) == 0) {
        promise(to.triangles <= most && mesh_holds(&to), "reduction leaves another mesh", "");
        promise(to.triangles > 0 || m->triangles == 0, "reduction leaves nothing", "");
        return to;
    }
    promise(!must, "reduction does not do what it says", f.text);
    promise(one_line_about(f.text, "mesh"), "no line about the mesh", f.text);
    promise(same_whole(&to, m), "a reduction that fails changes something", f.text);
    const size_t least = remedy_of(&f);
    mesh_free(&to);
    return least > 0 ? reduced(m, least, 1) : mesh_copy(m);
}

/* ---- images ------------------------------------------------------------------------------ */

static inline const char *mesh_use_trace(plt_engine *e) {
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

static inline void check_info(const packed *image) {
    const plt_source source = {image->bytes, image->size, NULL, NULL, NULL};
    plt_info info;
    plt_fault fault = {0, 0, 0, 0, NULL};
    promise(plt_image_info(&source, &info, &fault) == PLT_OK, "no info", fault.message);
    promise(info.triangles == image->info.triangles &&
                info.source_triangles == image->info.source_triangles,
            "an image says something else", "");
}

static inline void check_packed(int status, packed *image, const fail *f) {
    const hostile_config config = {0, 0, 2, 0};
    if (status != 0) {
        promise(one_line_about(f->text, "mesh"), "no line about the mesh", f->text);
        return;
    }
    check_info(image);
    const hostile_result r = hostile_try_by(image->bytes, image->size, config, mesh_use_trace);
    promise(r.status == PLT_OK, "a packed image is refused", r.fault.message);
    promise(r.sentence == NULL, "a packed image", r.sentence);
    pack_free(image);
}

static inline void pack_one_compact(const mesh *m, const compact_options *options) {
    packed image;
    lattice_loss loss;
    fail f = {""};
    check_packed(pack_compact(&image, m, options, "mesh", &loss, &f), &image, &f);
    promise(loss.largest_move >= 0 && isfinite(loss.largest_move), "a loss that is no number", "");
    promise(loss.vertices <= m->vertices && loss.unmoved <= loss.vertices &&
                loss.flat_before + loss.flat_now <= m->triangles,
            "a loss of more than there is", "");
}

static inline void pack_all(const mesh *m, unsigned choice) {
    static const double TOLERANCE[] = {0, 1e-3, 0, 1e-6};
    const size_t ends[] = {m->triangles / 2, m->triangles};
    packed image;
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
        .mesh_end = choice / 7 % 2 ? ends : NULL,
        .meshes = choice / 7 % 2 ? 2 : 1,
        .power = (uint8_t)(choice / 11 % 2),
        .tolerance = choice % 5 == 3 ? 0 : TOLERANCE[choice / 13 % 4],
    };
    pack_one_compact(m, &compact);
}

/* ---- all of it ------------------------------------------------------------------------- */

enum { MESH_USE_TRIANGLES = 64, MESH_USE_VERTICES = 256 }; /* the most that are packed */

/* Leaves the mesh settled. */
static inline void mesh_use(mesh *m, unsigned choice) {
    if (m->triangles > MESH_USE_TRIANGLES || m->vertices > MESH_USE_VERTICES) {
        return;
    }
    settle_mesh(m, choice);
    weld_all(m, choice / 16);
    const size_t most[] = {1, 2, 1 + m->triangles / 2};
    mesh fewer = reduced(m, most[choice / 2 % 3], 0);
    pack_all(choice % 2 ? m : &fewer, choice / 2);
    mesh_free(&fewer);
}

#endif
