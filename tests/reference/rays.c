/* rays - see rays.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/rays.h"

#include <math.h>

#include "tests/reference/shapes.h"

plt_ray ray_make(const float org[3], const float dir[3], float tmin, float tmax) {
    const plt_ray ray = {{org[0], org[1], org[2]}, tmin, {dir[0], dir[1], dir[2]}, tmax};
    return ray;
}

plt_ray ray_between(const float from[3], const float to[3]) {
    const float dir[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    return ray_make(from, dir, 0.0f, RAYS_FAR);
}

/* The mesh's box, and one around it that is half as large again on each side. */
static void boxes(const mesh *m, float lo[3], float hi[3], float out_lo[3], float out_hi[3]) {
    float most = 0.0f;
    shape_box(m, lo, hi);
    for (int a = 0; a < 3; a++) {
        most = fmaxf(most, hi[a] - lo[a]);
    }
    most = most > 0.0f ? most : 1.0f;
    for (int a = 0; a < 3; a++) {
        out_lo[a] = lo[a] - 0.5f * most;
        out_hi[a] = hi[a] + 0.5f * most;
    }
}

void rays_random(plt_ray *rays, uint32_t count, const mesh *m, random_state *r) {
    float lo[3], hi[3], out_lo[3], out_hi[3], from[3], to[3];
    boxes(m, lo, hi, out_lo, out_hi);
    for (uint32_t i = 0; i < count; i++) {
        random_point(r, out_lo, out_hi, from);
        random_point(r, lo, hi, to);
        rays[i] = ray_between(from, to);
        for (int a = 0; a < 3; a++) { /* for a flat scene the distance from its plane: never zero */
            rays[i].dir[a] += rays[i].dir[a] == 0.0f ? 1e-3f * (out_hi[a] - out_lo[a]) : 0.0f;
        }
        if (random_below(r, 4) == 0) {
            rays[i].tmin = random_float(r, -0.5f, 0.8f);
            rays[i].tmax = random_float(r, 0.8f, 1.5f);
        }
    }
}

void rays_camera(plt_ray *rays, uint32_t count, const mesh *m, random_state *r) {
    float lo[3], hi[3], out_lo[3], out_hi[3], from[3];
    boxes(m, lo, hi, out_lo, out_hi);
    random_point(r, out_lo, out_hi, from);
    const uint32_t side = (uint32_t)sqrt((double)count);
    const int flat = (int)random_below(r, 3), x = (flat + 1) % 3, y = (flat + 2) % 3;
    for (uint32_t i = 0; i < count; i++) {
        float to[3];
        to[flat] = 0.5f * (lo[flat] + hi[flat]);
        to[x] = lo[x] + (hi[x] - lo[x]) * ((float)(i % side) + 0.5f) / (float)side;
        to[y] = lo[y] + (hi[y] - lo[y]) * ((float)(i / side) + 0.5f) / (float)side;
        rays[i] = ray_between(from, to);
    }
}

void rays_axis(plt_ray *rays, uint32_t count, const mesh *m, random_state *r) {
    float lo[3], hi[3], out_lo[3], out_hi[3], from[3];
    boxes(m, lo, hi, out_lo, out_hi);
    for (uint32_t i = 0; i < count; i++) {
        const unsigned axis = random_below(r, 3), back = random_below(r, 2);
        float dir[3] = {random_below(r, 2) ? -0.0f : 0.0f, random_below(r, 2) ? -0.0f : 0.0f,
                        random_below(r, 2) ? -0.0f : 0.0f};
        random_point(r, lo, hi, from);
        if (m->vertices > 0 && random_below(r, 2)) {
            const float *v = m->vertex + 3 * (size_t)random_below(r, (uint32_t)m->vertices);
            for (int a = 0; a < 3; a++) {
                from[a] = v[a];
            }
        }
        from[axis] = back ? out_hi[axis] : out_lo[axis];
        dir[axis] = random_float(r, 0.5f, 2.0f) * (back ? -1.0f : 1.0f);
        rays[i] = ray_make(from, dir, 0.0f, RAYS_FAR);
    }
}

void rays_edges(plt_ray *rays, uint32_t count, const mesh *m, random_state *r) {
    float lo[3], hi[3], out_lo[3], out_hi[3], from[3], to[3];
    boxes(m, lo, hi, out_lo, out_hi);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t triangle = random_below(r, (uint32_t)m->triangles);
        const uint32_t corner = random_below(r, 3);
        const float *p = shape_corner(m, triangle, corner);
        const float *q = shape_corner(m, triangle, (corner + 1) % 3);
        const float share = i % 2 ? random_float(r, 0.0f, 1.0f) : 0.0f;
        random_point(r, out_lo, out_hi, from);
        for (int a = 0; a < 3; a++) {
            to[a] = p[a] + share * (q[a] - p[a]);
        }
        if (i % 4 == 3) {
            const float *s = shape_corner(m, triangle, (corner + 2) % 3);
            const float back = random_float(r, 0.5f, 4.0f);
            for (int a = 0; a < 3; a++) {
                from[a] = to[a] - back * (s[a] - to[a]);
            }
        }
        rays[i] = ray_between(from, to);
        const float *d = rays[i].dir;
        if (fabsf(d[0]) + fabsf(d[1]) + fabsf(d[2]) < 1e-15f) { /* shorter than allowed */
            rays[i].dir[i % 3] = 1.0f;
        }
    }
}

void rays_mixed(plt_ray *rays, uint32_t count, const mesh *m, random_state *r) {
    const uint32_t third = count / 3;
    rays_random(rays, third, m, r);
    rays_camera(rays + third, third, m, r);
    rays_axis(rays + 2 * third, count - 2 * third, m, r);
}
