/* frame_packets - see frame_packets.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/frame_packets.h"

#include <string.h>

#include "engine/shade/mixing.h"
#include "engine/shade/packet_shade.h"
#include "engine/shade/surface.h"

int plt_frame_next(plt_rendering *r, uint32_t pixel[2]) {
    if (r->done || r->all_added) {
        return 0;
    }
    pixel[0] = r->ahead.x + r->ahead.px;
    pixel[1] = r->ahead.y + r->ahead.py;
    r->all_added = (uint8_t)!plt_rendering_ahead(r);
    return 1;
}

void plt_frame_go_on(plt_rendering *r) {
    if (r->all_added) {
        plt_rendering_begin_batches(r, UINT32_MAX);
    }
}

static plt_pixels pixels_at(const plt_rendering *r, const uint32_t pixel[2]) {
    const uint32_t across = plt_rendering_across(r);
    const plt_pixels pixels = {r->side, across * pixel[0], across * pixel[1],
                               across * r->frame.width, across * r->frame.height};
    return pixels;
}

uint32_t plt_frame_packet(const plt_rendering *r, const plt_box *scene, const uint32_t pixel[2],
                          plt_packet *packet) {
    const plt_pixels pixels = pixels_at(r, pixel);
    plt_view_packet(&r->view, scene, packet, &pixels);
    return plt_least(r->side, pixels.x_end - pixels.x) *
           plt_least(r->side, pixels.y_end - pixels.y);
}

void plt_frame_shade(const plt_rendering *r, const uint32_t pixel[2], const plt_packet *packet,
                     uint8_t *rgb) {
    uint8_t sky[3 * PLT_PACKET_SIDE_MAX];
    const plt_frame *f = &r->frame;
    const plt_pixels pixels = pixels_at(r, pixel);
    const uint32_t side = plt_rendering_side(r), width = plt_least(side, f->width - pixel[0]);
    for (uint32_t y = 0; y < plt_least(side, f->height - pixel[1]); y++) {
        plt_surface_sky(f, pixel[1] + y, &sky[3 * y]);
    }
#if PLT_WITH_MIXES
    if (plt_mixes(r)) {
        plt_sampling s = r->sampling;
        plt_packet_mix(packet, &s, &pixels, sky, rgb, 3 * width);
        return;
    }
#endif
    plt_packet_shade(packet, f, &pixels, sky, rgb, 3 * width);
}

int plt_frame_take(plt_rendering *r, const uint8_t *rgb) {
    const uint32_t tile_width = plt_tile_width(&r->frame, &r->at);
    const uint32_t side = plt_rendering_side(r);
    const uint32_t width = plt_least(side, tile_width - r->at.px);
    const uint32_t height = plt_least(side, plt_tile_height(&r->frame, &r->at) - r->at.py);
    uint8_t *to = &r->tile[3 * (r->at.py * tile_width + r->at.px)];
    for (uint32_t y = 0; y < height; y++) {
        memcpy(to + 3 * y * tile_width, rgb + 3 * y * width, 3 * (size_t)width);
    }
    return plt_place_next_packet(&r->at, &r->frame, side) ? PLT_OK : PLT_TILE;
}

int plt_frame_ended(plt_rendering *r) {
    if (!r->done && r->at.py >= plt_tile_height(&r->frame, &r->at)) {
        r->done = (uint8_t)!plt_place_next_tile(&r->at, &r->frame, r->curves);
    }
    return r->done;
}
