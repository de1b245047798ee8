/* mtl - reads the materials of a Wavefront library
 *
 * newmtl, Kd, Ks, Ke, Ns, Ni, d, Tr, Tf, illum and map_Kd; all other lines are passed over. illum 0
 * has no lights: its Kd glows; 1 has no highlights; from 3 on Ks is what a mirror reflects; 4, 6, 7
 * and 9 are glass, as is what has a d below 1 whatever its illum. Of glass Tf is what comes through
 * one unit of length (Beer's law). Values beyond the ranges of an image are brought into them.
 *
 * Source: Wavefront Technologies, Advanced Visualizer Manual, appendix B2, "MTL material format",
 * 1995.
 *
 * SPDX-License-Identifier: MIT */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/base/files.h"
#include "host_tools/base/heap.h"
#include "host_tools/mesh/mtl.h"
#include "host_tools/mesh/mtl_map.h"
#include "host_tools/mesh/scan.h"

enum { EXPONENT_MOST = 1024, ILLUM_MOST = 10 };
#define ABSORPTION_MOST 1048576.0f
#define INDEX_MOST 4.0f

/* What a library says of one material. */
typedef struct definition {
    material_values values; /* but for what is below */
    float filter[3], exponent, opacity;
    int illum, number; /* number: of the material; -1: none has begun */
} definition;

typedef struct library {
    mesh_materials *to;
    const char *path;
    scan text;
    definition d;
} library;

static float within(float x, float least, float most) {
    return x > least ? (x < most ? x : most) : least; /* of a NaN the least */
}

static void within_all(float *x, float most) {
    for (int i = 0; i < 3; i++) {
        x[i] = within(x[i], 0.0f, most);
    }
}

static void set_glass(const definition *d, material_values *v) {
    const int glass = d->illum == 4 || d->illum == 6 || d->illum == 7 || d->illum == 9;
    v->transparency = within(1.0f - d->opacity, 0.0f, 1.0f);
    if (glass && v->transparency == 0.0f) {
        v->transparency = 1.0f; /* it says so, and does not say how much */
    }
    v->index = v->transparency > 0.0f ? within(v->index, 1.0f, INDEX_MOST) : 1.0f;
    for (int c = 0; c < 3; c++) {
        const float passes = within(d->filter[c], 0.0f, 1.0f);
        v->absorption[c] =
            passes > 0.0f ? within(-logf(passes), 0.0f, ABSORPTION_MOST) : ABSORPTION_MOST;
    }
}

/* A definition ends, with the next or the file. */
static void finish(library *l) {
    definition *d = &l->d;
    material_values v = d->values;
    if (d->number < 0) {
        return;
    }
    within_all(v.diffuse, 1.0f);
    within_all(v.specular, 1.0f);
    within_all(v.emission, 1048576.0f);
    if (d->illum == 0) {
        memcpy(v.emission, v.diffuse, sizeof v.emission);
        memset(v.diffuse, 0, sizeof v.diffuse);
    }
    if (d->illum < 2) {
        memset(v.specular, 0, sizeof v.specular);
    }
    set_glass(d, &v);
    v.mirror = d->illum == 3 || d->illum == 5 || d->illum == 8 ? 1.0f : 0.0f;
    v.exponent = (uint32_t)within(roundf(d->exponent), 1.0f, (float)EXPONENT_MOST);
    l->to->material[d->number].values = v;
    l->to->material[d->number].is_defined = 1;
}

static int begin(library *l) {
    const word name = scan_rest(&l->text);
    finish(l);
    l->d = (definition){.values = material_none(),
                        .filter = {1, 1, 1},
                        .exponent = 1,
                        .opacity = 1,
                        .illum = 2,
                        .number = -1};
    l->d.values.diffuse[0] = l->d.values.diffuse[1] = l->d.values.diffuse[2] = 0.8f;
    if (name.length == 0) {
        return 0;
    }
    l->d.number = materials_find(l->to, name.text, name.length);
    if (l->d.number < 0) {
        return -1;
    }
    material_map *map = &l->to->material[l->d.number].map; /* of an earlier definition */
    heap_drop(map->path);
    map->path = NULL;
    return 0;
}

/* One number counts for all three, as a missing one does. */
static int read_numbers(scan *s, float *to, int count) {
    int read = 0;
    while (read < count && !scan_line_done(s) && scan_float(s, &to[read]) == 0) {
        read++;
    }
    for (int i = read; i < count && read > 0; i++) {
        to[i] = to[read - 1];
    }
    return read > 0;
}

static int read_value(library *l, word key) {
    definition *d = &l->d;
    float number;
    if (word_is(key, "Kd")) {
        return read_numbers(&l->text, d->values.diffuse, 3);
    }
    if (word_is(key, "Ks")) {
        return read_numbers(&l->text, d->values.specular, 3);
    }
    if (word_is(key, "Ke")) {
        return read_numbers(&l->text, d->values.emission, 3);
    }
    if (word_is(key, "Tf")) {
        return read_numbers(&l->text, d->filter, 3);
    }
    if (!word_is(key, "Ns") && !word_is(key, "Ni") && !word_is(key, "d") && !word_is(key, "Tr") &&
        !word_is(key, "illum")) {
        return 1;
    }
    if (!read_numbers(&l->text, &number, 1)) {
        return 0;
    }
    if (word_is(key, "Ns")) {
        d->exponent = number;
    } else if (word_is(key, "Ni")) {
        d->values.index = number;
    } else if (word_is(key, "illum")) {
        d->illum = (int)within(number, 0.0f, (float)ILLUM_MOST);
    } else {
        d->opacity = word_is(key, "d") ? number : 1.0f - number;
    }
    return 1;
}

/* map_Kd, and lines like it. -1: memory is out. */
static int read_map(library *l, word key, size_t line) {
    material_map none = {.path = NULL};
    material_map *to = l->d.number < 0 ? &none : &l->to->material[l->d.number].map;
    if (!word_is_in_any_case(key, "map_kd")) {
        return 0;
    }
    const int status = mtl_map_read(l->to, to, &l->text, l->path);
    if (status == 0) {
        materials_complain(l->to, l->path, "line %zu has no file behind '%.*s'", line,
                           WORD_SHOWN(key));
    }
    heap_drop(none.path);
    return status < 0 ? -1 : 0;
}

static int read_line(library *l) {
    const size_t line = l->text.line;
    if (scan_line_done(&l->text) || *l->text.at == '#') {
        return 0;
    }
    const word key = scan_word(&l->text);
    if (word_is(key, "newmtl")) {
        return begin(l);
    }
    if (mtl_map_is(l->to, key)) {
        return read_map(l, key, line);
    }
    if (!read_value(l, key)) {
        materials_complain(l->to, l->path, "line %zu has no number behind '%.*s'", line,
                           WORD_SHOWN(key));
    }
    return 0;
}

int mtl_read(mesh_materials *m, const input *in) {
    library l = {.to = m,
                 .path = in->path,
                 .text = scan_begin_filled(in->bytes, in->size),
                 .d = {.number = -1}};
    int status = 0;
    do {
        status = read_line(&l);
    } while (status == 0 && scan_next_line(&l.text));
    finish(&l);
    return status;
}

/* Where the OBJ lies: its path up to the last slash. */
static size_t folder_length(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash == NULL ? 0 : (size_t)(slash - path) + 1;
}

/* The path of a library beside `path`; owned. NULL: memory is out. */
static char *path_beside(const char *path, const char *name, size_t length) {
    const size_t folder = length > 0 && name[0] == '/' ? 0 : folder_length(path);
    char *file = heap_get(folder + length + 1);
    if (file != NULL) {
        memcpy(file, path, folder);
        memcpy(file + folder, name, length);
        file[folder + length] = '\0';
    }
    return file;
}

static int read_one(mesh_materials *m, const char *path, const char *name, size_t length) {
    const int wanted = materials_library(m, path, name, length);
    char *file = wanted > 0 ? path_beside(path, name, length) : NULL;
    input in = {0};
    fail f = {""};
    int status = 0;
    if (file == NULL) {
        return wanted != 0 ? -1 : 0;
    }
    if (length > 0 && strcmp(file, "-") != 0 && files_is_file(file) &&
        input_read(&in, file, &f) == 0) {
        status = mtl_read(m, &in);
    } else {
        materials_complain(m, path, "its material library '%.*s' cannot be read",
                           (int)(length < 80 ? length : 80), name);
    }
    input_free(&in);
    heap_drop(file);
    return status;
}

static int is_blank(char c) {
    return c == ' ' || c == '\t';
}

int mtl_read_beside(mesh_materials *m, const char *path, const char *names, size_t length) {
    char *whole = path_beside(path, names, length);
    if (whole == NULL) {
        return -1;
    }
    const int is_one = files_is_file(whole);
    size_t at = 0;
    int status = is_one || length == 0 ? read_one(m, path, names, length) : 0;
    while (!is_one && at < length && status == 0) {
        size_t end = at;
        for (; end < length && !is_blank(names[end]); end++) {
        }
        status = end > at ? read_one(m, path, names + at, end - at) : 0;
        at = end + 1;
    }
    heap_drop(whole);
    return status;
}
