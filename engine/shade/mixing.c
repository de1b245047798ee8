/* mixing - see mixing.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/mixing.h"

#include "engine/shade/whitted_mix.h"

#if PLT_WITH_MIXES

int plt_mixing_allowed(const plt_rendering *r, const plt_frame *frame, int many) {
    const uint32_t across = plt_samples_across(frame->samples);
    const int adapts = frame->samples == PLT_SAMPLES_ADAPTIVE;
    if (many && (adapts || frame->shader == PLT_SHADE_HEAT)) {
        return 0;
    }
    return across > 0 && (PLT_WITH_SAMPLES || across == 1) && r->side >= (adapts ? 4 : across);
}

static void set_part(plt_sampling *s, uint32_t x, uint32_t y, uint32_t columns, uint32_t rows) {
    s->x = (uint8_t)x;
    s->y = (uint8_t)y;
    s->columns = (uint8_t)columns;
    s->rows = (uint8_t)rows;
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
    s->mixed = 0;
    set_part(s, 0, 0, 0, 0);
#if PLT_WITH_DIAGRAMS
    plt_depths_set(&s->depths, scene, r->view.eye);
#else
    (void)scene;
#endif
    set_view(r, plt_samples_across(r->frame.samples));
}

uint8_t *plt_mix_tile(const plt_rendering *r) {
    const uint32_t width = plt_tile_width(&r->frame, &r->at);
    return &r->tile[3 * ((r->at.py + r->sampling.y) * width + r->at.px + r->sampling.x)];
}

const uint8_t *plt_mix_sky(const plt_rendering *r) {
    return &r->sky[3 * (r->at.py + r->sampling.y)];
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
    const plt_sampling *s = &r->sampling;
    const uint32_t across = s->across, x = at->x + at->px + s->x, y = at->y + at->py + s->y;
    const plt_pixels all = {r->side, across * x, across * y,
                            across * (s->columns > 0 ? x + s->columns : r->frame.width),
                            across * (s->columns > 0 ? y + s->rows : r->frame.height)};
    *pixels = all;
}

static uint64_t pixels_of(const plt_sampling *s) {
    const uint64_t row = (1u << s->columns) - 1u;
    uint64_t all = 0;
    for (uint32_t y = s->y; y < (uint32_t)s->y + s->rows; y++) {
        all |= row << (8 * y + s->x);
    }
    return all;
}

/* The columns of so many rows from `y` on that some pixel is mixed in, a bit each. */
static uint32_t columns_of(uint64_t mixed, uint32_t y, uint32_t rows) {
    uint32_t columns = 0;
    for (uint32_t i = y; i < y + rows; i++) {
        columns |= (uint32_t)(mixed >> 8 * i) & 0xFFu;
    }
    return columns;
}

static uint32_t lowest(uint32_t bits) {
    uint32_t n = 0;
    while ((bits >> n & 1u) == 0) {
        n++;
    }
    return n;
}

/* The first rows, and of these the first columns, in which there are mixed pixels, side by side at
 * most, and no wider than they must be: so squares of 2 side by 2 side have at most four such
 * parts.
 */
static void next_part(plt_sampling *s, uint32_t side) {
    uint32_t y = 0, rows = side;
    while (columns_of(s->mixed, y, 1) == 0) {
        y++;
    }
    rows = y + rows > 8 ? 8 - y : rows;
    const uint32_t x = lowest(columns_of(s->mixed, y, rows));
    const uint32_t few = (1u << side) - 1u;
    while ((columns_of(s->mixed, y + rows - 1, 1) >> x & few) == 0) {
        rows--;
    }
    uint32_t columns = side;
    while ((columns_of(s->mixed, y, rows) >> x & 1u << (columns - 1)) == 0) {
        columns--;
    }
    set_part(s, x, y, columns, rows);
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
    s->mixed &= ~pixels_of(s);
    if (s->mixed != 0) {
        next_part(s, r->side / 4);
        set_view(r, 4);
        return 1;
    }
    plt_samples_drop(r);
    return 0;
}

void plt_samples_drop(plt_rendering *r) {
    if (r->sampling.adapts) {
        r->sampling.mixed = 0;
        set_part(&r->sampling, 0, 0, 0, 0);
        set_view(r, 2);
    }
}

#endif
#endif
