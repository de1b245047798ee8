/* drawing_paint - a drawing as pixels
 *
 * Edges cover pixels in part: what share of a pixel a rectangle has is exact, of a line it is how
 * far the pixel's centre is within it.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "host_tools/tables/drawing.h"
#include "host_tools/tables/letters.h"

static void blend(picture *p, long x, long y, double cover, uint32_t colour) {
    if (x < 0 || y < 0 || x >= (long)p->width || y >= (long)p->height || cover <= 0.0) {
        return;
    }
    uint8_t *to = p->rgb + 3 * ((size_t)y * p->width + (size_t)x);
    for (int c = 0; c < 3; c++) {
        const double ink = (double)(colour >> (16 - 8 * c) & 0xFFu);
        to[c] = (uint8_t)floor(to[c] + (ink - to[c]) * fmin(cover, 1.0) + 0.5);
    }
}

/* The part of pixel `at` that lo .. hi covers. */
static double within(double lo, double hi, long at) {
    return fmax(0.0, fmin(hi, (double)at + 1.0) - fmax(lo, (double)at));
}

static void paint_rectangle(picture *p, double x, double y, double x2, double y2, uint32_t colour) {
    const long top = (long)fmax(floor(y), 0.0), bottom = (long)fmin(ceil(y2), p->height);
    const long left = (long)fmax(floor(x), 0.0), right = (long)fmin(ceil(x2), p->width);
    for (long v = top; v < bottom; v++) {
        for (long u = left; u < right; u++) {
            blend(p, u, v, within(x, x2, u) * within(y, y2, v), colour);
        }
    }
}

/* How far a point is from a segment. */
static double distance(const drawing_item *i, double x, double y, double scale) {
    const double ax = scale * i->x, ay = scale * i->y;
    const double bx = scale * i->x2 - ax, by = scale * i->y2 - ay;
    const double length = bx * bx + by * by;
    const double t = length > 0.0 ? ((x - ax) * bx + (y - ay) * by) / length : 0.0;
    const double k = fmax(0.0, fmin(1.0, t));
    const double dx = x - ax - k * bx, dy = y - ay - k * by;
    return sqrt(dx * dx + dy * dy);
}

static void paint_line(picture *p, const drawing_item *i, double scale) {
    const double half = 0.5 * scale * i->width;
    const double reach = half + 1.0;
    const long left = (long)fmax(floor(scale * fmin(i->x, i->x2) - reach), 0.0);
    const long top = (long)fmax(floor(scale * fmin(i->y, i->y2) - reach), 0.0);
    const long right = (long)fmin(ceil(scale * fmax(i->x, i->x2) + reach), p->width);
    const long bottom = (long)fmin(ceil(scale * fmax(i->y, i->y2) + reach), p->height);
    for (long v = top; v < bottom; v++) {
        for (long u = left; u < right; u++) {
            const double d = distance(i, (double)u + 0.5, (double)v + 0.5, scale);
            blend(p, u, v, half + 0.5 - d, i->colour);
        }
    }
}

/* Letters stand on whole pixels, so that they are sharp. */
static void paint_letters(picture *p, const drawing_item *i) {
    const double dot = DRAWING_PIXELS * i->width;
    const double wide = dot * (DRAWING_ADVANCE * (double)strlen(i->text) - 1.0);
    double x = DRAWING_PIXELS * i->x;
    x -= i->anchor == DRAWING_START ? 0.0 : i->anchor == DRAWING_END ? wide : 0.5 * wide;
    x = floor(x + 0.5);
    const double y = floor(DRAWING_PIXELS * i->y + 0.5) - dot * LETTER_ROWS;
    for (const char *c = i->text; *c != '\0'; c++, x += dot * DRAWING_ADVANCE) {
        const uint8_t *rows = letter_rows(*c);
        for (int v = 0; v < LETTER_ROWS + LETTER_BELOW; v++) {
            for (int u = 0; u < LETTER_COLUMNS; u++) {
                if (rows[v] >> (LETTER_COLUMNS - 1 - u) & 1) {
                    paint_rectangle(p, x + u * dot, y + v * dot, x + (u + 1) * dot,
                                    y + (v + 1) * dot, i->colour);
                }
            }
        }
    }
}

int drawing_paint(const drawing *d, picture *to, fail *f) {
    const double s = DRAWING_PIXELS;
    if (d->wrong) {
        return fail_set(f, "plot", "out of memory; close other programs");
    }
    if (picture_resize(to, DRAWING_PIXELS * d->width, DRAWING_PIXELS * d->height, f) != 0) {
        return -1;
    }
    memset(to->rgb, 0xFF, 3 * (size_t)to->width * to->height);
    for (unsigned k = 0; k < d->items; k++) {
        const drawing_item *i = &d->item[k];
        if (i->shape == DRAWING_RECTANGLE) {
            paint_rectangle(to, s * i->x, s * i->y, s * i->x2, s * i->y2, i->colour);
        } else if (i->shape == DRAWING_LINE) {
            paint_line(to, i, s);
        } else {
            paint_letters(to, i);
        }
    }
    return 0;
}
