/* mixing - a frame of several samples per pixel, or of distances or node visits
 *
 * Adaptive: a packet of four samples per pixel is traced, and shaded. Where the four colours of a
 * pixel are not alike, so are the quarters of its square that such pixels lie in, with 16 samples,
 * each a packet like any other: a step of the frame is bounded as before. With lights it is those
 * pixels alone, as many at a time as a packet holds.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_MIXING_H
#define PLT_SHADE_MIXING_H

#include "engine/shade/packet_mix.h"
#include "engine/shade/rendering_state.h"

#if PLT_WITH_MIXES

/* There can be such a frame. `many`: of packets that are under way at a time. */
int plt_mixing_allowed(const plt_rendering *r, const plt_frame *frame, int many);

/* r->frame and r->view are set: the view becomes that of the samples. */
void plt_mixing_begin(plt_rendering *r, const plt_box *scene);

/* Pixels need more than one ray, or what is not a colour of theirs. */
static inline int plt_mixes(const plt_rendering *r) {
    return r->sampling.across > 1 || r->frame.shader == PLT_SHADE_DEPTH;
}

/* Where the current square is in the tile, and its rows of the sky. */
uint8_t *plt_mix_tile(const plt_rendering *r);
const uint8_t *plt_mix_sky(const plt_rendering *r);

/* The square's colour, after so many node visits. */
void plt_mix_heat(const plt_rendering *r, uint64_t visits);

#endif

#if PLT_WITH_SAMPLES
/* The rays of a packet. */
void plt_samples_at(const plt_rendering *r, const plt_frame_place *at, plt_pixels *pixels);

/* Adaptive: 1: what `at` is, or a part of it, is to be traced (again), by a view that is another;
 * 0: it is over, and the view is that of the next. */
int plt_samples_again(plt_rendering *r);

/* Whatever has been begun is dropped. */
void plt_samples_drop(plt_rendering *r);
#endif

#endif
