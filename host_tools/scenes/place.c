/* place - see place.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/place.h"

#include <stdint.h>

#include "host_tools/scenes/cos_sin.h"

#define CIRCLE 4294967296.0 /* 2^32 steps */

place place_at(double x, double y, double z) {
    return (place){{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, {x, y, z}};
}

void place_point(const place *p, const double local[3], double to[3]) {
    for (unsigned c = 0; c < 3; c++) {
        to[c] = p->at[c] + local[0] * p->axis[0][c] + local[1] * p->axis[1][c] +
                local[2] * p->axis[2][c];
    }
}

place place_moved(const place *p, double x, double y, double z) {
    const double local[3] = {x, y, z};
    place moved = *p;
    place_point(p, local, moved.at);
    return moved;
}

place place_rotated(const place *p, unsigned axis, double circles) {
    const double part = (circles < 0.0 ? circles + 1.0 : circles) * CIRCLE;
    const cos_sin angle = cos_sin_of((uint64_t)part, (uint64_t)1 << 32);
    const unsigned b = (axis + 1) % 3, c = (axis + 2) % 3;
    place rotated = *p;
    for (unsigned k = 0; k < 3; k++) {
        rotated.axis[b][k] = angle.cosine * p->axis[b][k] + angle.sine * p->axis[c][k];
        rotated.axis[c][k] = angle.cosine * p->axis[c][k] - angle.sine * p->axis[b][k];
    }
    return rotated;
}
