/* fuzz_surface - a libFuzzer target: any bytes as an image with normals and colours,
 * in tables or in pages
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. \
 *       tests/fuzz/fuzz_surface.c $(find engine -name "*.c")
 *
 * The first byte chooses source and order; bit 4 asks for checksums to be made right. The promises
 * checked are those of hostile/surface.h; tests/engine/test_surface_fuzz.c runs this with
 * mutations of its own.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/image_target.h"
#include "tests/hostile/surface.h"

static void seal_image(unsigned char *bytes, uint32_t size) {
    hostile_seal_paged(bytes, size);
}

static hostile_result try_image(const unsigned char *bytes, uint32_t size, uint8_t first) {
    const hostile_config config = {
        .streamed = first & 1, .order = first >> 1 & 1, .packet_side = 2};
    return hostile_try_surface(bytes, size, config);
}
