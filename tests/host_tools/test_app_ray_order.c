/* test_app_ray_order - sorted rays are all there, and neighbours are alike
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/app/ray_order.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { RAYS = 5000 };

static plt_ray rays[RAYS];
static uint32_t order[RAYS];

static void set_random(random_state *r) {
    for (uint32_t i = 0; i < RAYS; i++) {
        for (int a = 0; a < 3; a++) {
            rays[i].org[a] = random_float(r, -5.0f, 9.0f);
            rays[i].dir[a] = random_float(r, -1.0f, 1.0f);
        }
    }
}

static void is_permutation(uint32_t count) {
    static uint8_t seen[RAYS];
    memset(seen, 0, sizeof seen);
    for (uint32_t i = 0; i < count; i++) {
        CHECK(order[i] < count && !seen[order[i]], "%u comes twice, or is none", order[i]);
        seen[order[i]] = 1;
    }
}

static double length_of(const double a[3]) {
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

static double distance(const float a[3], const float b[3], int directions) {
    const double one[3] = {(double)a[0], (double)a[1], (double)a[2]};
    const double two[3] = {(double)b[0], (double)b[1], (double)b[2]};
    const double of_one = directions ? length_of(one) : 1.0;
    const double of_two = directions ? length_of(two) : 1.0;
    double apart[3];
    for (int i = 0; i < 3; i++) {
        apart[i] = one[i] / of_one - two[i] / of_two;
    }
    return length_of(apart);
}

/* The mean distance between neighbours: of what ray_order looks at. */
static double roughness(int sorted, int directions) {
    double sum = 0.0;
    for (uint32_t i = 1; i < RAYS; i++) {
        const plt_ray *one = &rays[sorted ? order[i - 1] : i - 1];
        const plt_ray *two = &rays[sorted ? order[i] : i];
        sum += directions ? distance(one->dir, two->dir, 1) : distance(one->org, two->org, 0);
    }
    return sum / (RAYS - 1);
}

static void neighbours_are_alike(void) {
    random_state r = {3};
    set_random(&r);
    CHECK(ray_order_sort(rays, RAYS, order) == 0, "memory");
    is_permutation(RAYS);
    CHECK(roughness(1, 0) < 0.2 * roughness(0, 0), "origins: %g, unsorted %g", roughness(1, 0),
          roughness(0, 0));
    for (uint32_t i = 0; i < RAYS; i++) {
        memset(rays[i].org, 0, sizeof rays[i].org);
    }
    CHECK(ray_order_sort(rays, RAYS, order) == 0, "memory");
    is_permutation(RAYS);
    CHECK(roughness(1, 1) < 0.1 * roughness(0, 1), "directions: %g, unsorted %g", roughness(1, 1),
          roughness(0, 1));
}

/* Rays alike stay as they came. */
static void is_stable(void) {
    memset(rays, 0, sizeof rays);
    CHECK(ray_order_sort(rays, RAYS, order) == 0, "memory");
    for (uint32_t i = 0; i < RAYS; i++) {
        CHECK(order[i] == i, "ray %u of equal ones comes at %u", order[i], i);
    }
}

/* Whatever a file holds, all of it comes once. */
static void takes_anything(void) {
    static const float odd[] = {NAN, INFINITY, -INFINITY, 0.0f, -0.0f, 3.0e38f, -3.0e38f, 1.0e-45f};
    random_state r = {9};
    for (uint32_t round = 0; round < 20; round++) {
        set_random(&r);
        for (uint32_t i = 0; i < RAYS; i += 1 + round % 3) {
            float *ray = (float *)&rays[i];
            ray[random_below(&r, 8)] = odd[random_below(&r, 8)];
        }
        CHECK(ray_order_sort(rays, RAYS, order) == 0, "memory");
        is_permutation(RAYS);
    }
    for (uint32_t count = 0; count < 4; count++) {
        CHECK(ray_order_sort(rays, count, order) == 0, "%u rays", count);
        is_permutation(count);
    }
}

int main(void) {
    test("neighbours of sorted rays begin and point alike, and all rays are there");
    neighbours_are_alike();
    test("equal rays keep their order");
    is_stable();
    test("rays of any bits are sorted");
    takes_anything();
    return test_done();
}
