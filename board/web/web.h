/* web - a page in a browser as a board: memory, time, scenes that the page holds
 *
 * WebAssembly has one memory, which begins with the C stack, then has what is static, and grows at
 * its end when it is asked to. What grows is the room: an image that is mapped, the arena, pixels.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_WEB_H
#define PLT_BOARD_WEB_H

#include <stdint.h>

#include "engine/planelet.h"

/* All of the room is free. */
void web_room_begin(void);

/* Bytes of it, aligned to PLT_ALIGN; what is in them is not known. NULL when the browser gives no
 * more memory. They are kept until the room begins anew, or goes back to before. */
void *web_room_take(uint32_t bytes);

/* Where the room that is free begins; going back there frees all that was taken since. */
uint32_t web_room_mark(void);
void web_room_back(uint32_t mark);

/* Milliseconds since the page began: some browsers give whole ones, others hundredths. */
double web_clock(void);

/* An image of the page that is not mapped: parts are copied when they are asked for. */
void web_scene_of_page(plt_source *source, uint32_t bytes);

/* Paints what is free of the stack; the most bytes ever used since, and its size. The engine's
 * variables mostly lie in the browser's own stack, where nobody can look: this is of those that
 * have an address. A stack that runs over leaves memory, and ends the program (a trap). */
void web_stack_paint(void);
uint32_t web_stack_used(void);
uint32_t web_stack_bytes(void);

#endif
