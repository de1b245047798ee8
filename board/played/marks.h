/* marks - where an instruction counter starts, stops and takes down what it has
 *
 * Functions that do nothing, around every call of the engine that a main loop makes: from _begin
 * to _end is one pass of a region, of which the longest is kept. A frame is over at
 * firmware_frame_done, and so is what came before the first one (board/tools/count.c).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_MARKS_H
#define PLT_BOARD_MARKS_H

void firmware_open_begin(void);
void firmware_open_end(void);
void firmware_read_begin(void);
void firmware_read_end(void);
void firmware_show_begin(void);
void firmware_show_end(void);
void firmware_rebuild_begin(void);
void firmware_rebuild_end(void);
void firmware_render_begin(void);
void firmware_render_end(void);
void firmware_frame_done(void);

#endif
