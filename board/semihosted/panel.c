/* panel - of a semihosted board that has one (board/panel.h), and what others say for it
 *
 * hold=PATH: what is shown stays until the host has made the file PATH, so that somebody can look
 * at it. Frames larger than the panel are not shown; with hold= they are refused.
 *
 * SPDX-License-Identifier: MIT */
#include "board/panel.h"

#include "board/board.h"
#include "board/line.h"
#include "board/parameters.h"
#include "board/semihosted/semihosted.h"

#if PLT_BOARD_PANEL
#include "platform/bare/semihost.h"

static uint8_t is_shown;

static void size_item(line *l, uint16_t width, uint16_t height) {
    line_u64(l, width);
    line_text(l, "x");
    line_u64(l, height);
}

static int complain_of_size(uint16_t width, uint16_t height, uint16_t most_x, uint16_t most_y) {
    line l;
    line_start(&l);
    line_text(&l, "error: the frame has ");
    size_item(&l, width, height);
    line_text(&l, " pixels, and this board's panel ");
    size_item(&l, most_x, most_y);
    line_print(&l);
    return -1;
}

int semihosted_panel_begin(uint16_t width, uint16_t height) {
    uint16_t most_x, most_y;
    parameter p;
    board_panel_size(&most_x, &most_y);
    is_shown = width <= most_x && height <= most_y;
    if (is_shown) {
        board_panel_begin(width, height);
    } else if (parameter_find(semihosted_parameters(), "hold", &p)) {
        return complain_of_size(width, height, most_x, most_y);
    }
    return 0;
}

void semihosted_panel_tile(const plt_tile *tile) {
    if (is_shown) {
        board_panel_tile(tile);
    }
}

/* The debugger does nothing else while it is asked for a file. */
static void wait_for_file(const char *path) {
    enum { LOOPS = 1000000 };
    int file = -1;
    while ((file = semihost_open(path, 0)) < 0) {
        for (int i = 0; i < LOOPS; i++) {
            __asm__ volatile("");
        }
    }
    semihost_close(file);
}

void semihosted_panel_end(const char *parameters) {
    char path[SEMIHOSTED_PATH_BYTES];
    parameter p;
    if (is_shown && parameter_find(parameters, "hold", &p) &&
        parameter_copy(&p, path, sizeof path) == 0) {
        board_print("panel shows the frame\n");
        wait_for_file(path);
    }
}

#else

int semihosted_panel_begin(uint16_t width, uint16_t height) {
    parameter p;
    (void)width;
    (void)height;
    return parameter_find(semihosted_parameters(), "hold", &p)
               ? semihosted_complain("error: this board has no panel; leave out hold=\n")
               : 0;
}

void semihosted_panel_tile(const plt_tile *tile) {
    (void)tile;
}

void semihosted_panel_end(const char *parameters) {
    (void)parameters;
}

#endif
