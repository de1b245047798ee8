/* margins - see margins.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/margins.h"

#include "engine/shade/lines.h"
#include "engine/trace/triangle_common.h"

#define CORNER_MOST 1024.0f /* pixels */
#define PIXELS_MOST 1024.0f /* margins above leave out no line */
#define PIXELS_TOLD 4.0f    /* above, what meets a line may yet be far beside the square */
#define SMALL_BESIDE                                                                               \
    24.0f               /* no corner of what meets a square is further from its first pixel        \
                         * than that and the triangle's size */
#define SMALL_TOLD 1.0f /* where margins are wider, one may be */
#define EDGE_BESIDE (60.0f * PLT_U) /* as samples may be beside a triangle's lines */
#define OBLIQUE_MOST 16384.0f       /* 2^14 */

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static float length(const float a[3]) {
    return __builtin_sqrtf(dot(a, a));
}

static float larger(float a, float b) {
    return a > b ? a : b;
}

/* The longest direction through a pixel: one of the frame's corners. */
static float longest_direction(const plt_view *v, uint32_t width, uint32_t height) {
    float most = 0.0f;
    for (unsigned i = 0; i < 4; i++) {
        float d[3];
        plt_view_point(v, i & 1u ? plt_view_most(v, (float)(width - 1)) : plt_view_least(v, 0.0f),
                       i & 2u ? plt_view_most(v, (float)(height - 1)) : plt_view_least(v, 0.0f), d);
        most = larger(most, length(d));
    }
    return most;
}

/* M: no rounding of a direction is above 3 u of it, on any axis. */
static float largest_term(const plt_view *v, uint32_t width, uint32_t height) {
    float most = 0.0f;
    for (int a = 0; a < 3; a++) {
        most = larger(most, __builtin_fabsf(v->corner[a]) +
                                (float)width * __builtin_fabsf(v->right[a]) +
                                (float)height * __builtin_fabsf(v->down[a]));
    }
    return most;
}

/* Of all points in a box, as footprint_corners.h computes it: by the corner that is least on each
 * axis, as rounding is monotone, in the differences, the products and their sum. */
static float least_depth(const float row_w[3], const float eye[3], const plt_box *box) {
    float q[3];
    for (int a = 0; a < 3; a++) {
        q[a] = (row_w[a] > 0.0f ? box->lo[a] : box->hi[a]) - eye[a];
    }
    return plt_along(q, row_w);
}

/* Between a corner that is projected and a ray, in pixels. `beside`: of the corner's x or y, times
 * `row`, as a share of `across`. The last factor: of the bias the result is a part. */
static float off_by(float across, float row, float direction, float beside, float rays,
                    float first) {
    const float bias = 9.0f * row * direction;
    const float sum = across * ((8.5f + 7.5f * beside) * direction + rays) + bias * first + 128.0f;
    return PLT_U * sum / (1.0f - PLT_U * bias);
}

static void set_pixels(plt_margins *m, float across, float row, float square, float rays,
                       float aside) {
#if PLT_WITH_SAMPLES
    const float first = PLT_LINE_FIRST + aside;
#else
    const float first = PLT_LINE_FIRST;
    (void)aside;
#endif
    m->pixels = off_by(across, row, m->direction, larger(0.5f, square), rays, first);
#if PLT_WITH_SAMPLES
    m->reach = m->pixels + aside;
#endif
    m->bias = PLT_LINE_FIRST + plt_margins_reach(m);
    m->edge = 1.5f * m->pixels + EDGE_BESIDE + 40.0f * PLT_U * across;
    m->edge_least = 3.0f * m->pixels * m->pixels + EDGE_BESIDE;
    const int is_told = m->pixels >= 0.0f && m->pixels < PIXELS_MOST; /* not where too wide */
    m->lines = is_told ? (int32_t)(plt_margins_reach(m) * (float)(1 << PLT_LINE_BITS)) + 2
                       : PLT_LINE_WIDEST;
}

#if PLT_WITH_SAMPLES
/* The same of a triangle of `size` that meets a square: its corners are all near. */
static float off_by_of(const plt_margins *m, float across, float row, float rays, float farthest,
                       float size) {
    const float reach = (SMALL_BESIDE + size) * m->step;
    return off_by(across, row, farthest + 2.0f * reach, reach / farthest,
                  rays + 4.0f * (reach / farthest), m->bias);
}

/* It grows faster and faster with the size: between two it is below the line that joins them. */
static void set_small(plt_margins *m, float across, float row, float rays, float farthest) {
    const float least = off_by_of(m, across, row, rays, farthest, 0.0f);
    const float most = off_by_of(m, across, row, rays, farthest, PLT_SMALL_SIZE);
    m->small_edge = m->edge;
    m->small_growth = 0.0f;
    if (m->pixels < SMALL_TOLD && most < m->pixels) {
        m->small_edge = 1.5f * least + EDGE_BESIDE;
        m->small_growth = 1.5f / PLT_SMALL_SIZE * (most - least) + 19.0f * PLT_U;
    }
}
#endif

void plt_margins_set(plt_margins *m, const plt_view *v, const plt_frame *frame, uint32_t side,
                     const plt_box *scene, float reach) {
    plt_cross(v->right, v->down, m->row_w);
    m->det = dot(v->corner, m->row_w);
    const float det = __builtin_fabsf(m->det);
    const float right = length(v->right), down = length(v->down), step = larger(right, down);
    const uint32_t across = plt_view_across(v);
    const uint32_t width = across * frame->width, height = across * frame->height;
    const float farthest = longest_direction(v, width, height);
    const float term = largest_term(v, width, height);
    const float row = right * down / det;     /* the length of row_w */
    const float rows = step * farthest / det; /* at least the length of row_x and row_y */
    const float square = (float)side * step / farthest;
    const float corner = 0.5f * farthest / step;
    m->step = step;
    m->direction = 3.0f * farthest;
    const float rays = 13.0f * (1.0f + square) * term + 4.0f * (1.0f + square);
    set_pixels(m, rows, row, square, rays, plt_view_most(v, 0.0f));
#if PLT_WITH_SAMPLES
    set_small(m, rows, row, rays, farthest);
#endif
    m->corner = corner < CORNER_MOST ? corner : CORNER_MOST;
    const float beside = plt_margins_reach(m);
    const int is_told = beside < PIXELS_TOLD && 16.0f * beside < m->corner;
    m->size = is_told ? m->corner - (float)side : -1.0f;
    m->depth = 1.75f * reach / m->direction;
    m->plane = 160.0f * PLT_U * term;
    m->t = PLT_U * (110.0f * row * farthest + 12.0f * row * term + 100.0f);
    m->shape = 800.0f * PLT_U * farthest / det;
    m->project = row * (farthest + term + 1.0f) <= OBLIQUE_MOST; /* false for NaN */
    for (int a = 0; a < 3; a++) {
        m->row_w[a] /= m->det;
    }
    m->all_deep = m->project && least_depth(m->row_w, v->eye, scene) >= m->depth;
}
