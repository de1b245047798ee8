/* packet_shade - see packet_shade.h
 *
 * Eye-light frames, squares that lie in them: group by group, four pixels, two by two.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/packet_shade.h"

#include "engine/base/bytes.h"
#include "engine/shade/surface_lanes.h"
#include "engine/trace/triangle_common.h"

#if PLT_SHADES_IN_LANES

/* Directions of a group whose rays are all longest along axis z, up to their signs, the largest
 * component 1: slopes are the other two. */
static inline void get_directions(const plt_group_rays *g, int z, f4 to[3]) {
    const float ones[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    const float *row[3] = {ones, ones, ones};
    row[plt_axis_after[z]] = g->slope[0];
    row[plt_axis_after[plt_axis_after[z]]] = g->slope[1];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        to[a] = f4_load(row[a]);
    }
}

/* Two pixels, 6 bytes; the fourth byte of a word means nothing. */
static inline uint64_t pair_of(uint64_t left, uint64_t right) {
    return (left & 0xFFFFFFu) | right << 24;
}

static inline void put_pair(uint8_t rgb[6], uint64_t pair) {
    plt_put_u32(rgb, (uint32_t)pair);
    rgb[4] = (uint8_t)(pair >> 32);
    rgb[5] = (uint8_t)(pair >> 40);
}

/* Two rows where nothing is hit: their words, each twice, and pairs. */
typedef struct sky_rows {
    u4 word;
    uint64_t above, below;
} sky_rows;

static inline sky_rows sky_of(const uint8_t sky[6]) {
    const uint32_t above = sky[0] | (uint32_t)sky[1] << 8 | (uint32_t)sky[2] << 16;
    const uint32_t below = sky[3] | (uint32_t)sky[4] << 8 | (uint32_t)sky[5] << 16;
    const uint32_t both[4] = {above, above, below, below};
    const sky_rows rows = {u4_load(both), pair_of(above, above), pair_of(below, below)};
    return rows;
}

static inline void shade_hits(const plt_group_rays *g, int z, m4 missed, const sky_rows *sky,
                              uint8_t *rgb, uint32_t row_bytes) {
    const f4 normal[3] = {f4_load(g->normal[0]), f4_load(g->normal[1]), f4_load(g->normal[2])};
    f4 dir[3];
    uint32_t word[4];
    get_directions(g, z, dir);
    u4_store(word, u4_select(missed, sky->word, plt_surface_clay(normal, dir)));
    put_pair(rgb, pair_of(word[0], word[1]));
    put_pair(rgb + row_bytes, pair_of(word[2], word[3]));
}

/* Of a packet without rays that are traced nothing is set. */
static void shade_groups(const plt_packet *p, uint32_t side, const uint8_t *sky, uint8_t *rgb,
                         uint32_t row_bytes) {
    static const uint8_t apart[8] = {0, 1, 4, 5, 16, 17, 20, 21}; /* every other bit of Z order */
    for (uint32_t y = 0; y < side / 2; y++, rgb += 2 * row_bytes) {
        const sky_rows rows = sky_of(&sky[6 * y]);
        const plt_group_rays *row = &p->rays[2u * apart[y]];
        for (uint32_t x = 0; x < side / 2; x++) {
            const plt_group_rays *g = &row[apart[x]];
            const m4 missed = u4_eq(u4_load(g->id), u4_all(PLT_MISS));
            if (p->active != 0 && m4_mask(missed) != 15) {
                shade_hits(g, p->axis, missed, &rows, rgb + 6 * x, row_bytes);
            } else {
                put_pair(rgb + 6 * x, rows.above);
                put_pair(rgb + 6 * x + row_bytes, rows.below);
            }
        }
    }
}

static int in_lanes(const plt_packet *p, const plt_frame *frame, const plt_pixels *pixels) {
    return frame->shader == PLT_SHADE_EYELIGHT && (p->active == 0 || p->axis != PLT_AXES_DIFFER) &&
           pixels->x + pixels->side <= pixels->x_end && pixels->y + pixels->side <= pixels->y_end;
}

void plt_packet_shade(const plt_packet *p, const plt_frame *frame, const plt_pixels *pixels,
                      const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes) {
    if (in_lanes(p, frame, pixels)) {
        shade_groups(p, pixels->side, sky, rgb, row_bytes);
    } else {
        plt_shade_pixels(p, p->active == 0, frame, pixels, sky, rgb, row_bytes);
    }
}

#endif
