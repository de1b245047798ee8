/* room_random - what a room's seed decides
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/noise.h"
#include "host_tools/scenes/room.h"

#define FIRST 1000u /* beyond the seeds of other scenes' noise */

double room_random(const room *r, uint32_t what, uint32_t which) {
    return noise_unit(which, what, r->seed + FIRST);
}
