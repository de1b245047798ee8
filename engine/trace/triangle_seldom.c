/* triangle_seldom - see triangle_seldom.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/triangle_seldom.h"

#include "engine/trace/exact.h"

#define MISS_MARGIN 3.0517578125e-5f /* 2^-15 */

static int is_below(const float v[3], float limit) {
    return __builtin_fabsf(v[0]) < limit && __builtin_fabsf(v[1]) < limit &&
           __builtin_fabsf(v[2]) < limit;
}

/* weight[c], without any error: it belongs to the edge from corner c + 2 to corner c + 1. */
static plt_scaled exact_weight(const plt_lone_ray *ray, const float corner[3][3], int c) {
    const int to = plt_axis_after[c], from = plt_axis_after[to];
    return plt_edge_value(corner[from], corner[to], ray->org, ray->dir);
}

/* Whether all three corners lie on one side of the ray, seen along the axis, by more than
 * any rounding. A triangle seen edge-on has all edge functions close to 0 in every
 * ray of its plane, however far beside: this spares the integers. */
static int is_beside(const float corner[3], float far) {
    const float p = corner[0], q = corner[1], r = corner[2];
    return (p > far && q > far && r > far) || (p < -far && q < -far && r < -far);
}

/* Edge functions that are not good enough for u and v: none is above a quarter of its error,
 * or u + v could get above 1 + 1/14, as one has the wrong sign, and none is above sixteen
 * times its error. */
static int is_coarse(const float weight[3], float error, int positive) {
    float least = 0.0f, most = 0.0f;
    for (int c = 0; c < 3; c++) {
        least = weight[c] < least ? weight[c] : least;
        most = weight[c] > most ? weight[c] : most;
    }
    const float size = most > -least ? most : -least, astray = positive ? -least : most;
    return size <= 0.25f * error || (astray > 0.0f && size <= 16.0f * error);
}

void plt_exact_weights(const plt_lone_ray *ray, const float corner[3][3], float weight[3]) {
    plt_scaled value[3];
    int most = -447; /* wide.h: no other value is lower */
    for (int c = 0; c < 3; c++) {
        value[c] = exact_weight(ray, corner, c);
        most = value[c].mantissa != 0.0f && value[c].exponent > most ? value[c].exponent : most;
    }
    for (int c = 0; c < 3; c++) {
        weight[c] = plt_scaled_float(value[c], -most);
    }
}

enum plt_meeting plt_decide_meeting(const plt_lone_ray *ray, const float corner[3][3],
                                    const plt_lone_edges *e) {
    const float far = MISS_MARGIN * ray->reach;
    if (is_beside(e->x, far) || is_beside(e->y, far)) {
        return PLT_MISSES;
    }
    unsigned sides = 0; /* 1: positive, 2: negative */
    for (int c = 0; c < 3; c++) {
        float sign = e->weight[c];
        if (__builtin_fabsf(sign) <= e->error) {
            sign = exact_weight(ray, corner, c).mantissa;
            sign = ray->dir[ray->z] < 0.0f ? -sign : sign; /* as seen along z */
        }
        sides |= (unsigned)(sign > 0.0f) | (unsigned)(sign < 0.0f) << 1;
    }
    if (sides != 1 && sides != 2) { /* of both signs, or all 0: the ray runs in its plane */
        return PLT_MISSES;
    }
    return is_coarse(e->weight, e->error, sides == 1) ? PLT_MEETS_COARSELY : PLT_MEETS;
}

/* An edge, by a power of two that makes its largest component 1 to 2. */
static void set_scaled_edge(float to[3], const float p[3], const float q[3]) {
    for (int a = 0; a < 3; a++) {
        to[a] = p[a] - q[a];
    }
    const float power = plt_power_to_one(to);
    for (int a = 0; a < 3; a++) {
        to[a] *= power;
    }
}

unsigned plt_scale_normal(const float corner[3][3], const float normal[3], float scaled[3]) {
    float first[3], second[3];
    set_scaled_edge(first, corner[1], corner[0]);
    set_scaled_edge(second, corner[2], corner[0]);
    plt_cross(first, second, scaled);
    for (int a = 0; a < 3; a++) {
        scaled[a] *= PLT_NORMAL_SCALE;
    }
    const unsigned small = is_below(normal, PLT_NORMAL_LEAST) ? PLT_NORMAL_IS_SMALL : 0u;
    return small | (is_below(scaled, PLT_SLIVER * PLT_NORMAL_SCALE) ? PLT_NORMAL_IS_SLIVER : 0u);
}
