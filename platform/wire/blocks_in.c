/* blocks_in - asks for pieces of an image and puts them where they belong
 *
 * Invariant: the first `has` bytes of a request are in `to`; nothing is written
 * outside to[0 .. count - 1].
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/services.h"

enum want_state { FREE, TO_ASK, ASKED, DONE, REFUSED };

void wire_blocks_in_open(wire_blocks_in *in, wire_peer *peer, int (*pump)(void *), void *context) {
    memset(in, 0, sizeof *in);
    in->peer = peer;
    in->pump = pump;
    in->pump_context = context;
    peer->blocks_in = in;
}

static void ask(wire_blocks_in *in, wire_block_want *w) {
    w->state = TO_ASK;
    wire_queue_control(in->peer, WIRE_BLOCK_ASK);
}

int wire_block_ask(wire_blocks_in *in, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        if (w->state == FREE) {
            *w = (wire_block_want){to, offset, count, 0, 0, (uint8_t)tag, DONE};
            if (count > 0) {
                ask(in, w);
            }
            return WIRE_OK;
        }
    }
    return WIRE_BUSY;
}

static int is_asked(const wire_block_want *w) {
    return w->state == TO_ASK || w->state == ASKED;
}

void wire_blocks_in_begin(wire_blocks_in *in) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        if (is_asked(&in->want[i])) {
            ask(in, &in->want[i]);
        }
    }
}

void wire_blocks_in_poll(wire_blocks_in *in) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        if (w->state == ASKED && in->peer->now_ms - w->asked_ms >= WIRE_BLOCK_AGAIN_MS) {
            ask(in, w);
        }
    }
}

uint32_t wire_blocks_in_write(wire_blocks_in *in, uint8_t *body) {
    uint32_t made = 0;
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        if (w->state != TO_ASK) {
            continue;
        }
        if (made > 0) {
            wire_queue_control(in->peer, WIRE_BLOCK_ASK); /* the next one in its own message */
            break;
        }
        body[0] = w->tag;
        wire_put32(body + 1, w->offset + w->has);
        wire_put32(body + 5, w->count - w->has);
        w->state = ASKED;
        w->asked_ms = in->peer->now_ms;
        made = 9;
    }
    return made;
}

void wire_blocks_in_receive(wire_blocks_in *in, const uint8_t *body) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        if (is_asked(w) && w->tag == body[0] && w->offset + w->has == wire_get32(body + 1)) {
            w->state = REFUSED;
        }
    }
}

void wire_blocks_in_head(wire_blocks_in *in, unsigned tag, uint32_t offset) {
    in->at = offset;
    in->coming = (uint8_t)tag;
}

/* Copies the part of the bytes that this request lacks next. */
static void copy_for(const wire_blocks_in *in, wire_block_want *w, const uint8_t *bytes,
                     uint32_t count) {
    const uint32_t next = w->offset + w->has, skip = next - in->at;
    if (w->tag != in->coming || in->at > next || skip >= count) {
        return;
    }
    const uint32_t left = w->count - w->has;
    const uint32_t n = count - skip < left ? count - skip : left;
    memcpy(w->to + w->has, bytes + skip, n);
    w->has += n;
    w->asked_ms = in->peer->now_ms;
    w->state = w->has == w->count ? DONE : w->state;
}

void wire_blocks_in_bytes(wire_blocks_in *in, const uint8_t *bytes, uint32_t count) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        if (is_asked(&in->want[i])) {
            copy_for(in, &in->want[i], bytes, count);
        }
    }
    in->at += count;
}

int wire_block_state(wire_blocks_in *in, uint32_t tags) {
    int status = WIRE_OK;
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        const wire_block_want *w = &in->want[i];
        if (w->state != FREE && tags >> (w->tag & 31) & 1) {
            if (is_asked(w)) {
                return WIRE_BUSY;
            }
            status = w->state == REFUSED ? WIRE_ERR_DOWN : status;
        }
    }
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        w->state = w->state != FREE && tags >> (w->tag & 31) & 1 ? FREE : w->state;
    }
    return status;
}

int wire_source_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    wire_blocks_in *in = context;
    while (wire_block_ask(in, tag, offset, to, count) == WIRE_BUSY) {
        if (in->pump(in->pump_context) < 0) {
            return -1;
        }
    }
    return 0;
}

int wire_source_wait(void *context, uint32_t tags) {
    wire_blocks_in *in = context;
    int status;
    while ((status = wire_block_state(in, tags)) == WIRE_BUSY) {
        if (in->pump(in->pump_context) < 0) {
            return -1;
        }
    }
    return status < 0 ? -1 : 0;
}
