/* lattice - see lattice.h, and lattice_parts.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/bytes.h"

uint32_t lattice_bits_for(double tolerance) {
    for (uint32_t bits = PLT_LATTICE_BITS_LEAST; bits <= PLT_LATTICE_BITS_MOST; bits++) {
        /* The longest step that step_for may choose, for a longest side of 1. */
        const double step = (1.0 + ldexp(1.0, (int)bits - 23)) / (double)((1u << bits) - 2u);
        if (0.5 * sqrt(3.0) * step <= tolerance) {
            return bits;
        }
    }
    return 0;
}

/* The box of the vertices that triangles use; an empty mesh gives 0, 0. */
static plt_box used_box(const mesh *m) {
    const plt_box nothing = {{0, 0, 0}, {0, 0, 0}};
    plt_box b = plt_box_empty();
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        plt_box_add_point(&b, m->vertex + 3 * (size_t)m->triangle[i]);
    }
    return m->triangles > 0 ? b : nothing;
}

/* The step, its mantissa rounded up to 24 - bits bits; one number is kept for
 * rounding outwards. */
static float step_for(double longest, uint32_t bits) {
    int exponent;
    const double least = longest > 0.0 ? longest / (double)((1u << bits) - 2u) : 1.0;
    const double mantissa = ceil(ldexp(frexp(least, &exponent), 24 - (int)bits));
    return (float)ldexp(mantissa, exponent - (24 - (int)bits));
}

static int set_lattice(snapped *s, uint32_t bits, const char *name, fail *f) {
    const float *lo = s->mesh_box.lo, *hi = s->mesh_box.hi;
    double longest = 0.0, farthest = 0.0;
    for (int a = 0; a < 3; a++) {
        s->lattice.origin[a] = lo[a];
        longest = fmax(longest, (double)hi[a] - (double)lo[a]);
        farthest = fmax(farthest, fmax(fabs((double)lo[a]), fabs((double)hi[a])));
    }
    s->lattice.bits = bits;
    s->lattice.step = step_for(longest, bits);
    if (!(s->lattice.step > 1.0e-30f)) {
        return fail_set(f, name, "the mesh is too small for a lattice; scale it up");
    }
    if ((double)s->lattice.step < ldexp(farthest, -23)) {
        return fail_set(f, name,
                        "a lattice of %u bits is finer than floats are that far from the origin; "
                        "use fewer bits (--geometry lattice:N) or --nodes thesis, or move the mesh "
                        "to the origin",
                        bits);
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

void lattice_add(snapped *s, const lattice_position *p, uint32_t positions, uint32_t source) {
    unsigned char *at = s->corners + (size_t)s->count * 3 * positions * s->width;
    for (uint32_t k = 0; k < 3 * positions; k++, at += s->width) {
        const uint32_t a = k % 3, q = p[k / 3].q[a];
        put(s, at, q);
        s->box.lo[a] = q < s->box.lo[a] ? q : s->box.lo[a];
        s->box.hi[a] = q > s->box.hi[a] ? q : s->box.hi[a];
    }
    s->source[s->count++] = source;
}

int lattice_begin(snapped *s, const mesh *m, uint32_t bits, uint32_t positions, const char *name,
                  fail *f) {
    const plt_lattice_box empty = {{UINT32_MAX, UINT32_MAX, UINT32_MAX}, {0, 0, 0}};
    memset(s, 0, sizeof *s);
    s->box = empty;
    s->mesh_box = used_box(m);
    if (set_lattice(s, bits, name, f) != 0) {
        return -1;
    }
    s->width = bits <= 16 ? 2 : 4;
    s->corners = malloc(m->triangles * 3 * positions * s->width + 1);
    s->source = malloc(m->triangles * sizeof *s->source + 1);
    if (s->corners == NULL || s->source == NULL) {
        return fail_set(f, name, "out of memory; pack on a larger machine");
    }
    return 0;
}

void lattice_free(snapped *s) {
    free(s->corners);
    free(s->source);
    free(s->rotation);
    s->corners = NULL;
    s->source = NULL;
    s->rotation = NULL;
}
