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
#define ALMOST_ONE 0.9999f                  /* x + this, cut off, is at most ceil(x) */

/* ---- the exact test ------------------------------------------------------------ */

static int wins_ties(const plt_beam *b, const plt_pixel *pixel, const plt_record *record) {
    return pixel->record == PLT_MISS ||
           plt_primitive_id(plt_get_u32(&record->word[9])) <
               plt_primitive_id(plt_get_u32(&b->records[pixel->record].word[9]));
}

static void test_pixel(plt_beam *b, const plt_record *record, uint32_t x, uint32_t y) {
    plt_pixel *pixel = &b->pixel[y * b->square.side + x];
    float corner[3][3], dir[3];
    plt_ray_hit hit;
    plt_record_corners(record, corner);
    plt_view_direction(b->view, b->square.x + x, b->square.y + y, dir);
    if (plt_triangle_ray(&b->origin, dir, (const float(*)[3])corner, pixel->t,
                         wins_ties(b, pixel, record), &hit)) {
        b->open -= pixel->record == PLT_MISS;
        b->is_stored = 1;
        pixel->t = hit.t;
        pixel->record = (uint32_t)(record - b->records);
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

/* Pixels first .. last of 0 .. end between two coordinates; 0: none. */
static inline int pixels_between(float from, float to, float end, uint32_t *first, uint32_t *last) {
    if (!(to >= 0.0f && from <= end)) {
        *first = *last = 0;
        return 0;
    }
    *first = from > 0.0f ? (uint32_t)(int32_t)(from + ALMOST_ONE) : 0;
    *last = (uint32_t)(int32_t)(to < end ? to : end);
    return *first <= *last;
}

static inline float along(const float q[3], const float row[3]) {
    return q[0] * row[0] + q[1] * row[1] + q[2] * row[2];
}

static inline int all_at_least(const float v[3], float limit) {
    return v[0] >= limit && v[1] >= limit && v[2] >= limit;
}

static inline int are_near(range r, float limit) {
    return r.least >= -limit && r.most <= limit;
}

enum projection { OUTSIDE, PROJECTED, NOT_PROJECTED };

/* Not projected: a corner is not in front, or too far beside. A deep triangle without a column
 * or without a row is outside wherever its corners are. */
static inline enum projection project(const plt_beam *b, const float q[3][3], projected *p) {
    const plt_margins *m = &b->margins;
    float depth[3];
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        depth[c] = along(q[c], m->row_w);
    }
    const int deep = m->all_deep || all_at_least(depth, m->depth);
    if (!deep && !all_at_least(depth, DEPTH_LEAST)) {
        return NOT_PROJECTED;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->over[c] = 1.0f / depth[c];
        p->x[c] = along(q[c], b->row_x) * p->over[c];
    }
    const range x = range_of(p->x);
    const int columns =
        pixels_between(x.least - m->pixels, x.most + m->pixels, b->end_x, &p->left, &p->right);
    if (!columns && deep) {
        return OUTSIDE;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        p->y[c] = along(q[c], b->row_y) * p->over[c];
    }
    const range y = range_of(p->y);
    const int rows =
        pixels_between(y.least - m->pixels, y.most + m->pixels, b->end_y, &p->top, &p->bottom);
    if (!rows && deep) {
        return OUTSIDE;
    }
    p->size = (x.most - x.least) + (y.most - y.least);
    const int meets = columns && rows;
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
    const float side = over.most * size * m->step + m->direction * length;
    const float slack =
        11.0f * error * length + m->t * over.most * area + m->shape * side * side / over.most;
    const int is_known = area > 16.0f * error && length <= over.least && slack <= over.most * area;
    return is_known ? slack : UNKNOWN;
}

static inline int is_behind(const plt_beam *b, const projected *p, footprint *f, const float e[3],
                            const plt_pixel *pixel) {
    if (pixel->record == PLT_MISS) {
        return 0;
    }
    if (f->slack < 0.0f) {
        f->slack = slack_of(&b->margins, range_of(p->over), p->size, f->error, f->area);
    }
    const float over = e[0] * p->over[0] + e[1] * p->over[1] + e[2] * p->over[2];
    return (over + f->slack) * pixel->t < f->area;
}

static inline void test_inside(plt_beam *b, const plt_record *record, const projected *p,
                               footprint *f, const float e[3], uint32_t x, uint32_t y) {
    const float out = -f->error;
    if (e[0] >= out && e[1] >= out && e[2] >= out &&
        !is_behind(b, p, f, e, &b->pixel[y * b->square.side + x])) {
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

static inline void test_record(plt_beam *b, const plt_record *record) {
    float q[3][3];
    projected p;
    footprint f;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        q[c][0] = plt_record_float(record, c, 0) - b->origin.org[0];
        q[c][1] = plt_record_float(record, c, 1) - b->origin.org[1];
        q[c][2] = plt_record_float(record, c, 2) - b->origin.org[2];
    }
    const enum projection how = project(b, (const float(*)[3])q, &p);
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

uint32_t plt_beam_lists(plt_beam *b, uint32_t first, uint32_t lists, uint32_t single) {
    const plt_record *begin = &b->records[first], *record = begin;
    const uint32_t project = b->margins.project;
    for (; lists > 0; record++) {
        if (project) {
            test_record(b, record);
        } else {
            test_planes(b, record);
        }
        lists -= (uint32_t)plt_record_is_last(record) | single;
    }
    return (uint32_t)(record - begin);
}
