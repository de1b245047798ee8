/* frame_reader - a run of bytes of the source, front to back, through a small window
 *
 * Of a source that is not mapped: while one half is read, the other one is filled. What a half ends
 * with in the middle is brought in front of the other, where there is room for it.
 *
 * Invariant: no transfer is on its way when plt_frame_reader_settle has returned.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_FRAME_READER_H
#define PLT_MOTION_FRAME_READER_H

#include "engine/motion/frame_block.h"
#include "engine/planelet.h"

/* Bytes of a half, and of the room before it: for a block that lacks a byte. */
enum {
    PLT_FRAME_HALF_BYTES = PLT_TRANSFER_BYTES < 2048 ? PLT_TRANSFER_BYTES / 4 * 4 : 2048,
    PLT_FRAME_BEFORE_BYTES = PLT_FRAME_BLOCK_MOST + 12,
    PLT_FRAME_WINDOW_BYTES =
        2 * (PLT_FRAME_BEFORE_BYTES + PLT_FRAME_HALF_BYTES) + PLT_BITS_BEHIND + 8
};

typedef struct plt_frame_reader {
    const plt_source *source;
    unsigned char *window;   /* PLT_FRAME_WINDOW_BYTES; NULL: the source is mapped */
    const unsigned char *at; /* the next byte */
    uint32_t offset, end;    /* of that byte in the image; of the first byte behind the run */
    uint32_t there;          /* bytes from `at` on that have come */
    uint32_t started;        /* bytes that are on their way, or have come, into the other half */
    uint8_t half;            /* that `at` is in, or was */
    uint8_t is_moving;       /* those bytes are on their way */
} plt_frame_reader;

/* From `offset` of the image to `end`, which is not before it; both are multiples of 4. */
void plt_frame_reader_begin(plt_frame_reader *r, uint32_t offset, uint32_t end);

/* Where the next `bytes` lie, PLT_FRAME_BLOCK_MOST at most and all within the run, until the next
 * call; bits may be read up to PLT_BITS_BEHIND bytes further. NULL: the source failed. */
const unsigned char *plt_frame_reader_need(plt_frame_reader *r, uint32_t bytes);

/* Goes on behind bytes that were needed. */
void plt_frame_reader_skip(plt_frame_reader *r, uint32_t bytes);

/* Waits for what is on its way. */
void plt_frame_reader_settle(plt_frame_reader *r);

#endif
