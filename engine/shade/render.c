/* render - a frame, tile after tile, a bounded piece at a time
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/camera.h"
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

int plt_render_begin(plt_engine *e, const plt_frame *frame) {
    plt_rendering *r = &e->rendering;
    r->done = 1;
    if (frame->width == 0 || frame->height == 0 || frame->shader > PLT_SHADE_TRIANGLE) {
        return PLT_ERR_ARGUMENT;
    }
    r->frame = *frame;
    const int status = plt_camera_setup(r);
    if (status == PLT_OK) {
        r->x = r->y = r->px = r->py = 0;
        r->tracing = r->done = 0;
    }
    return status;
}

static void begin_packet(plt_engine *e) {
    plt_rendering *r = &e->rendering;
    const uint32_t side = e->options.packet_side;
    const uint32_t x = r->x + r->px, y = r->y + r->py;
    plt_camera_packet(e, x, y, r->frame.width, r->frame.height);
    plt_walk_begin(&e->walker);
    e->walker.stats.rays +=
        (uint64_t)least(side, r->frame.width - x) * least(side, r->frame.height - y);
    r->tracing = 1;
}

static void shade_packet(plt_engine *e) {
    const plt_rendering *r = &e->rendering;
    const uint32_t side = e->options.packet_side;
    const uint32_t width = tile_width(r), height = tile_height(r);
    for (uint32_t k = 0; k < side * side; k++) {
        const uint32_t x = r->px + plt_z_order_x(k), y = r->py + plt_z_order_y(k);
        if (x < width && y < height) {
            plt_surface_colour(e, &e->walker.packet.group[k / 4], k % 4, r->y + y,
                               &e->film[3 * (y * width + x)]);
        }
    }
}

/* To the next packet of the tile; 0 when the tile is complete. */
static int next_packet(plt_engine *e) {
    plt_rendering *r = &e->rendering;
    r->tracing = 0;
    r->px += e->options.packet_side;
    if (r->px >= tile_width(r)) {
        r->px = 0;
        r->py += e->options.packet_side;
    }
    return r->py < tile_height(r);
}

/* The tile was fetched: to the next one, or to the end. */
static void next_tile(plt_rendering *r) {
    r->px = r->py = 0;
    r->x += PLT_TILE_SIDE;
    if (r->x >= r->frame.width) {
        r->x = 0;
        r->y += PLT_TILE_SIDE;
    }
    r->done = r->y >= r->frame.height;
}

int plt_render_step(plt_engine *e, uint32_t visits) {
    plt_rendering *r = &e->rendering;
    if (!r->done && r->py >= tile_height(r)) {
        next_tile(r);
    }
    if (r->done) {
        return PLT_OK;
    }
    if (!r->tracing) {
        begin_packet(e);
    }
    plt_engine_walk(e, visits > 0 ? visits : 1);
    if (e->walker.waiting > 0) {
        return PLT_MORE;
    }
    shade_packet(e);
    return next_packet(e) ? PLT_MORE : PLT_TILE;
}

void plt_render_tile(const plt_engine *e, plt_tile *tile) {
    const plt_rendering *r = &e->rendering;
    tile->rgb = e->film;
    tile->x = (uint16_t)r->x;
    tile->y = (uint16_t)r->y;
    tile->width = (uint16_t)tile_width(r);
    tile->height = (uint16_t)tile_height(r);
}
