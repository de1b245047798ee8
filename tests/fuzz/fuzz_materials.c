/* fuzz_materials - a libFuzzer target: any bytes as an image with materials
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. \
 *       tests/fuzz/fuzz_materials.c $(find engine -name "*.c")
 *
 * Bit 4 of the first byte asks for checksums to be made right. Opened with lights, it is refused or
 * rendered; tests/engine/test_materials.c does the same with mutations of its own.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hostile/materials.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    plt_fault fault;
    if (size < 2 || size > 1u << 20) {
        return 0;
    }
    unsigned char *image = aligned_alloc(PLT_ALIGN, (size + 62) / 64 * 64 + 64);
    memcpy(image, data + 1, size - 1);
    if (data[0] & 16) {
        hostile_seal_materials(image, (uint32_t)size - 1);
    }
    hostile_try_materials(image, (uint32_t)size - 1, &fault);
    free(image);
    return 0;
}
