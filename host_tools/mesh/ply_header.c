/* ply_header - what a PLY file says it holds
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/ply_header.h"

#include <string.h>

size_t ply_type_bytes(ply_type type) {
    static const size_t BYTES[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return BYTES[type];
}

static int type_of(word w, ply_type *type) {
    static const struct {
        const char *name;
        ply_type type;
    } NAMES[] = {
        {"char", PLY_INT8},       {"uchar", PLY_UINT8},    {"short", PLY_INT16},
        {"ushort", PLY_UINT16},   {"int", PLY_INT32},      {"uint", PLY_UINT32},
        {"float", PLY_FLOAT32},   {"double", PLY_FLOAT64}, {"int8", PLY_INT8},
        {"uint8", PLY_UINT8},     {"int16", PLY_INT16},    {"uint16", PLY_UINT16},
        {"int32", PLY_INT32},     {"uint32", PLY_UINT32},  {"float32", PLY_FLOAT32},
        {"float64", PLY_FLOAT64}, {"int64", PLY_INT64},    {"uint64", PLY_UINT64},
    };
    for (size_t i = 0; i < sizeof NAMES / sizeof NAMES[0]; i++) {
        if (word_is(w, NAMES[i].name)) {
            *type = NAMES[i].type;
            return 0;
        }
    }
    return -1;
}

static int read_format(ply_header *h, scan *s, const input *in, fail *f) {
    const word name = scan_word(s), version = scan_word(s);
    if (h->format != PLY_NO_FORMAT) {
        return fail_set(f, in->path, "line %zu: a second format; remove one", s->line);
    }
    h->format = word_is(name, "ascii")                  ? PLY_ASCII
                : word_is(name, "binary_little_endian") ? PLY_LITTLE
                : word_is(name, "binary_big_endian")    ? PLY_BIG
                                                        : PLY_NO_FORMAT;
    if (h->format == PLY_NO_FORMAT || !word_is(version, "1.0")) {
        return fail_set(f, in->path,
                        "line %zu: unknown format '%.*s %.*s'; write it as ascii, "
                        "binary_little_endian or binary_big_endian 1.0",
                        s->line, WORD_SHOWN(name), WORD_SHOWN(version));
    }
    return 0;
}

static int read_element(ply_header *h, scan *s, const input *in, fail *f) {
    const word name = scan_word(s), count = scan_word(s);
    int64_t number;
    if (word_integer(count, &number) != 0 || number < 0) {
        return fail_set(f, in->path, "line %zu: element '%.*s' has no count; write one", s->line,
                        WORD_SHOWN(name));
    }
    for (size_t i = 0; i < h->elements; i++) {
        if (word_is_word(h->element[i].name, name)) {
            return fail_set(f, in->path, "line %zu: a second element '%.*s'; rename one", s->line,
                            WORD_SHOWN(name));
        }
    }
    if (h->elements == PLY_ELEMENTS_MAX) {
        return fail_set(f, in->path, "line %zu: more than %d elements; remove some", s->line,
                        PLY_ELEMENTS_MAX);
    }
    h->element[h->elements++] = (ply_element){
        .name = name,
        .count = (uint64_t)number,
        .line = s->line,
        .property = h->property + h->properties,
    };
    return 0;
}

static int read_type(word w, ply_type *type, const scan *s, const input *in, fail *f) {
    if (type_of(w, type) == 0) {
        return 0;
    }
    return fail_set(f, in->path, "line %zu: unknown type '%.*s'; use one from char to double",
                    s->line, WORD_SHOWN(w));
}

static int read_types(ply_property *p, scan *s, const input *in, fail *f) {
    const word first = scan_word(s);
    p->is_list = word_is(first, "list");
    if (!p->is_list) {
        return read_type(first, &p->type, s, in, f);
    }
    if (read_type(scan_word(s), &p->count_type, s, in, f) != 0) {
        return -1;
    }
    if (p->count_type >= PLY_FLOAT32) {
        return fail_set(f, in->path, "line %zu: a list counted in fractions; use an integer type",
                        s->line);
    }
    return read_type(scan_word(s), &p->type, s, in, f);
}

static int read_property(ply_header *h, scan *s, const input *in, fail *f) {
    if (h->elements == 0) {
        return fail_set(f, in->path, "line %zu: a property before any element; reorder the header",
                        s->line);
    }
    if (h->properties == PLY_PROPERTIES_MAX) {
        return fail_set(f, in->path, "line %zu: more than %d properties; remove some", s->line,
                        PLY_PROPERTIES_MAX);
    }
    ply_property p = {0};
    if (read_types(&p, s, in, f) != 0) {
        return -1;
    }
    p.name = scan_word(s);
    if (p.name.length == 0) {
        return fail_set(f, in->path, "line %zu: a property without a name; write one", s->line);
    }
    ply_element *e = &h->element[h->elements - 1];
    for (size_t i = 0; i < e->properties; i++) {
        if (word_is_word(e->property[i].name, p.name)) {
            return fail_set(f, in->path, "line %zu: a second property '%.*s'; rename one", s->line,
                            WORD_SHOWN(p.name));
        }
    }
    h->property[h->properties++] = p;
    e->properties++;
    return 0;
}

/* A slip of the pen in a keyword must not be passed over: it would shift all data. */
static int is_slip(word w) {
    static const char *const HEADS[] = {"prop", "elem", "form", "list", "end"};
    for (size_t i = 0; i < sizeof HEADS / sizeof HEADS[0]; i++) {
        const size_t length = strlen(HEADS[i]);
        const word head = {w.text, w.length < length ? w.length : length};
        if (word_is_in_any_case(head, HEADS[i])) {
            return 1;
        }
    }
    return 0;
}

static int pass_over(ply_header *h, word first, scan *s, const input *in, fail *f) {
    if (is_slip(first)) {
        return fail_set(f, in->path,
                        "line %zu: '%.*s' in the header looks like a misspelt keyword; correct it, "
                        "or make the line a comment",
                        s->line, WORD_SHOWN(first));
    }
    h->unknown_lines++;
    return 1;
}

/* 1: the header goes on, 0: this was its last line. */
static int read_line(ply_header *h, scan *s, const input *in, fail *f) {
    const word first = scan_word(s);
    if (first.length == 0 || word_is(first, "comment") || word_is(first, "obj_info")) {
        return 1;
    }
    if (word_is(first, "end_header")) {
        return 0;
    }
    int result = 0;
    if (word_is(first, "format")) {
        result = read_format(h, s, in, f);
    } else if (word_is(first, "element")) {
        result = read_element(h, s, in, f);
    } else if (word_is(first, "property")) {
        result = read_property(h, s, in, f);
    } else {
        return pass_over(h, first, s, in, f);
    }
    if (result == 0 && !scan_line_done(s)) {
        return fail_set(f, in->path, "line %zu: more words than expected; remove them", s->line);
    }
    return result == 0 ? 1 : -1;
}

/* A file with CR line ends may have LF as its first data byte: that one is
 * no line end. */
static int find_data(ply_header *h, scan *s, const input *in, fail *f) {
    if (!scan_line_done(s)) {
        return fail_set(f, in->path, "line %zu: words after end_header; remove them", s->line);
    }
    const int bare_cr = in->bytes[3] == '\r' && in->bytes[4] != '\n';
    if (bare_cr && s->at < s->end) {
        s->at++;
        s->line++;
    } else {
        scan_next_line(s);
    }
    h->data = *s;
    return 0;
}

/* Fewest bytes of an element: in ASCII a digit and a separator per value. */
static size_t least_bytes(const ply_header *h, const ply_element *e) {
    size_t bytes = 0;
    for (size_t i = 0; i < e->properties; i++) {
        const ply_property *p = &e->property[i];
        bytes += h->format == PLY_ASCII ? 2 : ply_type_bytes(p->is_list ? p->count_type : p->type);
    }
    return bytes;
}

/* The last separator of an ASCII file may be missing. */
static int check_counts(const ply_header *h, const input *in, fail *f) {
    const size_t there = (size_t)(h->data.end - h->data.at);
    uint64_t left = there + (h->format == PLY_ASCII);
    for (size_t i = 0; i < h->elements; i++) {
        const ply_element *e = &h->element[i];
        const size_t least = least_bytes(h, e);
        if (least > 0 && e->count > left / least) {
            return fail_set(f, in->path,
                            "line %zu: %llu elements '%.*s' need at least %zu bytes each, but "
                            "%zu bytes follow the header; the file is cut short: get it again",
                            e->line, (unsigned long long)e->count, WORD_SHOWN(e->name), least,
                            there);
        }
        left -= e->count * least;
    }
    return 0;
}

int ply_header_read(ply_header *h, const input *in, fail *f) {
    *h = (ply_header){0};
    scan s = scan_begin(in->bytes, in->size);
    if (!word_is(scan_word(&s), "ply") || !scan_line_done(&s)) {
        return fail_set(f, in->path,
                        "line 1: does not begin with 'ply'; give it the name "
                        "of its true format");
    }
    int more = 1;
    while (more > 0 && scan_next_line(&s)) {
        more = read_line(h, &s, in, f);
    }
    if (more < 0) {
        return -1;
    }
    if (more > 0) {
        return fail_set(f, in->path,
                        "line %zu: the header has no end_header; the file is cut short: "
                        "get it again",
                        s.line);
    }
    if (h->format == PLY_NO_FORMAT) {
        return fail_set(f, in->path, "line %zu: the header names no format; add one", s.line);
    }
    return find_data(h, &s, in, f) != 0 ? -1 : check_counts(h, in, f);
}
