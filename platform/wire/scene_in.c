/* scene_in - receives a scene image, in order, and says from which byte it needs it
 *
 * Invariant: the first `has` bytes of the image are in `to`, and `sum` is
 * their checksum. State OPEN: the bytes are not touched until another image
 * is offered.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_crc32.h"
#include "platform/wire/services.h"

enum { AGAIN_MS = 30 }; /* between reports of the same gap */

void wire_scene_in_open(wire_scene_in *in, wire_peer *peer, void *to, uint32_t room) {
    memset(in, 0, sizeof *in);
    in->peer = peer;
    in->to = to;
    in->room = room;
    peer->scene_in = in;
}

void wire_scene_in_blocks(wire_scene_in *in) {
    in->takes_blocks = 1;
}

unsigned wire_scene_in_state(const wire_scene_in *in, uint32_t *bytes) {
    *bytes = in->bytes;
    return in->state;
}

static void report_state(wire_scene_in *in) {
    in->said_ms = in->peer->now_ms;
    wire_queue_control(in->peer, WIRE_SCENE_STATE);
}

void wire_scene_in_verdict(wire_scene_in *in, unsigned state) {
    in->state = (uint8_t)state;
    report_state(in);
}

static void start_over(wire_scene_in *in) {
    in->has = 0;
    in->sum = 0;
    in->is_missed = 1;
}

static unsigned state_for(const wire_scene_in *in, uint32_t bytes) {
    if (bytes > 0 && bytes <= in->room) {
        return WIRE_SCENE_GOING;
    }
    const int has_blocks = in->takes_blocks && in->peer->other.features & WIRE_SCENES;
    return bytes > 0 && has_blocks ? WIRE_SCENE_BLOCKS : WIRE_SCENE_LARGE;
}

/* While the memory is in use, another image waits: it is offered again. */
void wire_scene_in_receive(wire_scene_in *in, const uint8_t *body) {
    const uint32_t bytes = wire_get32(body), crc = wire_get32(body + 4);
    const int is_other = in->state == WIRE_SCENE_NONE || bytes != in->bytes || crc != in->crc;
    in->is_replaced = (uint8_t)(is_other && in->is_held);
    if (in->is_replaced) {
        return;
    }
    if (is_other) {
        in->bytes = bytes;
        in->crc = crc;
        in->state = (uint8_t)state_for(in, bytes);
        start_over(in);
    }
    report_state(in);
}

uint32_t wire_scene_in_write(wire_scene_in *in, uint8_t *body) {
    body[0] = in->state;
    body[1] = in->is_missed;
    wire_put32(body + 2, in->has);
    wire_put32(body + 6, in->crc);
    in->is_missed = 0;
    return 10;
}

/* Without progress it reports again, as the last report may have been lost. */
void wire_scene_in_poll(wire_scene_in *in) {
    const uint32_t pause = in->is_deaf ? AGAIN_MS : WIRE_IDLE_MS;
    if (in->state == WIRE_SCENE_GOING && in->peer->now_ms - in->said_ms >= pause) {
        in->is_missed |= in->is_deaf;
        report_state(in);
    }
}

void wire_scene_in_head(wire_scene_in *in, uint32_t offset) {
    in->at = offset;
    const int is_reported = in->is_deaf && in->peer->now_ms - in->said_ms < AGAIN_MS;
    if (in->state == WIRE_SCENE_GOING && offset > in->has && !is_reported) {
        in->is_deaf = 1;
        in->is_missed = 1;
        report_state(in);
    }
}

static void complete(wire_scene_in *in) {
    if (in->sum == in->crc) {
        in->state = WIRE_SCENE_HERE;
    } else {
        start_over(in);
    }
    report_state(in);
}

/* Bytes that are there already are skipped. */
void wire_scene_in_bytes(wire_scene_in *in, const uint8_t *bytes, uint32_t count) {
    const uint32_t from = in->at;
    in->at += count;
    if (in->state != WIRE_SCENE_GOING || from > in->has || in->at <= in->has) {
        return;
    }
    const uint32_t skip = in->has - from;
    const uint32_t left = in->bytes - in->has;
    const uint32_t n = count - skip < left ? count - skip : left;
    memcpy(in->to + in->has, bytes + skip, n);
    in->sum = plt_crc32(in->sum, bytes + skip, n);
    in->has += n;
    in->is_deaf = 0;
    in->said_ms = in->peer->now_ms;
    if (in->has == in->bytes) {
        complete(in);
    }
}
