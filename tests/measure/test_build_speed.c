/* test_build_speed [MESH...] - triangles per second of both builders, without reading and writing
 *
 * Splits, nodes or blocks, and treelets, on one core: the best of five. Without a mesh it
 * takes a small one and is one test more; the figures are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/builder/blocks.h"
#include "engine/builder/build.h"
#include "host_tools/base/clock.h"
#include "host_tools/pack/pack.h"
#include "tests/measure/meshes.h"
#include "tests/reference/room.h"

enum { ROUNDS = 5, K = 2, N = 64 };

static double best_of(double best, double began, int round) {
    const double took = clock_processor_seconds() - began;
    return round == 0 || took < best ? took : best;
}

/* Thesis nodes; 0: out of memory, or the build failed. */
static double thesis_seconds(const plt_record *records, uint32_t count) {
    const uint32_t nodes = plt_build_nodes_bound(count);
    plt_build_job job = {.count = count, .leaf_triangles = K, .treelet_nodes = N};
    double best = 0.0;
    job.room = plt_build_slots_bound(nodes, N);
    job.scratch_bytes = plt_build_scratch_bytes(nodes, N);
    job.nodes = malloc((size_t)(job.room + 1) * sizeof *job.nodes);
    job.scratch = room_get(job.scratch_bytes);
    job.records = malloc(count * sizeof *job.records);
    int status = job.nodes && job.scratch && job.records ? PLT_OK : PLT_ERR_ARENA;
    for (int i = 0; i < ROUNDS && status == PLT_OK; i++) {
        memcpy(job.records, records, count * sizeof *job.records);
        const double began = clock_processor_seconds();
        status = plt_build(&job);
        best = best_of(best, began, i);
    }
    free(job.nodes);
    free(job.scratch);
    free(job.records);
    return status == PLT_OK ? best : 0.0;
}

/* 16 bits per axis, over the longest side of the box. */
static unsigned char *lattice_corners(const plt_record *records, uint32_t count) {
    const plt_box box = plt_records_box(records, 0, count);
    const float step = plt_box_longest_side(&box) / 65535.0f;
    unsigned char *corners = malloc((size_t)18 * count);
    for (size_t i = 0; i < (size_t)9 * count && corners != NULL; i++) {
        const float x = plt_record_float(&records[i / 9], (int)(i % 9 / 3), (int)(i % 3));
        const uint32_t q = (uint32_t)((x - box.lo[i % 3]) / step + 0.5f);
        const uint32_t most = q < 65535 ? q : 65535;
        corners[2 * i] = (unsigned char)most;
        corners[2 * i + 1] = (unsigned char)(most >> 8);
    }
    return corners;
}

static double blocks_seconds(const plt_record *records, uint32_t count) {
    const size_t bytes = (size_t)48 * count + 65536;
    unsigned char *corners = lattice_corners(records, count), *memory = room_get(bytes);
    void *scratch = room_get(plt_blocks_scratch_bytes(count));
    double best = 0.0;
    int status = corners && memory && scratch ? PLT_OK : PLT_ERR_ARENA;
    for (int i = 0; i < ROUNDS && status == PLT_OK; i++) {
        plt_blocks_job job = {.triangles = {corners, count, 2, 0, NULL},
                              .bits = 16,
                              .leaf_triangles = K,
                              .memory = memory,
                              .bytes = bytes,
                              .scratch = scratch};
        const double began = clock_processor_seconds();
        status = plt_blocks_begin(&job);
        for (status = status == PLT_OK ? PLT_MORE : status; status == PLT_MORE;) {
            status = plt_blocks_step(&job);
        }
        best = best_of(best, began, i);
    }
    free(corners);
    free(memory);
    free(scratch);
    return status == PLT_OK ? best : 0.0;
}

static void measure(const mesh *m, const char *name) {
    const uint32_t count = (uint32_t)m->triangles;
    plt_record *records = malloc(count * sizeof *records + 1);
    for (uint32_t i = 0; i < count && records != NULL; i++) {
        pack_record(&records[i], m, i);
    }
    if (records != NULL) {
        const double thesis = thesis_seconds(records, count),
                     blocks = blocks_seconds(records, count);
        printf(
            "    %s: %u triangles; thesis nodes %.4f s, %.3f million per second; compact blocks "
            "%.4f s, %.3f\n",
            name, (unsigned)count, thesis, 1e-6 * count / thesis, blocks, 1e-6 * count / blocks);
        CHECK(thesis > 0.0 && blocks > 0.0, "%s: not built", name);
    }
    free(records);
}

int main(int argc, char **argv) {
    return measure_meshes(argc, argv, "both builders, triangles per second on one core", measure);
}
