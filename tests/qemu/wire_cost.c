/* wire_cost - what the codec and the sender cost on a Cortex-M4
 *
 * Encodes and decodes tiles of a picture that is computed, in a region each, for
 * libcount.so to count. Ends with 42 when all came back and the coded bytes are
 * those of every machine, with 2 when they are not.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/semihost.h"
#include "platform/bare/start.h"
#include "platform/wire/hash.h"
#include "tests/reference/wire_picture.h"

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

void machine_print(const char *text) {
    semihost_print(text);
}

_Noreturn void machine_exit(int status) {
    semihost_exit(status);
}

static uint8_t rgb[3 * 256], pixels[512], coded[512], back[512];

static uint32_t hash_tile(void) {
    for (unsigned y = 0; y < 16; y++) {
        wire_row_from_rgb(back + 32 * y, WIRE_RGB565, rgb + 48 * y, 16, 0, y);
    }
    return wire_hash(back, 512);
}

/* A row that is not decoded is then not that of the tile before. */
static void clear_back(void) {
    for (unsigned i = 0; i < sizeof back; i++) {
        back[i] = 0x5A;
    }
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

_Noreturn void machine_main(void) {
    const wire_tile_shape shape = {WIRE_RGB565, 16, 16};
    uint32_t wrong = 0, crc = 0;
    for (unsigned tile = 0; tile < PICTURE_TILES; tile++) {
        unsigned coder;
        wire_picture_tile(tile, pixels);
        for (unsigned y = 0; y < 16; y++) {
            wire_row_to_rgb(rgb + 48 * y, WIRE_RGB565, pixels + 32 * y, 16);
        }
        wire_hash_begin();
        const uint32_t hash = hash_tile();
        wire_hash_end();
        clear_back();
        wire_encode_begin();
        const uint32_t bytes = wire_tile_encode(shape, pixels, (void *)0, 0, coded, 512, &coder);
        wire_encode_end();
        crc = plt_crc32(crc, coded, bytes);
        wire_decode_begin();
        wrong += !decode(shape, coder, bytes);
        wire_decode_end();
        wrong += wire_hash(back, 512) != hash;
        wire_near_begin();
        const uint32_t fewer =
            wire_tile_encode(shape, pixels, (void *)0, PICTURE_NEAR, coded, 512, &coder);
        wire_near_end();
        crc = plt_crc32(crc, coded, fewer);
        clear_back();
        wrong += fewer > bytes || !decode(shape, coder, fewer);
        wrong += wire_hash(back, 512) != wire_hash(pixels, 512);
    }
    semihost_exit(wrong > 0 ? 1 : crc != PICTURE_CODED_CRC ? 2 : 42);
}
