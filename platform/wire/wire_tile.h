/* wire_tile - the codec: one tile of at most 16 x 16 pixels to bytes and back
 *
 * A tile coded without `old` stands for itself: nothing of another tile or
 * frame is needed to decode it, so a lost one leaves the old pixels and harms
 * no other. With `old`, what the panel shows is known to both peers (it was
 * acknowledged) and only what differs is coded; that needs a panel that can
 * be read. The encoder chooses the shortest of the coders. WIRE.md, section 5,
 * has every bit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_TILE_H
#define PLT_WIRE_TILE_H

#include <stddef.h>
#include <stdint.h>

#include "platform/wire/model.h"
#include "platform/wire/range.h"
#include "platform/wire/wire_format.h"

#ifdef __cplusplus
extern "C" {
#endif

enum wire_coder {
    WIRE_RAW = 0,     /* rows as they are */
    WIRE_SOLID = 1,   /* one pixel */
    WIRE_RUNS = 2,    /* lengths and pixels */
    WIRE_PREDICT = 3, /* what a prediction from the neighbours got wrong */
    WIRE_CODERS = 4
};

/* Largest error bound, in steps of the format: of 63 and 31, or of 255. The
 * formats grey4 and mono1 are always exact. */
enum { WIRE_NEAR_MOST = 15 };

/* Bytes of such a tile uncoded, rows without gaps: the coded length never
 * exceeds it, and it is at most WIRE_TILE_BYTES_MAX. 0: shape out of range. */
uint32_t wire_tile_bytes(wire_tile_shape shape);

/* Encodes `pixels` (wire_tile_bytes of them) into `to`, `room` bytes. `old`:
 * what the panel shows there now, or NULL. `near` 0: exact; else a sample may
 * be off by so many steps, and `pixels` becomes what the decoder will find.
 * Returns the bytes written and the coder, or 0 when the shortest does not
 * fit. Stack: about 500 bytes. */
uint32_t wire_tile_encode(wire_tile_shape shape, uint8_t *pixels, const uint8_t *old, unsigned near,
                          uint8_t *to, uint32_t room, unsigned *coder);

enum { WIRE_HELD_BYTES = 32 };

/* A tile being decoded, as its bytes come in pieces of any size. */
typedef struct wire_tile_reader {
    const uint8_t *old; /* rows of the panel there, `old_stride` bytes apart, or NULL */
    uint32_t old_stride;
    wire_tile_shape shape;
    uint8_t coder, y;  /* rows that were finished */
    uint8_t unit, run; /* bytes of a run's unit; units to come of this run */
    uint8_t is_run, held, started;
    uint16_t left, row_used; /* bytes of the tile still to come; of the row that are there */
    wire_range range;
    uint8_t held_bytes[WIRE_HELD_BYTES]; /* of the code, as a ring: a pixel is decoded whole */
    union {
        wire_model model;
        uint8_t row[WIRE_ROW_BYTES_MAX + 4]; /* and a pixel that repeats */
    } as;
} wire_tile_reader;

enum wire_tile_event {
    WIRE_TILE_MORE = 0,  /* all bytes used, more are needed */
    WIRE_TILE_ROW = 1,   /* a row is complete: wire_tile_row, then call again */
    WIRE_TILE_DONE = 2,  /* the tile is complete; its last row was reported before */
    WIRE_TILE_WRONG = -1 /* no encoder makes such bytes: give the tile up */
};

/* `coded`: bytes of the coded tile. `old` (may be NULL): rows of the panel at
 * the tile's position; a row is not read after it was reported. -1: a coder,
 * shape or length out of range. */
int wire_tile_begin(wire_tile_reader *reader, wire_tile_shape shape, unsigned coder, uint32_t coded,
                    const uint8_t *old, uint32_t old_stride);

/* Goes on with the bytes from `*at` up to `end`, moving `*at`; an enum
 * wire_tile_event. Reads no byte beyond `end` or `coded`, writes nothing but
 * `*reader`, and reports at most `height` rows whatever the bytes are. */
int wire_tile_read(wire_tile_reader *reader, const uint8_t **at, const uint8_t *end);

/* The row just completed, number reader->y - 1, into `to`:
 * wire_row_bytes(format, width) bytes. */
void wire_tile_row(const wire_tile_reader *reader, uint8_t *to);

#ifdef __cplusplus
}
#endif
#endif
