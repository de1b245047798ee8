/* beam_pixel - pixels of a square, one by one: the exact test, and what is kept of a hit
 *
 * And all of them by planes through the eye and a triangle's edges, where it is not projected.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/float_bits.h"
#include "engine/shade/footprint.h"
#include "engine/trace/triangle_common.h"

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

void plt_beam_test_pixel(plt_beam *b, const plt_record *record, uint32_t x, uint32_t y) {
    plt_pixel *pixel = &b->pixel[y * b->square.side + x];
    plt_ray_hit hit;
    plt_beam_settle(b, x, y);
    if (find_hit(b, record, x, y, pixel->t, wins_ties(b, pixel, record), &hit)) {
        plt_beam_take(b, pixel, hit.t, (uint32_t)(record - b->records));
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

void plt_beam_test_planes(plt_beam *b, const plt_record *record) {
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
        margin[c] = b->margins.plane * (size_of(from) * size_of(to) + PLT_PLANE_LEAST);
    }
    for (uint32_t y = 0; y < b->rows; y++) {
        for (uint32_t x = 0; x < b->columns; x++) {
            unsigned sides = 0; /* 1: surely above, 2: surely below */
            for (int c = 0; c < 3; c++) {
                const float at = e[c].at + (float)x * e[c].right + (float)y * e[c].down;
                sides |= (unsigned)(at > margin[c]) | (unsigned)(at < -margin[c]) << 1;
            }
            if (sides != 3) {
                plt_beam_test_pixel(b, record, x, y);
            }
        }
    }
}

/* ---- the farthest pixel -----------------------------------------------------------------------
 */

/* No t is negative: so they are in the order of their bits. */
void plt_beam_update_far(plt_beam *b) {
    int32_t most = 0;
    b->is_stored = 0;
    for (uint32_t y = 0; y < b->rows; y++) {
        const plt_pixel *row = &b->pixel[y * b->square.side];
        for (uint32_t x = 0; x < b->columns; x++) {
            const int32_t t = (int32_t)plt_bits_of(row[x].t);
            most = t > most ? t : most;
        }
    }
    b->far = plt_float_of((uint32_t)most);
}
