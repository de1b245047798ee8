/* blocks_in - asks for pieces of an image and puts them where they belong
 *
 * Invariant: the first `has` bytes of a request are in `to`; nothing is written
 * outside to[0 .. count - 1], and nothing at all once the request is forgotten.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/services.h"

enum want_state { FREE, TO_ASK, ASKED, DONE, FAILED };

void wire_blocks_in_open(wire_blocks_in *in, wire_peer *peer, int (*pump)(void *), void *context) {
    memset(in, 0, sizeof *in);
    in->peer = peer;
    in->pump = pump;
    in->pump_context = context;
    peer->blocks_in = in;
}

void wire_blocks_in_image(wire_blocks_in *in, uint32_t crc) {
    in->crc = crc;
    in->is_named = 1;
}

static void ask(wire_blocks_in *in, wire_block_want *w) {
    w->state = TO_ASK;
    wire_queue_control(in->peer, WIRE_BLOCK_ASK);
}

static int is_asked(const wire_block_want *w) {
    return w->state == TO_ASK || w->state == ASKED;
}

/* No request is on the way. */
static int is_silent(const wire_blocks_in *in) {
    int asked = 0;
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        asked |= is_asked(&in->want[i]);
    }
    return !asked;
}

int wire_block_ask(wire_blocks_in *in, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        if (w->state == FREE) {
            const uint32_t now = in->peer->now_ms;
            *w = (wire_block_want){to, offset, count, 0, now, now, (uint8_t)tag, DONE};
            if (count > 0) {
                in->moved_ms = is_silent(in) ? now : in->moved_ms;
                ask(in, w);
            }
            return WIRE_OK;
        }
    }
    return WIRE_BUSY;
}

void wire_blocks_in_begin(wire_blocks_in *in) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        if (is_asked(&in->want[i])) {
            ask(in, &in->want[i]);
        }
    }
}

static uint32_t again_ms(const wire_blocks_in *in) {
    return WIRE_BLOCK_AGAIN_MS + in->more_ms;
}

void wire_blocks_in_poll(wire_blocks_in *in) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        if (w->state == ASKED && in->peer->now_ms - w->asked_ms >= again_ms(in)) {
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
        wire_put32(body + 9, in->crc);
        made = in->is_named ? 13 : 9;
    }
    return made;
}

void wire_blocks_in_receive(wire_blocks_in *in, const uint8_t *body) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        if (is_asked(w) && w->tag == body[0] && w->offset + w->has == wire_get32(body + 1)) {
            w->state = FAILED;
        }
    }
}

void wire_blocks_in_head(wire_blocks_in *in, unsigned tag, uint32_t offset) {
    in->at = offset;
    in->coming = (uint8_t)tag;
}

/* Bytes came that were there already, or not. If they were, they had been asked for again too
 * soon. */
static void learn(wire_blocks_in *in, int was_in_vain) {
    const uint32_t most = WIRE_BLOCK_SLOW_MS - WIRE_BLOCK_AGAIN_MS;
    const uint32_t now = in->more_ms, less = now > 0 ? now - 1 : 0;
    const uint32_t more = was_in_vain ? now + WIRE_BLOCK_AGAIN_MS / 4u : less;
    in->more_ms = (uint16_t)(more < most ? more : most);
}

/* Copies the part of the bytes that this request lacks next. 0: it has had them, or never wanted
 * them. */
static int copy_for(wire_blocks_in *in, wire_block_want *w, const uint8_t *bytes, uint32_t count) {
    const uint32_t next = w->offset + w->has, skip = next - in->at;
    if (w->tag != in->coming || in->at > next || skip >= count) {
        return w->tag == in->coming && in->at > next && in->at < w->offset + w->count;
    }
    const uint32_t left = w->count - w->has;
    const uint32_t n = count - skip < left ? count - skip : left;
    memcpy(w->to + w->has, bytes + skip, n);
    w->has += n;
    w->asked_ms = in->moved_ms = in->peer->now_ms;
    w->state = w->has == w->count ? DONE : w->state;
    return 1;
}

void wire_blocks_in_bytes(wire_blocks_in *in, const uint8_t *bytes, uint32_t count) {
    int is_wanted = 0;
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        if (is_asked(&in->want[i])) {
            is_wanted |= copy_for(in, &in->want[i], bytes, count);
        }
    }
    learn(in, !is_wanted);
    in->at += count;
}

static int is_of(const wire_block_want *w, uint32_t tags) {
    return w->state != FREE && tags >> (w->tag & 31) & 1;
}

void wire_block_forget(wire_blocks_in *in, uint32_t tags) {
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        w->state = is_of(w, tags) ? FREE : w->state;
    }
}

static int is_late(const wire_blocks_in *in, const wire_block_want *w) {
    const uint32_t now = in->peer->now_ms;
    return now - in->moved_ms >= WIRE_BLOCK_DEAD_MS || now - w->begun_ms >= WIRE_BLOCK_MOST_MS;
}

int wire_block_state(wire_blocks_in *in, uint32_t tags) {
    int status = WIRE_OK;
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_want *w = &in->want[i];
        if (is_of(w, tags)) {
            if (is_asked(w) && !is_late(in, w)) {
                return WIRE_BUSY;
            }
            status = w->state == DONE ? status : WIRE_ERR_DOWN;
        }
    }
    wire_block_forget(in, tags);
    return status;
}

int wire_source_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    return wire_block_ask(context, tag, offset, to, count) == WIRE_OK ? 0 : -1;
}

int wire_source_wait(void *context, uint32_t tags) {
    wire_blocks_in *in = context;
    int status;
    while ((status = wire_block_state(in, tags)) == WIRE_BUSY) {
        if (in->pump(in->pump_context) < 0) {
            wire_block_forget(in, tags);
            return -1;
        }
    }
    return status < 0 ? -1 : 0;
}
