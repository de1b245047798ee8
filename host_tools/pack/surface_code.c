/* surface_code - see surface_code.h
 *
 * Of the four codes around a direction the nearest is taken, which is not always the one that
 * rounding gives (Cigolle et al., as octahedral.h has it, "precise").
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/surface_code.h"

#include <math.h>

#include "engine/surface/octahedral.h"
#include "host_tools/mesh/corners.h"

static double sign_of(double x) {
    return x < 0 ? -1.0 : 1.0;
}

/* How near: the cosine. */
static double nearness(uint32_t code, const double n[3]) {
    float v[3];
    plt_octahedral_vector(code, v);
    const double x = (double)v[0], y = (double)v[1], z = (double)v[2];
    return (x * n[0] + y * n[1] + z * n[2]) / sqrt(x * x + y * y + z * z);
}

uint32_t surface_normal_code(uint32_t normal) {
    double n[3], best = -2;
    uint32_t code = PLT_NORMAL_NONE;
    if (normal == CORNER_NO_NORMAL) {
        return code;
    }
    corner_direction(normal, n);
    const double sum = fabs(n[0]) + fabs(n[1]) + fabs(n[2]), x = n[0] / sum, y = n[1] / sum;
    const double u = n[2] < 0 ? (1 - fabs(y)) * sign_of(x) : x;
    const double v = n[2] < 0 ? (1 - fabs(x)) * sign_of(y) : y;
    for (int i = 0; i < 4; i++) {
        const double across = fmin(fmax(floor(u * 127) + (i & 1), -127), 127);
        const double along = fmin(fmax(floor(v * 127) + (i >> 1), -127), 127);
        const uint32_t tried =
            ((uint32_t)(int32_t)across & 0xFFu) | ((uint32_t)(int32_t)along & 0xFFu) << 8;
        const double near = nearness(tried, n);
        if (near > best) {
            best = near;
            code = tried;
        }
    }
    return code;
}

uint32_t surface_colour(uint32_t colour) {
    enum { CLAY = 0xD6EDFF };
    return colour != CORNER_NO_COLOUR ? colour & 0xFFFFFFu : CLAY;
}
