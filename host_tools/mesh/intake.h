/* intake - where every reader's vertices and faces are checked, once
 *
 * A reader sets `at` to the element it reads, hands in vertices and corners as
 * the file has them, and ends with `intake_finish` or with `intake_undo`, after
 * which the mesh is as it was.
 *
 * SPDX-License-Identifier: MIT */
#ifndef INTAKE_H
#define INTAKE_H
#include "host_tools/mesh/faces.h"
#include "host_tools/mesh/intake_corners.h"

#define INTAKE_UNKNOWN UINT64_MAX
#define INTAKE_MISSING INT64_MIN

typedef struct location {
    size_t line;      /* 0: a binary file, `byte` counts */
    size_t byte;      /* offset of the element */
    const char *what; /* "vertex", "face"; NULL: the line says enough */
    uint64_t number;  /* of the element, from 0 */
} location;

typedef struct intake {
    mesh *m;
    const char *path;
    mesh_report *report;          /* added to when the file is whole */
    uint64_t count[REPORT_ITEMS]; /* of this file */
    fail *f;
    location at;
    uint64_t declared; /* vertices in the file; INTAKE_UNKNOWN until the end */
    mesh_faces unresolved;
    int64_t furthest, furthest_written; /* greatest index not yet there */
    location furthest_at;
    intake_corners corners;               /* if m->corners wants them */
    uint32_t named[CORNER_NAMES];         /* of the next corner; CORNER_UNNAMED */
    int64_t furthest_named[CORNER_NAMES]; /* greatest number named; -1: none is */
    location furthest_named_at[CORNER_NAMES];
} intake;

/* A polygon or a triangle strip being read. */
typedef struct chain {
    uint32_t first, before, last;
    uint32_t named_first[CORNER_NAMES], named_last[CORNER_NAMES]; /* of those; strips name none */
    uint64_t corners;
    size_t first_triangle;
    int is_strip;
} chain;

intake intake_begin(mesh *m, const char *path, mesh_report *report, fail *f);
int intake_vertex(intake *in, const real position[3]);
size_t intake_vertices(const intake *in); /* of this file, so far */

chain intake_chain(const intake *in, int is_strip);
/* `vertex` counts from 0 (INTAKE_MISSING: cannot exist), `written` is what
 * the file says, for the failure. */
int intake_corner(intake *in, chain *c, int64_t vertex, int64_t written);
/* Faces of one and two corners are points and lines: left out and counted. */
int intake_polygon_end(intake *in, const chain *c);

/* Whether normals, colours of vertices, or texture coordinates are to be handed in. */
int intake_wants_normals(const intake *in);
int intake_wants_colours(const intake *in);
int intake_wants_texcoords(const intake *in);

/* A normal of any length, the next one of the file; or a colour of 0 to `most` each, of the vertex
 * handed in last. Others are refused, or with `repair` left out and counted. */
int intake_normal(intake *in, const double normal[3]);
int intake_colour(intake *in, const double colour[3], double most);
/* u and v, the next ones of the file; likewise. */
int intake_texcoord(intake *in, const double texcoord[2]);
/* The next ones are none, which nobody misses. */
int intake_no_texcoord(intake *in);
/* The next corner names a normal or texture coordinates (NAMED_), counted from 0; they may come
 * later. */
void intake_name(intake *in, int kind, int64_t number);
/* It names what the file writes as `written`: from 1 on, or less than 0, back from the last one so
 * far. */
int intake_name_written(intake *in, int kind, int64_t written);

int intake_finish(intake *in);
void intake_undo(intake *in);

/* "FILE: LOCATION: " and the formatted rest; returns -1. */
int intake_fail(intake *in, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
