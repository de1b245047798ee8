/* placed - see placed.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/instances/placed.h"

#define U 5.9604644775390625e-8f            /* 2^-24 */
#define REACH_LEAST 8.8817841970012523e-16f /* 2^-50, as trace/ray_bounds.h */
#define RESIDUAL_MOST 0.015625f             /* 2^-6 */

static float larger(float a, float b) {
    return a > b ? a : b;
}

static float size(float x) {
    return __builtin_fabsf(x);
}

/* Largest sum of the sizes of a row's columns. */
static float rows_size(const float m[PLT_MATRIX_FLOATS]) {
    float most = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float *row = &m[4 * a];
        most = larger(most, size(row[0]) + size(row[1]) + size(row[2]));
    }
    return most;
}

static float added_size(const float m[PLT_MATRIX_FLOATS]) {
    return larger(larger(size(m[3]), size(m[7])), size(m[11]));
}

/* False for NaN. */
static int is_in_range(const float m[PLT_MATRIX_FLOATS]) {
    int good = 1;
    for (int i = 0; i < PLT_MATRIX_FLOATS; i++) {
        good &= size(m[i]) <= (i % 4 == 3 ? PLT_COORD_MAX : PLT_MATRIX_SIZE_MOST);
    }
    const float a = rows_size(m);
    return good && a >= PLT_MATRIX_SIZE_LEAST && a <= PLT_MATRIX_SIZE_MOST;
}

/* What is left when row i and column j are taken away, with its sign. */
static float cofactor(const float m[PLT_MATRIX_FLOATS], int i, int j) {
    static const int after[3] = {1, 2, 0};
    const int r = after[i], s = after[r], c = after[j], d = after[c];
    return m[4 * r + c] * m[4 * s + d] - m[4 * r + d] * m[4 * s + c];
}

static void invert(const float m[PLT_MATRIX_FLOATS], float to[PLT_MATRIX_FLOATS]) {
    const float determinant =
        (m[0] * cofactor(m, 0, 0) + m[1] * cofactor(m, 0, 1)) + m[2] * cofactor(m, 0, 2);
    for (int i = 0; i < 3; i++) {
        float *row = &to[4 * i];
        for (int j = 0; j < 3; j++) {
            row[j] = cofactor(m, j, i) / determinant;
        }
        row[3] = -((row[0] * m[3] + row[1] * m[7]) + row[2] * m[11]);
    }
}

/* How far the product of both is from doing nothing: in rows, and in what is added. */
static void find_residual(const float m[PLT_MATRIX_FLOATS], const float n[PLT_MATRIX_FLOATS],
                          float *rows, float *added) {
    *rows = *added = 0.0f;
    for (int i = 0; i < 3; i++) {
        const float *row = &m[4 * i];
        float sum = 0.0f;
        for (int j = 0; j < 4; j++) {
            const float one = i == j ? -1.0f : j == 3 ? row[3] : 0.0f;
            const float left = ((row[0] * n[j] + row[1] * n[4 + j]) + row[2] * n[8 + j]) + one;
            sum += j < 3 ? size(left) : 0.0f;
            *added = j == 3 ? larger(*added, size(left)) : *added;
        }
        *rows = larger(*rows, sum);
    }
}

/* Of the corners that the matrix gives; rounding is the caller's. Returns its largest coordinate.
 */
static float set_box(plt_box *to, const float m[PLT_MATRIX_FLOATS], const plt_box *body) {
    float most = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float *row = &m[4 * a];
        float lo = row[3], hi = row[3];
        for (int k = 0; k < 3; k++) {
            const float p = row[k] * body->lo[k], q = row[k] * body->hi[k];
            lo += p < q ? p : q;
            hi += p < q ? q : p;
        }
        to->lo[a] = lo;
        to->hi[a] = hi;
        most = larger(most, larger(size(lo), size(hi)));
    }
    return most;
}

static float box_size(const plt_box *b) {
    float most = REACH_LEAST;
    for (int a = 0; a < 3; a++) {
        most = larger(most, larger(size(b->lo[a]), size(b->hi[a])));
    }
    return most;
}

/* All that does not depend on the ray. */
static int widen(plt_placed *p, const float m[PLT_MATRIX_FLOATS], const plt_box *body, float a,
                 float skew) {
    float rows, added;
    const float most = set_box(&p->box, m, body);
    find_residual(m, p->to_body, &rows, &added);
    rows += 5.0f * U * skew;
    const float sizes =
        64.0f * skew * most + a * (72.0f * added_size(p->to_body) + 64.0f * box_size(body));
    const float margin = U * (sizes + 16.0f * added_size(m)) + 1.25f * (rows * most + added);
    int good = rows <= RESIDUAL_MOST;
    for (int k = 0; k < 3; k++) {
        p->box.lo[k] -= margin;
        p->box.hi[k] += margin;
        good &= p->box.lo[k] >= -PLT_COORD_MAX && p->box.hi[k] <= PLT_COORD_MAX;
    }
    return good;
}

int plt_placed_set(plt_placed *to, const float matrix[PLT_MATRIX_FLOATS], const plt_box *body,
                   float *spread) {
    if (!is_in_range(matrix)) {
        return 0;
    }
    invert(matrix, to->to_body);
    const float a = rows_size(matrix), skew = a * rows_size(to->to_body);
    if (!(skew <= PLT_MATRIX_SKEW_MOST) || !widen(to, matrix, body, a, skew)) {
        return 0;
    }
    *spread = larger(*spread, 64.0f * U * skew);
    return 1;
}
