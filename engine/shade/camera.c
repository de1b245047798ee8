/* camera - see camera.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/camera.h"

#define UNLIMITED 3.0e38f /* tmax */

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

static void set_group(const plt_view *v, const plt_box *scene, plt_packet *p, unsigned index,
                      const uint32_t px[4], const uint32_t py[4], unsigned lanes) {
    f4 org[3], dir[3];
    for (int a = 0; a < 3; a++) {
        float d[4];
        for (int i = 0; i < 4; i++) {
            d[i] = (v->corner[a] + (float)px[i] * v->right[a]) + (float)py[i] * v->down[a];
        }
        org[a] = f4_all(v->eye[a]);
        dir[a] = f4_load(d);
    }
    /* Lanes outside the frame get an empty interval. */
    const f4 tmax = f4_select(m4_bits(lanes), f4_all(UNLIMITED), f4_all(-1.0f));
    plt_packet_set_group(p, index, scene, org, dir, f4_zero(), tmax, 4);
}

void plt_view_packet(const plt_view *v, const plt_box *scene, plt_packet *p,
                     const plt_pixels *pixels) {
    const uint32_t rays = pixels->side * pixels->side;
    plt_packet_begin(p, rays / 4, 0);
    for (uint32_t k = 0; k < rays; k += 4) {
        uint32_t px[4], py[4];
        unsigned lanes = 0;
        for (uint32_t i = 0; i < 4; i++) {
            px[i] = pixels->x + plt_z_order_x(k + i);
            py[i] = pixels->y + plt_z_order_y(k + i);
            lanes |= (unsigned)(px[i] < pixels->x_end && py[i] < pixels->y_end) << i;
        }
        set_group(v, scene, p, k / 4, px, py, lanes);
    }
    plt_packet_finish(p);
}
