/* camera - rays through pixel centres
 *
 * Pixel (x, y) looks along corner + x * right + y * down, computed in this
 * order: the same bits in every packet and on every machine.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_CAMERA_H
#define PLT_SHADE_CAMERA_H

#include "engine/trace/packet.h"

/* A camera over a frame of so many pixels. */
typedef struct plt_view {
    float eye[3];
    float corner[3];         /* direction through pixel (0, 0) */
    float right[3], down[3]; /* from a pixel to the next */
#if PLT_WITH_SAMPLES
    float aside[4]; /* its pixels are samples (plt_view_refine): those in row y are so far to the
                     * right of the column, those in column x so far above the row */
    float aside_most;
    float part[2];   /* steps down per step to the right, and to the left per step down: within a
                      * pixel, to the next one */
    uint32_t across; /* samples along the side of a pixel of the frame: 1, 2 or 4 */
#endif
} plt_view;

/* PLT_ERR_ARGUMENT: eye and look coincide, up runs along the view, or a value is out
 * of range. */
int plt_view_set(plt_view *view, const plt_frame *frame);

#if PLT_WITH_SAMPLES
/* Makes each pixel a square of across^2 samples, which then are pixels of the view, in rows and
 * columns across times as close. Each row is a little aside of the one above it, and each column
 * of the one before: the square is rotated, and no two samples of it share a row or a column.
 * `across`: 1 (and nothing changes), 2 or 4. */
void plt_view_refine(plt_view *view, uint32_t across);
#endif

#define PLT_VIEW_FAR 3.0e38f /* tmax of its rays */

/* Where a pixel is, in columns and in rows: all exact. */
static inline float plt_view_x(const plt_view *v, uint32_t px, uint32_t py) {
#if PLT_WITH_SAMPLES
    return (float)px + v->aside[py & (v->across - 1)];
#else
    (void)v;
    (void)py;
    return (float)px;
#endif
}

static inline float plt_view_y(const plt_view *v, uint32_t px, uint32_t py) {
#if PLT_WITH_SAMPLES
    return (float)py - v->aside[px & (v->across - 1)];
#else
    (void)v;
    (void)px;
    return (float)py;
#endif
}

/* As far aside of a column, or a row, as its pixels may be. */
static inline float plt_view_least(const plt_view *v, float line) {
#if PLT_WITH_SAMPLES
    return line - v->aside_most;
#else
    (void)v;
    return line;
#endif
}

static inline float plt_view_most(const plt_view *v, float line) {
#if PLT_WITH_SAMPLES
    return line + v->aside_most;
#else
    (void)v;
    return line;
#endif
}

static inline uint32_t plt_view_across(const plt_view *v) {
#if PLT_WITH_SAMPLES
    return v->across;
#else
    (void)v;
    return 1;
#endif
}

/* The side of a pixel, or of a sample, at a distance of 1. */
static inline float plt_view_pixel_angle(const plt_view *v, const plt_frame *frame) {
    return 2.0f * frame->camera.tan_half_fov / (float)(frame->height * plt_view_across(v));
}

/* The direction through a point of the frame. */
static inline void plt_view_point(const plt_view *v, float x, float y, float dir[3]) {
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        dir[a] = (v->corner[a] + x * v->right[a]) + y * v->down[a];
    }
}

/* The direction through a pixel. */
static inline void plt_view_direction(const plt_view *v, uint32_t px, uint32_t py, float dir[3]) {
    plt_view_point(v, plt_view_x(v, px, py), plt_view_y(v, px, py), dir);
}

/* The same in lanes, first along the row, then down the column. Whole numbers this small are
 * exact. */
static inline f4 plt_view_along(const plt_view *v, int a, f4 px) {
    return f4_add(f4_all(v->corner[a]), f4_mul(px, f4_all(v->right[a])));
}

static inline f4 plt_view_below(const plt_view *v, int a, f4 py) {
    return f4_mul(py, f4_all(v->down[a]));
}

static inline f4 plt_view_directions(const plt_view *v, int a, f4 px, f4 py) {
    return f4_add(plt_view_along(v, a, px), plt_view_below(v, a, py));
}

/* A square of pixels, its top left one, and the first column and row behind the frame. */
typedef struct plt_pixels {
    uint32_t side, x, y, x_end, y_end;
} plt_pixels;

/* Sets the packet up for these pixels, in Z order; those behind the frame get no ray. */
void plt_view_packet(const plt_view *view, const plt_box *scene, plt_packet *packet,
                     const plt_pixels *pixels);

/* Pixel k of a square in Z order: x from the even bits, y from the odd ones. */
static inline uint32_t plt_z_order_x(uint32_t k) {
    return (k & 1u) | (k >> 1 & 2u) | (k >> 2 & 4u) | (k >> 3 & 8u);
}

static inline uint32_t plt_z_order_y(uint32_t k) {
    return plt_z_order_x(k >> 1);
}

#endif
