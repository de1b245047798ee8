/* beam_samples - samples of a square, by planes through the eye and a triangle's edges
 *
 * As plt_beam_test_planes, but for all samples of a pixel together: planes in the middle of a
 * pixel, and how much they differ over its samples, tell whether it is surely outside, or surely
 * inside. The sum of the planes is n . d of the triangle's normal n, and n . q the same for all of
 * its corners q: so inside t = n . q / n . d is bounded, too, and where that is close enough no
 * sample is tested exactly. Of a pixel for which that fails each sample has planes and bounds of
 * its own. So do large triangles that are projected, but whose t is not known well enough.
 * Margins: DESIGN.md, section 7.7.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/lanes/unroll.h"
#include "engine/shade/beam.h"
#include "engine/trace/triangle_common.h"

#if PLT_WITH_SAMPLES

#define VOLUME_ERROR (48.0f * PLT_U) /* of n . q, times the sizes of all three corners */
#define SHAPE_ERROR (448.0f * PLT_U) /* of t, times the cube of the largest, over n . q */
#define NEAR_ERROR (4.0f * PLT_U)    /* of t, times the largest, over t */
#define ERROR_MOST 0x1p-8f

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static float larger(float a, float b) {
    return a > b ? a : b;
}

static float size_of(const float a[3]) {
    return larger(larger(__builtin_fabsf(a[0]), __builtin_fabsf(a[1])), __builtin_fabsf(a[2]));
}

/* Planes through the eye and an edge, times the direction in the middle of the square's first
 * pixel; how much they change to the next; their margins, and by how much a sample's may be above
 * or below, the margin included. */
typedef struct planes {
    float first[3], right[3], down[3], margin[3], beside[3];
    float volume, volume_error; /* n . q, and how far off it may be */
    float error, near;          /* of t: a share of it, and one that is to be divided by it */
} planes;

static float spread_of(const plt_view *v, float middle, float right, float down) {
    const float near = middle - v->aside_most, far = middle + v->aside_most;
    return larger(__builtin_fabsf(near * right + far * down),
                  __builtin_fabsf(far * right - near * down));
}

static void set_plane(planes *p, const plt_beam *b, int c, const float from[3], const float to[3]) {
    const float across = (float)b->view->across, middle = 0.5f * (across - 1.0f);
    float normal[3];
    plt_cross(from, to, normal);
    const float right = dot(normal, b->view->right), down = dot(normal, b->view->down);
    p->margin[c] = b->margins.plane * (size_of(from) * size_of(to) + PLT_PLANE_LEAST);
    p->first[c] = dot(normal, b->first) + middle * (right + down);
    p->right[c] = across * right;
    p->down[c] = across * down;
    p->beside[c] = spread_of(b->view, middle, right, down) + p->margin[c];
}

static void set_planes(planes *p, const plt_beam *b, const plt_record *record) {
    float q[3][3], normal[3], size[3];
    plt_record_corners(record, q);
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            q[c][a] -= b->origin.org[a];
        }
        size[c] = size_of(q[c]);
    }
    for (int c = 0; c < 3; c++) {
        set_plane(p, b, c, q[plt_axis_after[c]], q[plt_axis_after[plt_axis_after[c]]]);
    }
    const float largest = larger(larger(size[0], size[1]), size[2]);
    plt_cross(q[1], q[2], normal);
    p->volume = dot(q[0], normal);
    p->volume_error = VOLUME_ERROR * (size[0] * size[1] * size[2] + PLT_PLANE_LEAST);
    p->error = SHAPE_ERROR * (largest * largest * largest) / __builtin_fabsf(p->volume);
    p->near = NEAR_ERROR * largest;
}

/* The least and the greatest t that the exact test may give to a hit, or less and greater. */
typedef struct bounds {
    float least, most;
    int is_known; /* well enough */
} bounds;

/* Where planes are `at`, give or take `beside`. */
static bounds bounds_of(const planes *p, const float at[3], const float beside[3]) {
    const float sum = at[0] + at[1] + at[2], size = __builtin_fabsf(sum);
    const float wide = beside[0] + beside[1] + beside[2];
    const float volume = sum < 0.0f ? -p->volume : p->volume;
    bounds t = {0.0f, 0.0f, 0};
    if (!(volume > p->volume_error && size > wide)) {
        return t;
    }
    t.least = (volume - p->volume_error) / (size + wide);
    t.most = (volume + p->volume_error) / (size - wide);
    const float error = p->error + p->near / t.least + 8.0f * PLT_U;
    if (error <= ERROR_MOST) {
        t.least -= error * t.least;
        t.most += error * t.most;
        t.is_known = t.least >= t.most * (1.0f - 0.96f * PLT_PIXEL_SLACK) && t.most < PLT_VIEW_FAR;
    }
    return t;
}

/* Bits: 1, all are above some plane; 2, all are below one; 4, of one neither is sure. */
static inline unsigned sides_of(const float at[3], const float beside[3]) {
    unsigned sides = 0;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        sides |= at[c] > beside[c] ? 1u : at[c] < -beside[c] ? 2u : 4u;
    }
    return sides;
}

/* A pixel. */
typedef struct samples {
    float at[3]; /* planes in its middle */
    int is_inside;
    bounds t; /* of all samples */
} samples;

/* In sample (column, row) of the square. */
static inline void planes_in(const plt_view *v, const planes *p, const samples *of, uint32_t column,
                             uint32_t row, float at[3]) {
    const uint32_t last = v->across - 1;
    const float size = 1.0f / (float)(int32_t)v->across, half = 0.5f * (float)(int32_t)last;
    const float x = ((float)(int32_t)(column & last) - half + v->aside[row & last]) * size;
    const float y = ((float)(int32_t)(row & last) - half - v->aside[column & last]) * size;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        at[c] = of->at[c] + (x * p->right[c] + y * p->down[c]);
    }
}

/* One that is not surely outside. */
static void test_sample(plt_beam *b, const plt_record *record, const bounds *t, int is_inside,
                        uint32_t column, uint32_t row) {
    plt_pixel *pixel = &b->pixel[row * b->square.side + column];
    if (t->is_known && t->least > pixel->t) {
        return;
    }
    if (t->is_known && is_inside && t->most < pixel->t * (1.0f - PLT_PIXEL_SLACK)) {
        plt_beam_take(b, pixel, t->most, (uint32_t)(record - b->records) | PLT_PIXEL_BOUND);
    } else {
        plt_beam_test_pixel(b, record, column, row);
    }
}

/* One of a pixel that does not have one bound for all and is not inside as a whole. */
static void test_alone(plt_beam *b, const plt_record *record, const planes *p, const samples *of,
                       uint32_t column, uint32_t row) {
    float at[3];
    planes_in(b->view, p, of, column, row, at);
    const unsigned sides = sides_of(at, p->margin);
    if ((sides & 3u) != 3) {
        const bounds t = of->t.is_known ? of->t : bounds_of(p, at, p->margin);
        test_sample(b, record, &t, (sides & 4u) == 0, column, row);
    }
}

/* Those of the pixel whose first is at (x, y). */
static void test_pixel(plt_beam *b, const plt_record *record, const planes *p, const samples *of,
                       uint32_t x, uint32_t y) {
    for (uint32_t row = y; row < y + b->view->across; row++) {
        for (uint32_t column = x; column < x + b->view->across; column++) {
            if (of->is_inside && of->t.is_known) {
                test_sample(b, record, &of->t, 1, column, row);
            } else {
                test_alone(b, record, p, of, column, row);
            }
        }
    }
}

/* In pixel (x, y): products, as what is added from pixel to pixel would round once for each. */
static void planes_at(const planes *p, uint32_t x, uint32_t y, float at[3]) {
    const float right = (float)(int32_t)x, down = (float)(int32_t)y;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        at[c] = (p->first[c] + down * p->down[c]) + right * p->right[c];
    }
}

void plt_beam_test_samples(plt_beam *b, const plt_record *record, const plt_beam_part *part) {
    const uint32_t across = b->view->across;
    planes p;
    set_planes(&p, b, record);
    for (uint32_t y = part->top / across; across * y <= part->bottom; y++) {
        for (uint32_t x = part->left / across; across * x <= part->right; x++) {
            samples of;
            planes_at(&p, x, y, of.at);
            const unsigned sides = sides_of(of.at, p.beside);
            if ((sides & 3u) != 3) {
                of.is_inside = (sides & 4u) == 0;
                of.t = bounds_of(&p, of.at, p.beside);
                test_pixel(b, record, &p, &of, across * x, across * y);
            }
        }
    }
}

#endif
