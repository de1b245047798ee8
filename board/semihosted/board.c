/* board - see semihosted.h: the program's begin and end, its arena, stack and text
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "board/line.h"
#include "board/semihosted/semihosted.h"
#include "platform/bare/semihost.h"
#include "platform/bare/start.h"

/* Of the command line; a board with little RAM may say less. */
#ifndef PLT_COMMAND_LINE_BYTES
#define PLT_COMMAND_LINE_BYTES 1024
#endif

__attribute__((section(".arena"),
               aligned(PLT_ALIGN))) static unsigned char arena[PLT_BOARD_ARENA_BYTES];
static char command_line[PLT_COMMAND_LINE_BYTES];

const char *board_name(void) {
    return PLT_BOARD_NAME;
}

unsigned char *board_arena(size_t *bytes) {
    *bytes = sizeof arena;
    return arena;
}

void board_print(const char *text) {
    semihost_print(text);
}

void board_stack(uint32_t *used_bytes, uint32_t *size_bytes) {
    machine_stack(used_bytes, size_bytes);
}

void machine_print(const char *text) {
    semihost_print(text);
}

_Noreturn void machine_exit(int status) {
    semihost_exit(status);
}

int semihosted_complain(const char *sentence) {
    board_print(sentence);
    return -1;
}

int semihosted_too_large(const char *what, uint64_t bytes, uint64_t room) {
    line l;
    line_start(&l);
    line_text(&l, "error: ");
    line_text(&l, what);
    line_text(&l, " has ");
    line_u64(&l, bytes);
    line_text(&l, " bytes, and this board has room for ");
    line_u64(&l, room);
    line_print(&l);
    return -1;
}

const char *semihosted_parameters(void) {
    const char *at = command_line;
    while (*at && *at != ' ') {
        at++;
    }
    return at;
}

_Noreturn void machine_main(void) {
    if (semihost_command_line(command_line, sizeof command_line) < 0) {
        line l;
        line_start(&l);
        line_text(&l, "error: the command line is longer than ");
        line_u64(&l, sizeof command_line - 1);
        line_text(&l, " characters");
        line_print(&l);
        semihost_exit(FIRMWARE_USAGE);
    }
    semihost_exit(firmware(semihosted_parameters()));
}
