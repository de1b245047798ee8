/* lattice - see lattice.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice.h"

#include <math.h>

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

/* The step, its mantissa rounded up to 24 - bits bits; one number is kept for
 * rounding outwards. */
static float step_for(double longest, uint32_t bits) {
    int exponent;
    const double least = longest > 0.0 ? longest / (double)((1u << bits) - 2u) : 1.0;
    const double mantissa = ceil(ldexp(frexp(least, &exponent), 24 - (int)bits));
    return (float)ldexp(mantissa, exponent - (24 - (int)bits));
}

int lattice_over(plt_lattice *lattice, const plt_box *box, uint32_t bits, const char *name,
                 fail *f) {
    const float *lo = box->lo, *hi = box->hi;
    double longest = 0.0, farthest = 0.0;
    for (int a = 0; a < 3; a++) {
        lattice->origin[a] = lo[a];
        longest = fmax(longest, (double)hi[a] - (double)lo[a]);
        farthest = fmax(farthest, fmax(fabs((double)lo[a]), fabs((double)hi[a])));
    }
    lattice->bits = bits;
    lattice->step = step_for(longest, bits);
    if (!(lattice->step > 1.0e-30f)) {
        return fail_set(f, name, "the mesh is too small for a lattice; scale it up");
    }
    if ((double)lattice->step < ldexp(farthest, -23)) {
        return fail_set(f, name,
                        "a lattice of %u bits is finer than floats are that far from the origin; "
                        "use fewer bits (--geometry lattice:N) or --nodes thesis, or move the mesh "
                        "to the origin",
                        bits);
    }
    return 0;
}
