/* tiles_out - what the sender knows of a tile, and how one goes out
 *
 * Invariant: hash != 0 and slot 0: the panel shows those pixels, or, where coarse is
 * set, samples within `near` of theirs. With slot != 0 each row shows either that or
 * what it showed before.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_TILES_OUT_H
#define PLT_WIRE_TILES_OUT_H

#include "platform/wire/services.h"

/* WIRE_NUMBERS is a multiple of it: each unanswered frame has a slot of its own. */
enum { WIRE_SLOTS = 3 };
_Static_assert((int)WIRE_NUMBERS % WIRE_SLOTS == 0, "a slot for each frame");

static inline unsigned wire_slot_of(const wire_frames_out *out, unsigned tile) {
    return out->slot[tile / 4] >> (2 * (tile & 3)) & 3;
}

static inline void wire_set_slot(wire_frames_out *out, unsigned tile, unsigned slot) {
    uint8_t *at = &out->slot[tile / 4];
    *at = (uint8_t)((*at & ~(3u << (2 * (tile & 3)))) | slot << (2 * (tile & 3)));
}

static inline int wire_is_coarse(const wire_frames_out *out, unsigned tile) {
    return out->coarse[tile / 8] >> (tile & 7) & 1;
}

static inline void wire_set_coarse(wire_frames_out *out, unsigned tile, unsigned is) {
    uint8_t *at = &out->coarse[tile / 8];
    *at = (uint8_t)((*at & ~(1u << (tile & 7))) | is << (tile & 7));
}

/* The slot of the frame `back` frames before the one that goes out. */
static inline unsigned wire_slot_back(const wire_frames_out *out, unsigned back) {
    return (out->number + WIRE_NUMBERS - back) % WIRE_SLOTS + 1;
}

typedef struct wire_piece {
    unsigned index, x, y;
    wire_tile_shape shape;
    uint32_t row_bytes;
} wire_piece;

wire_piece wire_piece_of(const wire_frames_out *out, unsigned index);
int wire_has_reference(const wire_frames_out *out);

/* The tile's pixels in the panel's format, into out->pixels. */
void wire_convert(wire_frames_out *out, const wire_piece *p, const uint8_t *rgb, uint32_t stride);

/* Queues the tile in out->pixels if it has to be sent. 0: no room, call again. */
int wire_offer(wire_frames_out *out, const wire_piece *p);

/* The message that ends a frame; 0: no room for it. */
int wire_put_end(wire_frames_out *out, unsigned number);

/* A pass over a new frame begins; it is over (frames_rate.c). */
void wire_rate_begin(wire_frames_out *out);
void wire_rate_end(wire_frames_out *out, unsigned looked_at);

#endif
