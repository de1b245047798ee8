/* wire_cost - what the codec and the sender cost on a Cortex-M4
 *
 * Encodes and decodes tiles of a picture that is computed here (marbles-like
 * discs with noise on a ramp), in a region each, for libcount.so to count.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/cortex_m/semihost.h"
#include "platform/cortex_m/start.h"
#include "platform/wire/crc.h"
#include "platform/wire/hash.h"
#include "platform/wire/wire.h"

enum { TILES = 64 };

#define MARK(name)                                                                                 \
    __attribute__((noinline)) void name(void);                                                     \
    void name(void) {                                                                              \
        __asm__ volatile("");                                                                      \
    }
MARK(wire_encode_begin)
MARK(wire_encode_end)
MARK(wire_decode_begin)
MARK(wire_decode_end)
MARK(wire_near_begin)
MARK(wire_near_end)
MARK(wire_hash_begin)
MARK(wire_hash_end)

__attribute__((section(".arena"), used)) static unsigned char arena[16];

void cortex_m_print(const char *text) {
    semihost_print(text);
}

_Noreturn void cortex_m_exit(int status) {
    semihost_exit(status);
}

static uint8_t rgb[3 * 256], pixels[512], coded[512], back[512];

static void draw(unsigned tile) {
    uint32_t noise = tile * 2654435761u;
    for (unsigned i = 0; i < 256; i++) {
        const int x = (int)(i % 16) - 8, y = (int)(i / 16) - 8;
        noise = noise * 1664525u + 1013904223u;
        const unsigned grey = tile % 4 == 0        ? 40 + i / 16
                              : x * x + y * y < 50 ? 230 - (noise >> 29) * (tile % 4)
                                                   : 60;
        rgb[3 * i] = (uint8_t)grey;
        rgb[3 * i + 1] = (uint8_t)(grey * 15 / 16);
        rgb[3 * i + 2] = (uint8_t)(grey * 14 / 16);
    }
}

static uint32_t hash_tile(void) {
    for (unsigned y = 0; y < 16; y++) {
        wire_row_from_rgb(pixels + 32 * y, WIRE_RGB565, rgb + 48 * y, 16, 0, y);
    }
    return wire_hash(pixels, 512);
}

static int decode(wire_tile_shape shape, unsigned coder, uint32_t bytes) {
    wire_tile_reader reader;
    const uint8_t *at = coded;
    int event =
        wire_tile_begin(&reader, shape, coder, bytes, (void *)0, 0) == 0 ? WIRE_TILE_ROW : -1;
    while (event == WIRE_TILE_ROW) {
        event = wire_tile_read(&reader, &at, coded + bytes);
        if (event == WIRE_TILE_ROW) {
            wire_tile_row(&reader, back + 32 * (reader.y - 1));
        }
    }
    return event == WIRE_TILE_DONE;
}

_Noreturn void cortex_m_main(void) {
    const wire_tile_shape shape = {WIRE_RGB565, 16, 16};
    uint32_t wrong = 0;
    for (unsigned tile = 0; tile < TILES; tile++) {
        unsigned coder;
        draw(tile);
        wire_hash_begin();
        const uint32_t hash = hash_tile();
        wire_hash_end();
        wire_encode_begin();
        const uint32_t bytes = wire_tile_encode(shape, pixels, (void *)0, 0, coded, 512, &coder);
        wire_encode_end();
        wire_decode_begin();
        wrong += !decode(shape, coder, bytes);
        wire_decode_end();
        wrong += wire_hash(back, 512) != hash;
        wire_near_begin();
        const uint32_t fewer = wire_tile_encode(shape, pixels, (void *)0, 3, coded, 512, &coder);
        wire_near_end();
        wrong += fewer > bytes || !decode(shape, coder, fewer);
        wrong += wire_crc(0, back, 512) != wire_crc(0, pixels, 512);
    }
    semihost_exit(wrong == 0 ? 42 : 1);
}
