/* frames_out - which tiles go out, and what is known of the other peer's panel
 *
 * Of each tile the sender keeps the hash of the pixels it last sent (0: nothing is
 * known), whether it sent them with an error, and which frame carried it until
 * that frame is answered. The hash is of the pixels without the error.
 *
 * A hash that is equal by chance, 2^-32 for each tile that changes, leaves the
 * tile stale until the refresh, one tile per frame, reaches it.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/tiles_out.h"

_Static_assert(WIRE_TILES_MAX % 32 == 0 && WIRE_TILES_MAX <= 1024, "ten bits on the wire");
_Static_assert(sizeof(wire_frames_out) <= 4096, "the sender's state");

enum { ANSWER_MS = 60 };

void wire_frames_out_open(wire_frames_out *out, wire_peer *peer) {
    memset(out, 0, sizeof *out);
    out->peer = peer;
    peer->frames_out = out;
    peer->queue = &out->queue;
    if (wire_is_up(peer)) {
        wire_frames_out_begin(out);
    }
}

void wire_frames_reference(wire_frames_out *out, uint8_t *reference, uint32_t bytes) {
    out->reference = reference;
    out->reference_bytes = bytes;
    wire_frames_forget(out);
}

void wire_frames_forget(wire_frames_out *out) {
    memset(out->hash, 0, sizeof out->hash);
    memset(out->slot, 0, sizeof out->slot);
    memset(out->coarse, 0, sizeof out->coarse);
}

void wire_frames_out_begin(wire_frames_out *out) {
    const wire_caps *other = &out->peer->other;
    const uint32_t columns = (other->width + 15u) / 16, rows = (other->height + 15u) / 16;
    const uint32_t tiles = other->features & WIRE_SHOWS ? columns * rows : 0;
    if (tiles > WIRE_TILES_MAX) {
        wire_error_send(out->peer, WIRE_E_PANEL, WIRE_TILES_MAX);
    }
    const int is_same = out->width == other->width && out->height == other->height;
    out->rgb = is_same ? out->rgb : NULL; /* it may be too small now */
    out->width = other->width;
    out->height = other->height;
    out->format = other->format;
    out->columns = (uint16_t)columns;
    out->tiles = (uint16_t)(tiles <= WIRE_TILES_MAX ? tiles : 0);
    out->next = out->sent = out->refresh = 0;
    out->scanned = out->rgb != NULL ? 0 : out->tiles;
    out->number = out->unanswered = 0;
    out->in_frame = out->is_cut = out->is_exact_pass = out->is_waiting = 0;
    out->is_timed = out->is_refining = 0;
    out->is_fresh = out->rgb != NULL;
    wire_frames_forget(out);
}

/* ---- answers ---- */

/* Tiles from .. to - 1 of the frame with this slot: on the panel when their
 * bit is set in `got`, else to be sent again. */
static void mark_answered(wire_frames_out *out, unsigned slot, unsigned from, unsigned to,
                          const uint8_t *got) {
    for (unsigned t = from; t < to && t < out->tiles; t++) {
        if (wire_slot_of(out, t) == slot) {
            const int is_there = got != NULL && got[(t - from) / 8] >> (t & 7) & 1;
            wire_set_slot(out, t, 0);
            out->hash[t] = is_there ? out->hash[t] : 0;
        }
    }
}

static void mark_good(wire_frames_out *out, unsigned slot) {
    for (unsigned t = 0; t < out->tiles; t++) {
        if (wire_slot_of(out, t) == slot) {
            wire_set_slot(out, t, 0);
        }
    }
}

static void drop_oldest(wire_frames_out *out) {
    mark_answered(out, wire_slot_back(out, out->unanswered), 0, out->tiles, NULL);
    out->unanswered--;
    out->peer->stats.frames_bad++;
}

/* Frame `number` came whole, and so did the `more` before it. */
static void receive_good(wire_frames_out *out, unsigned number, unsigned more) {
    unsigned back =
        (out->number + WIRE_NUMBERS - number) % WIRE_NUMBERS + (more < WIRE_SLOTS ? more : 0);
    back = back < out->unanswered ? back : out->unanswered;
    while (out->unanswered > back) {
        drop_oldest(out);
    }
    const unsigned after = (out->number + WIRE_NUMBERS - number) % WIRE_NUMBERS - 1;
    while (out->unanswered > after) {
        mark_good(out, wire_slot_back(out, out->unanswered));
        out->unanswered--;
        out->peer->stats.frames_out++;
    }
}

/* Which tiles of 256 came; the last part completes the answer. */
static void receive_bad(wire_frames_out *out, const uint8_t *body) {
    const unsigned from = 256u * (body[1] & 3u);
    while (out->unanswered > (out->number + WIRE_NUMBERS - body[0]) % WIRE_NUMBERS) {
        drop_oldest(out);
    }
    mark_answered(out, wire_slot_back(out, out->unanswered), from, from + 256, body + 2);
    if (from + 256 >= out->tiles) {
        drop_oldest(out);
    }
}

void wire_frames_out_receive(wire_frames_out *out, unsigned type, const uint8_t *body) {
    const unsigned back = (out->number + WIRE_NUMBERS - body[0]) % WIRE_NUMBERS;

    if (body[0] >= WIRE_NUMBERS || back < 1 || back > out->unanswered) {
        return; /* not of ours */
    }
    if (type == WIRE_FRAME_GOOD) {
        receive_good(out, body[0], body[1]);
    } else {
        receive_bad(out, body);
    }
    out->is_waiting = 0;
}

void wire_frames_out_left(wire_frames_out *out, uint32_t number) {
    out->end_number = number;
}

int wire_put_end(wire_frames_out *out, unsigned number) {
    if (wire_queue_room(&out->queue) < WIRE_FRAME_END_BYTES) {
        return 0;
    }
    uint8_t *to = out->queue.bytes + out->queue.used;
    to += wire_head_put(to, WIRE_FRAME_END, WIRE_FRAME_END_BODY);
    to[0] = (uint8_t)number;
    to[1] = out->is_whole;
    wire_put16(to + 2, out->sent);
    wire_put32(to + 4, out->crc);
    to[8] = out->mark;
    out->queue.used = (uint16_t)(out->queue.used + WIRE_FRAME_END_BYTES);
    return 1;
}

/* No answer although its report was acknowledged: the frame's end was lost, or the
 * answer. Numbers may go round only after an answer. */
void wire_frames_out_poll(wire_frames_out *out) {
    const wire_peer *peer = out->peer;
    if (out->unanswered == 0 || out->in_frame ||
        (int32_t)(peer->out_acked - out->end_number) <= 0 || wire_queue_bytes(&out->queue) > 0) {
        out->is_waiting = 0;
    } else if (!out->is_waiting) {
        out->is_waiting = 1;
        out->waiting_ms = peer->now_ms;
    } else if (peer->now_ms - out->waiting_ms >= ANSWER_MS) {
        out->is_waiting = 0;
        wire_put_end(out, (out->number + WIRE_NUMBERS - 1u) % WIRE_NUMBERS);
    }
}
