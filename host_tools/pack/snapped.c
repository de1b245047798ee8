/* snapped - see snapped.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/snapped.h"

#include <string.h>

#include "engine/base/bytes.h"
#include "engine/image/items.h"
#include "host_tools/base/heap.h"
#include "host_tools/mesh/extent.h"

/* The grain of the corners of triangles that count (extent.h), or of all. */
static int grain_of(const mesh *m, const plt_box *box, int all) {
    int grain = LATTICE_NO_GRAIN;
    for (size_t i = 0; i < m->triangles; i++) {
        for (size_t k = 0; k < 9 && (all || k > 0 || mesh_counts(m, box, i)); k++) {
            const int of = lattice_grain(m->vertex[3 * (size_t)m->triangle[3 * i + k / 3] + k % 3]);
            grain = of < grain ? of : grain;
        }
    }
    return grain;
}

static lattice_ground ground_of(const mesh *m, int all) {
    const plt_box nothing = {{0, 0, 0}, {0, 0, 0}};
    lattice_ground g = {all ? mesh_box(m) : mesh_area_box(m), LATTICE_NO_GRAIN};
    g.grain = grain_of(m, &g.box, all);
    if (g.box.lo[0] > g.box.hi[0]) {
        g.box = nothing;
    }
    return g;
}

int snapped_begin(snapped *s, const mesh *m, const lattice_wish *wish, int are_boxes,
                  const char *name, fail *f) {
    const plt_lattice_box empty = {{UINT32_MAX, UINT32_MAX, UINT32_MAX}, {0, 0, 0}};
    const lattice_ground ground = ground_of(m, are_boxes);
    memset(s, 0, sizeof *s);
    s->box = empty;
    s->mesh_box = ground.box;
    if (lattice_over(&s->lattice, &ground, wish, name, f) != 0) {
        return -1;
    }
    s->loss.bits = s->lattice.bits;
    s->loss.step = s->lattice.step;
    s->width = plt_corner_width(s->lattice.bits);
    return 0;
}

int snapped_make_room(snapped *s, size_t triangles, uint32_t positions) {
    s->corners = heap_get((uint64_t)triangles * 3 * positions * s->width);
    s->source = heap_get((uint64_t)triangles * sizeof *s->source);
    s->rotation = positions == 3 ? heap_get(triangles) : NULL;
    return s->corners == NULL || s->source == NULL || (positions == 3 && s->rotation == NULL) ? -1
                                                                                              : 0;
}

static void put(const snapped *s, unsigned char *at, uint32_t q) {
    if (s->width == 2) {
        at[0] = (unsigned char)q;
        at[1] = (unsigned char)(q >> 8);
    } else {
        plt_put_u32(at, q);
    }
}

void snapped_add(snapped *s, const lattice_position *p, uint32_t positions, uint32_t source) {
    unsigned char *at = s->corners + (size_t)s->count * 3 * positions * s->width;
    for (uint32_t k = 0; k < 3 * positions; k++, at += s->width) {
        const uint32_t a = k % 3, q = p[k / 3].q[a];
        put(s, at, q);
        s->box.lo[a] = q < s->box.lo[a] ? q : s->box.lo[a];
        s->box.hi[a] = q > s->box.hi[a] ? q : s->box.hi[a];
    }
    s->source[s->count++] = source;
}

void snapped_free(snapped *s) {
    heap_drop(s->corners);
    heap_drop(s->source);
    heap_drop(s->rotation);
    s->corners = NULL;
    s->source = NULL;
    s->rotation = NULL;
}
