/* test_grid_counts [MESH...] - how many tests of a ray and a triangle a grid takes
 *
 * Without the mailbox, without the culling of triangles beside a packet, and with both, as in the
 * paper's table for a hand; and with groups of four rays looked at, too. Counts are the same on
 * every machine, so those of a mesh that is made here are compared exactly; of a MESH (the hand:
 * 14 million without, 0.9 with both, it says there) it is how much they save. Hits are the same
 * throughout. And how many slices and cells macro cells save, in frames.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "engine/trace/grid_state.h"
#include "host_tools/scenes/scenes.h"
#include "tests/measure/animation.h"
#include "tests/measure/meshes.h"
#include "tests/reference/frame_rays.h"
#include "tests/reference/grid_rig.h"

enum { SIDE = 256, PACKET = 8, KINDS = 5 };

static const struct {
    const char *name;
    uint8_t without;
} kinds[KINDS] = {
    {"neither", PLT_GRID_WITHOUT_MAILBOX | PLT_GRID_WITHOUT_CULLING | PLT_GRID_WITHOUT_GROUPS},
    {"the mailbox", PLT_GRID_WITHOUT_CULLING | PLT_GRID_WITHOUT_GROUPS},
    {"culling", PLT_GRID_WITHOUT_MAILBOX | PLT_GRID_WITHOUT_GROUPS},
    {"both", PLT_GRID_WITHOUT_GROUPS},
    {"groups, too", 0}};

/* Of four rays each. 0: such packets are not possible. */
static int counted(const mesh *m, uint32_t side, uint64_t count[KINDS]) {
    grid_rig g;
    rig_config c = rig_config_of(4, 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.packet_side = PACKET;
    if (rig_is_tiny() || PLT_PACKET_SIDE_MAX < PACKET ||
        !grid_rig_open(&g, m, &c, (size_t)80 * m->triangles)) {
        return 0;
    }
    const uint32_t rays = side * side;
    plt_ray *ray = frame_rays(m, side, PACKET);
    plt_hit *due = malloc(rays * sizeof *due), *hits = malloc(rays * sizeof *hits);
    CHECK(plt_trace(g.tree.engine, ray, due, rays, 0) == PLT_OK, "traced");
    for (int k = 0; k < KINDS; k++) {
        plt_stats q;
        plt_grid_state_of(&g.engine->traversal)->without = kinds[k].without;
        plt_stats_reset(g.engine);
        CHECK(plt_trace(g.engine, ray, hits, rays, 0) == PLT_OK, "traced");
        CHECK(memcmp(hits, due, rays * sizeof *hits) == 0, "with %s: other hits", kinds[k].name);
        plt_stats_get(g.engine, &q);
        count[k] = q.triangle_tests;
        printf("    with %-12s %9.6f million tests of a ray and a triangle\n", kinds[k].name,
               4e-6 * (double)count[k]);
    }
    free(ray);
    free(due);
    free(hits);
    grid_rig_close(&g);
    return 1;
}

static void of_marbles(void) {
    static const uint64_t due[KINDS] = {1344843, 609293, 558221, 149292, 61184};
    uint64_t count[KINDS];
    mesh m = {0};
    fail f = {""};
    test("a tray of marbles: as many tests with and without mailbox and culling as ever");
    CHECK(scene_marbles(&m, SCENE_MARBLES_MOST, 40, &f) == 0, "%s", f.text);
    if (counted(&m, SIDE, count)) {
        for (int k = 0; k < KINDS; k++) {
            CHECK(count[k] == due[k], "with %s: %llu, not %llu", kinds[k].name,
                  (unsigned long long)count[k], (unsigned long long)due[k]);
        }
    }
    mesh_free(&m);
}

/* ---- macro cells -------------------------------------------------------------------------- */

typedef struct slices {
    uint64_t steps, cells; /* a step goes through a slice, or past a slab that is empty */
} slices;

#if PLT_WITH_MACRO_CELLS
static slices slices_of(plt_engine *e, const plt_frame *frame, uint8_t without, uint64_t hash) {
    plt_stats q;
    plt_grid_state_of(&e->traversal)->without = without;
    plt_stats_reset(e);
    const frame_result r = frame_render(e, frame, 1);
    CHECK(r.status == PLT_OK && r.hash == hash, "another frame");
    free(r.rgb);
    plt_stats_get(e, &q);
    const slices s = {r.steps - r.tiles, q.node_visits};
    return s;
}

/* With macro cells, and without. 0: such packets are not possible. */
static int count_slices(const mesh *m, uint16_t side, uint8_t packet, slices of[2]) {
    grid_rig g;
    rig_config c = rig_config_of(4, 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.packet_side = packet;
    if (rig_is_tiny() || PLT_PACKET_SIDE_MAX < packet ||
        !grid_rig_open(&g, m, &c, (size_t)80 * m->triangles)) {
        return 0;
    }
    float lo[3], hi[3];
    shape_box(m, lo, hi);
    const plt_frame frame = animation_view(lo, hi, 0.0, 0, 0, side);
    const uint64_t hash = frame_hash(g.tree.engine, &frame, 1000000);
    of[0] = slices_of(g.engine, &frame, 0, hash);
    of[1] = slices_of(g.engine, &frame, PLT_GRID_WITHOUT_MACRO, hash);
    printf(
        "    %ux%u in %ux%u: %llu slices and slabs, %llu cells; without macro cells %llu slices, "
        "%llu cells\n",
        side, side, packet, packet, (unsigned long long)of[0].steps,
        (unsigned long long)of[0].cells, (unsigned long long)of[1].steps,
        (unsigned long long)of[1].cells);
    grid_rig_close(&g);
    return 1;
}
#else
static int count_slices(const mesh *m, uint16_t side, uint8_t packet, slices of[2]) {
    (void)m;
    (void)side;
    (void)packet;
    (void)of;
    return 0;
}
#endif

static void of_macro_cells(void) {
    slices of[2];
    mesh m = {0};
    fail f = {""};
    test("a knot: as many slices and cells with and without macro cells as ever");
    CHECK(scene_knot(&m, 20000, &f) == 0, "%s", f.text);
    if (count_slices(&m, SIDE, PACKET, of)) {
        CHECK(of[0].steps == 8167 && of[0].cells == 21086, "%llu, %llu",
              (unsigned long long)of[0].steps, (unsigned long long)of[0].cells);
        CHECK(of[1].steps == 14320 && of[1].cells == 22348, "without: %llu, %llu",
              (unsigned long long)of[1].steps, (unsigned long long)of[1].cells);
    }
    mesh_free(&m);
}

/* Mailbox and culling take off at least six of seven, groups at least nine of ten. */
static void of_mesh(const mesh *m, const char *name) {
    uint64_t count[KINDS];
    printf("  %s, %zu triangles\n", name, m->triangles);
    if (counted(m, 512, count)) {
        CHECK(count[1] < count[0] && count[2] < count[0], "each takes off some");
        CHECK(7 * count[3] <= count[0], "both take off no more than %.1f times",
              (double)count[0] / (double)count[3]);
        CHECK(10 * count[4] <= count[0], "groups take off no more than %.1f times",
              (double)count[0] / (double)count[4]);
    }
    slices of[2];
    if (count_slices(m, 512, 16, of)) {
        CHECK(of[0].steps <= of[1].steps && of[0].cells <= of[1].cells, "macro cells add some");
    }
}

int main(int argc, char **argv) {
    of_marbles();
    of_macro_cells();
    return argc > 1 ? measure_meshes(argc, argv, "meshes that are given", of_mesh) : test_done();
}
