/* ply - reads the Polygon File Format: ASCII and binary, either order
 *
 * Elements and properties may stand in any order; what is not x, y, z, a normal, colour or texture
 * coordinates that someone wants, or a vertex list of `face` or `tristrips` is passed over, and
 * counted if it would be drawn. Texture coordinates are by vertex, or in a list of a face's
 * corners.
 *
 * Keeps: each pass of a loop over a count from the file consumes at least one
 * byte or fails.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/ply_attributes.h"
#include "host_tools/mesh/ply_body.h"
#include "host_tools/mesh/ply_corners.h"
#include "host_tools/mesh/ply_value.h"
#include "host_tools/mesh/readers.h"

/* A face: corner i names the texture coordinates that are number first_texcoord + i, if the face
 * has a list of them, wherever in the face that stands. */
typedef struct face {
    chain corners;
    int has_texcoords;
    int64_t first_texcoord;
    uint64_t texcoords; /* read */
} face;

static int read_corners(ply_reader *r, const ply_property *p, face *f) {
    uint64_t count;
    if (ply_count(r, p, &count) != 0) {
        return -1;
    }
    for (uint64_t i = 0; i < count; i++) {
        int64_t vertex;
        if (f->has_texcoords) {
            intake_name(&r->in, NAMED_TEXCOORD, f->first_texcoord + (int64_t)i);
        }
        if (ply_integer(r, p->type, &vertex) != 0 ||
            intake_corner(&r->in, &f->corners, vertex, vertex) != 0) {
            return -1;
        }
    }
    return f->corners.is_strip ? 0 : intake_polygon_end(&r->in, &f->corners);
}

static const ply_property *find_property(const ply_element *e, const char *name, int is_list) {
    for (size_t i = 0; i < e->properties; i++) {
        if (e->property[i].is_list == is_list && word_is(e->property[i].name, name)) {
            return &e->property[i];
        }
    }
    return NULL;
}

static const ply_property *find_corners(const ply_element *e) {
    const ply_property *p = find_property(e, "vertex_indices", 1);
    return p ? p : find_property(e, "vertex_index", 1);
}

/* What an element is for. */
typedef struct role {
    enum { SKIP, VERTEX, FACE, STRIP } kind;
    ply_triple axis, normal, colour, texcoord; /* of vertices; all but the first if wanted */
    const ply_property *corners, *texcoords;
} role;

static int read_part(ply_reader *r, const ply_property *p, double *value) {
    real number;
    if (ply_coordinate(r, p->type, &number) != 0) {
        return -1;
    }
    *value = number.wide;
    return 0;
}

/* What a vertex has, as far as it is wanted. */
typedef struct vertex {
    real position[4];
    double normal[4], colour[4], texcoord[4];
} vertex;

static int add_vertex(ply_reader *r, const role *what, const vertex *v) {
    const ply_property *red = what->colour.property[0];
    if (intake_vertex(&r->in, v->position) != 0 ||
        (what->normal.property[0] != NULL && intake_normal(&r->in, v->normal) != 0) ||
        (what->texcoord.property[0] != NULL && intake_texcoord(&r->in, v->texcoord) != 0)) {
        return -1;
    }
    return red == NULL ? 0 : intake_colour(&r->in, v->colour, ply_colour_most(red->type));
}

static int read_property(ply_reader *r, const role *what, const ply_property *p, vertex *v) {
    const unsigned k = ply_triple_part(&what->axis, p);
    const unsigned n = ply_triple_part(&what->normal, p);
    const unsigned c = ply_triple_part(&what->colour, p);
    const unsigned t = ply_triple_part(&what->texcoord, p);
    return k < 3   ? ply_coordinate(r, p->type, &v->position[k])
           : n < 3 ? read_part(r, p, &v->normal[n])
           : c < 3 ? read_part(r, p, &v->colour[c])
           : t < 2 ? read_part(r, p, &v->texcoord[t])
                   : ply_skip(r, p);
}

static int read_vertex(ply_reader *r, const ply_element *e, const role *what) {
    vertex v = {.normal = {0}};
    size_t line = 0;
    for (size_t i = 0; i < e->properties; i++) {
        if (read_property(r, what, &e->property[i], &v) != 0) {
            return -1;
        }
        line = i == 0 ? r->data.line : line;
    }
    if (line != r->data.line) {
        r->short_line = r->short_vertices++ == 0 ? line : r->short_line;
    }
    return add_vertex(r, what, &v);
}

/* Two for each corner. */
static int read_texcoords(ply_reader *r, const ply_property *p, face *f) {
    uint64_t count;
    double texcoord[2] = {0, 0};
    if (ply_count(r, p, &count) != 0) {
        return -1;
    }
    for (uint64_t i = 0; i < count; i++) {
        if (read_part(r, p, &texcoord[i % 2]) != 0 ||
            (i % 2 == 1 && intake_texcoord(&r->in, texcoord) != 0)) {
            return -1;
        }
    }
    f->texcoords = count;
    return 0;
}

/* An empty list says that its corners have none. */
static int end_texcoords(ply_reader *r, const face *f) {
    const uint64_t due = 2 * f->corners.corners;
    if (f->texcoords != due && f->texcoords != 0 && !r->in.report->repair) {
        return intake_fail(&r->in,
                           "%llu numbers in its list texcoord, where its corners need %llu; "
                           "correct it, or use pack --repair to do without it",
                           (unsigned long long)f->texcoords, (unsigned long long)due);
    }
    for (uint64_t i = f->texcoords / 2; i < due / 2; i++) {
        if (intake_no_texcoord(&r->in) != 0) {
            return -1;
        }
    }
    return 0;
}

static int read_face(ply_reader *r, const ply_element *e, const role *what) {
    face f = {.corners = intake_chain(&r->in, what->kind == STRIP),
              .has_texcoords = what->texcoords != NULL,
              .first_texcoord = (int64_t)r->in.corners.texcoord[0].count};
    for (size_t i = 0; i < e->properties; i++) {
        const ply_property *p = &e->property[i];
        const int status = p == what->corners     ? read_corners(r, p, &f)
                           : p == what->texcoords ? read_texcoords(r, p, &f)
                                                  : ply_skip(r, p);
        if (status != 0) {
            return -1;
        }
    }
    return f.has_texcoords ? end_texcoords(r, &f) : 0;
}

static int skip_element(ply_reader *r, const ply_element *e) {
    for (size_t i = 0; i < e->properties; i++) {
        if (ply_skip(r, &e->property[i]) != 0) {
            return -1;
        }
    }
    return 0;
}

static int element_done(ply_reader *r) {
    if (r->header->format != PLY_ASCII || scan_line_done(&r->data)) {
        return 0;
    }
    if (r->short_vertices > 0) { /* a value that a line lacks: nothing behind is where it seems */
        r->in.at = (location){.line = r->short_line};
        return intake_fail(&r->in,
                           "fewer values than the header declares for a vertex; "
                           "correct the header or the lines");
    }
    return intake_fail(&r->in,
                       "more values on the line than the header declares; "
                       "correct the line or the header");
}

/* Corners that have their own need none of vertices. */
static int has_texcoord_lists(const ply_header *h) {
    for (size_t i = 0; i < h->elements; i++) {
        const ply_element *e = &h->element[i];
        if (word_is(e->name, "face") && e->count > 0 && ply_find_texcoord_list(e) != NULL) {
            return 1;
        }
    }
    return 0;
}

static int find_vertex_role(role *what, const ply_reader *r, const ply_element *e, const input *in,
                            fail *f) {
    const ply_property **axis = what->axis.property;
    what->kind = VERTEX;
    axis[0] = find_property(e, "x", 0);
    axis[1] = find_property(e, "y", 0);
    axis[2] = find_property(e, "z", 0);
    if (!axis[0] || !axis[1] || !axis[2]) {
        return fail_set(f, in->path, "line %zu: the vertices lack x, y or z; add them", e->line);
    }
    if (intake_wants_normals(&r->in)) {
        what->normal = ply_find_normal(e);
    }
    if (intake_wants_colours(&r->in)) {
        what->colour = ply_find_colour(e);
    }
    if (intake_wants_texcoords(&r->in) && !has_texcoord_lists(r->header)) {
        what->texcoord = ply_find_texcoord(e);
    }
    return 0;
}

static int find_role(role *what, const ply_reader *r, const ply_element *e, const input *in,
                     fail *f) {
    *what = (role){.kind = SKIP};
    if (word_is(e->name, "vertex")) {
        return find_vertex_role(what, r, e, in, f);
    }
    if (word_is(e->name, "face") || word_is(e->name, "tristrips")) {
        what->kind = word_is(e->name, "face") ? FACE : STRIP;
        what->corners = find_corners(e);
        if (!what->corners) {
            return fail_set(f, in->path, "line %zu: '%.*s' has no list vertex_indices; rename one",
                            e->line, WORD_SHOWN(e->name));
        }
        what->texcoords =
            what->kind == FACE && intake_wants_texcoords(&r->in) ? ply_find_texcoord_list(e) : NULL;
    }
    return 0;
}

static int read_one(ply_reader *r, const ply_element *e, const role *what) {
    switch (what->kind) {
    case VERTEX:
        return read_vertex(r, e, what);
    case FACE:
    case STRIP:
        return read_face(r, e, what);
    default:
        return skip_element(r, e);
    }
}

/* All that is there, but for what is kept. */
static void count_left_out(ply_reader *r, const ply_element *e, const role *what) {
    const uint64_t normals = r->in.count[REPORT_NORMALS], colours = r->in.count[REPORT_COLOURS];
    const uint64_t textures = r->in.count[REPORT_TEXTURES];
    ply_count_attributes(e, r->in.count);
    if (what->normal.property[0] != NULL) {
        r->in.count[REPORT_NORMALS] = normals;
    }
    if (what->colour.property[0] != NULL) {
        r->in.count[REPORT_COLOURS] = colours;
    }
    if (what->texcoord.property[0] != NULL || what->texcoords != NULL) {
        r->in.count[REPORT_TEXTURES] = textures;
    }
}

/* Elements without properties have no bytes and no meaning. */
static int read_element(ply_reader *r, const ply_element *e, const input *in) {
    static const char *const NAMES[] = {"element", "vertex", "face", "strip"};
    role what;
    if (e->count == 0 || e->properties == 0) {
        return 0;
    }
    if (find_role(&what, r, e, in, r->in.f) != 0) {
        return -1;
    }
    count_left_out(r, e, &what);
    r->in.at = (location){.what = NAMES[what.kind]};
    for (uint64_t i = 0; i < e->count; i++) {
        r->in.at.number = i;
        r->in.at.byte = (size_t)(r->data.at - r->bytes);
        r->in.at.line = r->header->format == PLY_ASCII ? r->data.line : 0;
        if (read_one(r, e, &what) != 0 || element_done(r) != 0) {
            return -1;
        }
    }
    return 0;
}

/* What follows the last element is of no use; line ends are not worth a word. */
static void count_loose_bytes(ply_reader *r) {
    int is_loose = 0;
    while (r->header->format == PLY_ASCII && scan_line_done(&r->data) && scan_next_line(&r->data)) {
    }
    for (const unsigned char *c = r->data.at; c < r->data.end; c++) {
        is_loose |= *c != '\n' && *c != '\r';
    }
    r->in.count[REPORT_LOOSE_BYTES] += is_loose ? (uint64_t)(r->data.end - r->data.at) : 0;
}

/* Room for what the header announces; its counts were checked against the file size. */
static int make_room(ply_reader *r) {
    uint64_t faces = 0;
    r->in.declared = 0;
    for (size_t i = 0; i < r->header->elements; i++) {
        const ply_element *e = &r->header->element[i];
        if (e->properties > 0 && word_is(e->name, "vertex")) {
            r->in.declared = e->count;
        } else if (e->properties > 0 && word_is(e->name, "face")) {
            faces = e->count;
        }
    }
    fail inner = {{0}};
    if (mesh_reserve(r->in.m, (size_t)r->in.declared, (size_t)faces, &inner) != 0) {
        return fail_set(r->in.f, r->in.path, "%s", inner.text);
    }
    return 0;
}

static int read_data(ply_reader *r, const input *in) {
    if (make_room(r) != 0) {
        return -1;
    }
    for (size_t i = 0; i < r->header->elements; i++) {
        if (read_element(r, &r->header->element[i], in) != 0) {
            return -1;
        }
    }
    count_loose_bytes(r);
    return 0;
}

/* A body of other types than the header's shows in faces that make no sense. */
static int read_body(ply_reader *r, const input *in, fail *f) {
    fail inner = {{0}};
    r->in.f = &inner;
    const int status = read_data(r, in);
    r->in.f = f;
    if ((status != 0 || r->in.count[REPORT_LOOSE_BYTES] > 0) &&
        ply_body_check(r->header, in, f) != 0) {
        return -1;
    }
    return status == 0 ? 0 : fail_set(f, NULL, "%s", inner.text);
}

int ply_is(const input *in) {
    return in->size >= 4 && memcmp(in->bytes, "ply", 3) == 0 &&
           (in->bytes[3] == '\n' || in->bytes[3] == '\r' || in->bytes[3] == ' ');
}

int ply_read(mesh *m, const input *in, mesh_report *report, fail *f) {
    ply_header *header = heap_get(sizeof *header);
    if (!header) {
        return fail_set(f, in->path, "out of memory; close other programs");
    }
    int result = ply_header_read(header, in, f);
    if (result == 0) {
        ply_reader r = {.header = header, .bytes = in->bytes, .data = header->data};
        r.in = intake_begin(m, in->path, report, f);
        r.in.count[REPORT_UNKNOWN_LINES] = header->unknown_lines;
        result = read_body(&r, in, f);
        if (result == 0) {
            result = intake_finish(&r.in);
        } else {
            intake_undo(&r.in);
        }
    }
    heap_drop(header);
    return result;
}
