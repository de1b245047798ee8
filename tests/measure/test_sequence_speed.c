/* test_sequence_speed [MESH...] - triangles per second of frames that an image holds
 *
 * Of thesis nodes, on one core: the best of ten. Blocks decoded and checked; records written from
 * vertices and indices; bounds and nodes; the last two together, which is what is compared with
 * corners that a caller gives (test_refit_speed). Without a mesh it takes a small one and is one
 * test more; the figures are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/motion/vertices.h"
#include "engine/move.h"
#include "host_tools/base/clock.h"
#include "tests/measure/meshes.h"
#include "tests/measure/two_frames.h"

enum { ROUNDS = 10 };

typedef struct speeds {
    double decode, records, bounds, corners; /* seconds, the best */
} speeds;

static double best_of(double best, double began, int round) {
    const double took = clock_processor_seconds() - began;
    return round == 0 || took < best ? took : best;
}

static void take_corners(plt_engine *e, const mesh *m, speeds *best, int round) {
    float(*corners)[9] = malloc(m->triangles * sizeof *corners);
    plt_fault fault;
    for (size_t i = 0; i < 9 * m->triangles; i++) {
        ((float *)corners)[i] = m->vertex[3 * (size_t)m->triangle[i / 3] + i % 3];
    }
    const double began = clock_processor_seconds();
    CHECK(plt_move(e, (const float(*)[9])corners, &fault) == PLT_OK, "%s", fault.message);
    best->corners = best_of(best->corners, began, round);
    free(corners);
}

static void take_frames(plt_engine *e, speeds *best, int round) {
    plt_fault fault;
    int status = plt_sequence_show(e, 0, &fault);
    double began = clock_processor_seconds();
    status += plt_sequence_begin(e, 1, &fault) + plt_sequence_step(e, UINT32_MAX, &fault);
    best->decode = best_of(best->decode, began, round);
    CHECK(status == PLT_OK, "%s", fault.message);
    began = clock_processor_seconds();
    plt_vertices_put(plt_records_of(e), e->scene.info.triangles, &e->sequence.vertices);
    best->records = best_of(best->records, began, round);
    began = clock_processor_seconds();
    plt_refit_all(e);
    plt_moved(e);
    best->bounds = best_of(best->bounds, began, round);
}

static void run(const packed *image, const mesh *m, const char *name, uint32_t k, uint32_t bits) {
    const plt_options o = {.packet_side = 2, .movable = 1};
    const plt_source source = rig_source(image);
    const size_t bytes = plt_arena_need(&image->info, 1, &o);
    const double millions = 1e-6 * (double)m->triangles;
    void *arena = aligned_alloc(PLT_ALIGN, bytes);
    plt_engine *e;
    plt_fault fault;
    speeds best = {0, 0, 0, 0};
    CHECK(plt_open(&e, arena, bytes, &source, &o, &fault) == PLT_OK, "%s", fault.message);
    for (int i = 0; i < ROUNDS && e != NULL; i++) {
        take_frames(e, &best, i);
        take_corners(e, m, &best, i);
    }
    free(arena);
    printf(
        "    %s, K = %u, %s%.0u: million triangles per second: decoded %.1f, records %.1f, bounds "
        "and nodes %.1f, the last two %.1f, from corners %.1f\n",
        name, k, bits > 0 ? "lattice:" : "float", bits, millions / best.decode,
        millions / best.records, millions / best.bounds, millions / (best.records + best.bounds),
        millions / best.corners);
}

static void measure(const mesh *m, const char *name) {
    for (uint32_t k = 1; k <= 4; k *= 2) {
        for (uint32_t bits = 0; bits <= 16; bits += 16) {
            packed image;
            pack_frames(&image, m, k, bits);
            run(&image, m, name, k, bits);
            pack_free(&image);
        }
    }
}

int main(int argc, char **argv) {
    return measure_meshes(argc, argv, "frames of an image, triangles per second on one core",
                          measure);
}
