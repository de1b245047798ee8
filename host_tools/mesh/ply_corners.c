/* ply_corners - see ply_corners.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/ply_corners.h"

#include <stddef.h>

enum { NAMES = 3 };

static const char *const NORMALS[NAMES][3] = {
    {"nx", "ny", "nz"}, {"normal_x", "normal_y", "normal_z"}, {"normalx", "normaly", "normalz"}};
static const char *const COLOURS[NAMES][3] = {
    {"red", "green", "blue"}, {"diffuse_red", "diffuse_green", "diffuse_blue"}, {"r", "g", "b"}};

static const ply_property *find(const ply_element *e, const char *name) {
    for (size_t i = 0; i < e->properties; i++) {
        if (!e->property[i].is_list && word_is_in_any_case(e->property[i].name, name)) {
            return &e->property[i];
        }
    }
    return NULL;
}

static ply_triple find_triple(const ply_element *e, const char *const names[NAMES][3]) {
    for (int i = 0; i < NAMES; i++) {
        const ply_triple t = {{find(e, names[i][0]), find(e, names[i][1]), find(e, names[i][2])}};
        if (t.property[0] != NULL && t.property[1] != NULL && t.property[2] != NULL) {
            return t;
        }
    }
    return (ply_triple){{NULL, NULL, NULL}};
}

ply_triple ply_find_normal(const ply_element *e) {
    return find_triple(e, NORMALS);
}

double ply_colour_most(ply_type type) {
    return type == PLY_UINT8 ? 255 : type == PLY_UINT16 ? 65535 : 1;
}

ply_triple ply_find_colour(const ply_element *e) {
    const ply_triple t = find_triple(e, COLOURS), none = {{NULL, NULL, NULL}};
    if (t.property[0] == NULL) {
        return none;
    }
    const ply_type type = t.property[0]->type;
    const int known =
        type == PLY_UINT8 || type == PLY_UINT16 || type == PLY_FLOAT32 || type == PLY_FLOAT64;
    return known && t.property[1]->type == type && t.property[2]->type == type ? t : none;
}

unsigned ply_triple_part(const ply_triple *t, const ply_property *p) {
    return p == t->property[0] ? 0 : p == t->property[1] ? 1 : p == t->property[2] ? 2 : 3;
}
