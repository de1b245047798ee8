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

/* Triangles that were shaded last: those of pixels side by side follow each other in lists. */
#define SHADED 4u

typedef struct some_shaded {
    shaded of[SHADED];
} some_shaded;

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
                      some_shaded *last, uint8_t rgb[3]) {
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
    const uint32_t record = plt_pixel_record(sample);
    shaded *shown = &last->of[record % SHADED];
    if (record != shown->record) {
        set_shaded(shown, b->records, record);
    }
    plt_surface_colour(&shown->surface, s->frame->shader, shown->id, at->dir, rgb);
}

/* The record that all samples have, or PLT_MISS if none has any; else what no record is. */
#define MIXED (PLT_MISS - 1)

static inline uint32_t record_of_all(const plt_pixel *sample, uint32_t across, uint32_t side) {
    const uint32_t record = sample->record;
    uint32_t other = 0;
    if (across > 1) {
        other = (sample[1].record ^ record) | (sample[side].record ^ record) |
                (sample[side + 1].record ^ record);
    }
    if (across > 2) {
        for (const plt_pixel *end = sample + 4 * side; sample < end; sample += side) {
            other |= (sample[0].record ^ record) | (sample[1].record ^ record) |
                     (sample[2].record ^ record) | (sample[3].record ^ record);
        }
    }
    return (other & ~PLT_PIXEL_BOUND) == 0 ? record : MIXED;
}

#if PLT_WITH_SAMPLES
/* How many of a pixel's samples from `first` on have the record of that one; they are PLT_MISS - 1
 * from then on, and count no more. */
static uint32_t take_alike(uint32_t record[16], uint32_t first, uint32_t samples) {
    const uint32_t of = record[first];
    uint32_t count = 0;
    for (uint32_t i = first; i < samples; i++) {
        if (record[i] == of) {
            record[i] = MIXED;
            count++;
        }
    }
    return count;
}

static void mix(plt_beam *b, plt_sampling *s, const place *at, uint32_t bit, some_shaded *last,
                uint8_t rgb[3]) {
    const uint32_t across = s->across, samples = across * across; /* 2 or 4 */
    const uint32_t last_column = across - 1, shift = across / 2;
    uint32_t record[16];
    plt_mix m;
    plt_mix_begin(&m);
    for (uint32_t i = 0; i < samples; i++) {
        record[i] = plt_pixel_record(sample_at(b, at->x + (i & last_column), at->y + (i >> shift)));
    }
    for (uint32_t i = 0; i < samples; i++) {
        uint8_t colour[3];
        if (record[i] != MIXED) {
            colour_of(b, s, at, at->x + (i & last_column), at->y + (i >> shift), last, colour);
            plt_mix_add(&m, colour, has_depths(s) ? 1 : take_alike(record, i, samples));
        }
    }
    plt_mix_put(s, &m, bit, rgb);
}
#endif

/* A pixel of which not all that is seen is the sky. */
static void shade(plt_beam *b, plt_sampling *s, const place *at, uint32_t bit, int is_mixed,
                  some_shaded *last, uint8_t rgb[3]) {
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
                      some_shaded *last) {
    const uint32_t across = s->across, side = b->square.side;
    const uint32_t first_x = b->square.x / across, row = b->square.y / across + y;
    const uint8_t red = sky[0], green = sky[1], blue = sky[2];
    const int depths = has_depths(s), some = s->columns > 0;
    const plt_pixel *sample = sample_at(b, 0, across * y);
    place at = {.y = across * y, .sky = sky};
    for (uint32_t x = 0; at.x < b->columns; x++, rgb += 3, at.x += across, sample += across) {
        if (some && !plt_is_shaded(s, plt_mixed_bit(s, x, y))) {
            continue;
        }
        const uint32_t record = record_of_all(sample, across, side);
        if (record == PLT_MISS && !depths) {
            rgb[0] = red;
            rgb[1] = green;
            rgb[2] = blue;
            continue;
        }
        const int is_mixed = across > 1 && (record == MIXED || depths);
        plt_view_direction(&s->middle, first_x + x, row, at.dir);
        shade(b, s, &at, plt_mixed_bit(s, x, y), is_mixed, last, rgb);
    }
}

void plt_beam_mix(plt_beam *b, plt_sampling *s, const uint8_t *sky, uint8_t *rgb,
                  uint32_t row_bytes) {
    some_shaded last;
    if (plt_beam_is_empty(b)) {
        shade_nothing(b, s, sky, rgb, row_bytes);
        return;
    }
    for (uint32_t i = 0; i < SHADED; i++) {
        last.of[i].record = PLT_MISS;
    }
    for (uint32_t y = 0; y < b->rows / s->across; y++, rgb += row_bytes, sky += 3) {
        shade_row(b, s, y, sky, rgb, &last);
    }
}

#endif
