/* lattice_boxes - see lattice_boxes.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice_boxes.h"

#include <math.h>

/* The coordinate whose float is the last one not above `x`, or the first not below. */
static uint32_t round_outwards(const plt_lattice *l, int axis, float x, int up) {
    const double near = ((double)x - (double)l->origin[axis]) / (double)l->step;
    uint32_t q = (uint32_t)fmax(0.0, floor(near));
    while (q > 0 && plt_lattice_float(l, axis, q) > x) {
        q--;
    }
    while (plt_lattice_float(l, axis, q + 1) <= x) {
        q++;
    }
    return q + (uint32_t)(up && plt_lattice_float(l, axis, q) < x);
}

static void add_box(snapped *s, const mesh *m, size_t i) {
    lattice_position p[3];
    for (int a = 0; a < 3; a++) {
        float lo = INFINITY, hi = -INFINITY;
        for (size_t c = 0; c < 3; c++) {
            const float x = m->vertex[3 * (size_t)m->triangle[3 * i + c] + (size_t)a];
            lo = x < lo ? x : lo;
            hi = x > hi ? x : hi;
        }
        p[0].q[a] = round_outwards(&s->lattice, a, lo, 0);
        p[1].q[a] = round_outwards(&s->lattice, a, hi, 1);
    }
    snapped_add(s, p, 2, (uint32_t)i);
}

int lattice_boxes(snapped *s, const mesh *m, const lattice_wish *wish, const char *name, fail *f) {
    if (snapped_begin(s, m, wish, 1, name, f) != 0) {
        return -1;
    }
    if (snapped_make_room(s, m->triangles, 2) != 0) {
        return fail_set(f, name, "out of memory; pack on a larger machine");
    }
    for (size_t i = 0; i < m->triangles; i++) {
        add_box(s, m, i);
    }
    return 0;
}
