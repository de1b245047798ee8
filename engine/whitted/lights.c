/* lights - see lights.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/lights.h"

#include "engine/whitted/optics.h"

#if PLT_WITH_WHITTED

#define BRIGHT_MOST 1048576.0f /* 2^20: of a light that a point is next to */
#define POWER_MOST 1.0995116e12f

static int are_between(const float *x, unsigned count, float least, float most) {
    int good = 1;
    for (unsigned i = 0; i < count; i++) {
        good &= x[i] >= least && x[i] <= most; /* false for NaN */
    }
    return good;
}

static int is_light(const plt_light *l) {
    const int has_direction = l->at[0] != 0.0f || l->at[1] != 0.0f || l->at[2] != 0.0f;
    return l->kind <= PLT_LIGHT_DISTANT && (l->kind == PLT_LIGHT_POINT || has_direction) &&
           are_between(l->at, 3, -PLT_COORD_MAX, PLT_COORD_MAX) &&
           are_between(l->power, 3, 0.0f, POWER_MOST) &&
           are_between(&l->radius, 1, 0.0f, PLT_COORD_MAX) && l->samples >= 1 &&
           l->samples <= PLT_LIGHT_SAMPLES_MOST;
}

int plt_lighting_valid(const plt_lighting *lighting) {
    int good = lighting->lights <= PLT_LIGHTS_MOST &&
               are_between(lighting->sky, 3, 0.0f, BRIGHT_MOST) &&
               are_between(lighting->ground, 3, 0.0f, BRIGHT_MOST);
    for (unsigned i = 0; good && i < lighting->lights; i++) {
        good = is_light(&lighting->light[i]);
    }
    return good;
}

uint8_t plt_light_turn(uint32_t x, uint32_t y) {
    const uint32_t q = x ^ y;
    return (uint8_t)((q & 1u) << 3 | (y & 1u) << 2 | (q & 2u) | (y >> 1 & 1u));
}

/* Cosine and sine of i times the golden angle, and of i sixteenths. */
static const float golden[PLT_LIGHT_SAMPLES_MOST][2] = {
    {1.0f, 0.0f},
    {-0.737368878f, 0.675490294f},
    {0.0874257247f, -0.996171041f},
    {0.608438861f, 0.793600751f},
    {-0.984713485f, -0.17418195f},
    {0.843755295f, -0.536728053f},
    {-0.259604305f, 0.965715074f},
    {-0.460907025f, -0.887448429f},
    {0.939321296f, 0.343038631f},
    {-0.924345556f, 0.381556408f},
    {0.423845995f, -0.905734273f},
    {0.299283864f, 0.95416412f},
    {-0.86521121f, -0.501407581f},
    {0.976675774f, -0.214719429f},
    {-0.575129429f, 0.81806243f},
    {-0.12851069f, -0.991708124f},
};
static const float sixteenth[16] = {1.0f,  0.923879533f,  0.707106781f,  0.382683432f,
                                    0.0f,  -0.382683432f, -0.707106781f, -0.923879533f,
                                    -1.0f, -0.923879533f, -0.707106781f, -0.382683432f,
                                    0.0f,  0.382683432f,  0.707106781f,  0.923879533f};

/* A point of the disc of radius 1. */
static void spiral(const plt_light *l, unsigned sample, uint8_t turn, float to[2]) {
    const float c = sixteenth[turn & 15u], s = sixteenth[(turn + 12u) & 15u];
    const float *at = golden[sample];
    const float r = __builtin_sqrtf(((float)sample + 0.5f) / (float)l->samples);
    to[0] = r * (at[0] * c - at[1] * s);
    to[1] = r * (at[0] * s + at[1] * c);
}

/* Moves `to`, which is along `axis` of length 1, across it. Two vectors at right angles: Duff et
 * al., "Building an orthonormal basis, revisited", 2017. */
static void move_across(const float n[3], const float by[2], float radius, float to[3]) {
    const float sign = n[2] < 0.0f ? -1.0f : 1.0f;
    const float a = -1.0f / (sign + n[2]), b = n[0] * n[1] * a;
    const float u[3] = {1.0f + sign * n[0] * n[0] * a, sign * b, -sign * n[0]};
    const float v[3] = {b, sign + n[1] * n[1] * a, -n[1]};
    for (int i = 0; i < 3; i++) {
        to[i] += radius * (by[0] * u[i] + by[1] * v[i]);
    }
}

float plt_light_towards(const plt_light *l, unsigned sample, uint8_t turn, const float point[3],
                        float to[3]) {
    const int is_point = l->kind == PLT_LIGHT_POINT;
    float axis[3], by[2], bright = 1.0f;
    for (int a = 0; a < 3; a++) {
        axis[a] = is_point ? l->at[a] - point[a] : l->at[a];
        to[a] = axis[a];
    }
    if (!plt_normalise(axis)) {
        return 0.0f;
    }
    if (is_point) {
        const float squared = plt_optics_dot(to, to);
        bright = squared > 1.0f / BRIGHT_MOST ? 1.0f / squared : BRIGHT_MOST;
    } else {
        for (int a = 0; a < 3; a++) {
            to[a] = axis[a];
        }
    }
    if (l->radius > 0.0f) {
        spiral(l, sample, turn, by);
        move_across(axis, by, l->radius, to);
    }
    return bright;
}

void plt_light_sky(const plt_lighting *lighting, float up, float to[3]) {
    const float high = 0.5f + 0.5f * up;
    for (int c = 0; c < 3; c++) {
        to[c] = lighting->ground[c] + high * (lighting->sky[c] - lighting->ground[c]);
    }
}

#endif
