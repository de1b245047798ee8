/* fuzz_polygon - a libFuzzer target: any bytes as the corners of a face
 *
 * The first byte says how the rest becomes corners: on small grids, where much touches; off
 * them by a hair; as numbers of any size; as a convex outline. The second and third put
 * them somewhere in space. Promised, whatever the bytes are (polygon.h):
 *
 *   - n - 2 triangles whose edges are those of the outline, each once, and others there and
 *     back; nothing is written behind them; a second call gives the same;
 *   - what is filled: no triangle turns right beyond the noise, areas add up to that of the
 *     outline, and the middle of a triangle is in no other one;
 *   - what is not filled is the fan, and so is what is convex or on a line;
 *   - no more steps than promised.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/mesh/orient2.h"
#include "host_tools/mesh/polygon.h"
#include "host_tools/mesh/polygon_plane.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MOST = 1024, MOST_LOOKED_AT = 96, GUARD = 3 };

static const double FURTHEST = 0x1p41;

typedef struct face {
    double corner[MOST][3];
    double point[MOST][2]; /* in its plane */
    double noise;          /* negative: on a line */
    uint32_t n;
    uint32_t to[3 * MOST + GUARD];
    int kind, is_convex;
} face;

static void promise(int kept, const char *sentence) {
    if (!kept) {
        fprintf(stderr, "%s\n", sentence);
        abort();
    }
}

/* ---- bytes to corners ------------------------------------------------------------------ */

typedef struct bytes {
    const uint8_t *at, *end;
} bytes;

static unsigned take(bytes *b) {
    return b->at < b->end ? *b->at++ : 0;
}

static double within(double x) {
    return isfinite(x) ? fmin(fmax(x, -FURTHEST), FURTHEST) : 0;
}

/* A double of three bytes, of any exponent that a float has. */
static double take_double(bytes *b) {
    const unsigned mantissa = take(b), exponent = take(b), sign = take(b);
    return (sign % 2 ? -1 : 1) * ldexp(1 + mantissa / 256.0, (int)(exponent % 192) - 150);
}

static double take_float(bytes *b) {
    uint8_t raw[4];
    float x;
    for (int i = 0; i < 4; i++) {
        raw[i] = (uint8_t)take(b);
    }
    memcpy(&x, raw, sizeof x);
    return (double)x;
}

/* A coordinate of the grid, and how far off it is, from 2^-60 to 2^-4. */
static double off_grid(bytes *b, unsigned on) {
    const unsigned off = take(b);
    return on + (off % 4 == 0 ? 0 : ldexp(off % 2 ? 1 : -1, -4 - (int)(off / 4) % 57));
}

static void put(face *f, double x, double y, double z) {
    double *p = f->corner[f->n++];
    p[0] = x;
    p[1] = y;
    p[2] = z;
}

static void draw(face *f, bytes *b, unsigned how) {
    while (b->at < b->end && f->n < MOST) {
        const unsigned on = how < 4 ? take(b) : 0;
        switch (how) {
        case 0:
            put(f, on % 16, on / 16, 0);
            break;
        case 1:
            put(f, on % 4, on / 4 % 4, on / 16 % 4);
            break;
        case 2:
            put(f, on % 4, on / 4 % 4, 0);
            break;
        case 3: {
            const double x = off_grid(b, on % 8), y = off_grid(b, on / 8 % 8);
            put(f, x, y, on / 64 == 3 ? off_grid(b, 0) : 0);
            break;
        }
        case 4:
            put(f, within(take_float(b)), within(take_float(b)), within(take_float(b)));
            break;
        default: {
            const double x = take_double(b), y = take_double(b);
            put(f, x, y, how == 5 ? 0 : take_double(b));
        }
        }
    }
}

static int compare_points(const void *a, const void *b) {
    const double *p = a, *q = b;
    for (int k = 0; k < 2; k++) {
        if (p[k] != q[k]) {
            return p[k] < q[k] ? -1 : 1;
        }
    }
    return 0;
}

static double area2(const double *a, const double *b, const double *c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* One more point of a hull that turns left, or goes straight on. */
static void bulge(double (*hull)[3], uint32_t *count, uint32_t least, const double *p) {
    while (*count > least && area2(hull[*count - 2], hull[*count - 1], p) < 0) {
        --*count;
    }
    memcpy(hull[(*count)++], p, sizeof hull[0]);
}

/* Sorts corners, and leaves one of each. */
static void sort_corners(face *f) {
    uint32_t n = 0;
    qsort(f->corner, f->n, sizeof f->corner[0], compare_points);
    for (uint32_t i = 0; i < f->n; i++) {
        if (n == 0 || compare_points(f->corner[n - 1], f->corner[i]) != 0) {
            memmove(f->corner[n++], f->corner[i], sizeof f->corner[0]);
        }
    }
    f->n = n;
}

/* Repeats some corners. */
static void repeat(face *f, unsigned which) {
    for (uint32_t i = 0; i < 8 && f->n < MOST; i++, which /= 2) {
        if (which % 2 && i < f->n) {
            memmove(f->corner[i + 1], f->corner[i], (f->n - i) * sizeof f->corner[0]);
            f->n++;
        }
    }
}

/* Replaces corners on a grid by their convex hull, most of those on its sides included. */
static void make_convex(face *f, unsigned repeated) {
    static double hull[2 * MOST + 2][3];
    uint32_t n = 0;
    sort_corners(f);
    for (uint32_t i = 0; i < f->n; i++) {
        bulge(hull, &n, 1, f->corner[i]);
    }
    const double *first = f->corner[0], *last = f->corner[f->n - 1];
    const uint32_t lower = n;
    for (uint32_t i = f->n; i-- > 0;) {
        if (area2(first, last, f->corner[i]) > 0) { /* what is on the line is there already */
            bulge(hull, &n, lower, f->corner[i]);
        }
    }
    while (n > lower && area2(hull[n - 2], hull[n - 1], hull[0]) < 0) {
        n--;
    }
    f->n = n < MOST ? n : MOST;
    f->is_convex = n <= MOST;
    memcpy(f->corner, hull, f->n * sizeof hull[0]);
    repeat(f, repeated);
}

/* ---- somewhere in space ---------------------------------------------------------------- */

static void turn_round(face *f, unsigned by, int backwards) {
    static double old[MOST][3];
    memcpy(old, f->corner, f->n * sizeof old[0]);
    for (uint32_t i = 0; i < f->n; i++) {
        const uint32_t from = ((backwards ? f->n - i : i) + by) % f->n;
        memcpy(f->corner[i], old[from], sizeof old[0]);
    }
}

/* Axes change places, the plane rises, all becomes larger or smaller, and moves. Grids and
 * slopes are such that what was convex still is, but for numbers that are rounded. */
static void place(face *f, unsigned where, unsigned how) {
    static const double SLOPE[] = {0, 1, -2, 0.5}, MOVE[] = {0, 64, 4096, -1048576};
    const double slope = SLOPE[where / 4 % 4], scale = ldexp(1, (int)(how % 16) * 4 - 36);
    for (uint32_t i = 0; i < f->n; i++) {
        double *p = f->corner[i], q[3];
        p[2] += slope * p[0];
        for (unsigned a = 0; a < 3; a++) {
            q[a] = within((p[(a + where) % 3] + MOVE[where / 16 % 4]) * scale);
        }
        memcpy(p, q, sizeof q);
        for (int a = 0; a < 3 && where / 128; a++) {
            p[a] = (double)(float)p[a];
        }
    }
}

static void make_face(face *f, bytes *b) {
    const unsigned what = take(b), where = take(b), how = take(b), by = take(b);
    f->n = 0;
    f->is_convex = 0;
    if (what % 8 == 7) {
        const unsigned repeated = take(b);
        draw(f, b, 0);
        if (f->n > 0) {
            make_convex(f, repeated);
        }
    } else {
        draw(f, b, what % 8);
    }
    if (f->n >= 3) {
        turn_round(f, by, how / 128 != 0);
        place(f, where, what % 8 >= 4 && what % 8 < 7 ? 9 : how); /* 9: the scale is 1 */
    }
}

/* ---- promises ---------------------------------------------------------------------------- */

static double logarithm(uint32_t n) {
    return 1 + log2((double)n);
}

static void cut_face(face *f, polygon *scratch) {
    const uint64_t ears = scratch->ears.work, sweep = scratch->sweep.work;
    memset(f->to, 0xee, sizeof f->to);
    f->kind = polygon_triangulate(scratch, (const double(*)[3])f->corner, f->n, f->to);
    promise(scratch->ears.work - ears <= (1u << 25) + 1024 * (uint64_t)(f->n + 8),
            "more steps than promised");
    promise((double)(scratch->sweep.work - sweep) <= 16 * f->n * logarithm(f->n),
            "a sweep of too many steps");
}

static int is_fan(const face *f) {
    for (uint32_t i = 0; i < f->n - 2; i++) {
        const uint32_t *t = f->to + 3 * (size_t)i;
        if (t[0] != 0 || t[1] != i + 1 || t[2] != i + 2) {
            return 0;
        }
    }
    return 1;
}

static void check_indices(const face *f) {
    const size_t end = 3 * ((size_t)f->n - 2);
    for (size_t i = 0; i < end; i++) {
        promise(f->to[i] < f->n, "an index beyond the corners");
    }
    for (size_t i = end; i < end + GUARD; i++) {
        promise(f->to[i] == 0xeeeeeeee, "more triangles than there is room for");
    }
}

/* Every edge of the outline once, all others as often back as there. */
static void check_edges(const face *f) {
    static int balance[MOST_LOOKED_AT][MOST_LOOKED_AT];
    memset(balance, 0, sizeof balance);
    for (size_t i = 0; i < 3 * ((size_t)f->n - 2); i++) {
        balance[f->to[i]][f->to[i - i % 3 + (i + 1) % 3]]++;
    }
    for (uint32_t i = 0; i < f->n; i++) {
        balance[i][(i + 1) % f->n]--;
    }
    for (uint32_t a = 0; a < f->n; a++) {
        for (uint32_t b = 0; b < f->n; b++) {
            promise(balance[a][b] == balance[b][a], "edges that are not those of the outline");
        }
    }
}

static double area_of(const face *f, uint32_t triangle) {
    const uint32_t *t = f->to + 3 * (size_t)triangle;
    return orient2(f->point[t[0]], f->point[t[1]], f->point[t[2]]);
}

static double noise_of(const face *f, uint32_t triangle) {
    const uint32_t *t = f->to + 3 * (size_t)triangle;
    return orient2_noise(f->noise, f->point[t[0]], f->point[t[1]], f->point[t[2]]);
}

static void check_areas(const face *f) {
    double outline = 0, triangles = 0;
    for (uint32_t i = 0; i < f->n - 2; i++) {
        const double area = area_of(f, i);
        promise(area >= -noise_of(f, i), "a triangle that turns right");
        triangles += area;
        outline += orient2(f->point[0], f->point[i + 1], f->point[i + 2]);
    }
    /* points are within +-4, so an area's rounding is below 2^-44 */
    promise(fabs(triangles - outline) <= f->n * 0x1p-44, "areas that do not add up");
}

/* Clearly inside: 1. */
static int holds(const face *f, uint32_t triangle, const double p[2]) {
    const uint32_t *t = f->to + 3 * (size_t)triangle;
    for (int k = 0; k < 3; k++) {
        const double *a = f->point[t[k]], *b = f->point[t[(k + 1) % 3]];
        if (orient2(a, b, p) <= 16 * orient2_noise(f->noise, a, b, p) + 0x1p-45) {
            return 0;
        }
    }
    return 1;
}

static void check_overlaps(const face *f) {
    for (uint32_t i = 0; i < f->n - 2; i++) {
        const uint32_t *t = f->to + 3 * (size_t)i;
        double middle[2];
        for (int k = 0; k < 2; k++) {
            middle[k] = (f->point[t[0]][k] + f->point[t[1]][k] + f->point[t[2]][k]) / 3;
        }
        for (uint32_t j = 0; j < f->n - 2 && holds(f, i, middle); j++) {
            promise(j == i || !holds(f, j, middle), "triangles that overlap");
        }
    }
}

static void check_face(face *f) {
    f->noise = polygon_project((const double(*)[3])f->corner, f->n, f->point);
    check_indices(f);
    promise(f->kind == POLYGON_FILLED || f->kind == POLYGON_OVERLAPS, "an unknown kind");
    promise(f->kind == POLYGON_FILLED || is_fan(f), "not filled, and no fan");
    promise(f->noise >= 0 || f->n == 3 || (is_fan(f) && f->kind == POLYGON_FILLED),
            "on a line, and no fan");
    promise(!f->is_convex || (is_fan(f) && f->kind == POLYGON_FILLED), "convex, and no fan");
    if (f->n <= MOST_LOOKED_AT) {
        check_edges(f);
    }
    if (f->kind == POLYGON_FILLED && f->noise >= 0 && f->n > 3) {
        check_areas(f);
        if (f->n <= MOST_LOOKED_AT) {
            check_overlaps(f);
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static face f, again;
    static polygon kept; /* as for the next face of a file */
    polygon fresh = {0};
    bytes b = {data, data + size};
    make_face(&f, &b);
    if (f.n < 3) {
        return 0;
    }
    memcpy(again.corner, f.corner, sizeof f.corner);
    again.n = f.n;
    cut_face(&f, &fresh);
    cut_face(&again, &kept);
    if (kept.ears.work > 1u << 20) { /* far from what all faces of a file may take */
        polygon_free(&kept);
    }
    promise(f.kind == again.kind && memcmp(f.to, again.to, sizeof f.to) == 0,
            "the second call gives something else");
    promise(memcmp(f.corner, again.corner, sizeof f.corner) == 0, "corners were changed");
    check_face(&f);
    polygon_free(&fresh);
    return 0;
}
