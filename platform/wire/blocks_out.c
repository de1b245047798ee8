/* blocks_out - answers requests for pieces of an image
 *
 * Orders are served round robin, a chunk each: a short one does not wait for a
 * long one. An order for what is being served already replaces it: the
 * other peer knows best what it still lacks.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_crc32.h"
#include "platform/wire/report.h"
#include "platform/wire/services.h"

enum { CHUNK_BYTES = 240 };

void wire_blocks_out_open(wire_blocks_out *out, wire_peer *peer, const void *image,
                          uint32_t bytes) {
    memset(out, 0, sizeof *out);
    out->peer = peer;
    out->image = image;
    out->bytes = bytes;
    out->crc = plt_crc32(0, image, image != NULL ? bytes : 0);
    if (peer->queue == NULL) {
        peer->queue = &out->own_queue;
    }
    peer->blocks_out = out;
}

static wire_block_order *order_for(wire_blocks_out *out, unsigned tag, uint32_t until) {
    wire_block_order *unused = NULL;
    for (int i = 0; i < WIRE_BLOCKS; i++) {
        wire_block_order *o = &out->order[i];
        if (o->live && o->tag == tag && o->offset + o->count == until) {
            return o;
        }
        unused = unused == NULL && !o->live ? o : unused;
    }
    return unused;
}

/* Tag, offset, count, and the image's checksum if it is named. An order too many is dropped; it
 * will be asked again. One for another image is not refused: its peer does not know yet
 * that another is offered, and will. */
void wire_blocks_out_receive(wire_blocks_out *out, const uint8_t *body, uint32_t body_bytes) {
    if (body_bytes >= 13 && wire_get32(body + 9) != out->crc) {
        return;
    }
    const uint32_t offset = wire_get32(body + 1), count = wire_get32(body + 5);
    if (count == 0 || offset > out->bytes || count > out->bytes - offset) {
        out->refused_tag = body[0];
        out->refused = offset;
        wire_queue_control(out->peer, WIRE_BLOCK_REFUSE);
        return;
    }
    wire_block_order *o = order_for(out, body[0], offset + count);
    if (o != NULL) {
        *o = (wire_block_order){offset, count, body[0], 1};
        out->asked++;
    }
}

uint32_t wire_blocks_out_write(wire_blocks_out *out, uint8_t *body) {
    body[0] = out->refused_tag;
    wire_put32(body + 1, out->refused);
    return 5;
}

/* As much as fills a report: each report that arrives is then of use. */
static uint32_t chunk_bytes(const wire_blocks_out *out, uint32_t left) {
    const uint32_t size = out->peer->own.out_bytes, payload = size - wire_header_bytes(size);
    const uint32_t most = payload < 17 ? 10 : payload - 7 < CHUNK_BYTES ? payload - 7 : CHUNK_BYTES;
    return left < most ? left : most;
}

static void send_chunk(wire_blocks_out *out, wire_block_order *o) {
    wire_queue *q = out->peer->queue;
    const uint32_t count = chunk_bytes(out, o->count);
    uint8_t *to = q->bytes + q->used;
    const uint32_t head = wire_head_put(to, WIRE_BLOCK_DATA, count + 5);
    to[head] = o->tag;
    wire_put32(to + head + 1, o->offset);
    memcpy(to + head + 5, out->image + o->offset, count);
    q->used = (uint16_t)(q->used + head + 5 + count);
    out->sent += count;
    o->offset += count;
    o->count -= count;
    o->live = o->count > 0;
}

int wire_blocks_out_fill(wire_blocks_out *out) {
    wire_queue *q = out->peer->queue;
    for (int looked = 0; looked < WIRE_BLOCKS; looked++) {
        if (wire_queue_room(q) < CHUNK_BYTES + 8) {
            break;
        }
        wire_block_order *o = &out->order[out->next_order];
        out->next_order = (uint8_t)((out->next_order + 1) % WIRE_BLOCKS);
        if (o->live) {
            send_chunk(out, o);
            looked = -1;
        }
    }
    return 1;
}
