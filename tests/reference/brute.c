/* brute - see brute.h
 *
 * The side of an edge that a ray passes on is left open only below 2^-38 of the factors' size:
 * the engine decides close cases in integers. t, u and v are single precision, with an
 * error bound worked out for each.
 *
 * Scaled triple products: with A B C the corners seen from the origin of the ray, dir . (C x B)
 * and so on all have the same sign where the ray passes inside. Error bounds: u = 2^-24; a
 * difference, two products and a sum of each of two factors are off by at most some 16 u of the
 * factors' magnitudes; the floors make subnormal numbers unsure.
 *
 * Source: Moeller, Trumbore, "Fast, minimum storage ray/triangle intersection", 1997 (the
 * determinants); errors our own.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/brute.h"

#include <float.h>
#include <math.h>

#include "tests/reference/shapes.h"

#define U 5.9604644775390625e-8
#define FLOOR 1e-43
#define CLOSE 3.637978807091713e-12 /* 2^-38 */

static void cross(const double a[3], const double b[3], double to[3]) {
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double size1(const double a[3]) {
    return fabs(a[0]) + fabs(a[1]) + fabs(a[2]);
}

static double largest(const double a[3]) {
    return fmax(fmax(fabs(a[0]), fabs(a[1])), fabs(a[2]));
}

typedef struct volume {
    double value;
    double error; /* of single precision: for u and v */
    double close; /* closer to 0 the side is left open */
} volume;

static volume volume_of(const double dir[3], const double b[3], const double c[3]) {
    double n[3];
    cross(b, c, n);
    const double size = largest(dir) * size1(b) * size1(c);
    const volume v = {dot(dir, n), 16.0 * U * size + largest(dir) * FLOOR,
                      CLOSE * size + largest(dir) * FLOOR};
    return v;
}

/* The normal, and the error bound of each component in single precision. */
static void normal_of(const double p[3][3], double n[3], double error[3]) {
    double e[3], f[3];
    for (int a = 0; a < 3; a++) {
        e[a] = p[1][a] - p[0][a];
        f[a] = p[2][a] - p[0][a];
    }
    cross(e, f, n);
    for (int a = 0; a < 3; a++) {
        const int y = (a + 1) % 3, z = (a + 2) % 3;
        error[a] = 4.0 * U * (fabs(e[y] * f[z]) + fabs(e[z] * f[y])) + FLOOR;
    }
}

/* The engine computes from the least corner, by x, then y, then z. */
static int least_corner(const double p[3][3]) {
    int least = 0;
    for (int c = 1; c < 3; c++) {
        int a = 0;
        while (a < 2 && p[c][a] == p[least][a]) {
            a++;
        }
        least = p[c][a] < p[least][a] ? c : least;
    }
    return least;
}

static void distance(brute_answer *to, const double q[3][3], const double org[3],
                     const double dir[3]) {
    double p[3][3], from[3];
    const int least = least_corner(q);
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            p[c][a] = q[(least + c) % 3][a];
        }
    }
    for (int a = 0; a < 3; a++) {
        from[a] = p[0][a] - org[a];
    }
    double n[3], error[3], above_error = 0.0, along_error = 0.0, vanishes = 1.0;
    normal_of(p, n, error);
    for (int a = 0; a < 3; a++) {
        const double off = error[a] + 6.0 * U * fabs(n[a]);
        above_error += off * fabs(from[a]) + FLOOR;
        along_error += off * fabs(dir[a]) + FLOOR;
        vanishes = fabs(n[a]) > 2.0 * error[a] ? 0.0 : vanishes;
    }
    const double along = dot(n, dir);
    to->t = dot(n, from) / along;
    if (vanishes != 0.0 && to->verdict == BRUTE_HIT) {
        to->verdict = BRUTE_UNSURE;
    }
    to->t_error = HUGE_VAL;
    if (fabs(along) > 2.0 * along_error) {
        to->t_error = (above_error + fabs(to->t) * along_error) / (fabs(along) - along_error) +
                      4.0 * U * fabs(to->t) + (double)FLT_MIN;
    }
}

static void barycentrics(brute_answer *to, const volume e[3]) {
    const double sum = e[0].value + e[1].value + e[2].value;
    const double sum_error = e[0].error + e[1].error + e[2].error;
    const double safe = fabs(sum) - sum_error;
    to->u = e[1].value / sum;
    to->v = e[2].value / sum;
    to->u_error = safe > 0.0 ? (e[1].error + fabs(to->u) * sum_error) / safe + 4.0 * U : HUGE_VAL;
    to->v_error = safe > 0.0 ? (e[2].error + fabs(to->v) * sum_error) / safe + 4.0 * U : HUGE_VAL;
}

brute_answer brute_triangle(const mesh *m, uint32_t triangle, const plt_ray *ray) {
    double p[3][3], seen[3][3];
    const double dir[3] = {(double)ray->dir[0], (double)ray->dir[1], (double)ray->dir[2]};
    for (unsigned c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            p[c][a] = (double)shape_corner(m, triangle, c)[a];
            seen[c][a] = p[c][a] - (double)ray->org[a];
        }
    }
    const volume e[3] = {volume_of(dir, seen[2], seen[1]), volume_of(dir, seen[0], seen[2]),
                         volume_of(dir, seen[1], seen[0])};
    int above = 0, below = 0;
    for (int i = 0; i < 3; i++) {
        above += e[i].value > e[i].close;
        below += e[i].value < -e[i].close;
    }
    brute_answer answer = {BRUTE_UNSURE, 0, 0, 0, 0, 0, 0};
    if (above == 3 || below == 3) {
        answer.verdict = BRUTE_HIT;
    } else if (above > 0 && below > 0) {
        answer.verdict = BRUTE_MISS;
    }
    const double org[3] = {(double)ray->org[0], (double)ray->org[1], (double)ray->org[2]};
    distance(&answer, (const double(*)[3])p, org, dir);
    barycentrics(&answer, e);
    return answer;
}

/* Checks the hit against the triangle that it names. */
static const char *hit_objects(const brute_answer *a, const plt_ray *ray, const plt_hit *hit) {
    if (a->verdict == BRUTE_MISS) {
        return "the triangle is certainly missed";
    }
    if (!(hit->t >= ray->tmin && hit->t <= ray->tmax && hit->t >= 0.0f)) {
        return "t is outside tmin .. tmax";
    }
    if (a->t_error < HUGE_VAL && !(fabs((double)hit->t - a->t) <= a->t_error)) {
        return "t is off";
    }
    if (!(fabs((double)hit->u - a->u) <= a->u_error && fabs((double)hit->v - a->v) <= a->v_error) &&
        a->u_error < HUGE_VAL) {
        return "u or v is off";
    }
    return hit->u >= 0.0f && hit->v >= 0.0f && hit->u <= 1.0f && hit->v <= 1.0f
               ? NULL
               : "u or v is outside 0 .. 1";
}

const char *brute_objects(const mesh *m, const plt_ray *ray, const plt_hit *hit, int *unsure) {
    double nearest = HUGE_VAL; /* something is certainly hit at this distance */
    const double tmin = ray->tmin > 0.0f ? (double)ray->tmin : 0.0;
    const double far = hit->triangle == PLT_MISS ? (double)ray->tmax : (double)hit->t;
    *unsure = 0;
    for (uint32_t i = 0; i < m->triangles; i++) {
        const brute_answer a = brute_triangle(m, i, ray);
        if (a.verdict == BRUTE_HIT && a.t - a.t_error >= tmin &&
            a.t + a.t_error <= (double)ray->tmax) {
            nearest = fmin(nearest, a.t + a.t_error);
        } else if (a.verdict != BRUTE_MISS && i != hit->triangle &&
                   !(a.t - a.t_error > far || a.t + a.t_error < tmin)) {
            *unsure = 1;
        }
    }
    if (hit->triangle == PLT_MISS) {
        return nearest < HUGE_VAL ? "a triangle is certainly hit" : NULL;
    }
    if (hit->triangle >= m->triangles) {
        return "there is no such triangle";
    }
    const brute_answer a = brute_triangle(m, hit->triangle, ray);
    *unsure |= a.verdict == BRUTE_UNSURE;
    if (nearest < (double)hit->t) {
        return "another triangle is certainly nearer";
    }
    return hit_objects(&a, ray, hit);
}
