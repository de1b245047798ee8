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
#include <stdio.h>

#include "tests/hostile/instances.h"

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
        hostile_seal_instances(bytes, count);
    }
    const hostile_result r = hostile_try_instances(bytes, count, config);
    free(bytes);
    images_opened += r.status == PLT_OK;
    if (r.sentence != NULL) {
        fprintf(stderr, "%s\n", r.sentence);
        abort();
    }
    return 0;
}
