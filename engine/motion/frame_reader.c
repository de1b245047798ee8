/* frame_reader - see frame_reader.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/frame_reader.h"

static unsigned char *half_at(const plt_frame_reader *r, unsigned half) {
    return r->window + PLT_FRAME_BEFORE_BYTES +
           half * (PLT_FRAME_BEFORE_BYTES + PLT_FRAME_HALF_BYTES);
}

/* 0: all that was on its way has come. */
static int wait_for_other(plt_frame_reader *r) {
    const uint32_t tag = 1u << (r->half ^ 1u);
    const int was_moving = r->is_moving;
    r->is_moving = 0;
    return was_moving && r->source->wait(r->source->context, tag) < 0 ? -1 : 0;
}

void plt_frame_reader_settle(plt_frame_reader *r) {
    if (r->is_moving && wait_for_other(r) != 0) {
        r->started = 0; /* it is asked for again */
    }
}

void plt_frame_reader_begin(plt_frame_reader *r, uint32_t offset, uint32_t end) {
    plt_frame_reader_settle(r);
    r->offset = offset;
    r->end = end;
    r->there = r->started = 0;
    r->half = 0;
    if (r->window == NULL) {
        r->at = (const unsigned char *)r->source->mapped + offset;
        r->there = end - offset;
    } else {
        r->at = half_at(r, 0);
    }
}

/* Begins to fill the other half with what follows. */
static int start_other(plt_frame_reader *r) {
    const uint32_t next = r->offset + r->there, left = r->end - next;
    const uint32_t count = left < PLT_FRAME_HALF_BYTES ? left : PLT_FRAME_HALF_BYTES;
    if (count == 0 || r->started > 0) {
        return 0;
    }
    if (r->source->start(r->source->context, r->half ^ 1u, next, half_at(r, r->half ^ 1u), count) <
        0) {
        return -1;
    }
    r->started = count;
    r->is_moving = 1;
    return 0;
}

/* Goes over to the other half, once it has come, with the rest of this one in front. */
static int change_halves(plt_frame_reader *r) {
    if (start_other(r) != 0) {
        return -1;
    }
    if (wait_for_other(r) != 0) {
        r->started = 0;
        return -1;
    }
    unsigned char *to = half_at(r, r->half ^ 1u) - r->there;
    memmove(to, r->at, r->there);
    r->at = to;
    r->there += r->started;
    r->started = 0;
    r->half ^= 1u;
    return 0;
}

const unsigned char *plt_frame_reader_need(plt_frame_reader *r, uint32_t bytes) {
    while (r->there < bytes) {
        if (change_halves(r) != 0) {
            return NULL;
        }
    }
    /* What follows may come meanwhile; if it cannot be asked for now, it is when it is needed. */
    if (r->window != NULL) {
        (void)start_other(r);
    }
    return r->at;
}

void plt_frame_reader_skip(plt_frame_reader *r, uint32_t bytes) {
    r->at += bytes;
    r->offset += bytes;
    r->there -= bytes;
}
