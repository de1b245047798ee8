/* lattice_area - see lattice_area.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice_area.h"

#include <string.h>

static void cross(const lattice_position p[3], int64_t c[3]) {
    int64_t e[3], g[3];
    for (int a = 0; a < 3; a++) {
        e[a] = (int64_t)p[1].q[a] - (int64_t)p[0].q[a];
        g[a] = (int64_t)p[2].q[a] - (int64_t)p[0].q[a];
    }
    for (int a = 0; a < 3; a++) {
        c[a] = e[(a + 1) % 3] * g[(a + 2) % 3] - e[(a + 2) % 3] * g[(a + 1) % 3];
    }
}

int lattice_has_area(const lattice_position p[3]) {
    int64_t c[3];
    cross(p, c);
    return c[0] != 0 || c[1] != 0 || c[2] != 0;
}

static int same(const lattice_position *a, const lattice_position *b) {
    return memcmp(a, b, sizeof *a) == 0;
}

int lattice_is_line(const lattice_position p[3]) {
    return !lattice_has_area(p) && !same(&p[0], &p[1]) && !same(&p[1], &p[2]) &&
           !same(&p[0], &p[2]);
}
