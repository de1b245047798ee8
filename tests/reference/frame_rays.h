/* frame_rays - the rays of a frame, as plt_trace takes them
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_FRAME_RAYS_H
#define REFERENCE_FRAME_RAYS_H

#include <math.h>
#include <stdlib.h>

#include "engine/planelet.h"
#include "tests/reference/shapes.h"

/* A frame of side^2 rays, the whole mesh in view, each packet's in Z order. The caller frees them.
 */
static inline plt_ray *frame_rays(const mesh *m, unsigned side, unsigned packet) {
    static const float from[3] = {0.5f, 0.4f, 1.2f};
    plt_ray *rays = malloc((size_t)side * side * sizeof *rays), *ray = rays;
    float longest = 0.0f, lo[3], hi[3], eye[3], look[3], right[3], up[3];
    shape_box(m, lo, hi);
    for (int a = 0; a < 3; a++) {
        look[a] = 0.5f * (lo[a] + hi[a]);
        longest = fmaxf(longest, hi[a] - lo[a]);
    }
    for (int a = 0; a < 3; a++) {
        eye[a] = look[a] + from[a] * longest;
        look[a] -= eye[a];
    }
    const float across = hypotf(look[0], look[2]), far = hypotf(across, look[1]);
    right[0] = -look[2] / across, right[1] = 0.0f, right[2] = look[0] / across;
    up[0] = right[1] * look[2] - right[2] * look[1];
    up[1] = right[2] * look[0] - right[0] * look[2];
    up[2] = right[0] * look[1] - right[1] * look[0];
    for (unsigned i = 0; i < side * side; i++) {
        const unsigned tile = i / (packet * packet), in = i % (packet * packet);
        unsigned x = tile % (side / packet) * packet, y = tile / (side / packet) * packet;
        for (unsigned bit = 0; bit < 4; bit++) {
            x += (in >> (2 * bit) & 1u) << bit;
            y += (in >> (2 * bit + 1) & 1u) << bit;
        }
        const float px = 0.5f * longest * (2.0f * ((float)x + 0.5f) / (float)side - 1.0f);
        const float py = 0.5f * longest * (2.0f * ((float)y + 0.5f) / (float)side - 1.0f) / far;
        *ray = (plt_ray){.tmin = 0.0f, .tmax = 3e38f};
        for (int a = 0; a < 3; a++) {
            ray->org[a] = eye[a];
            ray->dir[a] = look[a] + px * right[a] - py * up[a];
        }
        ray++;
    }
    return rays;
}

#endif
