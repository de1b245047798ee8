/* camera - see camera.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/camera.h"

static void cross(const float a[3], const float b[3], float to[3]) {
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

/* False for a vector without direction. */
static int normalise(float v[3]) {
    float most = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float size = __builtin_fabsf(v[a]);
        most = size > most ? size : most;
    }
    if (!(most > 0.0f && most <= 4.0f * PLT_COORD_MAX)) {
        return 0;
    }
    float sum = 0.0f;
    for (int a = 0; a < 3; a++) {
        v[a] /= most; /* first, so that no square overflows or vanishes */
        sum += v[a] * v[a];
    }
    const float length = __builtin_sqrtf(sum);
    for (int a = 0; a < 3; a++) {
        v[a] /= length;
    }
    return 1;
}

static int in_range(const plt_camera *c) {
    for (int a = 0; a < 3; a++) {
        const float v[3] = {c->eye[a], c->look[a], c->up[a]};
        for (int i = 0; i < 3; i++) {
            if (!(v[i] >= -PLT_COORD_MAX && v[i] <= PLT_COORD_MAX)) {
                return 0;
            }
        }
    }
    return c->tan_half_fov >= 1.0e-6f && c->tan_half_fov <= 1.0e6f;
}

#if PLT_WITH_SAMPLES
/* Row j of a pixel's is ((across - 1) / 2 - j) / across aside: with four samples +1/4 and -1/4,
 * which is the rotated grid of hardware, in pixels -1/8, 3/8, -3/8, 1/8. */
static void set_asides(plt_view *v, uint32_t across) {
    const float middle = 0.5f * (float)(across - 1), step = 1.0f / (float)across;
    for (uint32_t j = 0; j < 4; j++) {
        v->aside[j] = j < across ? (middle - (float)j) * step : 0.0f;
    }
    v->aside_most = v->aside[0];
    v->part[0] = across > 1 ? step : 0.0f;
    v->part[1] = across > 1 ? step - 1.0f : 0.0f;
    v->across = across;
}

void plt_view_refine(plt_view *v, uint32_t across) {
    const float back = 0.5f * (float)(across - 1), step = 1.0f / (float)across;
    for (int a = 0; a < 3; a++) {
        v->right[a] *= step; /* exact: a power of 2, far from the least floats */
        v->down[a] *= step;
        v->corner[a] = (v->corner[a] - back * v->right[a]) - back * v->down[a];
    }
    set_asides(v, across);
}
#endif

int plt_view_set(plt_view *v, const plt_frame *frame) {
    const plt_camera *c = &frame->camera;
    float forward[3], up[3] = {c->up[0], c->up[1], c->up[2]};
    if (!in_range(c)) {
        return PLT_ERR_ARGUMENT;
    }
    for (int a = 0; a < 3; a++) {
        forward[a] = c->look[a] - c->eye[a];
    }
    if (!normalise(forward) || !normalise(up)) {
        return PLT_ERR_ARGUMENT;
    }
    cross(forward, up, v->right);
    if (!normalise(v->right)) {
        return PLT_ERR_ARGUMENT;
    }
    cross(forward, v->right, v->down);
#if PLT_WITH_SAMPLES
    set_asides(v, 1);
#endif
    const float width = (float)frame->width, height = (float)frame->height;
    const float step = 2.0f * c->tan_half_fov / height; /* of a pixel, at distance 1 */
    for (int a = 0; a < 3; a++) {
        v->eye[a] = c->eye[a];
        v->right[a] *= step;
        v->down[a] *= step;
        v->corner[a] =
            forward[a] - (0.5f * width - 0.5f) * v->right[a] - (0.5f * height - 0.5f) * v->down[a];
    }
    return PLT_OK;
}
