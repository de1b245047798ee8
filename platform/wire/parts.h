/* parts - what an end and its parts want of each other
 *
 * Not for users. A part has, as it needs them: begin (a session is up),
 * poll, fill (put data messages into the queue), take (a control message
 * came), make (build a control message), and head / bytes / done / cut for
 * the data messages it receives.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_PARTS_H
#define PLT_WIRE_PARTS_H

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
    WIRE_TILE = 0x80
};

/* Control messages waiting to be sent, most urgent first: bit n for the type
 * 0x10 + n. */
static inline uint32_t wire_bit(unsigned type) {
    return UINT32_C(1) << (type - WIRE_HELLO);
}

static inline void wire_queue_control(wire_peer *peer, unsigned type) {
    peer->pending |= wire_bit(type);
}

/* Of the message that ends a frame: body and all. */
enum { WIRE_END_BODY = 9, WIRE_END_BYTES = 11 };

enum wire_state { WIRE_IS_DOWN, WIRE_IS_ASKING, WIRE_IS_UP };

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

/* ---- the end (end.c, peer_in.c, peer_out.c, control.c) -------------------------------- */

uint32_t wire_session_key(uint32_t host_half, uint32_t device_half);
uint32_t wire_scramble(uint32_t number);
void wire_session_begin(wire_peer *peer);
void wire_session_end(wire_peer *peer);

/* Bytes of a report before its payload. */
static inline uint32_t wire_header_bytes(uint32_t report_bytes) {
    return report_bytes > 128 ? 7 : 6;
}

/* The number of a hello report is just its low byte, under this key. */
enum { WIRE_HELLO_KEY = 0x31544C50 };

/* Builds the body of a control message; returns its bytes. */
uint32_t wire_control_write(wire_peer *peer, unsigned type, uint8_t *body);

/* `hello`: the report was under the hello key. */
void wire_control_receive(wire_peer *peer, unsigned type, const uint8_t *body, uint32_t bytes,
                          int hello);

/* Body of a HELLO or WELCOME (hello.c). */
uint32_t wire_hello_write(const wire_peer *peer, uint8_t *body);
void wire_hello_receive(wire_peer *peer, unsigned type, const uint8_t *body, uint32_t bytes);

/* ---- the queue (queue.c) ---------------------------------------------------------------- */

uint32_t wire_queue_room(wire_queue *q); /* moves what is there to the front */
static inline uint32_t wire_queue_bytes(const wire_queue *q) {
    return (uint32_t)(q->used - q->gone);
}

/* Moves bytes into a report, at most `room`. `*first`: offset in `to` of the
 * first message that begins there, unchanged when none does. */
uint32_t wire_queue_read(wire_queue *q, uint8_t *to, uint32_t room, uint32_t *first);

/* Head of a message: type, and the length of the body in one or two bytes. */
uint32_t wire_head_put(uint8_t *to, unsigned type, uint32_t body_bytes);

/* ---- parts --------------------------------------------------------------------------------- */

/* Numbers of frames go round: 0 .. 5. */
enum { WIRE_NUMBERS = 6 };

void wire_frames_out_begin(wire_frames_out *out);
void wire_frames_out_poll(wire_frames_out *out);
/* 1: what is queued should leave even if it does not fill a report. */
int wire_frames_out_fill(wire_frames_out *out);
void wire_frames_out_left(wire_frames_out *out, uint32_t number);
void wire_frames_out_receive(wire_frames_out *out, unsigned type, const uint8_t *body);

void wire_frames_in_begin(wire_frames_in *in);
uint32_t wire_frames_in_write(wire_frames_in *in, unsigned type, uint8_t *body);
void wire_frames_in_tile(wire_frames_in *in, unsigned type, unsigned low, uint32_t bytes);
void wire_frames_in_bytes(wire_frames_in *in, const uint8_t *bytes, uint32_t count);
void wire_frames_in_cut(wire_frames_in *in);
void wire_frames_in_end(wire_frames_in *in, const uint8_t *body);

void wire_scene_out_begin(wire_scene_out *out);
void wire_scene_out_poll(wire_scene_out *out);
int wire_scene_out_fill(wire_scene_out *out);
uint32_t wire_scene_out_write(wire_scene_out *out, uint8_t *body);
void wire_scene_out_receive(wire_scene_out *out, const uint8_t *body);

void wire_scene_in_poll(wire_scene_in *in);
uint32_t wire_scene_in_write(wire_scene_in *in, uint8_t *body);
void wire_scene_in_receive(wire_scene_in *in, const uint8_t *body);
void wire_scene_in_head(wire_scene_in *in, uint32_t offset);
void wire_scene_in_bytes(wire_scene_in *in, const uint8_t *bytes, uint32_t count);

void wire_view_out_begin(wire_view_out *out);
void wire_view_out_poll(wire_view_out *out);
uint32_t wire_view_out_write(wire_view_out *out, uint8_t *body);
void wire_view_in_receive(wire_view_in *in, const uint8_t *body);

int wire_blocks_out_fill(wire_blocks_out *out);
uint32_t wire_blocks_out_write(wire_blocks_out *out, uint8_t *body);
void wire_blocks_out_receive(wire_blocks_out *out, const uint8_t *body);

void wire_blocks_in_begin(wire_blocks_in *in);
void wire_blocks_in_poll(wire_blocks_in *in);
uint32_t wire_blocks_in_write(wire_blocks_in *in, uint8_t *body);
void wire_blocks_in_receive(wire_blocks_in *in, const uint8_t *body);
void wire_blocks_in_head(wire_blocks_in *in, unsigned tag, uint32_t offset);
void wire_blocks_in_bytes(wire_blocks_in *in, const uint8_t *bytes, uint32_t count);

#endif
