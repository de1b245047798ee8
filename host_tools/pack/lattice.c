/* lattice - see lattice.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/image/bytes.h"

typedef struct position {
    uint32_t q[3];
} position;

/* Of a vertex that no triangle uses: it may lie anywhere and counts for nothing. */
#define UNUSED UINT32_MAX

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
static void used_box(const mesh *m, float lo[3], float hi[3]) {
    for (int a = 0; a < 3; a++) {
        lo[a] = m->triangles > 0 ? m->vertex[3 * (size_t)m->triangle[0] + (size_t)a] : 0.0f;
        hi[a] = lo[a];
    }
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        const float *p = m->vertex + 3 * (size_t)m->triangle[i];
        for (int a = 0; a < 3; a++) {
            lo[a] = p[a] < lo[a] ? p[a] : lo[a];
            hi[a] = p[a] > hi[a] ? p[a] : hi[a];
        }
    }
}

/* The step, its mantissa rounded up to 24 - bits bits; one number is kept for
 * rounding outwards. */
static float step_for(double longest, uint32_t bits) {
    int exponent;
    const double least = longest > 0.0 ? longest / (double)((1u << bits) - 2u) : 1.0;
    const double mantissa = ceil(ldexp(frexp(least, &exponent), 24 - (int)bits));
    return (float)ldexp(mantissa, exponent - (24 - (int)bits));
}

static int set_lattice(snapped *s, const mesh *m, uint32_t bits, const char *name, fail *f) {
    float lo[3], hi[3];
    double longest = 0.0, farthest = 0.0;
    used_box(m, lo, hi);
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

static position snap(const snapped *s, const float p[3]) {
    const uint32_t most = (1u << s->lattice.bits) - 1u;
    position r;
    for (int a = 0; a < 3; a++) {
        const double q =
            floor(((double)p[a] - (double)s->lattice.origin[a]) / (double)s->lattice.step + 0.5);
        r.q[a] = q > (double)most ? most : (uint32_t)q;
    }
    return r;
}

static void cross(const position p[3], int64_t c[3]) {
    int64_t e[3], g[3];
    for (int a = 0; a < 3; a++) {
        e[a] = (int64_t)p[1].q[a] - (int64_t)p[0].q[a];
        g[a] = (int64_t)p[2].q[a] - (int64_t)p[0].q[a];
    }
    for (int a = 0; a < 3; a++) {
        c[a] = e[(a + 1) % 3] * g[(a + 2) % 3] - e[(a + 2) % 3] * g[(a + 1) % 3];
    }
}

static int same(const position *a, const position *b) {
    return memcmp(a, b, sizeof *a) == 0;
}

/* Has area in double, as it was in the mesh? */
static int had_area(const mesh *m, size_t i) {
    double p[3][3], e[3], g[3];
    for (size_t c = 0; c < 3; c++) {
        for (size_t a = 0; a < 3; a++) {
            p[c][a] = (double)m->vertex[3 * (size_t)m->triangle[3 * i + c] + a];
        }
    }
    for (int a = 0; a < 3; a++) {
        e[a] = p[1][a] - p[0][a];
        g[a] = p[2][a] - p[0][a];
    }
    return e[1] * g[2] != e[2] * g[1] || e[2] * g[0] != e[0] * g[2] || e[0] * g[1] != e[1] * g[0];
}

static void put(snapped *s, const position *p, int positions) {
    unsigned char *at = s->corners + (size_t)s->count * 3 * (size_t)positions * s->width;
    for (int k = 0; k < 3 * positions; k++, at += s->width) {
        const uint32_t q = p[k / 3].q[k % 3];
        if (s->width == 2) {
            at[0] = (unsigned char)q;
            at[1] = (unsigned char)(q >> 8);
        } else {
            plt_put_u32(at, q);
        }
    }
}

static void grow(plt_lattice_box *b, const position *p) {
    for (int a = 0; a < 3; a++) {
        b->lo[a] = p->q[a] < b->lo[a] ? p->q[a] : b->lo[a];
        b->hi[a] = p->q[a] > b->hi[a] ? p->q[a] : b->hi[a];
    }
}

/* The turn (numbers.h) of corners whose least one comes first. */
static uint8_t turn_of(const position p[3]) {
    unsigned least = 0;
    for (unsigned c = 1; c < 3; c++) {
        int a = 0;
        while (a < 2 && p[c].q[a] == p[least].q[a]) {
            a++;
        }
        least = p[c].q[a] < p[least].q[a] ? c : least;
    }
    return (uint8_t)((3 - least) % 3);
}

static void take(snapped *s, const mesh *m, const position *moved, size_t i) {
    position p[3];
    int64_t c[3];
    for (size_t k = 0; k < 3; k++) {
        p[k] = moved[m->triangle[3 * i + k]];
    }
    cross(p, c);
    if (c[0] == 0 && c[1] == 0 && c[2] == 0) {
        const int before = !had_area(m, i);
        s->loss.flat_before += (uint64_t)before;
        s->loss.flat_now += (uint64_t)!before;
        s->loss.t_junctions += !same(&p[0], &p[1]) && !same(&p[1], &p[2]) && !same(&p[0], &p[2]);
        return;
    }
    put(s, p, 3);
    s->source[s->count] = (uint32_t)i;
    s->turn[s->count] = turn_of(p);
    s->count++;
    for (int k = 0; k < 3; k++) {
        grow(&s->box, &p[k]);
    }
}

/* Counts positions, before or after: sorts keys and steps over equals. */
static int compare_positions(const void *a, const void *b) {
    return memcmp(a, b, 12);
}

static uint64_t count_different(void *keys, size_t count) {
    uint64_t different = count > 0;
    const unsigned char *k = keys;
    qsort(keys, count, 12, compare_positions);
    for (size_t i = 1; i < count; i++) {
        different += memcmp(k + 12 * i, k + 12 * (i - 1), 12) != 0;
    }
    return different;
}

static int measure(snapped *s, const mesh *m, const position *moved) {
    uint32_t(*before)[3] = malloc(m->vertices * 12 + 1), (*after)[3] = malloc(m->vertices * 12 + 1);
    const double step = (double)s->lattice.step;
    double longest = 0.0, largest = 0.0;
    if (before == NULL || after == NULL) {
        free(before);
        free(after);
        return -1;
    }
    size_t used = 0;
    for (size_t i = 0; i < m->vertices; i++) {
        double far2 = 0.0;
        if (moved[i].q[0] == UNUSED) {
            continue;
        }
        for (int a = 0; a < 3; a++) {
            const float p = m->vertex[3 * i + (size_t)a] + 0.0f; /* -0 is 0 */
            const double d = (double)p - ((double)s->lattice.origin[a] + step * moved[i].q[a]);
            memcpy(&before[used][a], &p, 4);
            after[used][a] = moved[i].q[a];
            far2 += d * d;
        }
        largest = fmax(largest, far2);
        used++;
    }
    for (int a = 0; a < 3; a++) {
        longest = fmax(longest, step * (double)(s->box.hi[a] - s->box.lo[a]));
    }
    s->loss.largest_move = longest > 0.0 ? sqrt(largest) / longest : 0.0;
    s->loss.merged = count_different(before, used) - count_different(after, used);
    free(before);
    free(after);
    return 0;
}

/* Where each vertex goes that a triangle uses. */
static void snap_all(const snapped *s, const mesh *m, position *moved) {
    for (size_t i = 0; i < m->vertices; i++) {
        moved[i].q[0] = UNUSED;
    }
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        const size_t vertex = m->triangle[i];
        if (moved[vertex].q[0] == UNUSED) {
            moved[vertex] = snap(s, m->vertex + 3 * vertex);
        }
    }
}

/* The lattice, and room for `numbers` of it a triangle. */
static int begin(snapped *s, const mesh *m, uint32_t bits, size_t numbers, const char *name,
                 fail *f) {
    const plt_lattice_box empty = {{UINT32_MAX, UINT32_MAX, UINT32_MAX}, {0, 0, 0}};
    memset(s, 0, sizeof *s);
    s->box = empty;
    if (set_lattice(s, m, bits, name, f) != 0) {
        return -1;
    }
    s->width = bits <= 16 ? 2 : 4;
    s->corners = malloc(m->triangles * numbers * s->width + 1);
    s->source = malloc(m->triangles * sizeof *s->source + 1);
    if (s->corners == NULL || s->source == NULL) {
        return fail_set(f, name, "out of memory; pack on a larger machine");
    }
    return 0;
}

int lattice_snap(snapped *s, const mesh *m, uint32_t bits, const char *name, fail *f) {
    if (begin(s, m, bits, 9, name, f) != 0) {
        return -1;
    }
    s->turn = malloc(m->triangles + 1);
    position *moved = malloc(m->vertices * sizeof *moved + 1);
    int status = 0;
    if (s->turn == NULL || moved == NULL) {
        status = fail_set(f, name, "out of memory; pack on a larger machine");
    } else {
        snap_all(s, m, moved);
        for (size_t i = 0; i < m->triangles; i++) {
            take(s, m, moved, i);
        }
        if (measure(s, m, moved) != 0) {
            status = fail_set(f, name, "out of memory; pack on a larger machine");
        }
    }
    free(moved);
    return status;
}

/* The number whose float is the last one not above `x`, or the first not below. */
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

static void take_box(snapped *s, const mesh *m, size_t i) {
    position p[3];
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
    put(s, p, 2);
    s->source[s->count++] = (uint32_t)i;
    grow(&s->box, &p[0]);
    grow(&s->box, &p[1]);
}

int lattice_boxes(snapped *s, const mesh *m, uint32_t bits, const char *name, fail *f) {
    if (begin(s, m, bits, 6, name, f) != 0) {
        return -1;
    }
    for (size_t i = 0; i < m->triangles; i++) {
        take_box(s, m, i);
    }
    return 0;
}

void lattice_free(snapped *s) {
    free(s->corners);
    free(s->source);
    free(s->turn);
    s->corners = NULL;
    s->source = NULL;
    s->turn = NULL;
}
