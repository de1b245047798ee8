/* surface_lanes - the colours of four hits at once, as surface.c has them, bit for bit
 *
 * Eye-light shading alone. Signs of a direction do not matter there: its dot products are squared,
 * and negating it negates each of their terms exactly.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_SURFACE_LANES_H
#define PLT_SHADE_SURFACE_LANES_H

#include "engine/lanes/lanes.h"
#include "engine/shade/surface.h"

static inline f4 plt_surface_dot(const f4 a[3], const f4 b[3]) {
    return f4_add(f4_add(f4_mul(a[0], b[0]), f4_mul(a[1], b[1])), f4_mul(a[2], b[2]));
}

/* The largest component is 1. A sliver, of normal 0, faces the eye. */
static inline void plt_surface_even_out(const f4 v[3], const f4 dir[3], f4 to[3]) {
    const f4 x = f4_abs(v[0]), y = f4_abs(v[1]), z = f4_abs(v[2]);
    const f4 most = f4_max(z, f4_max(x, y));
    const m4 has_one = f4_lt(f4_zero(), most);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        to[a] = f4_select(has_one, f4_div(v[a], most), dir[a]);
    }
}

/* One of three bytes, as a whole number. */
static inline f4 plt_surface_byte(f4 limited, float clay) {
    const f4 scaled = f4_mul(f4_mul(limited, f4_all(clay)), f4_all(255.0f));
    return f4_of_u4(u4_of_f4(f4_add(scaled, f4_all(0.5f))));
}

/* Clay, red in the lowest byte. `dir`: the direction, or its negative, its largest component 1 or
 * -1; `normal`: of any length. */
static inline u4 plt_surface_clay(const f4 normal[3], const f4 dir[3]) {
    f4 n[3];
    plt_surface_even_out(normal, dir, n);
    const f4 along = plt_surface_dot(n, dir);
    const f4 lengths = f4_mul(plt_surface_dot(n, n), plt_surface_dot(dir, dir));
    const f4 facing = f4_sqrt(f4_div(f4_mul(along, along), lengths));
    const f4 limited = f4_min(facing, f4_all(1.0f));
    const f4 green = f4_mul(plt_surface_byte(limited, PLT_CLAY_GREEN), f4_all(256.0f));
    const f4 blue = f4_mul(plt_surface_byte(limited, PLT_CLAY_BLUE), f4_all(65536.0f));
    return u4_of_f4(f4_add(f4_add(plt_surface_byte(limited, PLT_CLAY_RED), green), blue));
}

#endif
