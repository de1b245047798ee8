/* board - the board functions of the fake: every call recorded and checked
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "board/fake/fake.h"

fake_board fake;

const char *const fake_board_failure_name[FAKE_BOARD_FAILURES] = {
    [FAKE_BOARD_WORKS] = "works",
    [FAKE_HAS_NO_SCENE] = "has no scene",
    [FAKE_REFUSES_FRAME] = "refuses a frame",
    [FAKE_KEEPS_NO_FRAME] = "keeps no frame",
    [FAKE_ARENA_IS_SMALL] = "has a small arena",
    [FAKE_ARENA_IS_SHIFTED] = "has an arena that is not aligned",
    [FAKE_ARENA_IS_NULL] = "has no arena",
    [FAKE_CLOCK_STANDS] = "has a clock that stands",
    [FAKE_CLOCK_WRAPS] = "has a clock that wraps",
};

static _Alignas(PLT_ALIGN) unsigned char arena[FAKE_ARENA_BYTES + 1];

enum { TICKS_PER_CALL = 1000, TICKS_PER_SECOND = 1000000 };

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
    *bytes = fake.failure == FAKE_ARENA_IS_SMALL ? FAKE_SMALL_BYTES : FAKE_ARENA_BYTES;
    if (fake.failure == FAKE_ARENA_IS_NULL) {
        return NULL;
    }
    return arena + (fake.failure == FAKE_ARENA_IS_SHIFTED);
}

int board_scene(const char *parameters, plt_source *source) {
    (void)parameters;
    if (fake.failure == FAKE_HAS_NO_SCENE) {
        board_print("error: the fake board has no scene\n");
        return -1;
    }
    *source = fake.source;
    return 0;
}

static fake_frame *last_frame(void) {
    static fake_frame none;
    return fake.frames_begun == 0 ? &none : &fake.frames[fake.frames_begun - 1];
}

const fake_frame *fake_last_frame(void) {
    return last_frame();
}

int board_frame_begin(uint16_t width, uint16_t height) {
    const size_t pixels = (size_t)width * height;
    if (fake.frames_begun != fake.frames_ended) {
        break_contract("a frame begun before the one before it ended");
    }
    if (fake.failure == FAKE_REFUSES_FRAME || pixels > FAKE_PIXELS - fake.pixels_used ||
        fake.frames_begun == FAKE_FRAMES) {
        board_print("error: the fake board has no room for the frame\n");
        return -1;
    }
    fake.frames[fake.frames_begun++] =
        (fake_frame){fake.pixels + 3u * fake.pixels_used, width, height, 0};
    fake.pixels_used += (uint32_t)pixels;
    memset(fake.painted, 0, pixels);
    return 0;
}

static void record_row(const fake_frame *f, const plt_tile *tile, unsigned row) {
    const size_t at = (size_t)(tile->y + row) * f->width + tile->x;
    const size_t first = fake.pixels_used - (size_t)f->width * f->height;
    memcpy(fake.pixels + 3 * (first + at), tile->rgb + 3u * row * tile->width, 3u * tile->width);
    for (unsigned i = 0; i < tile->width; i++) {
        if (++fake.painted[at + i] != 1) {
            break_contract("a pixel that came twice");
        }
    }
}

void board_tile(const plt_tile *tile) {
    fake_frame *f = last_frame();
    if (fake.frames_begun != fake.frames_ended + 1) {
        break_contract("a tile outside a frame");
        return;
    }
    if (tile->x + tile->width > f->width || tile->y + tile->height > f->height ||
        tile->width == 0 || tile->height == 0) {
        break_contract("a tile that is empty or leaves the frame");
        return;
    }
    for (unsigned row = 0; row < tile->height; row++) {
        record_row(f, tile, row);
    }
    if (fake.tile_count < FAKE_TILES) {
        fake.tiles[fake.tile_count] = *tile;
        fake.tiles[fake.tile_count].rgb = NULL;
    }
    fake.tile_count++;
    f->tiles++;
}

const uint8_t *board_frame_end(const char *parameters) {
    const fake_frame *f = last_frame();
    (void)parameters;
    if (fake.frames_begun != fake.frames_ended + 1) {
        break_contract("an end of a frame that was not begun");
        return NULL;
    }
    fake.frames_ended++;
    for (size_t i = 0; i < (size_t)f->width * f->height; i++) {
        if (fake.painted[i] == 0) {
            break_contract("a pixel that never came");
            break;
        }
    }
    return fake.failure == FAKE_KEEPS_NO_FRAME ? NULL : f->rgb;
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
    if (fake.failure == FAKE_CLOCK_WRAPS && fake.ticks < UINT32_MAX - TICKS_PER_CALL) {
        fake.ticks = UINT32_MAX - TICKS_PER_CALL / 2;
    } else if (fake.failure != FAKE_CLOCK_STANDS) {
        fake.ticks += TICKS_PER_CALL;
    }
    return fake.ticks;
}

uint32_t board_ticks_per_second(void) {
    return TICKS_PER_SECOND;
}

void board_stack(uint32_t *used_bytes, uint32_t *size_bytes) {
    *used_bytes = 0;
    *size_bytes = 0;
}
