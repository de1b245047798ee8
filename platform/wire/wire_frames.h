/* wire_frames - frames from one peer onto the panel of the other
 *
 * The sender keeps no copy of any frame, only a hash of each tile as it was last
 * sent, and which frame carried it until that is answered. The receiver
 * keeps no frame at all: it decodes straight into the panel.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_FRAMES_H
#define PLT_WIRE_FRAMES_H

#include "platform/wire/wire_peer.h"
#include "platform/wire/wire_tile.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Most tiles of a panel that a sender can keep: 480 x 272 pixels are 510.
 * Each costs the sender 4.375 bytes and the receiver a bit; both peers check. */
#ifndef WIRE_TILES_MAX
#define WIRE_TILES_MAX 512
#endif

/* ---- frames out -------------------------------------------------------------- */

enum { WIRE_QUEUE_BYTES = 788 }; /* the longest tile with its head, and a frame end */

/* Messages on their way into reports. */
typedef struct wire_queue {
    uint16_t used, gone; /* bytes */
    uint16_t left;       /* of the message that is going */
    uint8_t bytes[WIRE_QUEUE_BYTES];
} wire_queue;

typedef struct wire_frames_out {
    wire_peer *peer;
    const uint8_t *rgb; /* the caller's frame, when there is one */
    uint8_t *reference; /* the caller's memory for what the panel shows, or NULL */
    uint32_t stride, reference_bytes;
    uint32_t crc;               /* of the tiles of this frame */
    uint32_t end_number;        /* of the report that ended the frame not yet answered */
    uint32_t waiting_ms;        /* since that report was acknowledged */
    uint32_t begun_ms, over_ms; /* of the pass over the last new frame */
    uint16_t goal_ms;           /* of such a pass; 0: near is fixed */
    uint16_t width, height, columns, tiles, next, scanned, sent, refresh;
    uint8_t format, near, mark;
    uint8_t number;     /* of the frame that goes out or comes next: 0 .. 5 */
    uint8_t unanswered; /* frames before it without an answer: 0 .. 3 */
    uint8_t in_frame, is_cut, is_fresh, is_exact_pass, is_waiting, is_whole;
    uint8_t is_timed, is_refining;
    uint32_t hash[WIRE_TILES_MAX];      /* of the pixels last sent, without an error; 0: send it */
    uint8_t slot[WIRE_TILES_MAX / 4];   /* 2 bits per tile: 0 acknowledged, else which frame */
    uint8_t coarse[WIRE_TILES_MAX / 8]; /* sent with an error */
    uint8_t pixels[WIRE_TILE_BYTES_MAX];
    wire_queue queue;
} wire_frames_out;

/* Gives `peer` the service that sends frames; it works whenever a session is up
 * and the other peer shows. `out` belongs to `peer` from then on. */
void wire_frames_out_open(wire_frames_out *out, wire_peer *peer);

/* Lets wire_frames_show say only what differs from what the panel shows, on
 * panels that can be read (WIRE_READS). `reference`: `bytes` of the caller's
 * memory, wire_row_bytes(format, width) * height at least, or it is not used. */
void wire_frames_reference(wire_frames_out *out, uint8_t *reference, uint32_t bytes);

/* While frames move, samples may be off by `near` steps of the panel's format
 * (0 .. WIRE_NEAR_MOST; 0, the default, is exact). Tiles sent so are sent
 * again exactly when wire_frames_show has had nothing newer for a tenth of a
 * second. */
void wire_frames_near(wire_frames_out *out, unsigned near);

/* The same with a bound that the sender chooses from frame to frame: as small
 * as lets `frames_per_second` (more than 1000 are 1000; 0: exact) through, but no
 * more than 6 for RGB565 and 15 for 8 bits: slower links show fewer. It begins
 * exact. */
void wire_frames_rate(wire_frames_out *out, unsigned frames_per_second);

/* A whole frame, for peers that have one: rows of 3 bytes per pixel, top down,
 * `stride` bytes apart, of the other peer's panel size. What changed goes out
 * as credits allow; what is lost goes out again by itself. The memory is read
 * until the next call (NULL: no frame any more), so do not change it while
 * wire_frames_out_idle() is 0. Called earlier, the latest frame wins: tiles not
 * yet sent come from the new one. Returns WIRE_OK, or
 * WIRE_ERR_DOWN when there is nobody to show it (the frame is not kept). */
int wire_frames_show(wire_frames_out *out, const uint8_t *rgb, uint32_t stride);

/* Tile by tile, for peers that have no whole frame. Begin, each tile (any order, any
 * subset; a tile of the 16 x 16 raster, `rgb` 3 bytes per pixel, only read
 * during the call; unchanged ones cost a hash), end. Each returns WIRE_OK,
 * WIRE_BUSY (let wire_next_report run, then call again), WIRE_ERR_DOWN, or
 * WIRE_ERR_SETUP for a tile that is not in the raster. A frame can begin
 * when the one before was answered: one that comes whole makes the picture whole.
 * `mark`: a byte for the other peer, wire_frames_mark. */
int wire_frame_begin(wire_frames_out *out, unsigned mark);
int wire_frame_tile(wire_frames_out *out, unsigned x, unsigned y, const uint8_t *rgb,
                    uint32_t stride);
int wire_frame_end(wire_frames_out *out);

/* Everything of the frame has been handed to reports: time for the next. */
int wire_frames_out_idle(const wire_frames_out *out);

/* The other peer has acknowledged every tile as it is now: every pixel of its
 * panel is that of the last frame. */
int wire_frames_out_done(const wire_frames_out *out);

/* Sends every tile again, as at the start of a session. */
void wire_frames_forget(wire_frames_out *out);

/* ---- frames in --------------------------------------------------------------- */

/* A panel: memory, or the window of a display controller, into which rows are
 * written. With `pixels` NULL, `row` gets `width` pixels that
 * begin at (x, y), x a multiple of 16: wire_row_bytes(format, width) bytes,
 * valid during the call. It is never called for a position outside the panel. */
typedef struct wire_panel {
    uint8_t *pixels;
    uint32_t stride; /* bytes from row to row of `pixels` */
    void (*row)(void *context, unsigned x, unsigned y, unsigned width, const uint8_t *pixels);
    void *context;
} wire_panel;

typedef struct wire_frames_in {
    wire_peer *peer;
    wire_panel panel;
    uint32_t crc, shown; /* frames that came whole, since open */
    uint16_t tile, columns, tiles, came;
    uint8_t number, is_any, in_frame, in_tile, is_torn, is_good;
    uint8_t answer; /* to send: 0 none, 1 good, 2 bad */
    uint8_t answer_number, answer_part, answer_more, mark;
    uint8_t got[WIRE_TILES_MAX / 8]; /* tiles of the frame that came whole */
    wire_tile_reader reader;
} wire_frames_in;

/* Gives `peer` the service that receives frames, of the size and format of its
 * capabilities. The panel is written only from wire_on_report. WIRE_ERR_SETUP:
 * the peer does not show, or has more than WIRE_TILES_MAX tiles. */
int wire_frames_in_open(wire_frames_in *in, wire_peer *peer, const wire_panel *panel);

/* Frames that came whole since open, each with the right checksum. */
uint32_t wire_frames_shown(const wire_frames_in *in);

/* The mark of the last of them. */
unsigned wire_frames_mark(const wire_frames_in *in);

#ifdef __cplusplus
}
#endif
#endif
