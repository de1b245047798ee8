/* jpeg - what the JPEG encoder takes of a board: a program for tests/measure/jpeg.sh
 *
 * The first letter of the parameters is a sampling, 0 to 2. What is counted is between
 * firmware_render_begin and firmware_render_end (board/tools/emulate.sh). PROGRAM=jpeg builds it
 * for any board, without the engine.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/jpeg.h"
#include "board/board.h"
#include "tests/boards/jpeg_picture.h"

enum { PIXELS = JPEG_PICTURE_SIDE * JPEG_PICTURE_SIDE };

static uint8_t rgb[3 * PIXELS], file[PIXELS];

__attribute__((noinline)) void firmware_render_begin(void);
__attribute__((noinline)) void firmware_render_end(void);

void firmware_render_begin(void) {
    __asm__ volatile("");
}

void firmware_render_end(void) {
    __asm__ volatile(" " ::: "memory");
}

static void print_hash(uint32_t hash) {
    char text[] = "hash 00000000\n";
    for (unsigned i = 0; i < 8; i++) {
        text[5 + i] = "0123456789abcdef"[hash >> (28 - 4 * i) & 15];
    }
    board_print(text);
}

int firmware(const char *parameters) {
    const picture p = {rgb, JPEG_PICTURE_SIDE, JPEG_PICTURE_SIDE};
    const char letter = *parameters == ' ' ? parameters[1] : *parameters;
    const jpeg_sampling sampling = letter == '1' ? JPEG_422 : letter == '2' ? JPEG_420 : JPEG_444;
    jpeg_picture_fill(rgb);
    firmware_render_begin();
    const size_t bytes = jpeg_write(&p, sampling, JPEG_PICTURE_QUALITY, file, sizeof file);
    firmware_render_end();
    if (bytes > sizeof file) {
        board_print("no room for the file\n");
        return FIRMWARE_FAILED;
    }
    print_hash(jpeg_picture_hash(file, bytes));
    return FIRMWARE_DONE;
}
