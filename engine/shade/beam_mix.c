/* beam_mix - the colours of a square of samples, and of distances
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "engine/shade/beam_surface.h"
#include "engine/shade/pixel_mix.h"

#if PLT_WITH_SAMPLES || PLT_WITH_DIAGRAMS

/* A pixel: its first sample in the square, and the direction through its middle. */
typedef struct place {
    uint32_t x, y;
    float dir[3];
    const uint8_t *sky;
} place;

static int has_depths(const plt_sampling *s) {
    return PLT_WITH_DIAGRAMS && s->frame->shader == PLT_SHADE_DEPTH;
}

static const plt_pixel *sample_at(const plt_beam *b, uint32_t x, uint32_t y) {
    return &b->pixel[y * b->square.side + x];
}

#if PLT_WITH_DIAGRAMS
static void depth_of(plt_beam *b, const plt_sampling *s, uint32_t x, uint32_t y, uint8_t rgb[3]) {
    float dir[3];
    rgb[0] = rgb[1] = rgb[2] = 0;
    if (sample_at(b, x, y)->record != PLT_MISS) {
        plt_beam_settle(b, x, y);
        plt_view_direction(b->view, b->square.x + x, b->square.y + y, dir);
        plt_depth_colour(&s->depths, dir, sample_at(b, x, y)->t, rgb);
    }
}
#endif

/* Of the sample in column x and row y of the square. */
static void colour_of(plt_beam *b, const plt_sampling *s, const place *at, uint32_t x, uint32_t y,
                      shaded *last, uint8_t rgb[3]) {
#if PLT_WITH_DIAGRAMS
    if (has_depths(s)) {
        depth_of(b, s, x, y, rgb);
        return;
    }
#endif
    const plt_pixel *sample = sample_at(b, x, y);
    if (sample->record == PLT_MISS) {
        memcpy(rgb, at->sky, 3);
        return;
    }
    if (plt_pixel_record(sample) != last->record) {
        set_shaded(last, b->records, plt_pixel_record(sample));
    }
    plt_surface_colour(&last->surface, s->frame->shader, last->id, at->dir, rgb);
}

#if PLT_WITH_SAMPLES
/* The record that all samples have, or PLT_MISS if none has any; else what no record is. */
#define MIXED (PLT_MISS - 1)

static inline uint32_t record_of_all(const plt_beam *b, uint32_t x, uint32_t y) {
    const plt_pixel *sample = sample_at(b, x, y);
    const uint32_t across = b->view->across, side = b->square.side, record = sample->record;
    uint32_t other = (sample[1].record ^ record) | (sample[side].record ^ record) |
                     (sample[side + 1].record ^ record);
    if (across > 2) {
        for (uint32_t i = 0; i < across * across; i++) {
            other |= sample[i / across * side + i % across].record ^ record;
        }
    }
    return (other & ~PLT_PIXEL_BOUND) == 0 ? record : MIXED;
}

static void mix(plt_beam *b, plt_sampling *s, const place *at, uint32_t bit, shaded *last,
                uint8_t rgb[3]) {
    uint32_t record = PLT_MISS;
    uint8_t colour[3] = {at->sky[0], at->sky[1], at->sky[2]};
    plt_mix m;
    plt_mix_begin(&m);
    for (uint32_t y = at->y; y < at->y + s->across; y++) {
        for (uint32_t x = at->x; x < at->x + s->across; x++) {
            if (has_depths(s) || plt_pixel_record(sample_at(b, x, y)) != record) {
                colour_of(b, s, at, x, y, last, colour);
                record = plt_pixel_record(sample_at(b, x, y));
            }
            plt_mix_add(&m, colour);
        }
    }
    plt_mix_put(s, &m, bit, rgb);
}
#endif

/* A pixel of which not all that is seen is the sky. */
static void shade(plt_beam *b, plt_sampling *s, const place *at, uint32_t bit, int is_mixed,
                  shaded *last, uint8_t rgb[3]) {
#if PLT_WITH_SAMPLES
    if (is_mixed) {
        mix(b, s, at, bit, last, rgb);
        return;
    }
#else
    (void)is_mixed;
#endif
    (void)bit;
    colour_of(b, s, at, at->x, at->y, last, rgb);
}

static void shade_nothing(const plt_beam *b, const plt_sampling *s, const uint8_t *sky,
                          uint8_t *rgb, uint32_t row_bytes) {
    static const uint8_t black[3] = {0, 0, 0};
    for (uint32_t y = 0; y < b->rows / s->across; y++, rgb += row_bytes, sky += 3) {
        for (uint32_t x = 0; x < b->columns / s->across; x++) {
            memcpy(rgb + 3 * x, has_depths(s) ? black : sky, 3);
        }
    }
}

static void shade_row(plt_beam *b, plt_sampling *s, uint32_t y, const uint8_t *sky, uint8_t *rgb,
                      shaded *last) {
    const uint32_t first_x = b->square.x / s->across, first_y = b->square.y / s->across;
    const uint8_t red = sky[0], green = sky[1], blue = sky[2];
    place at = {.y = s->across * y, .sky = sky};
    for (uint32_t x = 0; x < b->columns / s->across; x++, rgb += 3, at.x += s->across) {
        const uint32_t bit = plt_mixed_bit(s, b->square.side, x, y);
        const uint32_t record =
            s->across == 1 ? sample_at(b, at.x, at.y)->record : record_of_all(b, at.x, at.y);
        if (!plt_is_shaded(s, bit)) {
            continue;
        }
        if (record == PLT_MISS && !has_depths(s)) {
            rgb[0] = red;
            rgb[1] = green;
            rgb[2] = blue;
            continue;
        }
        const int is_mixed = s->across > 1 && (record == MIXED || has_depths(s));
        plt_view_direction(&s->middle, first_x + x, first_y + y, at.dir);
        shade(b, s, &at, bit, is_mixed, last, rgb);
    }
}

void plt_beam_mix(plt_beam *b, plt_sampling *s, const uint8_t *sky, uint8_t *rgb,
                  uint32_t row_bytes) {
    shaded last = {.record = PLT_MISS};
    if (plt_beam_is_empty(b)) {
        shade_nothing(b, s, sky, rgb, row_bytes);
        return;
    }
    for (uint32_t y = 0; y < b->rows / s->across; y++, rgb += row_bytes, sky += 3) {
        shade_row(b, s, y, sky, rgb, &last);
    }
}

#endif
