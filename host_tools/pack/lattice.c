/* lattice - see lattice.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice.h"

#include <math.h>

static const float STEP_LEAST = 1.0e-30f; /* SPEC.md, R14 */

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

int lattice_grain(float x) {
    int exponent;
    const double mantissa = ldexp(frexp((double)fabsf(x), &exponent), 24); /* whole */
    uint32_t bits = (uint32_t)mantissa;
    if (bits == 0) {
        return LATTICE_NO_GRAIN;
    }
    for (exponent -= 24; bits % 2 == 0; bits /= 2) {
        exponent++;
    }
    return exponent;
}

double lattice_longest(const plt_box *b) {
    double longest = 0.0;
    for (int a = 0; a < 3; a++) {
        longest = fmax(longest, (double)b->hi[a] - (double)b->lo[a]);
    }
    return longest;
}

static double farthest(const plt_box *b) {
    double far = 0.0;
    for (int a = 0; a < 3; a++) {
        far = fmax(far, fmax(fabs((double)b->lo[a]), fabs((double)b->hi[a])));
    }
    return far;
}

/* ---- a step for the longest side ------------------------------------------------------- */

/* The step, its mantissa rounded up to 24 - bits bits; one number is kept for
 * rounding outwards. */
static float step_for(double longest, uint32_t bits) {
    int exponent;
    const double least = longest > 0.0 ? longest / (double)((1u << bits) - 2u) : 1.0;
    const double mantissa = ceil(ldexp(frexp(least, &exponent), 24 - (int)bits));
    return (float)ldexp(mantissa, exponent - (24 - (int)bits));
}

/* Different coordinates are different floats, whatever the origin is. */
static int fit(plt_lattice *l, const plt_box *b) {
    for (int a = 0; a < 3; a++) {
        l->origin[a] = b->lo[a];
    }
    l->step = step_for(lattice_longest(b), l->bits);
    return (double)l->step >= ldexp(farthest(b), -23);
}

/* ---- powers of two --------------------------------------------------------------------- */

/* The bits suffice for the box on multiples of 2^exponent. */
static int suffices(const plt_box *b, int exponent, uint32_t bits) {
    double most = 0.0;
    for (int a = 0; a < 3; a++) {
        const double lo = floor(ldexp((double)b->lo[a], -exponent));
        const double hi = ceil(ldexp((double)b->hi[a], -exponent));
        most = fmax(most, hi - lo);
    }
    return most <= (double)((1u << bits) - 1u);
}

/* Coordinates are floats as they are: whole numbers of less than 24 bits, and a step more. */
static int fit_power(plt_lattice *l, const plt_box *b, int exponent) {
    l->step = (float)ldexp(1.0, exponent);
    for (int a = 0; a < 3; a++) {
        l->origin[a] = (float)ldexp(floor(ldexp((double)b->lo[a], -exponent)), exponent);
    }
    return farthest(b) < ldexp(1.0, exponent + 24);
}

static int fit_exact(plt_lattice *l, const lattice_ground *g) {
    return g->grain != LATTICE_NO_GRAIN && ldexp(1.0, g->grain) > (double)STEP_LEAST &&
           suffices(&g->box, g->grain, l->bits) && fit_power(l, &g->box, g->grain);
}

static int shortest_power(const plt_box *b, uint32_t bits) {
    const double longest = lattice_longest(b);
    int exponent = 0;
    if (longest > 0.0) {
        frexp(longest / (double)(1u << bits), &exponent);
        exponent--; /* a power of two not above that: the loop ends after two rounds */
    }
    while (!suffices(b, exponent, bits)) {
        exponent++;
    }
    return exponent;
}

/* ---- the choice ------------------------------------------------------------------------ */

static int choose(plt_lattice *l, const lattice_ground *g, int power, uint32_t bits) {
    l->bits = bits;
    return fit_exact(l, g) ||
           (power ? fit_power(l, &g->box, shortest_power(&g->box, bits)) : fit(l, &g->box));
}

/* The most bits below those wished for that will do, with their lattice; 0: none. */
static uint32_t fewer_bits(plt_lattice *l, const lattice_ground *g, const lattice_wish *w) {
    for (uint32_t bits = w->bits - 1; bits >= PLT_LATTICE_BITS_LEAST; bits--) {
        if (choose(l, g, w->power, bits)) {
            return bits;
        }
    }
    return 0;
}

static int refuse(const lattice_wish *w, uint32_t fewer, const char *name, fail *f) {
    if (fewer == 0) {
        return fail_set(f, name,
                        "a lattice of %u bits is finer than floats are that far from the origin; "
                        "use --centre or --nodes thesis",
                        w->bits);
    }
    if (w->fewest) { /* no number of bits was asked for, but a tolerance */
        return fail_set(f, name,
                        "a lattice of %u bits is finer than floats are that far from the origin; "
                        "use --centre, --nodes thesis, or a larger --tolerance",
                        w->bits);
    }
    return fail_set(f, name,
                    "a lattice of %u bits is finer than floats are that far from the origin; use "
                    "--centre, --nodes thesis, or fewer bits (--geometry lattice:%u)",
                    w->bits, fewer);
}

int lattice_over(plt_lattice *lattice, const lattice_ground *ground, const lattice_wish *wish,
                 const char *name, fail *f) {
    lattice->origin[3] = 0.0f;
    lattice->bits = PLT_LATTICE_BITS_LEAST;
    while (wish->fewest && lattice->bits < wish->bits) {
        if (fit_exact(lattice, ground)) {
            return 0;
        }
        lattice->bits++;
    }
    const int fine = choose(lattice, ground, wish->power, wish->bits);
    if (!(lattice->step > STEP_LEAST)) {
        return fail_set(f, name,
                        "the mesh is too small for a lattice; scale it up: pack a text file, "
                        "scene.txt, with the line FILE 1 0 0 0, which makes it 1 long");
    }
    const uint32_t fewer = fine ? 0 : fewer_bits(lattice, ground, wish);
    return fine || (wish->boxes && fewer > 0) ? 0 : refuse(wish, fewer, name, f);
}
