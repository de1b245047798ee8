/* diagram - see diagram.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/diagram.h"

#if PLT_WITH_DIAGRAMS

static float length(const float v[3]) {
    return __builtin_sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

void plt_depths_set(plt_depths *d, const plt_box *scene, const float eye[3]) {
    float near[3], far[3];
    for (int a = 0; a < 3; a++) {
        const float below = scene->lo[a] - eye[a], above = eye[a] - scene->hi[a];
        const float beside = below > above ? below : above;
        near[a] = beside > 0.0f ? beside : 0.0f;
        far[a] = __builtin_fabsf(below) > __builtin_fabsf(above) ? below : above;
    }
    d->nearest = length(near);
    d->farthest = length(far);
}

void plt_depth_colour(const plt_depths *d, const float dir[3], float t, uint8_t rgb[3]) {
    const float range = d->farthest - d->nearest;
    const float left = range > 0.0f ? (d->farthest - t * length(dir)) / range : 1.0f;
    const float limited = left > 0.0f ? (left < 1.0f ? left : 1.0f) : 0.0f;
    rgb[0] = rgb[1] = rgb[2] = (uint8_t)(limited * 255.0f + 0.5f);
}

/* The logarithm to base 2 of a number above 0, times 256: of the bits behind the first one a
 * straight line, off by less than 23 of 256. */
static int32_t logarithm(uint32_t value) {
    int32_t whole = 0;
    while (value >> whole > 1) {
        whole++;
    }
    const uint32_t behind = value - (1u << whole);
    return 256 * whole + (int32_t)(whole > 8 ? behind >> (whole - 8) : behind << (8 - whole));
}

void plt_heat_colour(uint64_t visits, uint32_t pixels, uint8_t rgb[3]) {
    static const uint8_t level[PLT_HEAT_LEVELS][3] = {{0, 0, 0},      {0, 0, 255},   {0, 255, 255},
                                                      {0, 255, 0},    {255, 255, 0}, {255, 0, 0},
                                                      {255, 255, 255}};
    const int32_t first = -6 * 256,
                  step = 4 * 256; /* 1/64 is level 1, and each 16 times the last */
    const uint32_t some = visits > UINT32_MAX ? UINT32_MAX : (uint32_t)visits;
    const int32_t above = some == 0 ? -step : logarithm(some) - logarithm(pixels) - first;
    const int32_t at = above + step < 0 ? 0 : above + step, last = PLT_HEAT_LEVELS - 1;
    const int32_t from = at / step < last ? at / step : last - 1;
    const int32_t part = at / step < last ? at % step : step;
    for (int c = 0; c < 3; c++) {
        rgb[c] = (uint8_t)((level[from][c] * (step - part) + level[from + 1][c] * part + step / 2) /
                           step);
    }
}

#endif
