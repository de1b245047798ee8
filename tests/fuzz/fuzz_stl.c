/* fuzz_stl - a libFuzzer target: any bytes as an STL, binary or ASCII
 *
 * What is promised is said in mesh_target.h. SPDX-License-Identifier: MIT */
#include "tests/fuzz/mesh_target.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    mesh_target_try(stl_read, "fuzz.stl", data, size, 0);
    return 0;
}
