/* test_refit_speed [MESH...] - triangles per second of a refit, alone and with records rewritten
 *
 * Of thesis nodes, on one core: the best of ten, every vertex moved. Without a mesh it takes a
 * small one and is one test more; the figures are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/motion/refit.h"
#include "host_tools/base/clock.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

enum { ROUNDS = 10 };

static void fill_corners(float (*corners)[9], const mesh *m, float scale) {
    for (size_t i = 0; i < 9 * m->triangles; i++) {
        ((float *)corners)[i] = scale * m->vertex[3 * (size_t)m->triangle[i / 3] + i % 3];
    }
}

static double best_of(double best, double began, int round) {
    const double took = clock_processor_seconds() - began;
    return round == 0 || took < best ? took : best;
}

/* Bounds and nodes alone: of what has moved already. */
static double refit_seconds(plt_engine *e, int round, double best) {
    plt_refit_job job = {.nodes = (plt_node *)(uintptr_t)e->scene.thesis.nodes,
                         .records = e->scene.thesis.records,
                         .root = e->scene.thesis.root,
                         .levels = e->moving.levels};
    const double began = clock_processor_seconds();
    plt_refit(&job);
    return best_of(best, began, round);
}

static void run(rig *r, const mesh *m, const char *name, uint32_t k) {
    const double millions = 1e-6 * (double)m->triangles;
    double refit = 0, whole = 0;
    float(*corners)[9] = malloc(m->triangles * sizeof *corners);
    for (int i = 0; i < ROUNDS; i++) {
        fill_corners(corners, m, i % 2 ? 1.0f : 1.5f);
        const double began = clock_processor_seconds();
        CHECK(plt_move(r->engine, (const float(*)[9])corners, &r->fault) == PLT_OK, "%s",
              r->fault.message);
        whole = best_of(whole, began, i);
        refit = refit_seconds(r->engine, i, refit);
    }
    free(corners);
    printf(
        "    %s, K = %u: bounds and nodes %.1f million triangles per second, with records "
        "%.1f\n",
        name, (unsigned)k, millions / refit, millions / whole);
}

static void measure(const mesh *m, const char *name) {
    for (uint32_t k = 1; k <= 4; k *= 2) {
        rig_config c = rig_config_of(k, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
        rig r;
        c.run.movable = 1;
        CHECK(rig_open(&r, m, &c) == PLT_OK, "%s: %s", name, r.fault.message);
        run(&r, m, name, k);
        rig_close(&r);
    }
}

int main(int argc, char **argv) {
    test("a refit, triangles per second on one core");
    for (int i = 1; i < argc || i == 1; i++) {
        mesh m = {0};
        mesh_report report = {0};
        fail f = {""};
        const int status = i < argc ? mesh_read(&m, argv[i], 0, &report, &f)
                                    : scene_knot(&m, rig_is_tiny() ? 100 : 20000, &f);
        CHECK(status == 0, "%s", f.text);
        if (status == 0) {
            measure(&m, i < argc ? argv[i] : "knot");
        }
        mesh_free(&m);
    }
    return test_done();
}
