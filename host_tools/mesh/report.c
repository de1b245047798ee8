/* report - see report.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/report.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *key, *one, *many; /* the words after a count; NULL: not left out */
} ITEMS[REPORT_ITEMS] = {
    [REPORT_SMALL_FACES] = {"small_faces", "face of fewer than 3 corners",
                            "faces of fewer than 3 corners"},
    [REPORT_POINTS] = {"points", "point", "points"},
    [REPORT_LINES] = {"lines", "line", "lines"},
    [REPORT_CURVES] = {"curves", "curve or free-form surface", "curves and free-form surfaces"},
    [REPORT_COLOURS] = {"colours", "colour", "colours"},
    [REPORT_NORMALS] = {"normals", "normal", "normals"},
    [REPORT_TEXTURES] = {"texture_coordinates", "texture coordinate", "texture coordinates"},
    [REPORT_MATERIALS] = {"materials", "use of a material", "uses of materials"},
    [REPORT_ELEMENTS] = {"other_elements", "element of another kind", "elements of other kinds"},
    [REPORT_UNREAD_LINES] = {"unread_lines", "line of a keyword that is not read",
                             "lines of keywords that are not read"},
    [REPORT_OVERLAPPING] = {"overlapping_faces", NULL, NULL},
    [REPORT_MISCOUNTED] = {"miscounted_triangles", NULL, NULL},
    [REPORT_SWAPPED] = {"big_endian_triangles", NULL, NULL},
    [REPORT_UNENDED] = {"unended_solids", NULL, NULL},
    [REPORT_UNKNOWN_LINES] = {"unknown_header_lines", NULL, NULL},
    [REPORT_LOOSE_BYTES] = {"loose_bytes", NULL, NULL},
    [REPORT_BAD_FACES] = {"dropped_faces", NULL, NULL},
    [REPORT_BAD_VERTICES] = {"bad_vertices", NULL, NULL},
};

const char *report_key(report_item item) {
    return ITEMS[item].key;
}

void report_add_miscount(mesh_report *r, report_miscount more) {
    r->miscount.files += more.files;
    r->miscount.counted += more.counted;
    r->miscount.held += more.held;
}

/* A list in words: "2 points, 1 normal". */
typedef struct list {
    char text[400];
    size_t used;
} list;

static void append(list *l, uint64_t count, const char *one, const char *many) {
    if (count > 0 && l->used < sizeof l->text) {
        const int n =
            snprintf(l->text + l->used, sizeof l->text - l->used, "%s%llu %s",
                     l->used > 0 ? ", " : "", (unsigned long long)count, count == 1 ? one : many);
        l->used += n > 0 ? (size_t)n : 0;
    }
}

static int say_left_out(const mesh_report *r, const char *path, fail *to) {
    list l = {"", 0};
    for (int i = 0; i < REPORT_ITEMS; i++) {
        if (ITEMS[i].one != NULL) {
            append(&l, r->count[i], ITEMS[i].one, ITEMS[i].many);
        }
    }
    if (l.used > 0) {
        fail_set(to, path, "left out %s", l.text);
    }
    return l.used > 0;
}

static int say_overlapping(const mesh_report *r, const char *path, fail *to) {
    const unsigned long long faces = r->count[REPORT_OVERLAPPING];
    if (faces > 0) {
        fail_set(to, path,
                 "%llu face%s cross%s %s, and no triangles fill %s without overlap; cut %s into "
                 "triangles where %s made",
                 faces, faces == 1 ? "" : "s", faces == 1 ? "es" : "",
                 faces == 1 ? "itself" : "themselves", faces == 1 ? "it" : "them",
                 faces == 1 ? "it" : "them", faces == 1 ? "it was" : "they were");
    }
    return faces > 0;
}

/* Of several files, which a recipe may place, the sums. */
static int say_miscount(const mesh_report *r, const char *path, fail *to) {
    const unsigned long long files = r->miscount.files, counted = r->miscount.counted;
    const unsigned long long held = r->miscount.held;
    const char *s = counted == 1 ? "" : "s";
    if (files == 1) {
        fail_set(to, path, "read whole: its count says %llu triangle%s, its size holds %llu",
                 counted, s, held);
    } else if (files > 1) {
        fail_set(to, path,
                 "read whole: the counts of %llu files say %llu triangle%s, their sizes hold %llu",
                 files, counted, s, held);
    }
    return files > 0;
}

static int say_habits(const mesh_report *r, const char *path, fail *to) {
    list l = {"", 0};
    append(&l, r->count[REPORT_SWAPPED], "triangle in big-endian order",
           "triangles in big-endian order");
    append(&l, r->count[REPORT_UNENDED], "solid without endsolid", "solids without endsolid");
    append(&l, r->count[REPORT_UNKNOWN_LINES], "header line that is no PLY keyword",
           "header lines that are no PLY keywords");
    if (l.used > 0) {
        fail_set(to, path, "read whole in spite of %s", l.text);
    }
    return l.used > 0;
}

static int say_dropped(const mesh_report *r, const char *path, fail *to) {
    list l = {"", 0};
    append(&l, r->count[REPORT_BAD_FACES], "face that cannot be traced",
           "faces that cannot be traced");
    append(&l, r->count[REPORT_BAD_VERTICES], "vertex that is not finite or is beyond +-2^40",
           "vertices that are not finite or are beyond +-2^40");
    if (l.used > 0) {
        fail_set(to, path, "dropped %s", l.text);
    }
    return l.used > 0;
}

static int say_ignored(const mesh_report *r, const char *path, fail *to) {
    const unsigned long long bytes = r->count[REPORT_LOOSE_BYTES];
    if (bytes > 0) {
        fail_set(to, path, "ignored %llu byte%s behind the data", bytes, bytes == 1 ? "" : "s");
    }
    return bytes > 0;
}

static int say_moved(const mesh_report *r, const char *path, fail *to) {
    if (r->moved > REPORT_MOVED_MOST) {
        fail_set(to, path,
                 "single precision moved corners by up to %.2g of an edge before their meshes were "
                 "placed, and %llu triangles lost an edge; use pack --centre to place them first",
                 r->moved, (unsigned long long)r->vanished);
    }
    return r->moved > REPORT_MOVED_MOST;
}

int report_line(const mesh_report *r, unsigned line, const char *path, fail *to) {
    static int (*const SAY[])(const mesh_report *, const char *, fail *) = {
        say_left_out, say_overlapping, say_miscount, say_habits,
        say_dropped,  say_ignored,     say_moved,
    };
    return line < sizeof SAY / sizeof SAY[0] ? SAY[line](r, path, to) : -1;
}
