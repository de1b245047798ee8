/* keys - how often each key has changed: the latest wins, repeated until it is acknowledged
 *
 * Keeps: changes[k] is odd while key k is down.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/services.h"

enum { REPEAT_MS = 50 };

void wire_keys_out_open(wire_keys_out *out, wire_peer *peer) {
    memset(out, 0, sizeof *out);
    out->peer = peer;
    out->have = 1;
    peer->keys_out = out;
    peer->own.features |= WIRE_KEYS;
}

static int is_wanted(const wire_keys_out *out) {
    return wire_has_session(out->peer) && (out->peer->other.features & WIRE_KEYS) != 0;
}

static void send(wire_keys_out *out) {
    out->have = 0;
    out->sent_ms = out->peer->now_ms;
    wire_queue_control(out->peer, WIRE_KEYS_ARE);
}

void wire_key_set(wire_keys_out *out, unsigned key, int is_down) {
    if (key >= WIRE_KEYS_MOST || (out->changes[key] & 1) == (is_down != 0)) {
        return;
    }
    out->changes[key]++;
    out->number++;
    if (is_wanted(out)) {
        send(out);
    }
}

/* What was pressed before, and is no longer, is nobody's business. */
void wire_keys_out_begin(wire_keys_out *out) {
    uint8_t down = 0;
    for (unsigned k = 0; k < WIRE_KEYS_MOST; k++) {
        out->changes[k] &= 1;
        down |= out->changes[k];
    }
    out->have = 1;
    if (down && is_wanted(out)) {
        send(out);
    }
}

void wire_keys_out_poll(wire_keys_out *out) {
    if (!out->have && out->peer->now_ms - out->sent_ms >= REPEAT_MS) {
        send(out);
    }
}

uint32_t wire_keys_out_write(const wire_keys_out *out, uint8_t *body) {
    body[0] = out->number;
    memcpy(body + 1, out->changes, WIRE_KEYS_MOST);
    return 1 + WIRE_KEYS_MOST;
}

void wire_keys_out_receive(wire_keys_out *out, const uint8_t *body) {
    out->have = out->have || body[0] == out->number;
}

void wire_keys_in_open(wire_keys_in *in, wire_peer *peer) {
    memset(in, 0, sizeof *in);
    peer->keys_in = in;
    peer->own.features |= WIRE_KEYS;
}

void wire_keys_in_begin(wire_keys_in *in) {
    memset(in, 0, sizeof *in);
}

/* Of a device with fewer keys, or with more. */
void wire_keys_in_receive(wire_keys_in *in, const uint8_t *body, uint32_t bytes) {
    in->number = body[0];
    memcpy(in->changes, body + 1, bytes - 1 < WIRE_KEYS_MOST ? bytes - 1 : WIRE_KEYS_MOST);
}

uint32_t wire_keys_in_write(const wire_keys_in *in, uint8_t *body) {
    body[0] = in->number;
    return 1;
}
