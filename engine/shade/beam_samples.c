/* beam_samples - samples of a square, by planes through the eye and a triangle's edges
 *
 * As plt_beam_test_planes, but for all samples of a pixel together: planes in the middle of a
 * pixel, and how much they differ over its samples, tell whether it is surely outside, or surely
 * inside. The sum of the planes is n . d of the triangle's normal n, and n . q the same for all of
 * its corners q: so inside t = n . q / n . d is bounded, too, and where that is close enough no
 * sample is tested exactly. Margins: DESIGN.md, section 7.7.
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
 * pixel; how much they change to the next, and by how much a sample's may be above or below, the
 * margin included. */
typedef struct planes {
    float first[3], right[3], down[3], beside[3];
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
    const float margin = b->margins.plane * (size_of(from) * size_of(to) + PLT_PLANE_LEAST);
    p->first[c] = dot(normal, b->first) + middle * (right + down);
    p->right[c] = across * right;
    p->down[c] = across * down;
    p->beside[c] = spread_of(b->view, middle, right, down) + margin;
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

/* All samples of a pixel are inside: the least and the greatest t that the exact test may give
 * them. 0: not known well enough. */
static int bounds_of(const planes *p, const float at[3], float t[2]) {
    const float sum = at[0] + at[1] + at[2];
    const float beside = p->beside[0] + p->beside[1] + p->beside[2];
    const float volume = sum < 0.0f ? -p->volume : p->volume, size = __builtin_fabsf(sum);
    if (!(volume > p->volume_error && size > beside)) {
        return 0;
    }
    const float least = (volume - p->volume_error) / (size + beside);
    const float most = (volume + p->volume_error) / (size - beside);
    const float error = p->error + p->near / least + 8.0f * PLT_U;
    if (!(error <= ERROR_MOST)) {
        return 0;
    }
    t[0] = least - error * least;
    t[1] = most + error * most;
    return t[0] >= t[1] * (1.0f - 0.96f * PLT_PIXEL_SLACK) && t[1] < PLT_VIEW_FAR;
}

/* Samples of the pixel whose first is at (x, y). `t`: bounds, or NULL: each is tested exactly. */
static void test_pixel(plt_beam *b, const plt_record *record, const float *t, uint32_t x,
                       uint32_t y) {
    const uint32_t index = (uint32_t)(record - b->records) | PLT_PIXEL_BOUND;
    for (uint32_t row = y; row < y + b->view->across; row++) {
        plt_pixel *pixel = &b->pixel[row * b->square.side + x];
        for (uint32_t column = x; column < x + b->view->across; column++, pixel++) {
            if (t == NULL || (t[1] >= pixel->t * (1.0f - PLT_PIXEL_SLACK) && t[0] <= pixel->t)) {
                plt_beam_test_pixel(b, record, column, row);
            } else if (t[0] <= pixel->t) {
                plt_beam_take(b, pixel, t[1], index);
            }
        }
    }
}

/* Bits: some sample may be above a plane, some below one, none is surely inside. */
static unsigned sides_of(const planes *p, const float at[3]) {
    unsigned sides = 0; /* 1: surely above, 2: surely below, 4: neither */
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        sides |= at[c] > p->beside[c] ? 1u : at[c] < -p->beside[c] ? 2u : 4u;
    }
    return sides;
}

/* In pixel (x, y): products, as what is added from pixel to pixel would round once for each. */
static void planes_at(const planes *p, uint32_t x, uint32_t y, float at[3]) {
    const float right = (float)(int32_t)x, down = (float)(int32_t)y;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        at[c] = (p->first[c] + down * p->down[c]) + right * p->right[c];
    }
}

void plt_beam_test_samples(plt_beam *b, const plt_record *record) {
    const uint32_t across = b->view->across;
    planes p;
    set_planes(&p, b, record);
    for (uint32_t y = 0; across * y < b->rows; y++) {
        for (uint32_t x = 0; across * x < b->columns; x++) {
            float at[3], t[2];
            planes_at(&p, x, y, at);
            const unsigned sides = sides_of(&p, at);
            if ((sides & 3u) != 3) {
                const int known = (sides & 4u) == 0 && bounds_of(&p, at, t);
                test_pixel(b, record, known ? t : NULL, across * x, across * y);
            }
        }
    }
}

#endif
