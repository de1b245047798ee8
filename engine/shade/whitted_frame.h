/* whitted_frame - frames of PLT_SHADE_WHITTED: the camera's pixels, and their bytes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_WHITTED_FRAME_H
#define PLT_SHADE_WHITTED_FRAME_H

#include "engine/shade/camera.h"
#include "engine/whitted/state.h"

#if PLT_WITH_WHITTED
/* The frame is of that kind, and there is room for it. */
static inline int plt_whitted_frame_valid(const plt_whitted *w, const plt_frame *frame) {
    return frame->shader == PLT_SHADE_WHITTED && w != NULL;
}

/* As plt_whitted_frame, if the frame is of that kind. */
void plt_whitted_frame_set(plt_whitted *w, const plt_frame *frame, const plt_box *box);

/* Before a packet: of samples each has its own level of a texture, as its own pixel would. */
static inline void plt_whitted_frame_view(plt_whitted *w, const plt_frame *frame,
                                          const plt_view *view) {
#if PLT_WITH_TEXTURE
    w->angle = plt_view_pixel_angle(view, frame);
#else
    (void)w;
    (void)frame;
    (void)view;
#endif
}

/* Hits are to have u and v, in place of normals. */
int plt_whitted_frame_wants_weights(const plt_traversal *t);

/* The packet of these pixels is set up and begun. */
void plt_whitted_frame_begin(plt_whitted *w, const plt_view *view, const plt_packet *packet,
                             const plt_pixels *pixels);

/* What a pixel's rays brought, or the background where the frame has one and its own ray hit
 * nothing. */
void plt_whitted_frame_colour(const plt_lit_pixel *pixel, const plt_frame *frame, uint8_t rgb[3]);

/* As plt_shade_pixels. */
void plt_whitted_frame_shade(const plt_whitted *w, const plt_frame *frame, const plt_pixels *pixels,
                             uint8_t *rgb, uint32_t row_bytes);
#endif

#endif
