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

static void say_unknown(const pack_file *file) {
    fail line = {""};
    fail_set(&line, pack_shown(file),
             "not looked at for holes and seams; use a larger --memory to have that done");
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
    if (file->edges_unknown) {
        say_unknown(file);
    } else if (file->open_edges > 0) {
        say_open(file);
    }
}

static const char *nothing_remedy(const pack_file *file) {
    return file->report.count[REPORT_BAD_FACES] > 0 ? "mend them in the program that wrote them"
           : file->vertices > 0 ? "write it with its faces; points need a surface first"
                                : "check that the right objects were exported";
}

/* "3 vertices, 2 lines, 1 point, no faces" */
int pack_nothing_to_trace(const pack_file *file, fail *f) {
    static const report_item THERE[] = {REPORT_CURVES, REPORT_LINES, REPORT_POINTS,
                                        REPORT_SMALL_FACES};
    const uint64_t dropped = file->report.count[REPORT_BAD_FACES];
    const int has_faces = file->report.count[REPORT_SMALL_FACES] > 0;
    const char *none = has_faces ? "" : ", no faces";
    count_list there = {"0 vertices", sizeof "0 vertices" - 1};
    char but[80] = "";
    if (file->vertices > 0) {
        there.used = 0;
        count_list_add(&there, file->vertices, "vertex", "vertices");
    }
    for (size_t i = 0; i < sizeof THERE / sizeof THERE[0]; i++) {
        report_count(&file->report, THERE[i], &there);
    }
    if (dropped > 0) {
        snprintf(but, sizeof but, "%s%" PRIu64 " that had to be dropped",
                 has_faces ? ", and " : " but ", dropped);
    }
    return fail_set(f, pack_shown(file), "%s%s%s: nothing to trace; %s", there.text, none, but,
                    nothing_remedy(file));
}
