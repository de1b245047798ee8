/* report - see report.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/report.h"

#include <stddef.h>

/* Items that stand together in a sentence. */
enum group { LEFT_OUT, HABITS, DROPPED, GROUPS, ALONE };

static const struct {
    const char *key;
    enum group group;
    const char *one, *many; /* the words after a count */
} ITEMS[REPORT_ITEMS] = {
    [REPORT_SMALL_FACES] = {"small_faces", LEFT_OUT, "face of fewer than 3 corners",
                            "faces of fewer than 3 corners"},
    [REPORT_POINTS] = {"points", LEFT_OUT, "point", "points"},
    [REPORT_LINES] = {"lines", LEFT_OUT, "line", "lines"},
    [REPORT_CURVES] = {"curves", LEFT_OUT, "curve or free-form surface",
                       "curves and free-form surfaces"},
    [REPORT_COLOURS] = {"colours", LEFT_OUT, "colour", "colours"},
    [REPORT_NORMALS] = {"normals", LEFT_OUT, "normal", "normals"},
    [REPORT_TEXTURES] = {"texture_coordinates", LEFT_OUT, "texture coordinate",
                         "texture coordinates"},
    [REPORT_MATERIALS] = {"materials", LEFT_OUT, "use of a material", "uses of materials"},
    [REPORT_ELEMENTS] = {"other_elements", LEFT_OUT, "element of another kind",
                         "elements of other kinds"},
    [REPORT_UNREAD_LINES] = {"unread_lines", LEFT_OUT, "line of a keyword that is not read",
                             "lines of keywords that are not read"},
    [REPORT_OVERLAPPING] = {"overlapping_faces", ALONE, NULL, NULL},
    [REPORT_MISCOUNTED] = {"miscounted_triangles", ALONE, NULL, NULL},
    [REPORT_SWAPPED] = {"big_endian_triangles", HABITS, "triangle in big-endian order",
                        "triangles in big-endian order"},
    [REPORT_UNENDED] = {"unended_solids", HABITS, "solid without endsolid",
                        "solids without endsolid"},
    [REPORT_UNKNOWN_LINES] = {"unknown_header_lines", HABITS, "header line that is no PLY keyword",
                              "header lines that are no PLY keywords"},
    [REPORT_LOOSE_BYTES] = {"loose_bytes", ALONE, NULL, NULL},
    [REPORT_BAD_FACES] = {"dropped_faces", DROPPED, "face that cannot be traced",
                          "faces that cannot be traced"},
    [REPORT_BAD_VERTICES] = {"bad_vertices", DROPPED,
                             "vertex that is not finite or is beyond +-2^40",
                             "vertices that are not finite or are beyond +-2^40"},
    [REPORT_BAD_NORMALS] = {"bad_normals", DROPPED, "normal that is not finite or has no length",
                            "normals that are not finite or have no length"},
    [REPORT_BAD_COLOURS] = {"bad_colours", DROPPED, "colour that is out of range",
                            "colours that are out of range"},
    [REPORT_BAD_TEXTURES] = {"bad_texture_coordinates", DROPPED,
                             "texture coordinate that is not finite or is beyond +-65536",
                             "texture coordinates that are not finite or are beyond +-65536"},
};

const char *report_key(report_item item) {
    return ITEMS[item].key;
}

void report_add_miscount(mesh_report *r, report_miscount more) {
    r->miscount.files += more.files;
    r->miscount.counted += more.counted;
    r->miscount.held += more.held;
}

void report_count(const mesh_report *r, report_item item, count_list *to) {
    count_list_add(to, r->count[item], ITEMS[item].one, ITEMS[item].many);
}

static int say_group(const mesh_report *r, enum group group, const char *path, fail *to) {
    static const char *const HEADS[GROUPS] = {
        [LEFT_OUT] = "left out", [HABITS] = "read whole in spite of", [DROPPED] = "dropped"};
    count_list items = {"", 0};
    for (int i = 0; i < REPORT_ITEMS; i++) {
        if (ITEMS[i].group == group) {
            report_count(r, (report_item)i, &items);
        }
    }
    if (items.used > 0) {
        fail_set(to, path, "%s %s", HEADS[group], items.text);
    }
    return items.used > 0;
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
                 "placed, and %llu triangle%s lost an edge; use pack --centre to place them first",
                 r->moved, (unsigned long long)r->vanished, r->vanished == 1 ? "" : "s");
    }
    return r->moved > REPORT_MOVED_MOST;
}

int report_line(const mesh_report *r, unsigned line, const char *path, fail *to) {
    switch (line) {
    case 0:
        return say_group(r, LEFT_OUT, path, to);
    case 1:
        return say_overlapping(r, path, to);
    case 2:
        return say_miscount(r, path, to);
    case 3:
        return say_group(r, HABITS, path, to);
    case 4:
        return say_group(r, DROPPED, path, to);
    case 5:
        return say_ignored(r, path, to);
    case 6:
        return say_moved(r, path, to);
    default:
        return -1;
    }
}
