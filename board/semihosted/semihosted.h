/* semihosted - a board that a debugger or an emulator runs, which gives it files and a screen
 *
 * Of the functions of board/board.h the clock alone is left to the board. The frame lies in
 * memory, if the linker script has room for it (plt_frame_start), else in the file of frame=,
 * row by row, where the run's script hashes it.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SEMIHOSTED_H
#define PLT_SEMIHOSTED_H

#include <stdint.h>

#include "engine/planelet.h"

enum { SEMIHOSTED_PATH_BYTES = 256 };

/* The command line behind the program's name. */
const char *semihosted_parameters(void);

/* Prints "error: the WHAT has N bytes; this board has room for M" and returns -1. */
int semihosted_too_large(const char *what, uint64_t bytes, uint64_t room);

/* The board's panel, or none: -1 after a printed line, if hold= asks for what it cannot show. */
int semihosted_panel_begin(uint16_t width, uint16_t height);
void semihosted_panel_tile(const plt_tile *tile);
void semihosted_panel_end(const char *parameters);

/* Prints the sentence and returns -1. */
int semihosted_complain(const char *sentence);

#endif
