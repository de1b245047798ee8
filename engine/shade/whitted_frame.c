/* whitted_frame - see whitted_frame.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/whitted_frame.h"

#include "engine/base/srgb.h"
#include "engine/shade/surface.h"
#include "engine/whitted/lights.h"
#include "engine/whitted/point.h"
#include "engine/whitted/whitted.h"

#if PLT_WITH_WHITTED

void plt_whitted_frame_set(plt_whitted *w, const plt_frame *frame, const plt_box *box) {
    if (frame->shader == PLT_SHADE_WHITTED) {
        plt_whitted_frame(w, box, frame->camera.eye, frame->camera.up);
#if PLT_WITH_TEXTURE
        w->failed = PLT_OK;
#endif
    }
}

int plt_whitted_frame_wants_weights(const plt_traversal *t) {
    return plt_point_is_smooth(t->scene);
}

void plt_whitted_frame_begin(plt_whitted *w, const plt_view *view, const plt_packet *packet,
                             const plt_pixels *pixels) {
    for (uint32_t k = 0; k < pixels->side * pixels->side; k++) {
        const uint32_t x = pixels->x + plt_z_order_x(k), y = pixels->y + plt_z_order_y(k);
        if (x < pixels->x_end && y < pixels->y_end) {
            float dir[3];
            plt_view_direction(view, x, y, dir);
            plt_whitted_pixel_set(w, k, dir, plt_light_turn(x, y));
        } else {
            plt_whitted_pixel_none(w, k);
        }
    }
    plt_whitted_begin(w, packet, w->pixels);
}

void plt_whitted_frame_colour(const plt_lit_pixel *p, const plt_frame *frame, uint8_t rgb[3]) {
#if PLT_WITH_BACKGROUND
    if (frame->has_background && p->ray.is_sky) {
        plt_surface_sky(frame, 0, rgb);
        return;
    }
#else
    (void)frame;
#endif
    for (int c = 0; c < 3; c++) {
        rgb[c] = plt_srgb_byte(p->colour[c]);
    }
}

void plt_whitted_frame_shade(const plt_whitted *w, const plt_frame *frame, const plt_pixels *pixels,
                             uint8_t *rgb, uint32_t row_bytes) {
    const uint32_t columns = pixels->x_end - pixels->x, rows = pixels->y_end - pixels->y;
    for (uint32_t k = 0; k < pixels->side * pixels->side; k++) {
        const uint32_t x = plt_z_order_x(k), y = plt_z_order_y(k);
        if (x < columns && y < rows) {
            plt_whitted_frame_colour(&w->pixel[k], frame, &rgb[y * row_bytes + 3 * x]);
        }
    }
}

#endif
