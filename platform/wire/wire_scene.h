/* wire_scene - a scene image from one peer into the memory of the other
 *
 * The receiver says from which byte on it needs the image; the sender begins
 * there. An image is known by its size and checksum, and one that was half there
 * goes on where it stopped: a cut costs only what was on its way.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_SCENE_H
#define PLT_WIRE_SCENE_H

#include "platform/wire/wire_frames.h"

#ifdef __cplusplus
extern "C" {
#endif

enum wire_scene_state {
    WIRE_SCENE_NONE = 0,    /* nothing offered yet */
    WIRE_SCENE_GOING = 1,   /* bytes are coming */
    WIRE_SCENE_HERE = 2,    /* all bytes are there and the checksum is right */
    WIRE_SCENE_LARGE = 3,   /* it does not fit */
    WIRE_SCENE_OPEN = 4,    /* the engine opened it */
    WIRE_SCENE_REFUSED = 5, /* the engine refused it: wire_error_read says why */
    WIRE_SCENE_BLOCKS = 6   /* it stays with its peer, which is asked for blocks of it */
};

/* ---- out ----------------------------------------------------------------------- */

typedef struct wire_scene_out {
    wire_peer *peer;
    const uint8_t *image;
    uint32_t bytes, crc, at, other_has, asked_ms;
    uint8_t state, is_known, careful;
    wire_queue own_queue; /* of a peer that sends no frames */
} wire_scene_out;

/* Offers `image` at every session from now on; it stays where it is. Costs a
 * checksum of the whole image. `image` NULL: none. */
void wire_scene_out_open(wire_scene_out *out, wire_peer *peer, const void *image, uint32_t bytes);

/* enum wire_scene_state as the other peer last said; bytes it has in `*has`. */
unsigned wire_scene_out_state(const wire_scene_out *out, uint32_t *has);

/* ---- in ------------------------------------------------------------------------ */

typedef struct wire_scene_in {
    wire_peer *peer;
    uint8_t *to;
    uint32_t room, bytes, crc, has, sum;
    uint32_t at, said_ms; /* offset of the bytes that come next */
    uint8_t state, is_missed, is_deaf;
    uint8_t takes_blocks; /* what does not fit may stay out */
    uint8_t is_held;      /* `to` is in use: no other image may come now ... */
    uint8_t is_replaced;  /* ... and one was offered */
} wire_scene_in;

/* Receives an image of at most `room` bytes into `to`. */
void wire_scene_in_open(wire_scene_in *in, wire_peer *peer, void *to, uint32_t room);

/* Images that have no room are taken all the same, as WIRE_SCENE_BLOCKS, from peers that can be
 * asked for blocks (wire_block.h). Nothing of them comes by itself. */
void wire_scene_in_blocks(wire_scene_in *in);

/* WIRE_SCENE_HERE: the image lies whole in `to`, `*bytes` of it. */
unsigned wire_scene_in_state(const wire_scene_in *in, uint32_t *bytes);

/* After HERE or BLOCKS: says what became of it (WIRE_SCENE_OPEN, _REFUSED, _LARGE; _BLOCKS after
 * HERE, and _NONE: let it be offered again). The
 * memory may be used from REFUSED on; a new offer then overwrites it. */
void wire_scene_in_verdict(wire_scene_in *in, unsigned state);

/* ---- views --------------------------------------------------------------------- */

/* Of a view: what devices that are older, or whose engine is built without it, leave out. */
enum wire_view_more { WIRE_VIEW_BACKGROUND = 1, WIRE_VIEW_SAMPLES = 2 };

/* Per pixel. Others, up to 15, are refused. */
enum wire_samples {
    WIRE_SAMPLES_ONE = 0,
    WIRE_SAMPLES_FOUR = 1,
    WIRE_SAMPLES_SIXTEEN = 2,
    WIRE_SAMPLES_ADAPTIVE = 3
};

/* What to render: floats as in plt_camera, and the rest as in plt_frame. */
typedef struct wire_view {
    float eye[3], look[3], up[3], tan_half_fov;
    uint8_t shader;
    uint8_t samples; /* enum wire_samples */
    uint8_t has_background, background[3];
    uint8_t number; /* counts views; filled in by wire_view_send */
} wire_view;

typedef struct wire_view_out {
    wire_peer *peer;
    wire_view view;
    uint32_t sent_ms;
    uint8_t have, is_set;
    uint8_t obeyed; /* enum wire_view_more, as the device has said; once it has */
} wire_view_out;

typedef struct wire_view_in {
    wire_view view;
    uint8_t fresh;
    uint8_t obeys; /* enum wire_view_more: set by whoever renders */
} wire_view_in;

void wire_view_out_open(wire_view_out *out, wire_peer *peer);

/* Sends a view, at once and at every later session; the latest wins. */
void wire_view_send(wire_view_out *out, const wire_view *view);

/* What the latest view asks for and its device leaves out: enum wire_view_more. 0: nothing, or the
 * device has not answered. */
unsigned wire_view_left_out(const wire_view_out *out);

void wire_view_in_open(wire_view_in *in, wire_peer *peer);

/* 1: a view came since the last call, and is in `view->view`. */
int wire_view_read(wire_view_in *in);

#ifdef __cplusplus
}
#endif
#endif
