/* whitted_mix - frames of PLT_SHADE_WHITTED with several samples per pixel
 *
 * A sample is a pixel of state.h, of a frame whose lines are closer: it has its own rays, its own
 * turn of the lights, and the byte of colour that a pixel would have. The mean is that of light.h.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_WHITTED_MIX_H
#define PLT_SHADE_WHITTED_MIX_H

#include "engine/shade/sampling.h"
#include "engine/whitted/state.h"

#if PLT_WITH_WHITTED && PLT_WITH_SAMPLES
/* As plt_packet_mix. */
void plt_whitted_mix(const plt_whitted *w, plt_sampling *s, const plt_pixels *pixels, uint8_t *rgb,
                     uint32_t row_bytes);

/* Adaptive: of the pixels in s->mixed those that a packet holds 16 samples of, the first ones. So
 * only pixels that need more samples are traced, wherever in the square they are. */
uint64_t plt_whitted_mix_some(const plt_whitted *w, const plt_sampling *s);

/* The packet of their samples is set up and begun; the square's first pixel is (x, y) of the
 * frame, `view` that of the samples. */
void plt_whitted_mix_again(plt_whitted *w, plt_traversal *t, plt_packet *packet,
                           const plt_view *view, const plt_sampling *s, uint32_t x, uint32_t y);

/* Their colours; `rgb`: of the square, whose rows are `row_bytes` apart. */
void plt_whitted_mix_finer(const plt_whitted *w, plt_sampling *s, uint8_t *rgb, uint32_t row_bytes);
#endif

#endif
