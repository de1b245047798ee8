/* twist - see twist.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/twist.h"

#include <math.h>

#include "host_tools/scenes/cos_sin.h"

#define WHOLE (UINT64_C(1) << 40) /* a circle */

static void box_of(const mesh *m, double lo[3], double hi[3]) {
    for (int a = 0; a < 3; a++) {
        lo[a] = (double)INFINITY;
        hi[a] = -(double)INFINITY;
        for (size_t i = 0; i < m->vertices; i++) {
            lo[a] = fmin(lo[a], mesh_wide(m, i, a));
            hi[a] = fmax(hi[a], mesh_wide(m, i, a));
        }
    }
}

void twist_mesh(mesh *m, unsigned step, unsigned steps) {
    double lo[3], hi[3];
    const unsigned at = 2 * step < steps ? step : steps - step; /* to, and fro */
    box_of(m, lo, hi);
    if (at == 0 || !(hi[1] > lo[1])) {
        return;
    }
    for (size_t i = 0; i < m->vertices; i++) {
        const double high = (mesh_wide(m, i, 1) - lo[1]) / (hi[1] - lo[1]);
        const double part = 0.25 * high * (2.0 * at / steps);
        const cos_sin r = cos_sin_of((uint64_t)(part * (double)WHOLE), WHOLE);
        const double x = mesh_wide(m, i, 0) - 0.5 * (lo[0] + hi[0]);
        const double z = mesh_wide(m, i, 2) - 0.5 * (lo[2] + hi[2]);
        m->vertex[3 * i] = (float)(0.5 * (lo[0] + hi[0]) + x * r.cosine + z * r.sine);
        m->vertex[3 * i + 2] = (float)(0.5 * (lo[2] + hi[2]) + z * r.cosine - x * r.sine);
        if (m->wide != NULL) {
            m->wide[3 * i] = (double)m->vertex[3 * i];
            m->wide[3 * i + 2] = (double)m->vertex[3 * i + 2];
        }
    }
}
