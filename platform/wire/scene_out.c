/* scene_out - sends a scene image: offers it, sends from where it is wanted
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_crc32.h"
#include "platform/wire/report.h"
#include "platform/wire/services.h"

/* Bytes per message; after a gap, for CAREFUL messages, what fills one report:
 * each report that arrives is then of use. */
enum { CHUNK_BYTES = 240, CAREFUL = 16 };

void wire_scene_out_open(wire_scene_out *out, wire_peer *peer, const void *image, uint32_t bytes) {
    memset(out, 0, sizeof *out);
    out->peer = peer;
    out->image = image;
    out->bytes = bytes;
    out->crc = plt_crc32(0, image, image != NULL ? bytes : 0);
    if (peer->queue == NULL) {
        peer->queue = &out->own_queue;
    }
    peer->scene_out = out;
    if (wire_is_up(peer)) {
        wire_scene_out_begin(out);
    }
}

void wire_scene_out_begin(wire_scene_out *out) {
    out->state = WIRE_SCENE_NONE;
    out->is_known = 0;
    out->asked_ms = out->peer->now_ms;
    if (out->image != NULL && out->peer->other.features & WIRE_RENDERS) {
        wire_queue_control(out->peer, WIRE_SCENE_OFFER);
    }
}

unsigned wire_scene_out_state(const wire_scene_out *out, uint32_t *has) {
    *has = out->other_has;
    return out->state;
}

/* An offer asks for the state; repeated until the other peer has decided. */
void wire_scene_out_poll(wire_scene_out *out) {
    const uint32_t now = out->peer->now_ms;
    const int is_decided = out->state >= WIRE_SCENE_LARGE;
    if (out->image != NULL && !is_decided && out->peer->other.features & WIRE_RENDERS &&
        now - out->asked_ms >= WIRE_IDLE_MS) {
        out->asked_ms = now;
        wire_queue_control(out->peer, WIRE_SCENE_OFFER);
    }
}

uint32_t wire_scene_out_write(wire_scene_out *out, uint8_t *body) {
    wire_put32(body, out->bytes);
    wire_put32(body + 4, out->crc);
    return 8;
}

/* State, whether something was missed, bytes there, checksum of the image. */
void wire_scene_out_receive(wire_scene_out *out, const uint8_t *body) {
    const uint32_t has = wire_get32(body + 2);
    if (wire_get32(body + 6) != out->crc || has > out->bytes) {
        return; /* of another image */
    }
    out->state = body[0];
    out->other_has = has;
    /* With nothing on the way, what it has is all that came. */
    if (!out->is_known || body[1] || wire_unacked(out->peer) == 0) {
        out->careful = body[1] ? CAREFUL : out->careful;
        out->at = has;
    }
    out->is_known = 1;
}

static uint32_t chunk_bytes(wire_scene_out *out) {
    const uint32_t left = out->bytes - out->at, size = out->peer->own.out_bytes;
    const uint32_t payload = size - wire_header_bytes(size);
    uint32_t most = CHUNK_BYTES;
    if (out->careful > 0) {
        out->careful--;
        most = payload < 16 ? 10 : payload - 6 < CHUNK_BYTES ? payload - 6 : CHUNK_BYTES;
    }
    return left < most ? left : most;
}

int wire_scene_out_fill(wire_scene_out *out) {
    wire_queue *q = out->peer->queue;
    if (out->image == NULL || !out->is_known || out->state != WIRE_SCENE_GOING) {
        return 1;
    }
    while (out->at < out->bytes) {
        if (wire_queue_room(q) < CHUNK_BYTES + 7) {
            break;
        }
        const uint32_t count = chunk_bytes(out);
        uint8_t *to = q->bytes + q->used;
        const uint32_t head = wire_head_put(to, WIRE_SCENE_DATA, count + 4);
        wire_put32(to + head, out->at);
        memcpy(to + head + 4, out->image + out->at, count);
        q->used = (uint16_t)(q->used + head + 4 + count);
        out->at += count;
    }
    return 1;
}
