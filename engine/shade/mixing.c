/* mixing - see mixing.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/mixing.h"

#include "engine/shade/whitted_mix.h"

#if PLT_WITH_MIXES

/* Adaptive: of a quarter that is traced again, along a side. */
static uint32_t quarter_of(const plt_rendering *r) {
    return r->sampling.across == 4 && r->sampling.adapts ? r->side / 4 : 0;
}

static uint32_t column_of(const plt_rendering *r) {
    return (r->sampling.part & 1u) * quarter_of(r);
}

static uint32_t row_of(const plt_rendering *r) {
    return (uint32_t)(r->sampling.part >> 1) * quarter_of(r);
}

int plt_mixing_allowed(const plt_rendering *r, const plt_frame *frame, int many) {
    const uint32_t across = plt_samples_across(frame->samples);
    const int adapts = frame->samples == PLT_SAMPLES_ADAPTIVE;
    if (many && (adapts || frame->shader == PLT_SHADE_HEAT)) {
        return 0;
    }
    return across > 0 && (PLT_WITH_SAMPLES || across == 1) && r->side >= (adapts ? 4 : across);
}

static void set_view(plt_rendering *r, uint32_t across) {
    r->sampling.across = (uint8_t)across;
#if PLT_WITH_SAMPLES
    r->view = r->sampling.middle;
    plt_view_refine(&r->view, across);
#endif
}

void plt_mixing_begin(plt_rendering *r, const plt_box *scene) {
    plt_sampling *s = &r->sampling;
    s->frame = &r->frame;
    s->middle = r->view;
    s->adapts = r->frame.samples == PLT_SAMPLES_ADAPTIVE;
    s->part = 0;
    s->mixed = 0;
#if PLT_WITH_DIAGRAMS
    plt_depths_set(&s->depths, scene, r->view.eye);
#else
    (void)scene;
#endif
    set_view(r, plt_samples_across(r->frame.samples));
}

uint8_t *plt_mix_tile(const plt_rendering *r) {
    const uint32_t width = plt_tile_width(&r->frame, &r->at);
    return &r->tile[3 * ((r->at.py + row_of(r)) * width + r->at.px + column_of(r))];
}

const uint8_t *plt_mix_sky(const plt_rendering *r) {
    return &r->sky[3 * (r->at.py + row_of(r))];
}

#if PLT_WITH_DIAGRAMS
void plt_mix_heat(const plt_rendering *r, uint64_t visits) {
    const plt_frame *f = &r->frame;
    const uint32_t tile_width = plt_tile_width(f, &r->at), side = plt_rendering_side(r);
    const uint32_t width = plt_least(side, tile_width - r->at.px);
    const uint32_t height = plt_least(side, plt_tile_height(f, &r->at) - r->at.py);
    uint8_t *row = &r->tile[3 * (r->at.py * tile_width + r->at.px)], rgb[3];
    plt_heat_colour(visits, width * height, rgb);
    for (uint32_t y = 0; y < height; y++, row += 3 * tile_width) {
        for (uint32_t x = 0; x < 3 * width; x++) {
            row[x] = rgb[x % 3];
        }
    }
}
#endif

#if PLT_WITH_SAMPLES

void plt_samples_at(const plt_rendering *r, const plt_frame_place *at, plt_pixels *pixels) {
    const uint32_t across = r->sampling.across;
    const plt_pixels all = {r->side, across * (at->x + at->px + column_of(r)),
                            across * (at->y + at->py + row_of(r)), across * r->frame.width,
                            across * r->frame.height};
    *pixels = all;
}

/* Pixels of a quarter of the square, as plt_sampling.mixed has them. */
static uint64_t pixels_of(uint32_t quarter, uint32_t part) {
    const uint64_t row = (1u << quarter) - 1u;
    uint64_t all = 0;
    for (uint32_t y = 0; y < quarter; y++) {
        all |= row << 8 * y;
    }
    return all << (8 * (part >> 1) * quarter + (part & 1u) * quarter);
}

#if PLT_WITH_WHITTED
/* Pixels with lights: as many as a packet holds. */
static int lights_again(plt_rendering *r) {
    plt_sampling *s = &r->sampling;
    if (s->across == 4) {
        s->mixed &= ~plt_whitted_mix_some(r->whitted, s);
    }
    if (s->mixed == 0) {
        plt_samples_drop(r);
        return 0;
    }
    set_view(r, 4);
    return 1;
}
#endif

int plt_samples_again(plt_rendering *r) {
    plt_sampling *s = &r->sampling;
    if (!s->adapts) {
        return 0;
    }
#if PLT_WITH_WHITTED
    if (r->frame.shader == PLT_SHADE_WHITTED) {
        return lights_again(r);
    }
#endif
    for (uint32_t part = s->across == 2 ? 0 : s->part + 1u; part < 4; part++) {
        if ((s->mixed & pixels_of(r->side / 4, part)) != 0) {
            s->part = (uint8_t)part;
            set_view(r, 4);
            return 1;
        }
    }
    plt_samples_drop(r);
    return 0;
}

void plt_samples_drop(plt_rendering *r) {
    if (r->sampling.adapts) {
        r->sampling.part = 0;
        r->sampling.mixed = 0;
        set_view(r, 2);
    }
}

#endif
#endif
