/* fuzz_sequence - a libFuzzer target: any bytes as an image with frames, all of them shown
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. \
 *       tests/fuzz/fuzz_sequence.c $(find engine -name "*.c")
 *
 * The first byte chooses source and order, and whether there are records (bits 5 and up); bit 4
 * asks for the checksums of sections and blocks to be made right, or hardly a mutation would pass
 * them. The promises checked are those of hostile/sequences.h; tests/engine/test_sequence_fuzz.c
 * runs this with mutations of its own.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/image_target.h"
#include "tests/hostile/sequences.h"

static void seal_image(unsigned char *bytes, uint32_t size) {
    hostile_seal_sequence(bytes, size);
}

static hostile_result try_image(const unsigned char *bytes, uint32_t size, uint8_t first) {
    const hostile_config config = {
        .streamed = first & 1, .order = first >> 1 & 1, .packet_side = 2};
    return hostile_try_sequence(bytes, size, config, HOSTILE_RECORDS + (first >> 5) % 3);
}
