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
#include <stdio.h>

#include "tests/hostile/sequences.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static unsigned long images_opened;

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 1 || size > 1u << 20) {
        return 0;
    }
    const hostile_config config = {
        .streamed = data[0] & 1, .order = data[0] >> 1 & 1, .packet_side = 2};
    const uint32_t count = (uint32_t)size - 1;
    unsigned char *bytes = malloc(count > 0 ? count : 1);
    memcpy(bytes, data + 1, count);
    if (data[0] & 16) {
        hostile_seal_sequence(bytes, count);
    }
    const hostile_result r =
        hostile_try_sequence(bytes, count, config, HOSTILE_RECORDS + (data[0] >> 5) % 3);
    free(bytes);
    images_opened += r.status == PLT_OK;
    if (r.sentence != NULL) {
        fprintf(stderr, "%s\n", r.sentence);
        abort();
    }
    return 0;
}
