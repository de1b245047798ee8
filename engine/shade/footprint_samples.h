/* footprint_samples - whole pixels of samples that a large triangle may cover
 *
 * Edge functions in the middle of a pixel, and how much they differ
 * over its samples, tell whether it is outside as a whole, or is taken as a whole; else its samples
 * are looked at one by one. So only next to edges a sample costs what a pixel does without samples.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_FOOTPRINT_SAMPLES_H
#define PLT_SHADE_FOOTPRINT_SAMPLES_H

#include "engine/shade/footprint_edges.h"

#if PLT_WITH_SAMPLES

/* Triangles of more width and height together cover whole pixels, in pixels. */
#define PLT_LARGE_SIZE 16.0f

/* What a triangle's functions change by: to the next column and row of samples, and at most from
 * the middle of a pixel to one of its samples. */
typedef struct slopes {
    float right[3], down[3], spread[3];
    float over_spread; /* of the sum of their products with 1 / depth */
    steps samples;     /* from one to the next */
} slopes;

/* Samples are a rotated square, so one of its corners is furthest. */
static inline float spread_of(const plt_view *v, float right, float down) {
    const float middle = 0.5f * (float)(int32_t)(v->across - 1);
    const float near = middle - v->aside_most, far = middle + v->aside_most;
    const float one = __builtin_fabsf(near * right + far * down);
    const float other = __builtin_fabsf(far * right - near * down);
    return one > other ? one : other;
}

static inline void set_slopes(slopes *s, const plt_view *v, const projected *p) {
    float right = 0.0f, down = 0.0f;
    PLT_UNROLLED for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        s->right[k] = p->y[j] - p->y[i];
        s->down[k] = p->x[i] - p->x[j];
        s->spread[k] = spread_of(v, s->right[k], s->down[k]);
        right += s->right[k] * p->over[k];
        down += s->down[k] * p->over[k];
    }
    s->over_spread = spread_of(v, right, down);
}

static inline uint32_t at_least(uint32_t a, uint32_t b) {
    return a > b ? a : b;
}

static inline uint32_t at_most(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* Those of the pixel at (x, y) that the triangle may reach, from the functions in its middle. */
PLT_RARELY void test_edge(plt_beam *b, candidate *c, const projected *p, const footprint *whole,
                          const slopes *s, const float middle[3], const rectangle *r, uint32_t x,
                          uint32_t y) {
    const plt_view *v = b->view;
    const uint32_t last = v->across - 1;
    const rectangle few = {at_least(x, r->left), at_most(x + last, r->right), at_least(y, r->top),
                           at_most(y + last, r->bottom)};
    const float half = 0.5f * (float)(int32_t)last;
    const float right = plt_view_x(v, few.left & last, few.top) - half;
    const float down = plt_view_y(v, few.left, few.top & last) - half;
    footprint f = *whole;
    PLT_UNROLLED for (int k = 0; k < 3; k++) {
        f.at[k] = middle[k] + (right * s->right[k] + down * s->down[k]);
    }
    test_all(b, c, p, &few, &s->samples, &f);
}

/* All samples of the pixel at (x, y) are inside: 1 if their t is known well enough, and all that
 * the triangle is surely nearer to have been taken, and no other may have it. */
static inline int take_pixel(plt_beam *b, candidate *c, const projected *p, const footprint *f,
                             const slopes *s, const float middle[3], uint32_t x, uint32_t y) {
    const uint32_t across = b->view->across, side = b->square.side;
    const float over = middle[0] * p->over[0] + middle[1] * p->over[1] + middle[2] * p->over[2];
    const float slack = f->slack + s->over_spread, least = over - slack, most = over + slack;
    plt_pixel *first = &b->pixel[y * side + x];
    float nearest = first->t, farthest = first->t;
    if (!(slack <= PLT_SLACK_MOST * over)) {
        return 0;
    }
    for (uint32_t row = 0; row < across; row++) {
        const plt_pixel *pixel = &first[row * side];
        for (uint32_t column = 0; column < across; column++) {
            nearest = pixel[column].t < nearest ? pixel[column].t : nearest;
            farthest = pixel[column].t > farthest ? pixel[column].t : farthest;
        }
    }
    if (!(least * (nearest * PLT_NEARER) > f->area)) {
        return most * farthest < f->area;
    }
    const uint32_t record = (uint32_t)(record_of(b, c) - b->records) | PLT_PIXEL_BOUND;
    const float t = f->area / least;
    for (uint32_t row = 0; row < across; row++) {
        for (uint32_t column = 0; column < across; column++) {
            plt_beam_take(b, &first[row * side + column], t, record);
        }
    }
    return 1;
}

static inline void test_pixel(plt_beam *b, candidate *c, const projected *p, footprint *f,
                              const slopes *s, const float e[3], const rectangle *r, uint32_t x,
                              uint32_t y) {
    const float in[3] = {f->error + s->spread[0], f->error + s->spread[1], f->error + s->spread[2]};
    if (!(e[0] >= -in[0] && e[1] >= -in[1] && e[2] >= -in[2])) {
        return;
    }
    if (!(e[0] >= in[0] && e[1] >= in[1] && e[2] >= in[2] && take_pixel(b, c, p, f, s, e, x, y))) {
        test_edge(b, c, p, f, s, e, r, x, y);
    }
}

/* Whether the slack is small enough wherever the triangle is; else its planes know t better. */
static inline int is_t_known(const plt_beam *b, const projected *p, footprint *f) {
    const range over = range_of(p->over);
    if (f->slack < 0.0f) {
        f->slack = slack_of(&b->margins, over, p->size, f->error, f->area);
    }
    return f->slack <= PLT_SLACK_MOST * over.least * f->area;
}

/* The pixels that a large triangle may cover, whole ones at once. 0: its planes know t better, and
 * its samples are to be tested by these; not from here, on top of all that lies on the stack. */
PLT_RARELY int test_pixels(plt_beam *b, candidate *c, projected *p, const rectangle *r) {
    const uint32_t across = b->view->across, whole = ~(across - 1), left = r->left & whole;
    const float step = (float)(int32_t)across;
    const float beside = 0.5f * (step - 1.0f);
    footprint f;
    slopes s;
    set_at_point(&f, p, plt_line_at(left) + beside, plt_line_at(r->top & whole) + beside,
                 plt_margins_reach(&b->margins));
    set_edges(&f, p, &b->margins);
    if (!is_t_known(b, p, &f)) {
        return 0;
    }
    set_slopes(&s, b->view, p);
    set_steps(&s.samples, b, p);
    for (uint32_t y = r->top & whole; y <= r->bottom; y += across) {
        float e[3] = {f.at[0], f.at[1], f.at[2]};
        for (uint32_t x = left; x <= r->right; x += across) {
            test_pixel(b, c, p, &f, &s, e, r, x, y);
            PLT_UNROLLED for (int k = 0; k < 3; k++) {
                e[k] += step * s.right[k];
            }
        }
        PLT_UNROLLED for (int k = 0; k < 3; k++) {
            f.at[k] += step * s.down[k];
        }
    }
    return 1;
}

#endif

#endif
