/* peer_out - the next report: control messages first, then data within credits
 *
 * Invariants: every number is used once a session; data leaves only while
 * fewer than the other peer's credits are unacknowledged; control messages
 * need no credit, so two peers can never wait for each other's.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/report.h"
#include "platform/wire/services.h"
#include "platform/wire/session.h"

typedef struct writing {
    uint8_t *report, *payload;
    uint32_t room, used; /* of the payload */
    uint32_t first;      /* offset of the first message that begins, or `none` */
    uint32_t none;
} writing;

static size_t finish(const wire_peer *peer, const writing *w, int is_control, uint32_t number,
                     uint32_t key) {
    const uint32_t bytes = peer->own.out_bytes;
    memset(w->payload + w->used, WIRE_PAD, w->room - w->used);
    wire_report_seal(w->report, bytes, peer->role, key, number, w->first, is_control);
    return bytes;
}

/* ---- control ------------------------------------------------------------------------- */

static int is_hello(unsigned type) {
    return type == WIRE_HELLO || type == WIRE_WELCOME;
}

/* The next control message into control_out; 0: there is none. `like`: only
 * of the same kind (hello or not), as one report has one key; -1: any. */
static int next_control(wire_peer *peer, int like) {
    const uint32_t hellos = wire_bit(WIRE_HELLO) | wire_bit(WIRE_WELCOME);
    const uint32_t silent = peer->role == WIRE_DEVICE ? hellos | wire_bit(WIRE_ACK) : hellos;
    uint32_t may = wire_is_up(peer) ? UINT32_MAX : wire_has_session(peer) ? silent : hellos;
    may &= like < 0 ? UINT32_MAX : like ? hellos : ~hellos;
    while (peer->pending & may) {
        /* An acknowledgement says that this session is up, before another one is offered. */
        unsigned type = peer->pending & may & wire_bit(WIRE_ACK) ? WIRE_ACK : WIRE_HELLO;
        while (!(peer->pending & may & wire_bit(type))) {
            type++;
        }
        peer->pending &= ~wire_bit(type);
        const uint32_t body = wire_control_write(peer, type, peer->control_out + 2);
        if (body > 0) {
            peer->control_out[0] = (uint8_t)type;
            peer->control_out[1] = (uint8_t)body;
            peer->control_used = (uint8_t)(body + 2);
            peer->control_gone = 0;
            peer->hello_number = is_hello(type) ? 0 : peer->hello_number;
            return 1;
        }
    }
    return 0;
}

static void add_control(wire_peer *peer, writing *w) {
    const uint32_t left = (uint32_t)peer->control_used - peer->control_gone;
    const uint32_t n = left < w->room - w->used ? left : w->room - w->used;
    if (peer->control_gone == 0 && w->first == w->none) {
        w->first = w->used;
    }
    if (peer->control_out[0] == WIRE_PING) {
        peer->out_asks = peer->out_number + 1;
    }
    memcpy(w->payload + w->used, peer->control_out + peer->control_gone, n);
    peer->control_gone = (uint8_t)(peer->control_gone + n);
    w->used += n;
}

static size_t control_report(wire_peer *peer, writing *w) {
    const int hello = is_hello(peer->control_out[0]);
    do {
        add_control(peer, w);
    } while (w->used < w->room && !hello && next_control(peer, 0));
    if (hello) {
        return finish(peer, w, 1, peer->hello_number++, WIRE_HELLO_KEY);
    }
    peer->stats.reports_out++;
    return finish(peer, w, 1, peer->out_number++, peer->key);
}

/* ---- data ------------------------------------------------------------------------------ */

static int fill_queue(wire_peer *peer) {
    int leaves = 0;
    if (peer->blocks_out != NULL) {
        leaves |= wire_blocks_out_fill(peer->blocks_out);
    }
    if (peer->scene_out != NULL) {
        leaves |= wire_scene_out_fill(peer->scene_out);
    }
    if (peer->frames_out != NULL) {
        leaves |= wire_frames_out_fill(peer->frames_out);
    }
    return leaves;
}

static size_t data_report(wire_peer *peer, writing *w) {
    const int leaves = fill_queue(peer);
    if (wire_queue_bytes(peer->queue) < (leaves ? 1 : w->room)) {
        return 0;
    }
    for (;;) {
        uint32_t first = w->none;
        const uint32_t n =
            wire_queue_read(peer->queue, w->payload + w->used, w->room - w->used, &first);
        w->first = w->first == w->none && first != w->none ? first + w->used : w->first;
        w->used += n;
        if (w->used == w->room) {
            break;
        }
        fill_queue(peer);
        if (wire_queue_bytes(peer->queue) == 0) {
            break;
        }
    }
    w->first = w->first < w->none ? w->first : w->none;
    if ((int32_t)(peer->out_asks - peer->out_acked) <= 0) {
        peer->asked_ms = peer->now_ms; /* the wait for an acknowledgement begins */
    }
    if (peer->frames_out != NULL && wire_queue_bytes(peer->queue) == 0) {
        wire_frames_out_left(peer->frames_out, peer->out_number);
    }
    peer->stats.payload_out += w->used;
    peer->stats.reports_out++;
    peer->out_asks = peer->out_number + 1;
    return finish(peer, w, 0, peer->out_number++, peer->key);
}

size_t wire_next_report(wire_peer *peer, uint8_t *report, uint32_t now_ms) {
    const uint32_t size = peer->own.out_bytes, head = wire_header_bytes(size);
    const uint32_t none = wire_first_none(size);
    writing w = {report, report + head, size - head, 0, none, none};
    peer->now_ms = now_ms;
    if (peer->control_gone < peer->control_used || next_control(peer, -1)) {
        return control_report(peer, &w);
    }
    if (!wire_is_up(peer) || peer->queue == NULL ||
        peer->out_number - peer->out_acked >= peer->other.credits) {
        return 0;
    }
    return data_report(peer, &w);
}
