/* test_lines - lines of pixels between two coordinates, and margins that pictures cannot show
 *
 * Margins are for the worst of many roundings at once, so frames with less of them come out right,
 * too (test_render_beam). What DESIGN.md, section 7.7, says of them is tested here: against sums in
 * double.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "engine/shade/footprint.h"
#include "tests/reference/random.h"
#include "tests/test.h"

#define UNIT 0x1p-18 /* of plt_lines_between's margin */

/* Whether line `i` is among those of a stretch in a square of `side`. */
static int has_line(plt_lines l, int32_t side, int32_t i) {
    const int32_t end = PLT_LINE_NUMBER + side - 1;
    return plt_lines_any(l, end) && (uint32_t)i >= plt_lines_first(l) &&
           (uint32_t)i <= plt_lines_last(l, end);
}

/* A coordinate: mostly near a square, often on a line or next to one, seldom far away. */
static float any_coordinate(random_state *r) {
    const float near = random_float(r, 8.0f, 40.0f);
    switch (random_below(r, 8)) {
    case 0:
        return roundf(near);
    case 1:
        return nextafterf(roundf(near), random_below(r, 2) ? 0.0f : 64.0f);
    case 2:
        return random_float(r, -100.0f, 100.0f);
    case 3:
        return ldexpf(random_below(r, 2) ? -1.0f : 1.0f, (int)random_below(r, 240) - 120);
    default:
        return near;
    }
}

/* All lines that lie between, the least lowered; and none that is twice as far beside. */
static void stretches(void) {
    random_state r = {1};
    uint32_t missing = 0, more = 0, lines = 0;
    for (uint32_t i = 0; i < 200000; i++) {
        const float a = any_coordinate(&r), b = any_coordinate(&r);
        const float least = a < b ? a : b, most = a < b ? b : a;
        const int32_t margin = 1 + (int32_t)(random_below(&r, 1u << random_below(&r, 20)));
        const int32_t side = 1 + (int32_t)random_below(&r, PLT_PACKET_SIDE_MAX);
        const plt_lines l = plt_lines_between(least, most, margin);
        uint32_t found = 0;
        for (int32_t k = 0; k < side; k++) {
            const double line = 16.0 + k, low = (double)least - margin * UNIT;
            const double lowest = (double)least - (2.0 * margin + 2.0) * UNIT;
            missing += line >= low && line <= (double)most && !has_line(l, side, k);
            more += (line < lowest || line > (double)most) && has_line(l, side, k);
            lines += line >= low && line <= (double)most;
            found += (uint32_t)has_line(l, side, k);
        }
        CHECK((found > 0) == plt_lines_any(l, PLT_LINE_NUMBER + side - 1),
              "from %g to %g: %u lines of %d", (double)least, (double)most, found, side);
    }
    CHECK(lines > 10000, "%u lines lie between", lines);
    CHECK(missing == 0, "%u lines are missing", missing);
    CHECK(more == 0, "%u lines more", more);
}

static void widest(void) {
    static const float at[6] = {-INFINITY, -1e30f, -0.0f, 0.0f, 17.5f, 31.5f};
    for (int i = 0; i < 6; i++) {
        const plt_lines l = plt_lines_between(at[i], INFINITY, PLT_LINE_WIDEST);
        for (int32_t k = 0; k < PLT_PACKET_SIDE_MAX; k++) {
            CHECK(has_line(l, PLT_PACKET_SIDE_MAX, k), "from %g: without line %d", (double)at[i],
                  k);
        }
    }
}

/* Of a view of any field, its tangent below 2^`widest`, and any frame. */
static int any_margins(random_state *r, uint32_t widest, plt_view *v, plt_frame *f, plt_margins *m,
                       uint32_t *side) {
    static const plt_box box = {{-1, -1, -1}, {1, 1, 1}};
    const int power = (int)random_below(r, widest + 24) - 24;
    const float tangent = ldexpf(random_float(r, 1.0f, 2.0f), power);
    *f = (plt_frame){.width = (uint16_t)(1 + random_below(r, 16000)),
                     .height = (uint16_t)(1 + random_below(r, 16000)),
                     .camera = {.eye = {0, 0, 3}, .up = {0, 1, 0}, .tan_half_fov = tangent}};
    *side = 2u << random_below(r, 4);
    if (plt_view_set(v, f) != PLT_OK) {
        return 0;
    }
    plt_margins_set(m, v, f, *side, &box, 5.0f);
    return 1;
}

static double length_of(const float v[3]) {
    return sqrt((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] +
                (double)v[2] * (double)v[2]);
}

/* The letters of 7.7, in double. */
typedef struct letters {
    double s, F, M, A, c, k;
    double det;
} letters;

static letters letters_of(const plt_view *v, const plt_frame *f, const plt_margins *m,
                          uint32_t side) {
    const double right = length_of(v->right), down = length_of(v->down);
    letters l = {.s = fmax(right, down), .det = fabs((double)m->det)};
    for (int i = 0; i < 4; i++) {
        float d[3];
        plt_view_point(v, i & 1 ? (float)(f->width - 1) : 0.0f,
                       i & 2 ? (float)(f->height - 1) : 0.0f, d);
        l.F = fmax(l.F, length_of(d));
    }
    for (int a = 0; a < 3; a++) {
        l.M = fmax(l.M, fabs((double)v->corner[a]) + f->width * fabs((double)v->right[a]) +
                            f->height * fabs((double)v->down[a]));
    }
    l.A = l.s * l.F / l.det;
    l.c = right * down / l.det;
    l.k = side * l.s / l.F;
    return l;
}

/* What edges of a triangle of `size` have to have that meets a square: its corners are within 24
 * pixels and that of the square's first. */
static double least_edge(const letters *l, const plt_margins *m, double size) {
    const double h = (size + 24.0) * l->s, direction = l->F + 2.0 * h;
    const double sum = l->A * ((8.5 + 7.5 * h / l->F) * direction + 13.0 * (1.0 + l->k) * l->M +
                               4.0 * (1.0 + l->k + h / l->F)) +
                       9.0 * direction * (double)m->bias * l->c + 128.0;
    return 0x1p-24 * (1.5 * sum + 18.0 * size);
}

/* Of large triangles, and of 1 / t. */
static void check_others(const letters *l, const plt_margins *m) {
    const double u = 0x1p-24, edge = 1.5 * (double)m->pixels + 37.0 * u * l->A;
    const double t = u * (110.0 * l->c * l->F + 11.0 * l->c * l->M + 100.0);
    CHECK((double)m->edge >= edge && (double)m->edge < 1.5 * edge + 0x1p-17,
          "an edge of %g, not %g", (double)m->edge, edge);
    CHECK((double)m->t >= 0.999 * t && (double)m->t < 1.2 * t, "%g of t, not %g", (double)m->t, t);
    CHECK((double)m->shape >= 504.0 * u * l->F / l->det &&
              (double)m->shape < 1000.0 * u * l->F / l->det,
          "%g of shape", (double)m->shape);
}

/* Margins of small triangles are that at least, and close to it. */
static uint32_t small_edges(const letters *l, const plt_margins *m) {
    if (m->small_growth == 0.0f) {
        CHECK(m->small_edge == m->edge, "an edge of %g, not %g", (double)m->small_edge,
              (double)m->edge);
        return 0;
    }
    CHECK(m->pixels < 1.0f, "small ones, where corners are off by %g", (double)m->pixels);
    for (float size = 0.0f; size <= PLT_SMALL_SIZE; size += 8.0f) {
        const double least = least_edge(l, m, (double)size);
        const double edge = (double)edge_of(m, size);
        CHECK(edge > 0.99999 * least + 0x1p-19 && edge < 2.0 * least,
              "%g pixels: an edge of %g, not %g", (double)size, edge, least);
    }
    return 1;
}

/* What is taken off the least coordinate, added to all, and left to edges. */
static void margins(void) {
    random_state r = {2};
    uint32_t views = 0, told = 0, widest_seen = 0, small = 0;
    for (uint32_t i = 0; i < 4000; i++) {
        plt_margins m;
        plt_frame f;
        plt_view v;
        uint32_t side;
        if (!any_margins(&r, 10, &v, &f, &m, &side) || !m.project) {
            continue;
        }
        const double eps = (double)m.pixels, taken = m.lines * UNIT;
        const int most = m.lines == PLT_LINE_WIDEST;
        CHECK(most ? eps >= 1024.0 : taken > 2.0 * eps && taken < 2.00001 * eps + 3.0 * UNIT,
              "%g pixels, %g taken off", eps, taken);
        CHECK(fabs((double)m.bias - 16.0 - eps) <= 1e-6 * (16.0 + eps), "%g: a bias of %g", eps,
              (double)m.bias);
        CHECK((double)m.edge > 1.5 * eps && (double)m.edge_least > 2.9 * eps * eps,
              "%g pixels, edges %g and %g", eps, (double)m.edge, (double)m.edge_least);
        CHECK(m.size < 0.0f || (m.pixels < 4.0f && 16.0f * m.pixels < m.corner &&
                                m.size == m.corner - (float)side),
              "%g pixels, corners up to %g: no look below %g", eps, (double)m.corner,
              (double)m.size);
        const letters l = letters_of(&v, &f, &m, side);
        check_others(&l, &m);
        small += small_edges(&l, &m);
        views++;
        told += m.size > 0.0f;
        widest_seen += most && eps < 1e6;
    }
    CHECK(views > 1000 && told > 500 && widest_seen > 20 && small > 300,
          "%u views, %u of narrow margins, %u widest, %u of small ones", views, told, widest_seen,
          small);
}

/* Of the widest fields, which project nothing, the sum that is solved for `pixels` has a negative
 * factor: no such number is made whole. */
static void too_wide(void) {
    random_state r = {4};
    uint32_t views = 0;
    for (uint32_t i = 0; i < 4000; i++) {
        plt_margins m;
        plt_frame f;
        plt_view v;
        uint32_t side;
        if (any_margins(&r, 20, &v, &f, &m, &side) && !m.project) {
            CHECK(m.lines >= 0 && m.lines <= PLT_LINE_WIDEST, "%g pixels: %d taken off",
                  (double)m.pixels, m.lines);
            views += !(m.pixels >= 0.0f);
        }
    }
    CHECK(views > 20, "%u views too wide", views);
}

/* A triangle of whole coordinates, turned or not: its own corners are on its edges, to the bit. */
static void corners(void) {
    plt_margins m = {.pixels = 0.25f, .bias = 16.25f};
#if PLT_WITH_SAMPLES
    m.reach = m.pixels;
#endif
    random_state r = {3};
    for (uint32_t i = 0; i < 2000; i++) {
        float x[3], y[3];
        projected p = {.size = 1.0f};
        for (int c = 0; c < 3; c++) {
            x[c] = (float)random_below(&r, PLT_PACKET_SIDE_MAX);
            y[c] = (float)random_below(&r, PLT_PACKET_SIDE_MAX);
            p.x[c] = m.bias + x[c];
            p.y[c] = m.bias + y[c];
            p.over[c] = 1.0f + (float)c;
        }
        const float twice = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        for (int c = 0; c < 3; c++) {
            footprint f;
            projected turned = p;
            set_at(&f, &turned, &m, (uint32_t)x[c], (uint32_t)y[c]);
            set_edges(&f, &turned, &m);
            const float over =
                f.at[0] * turned.over[0] + f.at[1] * turned.over[1] + f.at[2] * turned.over[2];
            CHECK(f.area == fabsf(twice), "an area of %g, not %g", (double)f.area,
                  (double)fabsf(twice));
            CHECK(twice == 0.0f || over == p.over[c] * f.area, "at corner %d %g, not %g", c,
                  (double)(over / f.area), (double)p.over[c]);
        }
    }
}

/* As far as corners may be, from the first pixel and not from where coordinates begin. */
static void near_ones(void) {
    const plt_margins m = {.bias = 16.25f, .corner = 8.0f};
    const range at[4] = {{8.25f, 24.25f}, {8.0f, 16.0f}, {16.0f, 24.5f}, {16.0f, NAN}};
    for (int i = 0; i < 4; i++) {
        CHECK(are_near(&m, at[i]) == (i == 0), "%g to %g", (double)at[i].least, (double)at[i].most);
    }
}

/* A right-angled triangle with legs of 4, whose corners go around either way. */
static footprint of_size(float edge, int turned) {
    const plt_margins m = {.bias = 16.0f, .small_edge = edge, .edge_least = 0.5f};
    projected p = {.x = {16, 20, 16}, .y = {16, 16, 20}, .over = {1, 1, 1}, .size = 8.0f};
    footprint f;
    if (turned) {
        p.x[1] = 16;
        p.x[2] = 20;
        p.y[1] = 20;
        p.y[2] = 16;
    }
    set_at(&f, &p, &m, 1, 1);
    set_edges(&f, &p, &m);
    return f;
}

/* Its area is 16: 12 errors of 1 1/3. */
static void open_sign(void) {
    for (int turned = 0; turned < 2; turned++) {
        const footprint less = of_size(0.1039f, turned), more = of_size(0.1043f, turned);
        CHECK(less.area == 16.0f && less.error > 1.33f && less.error < 1.34f,
              "an area of %g, an error of %g", (double)less.area, (double)less.error);
        CHECK(less.slack < 0.0f, "a slack of %g before it is known", (double)less.slack);
        CHECK(isinf(more.error) && isinf(more.slack), "an error of %g, a slack of %g",
              (double)more.error, (double)more.slack);
    }
}

#if PLT_WITH_SAMPLES
/* Edge functions, and their sum times 1 / depth, differ over a pixel's samples by as much as the
 * spread says: no sample is further from the middle, and one is as far. */
static void spreads(void) {
    random_state r = {5};
    for (uint32_t i = 0; i < 2000; i++) {
        const uint32_t across = i % 2 ? 2 : 4;
        const double half = 0.5 * (across - 1.0);
        plt_frame f = {.width = 64, .height = 64, .camera = {.look = {0, 0, 1}, .up = {0, 1, 0}}};
        plt_view v;
        projected p = {.size = 1.0f};
        slopes s;
        double most[4] = {0, 0, 0, 0};
        f.camera.tan_half_fov = 0.5f;
        CHECK(plt_view_set(&v, &f) == PLT_OK, "a view");
        plt_view_refine(&v, across);
        for (int c = 0; c < 3; c++) {
            p.x[c] = random_float(&r, -64.0f, 64.0f);
            p.y[c] = random_float(&r, -64.0f, 64.0f);
            p.over[c] = random_float(&r, 0.5f, 2.0f);
        }
        set_slopes(&s, &v, &p);
        for (uint32_t k = 0; k < across * across; k++) {
            const double x = (double)plt_view_x(&v, k % across, k / across) - half;
            const double y = (double)plt_view_y(&v, k % across, k / across) - half;
            double over = 0.0;
            for (int c = 0; c < 3; c++) {
                const double by = x * (double)s.right[c] + y * (double)s.down[c];
                most[c] = fmax(most[c], fabs(by));
                over += by * (double)p.over[c];
            }
            most[3] = fmax(most[3], fabs(over));
        }
        for (int c = 0; c < 4; c++) {
            const double spread = (double)(c < 3 ? s.spread[c] : s.over_spread);
            CHECK(spread >= most[c] - 1e-4 && spread <= most[c] + 1e-4, "a spread of %g, not %g",
                  spread, most[c]);
        }
    }
}
#endif

int main(void) {
    test("a stretch has the lines in it, and none that is twice its margin beside");
    stretches();
    test("the widest margin leaves out no line");
    widest();
    test("margins of lines and edges are what they have to be, of any view");
    margins();
    test("margins of fields that are too wide are whole numbers, too");
    too_wide();
    test("corners are near or far as seen from the first pixel");
    near_ones();
    test("edge functions at a triangle's corners are 0 or its area, which is positive");
    corners();
    test("of an area that is not beyond 12 errors no pixel is left out, and nothing hidden");
    open_sign();
#if PLT_WITH_SAMPLES
    test("what is linear differs over a pixel's samples by its spread");
    spreads();
#endif
    return test_done();
}
