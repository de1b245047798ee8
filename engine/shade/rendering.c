/* rendering - see rendering.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/rendering.h"

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

void plt_rendering_init(plt_rendering *r, uint8_t *tile, uint32_t packet_side) {
    const plt_rendering idle = {.tile = tile, .side = packet_side, .done = 1};
    *r = idle;
}

int plt_rendering_begin(plt_rendering *r, const plt_frame *frame) {
    r->done = 1;
    if (frame->width == 0 || frame->height == 0 || frame->shader > PLT_SHADE_TRIANGLE) {
        return PLT_ERR_ARGUMENT;
    }
    r->frame = *frame;
    const int status = plt_view_set(&r->view, frame);
    if (status == PLT_OK) {
        r->x = r->y = r->px = r->py = 0;
        r->tracing = r->done = 0;
    }
    return status;
}

static void begin_packet(plt_rendering *r, plt_traversal *t, plt_packet *p) {
    const plt_pixels pixels = {r->side, r->x + r->px, r->y + r->py, r->frame.width,
                               r->frame.height};
    plt_view_packet(&r->view, &t->scene->box, p, &pixels);
    plt_traversal_begin(t, p,
                        least(r->side, r->frame.width - pixels.x) *
                            least(r->side, r->frame.height - pixels.y));
    r->tracing = 1;
}

static void shade_packet(const plt_rendering *r, const plt_packet *p) {
    const uint32_t width = tile_width(r), height = tile_height(r);
    for (uint32_t k = 0; k < r->side * r->side; k++) {
        const uint32_t x = r->px + plt_z_order_x(k), y = r->py + plt_z_order_y(k);
        if (x < width && y < height) {
            plt_surface_colour(&r->frame, &p->rays[k / 4], k % 4, r->y + y,
                               &r->tile[3 * (y * width + x)]);
        }
    }
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
    const int status = plt_traverse(t, p, visits > 0 ? visits : 1);
    if (status < 0) {
        r->done = 1;
    }
    if (status != PLT_OK) {
        return status;
    }
    shade_packet(r, p);
    return next_packet(r) ? PLT_MORE : PLT_TILE;
}

void plt_rendering_tile(const plt_rendering *r, plt_tile *tile) {
    tile->rgb = r->tile;
    tile->x = (uint16_t)r->x;
    tile->y = (uint16_t)r->y;
    tile->width = (uint16_t)tile_width(r);
    tile->height = (uint16_t)tile_height(r);
}
