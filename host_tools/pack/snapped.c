/* snapped - see snapped.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/snapped.h"

#include <stdlib.h>
#include <string.h>

#include "engine/base/bytes.h"
#include "engine/image/items.h"
#include "host_tools/pack/lattice.h"

/* The box of the vertices that triangles use; an empty mesh gives 0, 0. */
static plt_box used_box(const mesh *m) {
    const plt_box nothing = {{0, 0, 0}, {0, 0, 0}};
    plt_box b = plt_box_empty();
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        plt_box_add_point(&b, m->vertex + 3 * (size_t)m->triangle[i]);
    }
    return m->triangles > 0 ? b : nothing;
}

int snapped_begin(snapped *s, const mesh *m, uint32_t bits, uint32_t positions, const char *name,
                  fail *f) {
    const plt_lattice_box empty = {{UINT32_MAX, UINT32_MAX, UINT32_MAX}, {0, 0, 0}};
    memset(s, 0, sizeof *s);
    s->box = empty;
    s->mesh_box = used_box(m);
    if (lattice_over(&s->lattice, &s->mesh_box, bits, name, f) != 0) {
        return -1;
    }
    s->width = plt_corner_width(bits);
    s->corners = malloc(m->triangles * 3 * positions * s->width + 1);
    s->source = malloc(m->triangles * sizeof *s->source + 1);
    if (s->corners == NULL || s->source == NULL) {
        return fail_set(f, name, "out of memory; pack on a larger machine");
    }
    return 0;
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
    free(s->corners);
    free(s->source);
    free(s->rotation);
    s->corners = NULL;
    s->source = NULL;
    s->rotation = NULL;
}
