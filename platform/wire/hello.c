/* hello - who is there: capabilities, and a key for the session
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_crc32.h"
#include "platform/wire/report.h"
#include "platform/wire/session.h"

enum { CAPS_BYTES = 22, HELLO_BYTES = 4 + CAPS_BYTES + 4 };

static void put_caps(uint8_t *to, const wire_caps *c) {
    to[0] = c->version;
    to[1] = c->features;
    to[2] = c->format;
    to[3] = c->credits;
    wire_put16(to + 4, c->width);
    wire_put16(to + 6, c->height);
    wire_put16(to + 8, c->formats);
    wire_put16(to + 10, c->in_bytes);
    wire_put16(to + 12, c->out_bytes);
    wire_put32(to + 14, c->arena_bytes);
    wire_put32(to + 18, c->session);
}

/* Values that could harm are made harmless: credits, format, sizes. */
static wire_caps get_caps(const uint8_t *at) {
    wire_caps c;
    c.version = at[0];
    c.features = at[1];
    c.format = at[2];
    c.credits = at[3] < 2 ? 2 : at[3] > WIRE_CREDITS_MAX ? WIRE_CREDITS_MAX : at[3];
    c.width = (uint16_t)wire_get16(at + 4);
    c.height = (uint16_t)wire_get16(at + 6);
    c.formats = (uint16_t)wire_get16(at + 8);
    c.in_bytes = (uint16_t)wire_get16(at + 10);
    c.out_bytes = (uint16_t)wire_get16(at + 12);
    c.arena_bytes = wire_get32(at + 14);
    c.session = wire_get32(at + 18);
    if (c.format >= WIRE_FORMATS || c.width == 0 || c.height == 0) {
        c.features &= (uint8_t)~WIRE_SHOWS;
    }
    return c;
}

/* Host's half, the sender's capabilities, CRC-32 of both. */
uint32_t wire_hello_write(const wire_peer *peer, uint8_t *body) {
    wire_put32(body, peer->role == WIRE_HOST ? peer->own.session : peer->host_half);
    put_caps(body + 4, &peer->own);
    wire_put32(body + 4 + CAPS_BYTES, plt_crc32(0, body, 4 + CAPS_BYTES));
    return HELLO_BYTES;
}

/* Device: a session is offered. It begins with the first report under its
 * key, so an old hello that comes late ends nothing. A host that was silent, or thinks that this
 * device was, may know the session that is up: it is told first. */
static void offer_session(wire_peer *peer, uint32_t host_half, const wire_caps *caps) {
    const int is_known = host_half == peer->host_half;
    if (!(is_known && (peer->has_next || peer->state == WIRE_IS_UP))) {
        peer->host_half = host_half;
        if (peer->state != WIRE_IS_UP) {
            peer->own.session = wire_scramble(peer->own.session + 1);
        }
        peer->next_key = wire_session_key(host_half, peer->own.session);
        peer->next_other = *caps;
        peer->has_next = peer->state != WIRE_IS_UP || peer->next_key != peer->key;
    }
    if (wire_has_session(peer) && wire_unacked(peer) <= WIRE_UNACKED_MOST) {
        wire_queue_control(peer, WIRE_ACK);
    }
    wire_queue_control(peer, WIRE_WELCOME);
}

void wire_hello_receive(wire_peer *peer, unsigned type, const uint8_t *body, uint32_t bytes) {
    if (bytes != HELLO_BYTES ||
        plt_crc32(0, body, 4 + CAPS_BYTES) != wire_get32(body + 4 + CAPS_BYTES)) {
        return;
    }
    const uint32_t host_half = wire_get32(body);
    const wire_caps caps = get_caps(body + 4);
    if (caps.version != WIRE_VERSION) {
        peer->other_error = WIRE_E_VERSION;
        peer->other_detail = caps.version;
        return;
    }
    if (type == WIRE_HELLO && peer->role == WIRE_DEVICE) {
        offer_session(peer, host_half, &caps);
    } else if (type == WIRE_WELCOME && !wire_is_up(peer) && peer->role == WIRE_HOST &&
               peer->state != WIRE_IS_DOWN && host_half == peer->own.session) {
        peer->other = caps;
        peer->key = wire_session_key(host_half, caps.session);
        wire_session_begin(peer);
    }
}
