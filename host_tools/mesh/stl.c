/* stl - reads stereolithography files, binary and ASCII; equal corners become one vertex
 *
 * A file of just the size that its count asks for is binary, whatever its first 80 bytes say.
 * Of others ASCII is what begins with "solid", in any case, and goes on after that line as
 * such text does, beyond byte 84; and what has hardly a control byte, when it begins with
 * "solid" or its name ends in .stl. All else is binary. Its size says how many triangles there
 * are when it is whole; the count at byte 80 is wrong in some files.
 *
 * Around facets and solids of ASCII may stand comments, zero bytes and the end-of-file byte
 * 0x1A of old systems; "endsolid" may be two words, or missing. A name may hold any byte.
 *
 * Source: 3D Systems, StereoLithography Interface Specification, 1988.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "host_tools/mesh/intake.h"
#include "host_tools/mesh/readers.h"
#include "host_tools/mesh/scan.h"
#include "host_tools/mesh/vertex_table.h"

enum { HEADER_BYTES = 84, TRIANGLE_BYTES = 50, NORMAL_BYTES = 12, SAMPLE_BYTES = 1024 };

typedef struct reader {
    intake in;
    vertex_table met;
    scan text;                /* ASCII only */
    int big_endian;           /* binary only: against the format, but some programs can */
    report_miscount miscount; /* binary only */
} reader;

static uint32_t read32(const unsigned char *at) {
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static uint32_t read32_big(const unsigned char *at) {
    return (uint32_t)at[3] | (uint32_t)at[2] << 8 | (uint32_t)at[1] << 16 | (uint32_t)at[0] << 24;
}

static uint64_t counted_bytes(const input *in) {
    return HEADER_BYTES + (uint64_t)TRIANGLE_BYTES * read32(in->bytes + HEADER_BYTES - 4);
}

/* An ASCII file of just the size that its bytes 80 to 83 ask for would be over 7 GB long. */
static int has_counted_size(const input *in) {
    return in->size >= HEADER_BYTES && in->size == counted_bytes(in);
}

static int is_control(unsigned char c) {
    return (c < 0x20 && !(c >= '\t' && c <= '\r')) || c == 0x7f;
}

static scan text_of(const input *in) {
    return scan_begin_filled(in->bytes, in->size);
}

/* Of its first bytes at most one of 32 is a control byte. A binary file has more: three of
 * its count below 2^24, and two of each triangle without a colour. */
static int is_mostly_text(const input *in) {
    size_t size = (size_t)(text_of(in).end - in->bytes), controls = 0;
    size = size < SAMPLE_BYTES ? size : SAMPLE_BYTES;
    for (size_t i = 0; i < size; i++) {
        controls += (size_t)is_control(in->bytes[i]);
    }
    return size > 0 && 32 * controls <= size;
}

static int is_comment(const scan *s) {
    return *s->at == '#' || *s->at == ';' || (s->end - s->at > 1 && memcmp(s->at, "//", 2) == 0);
}

/* Moves over blanks and line ends, and where they may stand, over comments and fillers. */
static void find_next(scan *s, int around) {
    for (;;) {
        if (scan_line_done(s) || (around && is_comment(s))) {
            if (!scan_next_line(s)) {
                return;
            }
        } else if (around && byte_is_filler(*s->at)) {
            s->at++;
        } else {
            return;
        }
    }
}

/* The next word of the line, without fillers behind it. */
static word read_word(scan *s) {
    const word w = scan_word(s);
    size_t length = w.length > 0;
    while (length < w.length && !byte_is_filler((unsigned char)w.text[length])) {
        length++;
    }
    s->at -= w.length - length;
    return (word){w.text, length};
}

/* Whether `w`, and the next word if need be, is "end" and `rest`: then `s` is behind both. */
static int ends(scan *s, word w, const char *rest) {
    if (word_is_in_any_case(w, "end")) {
        scan ahead = *s;
        find_next(&ahead, 0);
        if (word_is_in_any_case(read_word(&ahead), rest)) {
            *s = ahead;
            return 1;
        }
        return 0;
    }
    const word head = {w.text, w.length < 3 ? w.length : 3};
    const word tail = {w.text + head.length, w.length - head.length};
    return word_is_in_any_case(head, "end") && word_is_in_any_case(tail, rest);
}

/* From the word at `at` on all is ASCII, to the end of where a header would be. */
static int is_ascii_beyond_header(const input *in, const unsigned char *at) {
    const unsigned char *end = in->bytes + (in->size < HEADER_BYTES ? in->size : HEADER_BYTES);
    while (at < end && *at < 0x80 && !is_control(*at)) {
        at++;
    }
    return at >= end;
}

static int begins_with_solid(const input *in) {
    scan s = text_of(in);
    find_next(&s, 1);
    return word_is_in_any_case(read_word(&s), "solid");
}

/* Begins with "solid", and after that line, and those of solids without facets, a facet
 * or the end is there as text. The line itself may hold any byte: a name is there. */
static int speaks_stl(const input *in) {
    scan s = text_of(in);
    find_next(&s, 1);
    word w = read_word(&s);
    int solids = word_is_in_any_case(w, "solid"), ended = 0;
    if (!solids) {
        return 0;
    }
    while (solids) {
        scan_next_line(&s);
        find_next(&s, 1);
        w = read_word(&s);
        const int at_end = ends(&s, w, "solid");
        ended |= at_end;
        solids = at_end || word_is_in_any_case(w, "solid");
    }
    return word_is_in_any_case(w, "facet")
               ? is_ascii_beyond_header(in, (const unsigned char *)w.text)
               : ended && w.length == 0;
}

static int is_text(const input *in) {
    return speaks_stl(in) || is_mostly_text(in);
}

/* A vertex that the intake replaced is not found again: it is not at 0. */
static int add_corner(reader *r, chain *c, const real position[3]) {
    mesh *m = r->in.m;
    uint32_t *slot = vertex_table_find(&r->met, position);
    if (!slot) {
        return intake_fail(&r->in, "out of memory; split the mesh");
    }
    const uint64_t bad = r->in.count[REPORT_BAD_VERTICES];
    if (*slot == 0) {
        if (intake_vertex(&r->in, position) != 0) {
            return -1;
        }
        if (r->in.count[REPORT_BAD_VERTICES] == bad) {
            *slot = (uint32_t)m->vertices;
            r->met.used++;
        }
    }
    const int64_t vertex = *slot ? (int64_t)*slot - 1 : (int64_t)m->vertices - 1;
    const int64_t number = vertex - (int64_t)r->in.unresolved.first_vertex;
    return intake_corner(&r->in, c, number, number);
}

static int read_binary_triangle(reader *r, const unsigned char *at) {
    chain c = intake_chain(&r->in, 0);
    for (int k = 0; k < 3; k++) {
        real position[3];
        for (int axis = 0; axis < 3; axis++) {
            const unsigned char *coordinate = at + NORMAL_BYTES + 12 * k + 4 * axis;
            const uint32_t bits = r->big_endian ? read32_big(coordinate) : read32(coordinate);
            float value;
            memcpy(&value, &bits, sizeof bits);
            position[axis] = real_of_float(value);
        }
        if (add_corner(r, &c, position) != 0) {
            return -1;
        }
    }
    return 0;
}

static void note_miscount(reader *r, uint64_t counted, uint64_t held) {
    if (counted != held) {
        r->in.count[REPORT_MISCOUNTED] += held > counted ? held - counted : counted - held;
        r->miscount = (report_miscount){.files = 1, .counted = counted, .held = held};
    }
}

/* Bytes are left over behind the triangles. With repair they are ignored, and the triangles
 * are those that the size holds: the count is not above that. */
static int count_with_loose_bytes(reader *r, const input *in, uint64_t *triangles) {
    const unsigned long long counted = read32(in->bytes + HEADER_BYTES - 4);
    const unsigned long long held = (in->size - HEADER_BYTES) / TRIANGLE_BYTES;
    const unsigned long long asked = counted_bytes(in);
    const unsigned long long loose = (in->size - HEADER_BYTES) % TRIANGLE_BYTES;
    if (in->size < asked) {
        return fail_set(r->in.f, in->path,
                        "byte 80: %llu triangles take %llu bytes, but the file has %zu; "
                        "it is cut short or no STL: get it again",
                        counted, asked, in->size);
    }
    if (held == 0) {
        return fail_set(r->in.f, in->path,
                        "byte %d: a triangle takes %d bytes, but %llu follow; get the file again",
                        HEADER_BYTES, TRIANGLE_BYTES, loose);
    }
    if (!r->in.report->repair && held == counted) {
        return fail_set(r->in.f, in->path,
                        "byte %llu: %llu bytes more than the triangle count at byte 80 says; "
                        "remove them or use pack --repair to ignore them",
                        asked, loose);
    }
    if (!r->in.report->repair) {
        return fail_set(
            r->in.f, in->path,
            "byte 80: its count of triangles says %llu, but the file holds %llu and %llu "
            "bytes more; use pack --repair to read what it holds",
            counted, held, loose);
    }
    *triangles = held;
    note_miscount(r, counted, held);
    r->in.count[REPORT_LOOSE_BYTES] += loose;
    return 0;
}

/* Triangles of a binary file: by its size when that is whole. */
static int count_binary(reader *r, const input *in, uint64_t *triangles) {
    if (in->size < HEADER_BYTES) {
        return fail_set(r->in.f, in->path,
                        "byte %zu: ends inside the %d byte header of a binary STL; get it again",
                        in->size, HEADER_BYTES);
    }
    if ((in->size - HEADER_BYTES) % TRIANGLE_BYTES != 0) {
        return count_with_loose_bytes(r, in, triangles);
    }
    const uint64_t counted = read32(in->bytes + HEADER_BYTES - 4);
    const uint64_t held = (in->size - HEADER_BYTES) / TRIANGLE_BYTES;
    *triangles = held;
    r->big_endian = held != counted && held == read32_big(in->bytes + HEADER_BYTES - 4);
    if (r->big_endian) {
        r->in.count[REPORT_SWAPPED] += held;
    } else {
        note_miscount(r, counted, held);
    }
    return 0;
}

/* Two programs' ways to colour a triangle in the two bytes behind it: bit 15 set, or
 * anything when the header has a colour of all. */
static int is_coloured(const input *in, const unsigned char *triangle) {
    const unsigned attribute = triangle[TRIANGLE_BYTES - 2] | triangle[TRIANGLE_BYTES - 1] << 8;
    return attribute >> 15 || (attribute != 0 && memcmp(in->bytes, "COLOR=", 6) == 0);
}

static int read_binary(reader *r, const input *in) {
    uint64_t triangles = 0;
    if (count_binary(r, in, &triangles) != 0) {
        return -1;
    }
    for (uint64_t i = 0; i < triangles; i++) {
        const size_t byte = HEADER_BYTES + (size_t)i * TRIANGLE_BYTES;
        r->in.at = (location){.what = "triangle", .number = i, .byte = byte};
        if (read_binary_triangle(r, in->bytes + byte) != 0) {
            return -1;
        }
        r->in.count[REPORT_COLOURS] += (uint64_t)is_coloured(in, in->bytes + byte);
    }
    return 0;
}

/* The next word, which is empty at the end of the text. */
static word next_word(reader *r, int around) {
    find_next(&r->text, around);
    r->in.at.line = r->text.line;
    return read_word(&r->text);
}

static int fail_word(reader *r, word w, const char *expected) {
    if (w.length == 0) {
        return intake_fail(&r->in, "the file ends where '%s' belongs; get it again", expected);
    }
    return intake_fail(&r->in, "'%.*s' where '%s' belongs; correct it", WORD_SHOWN(w), expected);
}

static int expect(reader *r, const char *expected) {
    const word w = next_word(r, 0);
    return word_is_in_any_case(w, expected) ? 0 : fail_word(r, w, expected);
}

static int read_position(reader *r, real position[3]) {
    for (int axis = 0; axis < 3; axis++) {
        find_next(&r->text, 0);
        r->in.at.line = r->text.line;
        if (scan_real(&r->text, &position[axis]) != 0) {
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
        next_word(r, 0);
    }
    return expect(r, "outer") != 0 ? -1 : expect(r, "loop");
}

static int read_loop(reader *r, chain *c) {
    for (;;) {
        const word w = next_word(r, 0);
        if (ends(&r->text, w, "loop")) {
            return 0;
        }
        real position[3];
        if (!word_is_in_any_case(w, "vertex")) {
            return fail_word(r, w, "vertex");
        }
        if (read_position(r, position) != 0 || add_corner(r, c, position) != 0) {
            return -1;
        }
    }
}

/* A facet is a face of three corners at least: fewer are damage. */
static int read_loop_end(reader *r, const chain *c) {
    if (c->corners >= 3) {
        return intake_polygon_end(&r->in, c);
    }
    if (!r->in.report->repair) {
        return intake_fail(&r->in, "a face of %llu corners; use pack --repair to drop it",
                           (unsigned long long)c->corners);
    }
    r->in.count[REPORT_BAD_FACES]++;
    return 0;
}

static int read_facet(reader *r) {
    chain c = intake_chain(&r->in, 0);
    if (read_facet_begin(r) != 0 || read_loop(r, &c) != 0 || read_loop_end(r, &c) != 0) {
        return -1;
    }
    const word w = next_word(r, 0);
    return ends(&r->text, w, "facet") ? 0 : fail_word(r, w, "endfacet");
}

/* The solid that is open ends without endsolid; one without facets is damage. */
static int end_without_word(reader *r, size_t first_triangle) {
    if (r->in.m->triangles == first_triangle) {
        return fail_word(r, (word){"", 0}, "facet or endsolid");
    }
    r->in.count[REPORT_UNENDED]++;
    return 0;
}

/* One or more of: solid NAME ... endsolid NAME; a name may be anything. */
static int read_ascii(reader *r) {
    int open = 0;
    size_t first_triangle = 0; /* of the open solid */
    for (;;) {
        const word w = next_word(r, 1);
        const int begins = word_is_in_any_case(w, "solid");
        if (open && ends(&r->text, w, "solid")) {
            open = 0;
            scan_next_line(&r->text);
        } else if (open && (begins || w.length == 0) && end_without_word(r, first_triangle) != 0) {
            return -1;
        } else if (begins) {
            open = 1;
            first_triangle = r->in.m->triangles;
            scan_next_line(&r->text);
        } else if (open && word_is_in_any_case(w, "facet")) {
            if (read_facet(r) != 0) {
                return -1;
            }
        } else if (w.length == 0) {
            return 0;
        } else {
            return fail_word(r, w, open ? "facet or endsolid" : "solid");
        }
    }
}

int stl_is(const input *in) {
    return has_counted_size(in) || (begins_with_solid(in) && is_text(in));
}

int stl_may_be(const input *in) {
    return in->size > HEADER_BYTES && (in->size - HEADER_BYTES) % TRIANGLE_BYTES == 0 &&
           !is_text(in);
}

int stl_read(mesh *m, const input *in, mesh_report *report, fail *f) {
    reader r = {
        .in = intake_begin(m, in->path, report, f),
        .met = {.m = m},
        .text = text_of(in),
    };
    int result = !has_counted_size(in) && is_text(in) ? read_ascii(&r) : read_binary(&r, in);
    vertex_table_free(&r.met);
    if (result != 0) {
        intake_undo(&r.in);
        return -1;
    }
    if (intake_finish(&r.in) != 0) {
        return -1;
    }
    report_add_miscount(report, r.miscount);
    return 0;
}
