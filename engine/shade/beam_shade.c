/* beam_shade - the colours of a square of pixels
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam_surface.h"

#include "engine/trace/triangle_common.h"

/* Of any triangle; its normal may vanish, or nearly so. */
static void set_surface(plt_surface *s, const plt_record *record) {
    float corner[3][3], normal[3];
    plt_record_corners(record, corner);
    plt_hit_normal((const float(*)[3])corner, normal);
    plt_surface_set(s, normal);
}

static inline void set_record(shaded *s, const plt_record *records, uint32_t record) {
    s->record = record;
    s->id = plt_primitive_id(plt_get_u32(&records[record].word[9]));
}

#if PLT_WITH_MIXES
static inline int is_small(const float normal[3]) {
    return __builtin_fabsf(normal[0]) < PLT_NORMAL_LEAST &&
           __builtin_fabsf(normal[1]) < PLT_NORMAL_LEAST &&
           __builtin_fabsf(normal[2]) < PLT_NORMAL_LEAST;
}

/* The same without a copy of the corners, as pixels of several samples set so many. */
static inline void set_usual(plt_surface *s, const plt_record *record) {
    float corner[3][3], normal[3];
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            corner[c][a] = plt_record_float(record, c, a);
        }
    }
    plt_triangle_normal((const float(*)[3])corner, normal);
    if (is_small(normal)) {
        set_surface(s, record);
    } else {
        plt_surface_set(s, normal);
    }
}

void plt_shaded_set(shaded *s, const plt_record *records, uint32_t record) {
    set_usual(&s->surface, &records[record]);
    set_record(s, records, record);
}
#else
static inline void plt_shaded_set(shaded *s, const plt_record *records, uint32_t record) {
    set_surface(&s->surface, &records[record]);
    set_record(s, records, record);
}
#endif

static void shade_row(const plt_beam *b, uint8_t shader, uint32_t y, const uint8_t sky[3],
                      uint8_t *rgb, shaded *s) {
    const plt_pixel *row = &b->pixel[y * b->square.side];
    const uint8_t red = sky[0], green = sky[1], blue = sky[2];
    float down[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        down[a] = (float)(int32_t)(b->square.y + y) * b->view->down[a];
    }
    for (uint32_t x = 0, columns = b->columns; x < columns; x++, rgb += 3) {
        if (row[x].record == PLT_MISS) {
            rgb[0] = red;
            rgb[1] = green;
            rgb[2] = blue;
            continue;
        }
        const uint32_t record = plt_pixel_record(&row[x]);
        if (record != s->record) {
            plt_shaded_set(s, b->records, record);
        }
        float dir[3]; /* as plt_view_direction has it */
        const float px = (float)(int32_t)(b->square.x + x);
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            dir[a] = (b->view->corner[a] + px * b->view->right[a]) + down[a];
        }
        plt_surface_colour(&s->surface, shader, s->id, dir, rgb);
    }
}

static void shade_sky(const uint8_t sky[3], uint8_t *rgb, uint32_t columns) {
    const uint8_t red = sky[0], green = sky[1], blue = sky[2];
    for (const uint8_t *end = rgb + 3 * columns; rgb < end; rgb += 3) {
        rgb[0] = red;
        rgb[1] = green;
        rgb[2] = blue;
    }
}

void plt_beam_shade(const plt_beam *b, const plt_frame *frame, const uint8_t *sky, uint8_t *rgb,
                    uint32_t row_bytes) {
    shaded s = {.record = PLT_MISS};
    const int is_empty = plt_beam_is_empty(b);
    for (uint32_t y = 0; y < b->rows; y++, rgb += row_bytes, sky += 3) {
        if (is_empty) {
            shade_sky(sky, rgb, b->columns);
        } else {
            shade_row(b, frame->shader, y, sky, rgb, &s);
        }
    }
}
