/* test_compact_depth - the builder of compact blocks at its limits
 *
 * No scene of ordinary size is 64 levels deep, so the job starts with a root that is already
 * near that depth. Triangles lie at 1, 2, 4, .. along an axis, so both the median and the
 * surface area heuristic split them off one by one.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/builder/blocks.h"
#include "engine/builder/blocks_state.h"
#include "tests/reference/room.h"
#include "tests/test.h"

enum { TRIANGLES = 8, LEVELS = 2, MEMORY = 4096 };

static void put(uint16_t *corner, uint32_t x) {
    const uint32_t number[9] = {x, 0, 0, x + 1, 0, 0, x, 1, 0};
    for (int i = 0; i < 9; i++) {
        corner[i] = (uint16_t)number[i];
    }
}

/* The status of building eight triangles, two per list, below `depth` levels. */
static int build(uint32_t depth, uint8_t splits, plt_blocks_job *job) {
    static _Alignas(8) unsigned char memory[MEMORY];
    uint16_t corners[TRIANGLES][9];
    for (uint32_t i = 0; i < TRIANGLES; i++) {
        put(corners[i], 8u << i);
    }
    const plt_blocks_job fresh = {.triangles = {(const unsigned char *)corners, TRIANGLES, 2, 0},
                                  .bits = 12,
                                  .leaf_triangles = 1,
                                  .splits = splits,
                                  .memory = memory,
                                  .bytes = MEMORY,
                                  .scratch = room_get(plt_blocks_scratch_bytes(TRIANGLES))};
    *job = fresh;
    int status = plt_blocks_begin(job);
    plt_blocks_state *s = job->scratch;
    s->edge[0].depth = depth;
    for (status = status == PLT_OK ? PLT_MORE : status; status == PLT_MORE;) {
        status = plt_blocks_step(job);
    }
    free(job->scratch);
    return status;
}

/* The first block of a build that has, as it were, written `used` bytes of blocks before. */
static int build_behind(uint32_t used, plt_blocks_job *job) {
    uint16_t corners[1][9];
    put(corners[0], 8);
    const plt_blocks_job fresh = {.triangles = {(const unsigned char *)corners, 1, 2, 0},
                                  .bits = 12,
                                  .leaf_triangles = 1,
                                  .memory =
                                      room_get((size_t)used + MEMORY), /* touched at its end */
                                  .bytes = (size_t)used + MEMORY,
                                  .scratch = room_get(plt_blocks_scratch_bytes(1))};
    *job = fresh;
    int status = plt_blocks_begin(job);
    job->used = used;
    for (uint32_t i = 0; i < 2 && status >= PLT_OK; i++) {
        status = plt_blocks_step(job);
    }
    free(job->scratch);
    free(job->memory);
    return status;
}

int main(void) {
    for (uint8_t splits = PLT_SPLIT_SAH; splits <= PLT_SPLIT_MEDIAN; splits++) {
        const char *name = splits == PLT_SPLIT_SAH ? "SAH" : "median";
        plt_blocks_job job;
        test(splits == PLT_SPLIT_SAH ? "near the last level ranges are halved by count: SAH"
                                     : "... and median splits");
        int status = build(0, splits, &job);
        CHECK(status == PLT_OK && job.depth > LEVELS, "%s: status %d, depth %u: too even", name,
              status, job.depth);
        status = build(PLT_DEPTH_MAX - LEVELS, splits, &job);
        CHECK(status == PLT_OK && job.depth == PLT_DEPTH_MAX, "%s: status %d, depth %u", name,
              status, job.depth);
        test("... and what needs one more level is refused");
        status = build(PLT_DEPTH_MAX - LEVELS + 1, splits, &job);
        CHECK(status == PLT_ERR_LIMIT && job.limit == PLT_BLOCKS_LIMIT_DEPTH,
              "%s: status %d, limit %u, depth %u", name, status, job.limit, job.depth);
        status = build(PLT_DEPTH_MAX, splits, &job);
        CHECK(status == PLT_ERR_LIMIT && job.limit == PLT_BLOCKS_LIMIT_DEPTH,
              "%s: status %d, limit %u, depth %u", name, status, job.limit, job.depth);
    }
    test("blocks that links cannot reach are refused as that, not as too deep");
    plt_blocks_job job;
    int status = build_behind(PLT_BLOCKS_BYTES_MAX - 8, &job);
    CHECK(status == PLT_ERR_LIMIT && job.limit == PLT_BLOCKS_LIMIT_BYTES, "status %d, limit %u",
          status, job.limit);
    status = build_behind(PLT_BLOCKS_BYTES_MAX - 4096, &job);
    CHECK(status == PLT_MORE && job.limit == PLT_BLOCKS_LIMIT_NONE, "status %d, limit %u", status,
          job.limit);
    return test_done();
}
