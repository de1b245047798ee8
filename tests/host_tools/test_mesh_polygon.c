/* test_mesh_polygon - faces of many corners: what they cover, and that it is all
 *
 * Outlines are drawn in a plane, then put anywhere in space. The oracle looks
 * only at the drawing: triangles and outline must meet edge to edge, none turned,
 * and cover every sample point as often as the outline winds around it.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/mesh/orient2.h"
#include "host_tools/mesh/polygon.h"
#include "tests/test.h"

enum { MOST = 2048 };

typedef double point[2];

typedef struct drawing {
    const char *name;
    point at[MOST];
    double lift[MOST]; /* out of the plane */
    uint32_t n;
} drawing;

/* Where a drawing is put: in the columns of an orthonormal matrix, then scaled and moved. */
typedef struct placing {
    double matrix[3][3], scale, offset[3];
    int is_rounded;
} placing;

static polygon scratch;
static double space[MOST][3];
static uint32_t result[3 * MOST];

static uint64_t seed = 1;
static double chance(void) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 33) / 2147483648.0;
}

static uint32_t below(uint32_t n) {
    return (uint32_t)(chance() * n);
}

/* ---- drawings ---------------------------------------------------------- */

static void put(drawing *d, double x, double y) {
    d->at[d->n][0] = x;
    d->at[d->n][1] = y;
    d->lift[d->n++] = 0;
}

static drawing draw(const char *name, const double *xy, uint32_t n) {
    drawing d = {.name = name};
    for (uint32_t i = 0; i < n; i++) {
        put(&d, xy[2 * i], xy[2 * i + 1]);
    }
    return d;
}

static drawing star(uint32_t tips, double inner) {
    drawing d = {.name = "star"};
    for (uint32_t i = 0; i < 2 * tips; i++) {
        const double angle = 3.14159265358979 * i / tips, r = i % 2 ? inner : 1;
        put(&d, r * cos(angle), r * sin(angle));
    }
    return d;
}

static drawing comb(uint32_t teeth) {
    drawing d = {.name = "comb"};
    put(&d, 0, 0);
    put(&d, teeth, 0);
    for (uint32_t i = teeth; i > 0; i--) {
        put(&d, i, 2);
        put(&d, i - 0.5, 9);
    }
    put(&d, 0, 2);
    return d;
}

static drawing spiral(uint32_t steps) {
    drawing d = {.name = "spiral"};
    for (uint32_t i = 0; i < steps; i++) {
        const double angle = 0.4 * i;
        put(&d, (3.5 + angle) * cos(angle), (3.5 + angle) * sin(angle));
    }
    for (uint32_t i = steps; i-- > 0;) {
        const double angle = 0.4 * i;
        put(&d, (0.5 + angle) * cos(angle), (0.5 + angle) * sin(angle));
    }
    return d;
}

#define DRAW(name, ...)                                                                            \
    draw(name, (const double[]){__VA_ARGS__}, sizeof((const double[]){__VA_ARGS__}) / 16)

enum { SIMPLE_DRAWINGS = 8, DRAWINGS = 24 };

static drawing drawing_of(int which) {
    switch (which) {
    case 0:
        return DRAW("L", 0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2);
    case 1:
        return DRAW("dart", 0, 0, 4, -3, 1, 0, 4, 3);
    case 2:
        return DRAW("arrow", 0, 1, 3, 1, 3, 0, 5, 2, 3, 4, 3, 3, 0, 3);
    case 3:
        return comb(7);
    case 4:
        return spiral(40);
    case 5:
        return star(7, 0.3);
    case 6:
        return DRAW("U", 0, 0, 9, 0, 9, 5, 8, 5, 8, 1, 1, 1, 1, 5, 0, 5);
    case 7:
        return DRAW("zigzag", 0, 0, 1, 3, 2, 0, 3, 3, 4, 0, 4, 1, 3, 4, 2, 1, 1, 4, 0, 1);
    case 8:
        return DRAW("a hole", 0, 0, 9, 0, 9, 9, 0, 9, 0, 0, 3, 3, 3, 6, 6, 6, 6, 3, 3, 3);
    case 9:
        return DRAW("two holes", 0, 0, 12, 0, 12, 8, 0, 8, 0, 0, 2, 2, 2, 5, 5, 5, 7, 5, 7, 6, 9, 6,
                    9, 2, 7, 2, 7, 5, 5, 5, 5, 2, 2, 2);
    case 10:
        return DRAW("two holes of one corner", 0, 0, 12, 0, 12, 8, 0, 8, 0, 0, 2, 2, 2, 5, 5, 5, 5,
                    2, 2, 2, 0, 0, 7, 2, 7, 5, 9, 5, 9, 1, 7, 2);
    case 11:
        return DRAW("two that touch", 0, 0, 2, 0, 1, 1, 2, 2, 0, 2, 1, 1);
    case 12:
        return DRAW("a hole that touches", 0, 0, 8, 0, 8, 8, 0, 8, 0, 0, 2, 4, 4, 2);
    case 13:
        return DRAW("a hole that touches an edge", 0, 0, 4, 0, 2, 3, 4, 5, 6, 3, 4, 0, 8, 0, 8, 8,
                    0, 8);
    case 14:
        return DRAW("a tip that touches an edge from inside", 0, 0, 8, 0, 8, 8, 5, 8, 4, 0, 3, 8, 0,
                    8);
    case 15:
        return DRAW("a tip that touches an edge from outside", 0, 0, 8, 0, 8, 8, 4, 1, 6, 7, 0, 8);
    case 16:
        return DRAW("a spike outwards", 0, 0, 4, 0, 4, 4, 7, 7, 4, 4, 0, 4);
    case 17:
        return DRAW("a spike inwards", 0, 0, 5, 0, 5, 5, 2, 2, 5, 5, 0, 5);
    case 18:
        return DRAW("a spike along an edge", 0, 0, 5, 0, 2, 0, 5, 0, 5, 5, 0, 5, 0, 2, 2, 2, 0, 2);
    case 19:
        return DRAW("three petals", 0, 0, 3, 1, 3, 3, 0, 0, -1, 3, -3, 3, 0, 0, -1, -3, 1, -3);
    case 20:
        return DRAW("two that a bent path joins", 0, 0, 3, 0, 3, 2, 6, 5, 9, 2, 9, 0, 12, 0, 12, 5,
                    9, 2, 6, 5, 3, 2, 0, 2);
    case 21:
        return DRAW("a tree", 0, 0, 3, 0, 3, 3, 6, 3, 3, 3, 3, 6, 4, 9, 3, 6, 0, 8, 3, 6, 3, 3, 0,
                    3);
    case 22:
        return DRAW("a hole on a bent path", 0, 0, 9, 0, 9, 9, 0, 9, 0, 0, 1, 3, 3, 3, 3, 6, 6, 6,
                    6, 3, 3, 3, 1, 3);
    default:
        return DRAW("a hole that touches twice", 0, 0, 8, 0, 8, 8, 0, 8, 0, 0, 2, 5, 8, 8, 5, 2);
    }
}

static drawing turned(const drawing *d, uint32_t shift, int is_reversed) {
    drawing to = *d;
    for (uint32_t i = 0; i < d->n; i++) {
        const uint32_t from = ((is_reversed ? d->n - i : i) + shift) % d->n;
        memcpy(to.at[i], d->at[from], sizeof to.at[i]);
        to.lift[i] = d->lift[from];
    }
    return to;
}

/* Puts another corner behind corner `after`, on the edge: at 0 it repeats that corner. */
static void insert(drawing *d, uint32_t after, double along) {
    const uint32_t next = (after + 1) % d->n;
    point p;
    for (int a = 0; a < 2; a++) {
        p[a] = d->at[after][a] + along * (d->at[next][a] - d->at[after][a]);
    }
    memmove(d->at[after + 2], d->at[after + 1], (d->n - after - 1) * sizeof *d->at);
    memmove(&d->lift[after + 2], &d->lift[after + 1], (d->n - after - 1) * sizeof *d->lift);
    memcpy(d->at[after + 1], p, sizeof p);
    d->lift[after + 1] = d->lift[after];
    d->n++;
}

/* ---- placing ----------------------------------------------------------- */

static placing flat(void) {
    return (placing){.matrix = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .scale = 1};
}

static void rotate(placing *p, int axis, double angle) {
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    for (int k = 0; k < 3; k++) {
        const double u = p->matrix[k][x], v = p->matrix[k][y];
        p->matrix[k][x] = u * cos(angle) - v * sin(angle);
        p->matrix[k][y] = u * sin(angle) + v * cos(angle);
    }
}

static placing somewhere(double scale, double distance) {
    placing p = flat();
    for (int axis = 0; axis < 3; axis++) {
        rotate(&p, axis, 6.3 * chance());
        p.offset[axis] = distance * (2 * chance() - 1);
    }
    p.scale = scale;
    p.is_rounded = 1;
    return p;
}

static void place(const drawing *d, const placing *p) {
    for (uint32_t i = 0; i < d->n; i++) {
        for (int a = 0; a < 3; a++) {
            const double x = d->at[i][0] * p->matrix[0][a] + d->at[i][1] * p->matrix[1][a] +
                             d->lift[i] * p->matrix[2][a];
            const double placed = x * p->scale + p->offset[a];
            space[i][a] = p->is_rounded ? (double)(float)placed : placed;
        }
    }
}

/* How far rounding can have moved a corner, in the drawing. */
static double noise_of(const drawing *d, const placing *p) {
    double largest = 0;
    for (uint32_t i = 0; i < d->n; i++) {
        for (int a = 0; a < 3; a++) {
            largest = fmax(largest, fabs(space[i][a]));
        }
    }
    return 0x1p-23 * largest / p->scale;
}

/* ---- the oracle -------------------------------------------------------- */

static double area2(const point a, const point b, const point c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static double outline_area(const drawing *d) {
    double sum = 0;
    for (uint32_t i = 1; i + 1 < d->n; i++) {
        sum += area2(d->at[0], d->at[i], d->at[i + 1]);
    }
    return sum;
}

static double distance(const point a, const point b, const point p) {
    const double dx = b[0] - a[0], dy = b[1] - a[1], x = p[0] - a[0], y = p[1] - a[1];
    const double length = dx * dx + dy * dy;
    const double t = length > 0 ? fmin(1, fmax(0, (x * dx + y * dy) / length)) : 0;
    return hypot(x - t * dx, y - t * dy);
}

static int winding_by(const point a, const point b, const point p) {
    if ((a[1] <= p[1]) == (b[1] <= p[1])) {
        return 0;
    }
    return (area2(a, b, p) > 0) == (b[1] > a[1]) ? (b[1] > a[1] ? 1 : -1) : 0;
}

/* Checks a point, unless it is too near to an edge to tell. */
static void check_covered(const drawing *d, const point p, double noise) {
    int winds = 0, covers = 0;
    for (uint32_t i = 0; i < d->n; i++) {
        const double *a = d->at[i], *b = d->at[(i + 1) % d->n];
        if (distance(a, b, p) <= 8 * noise) {
            return;
        }
        winds += winding_by(a, b, p);
    }
    for (uint32_t i = 0; i < 3 * (d->n - 2); i++) {
        const double *a = d->at[result[i]], *b = d->at[result[i - i % 3 + (i + 1) % 3]];
        if (distance(a, b, p) <= 8 * noise) {
            return;
        }
        covers += winding_by(a, b, p);
    }
    CHECK(covers == winds, "%s: (%g %g) covered %d times, not %d", d->name, p[0], p[1], covers,
          winds);
    int triangles = 0;
    for (uint32_t t = 0; t < d->n - 2; t++) {
        int inside = 0;
        for (int k = 0; k < 3; k++) {
            inside += winding_by(d->at[result[3 * t + k]], d->at[result[3 * t + (k + 1) % 3]], p);
        }
        triangles += inside != 0;
    }
    CHECK(triangles == abs(winds) && triangles <= 1, "%s: (%g %g) in %d triangles, not %d", d->name,
          p[0], p[1], triangles, winds);
}

static void check_samples(const drawing *d, double noise) {
    double lo[2] = {1e300, 1e300}, hi[2] = {-1e300, -1e300};
    for (uint32_t i = 0; i < d->n; i++) {
        for (int a = 0; a < 2; a++) {
            lo[a] = fmin(lo[a], d->at[i][a]);
            hi[a] = fmax(hi[a], d->at[i][a]);
        }
    }
    for (int i = 0; i < 40; i++) {
        const point p = {lo[0] + chance() * (hi[0] - lo[0]), lo[1] + chance() * (hi[1] - lo[1])};
        check_covered(d, p, noise);
    }
    for (uint32_t t = 0; t < d->n - 2; t += 1 + d->n / 40) {
        point p = {0, 0};
        for (int k = 0; k < 3; k++) {
            p[0] += d->at[result[3 * t + k]][0] / 3;
            p[1] += d->at[result[3 * t + k]][1] / 3;
        }
        check_covered(d, p, noise);
    }
}

static int compare_edges(const void *a, const void *b) {
    return memcmp(a, b, 12);
}

/* Every edge of the outline belongs to one triangle, every other edge to two. */
static void check_edges(const drawing *d) {
    static uint32_t edge[3 * MOST + MOST][3];
    const uint32_t count = 3 * (d->n - 2);
    for (uint32_t i = 0; i < count + d->n; i++) {
        const uint32_t from = i < count ? result[i] : (i - count + 1) % d->n;
        const uint32_t to = i < count ? result[i - i % 3 + (i + 1) % 3] : i - count;
        edge[i][0] = from < to ? from : to;
        edge[i][1] = from < to ? to : from;
        edge[i][2] = from < to;
        CHECK(from < d->n && to < d->n && from != to, "%s: %u %u", d->name, from, to);
    }
    qsort(edge, count + d->n, sizeof *edge, compare_edges);
    for (uint32_t i = 0; i < count + d->n; i += 2) {
        CHECK(edge[i][0] == edge[i + 1][0] && edge[i][1] == edge[i + 1][1] &&
                  edge[i][2] + edge[i + 1][2] == 1,
              "%s: edge %u %u", d->name, edge[i][0], edge[i][1]);
    }
}

static void check_filled(const drawing *d, double noise) {
    const double area = outline_area(d), sign = area < 0 ? -1 : 1;
    double sum = 0;
    for (uint32_t t = 0; t < d->n - 2; t++) {
        const double *a = d->at[result[3 * t]], *b = d->at[result[3 * t + 1]],
                     *c = d->at[result[3 * t + 2]];
        const double size = hypot(b[0] - a[0], b[1] - a[1]) + hypot(c[0] - b[0], c[1] - b[1]);
        const double own = area2(a, b, c);
        sum += own;
        CHECK(own * sign >= -8 * noise * (size + noise) - 1e-12 * size * size,
              "%s: triangle %u %u %u has %g", d->name, result[3 * t], result[3 * t + 1],
              result[3 * t + 2], own * sign);
    }
    CHECK(fabs(sum - area) <= 1e-9 * fabs(area), "%s: %g, not %g", d->name, sum, area);
    check_edges(d);
    check_samples(d, fmax(noise, 1e-12));
}

static int is_fan_result(uint32_t n) {
    for (uint32_t i = 0; i < n - 2; i++) {
        if (result[3 * i] != 0 || result[3 * i + 1] != i + 1 || result[3 * i + 2] != i + 2) {
            return 0;
        }
    }
    return 1;
}

static int triangulate(const drawing *d, const placing *p) {
    place(d, p);
    memset(result, 0xFF, sizeof result);
    return polygon_triangulate(&scratch, (const double(*)[3])space, d->n, result);
}

static void expect_filled(const drawing *d, const placing *p) {
    const int kind = triangulate(d, p);
    CHECK(kind == POLYGON_FILLED, "%s of %u: %d, noise %g", d->name, d->n, kind,
          p->is_rounded ? noise_of(d, p) : 0);
    if (kind == POLYGON_FILLED) {
        check_filled(d, p->is_rounded ? noise_of(d, p) : 0);
    }
}

/* Where noise is beyond a thousandth of the face, a dent may be meant: it is filled, somehow. */
static void expect_fan(const drawing *d, const placing *p) {
    const int kind = triangulate(d, p);
    if (p->is_rounded && noise_of(d, p) > 0x1p-9) {
        CHECK(kind == POLYGON_FILLED, "%s of %u: %d noise %g", d->name, d->n, kind, noise_of(d, p));
        return;
    }
    CHECK(kind == POLYGON_FILLED && is_fan_result(d->n), "%s of %u: %d noise %g", d->name, d->n,
          kind, p->is_rounded ? noise_of(d, p) : 0);
}

static void expect_overlaps(const drawing *d, const placing *p) {
    const int kind = triangulate(d, p);
    CHECK(kind == POLYGON_OVERLAPS && is_fan_result(d->n), "%s of %u: %d", d->name, d->n, kind);
}

/* From every corner, in both directions. */
static void every_way(const drawing *d, const placing *p,
                      void (*expect)(const drawing *, const placing *)) {
    for (uint32_t shift = 0; shift < d->n; shift++) {
        for (int is_reversed = 0; is_reversed < 2; is_reversed++) {
            const drawing t = turned(d, shift, is_reversed);
            expect(&t, p);
        }
    }
}

/* ---- properties -------------------------------------------------------- */

static void test_drawings(void) {
    const placing here = flat();
    test("concave, self-touching and bridged outlines are filled from every corner, both ways");
    for (int which = 0; which < DRAWINGS; which++) {
        const drawing d = drawing_of(which);
        every_way(&d, &here, expect_filled);
    }
    test("so they are in any orientation, rounded, from 1e-6 to 1e6");
    for (int which = 0; which < DRAWINGS; which++) {
        const drawing d = drawing_of(which);
        for (int i = 0; i < 12; i++) {
            const placing p = somewhere(pow(10, below(13) - 6.0), 0);
            const drawing t = turned(&d, below(d.n), i % 2);
            expect_filled(&t, &p);
        }
    }
    test("and far from the origin, as long as rounding leaves their shape");
    for (int which = 0; which < DRAWINGS; which++) {
        const drawing d = drawing_of(which);
        for (int i = 0; i < 60; i++) {
            const double scale = pow(10, below(7) - 3.0);
            const placing p = somewhere(scale, scale * pow(10, below(5)));
            const drawing t = turned(&d, below(d.n), i % 2);
            expect_filled(&t, &p);
        }
    }
}

static void check_inserted(double along, const placing *p) {
    for (int which = 0; which < DRAWINGS; which++) {
        const drawing whole = drawing_of(which);
        for (uint32_t after = 0; after < whole.n; after++) {
            drawing d = whole;
            insert(&d, after, along);
            const drawing t = turned(&d, below(d.n), (int)after % 2);
            expect_filled(&t, p);
        }
        drawing all = whole;
        for (uint32_t after = 0; after < all.n; after += 2) {
            insert(&all, after, along);
        }
        const drawing t = turned(&all, below(all.n), which % 2);
        expect_filled(&t, p);
    }
}

static void test_inserted(void) {
    const placing here = flat();
    test("a collinear corner may stand in any edge, and in all");
    check_inserted(0.5, &here);
    test("a corner may be repeated anywhere, and all");
    check_inserted(0, &here);
    test("both also where rounding moves them off the edge");
    for (int i = 0; i < 10; i++) {
        const placing p = somewhere(1, i < 3 ? 0 : i * i * 10);
        check_inserted(0.3, &p);
        check_inserted(0, &p);
    }
}

static void test_lifted(void) {
    test("outlines that are not flat are filled as seen along their normal");
    for (int which = 0; which < SIMPLE_DRAWINGS; which++) {
        for (int i = 0; i < 20; i++) {
            drawing d = drawing_of(which);
            /* Symmetric lifts keep the normal: a paraboloid's slope at the centre. */
            const double bend = 0.02 * chance();
            for (uint32_t k = 0; k < d.n; k++) {
                d.lift[k] = bend * (chance() - 0.5);
            }
            const placing p = somewhere(1, 0);
            place(&d, &p);
            const int kind = triangulate(&d, &p);
            CHECK(kind == POLYGON_FILLED, "%s: %d", d.name, kind);
            check_filled(&d, 0.03);
        }
    }
}

static drawing convex(uint32_t n) {
    drawing d = {.name = "convex"};
    double angle = 0;
    for (uint32_t i = 0; i < n; i++) {
        put(&d, 3 * cos(angle), 2 * sin(angle));
        angle += (0.2 + 0.8 * chance()) * 2 * 3.14159265358979 / n;
    }
    return d;
}

static void test_convex(void) {
    test("convex faces are the fan, also with collinear and with repeated corners");
    for (int i = 0; i < 3000; i++) {
        drawing d = convex(4 + below(12));
        for (uint32_t more = below(8); more > 0; more--) {
            insert(&d, below(d.n), below(4) / 4.0);
        }
        const drawing t = turned(&d, below(d.n), i % 2);
        const placing here = flat(), p = somewhere(pow(10, below(13) - 6.0), 0);
        const placing far = somewhere(1, pow(10, below(6)));
        expect_fan(&t, &here);
        expect_fan(&t, &p);
        expect_fan(&t, &far);
    }
    test("squares with collinear corners are the fan, wherever they are");
    for (int i = 0; i < 3000; i++) {
        drawing d = DRAW("square", 0, 0, 1, 0, 1, 1, 0, 1);
        for (uint32_t more = below(8); more > 0; more--) {
            insert(&d, below(d.n), below(8) / 8.0);
        }
        const drawing t = turned(&d, below(d.n), i % 2);
        const placing p = somewhere(1, pow(10, below(8) - 2.0));
        expect_fan(&t, &p);
    }
    test("saddles and faces without area are the fan");
    for (int i = 0; i < 1000; i++) {
        drawing d = DRAW("saddle", 0, 0, 1, 0, 1, 1, 0, 1);
        for (uint32_t k = 0; k < 4; k++) {
            d.lift[k] = k % 2 ? 0.7 : 0;
        }
        const placing p = somewhere(1, i % 2 ? 0 : 1000);
        expect_fan(&d, &p);
        drawing line = {.name = "line"};
        const uint32_t n = 3 + below(9);
        for (uint32_t k = 0; k < n; k++) {
            put(&line, i % 3 ? below(7) : 5, 0);
        }
        expect_fan(&line, &p);
    }
}

static drawing wound(uint32_t n, uint32_t step) {
    drawing d = {.name = "wound"};
    for (uint32_t i = 0; i < n; i++) {
        const double angle = 2 * 3.14159265358979 * i * step / n;
        put(&d, cos(angle), sin(angle));
    }
    return d;
}

static drawing ring_that_overlaps(void) {
    drawing d = {.name = "a ring that overlaps its beginning"};
    for (int i = 0; i <= 40; i++) {
        const double angle = 0.17 * i;
        put(&d, 3 * cos(angle), 3 * sin(angle));
    }
    for (int i = 40; i >= 0; i--) {
        const double angle = 0.17 * i;
        put(&d, 2 * cos(angle), 2 * sin(angle));
    }
    return d;
}

static void test_overlaps(void) {
    const drawing crossing[] = {
        DRAW("bow tie", 0, 0, 2, 2, 2, 0, 0, 2),
        DRAW("uneven bow tie", 0, 0, 3, 2, 3, 0, 0, 1),
        DRAW("eight", 0, 0, 1, 0, 3, 2, 4, 2, 4, 1, 3, 1, 1, 2, 0, 2),
        DRAW("bow tie through a corner", 0, 0, 1, 1, 2, 2, 2, 0, 1, 1, 0, 2),
        wound(5, 2),
        wound(7, 3),
        wound(9, 4),
        ring_that_overlaps(),
        DRAW("twice around", 0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 4, 0, 4, 4, 0, 4),
        DRAW("a loop inside", 0, 0, 9, 0, 9, 9, 0, 9, 0, 0, 3, 2, 3, 3, 2, 3),
        DRAW("a square across an L", 0, 0, 6, 0, 6, 1, 1, 1, 1, 3, 4, 3, 4, -2, 5, -2, 5, 4, 0, 4),
    };
    test("what crosses itself or winds twice is reported, and is the fan");
    for (size_t i = 0; i < sizeof crossing / sizeof *crossing; i++) {
        const placing here = flat();
        every_way(&crossing[i], &here, expect_overlaps);
        for (int k = 0; k < 10; k++) {
            const placing p = somewhere(pow(10, below(9) - 4.0), k % 2 ? 0 : 100);
            const placing far = somewhere(1, 1000);
            expect_overlaps(&crossing[i], &p);
            expect_overlaps(&crossing[i], k % 2 ? &p : &far);
        }
    }
    test("so are outlines wound two and three times, of many corners");
    for (uint32_t n = 9; n < 60; n += 2) {
        const placing p = somewhere(1, 10);
        const drawing twice = wound(n, 2);
        expect_overlaps(&twice, &p);
        if (n % 3) {
            const drawing thrice = wound(n, 3);
            expect_overlaps(&thrice, &p);
        }
    }
}

/* ---- random outlines --------------------------------------------------- */

static int crosses(const point a, const point b, const point c, const point d) {
    return (area2(a, b, c) > 0) != (area2(a, b, d) > 0) &&
           (area2(c, d, a) > 0) != (area2(c, d, b) > 0);
}

/* Random points in an order that crosses nowhere: crossings are turned around until
 * there are none, which each time makes the tour shorter. */
static drawing random_simple(uint32_t n) {
    drawing d = {.name = "random"};
    for (uint32_t i = 0; i < n; i++) {
        put(&d, chance(), chance());
    }
    for (int changed = 1; changed;) {
        changed = 0;
        for (uint32_t i = 0; i < n; i++) {
            for (uint32_t k = i + 2; k < n - (i == 0); k++) {
                if (!crosses(d.at[i], d.at[i + 1], d.at[k], d.at[(k + 1) % n])) {
                    continue;
                }
                changed = 1;
                for (uint32_t lo = i + 1, hi = k; lo < hi; lo++, hi--) {
                    point swapped;
                    memcpy(swapped, d.at[lo], sizeof swapped);
                    memcpy(d.at[lo], d.at[hi], sizeof swapped);
                    memcpy(d.at[hi], swapped, sizeof swapped);
                }
            }
        }
    }
    return d;
}

static drawing random_star(uint32_t n) {
    drawing d = {.name = "random star"};
    for (uint32_t i = 0; i < n; i++) {
        const double angle = 2 * 3.14159265358979 * i / n, r = 0.1 + chance();
        put(&d, r * cos(angle), r * sin(angle));
    }
    return d;
}

static drawing random_monotone(uint32_t n) {
    drawing d = {.name = "random monotone"};
    for (uint32_t i = 0; i < n; i++) {
        put(&d, i, -0.01 - 5 * chance());
    }
    for (uint32_t i = n; i-- > 0;) {
        put(&d, i, 0.01 + 5 * chance());
    }
    return d;
}

static void test_random(void) {
    test("random simple outlines are filled");
    for (int i = 0; i < 300; i++) {
        const drawing d = i % 3 == 0   ? random_simple(5 + below(i % 30 ? 40 : 250))
                          : i % 3 == 1 ? random_star(5 + below(80))
                                       : random_monotone(3 + below(60));
        const placing here = flat(), p = somewhere(pow(10, below(13) - 6.0), 0);
        expect_filled(&d, &here);
        expect_filled(&d, &p);
    }
    test("on small grids, where much touches, what is filled is filled rightly");
    int filled = 0;
    for (int i = 0; i < 200000; i++) {
        drawing d = {.name = "grid"};
        const uint32_t n = 4 + below(6);
        for (uint32_t k = 0; k < n; k++) {
            put(&d, below(4), below(4));
        }
        const placing here = flat();
        if (triangulate(&d, &here) == POLYGON_FILLED) {
            filled++;
            check_filled(&d, 0);
        } else {
            CHECK(is_fan_result(n), "%u", n);
        }
    }
    CHECK(filled > 20000, "%d", filled);
}

/* ---- many corners ------------------------------------------------------ */

typedef struct big {
    double (*corner)[3];
    uint32_t n, *to;
    double angle; /* it is drawn at, of a plane that rises */
} big;

static void put_big(big *b, double x, double y) {
    double *p = b->corner[b->n++];
    p[0] = (double)(float)(x * cos(b->angle) - y * sin(b->angle));
    p[1] = (double)(float)(x * sin(b->angle) + y * cos(b->angle));
    p[2] = (double)(float)(0.25 * p[0]);
}

static void big_comb(big *b, uint32_t n) {
    put_big(b, 0, 0);
    put_big(b, 1, 0);
    for (uint32_t i = n / 2; i > 0; i--) {
        put_big(b, 2.0 * i / n, 0.2 + 0.1 * chance());
        put_big(b, 2.0 * (i - 0.5) / n, 0.9 + 0.1 * chance());
    }
    put_big(b, 0, 0.2);
}

static void big_spiral(big *b, uint32_t n) {
    for (uint32_t i = 0; i < n; i++) {
        const double along = 2000.0 * (i < n / 2 ? i : n - 1 - i) / n;
        const double r = along + (i < n / 2 ? 4 : 1);
        put_big(b, r * cos(along), r * sin(along));
    }
}

static void big_star(big *b, uint32_t n) {
    for (uint32_t i = 0; i < n; i++) {
        const double angle = 2 * 3.14159265358979 * i / n, r = 0.1 + chance();
        put_big(b, r * cos(angle), r * sin(angle));
    }
}

static void big_hole(big *b, uint32_t n) {
    put_big(b, 0, 0);
    put_big(b, 9, 0);
    put_big(b, 9, 9);
    put_big(b, 0, 9);
    put_big(b, 0, 0);
    for (uint32_t i = 0; i <= n; i++) {
        const double angle = 2 * 3.14159265358979 * (i % n) / n;
        put_big(b, 5 - 2 * cos(angle), 5 + 2 * sin(angle));
    }
}

static void big_tangle(big *b, uint32_t n) {
    for (uint32_t i = 0; i < n; i++) {
        put_big(b, chance(), chance());
    }
}

/* Steps per corner. */
static double expect_big(void (*draw_big)(big *, uint32_t), uint32_t n, double angle, int kind) {
    big b = {.angle = angle};
    b.corner = malloc((n + 6) * sizeof *b.corner);
    b.to = malloc(3 * (size_t)(n + 6) * sizeof *b.to);
    polygon p = {0};
    double steps = 0;
    if (b.corner && b.to) {
        draw_big(&b, n);
        const int got = polygon_triangulate(&p, (const double(*)[3])b.corner, b.n, b.to);
        CHECK(got == kind, "%u corners: %d", b.n, got);
        steps = (double)(p.sweep.work + p.ears.work) / b.n;
    }
    polygon_free(&p);
    free(b.corner);
    free(b.to);
    return steps;
}

static void test_big(void) {
    test("a hundred thousand and a million corners take tens of steps each");
    for (int i = 0; i < 4; i++) {
        const uint32_t n = i < 3 ? 100000 : 1000000;
        CHECK(expect_big(big_comb, n, i, POLYGON_FILLED) < 60, "comb");
        CHECK(expect_big(big_star, n, i, POLYGON_FILLED) < 60, "star");
        CHECK(expect_big(big_spiral, n, i, POLYGON_FILLED) < 60, "spiral");
    }
    test("a bridged hole of a hundred thousand takes hundreds, and a tangle is seen at once");
    CHECK(expect_big(big_hole, 100000, 0, POLYGON_FILLED) < 600, "hole");
    CHECK(expect_big(big_hole, 100000, 1, POLYGON_FILLED) < 600, "hole");
    CHECK(expect_big(big_tangle, 100000, 0, POLYGON_OVERLAPS) < 60, "tangle");
}

/* Corners on the four of a square, where every cut has hundreds of points to look at. */
static void test_many_tangles(void) {
    test("hopeless outlines share what they may take: a file of them takes linear time");
    enum { CORNERS = 2500, OUTLINES = 40 };
    static double corner[CORNERS][3];
    static uint32_t to[3 * CORNERS];
    polygon p = {0};
    int overlap = 0;
    for (int i = 0; i < OUTLINES; i++) {
        for (uint32_t k = 0; k < CORNERS; k++) {
            corner[k][0] = below(2);
            corner[k][1] = below(2);
        }
        overlap +=
            polygon_triangulate(&p, (const double(*)[3])corner, CORNERS, to) == POLYGON_OVERLAPS;
    }
    const double most = 0x1p25 + 0x1p10 * CORNERS * OUTLINES;
    CHECK((double)p.ears.work > 0x1p25 && (double)p.ears.work < most, "%llu steps",
          (unsigned long long)p.ears.work);
    CHECK(overlap == OUTLINES, "%d", overlap);
    const drawing d = drawing_of(8);
    const placing here = flat();
    place(&d, &here);
    CHECK(polygon_triangulate(&p, (const double(*)[3])space, d.n, to) == POLYGON_FILLED,
          "a hole after them");
    polygon_free(&p);
}

static void test_extremes(void) {
    test("sizes from 1e-30 to 1e12 are filled");
    for (int exponent = -30; exponent <= 11; exponent++) {
        for (int which = 0; which < DRAWINGS; which++) {
            const placing p = somewhere(pow(10, exponent), 0);
            const drawing d = drawing_of(which);
            expect_filled(&d, &p);
        }
    }
    test("the side of a line is exact");
    for (int i = 0; i < 10000; i++) {
        const int64_t x = below(1u << 30), y = below(1u << 30), k = 1 + below(1u << 20);
        const point a = {0, 0}, b = {(double)x, (double)y};
        const point on = {(double)(x * k), (double)(y * k)}, up = {on[0], on[1] + 1};
        CHECK(orient2(a, b, on) == 0, "%lld %lld", (long long)x, (long long)y);
        CHECK((orient2(a, b, up) > 0) == (x > 0) && orient2(b, a, up) <= 0, "%lld", (long long)x);
    }
}

int main(void) {
    test_drawings();
    test_inserted();
    test_lifted();
    test_convex();
    test_overlaps();
    test_random();
    test_extremes();
    test_big();
    test_many_tangles();
    polygon_free(&scratch);
    return test_done();
}
