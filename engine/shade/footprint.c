/* footprint - the pixels of a square that a triangle may cover
 *
 * A triangle whose corners are all in front of the eye, and not too far beside the square, is
 * projected: three edge functions, linear in the pixel, over the pixels of its rectangle. Of
 * any other the edge functions are planes through the eye and an edge, which need no
 * division; they are looked at in all pixels. What is not surely outside is tested exactly.
 *
 * Source: Pineda, "A parallel algorithm for polygon rasterization", 1988 (edge functions).
 * Margins: DESIGN.md, section 7.7.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/lanes/unroll.h"
#include "engine/shade/beam.h"
#include "engine/trace/triangle_common.h"

/* Apart, as it would take registers from the others. */
#ifdef __GNUC__
#define RARELY __attribute__((noinline)) static
#else
#define RARELY static
#endif

#define DEPTH_LEAST 7.8886090522101181e-31f /* 2^-100: below, products may underflow */
#define PLANE_LEAST 7.8886090522101181e-31f /* 2^-100: what underflow takes of a plane */
#define SLACK_MOST (0.49f * PLT_PIXEL_SLACK)
#define NEARER (1.0f - PLT_PIXEL_SLACK)
#define ALMOST_ONE 0.9999f /* x + this, cut off, is at most ceil(x) */

/* ---- the exact test ------------------------------------------------------------ */

static int wins_ties(const plt_beam *b, const plt_pixel *pixel, const plt_record *record) {
    return pixel->record == PLT_MISS ||
           plt_primitive_id(plt_get_u32(&record->word[9])) <
               plt_primitive_id(plt_get_u32(&b->records[pixel->record].word[9]));
}

static int find_hit(const plt_beam *b, const plt_record *record, uint32_t x, uint32_t y, float tmax,
                    int wins, plt_ray_hit *hit) {
    float corner[3][3], dir[3];
    plt_record_corners(record, corner);
    plt_view_direction(b->view, b->square.x + x, b->square.y + y, dir);
    return plt_triangle_ray(&b->origin, dir, (const float(*)[3])corner, tmax, wins, hit);
}

void plt_beam_settle(plt_beam *b, uint32_t x, uint32_t y) {
    plt_pixel *pixel = &b->pixel[y * b->square.side + x];
    plt_ray_hit hit;
    if (pixel->record != PLT_MISS && (pixel->record & PLT_PIXEL_BOUND) != 0) {
        pixel->record = plt_pixel_record(pixel);
        if (find_hit(b, &b->records[pixel->record], x, y, PLT_VIEW_FAR, 1, &hit)) { /* it is one */
            pixel->t = hit.t;
        }
    }
}

static void take(plt_beam *b, plt_pixel *pixel, float t, uint32_t record) {
    b->open -= pixel->record == PLT_MISS;
    b->is_stored = 1;
    pixel->t = t;
    pixel->record = record;
}

static void test_pixel(plt_beam *b, const plt_record *record, uint32_t x, uint32_t y) {
    plt_pixel *pixel = &b->pixel[y * b->square.side + x];
    plt_ray_hit hit;
    plt_beam_settle(b, x, y);
    if (find_hit(b, record, x, y, pixel->t, wins_ties(b, pixel, record), &hit)) {
        take(b, pixel, hit.t, (uint32_t)(record - b->records));
    }
}

/* ---- planes through the eye -------------------------------------------------------------- */

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static float size_of(const float a[3]) {
    const float x = __builtin_fabsf(a[0]), y = __builtin_fabsf(a[1]), z = __builtin_fabsf(a[2]);
    const float xy = x > y ? x : y;
    return xy > z ? xy : z;
}

/* In pixel (x, y): at + x * right + y * down. */
typedef struct edge {
    float at, right, down;
} edge;

RARELY void test_planes(plt_beam *b, const plt_record *record) {
    float q[3][3], margin[3];
    edge e[3];
    plt_record_corners(record, q);
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            q[c][a] -= b->origin.org[a];
        }
    }
    for (int c = 0; c < 3; c++) {
        const float *from = q[plt_axis_after[c]], *to = q[plt_axis_after[plt_axis_after[c]]];
        float normal[3];
        plt_cross(from, to, normal);
        e[c].at = dot(normal, b->first);
        e[c].right = dot(normal, b->view->right);
        e[c].down = dot(normal, b->view->down);
        margin[c] = b->margins.plane * (size_of(from) * size_of(to) + PLANE_LEAST);
    }
    for (uint32_t y = 0; y < b->rows; y++) {
        for (uint32_t x = 0; x < b->columns; x++) {
            unsigned sides = 0; /* 1: surely above, 2: surely below */
            for (int c = 0; c < 3; c++) {
                const float at = e[c].at + (float)x * e[c].right + (float)y * e[c].down;
                sides |= (unsigned)(at > margin[c]) | (unsigned)(at < -margin[c]) << 1;
            }
            if (sides != 3) {
                test_pixel(b, record, x, y);
            }
        }
    }
}

/* ---- projection -------------------------------------------------------------------------- */

/* A triangle in a square of pixels: its corners, and the pixels that may be in it, both ends
 * included. */
typedef struct projected {
    float x[3], y[3]; /* pixels from the square's first */
    float over[3];    /* 1 / depth */
    float size;       /* width and height together */
    uint32_t left, right, top, bottom;
} projected;

typedef struct range {
    float least, most;
} range;

static inline range range_of(const float v[3]) {
    range r = {v[0], v[1]};
    if (v[0] > v[1]) {
        r.least = v[1];
        r.most = v[0];
    }
    r.least = v[2] < r.least ? v[2] : r.least;
    r.most = v[2] > r.most ? v[2] : r.most;
    return r;
}

/* Whether there is a pixel of 0 .. end between two coordinates. */
static inline int has_pixel(float from, float to, float end) {
    return to >= 0.0f && from <= end && (from <= 0.0f || (float)(int32_t)(from + ALMOST_ONE) <= to);
}

/* Which ones, if there are any. */
static inline void set_pixels(float from, float to, float end, uint32_t *first, uint32_t *last) {
    *first = from > 0.0f ? (uint32_t)(int32_t)(from + ALMOST_ONE) : 0;
    *last = (uint32_t)(int32_t)(to < end ? to : end);
}

/* What all triangles are projected by; of a square, in registers. */
typedef struct projector {
    float org[3], row_w[3], row_x[3], row_y[3];
    float margin, end_x, end_y;
} projector;

static inline void set_projector(projector *k, const plt_beam *b) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        k->org[a] = b->origin.org[a];
        k->row_w[a] = b->margins.row_w[a];
        k->row_x[a] = b->row_x[a];
        k->row_y[a] = b->row_y[a];
    }
    k->margin = b->margins.pixels;
    k->end_x = b->end_x;
    k->end_y = b->end_y;
}

static inline int all_at_least(const float v[3], float limit) {
    return v[0] >= limit && v[1] >= limit && v[2] >= limit;
}

static inline int are_near(range r, float limit) {
    return r.least >= -limit && r.most <= limit;
}

enum projection { OUTSIDE, PROJECTED, NOT_PROJECTED };

/* Not projected: a corner is not in front, or too far beside. A deep triangle without a column
 * or without a row is outside wherever its corners are; `all_deep`: every one is deep. */
static inline enum projection project(const plt_margins *m, const projector *k, const float q[3][3],
                                      int all_deep, projected *p) {
    float depth[3];
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        depth[c] = plt_along(q[c], k->row_w);
    }
    const int deep = all_deep || all_at_least(depth, m->depth);
    if (!deep && !all_at_least(depth, DEPTH_LEAST)) {
        return NOT_PROJECTED;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->over[c] = 1.0f / depth[c];
        p->x[c] = plt_along(q[c], k->row_x) * p->over[c];
    }
    const range x = range_of(p->x);
    const float left = x.least - k->margin, right = x.most + k->margin;
    const int columns = has_pixel(left, right, k->end_x);
    if (!columns && deep) {
        return OUTSIDE;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->y[c] = plt_along(q[c], k->row_y) * p->over[c];
    }
    const range y = range_of(p->y);
    const float top = y.least - k->margin, bottom = y.most + k->margin;
    const int rows = has_pixel(top, bottom, k->end_y);
    if (!rows && deep) {
        return OUTSIDE;
    }
    p->size = (x.most - x.least) + (y.most - y.least);
    const int meets = columns && rows;
    if (meets) {
        set_pixels(left, right, k->end_x, &p->left, &p->right);
        set_pixels(top, bottom, k->end_y, &p->top, &p->bottom);
    }
    if ((meets && p->size <= m->size) || (are_near(x, m->corner) && are_near(y, m->corner))) {
        return meets ? PROJECTED : OUTSIDE;
    }
    return NOT_PROJECTED;
}

/* ---- pixels --------------------------------------------------------------------------------- */

/* Edge functions: of corner c the one across from it, at `at` in the rectangle's first pixel;
 * positive inside, as the area is. */
typedef struct footprint {
    float at[3];
    float sign;  /* of the area that the corners have */
    float error; /* of each function */
    float area;  /* their sum */
    float slack; /* of the sum of their products with `over`; negative: not known yet */
} footprint;

/* An error that leaves no pixel out, and a slack that hides nothing, behind no t: infinity times
 * 0 is a NaN. */
#define UNKNOWN __builtin_inff()

/* What the sum of edge functions times 1 / depth, which is area / t, may be off by, and t itself
 * as the exact test computes it. `over`: the range of 1 / depth. */
RARELY float slack_of(const plt_margins *m, range over, float size, float error, float area) {
    const float length = over.most - over.least;
    const float wide = size * m->step;
    const float side = over.most * wide + (0.34f * m->direction + wide) * length;
    const float slack =
        11.0f * error * length + m->t * over.most * area + m->shape * side * side / over.most;
    const int is_known = area > 16.0f * error && length <= over.least && slack <= over.most * area;
    return is_known ? slack : UNKNOWN;
}

/* Surely inside and surely nearer: takes the pixel, with the greatest t it may have. What is not
 * surely beside or behind either is tested exactly. */
static inline void test_inside(plt_beam *b, const plt_record *record, const projected *p,
                               footprint *f, const float e[3], uint32_t x, uint32_t y) {
    const float in = f->error, out = -in;
    if (!(e[0] >= out && e[1] >= out && e[2] >= out)) {
        return;
    }
    plt_pixel *pixel = &b->pixel[y * b->square.side + x];
    if (f->slack < 0.0f) {
        f->slack = slack_of(&b->margins, range_of(p->over), p->size, f->error, f->area);
    }
    const float over = e[0] * p->over[0] + e[1] * p->over[1] + e[2] * p->over[2];
    if ((over + f->slack) * pixel->t < f->area) {
        return;
    }
    const float least = over - f->slack;
    if (e[0] >= in && e[1] >= in && e[2] >= in && f->slack <= SLACK_MOST * over &&
        least * (pixel->t * NEARER) > f->area) {
        take(b, pixel, f->area / least, (uint32_t)(record - b->records) | PLT_PIXEL_BOUND);
    } else {
        test_pixel(b, record, x, y);
    }
}

static inline void test_all(plt_beam *b, const plt_record *record, const projected *p,
                            footprint *f) {
    float right[3], down[3];
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        const int i = (c + 1) % 3, j = (c + 2) % 3;
        right[c] = (p->y[i] - p->y[j]) * f->sign;
        down[c] = (p->x[j] - p->x[i]) * f->sign;
    }
    for (uint32_t y = p->top; y <= p->bottom; y++) {
        float e[3] = {f->at[0], f->at[1], f->at[2]};
        for (uint32_t x = p->left; x <= p->right; x++) {
            test_inside(b, record, p, f, e, x, y);
            PLT_UNROLLED for (int c = 0; c < 3; c++) {
                e[c] += right[c];
            }
        }
        PLT_UNROLLED for (int c = 0; c < 3; c++) {
            f->at[c] += down[c];
        }
    }
}

static inline void set_edges(footprint *f, const projected *p, float margin) {
    const float x0 = (float)(int32_t)p->left, y0 = (float)(int32_t)p->top;
    const float x[3] = {p->x[0] - x0, p->x[1] - x0, p->x[2] - x0};
    const float y[3] = {p->y[0] - y0, p->y[1] - y0, p->y[2] - y0};
    f->at[0] = x[1] * y[2] - x[2] * y[1];
    f->at[1] = x[2] * y[0] - x[0] * y[2];
    f->at[2] = x[0] * y[1] - x[1] * y[0];
    f->area = f->at[0] + f->at[1] + f->at[2];
    f->error = 4.0f * margin * (p->size + 2.0f * margin);
    f->slack = -1.0f;
    f->sign = 1.0f;
    if (__builtin_fabsf(f->area) <= 4.0f * f->error) { /* its sign is open: no pixel is left out */
        f->error = f->slack = UNKNOWN;
    } else if (f->area < 0.0f) {
        f->sign = -1.0f;
        f->area = -f->area;
        PLT_UNROLLED for (int c = 0; c < 3; c++) {
            f->at[c] = -f->at[c];
        }
    }
}

static inline void test_record(plt_beam *b, const projector *k, const plt_record *record,
                               int all_deep) {
    float q[3][3];
    projected p;
    footprint f;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        q[c][0] = plt_record_float(record, c, 0) - k->org[0];
        q[c][1] = plt_record_float(record, c, 1) - k->org[1];
        q[c][2] = plt_record_float(record, c, 2) - k->org[2];
    }
    const enum projection how = project(&b->margins, k, (const float(*)[3])q, all_deep, &p);
    if (how != PROJECTED) {
        if (how == NOT_PROJECTED) {
            test_planes(b, record);
        }
        return;
    }
    set_edges(&f, &p, b->margins.pixels);
    if (p.left == p.right && p.top == p.bottom) {
        test_inside(b, record, &p, &f, f.at, p.left, p.top);
    } else {
        test_all(b, record, &p, &f);
    }
}

/* Of a field that is too wide or too narrow to project anything. */
RARELY uint32_t test_unprojected(plt_beam *b, const plt_record *begin, uint32_t lists,
                                 uint32_t single) {
    const plt_record *record = begin;
    for (; lists > 0; record++) {
        test_planes(b, record);
        lists -= (uint32_t)plt_record_is_last(record) | single;
    }
    return (uint32_t)(record - begin);
}

uint32_t plt_beam_lists(plt_beam *b, uint32_t first, uint32_t lists, uint32_t single) {
    const plt_record *begin = &b->records[first], *record = begin;
    const int all_deep = b->margins.all_deep;
    projector k;
    if (!b->margins.project) {
        return test_unprojected(b, begin, lists, single);
    }
    set_projector(&k, b);
    for (; lists > 0; record++) {
        test_record(b, &k, record, all_deep);
        lists -= (uint32_t)plt_record_is_last(record) | single;
    }
    return (uint32_t)(record - begin);
}
