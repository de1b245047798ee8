/* tiles_out - see tiles_out.h
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/tiles_out.h"
#include "engine/planelet_crc32.h"
#include "platform/wire/hash.h"

wire_piece wire_piece_of(const wire_frames_out *out, unsigned index) {
    wire_piece p = {index, index % out->columns * 16, index / out->columns * 16, {0, 0, 0}, 0};
    p.shape.format = out->format;
    p.shape.width = (uint8_t)(out->width - p.x < 16 ? out->width - p.x : 16);
    p.shape.height = (uint8_t)(out->height - p.y < 16 ? out->height - p.y : 16);
    p.row_bytes = wire_row_bytes(out->format, p.shape.width);
    return p;
}

/* 0 stands for a tile of which nothing is known. */
static uint32_t hash_of(const wire_frames_out *out, const wire_piece *p) {
    const uint32_t hash = wire_hash(out->pixels, p->row_bytes * p->shape.height);
    return hash == 0 ? 1 : hash;
}

int wire_has_reference(const wire_frames_out *out) {
    return out->reference != NULL && out->peer->other.features & WIRE_READS &&
           out->reference_bytes >= wire_row_bytes(out->format, out->width) * out->height;
}

/* Copies between `pixels`-like memory without gaps and the reference. */
static void move_reference(wire_frames_out *out, const wire_piece *p, uint8_t *tile, int into) {
    const uint32_t stride = wire_row_bytes(out->format, out->width);
    for (unsigned y = 0; y < p->shape.height; y++) {
        uint8_t *at = out->reference + (p->y + y) * stride + wire_row_bytes(out->format, p->x);
        memcpy(into ? at : tile, into ? tile : at, p->row_bytes);
        tile += p->row_bytes;
    }
}

/* Whether what the panel shows is within the bound of `pixels`. */
static int is_near_enough(const wire_frames_out *out, const wire_piece *p, const uint8_t *old,
                          unsigned near) {
    for (unsigned y = 0; y < p->shape.height; y++) {
        for (unsigned x = 0; x < p->shape.width; x++) {
            const wire_sample a = wire_sample_get(out->format, old + y * p->row_bytes, x);
            const wire_sample b = wire_sample_get(out->format, out->pixels + y * p->row_bytes, x);
            for (unsigned i = 0; i < 3; i++) {
                if (a.v[i] > b.v[i] + near || b.v[i] > a.v[i] + near) {
                    return 0;
                }
            }
        }
    }
    return 1;
}

/* Appends the tile in `pixels`; 0: no room. `old` may be NULL. */
static int append(wire_frames_out *out, const wire_piece *p, const uint8_t *old, unsigned near) {
    const uint32_t room = wire_queue_room(&out->queue);
    uint8_t *to = out->queue.bytes + out->queue.used;
    const uint32_t raw = p->row_bytes * p->shape.height;
    unsigned coder;
    if (room < raw + 4 + WIRE_FRAME_END_BYTES) {
        return 0;
    }
    const uint32_t bytes = wire_tile_encode(p->shape, out->pixels, old, near, to + 4, raw, &coder);
    const unsigned type = WIRE_TILE | coder << 5 | (unsigned)out->number << 2 | p->index >> 8;
    uint32_t head = 0;
    to[head++] = (uint8_t)type;
    to[head] = (uint8_t)p->index;
    head += wire_head_put(to + head, p->index & 255, bytes);
    memmove(to + head, to + 4, bytes);
    out->queue.used = (uint16_t)(out->queue.used + head + bytes);
    return 1;
}

/* The checksum of a frame: of each tile's number and pixels, in order. */
static void add_to_checksum(wire_frames_out *out, const wire_piece *p) {
    uint8_t index[2];
    wire_put16(index, p->index);
    out->crc = plt_crc32(out->crc, index, 2);
    out->crc = plt_crc32(out->crc, out->pixels, p->row_bytes * p->shape.height);
}

int wire_offer(wire_frames_out *out, const wire_piece *p) {
    uint8_t old[WIRE_TILE_BYTES_MAX];
    const uint32_t hash = hash_of(out, p);
    const int is_known = out->hash[p->index] == hash;
    const int refines = out->is_exact_pass && wire_is_coarse(out, p->index);
    /* What is known goes out again only to be exact. */
    const int is_exact = is_known || out->is_exact_pass || out->format >= WIRE_GREY4;
    const unsigned near = is_exact ? 0 : out->near;
    if (is_known && !refines && p->index != out->refresh) {
        return 1;
    }
    const int delta =
        wire_has_reference(out) && out->hash[p->index] != 0 && wire_slot_of(out, p->index) == 0;
    if (delta) {
        move_reference(out, p, old, 0);
        if (near > 0 && is_near_enough(out, p, old, near)) {
            wire_set_coarse(out, p->index, 1);
            out->hash[p->index] = hash;
            return 1;
        }
    }
    const int refreshes = is_known && !refines;
    if (!append(out, p, delta && !refreshes ? old : NULL, near)) {
        return 0;
    }
    add_to_checksum(out, p);
    if (wire_has_reference(out)) {
        move_reference(out, p, out->pixels, 1);
    }
    wire_set_slot(out, p->index, wire_slot_back(out, 0));
    wire_set_coarse(out, p->index, near > 0);
    out->hash[p->index] = hash;
    out->sent++;
    out->peer->stats.tiles_out++;
    return 1;
}

void wire_convert(wire_frames_out *out, const wire_piece *p, const uint8_t *rgb, uint32_t stride) {
    for (unsigned y = 0; y < p->shape.height; y++) {
        wire_row_from_rgb(out->pixels + y * p->row_bytes, out->format, rgb + y * stride,
                          p->shape.width, p->x, p->y + y);
    }
}
