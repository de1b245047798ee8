/* model - see model.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hid/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/picture/dither.h"
#include "platform/wire/wire_format.h"
#include "tests/hid/pattern.h"

static const model_kind *const kinds[] = {
    &model_planelet,  &model_mini,    &model_nova,     &model_nova_elite, &model_apex,
    &model_apex_2023, &model_nexus,   &model_logitech, &model_picolcd,    &model_original,
    &model_deck,      &model_deck_xl, &model_deck_neo, &model_deck_plus,  &model_corsair_lcd};

const model_kind *model_kind_named(const char *name) {
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        if (strcmp(kinds[i]->name, name) == 0) {
            return kinds[i];
        }
    }
    return NULL;
}

static unsigned otherwise(unsigned value, unsigned if_zero) {
    return value != 0 ? value : if_zero;
}

model *model_make(const model_kind *kind, model_shape shape) {
    model *m = calloc(1, sizeof *m);
    if (m == NULL) {
        return NULL;
    }
    m->kind = kind;
    m->width = otherwise(kind->width, otherwise(shape.width, 64));
    m->height = otherwise(kind->height, otherwise(shape.height, 48));
    m->format = shape.format;
    m->reads = shape.reads;
    m->has_keys = shape.has_keys;
    m->report_bytes = otherwise(kind->output_bytes, otherwise(shape.report_bytes, 64));
    m->in_bytes = otherwise(shape.in_bytes, kind->input_bytes);
    m->brightness = -1;
    m->rgb = calloc(3 * (size_t)m->width, m->height);
    if (m->rgb == NULL || (kind->open != NULL && kind->open(m) != 0)) {
        model_free(m);
        return NULL;
    }
    return m;
}

void model_free(model *m) {
    if (m != NULL) {
        free(m->rgb);
        free(m->state);
        free(m);
    }
}

void model_breach(model *m, const char *what) {
    if (m->wrong++ == 0) {
        snprintf(m->why, sizeof m->why, "%s", what);
    }
}

static size_t put(uint8_t *to, size_t at, const uint8_t *bytes, size_t count) {
    memcpy(to + at, bytes, count);
    return at + count;
}

/* One report of whole bytes: number, count, usage, main item. */
static size_t put_report(uint8_t *to, size_t at, uint8_t number, unsigned bytes, uint8_t item) {
    const uint8_t id[] = {0x85, number};
    const uint8_t rest[] = {0x96, (uint8_t)bytes, (uint8_t)(bytes >> 8), 0x09, 0x02, item, 0x02};
    if (bytes == 0) {
        return at;
    }
    return put(to, number != 0 ? put(to, at, id, 2) : at, rest, sizeof rest);
}

/* HID 1.11, section 6.2.2: a vendor's collection of byte arrays. */
size_t model_descriptor(const model *m, uint8_t *to) {
    static const uint8_t head[] = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01,
                                   0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08};
    static const uint8_t tail[] = {0xC0};
    const model_kind *k = m->kind;
    size_t at = put(to, 0, head, sizeof head);
    at = put_report(to, at, k->input_number, m->in_bytes, 0x81);
    at = put_report(to, at, k->output_number, m->report_bytes, 0x91);
    at = put_report(to, at, k->feature_number, k->feature_bytes, 0xB1);
    return put(to, at, tail, sizeof tail);
}

/* A pixel as a panel of fewer bits has it. */
static void through_bits(const model *m, uint8_t *rgb, unsigned x, unsigned y) {
    const int lit = dither_is_lit(rgb, x, y);
    for (unsigned c = 0; c < 3; c++) {
        rgb[c] = m->kind->bits == 1 ? (lit ? 255 : 0) : dither_six_bits(rgb[c], x, y);
    }
}

/* What a Neo does not show: left and right of its window. */
static void hide_corners(const model *m, uint8_t *rgb) {
    for (unsigned y = 192; m->kind == &model_deck_neo && y < m->height; y++) {
        memset(rgb + 3 * (size_t)y * 384, 0, 3 * 96);
        memset(rgb + 3 * ((size_t)y * 384 + 288), 0, 3 * 96);
    }
}

/* Rows of a picture through the panel's format and back. */
static void through_format(const model *m, uint8_t *rgb) {
    uint8_t row[3 * 1024];
    hide_corners(m, rgb);
    for (unsigned i = 0; m->kind->bits != 0 && i < m->width * m->height; i++) {
        through_bits(m, rgb + 3 * (size_t)i, i % m->width, i / m->width);
    }
    for (unsigned y = 0; m->kind == &model_planelet && y < m->height; y++) {
        uint8_t *at = rgb + 3 * (size_t)y * m->width;
        wire_row_from_rgb(row, m->format, at, m->width, 0, y);
        wire_row_to_rgb(at, m->format, row, m->width);
    }
}

enum { SQUARE = 24 };

/* The mean of squares that the panel is off in one of its squares. */
static double off_in(const model *m, const uint8_t *rgb, unsigned left, unsigned top) {
    double sum = 0;
    unsigned count = 0;
    for (unsigned y = top; y < top + SQUARE && y < m->height; y++) {
        for (unsigned i = 3 * left; i < 3 * (left + SQUARE) && i < 3 * m->width; i++, count++) {
            const size_t at = 3 * (size_t)y * m->width + i;
            sum += ((double)rgb[at] - m->rgb[at]) * ((double)rgb[at] - m->rgb[at]);
        }
    }
    return sum / count;
}

static int is_shown(const model *m, const uint8_t *rgb) {
    if (m->kind->lossy == 0) {
        return memcmp(rgb, m->rgb, 3 * (size_t)m->width * m->height) == 0;
    }
    for (unsigned y = 0; y < m->height; y += SQUARE) {
        for (unsigned x = 0; x < m->width; x += SQUARE) {
            if (off_in(m, rgb, x, y) > m->kind->lossy) {
                return 0;
            }
        }
    }
    return 1;
}

int model_shows_pattern(const model *m, unsigned from, unsigned count) {
    uint8_t *rgb = malloc(3 * (size_t)m->width * m->height);
    int found = -1;
    for (unsigned i = 0; rgb != NULL && i < count && found < 0; i++) {
        pattern_fill(from + i, m->width, m->height, rgb);
        through_format(m, rgb);
        found = is_shown(m, rgb) ? (int)(from + i) : -1;
    }
    free(rgb);
    return found;
}

static int piece_is_whole(const model *m, uint8_t *const *pictures, unsigned count, unsigned x,
                          unsigned y) {
    const size_t at = 3 * ((size_t)y * m->width + x);
    const unsigned width = m->width - x < 16 ? m->width - x : 16;
    for (unsigned i = 0; i < count; i++) {
        if (memcmp(m->rgb + at, pictures[i] + at, 3 * (size_t)width) == 0) {
            return 1;
        }
    }
    return 0;
}

/* Pictures as the panel would show them, and a dark one at the end. */
static uint8_t **make_pictures(const model *m, unsigned from, unsigned count) {
    uint8_t **pictures = calloc(count + 1, sizeof *pictures);
    for (unsigned i = 0; pictures != NULL && i <= count; i++) {
        pictures[i] = calloc(3 * (size_t)m->width, m->height);
        if (pictures[i] == NULL) {
            abort();
        }
        if (i < count) {
            pattern_fill(from + i, m->width, m->height, pictures[i]);
            through_format(m, pictures[i]);
        }
    }
    return pictures;
}

int model_rows_are_whole(const model *m, unsigned from, unsigned count) {
    const unsigned columns = (m->width + 15) / 16;
    uint8_t **pictures = make_pictures(m, from, count);
    int whole = pictures != NULL;
    for (unsigned i = 0; i < columns * m->height && whole; i++) {
        whole = piece_is_whole(m, pictures, count + 1, i % columns * 16, i / columns);
    }
    for (unsigned i = 0; pictures != NULL && i <= count; i++) {
        free(pictures[i]);
    }
    free(pictures);
    return whole;
}
