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
        const float size = v[a] < 0.0f ? -v[a] : v[a];
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

int plt_camera_setup(plt_rendering *r) {
    const plt_camera *c = &r->frame.camera;
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
    cross(forward, up, r->right);
    if (!normalise(r->right)) {
        return PLT_ERR_ARGUMENT;
    }
    cross(forward, r->right, r->down);
    const float width = (float)r->frame.width, height = (float)r->frame.height;
    const float step = 2.0f * c->tan_half_fov / height; /* of a pixel, at distance 1 */
    for (int a = 0; a < 3; a++) {
        r->right[a] *= step;
        r->down[a] *= step;
        r->corner[a] =
            forward[a] - (0.5f * width - 0.5f) * r->right[a] - (0.5f * height - 0.5f) * r->down[a];
    }
    return PLT_OK;
}

static void camera_group(plt_engine *e, unsigned index, const uint32_t px[4], const uint32_t py[4],
                         unsigned lanes) {
    const plt_rendering *r = &e->rendering;
    f4 org[3], dir[3];
    for (int a = 0; a < 3; a++) {
        float d[4];
        for (int i = 0; i < 4; i++) {
            d[i] = (r->corner[a] + (float)px[i] * r->right[a]) + (float)py[i] * r->down[a];
        }
        org[a] = f4_all(r->frame.camera.eye[a]);
        dir[a] = f4_load(d);
    }
    /* Lanes outside the frame get an empty interval. */
    const f4 tmax = f4_select(m4_bits(lanes), f4_all(PLT_BOX_FAR), f4_all(-1.0f));
    plt_group_set(&e->walker.packet, index, &e->walker.tree.box, org, dir, f4_zero(), tmax, 4);
}

void plt_camera_packet(plt_engine *e, uint32_t x, uint32_t y, uint32_t x_end, uint32_t y_end) {
    const uint32_t side = e->options.packet_side;
    plt_packet_begin(&e->walker.packet, side * side / 4, 0);
    for (uint32_t k = 0; k < side * side; k += 4) {
        uint32_t px[4], py[4];
        unsigned lanes = 0;
        for (uint32_t i = 0; i < 4; i++) {
            px[i] = x + plt_z_order_x(k + i);
            py[i] = y + plt_z_order_y(k + i);
            lanes |= (unsigned)(px[i] < x_end && py[i] < y_end) << i;
        }
        camera_group(e, k / 4, px, py, lanes);
    }
    plt_packet_finish(&e->walker.packet);
}
