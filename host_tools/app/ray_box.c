/* ray_box - see ray_box.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/ray_box.h"

#include <math.h>

void ray_set_add(ray_set *s, const double org[3], const double dir[3], float tmax) {
    plt_ray *ray = &s->rays[s->count++];
    for (int a = 0; a < 3; a++) {
        ray->org[a] = (float)org[a];
        ray->dir[a] = (float)dir[a];
    }
    ray->tmin = 0.0f;
    ray->tmax = tmax;
}

double ray_random(uint64_t *state) {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return (double)(*state >> 11) * 0x1p-53;
}

uint32_t ray_random_below(uint64_t *state, uint32_t count) {
    return (uint32_t)(ray_random(state) * count);
}

void ray_normalise(double v[3]) {
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int a = 0; a < 3 && length > 0.0; a++) {
        v[a] /= length;
    }
}

void ray_frame(const double normal[3], double side[3], double over[3]) {
    const int least = fabs(normal[0]) < fabs(normal[1])
                          ? (fabs(normal[0]) < fabs(normal[2]) ? 0 : 2)
                          : (fabs(normal[1]) < fabs(normal[2]) ? 1 : 2);
    const int b = (least + 1) % 3, c = (least + 2) % 3;
    side[least] = 0.0;
    side[b] = -normal[c];
    side[c] = normal[b];
    ray_normalise(side);
    for (int a = 0; a < 3; a++) {
        const int next = (a + 1) % 3, last = (a + 2) % 3;
        over[a] = normal[next] * side[last] - normal[last] * side[next];
    }
}

/* Sides are 0 .. 5: an axis, and which end of it. */
static void point_of_side(const plt_info *info, uint32_t side, double point[3], uint64_t *random) {
    for (unsigned a = 0; a < 3; a++) {
        const double lo = (double)info->lo[a], hi = (double)info->hi[a];
        const double share = a == side / 2 ? (double)(side % 2) : ray_random(random);
        point[a] = lo + share * (hi - lo);
    }
}

void ray_box_sides(ray_set *s, const plt_info *info, uint32_t count, uint64_t *random) {
    for (uint32_t i = 0; i < count; i++) {
        double from[3], to[3], dir[3];
        const uint32_t side = ray_random_below(random, 6);
        point_of_side(info, side, from, random);
        point_of_side(info, (side + 1 + ray_random_below(random, 5)) % 6, to, random);
        for (int a = 0; a < 3; a++) {
            dir[a] = to[a] - from[a];
        }
        ray_normalise(dir);
        ray_set_add(s, from, dir, INFINITY);
    }
}

/* All directions alike: points of a ball, moved to its surface. */
static void random_direction(double dir[3], uint64_t *random) {
    double square;
    do {
        square = 0.0;
        for (int a = 0; a < 3; a++) {
            dir[a] = 2.0 * ray_random(random) - 1.0;
            square += dir[a] * dir[a];
        }
    } while (square > 1.0 || square < 1e-6);
    ray_normalise(dir);
}

/* All lines that meet the ball around the box alike: a direction, and a point of the ball's
 * disc at right angles to it. */
void ray_box_outside(ray_set *s, const plt_info *info, uint32_t count, uint64_t *random) {
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        const double half = 0.5 * ((double)info->hi[a] - (double)info->lo[a]);
        square += half * half;
    }
    const double radius = sqrt(square);
    for (uint32_t i = 0; i < count; i++) {
        double dir[3], side[3], over[3], org[3], x, y;
        random_direction(dir, random);
        ray_frame(dir, side, over);
        do {
            x = 2.0 * ray_random(random) - 1.0;
            y = 2.0 * ray_random(random) - 1.0;
        } while (x * x + y * y >= 1.0);
        for (int a = 0; a < 3; a++) {
            const double middle = 0.5 * ((double)info->lo[a] + (double)info->hi[a]);
            org[a] = middle + radius * (x * side[a] + y * over[a] - 2.0 * dir[a]);
        }
        ray_set_add(s, org, dir, INFINITY);
    }
}

void ray_box_inside(ray_set *s, const plt_info *info, uint32_t count, uint64_t *random) {
    for (uint32_t i = 0; i < count; i++) {
        double org[3], dir[3];
        for (int a = 0; a < 3; a++) {
            const double edge = (double)info->hi[a] - (double)info->lo[a];
            org[a] = (double)info->lo[a] + (0.25 + 0.5 * ray_random(random)) * edge;
        }
        random_direction(dir, random);
        ray_set_add(s, org, dir, INFINITY);
    }
}
