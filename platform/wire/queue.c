/* queue - data messages that wait for room in reports
 *
 * Invariant: bytes[gone .. used) are whole messages but for the first, of
 * which `left` bytes are there; `left` 0: a message begins at `gone`.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/base.h"

uint32_t wire_queue_room(wire_queue *q) {
    memmove(q->bytes, q->bytes + q->gone, wire_queue_bytes(q));
    q->used = (uint16_t)(q->used - q->gone);
    q->gone = 0;
    return WIRE_QUEUE_BYTES - q->used;
}

uint32_t wire_head_put(uint8_t *to, unsigned type, uint32_t body_bytes) {
    uint32_t used = 0;
    to[used++] = (uint8_t)type;
    if (body_bytes < 128) {
        to[used++] = (uint8_t)body_bytes;
    } else {
        to[used++] = (uint8_t)(body_bytes | 128);
        to[used++] = (uint8_t)(body_bytes >> 7);
    }
    return used;
}

/* Bytes of the message that begins at `at`, head included. */
static uint32_t message_bytes(const uint8_t *at) {
    const uint32_t head = at[0] & WIRE_TILE ? 2 : 1;
    const uint32_t length = at[head];
    return length < 128 ? head + 1 + length
                        : head + 2 + ((length & 127) | (uint32_t)at[head + 1] << 7);
}

uint32_t wire_queue_read(wire_queue *q, uint8_t *to, uint32_t room, uint32_t *first) {
    uint32_t moved = 0;
    int is_first = 1;
    while (moved < room && wire_queue_bytes(q) > 0) {
        if (q->left == 0) {
            q->left = (uint16_t)message_bytes(q->bytes + q->gone);
            if (is_first) {
                *first = moved;
                is_first = 0;
            }
        }
        const uint32_t n = q->left < room - moved ? q->left : room - moved;
        memcpy(to + moved, q->bytes + q->gone, n);
        moved += n;
        q->gone = (uint16_t)(q->gone + n);
        q->left = (uint16_t)(q->left - n);
    }
    return moved;
}
