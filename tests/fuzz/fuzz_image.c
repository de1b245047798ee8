/* fuzz_image - a libFuzzer target: any bytes as an image, opened and traced
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. \
 *       tests/fuzz/fuzz_image.c $(find engine -name "*.c")
 *
 * The first byte chooses source, order and packet side; bit 4 asks for the checksums and the
 * checks of parts to be made right; with bit 5 the scene stays in its source. The promises checked
 * are those of hostile/images.h; tests/engine/test_image_fuzz.c runs this with mutations of its own
 * in `make test`.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/image_target.h"

static void seal_image(unsigned char *bytes, uint32_t size) {
    hostile_seal(bytes, size);
}

static hostile_result try_image(const unsigned char *bytes, uint32_t size, uint8_t first) {
    static const uint8_t sides[4] = {2, 4, 8, 16};
    const uint8_t side = sides[first >> 2 & 3];
    const hostile_config config = {first & 1, first >> 1 & 1,
                                   side < PLT_PACKET_SIDE_MAX ? side : PLT_PACKET_SIDE_MAX,
                                   first & 32 ? PLT_RESIDENCY_STREAMED : PLT_RESIDENCY_WHOLE};
    return hostile_try_by(bytes, size, config,
                          config.residency == PLT_RESIDENCY_STREAMED ? hostile_trace_streamed
                                                                     : hostile_trace);
}
