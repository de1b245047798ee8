/* wave_density - whether rays that look coherent are better traced in packets or by the wave
 *
 * Where boxes are as small as the gaps between rays they are visited for a ray or two at a time,
 * and packets are a burden. Nodes that are visited per ray tell it (DESIGN.md, section 6.2).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_DENSITY_H
#define PLT_TRACE_WAVE_DENSITY_H

#include <stdint.h>

enum { PLT_WAVE_VISIT_ONE = 65536 }; /* one visit: so fine that single rays count */

/* How dense boxes are for packets of rays of a kind; all 0 in the beginning. */
typedef struct plt_wave_density {
    uint32_t visits; /* per ray of packets, a moving average, in PLT_WAVE_VISIT_ONE */
    uint16_t dense;  /* rays that go by the wave, whether they are coherent or not */
    uint8_t run;     /* windows of them, from one try of packets to the next */
    uint8_t pad;
} plt_wave_density;

/* Rays that are looked at together, a power of two, 256 at most, and those of a packet, at most. */
typedef struct plt_wave_window {
    uint32_t rays, packet_rays;
} plt_wave_window;

/* After `rays` of a window, or all of it, that went in packets, which visited so many nodes; `any`
 * hit was enough. */
void plt_wave_density_packets(plt_wave_density *d, const plt_wave_window *window, int any,
                              uint32_t rays, uint64_t visits);

/* After rays that went by the wave because packets were dense: if hardly anything is there any
 * more, packets are tried again. */
void plt_wave_density_alone(plt_wave_density *d, uint32_t rays, uint64_t visits);

/* Whether the next `rays` go by the wave, as packets were dense: counts down. */
static inline int plt_wave_density_is_high(plt_wave_density *d, uint32_t rays) {
    const int is_high = d->dense > 0;
    d->dense = (uint16_t)(rays < d->dense ? d->dense - rays : 0);
    return is_high;
}

#endif
