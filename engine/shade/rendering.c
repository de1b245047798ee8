/* rendering - see rendering.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/rendering.h"

#include <string.h>

#include "engine/shade/surface.h"

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

static uint32_t tile_width(const plt_rendering *r) {
    return least(PLT_TILE_SIDE, r->frame.width - r->x);
}

static uint32_t tile_height(const plt_rendering *r) {
    return least(PLT_TILE_SIDE, r->frame.height - r->y);
}

/* A constant where there is no choice, and the compiler leaves the other way out. */
#define HAS_BEAMS(r) (PLT_WITH_BEAMS && (!PLT_WITH_GROUPS || (r)->beams))

#if PLT_WITH_STREAMED
#define HAS_CURVES(r) ((r)->curves)
#else
#define HAS_CURVES(r) 0
#endif

void plt_rendering_init(plt_rendering *r, uint8_t *tile, void *beam, uint32_t packet_side) {
    const plt_rendering idle = {.beam = beam, .tile = tile, .side = packet_side, .done = 1};
    *r = idle;
}

/* Beams keep to the depth-first order. They take the fewest instructions, but depend on one
 * another: where four lanes are one register, groups are faster on large meshes (DESIGN.md,
 * section 6). */
static int has_beams(const plt_rendering *r, const plt_traversal *t) {
    return !PLT_LANES_REGISTERS && t->order == PLT_ORDER_DEPTH_FIRST &&
           !plt_is_streamed(t->scene->format) &&
           (t->scene->format != PLT_FORMAT_COMPACT || r->side >= PLT_BEAM_BLOCKS_LEAST);
}

/* Both orders begin with the first tile of the first row. */
static void set_order(plt_rendering *r, int curves) {
#if PLT_WITH_STREAMED
    const plt_tile_order order = {.columns = (r->frame.width + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE,
                                  .rows = (r->frame.height + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE};
    r->order = order;
    r->curves = (uint8_t)curves;
#else
    (void)r;
    (void)curves;
#endif
}

int plt_rendering_begin(plt_rendering *r, const plt_frame *frame, const plt_traversal *t) {
    r->done = 1;
    if (frame->width == 0 || frame->height == 0 || frame->shader > PLT_SHADE_TRIANGLE) {
        return PLT_ERR_ARGUMENT;
    }
    r->frame = *frame;
    const int status = plt_view_set(&r->view, frame);
    if (status == PLT_OK) {
        r->beams = (uint8_t)has_beams(r, t);
        if (HAS_BEAMS(r)) {
            plt_beam_init(r->beam, &r->view, frame, t->scene, r->side);
        }
        set_order(r, plt_is_streamed(t->scene->format));
        r->x = r->y = r->px = r->py = 0;
        r->tracing = r->done = 0;
    }
    return status;
}

/* Of the rows of a tile; rows of tiles that go from left to right share it. */
static void set_sky(plt_rendering *r) {
    for (uint32_t y = 0; y < tile_height(r); y++) {
        plt_surface_sky(&r->frame, r->y + y, &r->sky[3 * y]);
    }
}

static void begin_packet(plt_rendering *r, plt_traversal *t, plt_packet *p) {
    const plt_pixels pixels = {r->side, r->x + r->px, r->y + r->py, r->frame.width,
                               r->frame.height};
    const uint32_t rays =
        least(r->side, r->frame.width - pixels.x) * least(r->side, r->frame.height - pixels.y);
    r->tracing = 1;
    if ((HAS_CURVES(r) ? r->px == 0 : pixels.x == 0) && r->py == 0) {
        set_sky(r);
    }
    if (HAS_BEAMS(r)) {
        plt_beam_begin(r->beam, &pixels, t, rays);
        return;
    }
#if PLT_WITH_GROUPS
    plt_view_packet(&r->view, &t->scene->box, p, &pixels);
    plt_traversal_begin(t, p, rays);
#else
    (void)p;
#endif
}

static void shade_lane(const plt_frame *frame, const plt_group_rays *g, unsigned lane,
                       const uint8_t sky[3], uint8_t rgb[3]) {
    if (!(g->valid >> lane & 1u) || g->id[lane] == PLT_MISS) {
        memcpy(rgb, sky, 3);
        return;
    }
    const float normal[3] = {g->normal[0][lane], g->normal[1][lane], g->normal[2][lane]};
    const float dir[3] = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]};
    plt_surface surface;
    plt_surface_set(&surface, normal);
    plt_surface_colour(&surface, frame->shader, g->id[lane], dir, rgb);
}

static void shade_packet(const plt_rendering *r, const plt_packet *p) {
    const uint32_t width = tile_width(r), height = tile_height(r);
    for (uint32_t k = 0; k < r->side * r->side; k++) {
        const uint32_t x = r->px + plt_z_order_x(k), y = r->py + plt_z_order_y(k);
        if (x < width && y < height) {
            shade_lane(&r->frame, &p->rays[k / 4], k % 4, &r->sky[3 * y],
                       &r->tile[3 * (y * width + x)]);
        }
    }
}

static void shade_square(const plt_rendering *r) {
#if PLT_WITH_BEAMS
    const uint32_t width = tile_width(r);
    plt_beam_shade(r->beam, &r->frame, &r->sky[3 * r->py], &r->tile[3 * (r->py * width + r->px)],
                   3 * width);
#else
    (void)r;
#endif
}

/* To the next packet of the tile; 0 when the tile is complete. */
static int next_packet(plt_rendering *r) {
    r->tracing = 0;
    r->px += r->side;
    if (r->px >= tile_width(r)) {
        r->px = 0;
        r->py += r->side;
    }
    return r->py < tile_height(r);
}

static void follow_curve(plt_rendering *r) {
#if PLT_WITH_STREAMED
    uint32_t column = 0, row = 0;
    r->done = (uint8_t)!plt_tile_order_next(&r->order, &column, &row);
    r->x = PLT_TILE_SIDE * column;
    r->y = PLT_TILE_SIDE * row;
#else
    (void)r;
#endif
}

/* The tile was fetched: to the next one, or to the end. */
static void next_tile(plt_rendering *r) {
    r->px = r->py = 0;
    if (HAS_CURVES(r)) {
        follow_curve(r);
        return;
    }
    r->x += PLT_TILE_SIDE;
    if (r->x >= r->frame.width) {
        r->x = 0;
        r->y += PLT_TILE_SIDE;
    }
    r->done = r->y >= r->frame.height;
}

int plt_rendering_step(plt_rendering *r, plt_traversal *t, plt_packet *p, uint32_t visits) {
    if (!r->done && r->py >= tile_height(r)) {
        next_tile(r);
    }
    if (r->done) {
        return PLT_OK;
    }
    if (!r->tracing) {
        begin_packet(r, t, p);
    }
    visits = visits > 0 ? visits : 1;
    const int status =
        HAS_BEAMS(r) ? plt_beam_trace(r->beam, t, visits) : plt_traverse(t, p, visits);
    if (status < 0) {
        r->done = 1;
    }
    if (status != PLT_OK) {
        return status;
    }
    if (HAS_BEAMS(r)) {
        shade_square(r);
    } else {
        shade_packet(r, p);
    }
    return next_packet(r) ? PLT_MORE : PLT_TILE;
}

void plt_rendering_tile(const plt_rendering *r, plt_tile *tile) {
    tile->rgb = r->tile;
    tile->x = (uint16_t)r->x;
    tile->y = (uint16_t)r->y;
    tile->width = (uint16_t)tile_width(r);
    tile->height = (uint16_t)tile_height(r);
}
