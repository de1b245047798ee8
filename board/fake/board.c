/* board - the board functions of the fake: every call recorded and checked
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "board/fake/fake.h"

fake_board fake;

static _Alignas(PLT_ALIGN) unsigned char arena[FAKE_ARENA_BYTES];

static void break_contract(const char *sentence) {
    fake.broken++;
    fake.sentence = sentence;
}

void fake_reset(void) {
    memset(&fake, 0, sizeof fake);
}

const char *board_name(void) {
    return "fake";
}

unsigned char *board_arena(size_t *bytes) {
    *bytes = sizeof arena;
    return arena;
}

int board_scene(const char *parameters, plt_source *source) {
    (void)parameters;
    if (fake.scene_fails) {
        board_print("error: the fake board has no scene\n");
        return -1;
    }
    *source = fake.source;
    return 0;
}

int board_frame_begin(uint16_t width, uint16_t height) {
    const size_t pixels = (size_t)width * height;
    if (fake.frame_fails || pixels > sizeof fake.painted) {
        board_print("error: the fake board has no room for the frame\n");
        return -1;
    }
    fake.width = width;
    fake.height = height;
    fake.frames_begun++;
    memset(fake.painted, 0, pixels);
    return 0;
}

static void record_row(const plt_tile *tile, unsigned row) {
    const size_t at = (size_t)(tile->y + row) * fake.width + tile->x;
    memcpy(fake.frame + 3 * at, tile->rgb + 3u * row * tile->width, 3u * tile->width);
    for (unsigned i = 0; i < tile->width; i++) {
        if (++fake.painted[at + i] != 1) {
            break_contract("a pixel that came twice");
        }
    }
}

void board_tile(const plt_tile *tile) {
    if (fake.frames_begun != fake.frames_ended + 1) {
        break_contract("a tile outside a frame");
        return;
    }
    if (tile->x + tile->width > fake.width || tile->y + tile->height > fake.height ||
        tile->width == 0 || tile->height == 0) {
        break_contract("a tile that is empty or leaves the frame");
        return;
    }
    for (unsigned row = 0; row < tile->height; row++) {
        record_row(tile, row);
    }
    if (fake.tile_count < FAKE_TILES) {
        fake.tiles[fake.tile_count] = *tile;
        fake.tiles[fake.tile_count].rgb = NULL;
    }
    fake.tile_count++;
}

const uint8_t *board_frame_end(const char *parameters) {
    (void)parameters;
    fake.frames_ended++;
    for (size_t i = 0; i < (size_t)fake.width * fake.height; i++) {
        if (fake.painted[i] == 0) {
            break_contract("a pixel that never came");
            break;
        }
    }
    return fake.keeps_no_frame ? NULL : fake.frame;
}

void board_print(const char *text) {
    const size_t length = strlen(text);
    if (length >= FAKE_TEXT_BYTES - fake.text_used) {
        break_contract("more text than the fake records");
        return;
    }
    memcpy(fake.text + fake.text_used, text, length + 1);
    fake.text_used += (uint32_t)length;
}

uint32_t board_ticks(void) {
    static uint32_t ticks;
    return ticks += 1000;
}

uint32_t board_ticks_per_second(void) {
    return 1000000;
}

void board_stack(uint32_t *used_bytes, uint32_t *size_bytes) {
    *used_bytes = 0;
    *size_bytes = 0;
}
