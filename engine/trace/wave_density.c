/* wave_density - see wave_density.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/wave_density.h"

/* The average: a window adds half, a shorter one the share of its rays, and none more than twice
 * the limit. Above the limit the rays of a window go by the wave, until packets are tried again; of
 * about twice as many as before, if those were dense once more. */
enum { LOG2_WINDOWS = 1, DENSE_MOST = 2, RUN_MOST = 127 };

/* Where the wave visits fewer nodes per ray, wide or not, there is hardly anything. */
enum { LEAST_ALONE = 2 };

/* Visits per ray of packets of 16 x 16 that take as long as the wave. A ray that any hit will do
 * for visits as many nodes in a packet, but fewer alone. Smaller packets share less near the root:
 * their limits are 1.25, 1.75 and 2.75 times as high for 8 to 2 rays per side. */
enum { LIMIT_NEAREST = PLT_WAVE_VISIT_ONE / 10 * 21, LIMIT_ANY = PLT_WAVE_VISIT_ONE / 10 * 11 };

static uint32_t limit_of(uint32_t packet_rays, int any) {
    uint32_t side = 2;
    while (side * side < packet_rays) {
        side *= 2;
    }
    return (any ? LIMIT_ANY : LIMIT_NEAREST) / 16 * (12 + 64 / side);
}

static uint32_t run_after(uint32_t run, int is_dense) {
    const uint32_t longer = 2 * run + 1;
    return run == 0 || !is_dense ? 1 : (longer < RUN_MOST ? longer : RUN_MOST);
}

void plt_wave_density_packets(plt_wave_density *d, const plt_wave_window *window, int any,
                              uint32_t rays, uint64_t visits) {
    const uint32_t limit = limit_of(window->packet_rays, any);
    const uint64_t most = (uint64_t)DENSE_MOST * limit * rays;
    const uint64_t now = visits < most / PLT_WAVE_VISIT_ONE ? visits * PLT_WAVE_VISIT_ONE : most;
    const unsigned shift = LOG2_WINDOWS + (unsigned)__builtin_ctz(window->rays); /* no division */
    d->visits = (uint32_t)(((((uint64_t)1 << shift) - rays) * d->visits + now) >> shift);
    d->run = (uint8_t)(d->visits > limit ? run_after(d->run, now > (uint64_t)limit * rays) : 0);
    d->dense = (uint16_t)(d->run * window->rays);
}

void plt_wave_density_alone(plt_wave_density *d, uint32_t rays, uint64_t visits) {
    if (visits < (uint64_t)LEAST_ALONE * rays) {
        d->dense = 0;
    }
}
