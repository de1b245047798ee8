/* base - what every service of the wire stands on: messages, numbers, the queue
 *
 * Not for users. Below this there is nothing of the wire but the codec of tiles;
 * who calls whom, from the top down, each file calling only those below it:
 *
 *   device                                   the engine behind a peer
 *   peer_in, peer_out                        a report that came; the next one
 *   control                                  control messages, to their services
 *   hello                                    who is there
 *   peer                                     sessions, time
 *   frames_show, frames_rate, frames_out,    the services (services.h)
 *   tiles_out, frames_in, scene_*, view, keys, blocks_*
 *   state, report, queue, bytes              the base
 *
 * So a service knows no other peer's business than its own: it leaves what it
 * wants sent in the queue or as a bit of `pending`, and is asked again.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_BASE_H
#define PLT_WIRE_BASE_H

#include <string.h>

#include "platform/wire/wire.h"

/* Types of messages. Data: tiles have the top bit set. */
enum wire_type {
    WIRE_PAD = 0x00, /* the rest of the report is nothing */
    WIRE_FRAME_END = 0x01,
    WIRE_SCENE_DATA = 0x02,
    WIRE_BLOCK_DATA = 0x03,
    WIRE_HELLO = 0x10,
    WIRE_WELCOME = 0x11,
    WIRE_ACK = 0x12,
    WIRE_PING = 0x13,
    WIRE_FRAME_GOOD = 0x14,
    WIRE_FRAME_BAD = 0x15,
    WIRE_SCENE_OFFER = 0x16,
    WIRE_SCENE_STATE = 0x17,
    WIRE_VIEW = 0x18,
    WIRE_VIEW_HAVE = 0x19,
    WIRE_BLOCK_ASK = 0x1A,
    WIRE_BLOCK_REFUSE = 0x1B,
    WIRE_ERROR = 0x1C,
    WIRE_SET = 0x1D,
    WIRE_STATS_ASK = 0x1E,
    WIRE_STATS = 0x1F,
    WIRE_KEYS_ARE = 0x20,
    WIRE_KEYS_HAVE = 0x21,
    WIRE_TILE = 0x80
};

/* Of a peer. */
enum wire_state { WIRE_IS_DOWN, WIRE_IS_ASKING, WIRE_IS_UP };

/* A session is up, be the other peer silent or not. */
static inline int wire_has_session(const wire_peer *peer) {
    return peer->state == WIRE_IS_UP;
}

/* Of the message that ends a frame: body, and body with its head. */
enum { WIRE_FRAME_END_BODY = 9, WIRE_FRAME_END_BYTES = 11 };

/* Reports without an acknowledgement after which a session does not outlive silence: of numbers
 * 128 apart nobody knows which is meant. */
enum { WIRE_UNACKED_MOST = 64 };

/* Numbers of frames go round: 0 .. 5. */
enum { WIRE_NUMBERS = 6 };

/* Control messages that wait to be sent, most urgent first: bit n for the type
 * 0x10 + n. */
static inline uint32_t wire_bit(unsigned type) {
    return UINT32_C(1) << (type - WIRE_HELLO);
}

static inline void wire_queue_control(wire_peer *peer, unsigned type) {
    peer->pending |= wire_bit(type);
}

/* ---- little-endian numbers -------------------------------------------------------- */

static inline void wire_put16(uint8_t *to, uint32_t x) {
    to[0] = (uint8_t)x;
    to[1] = (uint8_t)(x >> 8);
}

static inline void wire_put32(uint8_t *to, uint32_t x) {
    wire_put16(to, x);
    wire_put16(to + 2, x >> 16);
}

static inline uint32_t wire_get16(const uint8_t *at) {
    return at[0] | (uint32_t)at[1] << 8;
}

static inline uint32_t wire_get32(const uint8_t *at) {
    return wire_get16(at) | wire_get16(at + 2) << 16;
}

/* ---- the queue (queue.c) ----------------------------------------------------------- */

uint32_t wire_queue_room(wire_queue *q); /* moves what is there to the front */
static inline uint32_t wire_queue_bytes(const wire_queue *q) {
    return (uint32_t)(q->used - q->gone);
}

/* Moves bytes into a report, at most `room`. `*first`: offset in `to` of the
 * first message that begins there, unchanged when none does. */
uint32_t wire_queue_read(wire_queue *q, uint8_t *to, uint32_t room, uint32_t *first);

/* Head of a message: type, and the length of the body in one or two bytes. */
uint32_t wire_head_put(uint8_t *to, unsigned type, uint32_t body_bytes);

#endif
