/* footprint_edges - a triangle that is projected, and pixels by its edge functions
 *
 * A triangle whose corners are all in front of the eye, and not too far beside the square, is
 * projected: three edge functions, linear in the pixel, over the pixels of its rectangle. Of
 * any other the edge functions are planes through the eye and an edge, which need no
 * division; they are looked at in all pixels. What is not surely outside is tested exactly;
 * of samples see beam_samples.c.
 *
 * Inline for those who project triangles: footprint_corners.h has float corners, beam_strips.c the
 * strips of compact blocks.
 *
 * Source: Pineda, "A parallel algorithm for polygon rasterization", 1988 (edge functions).
 * Margins: DESIGN.md, section 7.7.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_FOOTPRINT_EDGES_H
#define PLT_SHADE_FOOTPRINT_EDGES_H

#include "engine/lanes/unroll.h"
#include "engine/shade/beam.h"
#include "engine/shade/lines.h"

/* Apart, as it would take registers from the others; static, as the compiler then knows which ones
 * it leaves alone. */
#ifdef __GNUC__
#define PLT_RARELY __attribute__((noinline)) static
#else
#define PLT_RARELY static
#endif

#define PLT_DEPTH_LEAST 7.8886090522101181e-31f /* 2^-100: below, products may underflow */

#define PLT_SLACK_MOST (0.49f * PLT_PIXEL_SLACK)
#define PLT_NEARER (1.0f - PLT_PIXEL_SLACK)

/* ---- projection -------------------------------------------------------------------------- */

/* A triangle in a square of pixels: its corners, and the lines it may reach. */
typedef struct projected {
    float x[3], y[3]; /* pixels from the square's first, and the margins' bias more */
    float over[3];    /* 1 / depth */
    float size;       /* width and height together */
    plt_lines columns, rows;
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

/* What all triangles are projected by; of a square, in registers. */
typedef struct projector {
    float org[3], row_w[3], row_x[3];
} projector;

static inline void set_projector(projector *k, const plt_beam *b) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        k->org[a] = b->origin.org[a];
        k->row_w[a] = b->margins.row_w[a];
        k->row_x[a] = b->row_x[a];
    }
}

static inline int all_at_least(const float v[3], float limit) {
    return v[0] >= limit && v[1] >= limit && v[2] >= limit;
}

/* From the square's first pixel. */
static inline int are_near(const plt_margins *m, range r) {
    return r.least >= m->bias - m->corner && r.most <= m->bias + m->corner;
}

enum projection { OUTSIDE, PROJECTED, NOT_PROJECTED };

/* Of a triangle that meets columns and rows or, 0, does not: whether it is too large to be
 * projected. */
static inline enum projection projection_of(const plt_margins *m, range x, range y, int meets,
                                            projected *p) {
    p->size = (x.most - x.least) + (y.most - y.least);
    if ((meets && p->size <= m->size) || (are_near(m, x) && are_near(m, y))) {
        return meets ? PROJECTED : OUTSIDE;
    }
    return NOT_PROJECTED;
}

/* ---- pixels --------------------------------------------------------------------------------- */

/* Edge functions: of corner c the one across from it, at `at` in a pixel; positive inside, as the
 * area is. */
typedef struct footprint {
    float at[3];
    float error; /* of each function */
    float area;  /* their sum */
    float slack; /* of the sum of their products with `over`; negative: not known yet */
} footprint;

/* An error that leaves no pixel out, and a slack that hides nothing, behind no t: infinity times
 * 0 is a NaN. */
#define PLT_UNKNOWN __builtin_inff()

/* What the sum of edge functions times 1 / depth, which is area / t, may be off by, and t itself
 * as the exact test computes it. `over`: the range of 1 / depth. */
PLT_RARELY float slack_of(const plt_margins *m, range over, float size, float error, float area) {
    const float length = over.most - over.least;
    const float wide = size * m->step;
    const float side = over.most * wide + (0.34f * m->direction + wide) * length;
    const float slack =
        4.0f * error * length + m->t * over.most * area + m->shape * side * side / over.most;
    const int is_known = length <= over.least && slack <= over.most * area;
    return is_known ? slack : PLT_UNKNOWN;
}

/* The triangle that is looked at. */
typedef struct candidate {
    const plt_record *record; /* NULL: it becomes one if a pixel may have it */
    const plt_leaf *leaf;     /* which triangle of a compact block it is, then */
    uint32_t triangle, index; /* in the leaf, in the image */
#ifdef FOOTPRINT_OF_VERTICES
    const plt_vertex_lists *lists; /* what it is made of, then */
    plt_listed listed;
#endif
} candidate;

/* Its record: one of the scene's, or one that is made now. */
static inline const plt_record *record_of(plt_beam *b, candidate *c) {
#ifdef FOOTPRINT_OF_VERTICES
    if (c->record == NULL) {
        plt_record *r = plt_beam_free_record(b);
        plt_vertex_lists_record(c->lists, &c->listed, r);
        plt_record_set_last(r, 0);
        c->record = r;
    }
#elif PLT_WITH_COMPACT
    if (c->leaf != NULL && c->record == NULL) {
        c->record = plt_beam_store(b, c->leaf, c->triangle, c->index);
    }
#else
    (void)b;
#endif
    return c->record;
}

PLT_INLINED int is_outside(const footprint *f, const float e[3]) {
    const float out = -f->error;
    return !(e[0] >= out && e[1] >= out && e[2] >= out);
}

/* Not outside. Surely inside and surely nearer: takes the pixel, with the greatest t it may have.
 * What is not surely beside or behind either is tested exactly. */
PLT_INLINED void test_inside(plt_beam *b, candidate *c, const projected *p, footprint *f,
                             const float e[3], uint32_t x, uint32_t y) {
    const float in = f->error;
    plt_pixel *pixel = &b->pixel[y * b->square.side + x];
    if (f->slack < 0.0f) {
        f->slack = slack_of(&b->margins, range_of(p->over), p->size, f->error, f->area);
    }
    const float over = e[0] * p->over[0] + e[1] * p->over[1] + e[2] * p->over[2];
    if ((over + f->slack) * pixel->t < f->area) {
        return;
    }
    const float least = over - f->slack;
    if (e[0] >= in && e[1] >= in && e[2] >= in && f->slack <= PLT_SLACK_MOST * over &&
        least * (pixel->t * PLT_NEARER) > f->area) {
        const uint32_t record = (uint32_t)(record_of(b, c) - b->records);
        plt_beam_take(b, pixel, f->area / least, record | PLT_PIXEL_BOUND);
    } else {
        plt_beam_test_pixel(b, record_of(b, c), x, y);
    }
}

/* The edge functions at a point of lines; `beside`: that of the margins. */
PLT_INLINED void set_at_point(footprint *f, const projected *p, float column, float row,
                              float beside) {
    const float x0 = column + beside, y0 = row + beside;
    const float x[3] = {p->x[0] - x0, p->x[1] - x0, p->x[2] - x0};
    const float y[3] = {p->y[0] - y0, p->y[1] - y0, p->y[2] - y0};
    f->at[0] = x[2] * y[1] - x[1] * y[2];
    f->at[1] = x[0] * y[2] - x[2] * y[0];
    f->at[2] = x[1] * y[0] - x[0] * y[1];
}

/* Where two lines meet. */
PLT_INLINED void set_at(footprint *f, const projected *p, const plt_margins *m, uint32_t column,
                        uint32_t row) {
    set_at_point(f, p, plt_line_at(column), plt_line_at(row), plt_margins_reach(m));
}

/* Of a pixel. */
PLT_INLINED void set_at_pixel(footprint *f, const projected *p, const plt_beam *b, uint32_t column,
                              uint32_t row) {
#if PLT_WITH_SAMPLES
    const plt_view *v = b->view;
    set_at_point(f, p, plt_line_at(column) + v->aside[row & (v->across - 1)],
                 plt_line_at(row) - v->aside[column & (v->across - 1)], b->margins.reach);
#else
    set_at(f, p, &b->margins, column, row);
#endif
}

PLT_INLINED void swap(float *a, float *b) {
    const float was = *a;
    *a = *b;
    *b = was;
}

/* Makes the area positive, as that of most triangles seen from outside is: rows are counted
 * downwards. */
PLT_INLINED void turn(footprint *f, projected *p) {
    swap(&p->x[1], &p->x[2]);
    swap(&p->y[1], &p->y[2]);
    swap(&p->over[1], &p->over[2]);
    swap(&f->at[1], &f->at[2]);
    f->area = -f->area;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        f->at[c] = -f->at[c];
    }
}

PLT_INLINED float edge_of(const plt_margins *m, float size) {
#if PLT_WITH_SAMPLES
    if (size <= PLT_SMALL_SIZE) {
        return m->small_edge + m->small_growth * size;
    }
#else
    (void)size;
#endif
    return m->edge;
}

PLT_INLINED void set_edges(footprint *f, projected *p, const plt_margins *m) {
    f->area = f->at[0] + f->at[1] + f->at[2];
    f->error = edge_of(m, p->size) * p->size + m->edge_least;
    f->slack = -1.0f;
    if (__builtin_fabsf(f->area) <= 12.0f * f->error) { /* its sign is open: no pixel is left out */
        f->error = f->slack = PLT_UNKNOWN;
    } else if (f->area < 0.0f) {
        turn(f, p);
    }
}

typedef plt_beam_part rectangle;

/* What is added to an edge function from pixel to pixel of a row, and from row to row. Of samples
 * the second is to the next pixel of the frame; of single ones both are the same. */
#if PLT_WITH_SAMPLES
#define PLT_STEPS 2
#else
#define PLT_STEPS 1
#endif

typedef struct steps {
    float right[PLT_STEPS][3], down[PLT_STEPS][3];
} steps;

PLT_INLINED void set_steps(steps *s, const plt_beam *b, const projected *p) {
    PLT_UNROLLED for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const float right = p->y[j] - p->y[i], down = p->x[i] - p->x[j];
#if PLT_WITH_SAMPLES
        const float *part = b->view->part;
        PLT_UNROLLED for (int after = 0; after < PLT_STEPS; after++) {
            s->right[after][k] = right + part[after] * down;
            s->down[after][k] = down - part[after] * right;
        }
#else
        (void)b;
        s->right[0][k] = right;
        s->down[0][k] = down;
#endif
    }
}

PLT_INLINED void step(float e[3], const float by[3]) {
    PLT_UNROLLED for (int k = 0; k < 3; k++) {
        e[k] += by[k];
    }
}

/* From a line to the next one; `last`: of a pixel. */
PLT_INLINED void step_from(float e[3], const float by[PLT_STEPS][3], uint32_t line, uint32_t last) {
#if PLT_WITH_SAMPLES
    if ((line & last) == last) {
        step(e, by[1]);
        return;
    }
#else
    (void)line;
    (void)last;
#endif
    step(e, by[0]);
}

PLT_INLINED void test_all(plt_beam *b, candidate *c, const projected *p, const rectangle *r,
                          const steps *s, footprint *f) {
    const uint32_t last = plt_view_across(b->view) - 1;
    for (uint32_t y = r->top; y <= r->bottom; y++) {
        float e[3] = {f->at[0], f->at[1], f->at[2]};
        for (uint32_t x = r->left; x <= r->right; x++) {
            if (!is_outside(f, e)) {
                test_inside(b, c, p, f, e, x, y);
            }
            step_from(e, (const float(*)[3])s->right, x, last);
        }
        step_from(f->at, (const float(*)[3])s->down, y, last);
    }
}

#endif
