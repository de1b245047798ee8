/* wire_block - pieces of a scene image on request, for scenes that stay out
 *
 * One peer asks for `count` bytes from `offset` under a tag; the other sends
 * them in pieces. What is lost is asked for again: requests are idempotent.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_BLOCK_H
#define PLT_WIRE_BLOCK_H

#include "platform/wire/wire_scene.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { WIRE_BLOCKS = 8, WIRE_BLOCK_AGAIN_MS = 100 };

/* ---- out: the peer that has the image ---------------------------------------------- */

typedef struct wire_block_order {
    uint32_t offset, count; /* still to send */
    uint8_t tag, live;
} wire_block_order;

typedef struct wire_blocks_out {
    wire_peer *peer;
    const uint8_t *image;
    uint32_t bytes;
    wire_block_order order[WIRE_BLOCKS];
    uint32_t refused;
    uint8_t next_order, refused_tag;
    wire_queue own_queue; /* of a peer that sends neither frames nor scenes */
} wire_blocks_out;

/* Answers requests for bytes of `image`, which stays where it is. */
void wire_blocks_out_open(wire_blocks_out *out, wire_peer *peer, const void *image, uint32_t bytes);

/* ---- in: the peer that asks ---------------------------------------------------------- */

typedef struct wire_block_want {
    uint8_t *to;
    uint32_t offset, count, has; /* bytes from the start that are there */
    uint32_t asked_ms;
    uint8_t tag, state; /* 0 free, 1 to ask, 2 asked, 3 done, 4 refused */
} wire_block_want;

typedef struct wire_blocks_in {
    wire_peer *peer;
    wire_block_want want[WIRE_BLOCKS];
    uint32_t at; /* of the bytes that come next */
    uint8_t coming;
    /* For wire_source_wait: moves reports until something happens, or returns
     * -1 to give up. */
    int (*pump)(void *context);
    void *pump_context;
} wire_blocks_in;

void wire_blocks_in_open(wire_blocks_in *in, wire_peer *peer, int (*pump)(void *), void *context);

/* Asks. `to` gets the bytes; WIRE_BUSY when WIRE_BLOCKS are on the way. */
int wire_block_ask(wire_blocks_in *in, unsigned tag, uint32_t offset, void *to, uint32_t count);

/* Of all requests of the tags in `tags` (bit n: tag n): WIRE_OK all are there
 * (and are forgotten), WIRE_BUSY some are on the way, WIRE_ERR_DOWN one was
 * refused by the other peer. Requests outlive sessions. */
int wire_block_state(wire_blocks_in *in, uint32_t tags);

/* The two functions of plt_source, `context` a wire_blocks_in. */
int wire_source_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count);
int wire_source_wait(void *context, uint32_t tags);

#ifdef __cplusplus
}
#endif
#endif
