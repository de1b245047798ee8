/* fake - a board that records everything, and a source that fails on order
 *
 * For tests. The fake honours the contracts of board.h and plt_source to the
 * letter, and records when its caller does not: `broken` counts calls that
 * break the contract and `sentence` says what the last one did.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_FAKE_H
#define PLT_BOARD_FAKE_H

#include <stddef.h>
#include <stdint.h>

#include "board/board.h"

/* ---- a source ------------------------------------------------------------ */

enum fake_failure {
    FAKE_WORKS = 0,
    FAKE_FAILS_AT_START,     /* start number `at_call` returns -1 */
    FAKE_FAILS_AT_WAIT,      /* wait number `at_call` returns -1 */
    FAKE_FAILS_AT_CALL,      /* the same, starts and waits counted together */
    FAKE_FAILS_FROM_CALL,    /* and every call after it: the link is cut */
    FAKE_SHORT_AT_START,     /* transfer `at_call` delivers half, its wait returns -1 */
    FAKE_GARBLED_AT_START,   /* transfer `at_call` has one bit wrong, its wait returns 0 */
    FAKE_GARBLED_FROM_START, /* and so has every one after it */
    FAKE_SILENT_AT_START,    /* transfer `at_call` delivers nothing, its wait returns 0 */
    FAKE_STALE_AT_START      /* the same, and what was there before it stays */
};

enum { FAKE_TRANSFERS = 64 };

typedef struct fake_transfer {
    uint32_t tag_bit; /* 0: free */
    uint32_t offset, count, number;
    unsigned char *to;
} fake_transfer;

/* Zero it, set the first group, then call fake_source. */
typedef struct fake_link {
    const unsigned char *image;
    uint32_t bytes;
    const void *arena; /* transfers but the header's must lie in it; NULL: anywhere */
    size_t arena_bytes;
    enum fake_failure failure;
    uint32_t at_call; /* from 1 */
    int at_once;      /* bytes come at start; else at wait, garbage before */

    uint32_t starts, waits, failed; /* what happened */
    uint32_t pending_most;          /* transfers at once */
    uint64_t bytes_moved;
    uint32_t broken;
    const char *sentence;

    fake_transfer pending[FAKE_TRANSFERS];
} fake_link;

/* The source over `link`, which must stay where it is. */
plt_source fake_source(fake_link *link);

/* Transfers begun and never waited for. */
unsigned fake_unfinished(const fake_link *link);

/* ---- a board ------------------------------------------------------------- */

enum {
    FAKE_ARENA_BYTES = 1 << 20,
    FAKE_TEXT_BYTES = 1 << 14,
    FAKE_FRAME_BYTES = 1 << 20,
    FAKE_TILES = 4096
};

typedef struct fake_board {
    /* Set these before firmware() runs. */
    plt_source source;  /* what board_scene returns */
    int scene_fails;    /* board_scene returns -1 */
    int frame_fails;    /* board_frame_begin returns -1 */
    int keeps_no_frame; /* board_frame_end returns NULL */

    /* What was recorded. */
    char text[FAKE_TEXT_BYTES]; /* all that was printed, ended by a zero */
    uint32_t text_used;
    uint8_t frame[FAKE_FRAME_BYTES];
    uint8_t painted[FAKE_FRAME_BYTES / 3]; /* times each pixel came */
    uint16_t width, height;
    plt_tile tiles[FAKE_TILES]; /* in order; `rgb` is NULL */
    uint32_t tile_count, frames_begun, frames_ended;
    uint32_t broken;
    const char *sentence;
} fake_board;

extern fake_board fake;

void fake_reset(void);

#endif
