/* pack_lines - see pack_lines.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_lines.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

const char *pack_shown(const pack_file *file) {
    return strcmp(file->path, "-") == 0 ? "standard input" : file->path;
}

static void print(const fail *line) {
    fprintf(stderr, "%s\n", line->text);
}

/* The ending of a plural. */
static const char *s(uint64_t count) {
    return count == 1 ? "" : "s";
}

static void say_report(const pack_file *file) {
    int more = 0;
    for (unsigned i = 0; more >= 0; i++) {
        fail line = {""};
        more = report_line(&file->report, i, pack_shown(file), &line);
        if (more > 0) {
            print(&line);
        }
    }
}

static void say_moved(const pack_file *file) {
    const precision *p = &file->moved;
    fail line = {""};
    fail_set(&line, pack_shown(file),
             "single precision moves corners by up to %.2g, %.2g of an edge there, and %" PRIu64
             " triangle%s lose%s an edge; %s",
             p->moved, p->relative, p->vanished, s(p->vanished), p->vanished == 1 ? "s" : "",
             file->centre_helps
                 ? "use pack --centre to move the mesh to the origin first"
                 : "the mesh is too large for its smallest parts: pack these apart, with --centre");
    print(&line);
}

static void say_welded(const pack_file *file) {
    fail line = {""};
    fail_set(&line, pack_shown(file),
             "welded %" PRIu64 " position%s to another; %" PRIu64 " triangle%s lost %s area by it",
             file->welded.moved, s(file->welded.moved), file->welded.collapsed,
             s(file->welded.collapsed), file->welded.collapsed == 1 ? "its" : "their");
    print(&line);
}

static void say_open(const pack_file *file) {
    const uint64_t closed = file->open_edges - file->open_left;
    fail line = {""};
    if (file->open_distance > 0) {
        fail_set(&line, pack_shown(file),
                 "%" PRIu64
                 " open edge%s, some of which all but meet; use pack --weld %.0e to "
                 "close %" PRIu64,
                 file->open_edges, s(file->open_edges), file->open_distance, closed);
    } else {
        fail_set(&line, pack_shown(file),
                 "%" PRIu64 " open edge%s: the surface has holes or a border", file->open_edges,
                 s(file->open_edges));
    }
    print(&line);
}

void pack_say_lines(const pack_file *file) {
    fail line = {""};
    say_report(file);
    if (file->first == file->end) {
        pack_nothing_to_trace(file, &line);
        print(&line);
    }
    if (precision_matters(&file->moved)) {
        say_moved(file);
    }
    if (file->welded.moved > 0) {
        say_welded(file);
    }
    if (file->open_edges > 0) {
        say_open(file);
    }
}

static const char *nothing_remedy(const pack_file *file) {
    return file->report.count[REPORT_BAD_FACES] > 0 ? "mend them in the program that wrote them"
           : file->vertices > 0 ? "write it with its faces; points need a surface first"
                                : "check that the right objects were exported";
}

/* The parts of "3 vertices, 2 lines, 1 point, no faces". */
typedef struct held {
    char text[240];
    size_t used;
} held;

static void append(held *h, uint64_t count, const char *one, const char *many) {
    if (count > 0 && h->used < sizeof h->text) {
        const int n = snprintf(h->text + h->used, sizeof h->text - h->used, ", %" PRIu64 " %s",
                               count, count == 1 ? one : many);
        h->used += n > 0 ? (size_t)n : 0;
    }
}

int pack_nothing_to_trace(const pack_file *file, fail *f) {
    const uint64_t *count = file->report.count;
    const uint64_t dropped = count[REPORT_BAD_FACES], small = count[REPORT_SMALL_FACES];
    const char *none = small > 0 ? "" : ", no faces";
    held h = {"", 0};
    char but[80] = "";
    append(&h, count[REPORT_CURVES], "curve or free-form surface", "curves and free-form surfaces");
    append(&h, count[REPORT_LINES], "line", "lines");
    append(&h, count[REPORT_POINTS], "point", "points");
    append(&h, small, "face of fewer than 3 corners", "faces of fewer than 3 corners");
    if (dropped > 0) {
        snprintf(but, sizeof but, "%s%" PRIu64 " that had to be dropped",
                 small > 0 ? ", and " : " but ", dropped);
    }
    return fail_set(f, pack_shown(file), "%zu %s%s%s%s: nothing to trace; %s", file->vertices,
                    file->vertices == 1 ? "vertex" : "vertices", h.text, none, but,
                    nothing_remedy(file));
}
