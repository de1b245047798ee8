/* lanes_run - SIMD128 beside the scalar reference, as a program in WebAssembly for lanes.js
 *
 * SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "host_tools/web/exports.h"
#include "tests/lanes/compare.h"

/* Names of operations, NULL behind the last; and how many cases of them differ, of how many. */
WEB_EXPORT(const char *, lanes_name)(int op);
WEB_EXPORT(uint32_t, lanes_differ)(int op);
WEB_EXPORT(uint32_t, lanes_compared)(void);
/* Of the first that differs: its words, what came, and what the reference has. */
WEB_EXPORT(const uint32_t *, lanes_first)(void);

extern const lanes_probe lanes_probe_scalar, lanes_probe_wasm;

static lanes_comparison c = {.probe = &lanes_probe_wasm, .scalar = &lanes_probe_scalar, .step = 1};

const char *lanes_name(int op) {
    return op <= LANES_OP_COUNT ? lanes_names[op] : NULL;
}

uint32_t lanes_differ(int op) {
    lanes_make_values();
    lanes_compare(&c, (enum lanes_op)op);
    return (uint32_t)c.differ;
}

uint32_t lanes_compared(void) {
    return (uint32_t)c.compared;
}

const uint32_t *lanes_first(void) {
    static uint32_t first[5];
    for (int row = 0; row < 3; row++) {
        first[row] = c.in.row[row][c.word & 3];
    }
    first[3] = c.got;
    first[4] = c.want;
    return first;
}
