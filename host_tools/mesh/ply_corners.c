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

static const char *const TEXCOORDS[][2] = {
    {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}, {"s0", "t0"}};

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

static int is_real(const ply_property *p) {
    return p != NULL && (p->type == PLY_FLOAT32 || p->type == PLY_FLOAT64);
}

ply_triple ply_find_texcoord(const ply_element *e) {
    for (size_t i = 0; i < sizeof TEXCOORDS / sizeof TEXCOORDS[0]; i++) {
        const ply_triple t = {{find(e, TEXCOORDS[i][0]), find(e, TEXCOORDS[i][1]), NULL}};
        if (is_real(t.property[0]) && is_real(t.property[1])) {
            return t;
        }
    }
    return (ply_triple){{NULL, NULL, NULL}};
}

const ply_property *ply_find_texcoord_list(const ply_element *e) {
    for (size_t i = 0; i < e->properties; i++) {
        const ply_property *p = &e->property[i];
        if (p->is_list && is_real(p) && word_is_in_any_case(p->name, "texcoord")) {
            return p;
        }
    }
    return NULL;
}

unsigned ply_triple_part(const ply_triple *t, const ply_property *p) {
    return p == t->property[0] ? 0 : p == t->property[1] ? 1 : p == t->property[2] ? 2 : 3;
}
