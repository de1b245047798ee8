/* gaps - see gaps.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/gaps.h"

#include <stddef.h>
#include <string.h>

/* Pixels of a row of keys with gaps, and of a column. */
static unsigned keys_width(const key_grid *g) {
    return g->columns * g->side + (g->columns - 1) * g->gap_x;
}

static unsigned keys_height(const key_grid *g) {
    return g->rows * g->side + (g->rows - 1) * g->gap_y;
}

/* Rows below the keys, in a picture with gaps. */
static unsigned rows_below(const key_grid *g, unsigned width, unsigned height) {
    const unsigned rows = height - g->rows * g->side;
    return (rows * keys_width(g) + width / 2) / width;
}

void gaps_size(const key_grid *g, unsigned width, unsigned height, unsigned *span_width,
               unsigned *span_height) {
    const unsigned below = rows_below(g, width, height);
    *span_width = keys_width(g);
    *span_height = keys_height(g) + (below > 0 ? g->gap_y + below : 0);
}

static const uint8_t *pixel(const picture *p, unsigned x, unsigned y) {
    return p->rgb + 3 * ((size_t)y * p->width + x);
}

static void cut_keys(const key_grid *g, const picture *span, picture *panel) {
    for (unsigned y = 0; y < g->rows * g->side; y++) {
        for (unsigned column = 0; column < g->columns; column++) {
            memcpy(panel->rgb + 3 * ((size_t)y * panel->width + column * g->side),
                   pixel(span, column * (g->side + g->gap_x), y + y / g->side * g->gap_y),
                   (size_t)3 * g->side);
        }
    }
}

static void cut_below(const key_grid *g, const picture *span, picture *panel) {
    const unsigned top = g->rows * g->side, from = keys_height(g) + g->gap_y;
    const unsigned rows = panel->height - top, span_rows = span->height - from;
    for (unsigned y = 0; y < rows; y++) {
        for (unsigned x = 0; x < panel->width; x++) {
            memcpy(panel->rgb + 3 * ((size_t)(top + y) * panel->width + x),
                   pixel(span, (2 * x + 1) * span->width / (2 * panel->width),
                         from + (2 * y + 1) * span_rows / (2 * rows)),
                   3);
        }
    }
}

void gaps_cut(const key_grid *g, const picture *span, picture *panel) {
    cut_keys(g, span, panel);
    if (panel->height > g->rows * g->side) {
        cut_below(g, span, panel);
    }
}

void gaps_keys(const key_grid *g, const display_key *keys, display_key *to) {
    unsigned count = 0;
    for (; count < KEYS_MOST && keys[count].name != NULL; count++) {
        const unsigned x = keys[count].x, y = keys[count].y;
        to[count] = keys[count];
        to[count].x = (uint16_t)(x + x / g->side * g->gap_x);
        to[count].y = (uint16_t)(y + y / g->side * g->gap_y);
    }
    to[count] = (display_key){NULL, STEER_LEFT, 0, 0};
}
