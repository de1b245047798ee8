/* intake_corners - see intake_corners.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/intake_corners.h"

#include "host_tools/base/heap.h"

int corner_list_put(corner_list *l, size_t at, uint32_t item, uint32_t none) {
    if (at >= l->room) {
        const size_t room = at + at / 2 + 16;
        uint32_t *more = heap_resize(l->item, 4 * (uint64_t)room);
        if (more == NULL) {
            return -1;
        }
        l->item = more;
        l->room = room;
    }
    while (l->count < at) {
        l->item[l->count++] = none;
    }
    l->item[at] = item;
    l->count = at < l->count ? l->count : at + 1;
    return 0;
}

static uint32_t item_of(const corner_list *l, size_t at, uint32_t none) {
    return at < l->count ? l->item[at] : none;
}

/* Where in its list a corner's item is: `i` counts corners from the file's first. */
static size_t place_of(const intake_corners *in, int kind, const mesh *m, size_t first_vertex,
                       size_t first_triangle, size_t i) {
    return in->named[kind].count > 0 || in->is_numbered[kind]
               ? item_of(&in->named[kind], i, CORNER_UNNAMED)
               : m->triangle[3 * first_triangle + i] - first_vertex;
}

static int finish_normals(const intake_corners *in, const mesh *m, size_t first_vertex,
                          size_t first_triangle) {
    mesh_corners *c = m->corners;
    const size_t first = 3 * first_triangle;
    if (in->normal.count == 0) {
        return 0;
    }
    if (corners_want_normals(c, m->triangles) != 0) {
        return -1;
    }
    for (size_t i = first; i < 3 * m->triangles; i++) {
        const size_t at = place_of(in, NAMED_NORMAL, m, first_vertex, first_triangle, i - first);
        c->normal[i] = item_of(&in->normal, at, CORNER_NO_NORMAL);
        c->normals += c->normal[i] != CORNER_NO_NORMAL;
    }
    return 0;
}

static int finish_texcoords(const intake_corners *in, const mesh *m, size_t first_vertex,
                            size_t first_triangle) {
    mesh_corners *c = m->corners;
    const size_t first = 3 * first_triangle;
    if (in->texcoord[1].count == 0) {
        return 0;
    }
    if (corners_want_texcoords(c, m->triangles) != 0) {
        return -1;
    }
    for (size_t i = first; i < 3 * m->triangles; i++) {
        const size_t at = place_of(in, NAMED_TEXCOORD, m, first_vertex, first_triangle, i - first);
        c->texcoord[0][i] = item_of(&in->texcoord[0], at, CORNER_NO_TEXCOORD);
        c->texcoord[1][i] = item_of(&in->texcoord[1], at, CORNER_NO_TEXCOORD);
        c->texcoords += c->texcoord[0][i] != CORNER_NO_TEXCOORD;
    }
    return 0;
}

static int finish_colours(const intake_corners *in, const mesh *m, size_t first_vertex,
                          size_t first_triangle) {
    mesh_corners *c = m->corners;
    if (in->colour.count == 0) {
        return 0;
    }
    if (corners_want_colours(c, m->triangles) != 0) {
        return -1;
    }
    for (size_t i = 3 * first_triangle; i < 3 * m->triangles; i++) {
        c->colour[i] = item_of(&in->colour, m->triangle[i] - first_vertex, CORNER_NO_COLOUR);
        c->colours += c->colour[i] != CORNER_NO_COLOUR;
    }
    return 0;
}

int intake_corners_finish(const intake_corners *in, mesh *m, size_t first_vertex,
                          size_t first_triangle) {
    if (m->corners == NULL) {
        return 0;
    }
    return finish_normals(in, m, first_vertex, first_triangle) != 0 ||
                   finish_texcoords(in, m, first_vertex, first_triangle) != 0
               ? -1
               : finish_colours(in, m, first_vertex, first_triangle);
}

void intake_corners_free(intake_corners *in) {
    heap_drop(in->normal.item);
    heap_drop(in->colour.item);
    for (int k = 0; k < 2; k++) {
        heap_drop(in->texcoord[k].item);
    }
    for (int k = 0; k < CORNER_NAMES; k++) {
        heap_drop(in->named[k].item);
    }
    *in = (intake_corners){.normal = {NULL, 0, 0}};
}
