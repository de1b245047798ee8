/* fuzz_instances - a libFuzzer target: any bytes as an image with instances, all frames shown
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. \
 *       tests/fuzz/fuzz_instances.c $(find engine -name "*.c")
 *
 * The first byte chooses source and order; bit 4 asks for the checksums of sections and frames
 * to be made right, or hardly a mutation would pass them. The promises checked are those of
 * hostile/instances.h; tests/engine/test_instances_fuzz.c runs this with mutations of its own.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/image_target.h"
#include "tests/hostile/instances.h"

static void seal_image(unsigned char *bytes, uint32_t size) {
    hostile_seal_instances(bytes, size);
}

static hostile_result try_image(const unsigned char *bytes, uint32_t size, uint8_t first) {
    const hostile_config config = {
        .streamed = first & 1, .order = first >> 1 & 1, .packet_side = 2};
    return hostile_try_instances(bytes, size, config);
}
