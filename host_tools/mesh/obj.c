/* obj - reads vertices and faces of Wavefront OBJ
 *
 * `v` and `f` are read, all other keywords passed over. A face may use a
 * vertex that only comes later. Vertices are counted from 1; a negative
 * number counts back from the last vertex so far.
 *
 * Source: Wavefront Technologies, Advanced Visualizer Manual, appendix B1,
 * Object Files, 1995.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/intake.h"
#include "host_tools/mesh/readers.h"
#include "host_tools/mesh/scan.h"

typedef struct reader {
    intake in;
    scan text;
    size_t known_lines;
} reader;

static const char *const KNOWN[] = {
    "v",  "f",      "vt",     "vn",     "vp",     "g",  "o",      "s",   "l",    "p",
    "mg", "mtllib", "usemtl", "usemap", "maplib", "fo", "cstype", "deg", "surf", "curv",
};

static int is_known(word w) {
    for (size_t i = 0; i < sizeof KNOWN / sizeof KNOWN[0]; i++) {
        if (word_is(w, KNOWN[i])) {
            return 1;
        }
    }
    return 0;
}

static int is_text(word w) {
    for (size_t i = 0; i < w.length; i++) {
        if ((unsigned char)w.text[i] < 0x20) {
            return 0;
        }
    }
    return 1;
}

static int fail_coordinate(reader *r) {
    const word w = scan_word(&r->text);
    if (w.length == 0) {
        return intake_fail(&r->in, "a coordinate is missing; correct the line");
    }
    return intake_fail(&r->in, "'%.*s' where a coordinate belongs; correct the line",
                       WORD_SHOWN(w));
}

/* What follows z (w, colours) is not used. */
static int read_vertex(reader *r) {
    float position[3];
    for (int axis = 0; axis < 3; axis++) {
        if (scan_float(&r->text, &position[axis]) != 0) {
            return fail_coordinate(r);
        }
    }
    return intake_vertex(&r->in, position[0], position[1], position[2]);
}

/* "7", "7/1", "7/1/3" or "7//3": only the first number is used. */
static int read_corner_number(reader *r, int64_t *written) {
    const word whole = scan_word(&r->text);
    word number = whole;
    for (size_t i = 0; i < whole.length; i++) {
        if (whole.text[i] == '/') {
            number.length = i;
            break;
        }
    }
    if (word_integer(number, written) != 0) {
        return intake_fail(&r->in, "'%.*s' where a vertex number belongs; correct the line",
                           WORD_SHOWN(whole));
    }
    return 0;
}

static int read_corner(reader *r, chain *c) {
    int64_t written;
    if (read_corner_number(r, &written) != 0) {
        return -1;
    }
    const int64_t here = (int64_t)(r->in.m->vertices - r->in.first_vertex);
    int64_t vertex = written > 0 ? written - 1 : INTAKE_MISSING;
    if (written < 0 && written >= -here) {
        vertex = here + written;
    }
    return intake_corner(&r->in, c, vertex, written);
}

static int read_face(reader *r) {
    chain c = {0};
    while (!scan_line_done(&r->text) && *r->text.at != '#') {
        if (read_corner(r, &c) != 0) {
            return -1;
        }
    }
    return intake_polygon_end(&r->in, &c);
}

/* A comment may end in a backslash (a path): it joins no lines. */
static int read_line(reader *r) {
    r->in.at = (location){.line = r->text.line};
    r->text.continued = 0;
    if (scan_line_done(&r->text) || *r->text.at == '#') {
        return 0;
    }
    const word w = scan_word(&r->text);
    const int is_vertex = word_is(w, "v"), is_face = word_is(w, "f");
    if (!is_text(w)) {
        return intake_fail(&r->in, "'%.*s' is no text; check that this is an OBJ file",
                           WORD_SHOWN(w));
    }
    r->text.continued = is_vertex || is_face;
    r->known_lines += (size_t)is_known(w);
    return is_vertex ? read_vertex(r) : is_face ? read_face(r) : 0;
}

static int read_lines(reader *r) {
    do {
        if (read_line(r) != 0) {
            return -1;
        }
    } while (scan_next_line(&r->text));
    if (r->known_lines == 0) {
        return intake_fail(&r->in, "no line up to here is one of OBJ; check the file's format");
    }
    return 0;
}

int obj_is(const input *in) {
    scan s = scan_begin(in->bytes, in->size);
    while ((scan_line_done(&s) || *s.at == '#') && scan_next_line(&s)) {
    }
    return is_known(scan_word(&s));
}

int obj_read(mesh *m, const input *in, mesh_repair *repair, fail *f) {
    reader r = {
        .in = intake_begin(m, in->path, repair, f),
        .text = scan_begin(in->bytes, in->size),
    };
    int result = read_lines(&r);
    if (result == 0) {
        result = intake_finish(&r.in);
    } else {
        intake_undo(&r.in);
    }
    return result;
}
