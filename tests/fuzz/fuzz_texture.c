/* fuzz_texture - a libFuzzer target: any bytes as an image with materials and textures, with lights
 * or without, resident or streamed
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. \
 *       tests/fuzz/fuzz_texture.c $(find engine -name "*.c")
 *
 * The first byte chooses source, filter, lights and residency; bit 4 asks for checksums to be made
 * right, but for those of tiles. The promises checked are those of hostile/textures.h;
 * tests/engine/test_texture_fuzz.c runs this with mutations of its own.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/image_target.h"
#include "tests/hostile/textures.h"

static void seal_image(unsigned char *bytes, uint32_t size) {
    hostile_seal_paged(bytes, size);
}

static hostile_result try_image(const unsigned char *bytes, uint32_t size, uint8_t first) {
    const hostile_textured how = {.fetched = first & 1,
                                  .filter = (uint8_t)(1 + (first >> 1 & 1)),
                                  .lit = first >> 2 & 1,
                                  .residency = first >> 3 & 1};
    return hostile_try_textures(bytes, size, how);
}
