/* test_tree_treelets - treelets, and the stacks that traversing them needs
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/tree_check.h"
#include "tests/test.h"

static const uint32_t treelet_sizes[] = {1, 2, 3, 7, 8, 16, 64, 256, 512, 10000};
#define SIZES (sizeof treelet_sizes / sizeof treelet_sizes[0])
#define SCENES 6

/* Two clusters of triangles, one stretched out so that the root's treelet is a chain and
 * treelets far below are bushy. */
static void chain_then_bush(mesh *m, uint32_t triangles) {
    fail f = {""};
    shape_soup(m, triangles - 40 < triangles ? triangles - 40 : 1, 0.05f, 4);
    shape_transform(m, 1e-6f, 0.0f, 0.0f, 0.0f);
    for (int i = 0; i < 40 && m->triangles < triangles; i++) {
        const float x = (float)(1u << (i < 30 ? i : 30)) * 1e-5f;
        const uint32_t first = (uint32_t)m->vertices;
        mesh_add_vertex(m, x, 0.0f, 0.0f, &f);
        mesh_add_vertex(m, x * 1.01f, 0.0f, 1e-6f, &f);
        mesh_add_vertex(m, x, 1e-6f, 0.0f, &f);
        mesh_add_triangle(m, first, first + 1, first + 2, &f);
    }
}

static mesh make(int scene) {
    mesh m = {0};
    fail f = {""};
    switch (scene) {
    case 0:
        scene_knot(&m, rig_triangles(3000, 1), &f);
        break;
    case 1:
        scene_terrain(&m, rig_triangles(5000, 1), &f);
        break;
    case 2:
        shape_soup(&m, rig_triangles(700, 1), 0.4f, 2);
        break;
    case 3:
        shape_exponential(&m, 60);
        break;
    case 4:
        chain_then_bush(&m, rig_triangles(400, 1));
        break;
    default:
        shape_coincident(&m, 70);
    }
    return m;
}

static int packed_as(packed *image, const mesh *m, uint32_t k, uint32_t n, uint8_t splits) {
    fail f = {""};
    const pack_options options = {splits, PLT_BUILD_HOST, k, n, NULL, 0, NULL, 0, 0};
    const int status = pack_mesh(image, m, &options, "test", &f);
    CHECK(status == 0, "%s", f.text);
    return status == 0;
}

static void each_image(void (*look)(const packed *image, int scene)) {
    for (int scene = 0; scene < SCENES; scene++) {
        mesh m = make(scene);
        for (size_t n = 0; n < SIZES; n++) {
            for (uint32_t k = 1; k <= 4; k *= 2) {
                packed image;
                if (packed_as(&image, &m, k, treelet_sizes[n], (uint8_t)(k % 2))) {
                    look(&image, scene);
                }
                pack_free(&image);
            }
        }
        mesh_free(&m);
    }
}

static void well_formed(const packed *image, int scene) {
    const tree_view v = tree_view_of(image);
    const tree_facts facts = tree_check(&v);
    const plt_info *i = &image->info;
    CHECK(facts.broken == 0, "scene %d, K %u, N %u: %s", scene, i->leaf_triangles, i->treelet_nodes,
          facts.sentence);
    CHECK(i->nodes == 0 || v.root >> 5 == 0, "the root is in slot %u", v.root >> 5);
    CHECK(facts.treelets == i->treelets && facts.nodes == i->nodes &&
              facts.lists == i->leaf_lists && facts.twos == i->intermediate_lists,
          "scene %d, K %u, N %u: counts", scene, i->leaf_triangles, i->treelet_nodes);
    CHECK(facts.largest_treelet <= i->treelet_nodes, "%u nodes", facts.largest_treelet);
    CHECK(i->node_slots % i->treelet_nodes == 0, "%u slots", i->node_slots);
}

static uint32_t exact, wider;

/* Table 5.5: only the last block has free slots. Where the slot rule does not reach that, whole
 * blocks are lost. */
static void overhead(int scene, uint32_t triangles) {
    mesh m = {0};
    fail f = {""};
    (scene == 0 ? scene_knot : scene_terrain)(&m, rig_triangles(triangles, 1), &f);
    for (size_t n = 0; n < SIZES; n++) {
        packed image;
        if (packed_as(&image, &m, 1, treelet_sizes[n], PLT_SPLIT_MEDIAN)) {
            const uint32_t nodes = image.info.nodes, size = treelet_sizes[n];
            const uint32_t due = (size - nodes % size) % size;
            const uint32_t found = image.info.node_slots - nodes;
            /* Treelets larger than half a block do not share one: here only the bound is
             * checked. */
            const uint32_t most = size <= 16 && !rig_is_tiny() ? due : due + nodes / 4 + size;
            CHECK(found <= most, "%s, N %u: %u nodes, %u free slots, not %u",
                  scene == 0 ? "knot" : "terrain", size, nodes, found, due);
            exact += found == due;
            wider += found != due;
        }
        pack_free(&image);
    }
    mesh_free(&m);
}

static void needs(const packed *image, int scene) {
    tree_view v = tree_view_of(image);
    const tree_facts facts = tree_check(&v);
    const plt_info *i = &image->info;
    CHECK(facts.local == i->local_stack_entries, "scene %d, K %u, N %u: local %u, not %u", scene,
          i->leaf_triangles, i->treelet_nodes, i->local_stack_entries, facts.local);
    CHECK(facts.global == i->global_stack_entries, "scene %d, K %u, N %u: global %u, not %u", scene,
          i->leaf_triangles, i->treelet_nodes, i->global_stack_entries, facts.global);
    CHECK(facts.depth == i->depth_stack_entries, "scene %d, K %u, N %u: depth %u, not %u", scene,
          i->leaf_triangles, i->treelet_nodes, i->depth_stack_entries, facts.depth);
}

static void reached(const packed *image, int scene) {
    tree_view v = tree_view_of(image);
    tree_traversal t = {.order = tree_deepest_order, .context = &v};
    const plt_info *i = &image->info;
    tree_traverse_depth_first(&v, &t);
    t.order = tree_bushiest_order;
    tree_traverse_two_stage(&v, &t);
    CHECK(t.local == i->local_stack_entries && t.global == i->global_stack_entries &&
              t.depth == i->depth_stack_entries,
          "scene %d, K %u, N %u: local %u of %u, global %u of %u, depth %u of %u", scene,
          i->leaf_triangles, i->treelet_nodes, t.local, i->local_stack_entries, t.global,
          i->global_stack_entries, t.depth, i->depth_stack_entries);
}

static unsigned any_order(void *context, uint32_t node, uint32_t left, uint32_t right) {
    const uint64_t bits = random_bits(context);
    (void)node, (void)left, (void)right;
    return (bits & 7) == 0 ? (unsigned)(bits >> 8 & 7) : 3u | (unsigned)(bits >> 8 & 4);
}

static void never_exceeded(const packed *image, int scene) {
    const tree_view v = tree_view_of(image);
    random_state r = {(uint64_t)scene};
    const plt_info *i = &image->info;
    for (int round = 0; round < 10; round++) {
        tree_traversal t = {.order = any_order, .context = &r};
        tree_traverse_depth_first(&v, &t);
        tree_traverse_two_stage(&v, &t);
        CHECK(t.local <= i->local_stack_entries && t.global <= i->global_stack_entries &&
                  t.depth <= i->depth_stack_entries,
              "scene %d, K %u, N %u", scene, i->leaf_triangles, i->treelet_nodes);
    }
}

int main(void) {
    test("treelets are connected, breadth first, inside blocks; free slots are zero");
    each_image(well_formed);
    test(
        "median scenes have free slots in the last block only, except for some with N = 64 and "
        "256");
    overhead(0, 4000);
    overhead(0, 20000);
    overhead(1, 3000);
    overhead(1, 20000);
    CHECK(wider * (rig_is_tiny() ? 4 : 8) < exact, "%u of %u images lose a block", wider,
          exact + wider);
    test("the header's stack needs are those that plain recursion computes");
    each_image(needs);
    test("the stack needs are reached by the worst order");
    each_image(reached);
    test("no random order exceeds the stack needs");
    each_image(never_exceeded);
    return test_done();
}
