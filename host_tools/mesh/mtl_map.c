/* mtl_map - see mtl_map.h
 *
 * Of the options -s and -o say how the picture lies, -clamp whether it repeats; a second and a
 * third number may be missing, and the file's name may be a number itself. Readers step over
 * others.
 *
 * Source: as mtl.c.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/mtl_map.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/base/files.h"
#include "host_tools/base/heap.h"

/* Maps and options that are left out, in the order of the bits of maps_left; names in lower case,
 * as some write map_Bump. */
static const char *const left[] = {
    "map_ka", "map_ks", "map_ke",   "map_ns", "map_d",    "map_tr", "map_bump", "bump",     "disp",
    "decal",  "refl",   "norm",     "map_kn", "map_refl", "map_pr", "map_pm",   "map_disp", "-t",
    "-mm",    "-boost", "-imfchan", "-cc",    "-bm",      "-type",  "-blendu",  "-blendv",
};
enum { LEFT = sizeof left / sizeof left[0], FIRST_OPTION = 17 };

_Static_assert(LEFT <= 32, "a bit each");

static int find(word w, unsigned first, unsigned end) {
    for (unsigned i = first; i < end; i++) {
        if (word_is_in_any_case(w, left[i])) {
            return (int)i;
        }
    }
    return -1;
}

const char *materials_map_left(unsigned bit) {
    return bit < LEFT ? left[bit] : NULL;
}

int mtl_map_is(mesh_materials *m, word key) {
    const int bit = find(key, 0, FIRST_OPTION);
    if (bit >= 0) {
        m->maps_left |= 1u << bit;
    }
    return bit >= 0 || word_is_in_any_case(key, "map_kd");
}

/* Up to three numbers, finite ones; the last word of a line is the file's name. */
static void read_numbers(scan *s, float to[3]) {
    for (int i = 0; i < 3; i++) {
        scan ahead = *s;
        float number;
        if (scan_line_done(&ahead) || scan_float(&ahead, &number) != 0 || !isfinite(number) ||
            scan_line_done(&ahead)) {
            return;
        }
        to[i] = number;
        *s = ahead;
    }
}

static int is_on(scan *s) {
    return word_is_in_any_case(scan_word(s), "on");
}

/* 1: the word that follows is an option, and was read. */
static int read_option(mesh_materials *m, material_map *to, scan *s) {
    scan ahead = *s;
    const word option = scan_word(&ahead);
    float passed[3], *numbers = NULL;
    const int bit = find(option, FIRST_OPTION, LEFT);
    if (word_is(option, "-s")) {
        numbers = to->scale;
    } else if (word_is(option, "-o")) {
        numbers = to->offset;
    } else if (bit >= 0 && (word_is(option, "-t") || word_is(option, "-mm"))) {
        numbers = passed;
    }
    if (numbers == NULL && bit < 0 && !word_is(option, "-clamp") && !word_is(option, "-texres")) {
        return 0;
    }
    *s = ahead;
    if (numbers != NULL) {
        read_numbers(s, numbers);
    } else if (word_is(option, "-clamp")) {
        to->clamp = is_on(s);
    } else {
        scan_word(s);
    }
    m->maps_left |= bit >= 0 ? 1u << bit : 0u;
    return 1;
}

/* Some write DIR\FILE.png: with slashes if there is such a file, and none as it is written. */
static void mend_slashes(char *file, size_t folder) {
    if (strchr(file + folder, '\\') == NULL || files_is_file(file)) {
        return;
    }
    for (char *at = file + folder; *at != '\0'; at++) {
        *at = *at == '\\' ? '/' : *at;
    }
}

static char *path_of(const char *library, const char *name, size_t length) {
    const char *slash = strrchr(library, '/');
    const size_t folder = slash == NULL || name[0] == '/' ? 0 : (size_t)(slash - library) + 1;
    char *file = heap_get(folder + length + 1);
    if (file != NULL) {
        memcpy(file, library, folder);
        memcpy(file + folder, name, length);
        file[folder + length] = '\0';
        mend_slashes(file, folder);
    }
    return file;
}

int mtl_map_read(mesh_materials *m, material_map *to, scan *text, const char *path) {
    heap_drop(to->path);
    *to = (material_map){.path = NULL, .scale = {1, 1, 1}};
    while (!scan_line_done(text) && read_option(m, to, text)) {
    }
    const word name = scan_rest(text);
    if (name.length == 0) {
        return 0;
    }
    to->path = path_of(path, name.text, name.length);
    return to->path != NULL ? 1 : -1;
}
