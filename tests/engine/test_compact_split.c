/* test_compact_split - a split that saves a node is preferred when it is nearly as good
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/builder/blocks.h"
#include "tests/reference/room.h"
#include "tests/test.h"

enum { SIDES = 4, MEMORY = 4096 };

/* A triangle in the plane z = 0 from x to x + width, one lattice step high. */
static void put(unsigned char *corner, uint32_t x, uint32_t width) {
    const uint32_t number[9] = {x, 0, 0, x + width, 0, 0, x, 1, 0};
    for (int i = 0; i < 9; i++) {
        corner[2 * i] = (unsigned char)number[i];
        corner[2 * i + 1] = (unsigned char)(number[i] >> 8);
    }
}

/* Four lists of K side by side: the first 100 wide, `gap` from its start to the others, 600
 * wide in all. Splitting into halves costs 2 (gap + 150) + 2 * 300 and needs one node;
 * splitting off the first list costs 100 + 3 * 600 = 1,900 and needs two. */
static uint32_t nodes_of(uint32_t k, uint32_t gap) {
    static _Alignas(8) unsigned char memory[MEMORY];
    unsigned char corners[SIDES * 4][9 * 2];
    const uint32_t count = SIDES * k;
    for (uint32_t i = 0; i < k; i++) {
        put(corners[i], 0, 100);
        put(corners[k + i], gap, 150);
        put(corners[2 * k + i], gap + 300, 300);
        put(corners[3 * k + i], gap + 300, 300);
    }
    plt_blocks_job job = {.triangles = {corners[0], count, 2, 0},
                          .bits = 12,
                          .leaf_triangles = k,
                          .splits = PLT_SPLIT_SAH,
                          .memory = memory,
                          .bytes = MEMORY,
                          .scratch = room_get(plt_blocks_scratch_bytes(count))};
    int status = plt_blocks_begin(&job);
    for (status = status == PLT_OK ? PLT_MORE : status; status == PLT_MORE;) {
        status = plt_blocks_step(&job);
    }
    free(job.scratch);
    CHECK(status == PLT_OK, "status %d", status);
    return job.nodes;
}

int main(void) {
    test("a split that fills leaves is chosen up to a 32nd above the best cost, and not beyond");
    for (uint32_t k = 1; k <= 4 && SIDES * k <= PLT_SAH_BINS; k *= 2) {
        static const struct {
            uint32_t gap, nodes;
        } sample[4] = {{499, 1}, {501, 1}, {529, 1}, {530, 2}}; /* 1,900 * 33 / 32: 529.7 */
        for (int i = 0; i < 4; i++) {
            const uint32_t nodes = nodes_of(k, sample[i].gap);
            CHECK(nodes == sample[i].nodes, "K %u, gap %u: %u nodes", k, sample[i].gap, nodes);
        }
    }
    return test_done();
}
