/* frames_rate - how far off a moving picture may be, so that enough of them come
 *
 * A pass over a new frame is timed from its first tile to when the next could
 * begin. If it is longer than the goal, the error bound of the next frames grows;
 * if it is well below, the bound shrinks. Once the picture is at rest, what was
 * sent near is sent again exactly (frames_show.c).
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/tiles_out.h"

/* The largest bound chosen, in steps: a tenth of green's 63 and a fifth of the others' 31, or
 * a seventeenth of 255. */
enum { MOST_565 = 6, MOST_8_BITS = 15 };

void wire_frames_near(wire_frames_out *out, unsigned near) {
    out->near = (uint8_t)(near < WIRE_NEAR_MOST ? near : WIRE_NEAR_MOST);
    out->goal_ms = 0;
}

void wire_frames_rate(wire_frames_out *out, unsigned frames_per_second) {
    out->near = 0;
    const unsigned most =
        frames_per_second < 1000 ? frames_per_second : 1000; /* a ms is the clock */
    out->goal_ms = (uint16_t)(most > 0 ? 1000 / most : 0);
}

void wire_rate_begin(wire_frames_out *out) {
    out->is_timed = 1;
    out->begun_ms = out->peer->now_ms;
}

/* A step changes the bytes by about a quarter, from 1 to 0 by more. So the bound
 * stays while the time is between three quarters of the goal and the goal. */
static void adapt(wire_frames_out *out, uint32_t took_ms) {
    const unsigned most = out->format == WIRE_RGB565 ? MOST_565 : MOST_8_BITS;
    unsigned near = out->near;
    if (took_ms > out->goal_ms) {
        near += 1 + near / 4;
        near += took_ms > 2u * out->goal_ms ? 1 + near / 4 : 0;
    } else if (near > 0 && 4 * took_ms < 3u * out->goal_ms) {
        near -= 1 + near / 8;
    }
    out->near = (uint8_t)(near < most ? near : most);
}

/* `looked_at` of `tiles`: less when a newer frame cut this one short. */
void wire_rate_end(wire_frames_out *out, unsigned looked_at) {
    if (!out->is_timed) {
        return;
    }
    out->is_timed = 0;
    out->over_ms = out->peer->now_ms;
    if (out->goal_ms > 0 && looked_at > 0) {
        const uint32_t took = out->over_ms - out->begun_ms;
        adapt(out, (took < 60000 ? took : 60000) * out->tiles / looked_at);
    }
}
