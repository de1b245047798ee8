/* corners - see corners.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/corners.h"

#include <math.h>

#include "engine/base/float_bits.h"
#include "host_tools/base/heap.h"

static const double LARGEST = 32767.0;

static uint32_t bits_of(double at) {
    return (uint32_t)(int32_t)lrint(at * LARGEST) & 0xFFFFu;
}

static double number_of(uint32_t bits) {
    return (double)(int16_t)(uint16_t)bits / LARGEST;
}

static double sign_of(double x) {
    return x < 0 ? -1.0 : 1.0;
}

uint32_t corner_normal(const double n[3]) {
    const double most = fmax(fabs(n[0]), fmax(fabs(n[1]), fabs(n[2])));
    const double x = n[0] / most, y = n[1] / most, z = n[2] / most;
    const double sum = fabs(x) + fabs(y) + fabs(z);
    const double u = x / sum, v = y / sum;
    return z < 0 ? bits_of((1 - fabs(v)) * sign_of(u)) | bits_of((1 - fabs(u)) * sign_of(v)) << 16
                 : bits_of(u) | bits_of(v) << 16;
}

void corner_direction(uint32_t normal, double n[3]) {
    const double u = number_of(normal & 0xFFFFu), v = number_of(normal >> 16);
    n[2] = 1 - fabs(u) - fabs(v);
    n[0] = n[2] < 0 ? (1 - fabs(v)) * sign_of(u) : u;
    n[1] = n[2] < 0 ? (1 - fabs(u)) * sign_of(v) : v;
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int a = 0; a < 3; a++) {
        n[a] /= length;
    }
}

static int want(uint32_t **items, size_t before, size_t triangles, uint32_t none) {
    uint32_t *more = heap_resize(*items, 12 * (uint64_t)(triangles > 0 ? triangles : 1));
    if (more == NULL) {
        return -1;
    }
    for (size_t i = 3 * before; i < 3 * triangles; i++) {
        more[i] = none;
    }
    *items = more;
    return 0;
}

enum { NORMALS = 1, COLOURS = 2, TEXCOORDS = 4 };

/* Those that are there, and these. */
static int want_all(mesh_corners *c, size_t triangles, unsigned more) {
    const struct {
        uint32_t **items, none;
        unsigned kind;
    } lists[] = {{&c->normal, CORNER_NO_NORMAL, NORMALS},
                 {&c->colour, CORNER_NO_COLOUR, COLOURS},
                 {&c->texcoord[0], CORNER_NO_TEXCOORD, TEXCOORDS},
                 {&c->texcoord[1], CORNER_NO_TEXCOORD, TEXCOORDS}};
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        const int is_there = *lists[i].items != NULL;
        if ((is_there || (more & lists[i].kind) != 0) &&
            want(lists[i].items, is_there ? c->triangles : 0, triangles, lists[i].none) != 0) {
            return -1;
        }
    }
    c->triangles = triangles;
    return 0;
}

int corners_want_normals(mesh_corners *c, size_t triangles) {
    return want_all(c, triangles, NORMALS);
}

int corners_want_colours(mesh_corners *c, size_t triangles) {
    return want_all(c, triangles, COLOURS);
}

int corners_want_texcoords(mesh_corners *c, size_t triangles) {
    return want_all(c, triangles, TEXCOORDS);
}

uint32_t corner_texcoord(double coordinate) {
    return plt_bits_of((float)coordinate + 0.0f); /* -0 is 0 */
}

void corners_free(mesh_corners *c) {
    heap_drop(c->normal);
    heap_drop(c->colour);
    heap_drop(c->texcoord[0]);
    heap_drop(c->texcoord[1]);
    c->normal = c->colour = c->texcoord[0] = c->texcoord[1] = NULL;
    c->triangles = 0;
}
