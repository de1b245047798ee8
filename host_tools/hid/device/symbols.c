/* symbols - see symbols.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/symbols.h"

#include <stddef.h>

/* Rows of 11 pixels: # is white, what is beside it dark. */
static const char *const shapes[STEER_ACTIONS][SYMBOL_SIDE] = {
    [STEER_LEFT] = {"           ", "      #    ", "     ##    ", "    ###    ", "   ####### ",
                    "  ######## ", "   ####### ", "    ###    ", "     ##    ", "      #    ",
                    "           "},
    [STEER_RIGHT] = {"           ", "    #      ", "    ##     ", "    ###    ", " #######   ",
                     " ########  ", " #######   ", "    ###    ", "    ##     ", "    #      ",
                     "           "},
    [STEER_UP] = {"           ", "           ", "     #     ", "    ###    ", "   #####   ",
                  "  #######  ", " ######### ", "    ###    ", "    ###    ", "    ###    ",
                  "           "},
    [STEER_DOWN] = {"           ", "    ###    ", "    ###    ", "    ###    ", " ######### ",
                    "  #######  ", "   #####   ", "    ###    ", "     #     ", "           ",
                    "           "},
    [STEER_NEARER] = {"           ", "    ###    ", "    ###    ", "    ###    ", " ######### ",
                      " ######### ", " ######### ", "    ###    ", "    ###    ", "    ###    ",
                      "           "},
    [STEER_FARTHER] = {"           ", "           ", "           ", "           ", " ######### ",
                       " ######### ", " ######### ", "           ", "           ", "           ",
                       "           "},
    [STEER_RESET] = {"           ", "   #####   ", "  ##   ##  ", " ##     ## ", " #       # ",
                     " #   #   # ", " #       # ", " ##     ## ", "  ##   ##  ", "   #####   ",
                     "           "},
    [STEER_STILL] = {"           ", "  ##   ##  ", "  ##   ##  ", "  ##   ##  ", "  ##   ##  ",
                     "  ##   ##  ", "  ##   ##  ", "  ##   ##  ", "  ##   ##  ", "  ##   ##  ",
                     "           "}};

static int is_lit(const char *const shape[SYMBOL_SIDE], int x, int y) {
    return x >= 0 && y >= 0 && x < SYMBOL_SIDE && y < SYMBOL_SIDE && shape[y][x] == '#';
}

static int is_edge(const char *const shape[SYMBOL_SIDE], int x, int y) {
    for (int i = 0; i < 9; i++) {
        if (is_lit(shape, x + i % 3 - 1, y + i / 3 - 1)) {
            return 1;
        }
    }
    return 0;
}

static void draw(picture *p, const char *const shape[SYMBOL_SIDE], unsigned left, unsigned top) {
    for (int y = 0; y < SYMBOL_SIDE; y++) {
        for (int x = 0; x < SYMBOL_SIDE; x++) {
            const unsigned px = left + (unsigned)x, py = top + (unsigned)y;
            if (px >= p->width || py >= p->height || !is_edge(shape, x, y)) {
                continue;
            }
            uint8_t *rgb = p->rgb + 3 * ((size_t)py * p->width + px);
            rgb[0] = rgb[1] = rgb[2] = is_lit(shape, x, y) ? 255 : 32;
        }
    }
}

void symbols_draw(picture *p, const display_key *keys) {
    for (unsigned k = 0; keys != NULL && keys[k].name != NULL; k++) {
        if (keys[k].x > 0 || keys[k].y > 0) {
            draw(p, shapes[keys[k].action], keys[k].x, keys[k].y);
        }
    }
}
