/* fuzz_mtl - a libFuzzer target: any bytes as a library of materials
 *
 * Whatever it says, each material has values that an image may have.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/mesh/mtl.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(const float *x, int count, float least, float most) {
    for (int i = 0; i < count; i++) {
        if (!(x[i] >= least && x[i] <= most)) {
            abort();
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    mesh_materials m = {0};
    unsigned char *bytes = malloc(size + 1);
    memcpy(bytes, data, size);
    bytes[size] = 0;
    const input in = {.path = "fuzz.mtl", .bytes = bytes, .size = size};
    if (materials_begin(&m, 0) != 0 || mtl_read(&m, &in) != 0) {
        abort();
    }
    for (size_t i = 0; i < m.count; i++) {
        const material_values *v = &m.material[i].values;
        check(v->diffuse, 3, 0, 1);
        check(v->specular, 3, 0, 1);
        check(v->emission, 3, 0, 1048576);
        check(v->absorption, 3, 0, 1048576);
        check(&v->index, 1, 1, 4);
        check(&v->transparency, 1, 0, 1);
        check(&v->mirror, 1, 0, 1);
        if (v->exponent < 1 || v->exponent > 1024) {
            abort();
        }
    }
    materials_free(&m);
    free(bytes);
    return 0;
}
