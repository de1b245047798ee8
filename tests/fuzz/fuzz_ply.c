/* fuzz_ply - a libFuzzer target: any bytes as a PLY
 *
 * What is promised is said in mesh_target.h. SPDX-License-Identifier: MIT */
#include "tests/fuzz/mesh_target.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    mesh_target_try(ply_read, "fuzz.ply", data, size, 0);
    return 0;
}
