/* beam_mix - the colours of a square of samples, and of distances
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "engine/shade/beam_surface.h"
#include "engine/shade/pixel_mix.h"

#if PLT_WITH_SAMPLES || PLT_WITH_DIAGRAMS

/* A pixel: its first sample in the square, and how it is seen through its middle. */
typedef struct place {
    uint32_t x, y;
    plt_sight seen;
    const uint8_t *sky;
} place;

/* Triangles that were shaded last: those of pixels side by side follow each other in lists. */
#define SHADED 16u

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

/* The record that all samples have, or PLT_MISS if none has any; else what no record is. */
#define MIXED (PLT_MISS - 1)

/* The record of a sample that hits nothing, without PLT_PIXEL_BOUND. */
#define NONE (PLT_MISS & ~PLT_PIXEL_BOUND)

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

/* Of a record, or of the sky. */
static void colour_of(const plt_beam *b, const plt_sampling *s, const place *at, uint32_t record,
                      some_shaded *last, uint8_t rgb[3]) {
    if (record == NONE) {
        rgb[0] = at->sky[0];
        rgb[1] = at->sky[1];
        rgb[2] = at->sky[2];
        return;
    }
    shaded *shown = &last->of[record % SHADED];
    if (record != shown->record) {
        plt_shaded_set(shown, b->records, record);
    }
    plt_surface_seen(&shown->surface, s->frame->shader, shown->id, &at->seen, rgb);
}

#if PLT_WITH_SAMPLES
/* How many of a pixel's samples after the first have its record; they are MIXED from then on, and
 * count no more. */
static inline uint32_t take_alike(uint32_t *first, const uint32_t *end) {
    const uint32_t of = *first;
    uint32_t count = 1;
    for (uint32_t *record = first + 1; record < end; record++) {
        if (*record == of) {
            *record = MIXED;
            count++;
        }
    }
    return count;
}

/* The records of a pixel's samples; returns their end. */
static inline uint32_t *get_records(const plt_pixel *sample, uint32_t across, uint32_t side,
                                    uint32_t *to) {
    for (const plt_pixel *end = sample + across * side; sample < end; sample += side) {
        *to++ = plt_pixel_record(&sample[0]);
        *to++ = plt_pixel_record(&sample[1]);
        if (across > 2) {
            *to++ = plt_pixel_record(&sample[2]);
            *to++ = plt_pixel_record(&sample[3]);
        }
    }
    return to;
}

static void mix(const plt_beam *b, plt_sampling *s, const place *at, uint32_t bit,
                some_shaded *last, uint8_t rgb[3]) {
    uint32_t records[16];
    plt_mix m;
    plt_mix_begin_pixel(s, &m);
    const uint32_t *end =
        get_records(sample_at(b, at->x, at->y), s->across, b->square.side, records);
    for (uint32_t *record = records; record < end; record++) {
        uint8_t colour[3];
        if (*record != MIXED) {
            colour_of(b, s, at, *record, last, colour);
            plt_mix_add(&m, colour, take_alike(record, end));
        }
    }
    plt_mix_put(s, &m, bit, rgb);
}

#if PLT_WITH_DIAGRAMS
static void mix_depths(plt_beam *b, plt_sampling *s, const place *at, uint32_t bit,
                       uint8_t rgb[3]) {
    const uint32_t across = s->across;
    plt_mix m;
    plt_mix_begin_pixel(s, &m);
    for (uint32_t i = 0; i < across * across; i++) {
        uint8_t colour[3];
        depth_of(b, s, at->x + i % across, at->y + i / across, colour);
        plt_mix_add(&m, colour, 1);
    }
    plt_mix_put(s, &m, bit, rgb);
}
#endif
#endif

/* A pixel of which not all that is seen is the sky; `record`: that all samples have, or MIXED. */
static void shade(plt_beam *b, plt_sampling *s, const place *at, uint32_t bit, uint32_t record,
                  some_shaded *last, uint8_t rgb[3]) {
#if PLT_WITH_DIAGRAMS
    if (has_depths(s)) {
#if PLT_WITH_SAMPLES
        if (s->across > 1) {
            mix_depths(b, s, at, bit, rgb);
            return;
        }
#endif
        depth_of(b, s, at->x, at->y, rgb);
        return;
    }
#endif
#if PLT_WITH_SAMPLES
    if (record == MIXED) {
        mix(b, s, at, bit, last, rgb);
        return;
    }
#endif
    (void)bit;
    colour_of(b, s, at, record & ~PLT_PIXEL_BOUND, last, rgb);
}

static void shade_nothing(const plt_beam *b, const plt_sampling *s, const uint8_t *sky,
                          uint8_t *rgb, uint32_t row_bytes) {
    static const uint8_t black[3] = {0, 0, 0};
    const uint32_t columns = b->columns / s->across, rows = b->rows / s->across;
    for (uint32_t y = 0; y < rows; y++, rgb += row_bytes, sky += 3) {
        for (uint32_t x = 0; x < columns; x++) {
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
    float down[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        down[a] = (float)(int32_t)row * s->middle.down[a];
    }
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
        float dir[3]; /* as plt_view_direction has it */
        const float px = (float)(int32_t)(first_x + x);
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            dir[a] = (s->middle.corner[a] + px * s->middle.right[a]) + down[a];
        }
        plt_sight_set(&at.seen, dir);
        shade(b, s, &at, plt_mixed_bit(s, x, y), record, last, rgb);
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
