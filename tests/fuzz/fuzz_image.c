/* fuzz_image - a libFuzzer target: any bytes as an image, opened and traced
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. \
 *       tests/fuzz/fuzz_image.c $(find engine -name "*.c")
 *
 * The first byte chooses source, walk and packet side; bit 4 asks for the
 * checksums and the checks of parts to be made right, or hardly a mutation would pass them; with
 * bit 5 the scene stays in its source. The
 * promises checked are those of hostile/images.h; tests/test_image_fuzz.c runs
 * this with mutations of its own in `make test`.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "tests/hostile/images.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static unsigned long images_opened;

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const uint8_t sides[4] = {2, 4, 8, 16};
    if (size < 1 || size > 1u << 20) {
        return 0;
    }
    const uint8_t side = sides[data[0] >> 2 & 3];
    const hostile_config config = {data[0] & 1, data[0] >> 1 & 1,
                                   side < PLT_PACKET_SIDE_MAX ? side : PLT_PACKET_SIDE_MAX,
                                   data[0] & 32 ? PLT_RESIDENCY_STREAMED : PLT_RESIDENCY_WHOLE};
    const uint32_t count = (uint32_t)size - 1;
    unsigned char *bytes = malloc(count > 0 ? count : 1);
    memcpy(bytes, data + 1, count);
    if (data[0] & 16) {
        hostile_seal(bytes, count);
    }
    const hostile_result r = hostile_try_by(
        bytes, count, config,
        config.residency == PLT_RESIDENCY_STREAMED ? hostile_trace_streamed : hostile_trace);
    free(bytes);
    images_opened += r.status == PLT_OK;
    if (r.sentence != NULL) {
        fprintf(stderr, "%s\n", r.sentence);
        abort();
    }
    return 0;
}
