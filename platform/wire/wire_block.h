/* wire_block - pieces of a scene image on request, for scenes that stay out
 *
 * One peer asks for `count` bytes from `offset` under a tag; the other sends
 * them in pieces. What is lost is asked for again: requests are idempotent. A request
 * for which nothing comes any more ends, and so does a wait for it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_BLOCK_H
#define PLT_WIRE_BLOCK_H

#include "platform/wire/wire_scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Requests at a time. One is repeated after AGAIN_MS without a byte, or later, up to SLOW_MS, where
 * bytes are seen to come twice for that; and given up when no request has had a byte for DEAD_MS,
 * or it has lasted MOST_MS: after 300 repeats at most. */
enum {
    WIRE_BLOCKS = 8,
    WIRE_BLOCK_AGAIN_MS = 100,
    WIRE_BLOCK_SLOW_MS = 1000,
    WIRE_BLOCK_DEAD_MS = 5000,
    WIRE_BLOCK_MOST_MS = 30000
};

/* ---- out: the peer that has the image ---------------------------------------------- */

typedef struct wire_block_order {
    uint32_t offset, count; /* still to send */
    uint8_t tag, live;
} wire_block_order;

typedef struct wire_blocks_out {
    wire_peer *peer;
    const uint8_t *image;
    uint32_t bytes, crc;
    uint64_t sent;  /* bytes of the image, those sent again counted again */
    uint32_t asked; /* requests that were served, repeated ones counted again */
    wire_block_order order[WIRE_BLOCKS];
    uint32_t refused;
    uint8_t next_order, refused_tag;
    wire_queue own_queue; /* of a peer that sends neither frames nor scenes */
} wire_blocks_out;

/* Answers requests for bytes of `image`, which stays where it is. Requests for an image of
 * another checksum are not answered. Costs a checksum of the whole image. */
void wire_blocks_out_open(wire_blocks_out *out, wire_peer *peer, const void *image, uint32_t bytes);

/* ---- in: the peer that asks ---------------------------------------------------------- */

typedef struct wire_block_want {
    uint8_t *to;
    uint32_t offset, count, has; /* bytes from the start that are there */
    uint32_t asked_ms, begun_ms;
    uint8_t tag, state; /* 0 free, 1 to ask, 2 asked, 3 done, 4 failed */
} wire_block_want;

typedef struct wire_blocks_in {
    wire_peer *peer;
    wire_block_want want[WIRE_BLOCKS];
    uint32_t at;       /* of the bytes that come next */
    uint32_t crc;      /* of the image that is asked for */
    uint32_t moved_ms; /* when a byte of any request came last */
    uint8_t coming, is_named;
    uint16_t more_ms; /* than AGAIN_MS until a request is repeated */
    /* For wire_source_wait: moves reports until something happens, or returns
     * -1 to give up. */
    int (*pump)(void *context);
    void *pump_context;
} wire_blocks_in;

void wire_blocks_in_open(wire_blocks_in *in, wire_peer *peer, int (*pump)(void *), void *context);

/* Names the image that is asked for by the checksum of its offer, so that no other host's
 * bytes come. Without a name any image's do. */
void wire_blocks_in_image(wire_blocks_in *in, uint32_t crc);

/* Asks. `to` gets the bytes; WIRE_BUSY when WIRE_BLOCKS were asked for and not forgotten. */
int wire_block_ask(wire_blocks_in *in, unsigned tag, uint32_t offset, void *to, uint32_t count);

/* Of all requests of the tags in `tags` (bit n: tag n): WIRE_OK all are there
 * (and are forgotten), WIRE_BUSY some are on the way, WIRE_ERR_DOWN (all are forgotten) one was
 * refused by the other peer, or did not come in time. Requests outlive sessions. */
int wire_block_state(wire_blocks_in *in, uint32_t tags);

/* Forgets requests, there or not: nothing is written to their memory from then on. */
void wire_block_forget(wire_blocks_in *in, uint32_t tags);

/* The two functions of plt_source, `context` a wire_blocks_in. At most WIRE_BLOCKS transfers
 * between two waits; after a wait, failed or not, none of its tags is on the way. */
int wire_source_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count);
int wire_source_wait(void *context, uint32_t tags);

#ifdef __cplusplus
}
#endif
#endif
