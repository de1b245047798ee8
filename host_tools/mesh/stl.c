/* stl - reads stereolithography files, binary and ASCII; corners are welded
 *
 * Binary is what has the size that its triangle count at byte 80 asks for,
 * whatever its first 80 bytes say ("solid" among others). An ASCII file of
 * that size would begin with a count above 2^27 and be over 7 GB long.
 *
 * Source: 3D Systems, StereoLithography Interface Specification, 1988.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "host_tools/mesh/intake.h"
#include "host_tools/mesh/readers.h"
#include "host_tools/mesh/scan.h"
#include "host_tools/mesh/weld.h"

enum { HEADER_BYTES = 84, TRIANGLE_BYTES = 50, NORMAL_BYTES = 12 };

typedef struct reader {
    intake in;
    weld welded;
    scan text; /* ASCII only */
} reader;

static uint32_t read32(const unsigned char *at) {
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static uint64_t binary_bytes(const input *in) {
    return HEADER_BYTES + (uint64_t)TRIANGLE_BYTES * read32(in->bytes + HEADER_BYTES - 4);
}

static int is_binary(const input *in) {
    return in->size >= HEADER_BYTES && in->size == binary_bytes(in);
}

static int is_ascii(const input *in) {
    const size_t looked_at = in->size < 1024 ? in->size : 1024;
    scan s = scan_begin(in->bytes, in->size);
    while (scan_line_done(&s) && scan_next_line(&s)) {
    }
    return word_is(scan_word(&s), "solid") && !memchr(in->bytes, 0, looked_at);
}

/* A vertex that the intake replaced is not welded: it is not at 0. */
static int add_corner(reader *r, chain *c, const float position[3]) {
    mesh *m = r->in.m;
    uint32_t *slot = weld_find(&r->welded, position);
    if (!slot) {
        return intake_fail(&r->in, "out of memory; split the mesh");
    }
    const uint64_t bad = r->in.bad_vertices;
    if (*slot == 0) {
        if (intake_vertex(&r->in, position[0], position[1], position[2]) != 0) {
            return -1;
        }
        if (r->in.bad_vertices == bad) {
            *slot = (uint32_t)m->vertices;
            r->welded.used++;
        }
    }
    const int64_t vertex = *slot ? (int64_t)*slot - 1 : (int64_t)m->vertices - 1;
    const int64_t number = vertex - (int64_t)r->in.first_vertex;
    return intake_corner(&r->in, c, number, number);
}

static int read_binary_triangle(reader *r, const unsigned char *at) {
    chain c = {0};
    for (int k = 0; k < 3; k++) {
        float position[3];
        for (int axis = 0; axis < 3; axis++) {
            const uint32_t bits = read32(at + NORMAL_BYTES + 12 * k + 4 * axis);
            memcpy(&position[axis], &bits, sizeof bits);
        }
        if (add_corner(r, &c, position) != 0) {
            return -1;
        }
    }
    return 0;
}

static int check_size(const reader *r, const input *in) {
    if (in->size < HEADER_BYTES) {
        return fail_set(r->in.f, in->path,
                        "byte %zu: ends inside the %d byte header of a binary STL; get it again",
                        in->size, HEADER_BYTES);
    }
    const unsigned long long asked = binary_bytes(in);
    if (in->size < asked) {
        return fail_set(r->in.f, in->path,
                        "byte 80: %llu triangles take %llu bytes, but the file has %zu; "
                        "it is cut short or no STL: get it again",
                        (asked - HEADER_BYTES) / TRIANGLE_BYTES, asked, in->size);
    }
    if (in->size > asked && !r->in.repair->wanted) {
        return fail_set(r->in.f, in->path,
                        "byte %llu: %llu bytes more than the triangle count at byte 80 says; "
                        "correct it or use pack --repair to ignore them",
                        asked, (unsigned long long)in->size - asked);
    }
    return 0;
}

static int read_binary(reader *r, const input *in) {
    if (check_size(r, in) != 0) {
        return -1;
    }
    const uint64_t triangles = read32(in->bytes + HEADER_BYTES - 4);
    for (uint64_t i = 0; i < triangles; i++) {
        const size_t byte = HEADER_BYTES + (size_t)i * TRIANGLE_BYTES;
        r->in.at = (location){.what = "triangle", .number = i, .byte = byte};
        if (read_binary_triangle(r, in->bytes + byte) != 0) {
            return -1;
        }
    }
    return 0;
}

/* Moves over line ends to the next word; its length is 0 at the end of the text. */
static void find_word(reader *r) {
    while (scan_line_done(&r->text) && scan_next_line(&r->text)) {
    }
    r->in.at.line = r->text.line;
}

static word next_word(reader *r) {
    find_word(r);
    return scan_word(&r->text);
}

static int fail_word(reader *r, word w, const char *expected) {
    if (w.length == 0) {
        return intake_fail(&r->in, "the file ends where '%s' belongs; get it again", expected);
    }
    return intake_fail(&r->in, "'%.*s' where '%s' belongs; correct it", WORD_SHOWN(w), expected);
}

static int expect(reader *r, const char *expected) {
    const word w = next_word(r);
    return word_is(w, expected) ? 0 : fail_word(r, w, expected);
}

static int read_position(reader *r, float position[3]) {
    for (int axis = 0; axis < 3; axis++) {
        find_word(r);
        if (scan_float(&r->text, &position[axis]) != 0) {
            return fail_word(r, scan_word(&r->text), "a number");
        }
    }
    return 0;
}

/* Normals follow from the corners. Some files do not even have numbers
 * there. */
static int read_facet_begin(reader *r) {
    if (expect(r, "normal") != 0) {
        return -1;
    }
    for (int axis = 0; axis < 3; axis++) {
        next_word(r);
    }
    return expect(r, "outer") != 0 ? -1 : expect(r, "loop");
}

static int read_facet(reader *r) {
    chain c = {0};
    if (read_facet_begin(r) != 0) {
        return -1;
    }
    for (;;) {
        const word w = next_word(r);
        if (word_is(w, "endloop")) {
            break;
        }
        float position[3];
        if (!word_is(w, "vertex")) {
            return fail_word(r, w, "vertex");
        }
        if (read_position(r, position) != 0 || add_corner(r, &c, position) != 0) {
            return -1;
        }
    }
    return intake_polygon_end(&r->in, &c) != 0 ? -1 : expect(r, "endfacet");
}

/* One or more of: solid NAME ... endsolid NAME; a name may be anything. */
static int read_ascii(reader *r) {
    int open = 0;
    for (;;) {
        const word w = next_word(r);
        if (word_is(w, open ? "endsolid" : "solid")) {
            open = !open;
            scan_next_line(&r->text);
        } else if (open && word_is(w, "facet")) {
            if (read_facet(r) != 0) {
                return -1;
            }
        } else if (w.length == 0 && !open) {
            return 0;
        } else {
            return fail_word(r, w, open ? "facet or endsolid" : "solid");
        }
    }
}

int stl_is(const input *in) {
    return is_binary(in) || is_ascii(in);
}

int stl_read(mesh *m, const input *in, mesh_repair *repair, fail *f) {
    reader r = {
        .in = intake_begin(m, in->path, repair, f),
        .welded = {.m = m},
        .text = scan_begin(in->bytes, in->size),
    };
    int result = !is_binary(in) && is_ascii(in) ? read_ascii(&r) : read_binary(&r, in);
    weld_free(&r.welded);
    if (result == 0) {
        result = intake_finish(&r.in);
    } else {
        intake_undo(&r.in);
    }
    return result;
}
