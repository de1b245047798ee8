/* wire_tile - the codec: one tile of at most 16 x 16 pixels to bytes and back
 *
 * Every tile stands for itself: nothing of another tile or frame is needed to
 * decode it, so a lost one leaves the old pixels and harms no other. The
 * encoder takes the shortest of the coders that the format has; all of them
 * are lossless in the panel's format. WIRE.md, section 5, has every bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_TILE_H
#define PLT_WIRE_TILE_H

#include <stddef.h>
#include <stdint.h>

#include "platform/wire/wire_format.h"

enum wire_coder {
    WIRE_RAW = 0,     /* rows as they are */
    WIRE_SOLID = 1,   /* one pixel */
    WIRE_RUNS = 2,    /* lengths and pixels */
    WIRE_PREDICT = 3, /* what a prediction from three neighbours got wrong */
    WIRE_CODERS = 4
};

typedef struct wire_tile_shape {
    uint8_t format, width, height; /* 1 .. WIRE_TILE_SIDE pixels */
} wire_tile_shape;

/* Bytes of such a tile uncoded, rows without gaps: the coded length never
 * exceeds it, and it is at most WIRE_TILE_BYTES_MAX. */
uint32_t wire_tile_bytes(wire_tile_shape shape);

/* Encodes `pixels` (wire_tile_bytes of them) into `to`, `room` bytes. Returns
 * the bytes written and the coder, or 0 when the shortest does not fit. */
uint32_t wire_tile_encode(wire_tile_shape shape, const uint8_t *pixels, uint8_t *to, uint32_t room,
                          unsigned *coder);

/* A tile being decoded, as its bytes come in pieces of any size. */
typedef struct wire_tile_reader {
    wire_tile_shape shape;
    uint8_t coder, x, y;             /* the pixel that comes next */
    uint8_t row[WIRE_ROW_BYTES_MAX]; /* the row that was finished last */
    uint32_t bits;                   /* bits that came and were not used ... */
    uint8_t bit_count, mode[3];
    uint16_t left, run; /* bytes of the tile still to come */
} wire_tile_reader;

enum wire_tile_event {
    WIRE_TILE_MORE = 0,  /* all bytes used, more are needed */
    WIRE_TILE_ROW = 1,   /* row `y - 1` is complete in `row`: take it, call again */
    WIRE_TILE_DONE = 2,  /* the tile is complete; its last row was reported before */
    WIRE_TILE_WRONG = -1 /* no encoder makes such bytes: give the tile up */
};

/* `coded`: bytes of the coded tile. -1 for a coder or shape out of range. */
int wire_tile_begin(wire_tile_reader *reader, wire_tile_shape shape, unsigned coder,
                    uint32_t coded);

/* Goes on with the bytes from `*at` up to `end`, moving `*at`. Reads no byte
 * beyond `end`, writes nothing but `*reader`, and ends after at most
 * width * height pixels whatever the bytes are. */
int wire_tile_read(wire_tile_reader *reader, const uint8_t **at, const uint8_t *end);

#endif
