/* whitted_frame - frames of PLT_SHADE_WHITTED: the camera's pixels, and their bytes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_WHITTED_FRAME_H
#define PLT_SHADE_WHITTED_FRAME_H

#include "engine/shade/rendering.h"

#if PLT_WITH_WHITTED
/* The frame is of that kind, and there is room for it. */
static inline int plt_whitted_frame_valid(const plt_rendering *r, const plt_frame *frame) {
    return frame->shader == PLT_SHADE_WHITTED && r->whitted != NULL;
}

/* Frame and view are set. */
void plt_whitted_frame_set(plt_rendering *r, const plt_box *box);

/* Hits are to have u and v, in place of normals. */
int plt_whitted_frame_wants_weights(const plt_traversal *t);

/* The packet of these pixels is set up and begun. */
void plt_whitted_frame_begin(plt_rendering *r, const plt_packet *packet, const plt_pixels *pixels);

/* As plt_traverse; PLT_OK: the pixels have their colours. */
int plt_whitted_frame_step(plt_rendering *r, plt_traversal *t, plt_packet *packet, uint32_t visits);

/* As plt_shade_pixels. */
void plt_whitted_frame_shade(const plt_rendering *r, const plt_pixels *pixels, uint8_t *rgb,
                             uint32_t row_bytes);
#else
static inline int plt_whitted_frame_valid(const plt_rendering *r, const plt_frame *frame) {
    (void)r;
    (void)frame;
    return 0;
}

static inline void plt_whitted_frame_set(const plt_rendering *r, const plt_box *box) {
    (void)r;
    (void)box;
}

static inline int plt_whitted_frame_wants_weights(const plt_traversal *t) {
    (void)t;
    return 0;
}

static inline void plt_whitted_frame_begin(const plt_rendering *r, const plt_packet *packet,
                                           const plt_pixels *pixels) {
    (void)r;
    (void)packet;
    (void)pixels;
}

static inline int plt_whitted_frame_step(const plt_rendering *r, const plt_traversal *t,
                                         const plt_packet *packet, uint32_t visits) {
    (void)r;
    (void)t;
    (void)packet;
    return (int)visits;
}

static inline void plt_whitted_frame_shade(const plt_rendering *r, const plt_pixels *pixels,
                                           const uint8_t *rgb, uint32_t row_bytes) {
    (void)r;
    (void)pixels;
    (void)rgb;
    (void)row_bytes;
}
#endif

#endif
