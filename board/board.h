/* board - what the firmware asks of a device, and the device of the firmware
 *
 * A board is a folder: board.mk (compiler, CPU flags, arena and stack bytes,
 * how it is run), a linker script, and the functions below. The firmware
 * (firmware.c) is the same on every board; it calls nothing else outside the
 * engine and the small files beside it. Nothing here is called from an
 * interrupt. platform/PORTING.md leads through a new board.
 *
 * Order of calls: start-up, then firmware(), which calls
 *   board_arena  board_scene  { board_frame_begin  board_tile*  board_frame_end }
 * with board_print, board_ticks and board_stack at any time.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_H
#define PLT_BOARD_H

#include <stddef.h>
#include <stdint.h>

#include "engine/planelet.h"

/* ---- given by the firmware ----------------------------------------------- */

enum firmware_status {
    FIRMWARE_DONE = 0,
    FIRMWARE_FAILED = 1, /* the scene, the arena or the frame: a line was printed */
    FIRMWARE_USAGE = 2   /* a parameter is wrong: a line was printed */
};

/* The whole program; the board calls it once, when board_print works, and
 * ends with its status. `parameters` is a line of key=value items separated by
 * spaces ("" is allowed; firmware.c lists the keys) and stays as it is. */
int firmware(const char *parameters);

/* ---- given by the board --------------------------------------------------- */

/* Name of the board as in board/NAME, in static storage. */
const char *board_name(void);

/* The arena: one static array of PLT_BOARD_ARENA_BYTES, aligned to PLT_ALIGN,
 * which the board does not touch again. */
unsigned char *board_arena(size_t *bytes);

/* Where the scene image lies; called once. Fills `source`, which must stay
 * valid until the program ends. On failure prints a line that says why and returns -1. */
int board_scene(const char *parameters, plt_source *source);

/* A frame of this size comes next. -1 after a printed line when the board
 * has no room for it; then no tile follows. */
int board_frame_begin(uint16_t width, uint16_t height);

/* A finished tile: copied or sent before the call returns, as its bytes are
 * the engine's. Every pixel of the frame comes exactly once, in any order. */
void board_tile(const plt_tile *tile);

/* The frame is complete. Returns its width * height * 3 bytes, rows top down
 * without gaps, valid until the next board_frame_begin, or NULL on a board
 * that sends tiles away and keeps none (what shows them hashes the frame).
 * Shows or stores the frame as `parameters` ask. */
const uint8_t *board_frame_end(const char *parameters);

/* Prints text as it is; lines end in '\n'. Must not fail. */
void board_print(const char *text);

/* A clock that counts up and wraps at 2^32, and its speed. */
uint32_t board_ticks(void);
uint32_t board_ticks_per_second(void);

/* The C stack: most bytes ever used (found by painting) and its size.
 * 0 and 0 on a board that does not know. */
void board_stack(uint32_t *used_bytes, uint32_t *size_bytes);

#endif
