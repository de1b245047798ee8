/* beam_smooth - the colours of a square of pixels, by normals and colours of corners
 *
 * A pixel keeps its triangle, not where it was hit: u and v are had from the exact test, once more
 * for each pixel.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"
#include "engine/shade/pixel_mix.h"
#include "engine/shade/smooth.h"

#if PLT_WITH_SURFACE && PLT_WITH_BEAMS

#include <string.h>

#include "engine/trace/surface_hit.h"

/* The triangle that was shaded last. */
typedef struct shaded {
    uint32_t record;
    plt_surface_corners corners;
} shaded;

static int shade_pixel(const plt_beam *b, const plt_smooth *how, uint32_t x, uint32_t y, shaded *s,
                       uint8_t rgb[3]) {
    const uint32_t index = plt_pixel_record(&b->pixel[y * b->square.side + x]);
    const plt_record *record = &b->records[index];
    const uint32_t word = plt_get_u32(&record->word[9]);
    float corner[3][3], dir[3], t = PLT_VIEW_FAR, u = 0.0f, v = 0.0f;
    plt_ray_hit hit;
    plt_surface_point point;
    if (index != s->record) {
        const int status = plt_surface_of_record(how->traversal, record,
                                                 plt_beam_image_index(b, index), &s->corners);
        if (status != PLT_OK) {
            return status;
        }
        s->record = index;
    }
    plt_record_corners(record, corner);
    plt_view_direction(b->view, b->square.x + x, b->square.y + y, dir);
    if (plt_triangle_ray(&b->origin, dir, (const float(*)[3])corner, PLT_VIEW_FAR, 1,
                         &hit)) { /* it is one */
        plt_ray_hit_weights(&hit, plt_primitive_rotation(word), &u, &v);
        t = hit.t;
    }
    plt_surface_mix(&s->corners, u, v, &point);
    return plt_smooth_point(how, plt_primitive_id(word), dir, t, &point, rgb);
}

int plt_beam_smooth(const plt_beam *b, const plt_smooth *how, const uint8_t *sky, uint8_t *rgb,
                    uint32_t row_bytes) {
    shaded s = {.record = PLT_MISS};
    const int is_empty = plt_beam_is_empty(b);
    for (uint32_t y = 0; y < b->rows; y++, rgb += row_bytes, sky += 3) {
        const plt_pixel *row = &b->pixel[y * b->square.side];
        for (uint32_t x = 0; x < b->columns; x++) {
            if (is_empty || row[x].record == PLT_MISS) {
                memcpy(&rgb[3 * x], sky, 3);
                continue;
            }
            const int status = shade_pixel(b, how, x, y, &s, &rgb[3 * x]);
            if (status != PLT_OK) {
                return status;
            }
        }
    }
    return PLT_OK;
}

#if PLT_WITH_SAMPLES
/* Pixel (x, y) of the square. */
static int mix(const plt_beam *b, const plt_smooth *how, plt_sampling *s, uint32_t x, uint32_t y,
               const uint8_t sky[3], shaded *last, uint8_t rgb[3]) {
    const uint32_t across = s->across, end_x = across * (x + 1), end_y = across * (y + 1);
    plt_mix m;
    plt_mix_begin_pixel(s, &m);
    for (uint32_t row = across * y; row < end_y; row++) {
        for (uint32_t column = across * x; column < end_x; column++) {
            uint8_t colour[3] = {sky[0], sky[1], sky[2]};
            if (b->pixel[row * b->square.side + column].record != PLT_MISS) {
                const int status = shade_pixel(b, how, column, row, last, colour);
                if (status != PLT_OK) {
                    return status;
                }
            }
            plt_mix_add(&m, colour, 1);
        }
    }
    plt_mix_put(s, &m, plt_mixed_bit(s, x, y), rgb);
    return PLT_OK;
}

int plt_beam_smooth_mix(const plt_beam *b, const plt_smooth *how, plt_sampling *s,
                        const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes) {
    shaded last = {.record = PLT_MISS};
    const int is_empty = plt_beam_is_empty(b);
    for (uint32_t y = 0; y < b->rows / s->across; y++, rgb += row_bytes, sky += 3) {
        for (uint32_t x = 0; x < b->columns / s->across; x++) {
            if (!plt_is_shaded(s, plt_mixed_bit(s, x, y))) {
                continue;
            }
            if (is_empty) {
                memcpy(&rgb[3 * x], sky, 3);
                continue;
            }
            const int status = mix(b, how, s, x, y, sky, &last, &rgb[3 * x]);
            if (status != PLT_OK) {
                return status;
            }
        }
    }
    return PLT_OK;
}
#endif

#endif
