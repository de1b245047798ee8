/* board - the functions of board/board.h, in the order in which they are called, for a new board
 *
 * As they are, they show and print nothing. board/semihosted gives all of them but the clock to
 * boards that a debugger runs: take that for the first picture, and write these one by one.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "platform/bare/start.h"

/* The section is what the linker script looks for; its size is ARENA_BYTES of board.mk. */
__attribute__((section(".arena"),
               aligned(PLT_ALIGN))) static unsigned char arena[PLT_BOARD_ARENA_BYTES];

extern uint8_t plt_scene_start[], plt_scene_end[];

/* 1. Comes from machine_start, with memory set up. Turns on clocks and what board_print needs, runs
 * the program once, and ends with its status. */
_Noreturn void machine_main(void) {
    machine_exit(firmware(""));
}

/* 2. The first sign of life: a UART, a debugger. Before it works, nothing else is worth a try. */
void board_print(const char *text) {
    (void)text;
}

/* 3. The name of the folder. */
const char *board_name(void) {
    return PLT_BOARD_NAME;
}

/* 4. */
unsigned char *board_arena(size_t *bytes) {
    *bytes = sizeof arena;
    return arena;
}

/* 5. Where the scene is. Fetched: the two functions (plt_source in engine/planelet.h), whose names
 * board.mk has in SOURCE_FUNCTIONS, as they are called by pointer. Mapped: source->mapped is its
 * address, a multiple of PLT_ALIGN; the functions stay as they are, never called, as the stack
 * bound wants a place where calls by pointer lead. Whether it is a scene the engine finds out. */
static int scene_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    (void)context;
    (void)tag;
    (void)offset;
    (void)to;
    (void)count;
    return -1;
}

static int scene_wait(void *context, uint32_t tags) {
    (void)context;
    (void)tags;
    return -1;
}

int board_scene(const char *parameters, plt_source *source) {
    (void)parameters;
    source->bytes = (uint32_t)((uintptr_t)plt_scene_end - (uintptr_t)plt_scene_start);
    source->start = scene_start;
    source->wait = scene_wait;
    return 0;
}

/* 6. Before the first tile: -1, and a printed line that names both sizes, if the frame has no
 * room. */
int board_frame_begin(uint16_t width, uint16_t height) {
    (void)width;
    (void)height;
    return 0;
}

/* 7. Copies or sends tile->width * tile->height pixels of three bytes, rows top down, which belong
 * at (tile->x, tile->y) of the frame. They are gone when it returns: a DMA must have ended. */
void board_tile(const plt_tile *tile) {
    (void)tile;
}

/* 8. All tiles have come. NULL: the board keeps no frame. */
const uint8_t *board_frame_end(const char *parameters) {
    (void)parameters;
    return NULL;
}

/* 9. A counter of 32 bits that goes up and may wrap, and how fast it is. */
uint32_t board_ticks(void) {
    return 0;
}

uint32_t board_ticks_per_second(void) {
    return 1;
}

/* 10. As it is: the paint of reset tells. */
void board_stack(uint32_t *used_bytes, uint32_t *size_bytes) {
    machine_stack(used_bytes, size_bytes);
}

/* 11. For last words of a fault: without interrupts, and with little stack. */
void machine_print(const char *text) {
    board_print(text);
}

/* 12. Resets, sleeps, or tells the debugger. */
_Noreturn void machine_exit(int status) {
    (void)status;
    for (;;) {
    }
}
