/* frames_show - frames from the caller: whole ones, or tile by tile
 *
 * Invariant: at most one frame is open, and every frame that was begun is ended
 * by a FRAME_END, or by the end of the session.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/tiles_out.h"

/* A picture is at rest when no newer frame came for so long. */
enum { REST_MS = 100 };

static void start_frame(wire_frames_out *out) {
    out->in_frame = 1;
    out->is_cut = 0;
    out->sent = 0;
    out->crc = 0;
    out->refresh = (uint16_t)(out->refresh + 1 < out->tiles ? out->refresh + 1 : 0);
}

/* 0: no room for the message. */
static int end_frame(wire_frames_out *out, int is_whole) {
    out->is_whole = (uint8_t)is_whole;
    if (!wire_put_end(out, out->number)) {
        return 0;
    }
    out->in_frame = 0;
    out->number = (uint8_t)((out->number + 1) % WIRE_NUMBERS);
    out->unanswered++;
    out->is_waiting = 0;
    return 1;
}

/* Whether some tile of the caller's frame is not on the panel, or not exact. */
static int is_missing(const wire_frames_out *out, int *coarse) {
    int missing = 0;
    *coarse = 0;
    for (unsigned t = 0; t < out->tiles; t++) {
        missing |= out->hash[t] == 0;
        *coarse |= wire_is_coarse(out, t) && wire_slot_of(out, t) == 0;
    }
    return missing;
}

/* Whether the picture is at rest. While frames follow each other, sending exactly
 * what was sent near would cost the next frame its time. */
static int is_resting(const wire_frames_out *out) {
    return out->unanswered == 0 && out->peer->now_ms - out->over_ms >= REST_MS;
}

/* Whether a pass over the frame should begin. */
static int wants_pass(wire_frames_out *out) {
    int coarse;
    out->is_refining = 0;
    if (out->is_fresh) {
        out->is_exact_pass = out->near == 0;
        out->is_fresh = 0;
        wire_rate_begin(out);
        return 1;
    }
    const int missing = is_missing(out, &coarse);
    out->is_refining = !missing;
    out->is_exact_pass = !missing || out->near == 0;
    return missing || (coarse && is_resting(out));
}

/* Tiles of the caller's frame, until the queue is full. */
static void scan(wire_frames_out *out) {
    while (out->scanned < out->tiles && !out->is_cut) {
        const wire_piece p = wire_piece_of(out, out->next);
        wire_convert(out, &p, out->rgb + p.y * (size_t)out->stride + 3 * (size_t)p.x, out->stride);
        if (!wire_offer(out, &p)) {
            return;
        }
        out->next = (uint16_t)(out->next + 1 < out->tiles ? out->next + 1 : 0);
        out->scanned++;
    }
    if (end_frame(out, out->scanned == out->tiles)) {
        if (out->scanned < out->tiles) {
            wire_rate_end(out, out->scanned);
        }
        out->scanned = out->tiles;
    }
}

int wire_frames_out_fill(wire_frames_out *out) {
    if (out->rgb == NULL) {
        return !out->in_frame || out->is_cut; /* tile by tile: when full or ended */
    }
    /* A delta needs the answer to what was sent before, and is worth that wait. */
    const unsigned most = wire_has_reference(out) ? 1 : WIRE_SLOTS;
    if (!out->in_frame && out->unanswered < most) {
        wire_rate_end(out, out->tiles);
        if (wants_pass(out)) {
            out->scanned = 0;
            start_frame(out);
        }
    }
    if (out->in_frame) {
        scan(out);
    }
    return 1;
}

static int is_ready(const wire_frames_out *out) {
    return wire_has_session(out->peer) && out->tiles > 0;
}

int wire_frames_show(wire_frames_out *out, const uint8_t *rgb, uint32_t stride) {
    if (rgb == NULL) {
        out->is_cut = out->in_frame;
        out->is_fresh = 0;
        if (out->in_frame && out->rgb != NULL && !end_frame(out, 0)) {
            wire_frames_forget(out); /* its end never comes: nothing is known of it */
            out->in_frame = 0;
        }
        out->rgb = NULL;
        return WIRE_OK;
    }
    if (!is_ready(out) || !wire_is_up(out->peer)) {
        return WIRE_ERR_DOWN;
    }
    out->is_cut = out->in_frame;
    out->rgb = rgb;
    out->stride = stride;
    out->is_fresh = 1;
    return WIRE_OK;
}

int wire_frame_begin(wire_frames_out *out, unsigned mark) {
    if (!is_ready(out)) {
        return WIRE_ERR_DOWN;
    }
    if (out->in_frame || out->unanswered > 0) {
        return WIRE_BUSY;
    }
    out->rgb = NULL;
    out->is_exact_pass = 1;
    out->mark = (uint8_t)mark;
    start_frame(out);
    return WIRE_OK;
}

int wire_frame_tile(wire_frames_out *out, unsigned x, unsigned y, const uint8_t *rgb,
                    uint32_t stride) {
    if (!is_ready(out) || !out->in_frame) {
        return WIRE_ERR_DOWN;
    }
    if (x >= out->width || y >= out->height || x % 16 != 0 || y % 16 != 0) {
        return WIRE_ERR_SETUP;
    }
    const wire_piece p = wire_piece_of(out, y / 16 * out->columns + x / 16);
    wire_convert(out, &p, rgb, stride);
    out->is_cut = (uint8_t)!wire_offer(out, &p);
    return out->is_cut ? WIRE_BUSY : WIRE_OK;
}

int wire_frame_end(wire_frames_out *out) {
    if (!is_ready(out) || !out->in_frame) {
        return WIRE_ERR_DOWN;
    }
    out->is_cut = (uint8_t)!end_frame(out, 1);
    return out->is_cut ? WIRE_BUSY : WIRE_OK;
}

int wire_frames_out_idle(const wire_frames_out *out) {
    return is_ready(out) && !out->is_fresh && (!out->in_frame || out->is_refining) &&
           out->unanswered < WIRE_SLOTS;
}

int wire_frames_out_done(const wire_frames_out *out) {
    int coarse;
    if (!is_ready(out) || out->is_fresh || out->in_frame || out->unanswered > 0) {
        return 0;
    }
    return !is_missing(out, &coarse) && !coarse;
}
