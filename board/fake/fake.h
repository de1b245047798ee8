/* fake - a board that records everything, and a source and a line of bytes that fail on order
 *
 * For tests. The fake honours the contracts of board.h, wired/serial.h and plt_source to the
 * letter, and records when its caller does not: `broken` counts calls that
 * break the contract and `sentence` says what the last one did. What fails is one of the named
 * modes of three enums; a source or a line that fails still keeps its contract, as hardware
 * does that notices, or does not.
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
    FAKE_STALE_AT_START,     /* the same, and what was there before it stays */
    FAKE_STALLS_AT_START, /* start `at_call` and the next returns -1, as of a queue that is full */
    FAKE_NEVER_ENDS,      /* transfer `at_call` does not: each wait for its tag times out, -1 */
    FAKE_LAST_FIRST,      /* no failure: transfers end in the other order, their bytes, too */
    FAKE_LOSES_BYTE,      /* in transfer `at_call`: those behind it move up, its wait returns 0 */
    FAKE_REPEATS_BYTE,    /* likewise: those behind it move down, and the last is cut off */
    FAKE_FAILURES
};

/* What a test prints of a mode: "fails at start" and so on. */
extern const char *const fake_failure_name[FAKE_FAILURES];

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

    uint32_t dead_tags; /* of FAKE_NEVER_ENDS, for good */
    fake_transfer pending[FAKE_TRANSFERS];
} fake_link;

/* The source over `link`, which must stay where it is. */
plt_source fake_source(fake_link *link);

/* Transfers begun and never waited for. */
unsigned fake_unfinished(const fake_link *link);

/* ---- a board ------------------------------------------------------------- */

enum fake_board_failure {
    FAKE_BOARD_WORKS = 0,
    FAKE_HAS_NO_SCENE,     /* board_scene returns -1 */
    FAKE_REFUSES_FRAME,    /* board_frame_begin returns -1 */
    FAKE_KEEPS_NO_FRAME,   /* no failure: board_frame_end returns NULL */
    FAKE_ARENA_IS_SMALL,   /* FAKE_SMALL_BYTES */
    FAKE_ARENA_IS_SHIFTED, /* a byte behind a multiple of PLT_ALIGN */
    FAKE_ARENA_IS_NULL,
    FAKE_CLOCK_STANDS,
    FAKE_CLOCK_WRAPS, /* while a frame is rendered */
    FAKE_BOARD_FAILURES
};

extern const char *const fake_board_failure_name[FAKE_BOARD_FAILURES];

enum {
    FAKE_ARENA_BYTES = 1 << 20,
    FAKE_SMALL_BYTES = 1000,
    FAKE_TEXT_BYTES = 1 << 14,
    FAKE_PIXELS = 1 << 20,
    FAKE_FRAMES = 64,
    FAKE_TILES = 4096
};

typedef struct fake_frame {
    const uint8_t *rgb; /* width * height * 3 bytes, in fake.pixels */
    uint16_t width, height;
    uint32_t tiles;
} fake_frame;

typedef struct fake_board {
    /* Set these before firmware() runs. */
    plt_source source; /* what board_scene returns */
    enum fake_board_failure failure;

    /* What was recorded. */
    char text[FAKE_TEXT_BYTES]; /* all that was printed, ended by a zero */
    uint32_t text_used;
    fake_frame frames[FAKE_FRAMES]; /* every frame, the last one maybe not whole */
    uint8_t pixels[3 * FAKE_PIXELS];
    uint32_t pixels_used;
    uint8_t painted[FAKE_PIXELS]; /* times that each pixel of the last frame came */
    plt_tile tiles[FAKE_TILES];   /* in order; `rgb` is NULL */
    uint32_t tile_count, frames_begun, frames_ended;
    uint32_t ticks;
    uint32_t broken;
    const char *sentence;
} fake_board;

extern fake_board fake;

void fake_reset(void);

/* The frame that was begun last; of none, one of no size. */
const fake_frame *fake_last_frame(void);

/* ---- a line of bytes ------------------------------------------------------ */

/* Of what the firmware gets; what it sends arrives. */
enum fake_line_failure {
    FAKE_LINE_WORKS = 0,
    FAKE_LINE_LOSES,   /* byte `at` does not come, and is counted */
    FAKE_LINE_DROPS,   /* nor is it counted */
    FAKE_LINE_REPEATS, /* it comes twice */
    FAKE_LINE_GARBLES, /* one bit of it is wrong */
    FAKE_LINE_STALLS,  /* it comes FAKE_STALL_CALLS calls late, as does what follows */
    FAKE_LINE_FILLS,   /* board_serial_put says 0 as often before byte `at` goes out */
    FAKE_LINE_DIES,    /* it does not come, nor does what follows */
    FAKE_LINE_FAILURES
};

extern const char *const fake_line_failure_name[FAKE_LINE_FAILURES];

enum { FAKE_LINE_BYTES = 1 << 14, FAKE_STALL_CALLS = 100 };

/* board_serial_get, _put, _lost and _open are those of this line. */
typedef struct fake_serial {
    /* Set these; `in` may grow while the line is in use. */
    uint8_t in[FAKE_LINE_BYTES]; /* what the other side sends */
    uint32_t in_bytes;
    enum fake_line_failure failure;
    uint32_t at; /* from 1 */
    uint32_t room_bytes;

    /* What was recorded. */
    uint8_t out[FAKE_LINE_BYTES]; /* what the firmware sent */
    uint32_t out_bytes, taken, lost, stalled;
    int is_open, is_repeated;
    uint32_t broken;
    const char *sentence;
} fake_serial;

extern fake_serial fake_line;

#endif
