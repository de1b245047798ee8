/* recipe - a scene put together from meshes, one per line
 *
 *     FILE SIZE X Y Z [ANGLE_X ANGLE_Y]     # comment
 *
 * FILE is relative to the recipe, without blanks; "name_{}.ply*N+START"
 * stands for the frames name_000.ply to name_(N-1).ply, of which frame
 * (frame + START) modulo N is read. `placement.h` says what the numbers do.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/recipe.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/mesh_single.h"
#include "host_tools/mesh/placement.h"
#include "host_tools/mesh/precision.h"
#include "host_tools/mesh/scan.h"

enum { FRAMES_MAX = 1000, FRAME_DIGITS_BYTES = 16 };

typedef struct reader {
    mesh *m;
    const char *path;
    size_t directory_length; /* of `path`, with its slash */
    unsigned frame;
    mesh_report *report;
    scan text;
    fail *f;
} reader;

/* A sequence, or a single file (`frames` 0). */
typedef struct source {
    word name;   /* without the part from '*' */
    size_t hole; /* offset of "{}"; name.length: there is none */
    int64_t frames, start;
} source;

static int fail_line(reader *r, const char *text) {
    return fail_set(r->f, r->path, "line %zu: %s", r->text.line, text);
}

static word part(word w, size_t from, size_t to) {
    return (word){w.text + from, to - from};
}

static size_t find(word w, char c) {
    const char *at = w.length ? memchr(w.text, c, w.length) : NULL;
    return at ? (size_t)(at - w.text) : w.length;
}

static int read_frames(reader *r, word tail, source *s) {
    const size_t plus = find(tail, '+');
    s->start = 0;
    if (word_integer(part(tail, 0, plus), &s->frames) != 0 || s->frames < 1 ||
        s->frames > FRAMES_MAX) {
        return fail_line(r, "'*' needs the number of frames after it; write 1 to 1000");
    }
    if (plus < tail.length &&
        (word_integer(part(tail, plus + 1, tail.length), &s->start) != 0 || s->start < 0)) {
        return fail_line(r, "'+' needs the first frame after it; write a whole number from 0");
    }
    return 0;
}

static int read_source(reader *r, word whole, source *s) {
    const size_t star = find(whole, '*');
    *s = (source){.name = part(whole, 0, star)};
    s->hole = find(s->name, '{');
    const int has_hole = s->hole + 1 < s->name.length && s->name.text[s->hole + 1] == '}';
    if (!has_hole) {
        s->hole = s->name.length;
    }
    if (has_hole != (star < whole.length)) {
        return fail_line(r, "a sequence has both {} and *N; write name_{}.ply*N");
    }
    if (memchr(whole.text, 0, whole.length)) {
        return fail_line(r, "the file name holds a zero byte; correct it");
    }
    return has_hole ? read_frames(r, part(whole, star + 1, whole.length), s) : 0;
}

/* The path of the file: from malloc, NULL when memory is out. */
static char *path_of(const reader *r, const source *s) {
    const size_t directory = s->name.text[0] == '/' ? 0 : r->directory_length;
    const size_t room = directory + s->name.length + FRAME_DIGITS_BYTES;
    char *path = heap_get(room);
    if (!path) {
        return NULL;
    }
    memcpy(path, r->path, directory);
    memcpy(path + directory, s->name.text, s->name.length);
    path[directory + s->name.length] = '\0';
    if (s->frames > 0) {
        const int64_t number = (r->frame % s->frames + s->start % s->frames) % s->frames;
        const size_t rest = s->name.length - s->hole - 2;
        snprintf(path + directory + s->hole, room - directory - s->hole, "%03d%.*s", (int)number,
                 (int)rest, s->name.text + s->hole + 2);
    }
    return path;
}

static int line_has_more(reader *r) {
    return !scan_line_done(&r->text) && *r->text.at != '#';
}

static int read_number(reader *r, float *value) {
    return line_has_more(r) && scan_float(&r->text, value) == 0 && isfinite(*value) ? 0 : -1;
}

static int read_placement(reader *r, placement *p) {
    *p = (placement){0};
    if (read_number(r, &p->size) != 0 || read_number(r, &p->base[0]) != 0 ||
        read_number(r, &p->base[1]) != 0 || read_number(r, &p->base[2]) != 0) {
        return fail_line(r, "a size and a position are missing; write FILE SIZE X Y Z");
    }
    if (!(p->size > 0)) {
        return fail_line(r, "the size is not above 0; correct it");
    }
    if (line_has_more(r) && (read_number(r, &p->angle_x) != 0 || read_number(r, &p->angle_y) != 0 ||
                             line_has_more(r))) {
        return fail_line(r, "only two angles may follow FILE SIZE X Y Z; correct them");
    }
    return 0;
}

/* Before the floats are placed: what their rounding has done to them. */
static void note_precision(reader *r, size_t first_triangle) {
    static const double NOWHERE[3] = {0, 0, 0};
    const precision p = precision_of(r->m, first_triangle, r->m->triangles, NOWHERE);
    r->report->moved = fmax(r->report->moved, p.relative);
    r->report->vanished += p.vanished;
}

static int add_mesh(reader *r, const source *s, const placement *p) {
    const size_t first_vertex = r->m->vertices, first_triangle = r->m->triangles;
    char *path = path_of(r, s);
    if (!path) {
        return fail_line(r, "out of memory; close other programs");
    }
    fail inner = {{0}};
    int result = strcmp(path, "-") == 0 ? fail_set(&inner, path, "is standard input; name a file")
                                        : mesh_read_single(r->m, path, r->report, &inner);
    if (result == 0) {
        if (!r->report->centred) {
            note_precision(r, first_triangle);
        }
        result = placement_apply(p, r->m, first_vertex, first_triangle, r->report->centred, path,
                                 &inner);
    }
    heap_drop(path);
    r->report->sequences += s->frames > 0;
    return result == 0 ? 0 : fail_line(r, inner.text);
}

static int read_line(reader *r) {
    if (!line_has_more(r)) {
        return 0;
    }
    source s;
    placement p;
    if (read_source(r, scan_word(&r->text), &s) != 0 || read_placement(r, &p) != 0) {
        return -1;
    }
    return add_mesh(r, &s, &p);
}

static size_t directory_length(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

int recipe_read(mesh *m, const input *in, unsigned frame, mesh_report *report, fail *f) {
    const size_t vertices = m->vertices, triangles = m->triangles;
    const mesh_report before = *report;
    reader r = {
        .m = m,
        .path = in->path,
        .directory_length = directory_length(in->path),
        .frame = frame,
        .report = report,
        .text = scan_begin(in->bytes, in->size),
        .f = f,
    };
    do {
        if (read_line(&r) != 0) {
            m->vertices = vertices;
            m->triangles = triangles;
            *report = before;
            return -1;
        }
    } while (scan_next_line(&r.text));
    return 0;
}
