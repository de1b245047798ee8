/* test_refit_speed [MESH...] - triangles per second of a refit, alone and with records rewritten
 *
 * Of thesis nodes, on one core: the best of ten, every vertex moved; and what share of that it
 * takes to move 5 % of the triangles, in a region and at random. Without a mesh it takes a
 * small one and is one test more; the figures are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/motion/refit.h"
#include "host_tools/base/clock.h"
#include "tests/measure/meshes.h"

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

typedef struct near {
    float distance;
    uint32_t id;
} near;

static int by_distance(const void *a, const void *b) {
    const near *x = a, *y = b;
    return x->distance != y->distance ? (x->distance < y->distance ? -1 : 1)
                                      : (x->id < y->id ? -1 : 1);
}

/* The triangles nearest to the first one, or every twentieth. */
static void choose(uint32_t *ids, uint32_t count, const mesh *m, int in_a_region) {
    near *all = malloc(m->triangles * sizeof *all);
    const float *first = &m->vertex[3 * (size_t)m->triangle[0]];
    for (uint32_t i = 0; i < m->triangles; i++) {
        const float *p = &m->vertex[3 * (size_t)m->triangle[3 * (size_t)i]];
        all[i].id = i;
        all[i].distance = 0;
        for (int a = 0; a < 3; a++) {
            all[i].distance += (p[a] - first[a]) * (p[a] - first[a]);
        }
        if (!in_a_region) {
            all[i].distance = (float)(i * 2654435761u >> 8);
        }
    }
    qsort(all, m->triangles, sizeof *all, by_distance);
    for (uint32_t i = 0; i < count; i++) {
        ids[i] = all[i].id;
    }
    free(all);
}

/* Seconds of moving the chosen. */
static double some_seconds(rig *r, const mesh *m, int in_a_region) {
    const uint32_t count = (uint32_t)(m->triangles / 20);
    uint32_t *ids = malloc((count + 1) * sizeof *ids);
    float(*corners)[9] = malloc(m->triangles * sizeof *corners);
    float(*some)[9] = malloc((count + 1) * sizeof *some);
    double best = 0;
    choose(ids, count, m, in_a_region);
    for (int i = 0; i < ROUNDS; i++) {
        fill_corners(corners, m, i % 2 ? 1.0f : 1.01f);
        for (uint32_t k = 0; k < count; k++) {
            memcpy(some[k], corners[ids[k]], sizeof some[k]);
        }
        const double began = clock_processor_seconds();
        CHECK(plt_move_some(r->engine, ids, (const float(*)[9])some, count, &r->fault) == PLT_OK,
              "%s", r->fault.message);
        best = best_of(best, began, i);
    }
    free(ids);
    free(corners);
    free(some);
    return best;
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
    printf("    ... 5 %% of them: in a region %.3f of all, at random %.3f\n",
           some_seconds(r, m, 1) / whole, some_seconds(r, m, 0) / whole);
}

static void measure(const mesh *m, const char *name) {
    for (uint32_t k = 1; k <= 4; k *= 2) {
        rig_config c = rig_config_of(k, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
        rig r;
        c.run.movable = c.run.moves_some = 1;
        CHECK(rig_open(&r, m, &c) == PLT_OK, "%s: %s", name, r.fault.message);
        run(&r, m, name, k);
        rig_close(&r);
    }
}

int main(int argc, char **argv) {
    return measure_meshes(argc, argv, "a refit, triangles per second on one core", measure);
}
