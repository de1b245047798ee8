/* test_tables_figure_42 - the reference for Table 5.6 has the hits of all structures
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/baselines/structure.h"
#include "host_tools/scenes/scenes.h"
#include "host_tools/tables/figure_42.h"
#include "tests/test.h"

enum { SIDE = 64, RAYS = SIDE * SIDE };

static plt_ray ray[RAYS];
static plt_hit due[RAYS], got[RAYS];

/* From one side of a knot in packets of 4x4, some of which miss, and some that are no rays. */
static void make_rays(void) {
    for (uint32_t i = 0; i < RAYS; i++) {
        const uint32_t tile = i / 16, x = 4 * (tile % (SIDE / 4)) + i % 4,
                       y = 4 * (tile / (SIDE / 4)) + i % 16 / 4;
        ray[i] = (plt_ray){.org = {0.5f, 0.3f, 12.0f},
                           .dir = {(float)x / SIDE - 0.5f, (float)y / SIDE - 0.5f, -1.0f},
                           .tmax = 1e30f};
        if (i % 97 == 0) {
            ray[i].tmax = -1.0f;
        }
    }
}

static void trace_due(const mesh *m) {
    const structure_options options = {.packet_side = 4};
    fail f = {""};
    built_structure *s = structure_open(structure_find("bph"), m, &options, "test", &f);
    CHECK(s != NULL && structure_trace(s, ray, due, RAYS, 0, &f) == 0, "%s", f.text);
    structure_close(s);
}

/* Node visits per packet. */
static double visit_all(const mesh *m, uint32_t size, int near_last) {
    figure_42 *t = calloc(1, sizeof *t);
    double nodes = 0.0;
    CHECK(figure_42_open(t, m, size) == 0, "no memory");
    t->near_last = near_last;
    memset(got, 7, sizeof got);
    CHECK(figure_42_trace(t, ray, got, RAYS) == 0, "no memory");
    CHECK(memcmp(due, got, sizeof due) == 0, "treelets of %u: other hits", size);
    CHECK(t->packets > 0 && t->packets <= RAYS / 16, "%lu packets", (unsigned long)t->packets);
    nodes = (double)t->nodes / (double)t->packets;
    figure_42_close(t);
    free(t);
    return nodes;
}

int main(void) {
    static const uint32_t sizes[] = {1, 2, 3, 7, 64, 512, 10000};
    double last = 0.0, most = 0.0;
    uint32_t hits = 0;
    mesh m = {0}, small = {0};
    fail f = {""};
    make_rays();
    scene_knot(&m, 3000, &f);
    trace_due(&m);
    for (uint32_t i = 0; i < RAYS; i++) {
        hits += due[i].triangle != PLT_MISS;
    }
    test("hits are those of the BPH, bit for bit, in treelets of any size");
    CHECK(hits > RAYS / 20 && hits < RAYS, "%u hits", hits);
    for (unsigned i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        const double plain = visit_all(&m, sizes[i], 0), near = visit_all(&m, sizes[i], 1);
        CHECK(near < 1.02 * plain && (near < plain || sizes[i] < 64 || sizes[i] > 512),
              "%u: %g, near last %g", sizes[i], plain, near);
        last = plain;
        most = plain > most ? plain : most;
    }
    test("where all nodes are one treelet, no hit saves any");
    CHECK(last == most && last == visit_all(&m, 10000, 1), "%g of %g", last, most);
    test("a scene without nodes, and none at all");
    mesh_add_vertex(&small, 0.0f, 0.0f, 0.0f, &f);
    mesh_add_vertex(&small, 1.0f, 0.0f, 0.0f, &f);
    mesh_add_vertex(&small, 0.0f, 1.0f, 0.0f, &f);
    for (unsigned triangles = 0; triangles < 2; triangles++) {
        trace_due(&small);
        CHECK(visit_all(&small, 8, 1) == 0.0, "%u triangles", triangles);
        mesh_add_triangle(&small, 0, 1, 2, &f);
    }
    mesh_free(&m);
    mesh_free(&small);
    return test_done();
}
