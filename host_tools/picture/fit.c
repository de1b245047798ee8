/* fit - see fit.h
 *
 * One axis at a time is enough to say which picture pixels lie under a panel
 * pixel: a span of the axis in units of 1 / panel length. Products of a
 * picture's and a panel's side stay below 2^31, of two such and 255 below
 * 2^64 for sides up to PICTURE_SIDE_MAX.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/fit.h"

#include <string.h>

/* An axis: picture pixels from .. from + count are shown on panel pixels
 * at .. at + room. */
typedef struct axis {
    unsigned from, count, at, room;
} axis;

static unsigned scaled(unsigned side, unsigned to, unsigned from) {
    const uint64_t value = ((uint64_t)side * to + from / 2) / from;
    return value == 0 ? 1 : (unsigned)value;
}

static axis centred(unsigned count, unsigned shown, unsigned panel, unsigned room) {
    return (axis){(count - shown) / 2, shown, (panel - room) / 2, room};
}

static unsigned least(unsigned a, unsigned b) {
    return a < b ? a : b;
}

static void lay_out(const picture *p, const picture *panel, enum fit_mode mode, axis *x, axis *y) {
    const unsigned w = p->width, h = p->height, W = panel->width, H = panel->height;
    const int wider = (uint64_t)w * H > (uint64_t)h * W;
    *x = centred(w, w, W, W);
    *y = centred(h, h, H, H);
    if (mode == FIT_NONE) {
        *x = centred(w, least(w, W), W, least(w, W));
        *y = centred(h, least(h, H), H, least(h, H));
    } else if (mode == FIT_CONTAIN && wider) {
        *y = centred(h, h, H, least(H, scaled(h, W, w)));
    } else if (mode == FIT_CONTAIN) {
        *x = centred(w, w, W, least(W, scaled(w, H, h)));
    } else if (mode == FIT_COVER && wider) {
        *x = centred(w, least(w, scaled(W, h, H)), W, W);
    } else if (mode == FIT_COVER) {
        *y = centred(h, least(h, scaled(H, w, W)), H, H);
    }
}

/* How much of picture pixel i lies under panel pixel k, of a->count. */
static uint64_t overlap(const axis *a, unsigned i, unsigned k) {
    const uint64_t begin = (uint64_t)i * a->room, end = begin + a->room;
    const uint64_t from = (uint64_t)k * a->count, to = from + a->count;
    return (end < to ? end : to) - (begin > from ? begin : from);
}

static unsigned first_under(const axis *a, unsigned k) {
    return (unsigned)((uint64_t)k * a->count / a->room);
}

static unsigned end_under(const axis *a, unsigned k) {
    return (unsigned)(((uint64_t)(k + 1) * a->count + a->room - 1) / a->room);
}

static void average(const picture *p, const axis *x, const axis *y, unsigned i, unsigned j,
                    uint8_t *rgb) {
    const uint64_t whole = (uint64_t)x->count * y->count;
    uint64_t sum[3] = {whole / 2, whole / 2, whole / 2};
    for (unsigned v = first_under(y, j); v < end_under(y, j); v++) {
        const uint8_t *row = p->rgb + 3 * ((size_t)(y->from + v) * p->width + x->from);
        const uint64_t height = overlap(y, v, j);
        for (unsigned u = first_under(x, i); u < end_under(x, i); u++) {
            const uint64_t weight = height * overlap(x, u, i);
            for (unsigned c = 0; c < 3; c++) {
                sum[c] += weight * row[3 * u + c];
            }
        }
    }
    for (unsigned c = 0; c < 3; c++) {
        rgb[c] = (uint8_t)(sum[c] / whole);
    }
}

void fit_picture(const picture *p, picture *panel, enum fit_mode mode) {
    const size_t bytes = 3 * (size_t)panel->width * panel->height;
    axis x, y;
    if (p->width == panel->width && p->height == panel->height) {
        memcpy(panel->rgb, p->rgb, bytes);
        return;
    }
    memset(panel->rgb, 0, bytes);
    lay_out(p, panel, mode, &x, &y);
    for (unsigned j = 0; j < y.room; j++) {
        for (unsigned i = 0; i < x.room; i++) {
            average(p, &x, &y, i, j,
                    panel->rgb + 3 * ((size_t)(y.at + j) * panel->width + x.at + i));
        }
    }
}
