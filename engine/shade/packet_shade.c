/* packet_shade - see packet_shade.h
 *
 * Where four lanes are one register, squares that lie in the frame are shaded group by group:
 * four pixels, two by two.
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
    static const float ones[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    const float *row[3] = {ones, ones, ones};
    row[plt_axis_after[z]] = g->slope[0];
    row[plt_axis_after[plt_axis_after[z]]] = g->slope[1];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        to[a] = f4_load(row[a]);
    }
}

/* Two pixels, 6 bytes; the fourth byte of a word means nothing. */
static inline void put_pair(uint8_t rgb[6], uint64_t left, uint64_t right) {
    const uint64_t both = (left & 0xFFFFFFu) | right << 24;
    plt_put_u32(rgb, (uint32_t)both);
    rgb[4] = (uint8_t)(both >> 32);
    rgb[5] = (uint8_t)(both >> 40);
}

/* The words of both rows where nothing is hit, each twice. */
static inline u4 sky_of(const uint8_t sky[6]) {
    const uint32_t above = sky[0] | (uint32_t)sky[1] << 8 | (uint32_t)sky[2] << 16;
    const uint32_t below = sky[3] | (uint32_t)sky[4] << 8 | (uint32_t)sky[5] << 16;
    const uint32_t both[4] = {above, above, below, below};
    return u4_load(both);
}

static inline void shade_group(const plt_group_rays *g, int z, u4 sky, uint8_t *rgb,
                               uint32_t row_bytes) {
    const m4 missed = u4_eq(u4_load(g->id), u4_all(PLT_MISS));
    u4 colour = sky;
    uint32_t word[4];
    if (m4_mask(missed) != 15) {
        const f4 normal[3] = {f4_load(g->normal[0]), f4_load(g->normal[1]), f4_load(g->normal[2])};
        f4 dir[3];
        get_directions(g, z, dir);
        colour = u4_select(missed, sky, plt_surface_clay(normal, dir));
    }
    u4_store(word, colour);
    put_pair(rgb, word[0], word[1]);
    put_pair(rgb + row_bytes, word[2], word[3]);
}

static void shade_groups(const plt_packet *p, uint32_t side, const uint8_t *sky, uint8_t *rgb,
                         uint32_t row_bytes) {
    static const uint8_t apart[8] = {0, 1, 4, 5, 16, 17, 20, 21}; /* every other bit of Z order */
    for (uint32_t y = 0; y < side / 2; y++) {
        const u4 above = sky_of(&sky[6 * y]);
        for (uint32_t x = 0; x < side / 2; x++) {
            const uint32_t index = apart[x] + 2u * apart[y];
            shade_group(&p->rays[index], p->axis, above, &rgb[2 * y * row_bytes + 6 * x],
                        row_bytes);
        }
    }
}

static int in_lanes(const plt_packet *p, const plt_frame *frame, const plt_pixels *pixels) {
    return frame->shader == PLT_SHADE_EYELIGHT && p->axis != PLT_AXES_DIFFER &&
           pixels->x + pixels->side <= pixels->x_end && pixels->y + pixels->side <= pixels->y_end;
}

void plt_packet_shade(const plt_packet *p, const plt_frame *frame, const plt_pixels *pixels,
                      const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes) {
    if (in_lanes(p, frame, pixels)) {
        shade_groups(p, pixels->side, sky, rgb, row_bytes);
    } else {
        plt_shade_pixels(p, frame, pixels, sky, rgb, row_bytes);
    }
}

#endif
