/* fuzz_wire_tile - a libFuzzer target: any bytes as a coded tile
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. tests/fuzz/fuzz_wire_tile.c \
 *       platform/wire/tile_*.c platform/wire/model*.c platform/wire/wire_format.c
 *
 * The first four bytes choose coder, format, shape, and the size of the pieces
 * the rest comes in. Promised (WIRE.md, section 10): it ends, reports at most
 * `height` rows, and reads and writes nothing outside its bytes and reader.
 * tests/test_wire_fuzz.c runs this with mutations of its own in `make test`.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/wire/wire_tile.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static unsigned long tiles_whole, tiles_wrong;

static void broken(const char *sentence) {
    fprintf(stderr, "%s\n", sentence);
    abort();
}

static int feed(wire_tile_reader *r, const uint8_t **at, const uint8_t *end) {
    uint8_t row[WIRE_ROW_BYTES_MAX];
    unsigned rows = 0;
    for (;;) {
        const int event = wire_tile_read(r, at, end);
        if (event != WIRE_TILE_ROW) {
            return event;
        }
        wire_tile_row(r, row);
        if (++rows > r->shape.height || r->y > r->shape.height) {
            broken("more rows than the tile has");
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const uint8_t old[WIRE_TILE_BYTES_MAX] = {0x12, 0x34, 0x56};
    if (size < 5) {
        return 0;
    }
    const wire_tile_shape shape = {data[0] % 6, (uint8_t)(data[1] % 18), (uint8_t)(data[2] % 18)};
    const uint32_t count = (uint32_t)size - 4, piece = data[3] / 2 + 1u;
    uint8_t *bytes = malloc(count);
    memcpy(bytes, data + 4, count);
    wire_tile_reader r;
    const uint8_t *at = bytes;
    int event = wire_tile_begin(&r, shape, data[0] / 6 % 5, count, data[3] & 1 ? old : NULL,
                                WIRE_ROW_BYTES_MAX);
    event = event == 0 ? WIRE_TILE_MORE : WIRE_TILE_WRONG;
    for (uint32_t end = 0; event == WIRE_TILE_MORE && end < count;) {
        end = end + piece < count ? end + piece : count;
        event = feed(&r, &at, bytes + end);
        if (at > bytes + end) {
            broken("read beyond the bytes");
        }
    }
    tiles_whole += event == WIRE_TILE_DONE;
    tiles_wrong += event == WIRE_TILE_WRONG;
    free(bytes);
    return 0;
}
