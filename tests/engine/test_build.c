/* test_build - what the builder promises of every tree
 *
 * SPDX-License-Identifier: MIT */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "engine/builder/build.h"
#include "engine/engine.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/tree_check.h"
#include "tests/test.h"

#define SCENES 12

static mesh make(int scene) {
    mesh m = {0};
    fail f = {""};
    switch (scene) {
    case 0:
        shape_soup(&m, rig_triangles(900, 1), 0.3f, 3);
        break;
    case 1:
    case 2:
    case 3:
        shape_sheet(&m, rig_is_tiny() ? 7 : 15, scene - 1);
        break;
    case 4:
        shape_coincident(&m, rig_triangles(300, 1) - 2);
        break;
    case 5:
        shape_degenerate(&m);
        break;
    case 6:
        shape_exponential(&m, rig_triangles(600, 1)); /* 120 different ones, repeated */
        break;
    case 7:
        shape_exponential(&m, 100);
        break;
    case 8:
        scene_knot(&m, rig_triangles(4000, 1), &f);
        break;
    case 9:
        scene_terrain(&m, rig_triangles(4000, 1), &f);
        break;
    case 10:
        shape_soup(&m, 100, 0.1f, 5);
        shape_transform(&m, 1e-30f, 1.0f, 2.0f, -3.0f); /* all in one point */
        break;
    default:
        shape_icosphere(&m, 1);
        shape_transform(&m, 1e9f, 1e12f, -1e12f, 0.0f); /* few steps of a float across */
    }
    return m;
}

static void look(const packed *image, int scene) {
    const tree_view v = tree_view_of(image);
    const tree_facts facts = tree_check(&v);
    const plt_info *i = &image->info;
    CHECK(facts.broken == 0, "scene %d, %u triangles, K %u: %s (%u times)", scene, i->triangles,
          i->leaf_triangles, facts.sentence, facts.broken);
    CHECK(facts.levels <= PLT_DEPTH_MAX, "scene %d: %u levels", scene, facts.levels);
    CHECK(facts.longest_list <= i->leaf_triangles, "scene %d: a list of %u", scene,
          facts.longest_list);
    CHECK(i->nodes <= plt_build_nodes_bound(i->triangles), "scene %d: %u nodes", scene, i->nodes);
    CHECK(i->node_slots <= plt_build_slots_bound(i->nodes, i->treelet_nodes), "scene %d: %u slots",
          scene, i->node_slots);
}

static void pack_and_look(const mesh *m, int scene, uint32_t k, uint32_t n, uint8_t splits) {
    const pack_options options = {splits, PLT_BUILD_HOST, k, n, NULL, 0, NULL, 0, 0};
    packed image, again;
    fail f = {""};
    CHECK(pack_mesh(&image, m, &options, "test", &f) == 0, "scene %d: %s", scene, f.text);
    CHECK(pack_mesh(&again, m, &options, "test", &f) == 0, "scene %d: %s", scene, f.text);
    if (image.bytes != NULL && again.bytes != NULL) {
        look(&image, scene);
        CHECK(image.size == again.size && memcmp(image.bytes, again.bytes, image.size) == 0,
              "scene %d: two builds differ", scene);
    }
    pack_free(&image);
    pack_free(&again);
}

static void every_scene(void) {
    static const uint32_t sizes[4] = {1, 2, 8, 300};
    for (int scene = 0; scene < SCENES; scene++) {
        mesh m = make(scene);
        for (uint32_t k = 1; k <= 4; k++) {
            for (int n = 0; n < 4; n++) {
                pack_and_look(&m, scene, k, sizes[n], PLT_SPLIT_SAH);
                pack_and_look(&m, scene, k, sizes[n], PLT_SPLIT_MEDIAN);
            }
        }
        mesh_free(&m);
    }
}

static void few_triangles(void) {
    for (uint32_t count = 0; count < 40; count++) {
        mesh m = {0};
        shape_soup(&m, count, 0.5f, count);
        for (uint32_t k = 1; k <= 4; k *= 2) {
            pack_and_look(&m, (int)count, k, 3, PLT_SPLIT_SAH);
            pack_and_look(&m, (int)count, k, 3, PLT_SPLIT_MEDIAN);
        }
        mesh_free(&m);
    }
}

static uint32_t same; /* trees of devices that were compared */

/* The device's nodes and records, in its arena, equal those of the host's image. */
static void same_on_device(int scene, uint32_t k, uint32_t n, uint8_t splits) {
    mesh m = make(scene);
    rig host, device;
    rig_config host_config = rig_config_of(k, n, PLT_BUILD_HOST, splits);
    host_config.pack.checks = 0; /* of what is streamed, in id words: a device has none */
    const rig_config device_config = rig_config_of(k, n, PLT_BUILD_DEVICE, splits);
    const int a = rig_open(&host, &m, &host_config), b = rig_open(&device, &m, &device_config);
    CHECK(a == b, "scene %d: host %d, device %d", scene, a, b);
    CHECK(a == PLT_OK || (a == PLT_ERR_LIMIT && rig_is_tiny()), "scene %d: %s", scene,
          host.fault.message);
    if (a == PLT_OK && b == PLT_OK) {
        const plt_tree *h = &host.engine->scene.thesis, *d = &device.engine->scene.thesis;
        plt_info hi = *plt_engine_info(host.engine), di = *plt_engine_info(device.engine);
        CHECK(h->root == d->root && h->node_slots == d->node_slots, "scene %d: root, slots", scene);
        CHECK(memcmp(h->nodes, d->nodes, 32 * (size_t)h->node_slots) == 0, "scene %d: nodes",
              scene);
        CHECK(memcmp(h->records, d->records, 40 * (size_t)h->records_count) == 0,
              "scene %d: records", scene);
        /* everything in plt_info except where the tree was built */
        di.image_bytes = hi.image_bytes;
        di.node_bytes = hi.node_bytes;
        di.build = hi.build;
        CHECK(memcmp(&hi, &di, offsetof(plt_info, build)) == 0, "scene %d: counts", scene);
        same++;
    }
    rig_close(&host);
    rig_close(&device);
    mesh_free(&m);
}

/* Room and scratch of any size: the same tree or a refusal, never a write beyond. */
static void short_of_room(uint32_t n) {
    mesh m = {0};
    fail f = {""};
    shape_soup(&m, 100, 0.4f, 9);
    const pack_options options = {PLT_SPLIT_SAH, PLT_BUILD_DEVICE, 1, n, NULL, 0, NULL, 0, 0};
    packed image;
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    const uint32_t bound = plt_build_slots_bound(plt_build_nodes_bound(100), n);
    int built = 0, refused = 0;
    for (uint32_t room = 0; room <= bound; room++) {
        plt_record *records = malloc(100 * sizeof *records);
        plt_node *nodes = malloc(room * sizeof *nodes + 1);
        plt_build_job job = {.records = records,
                             .count = 100,
                             .nodes = nodes,
                             .room = room,
                             .leaf_triangles = 1,
                             .treelet_nodes = n,
                             .splits = PLT_SPLIT_SAH,
                             .scratch_bytes = plt_build_scratch_bytes(98, n)};
        memcpy(records, image.bytes + 256, 100 * sizeof *records);
        job.scratch = aligned_alloc(16, (job.scratch_bytes + 15) / 16 * 16);
        const int status = plt_build(&job);
        CHECK(status == PLT_OK || status == PLT_ERR_ARENA, "room %u: %d", room, status);
        CHECK(status != PLT_OK || job.node_slots <= room, "room %u: %u slots", room,
              job.node_slots);
        CHECK(status == PLT_OK || !built, "room %u is refused, less was enough", room);
        built += status == PLT_OK;
        refused += status != PLT_OK;
        free(records);
        free(nodes);
        free(job.scratch);
    }
    CHECK(built > 0 && refused > 0, "%d built, %d refused", built, refused);
    pack_free(&image);
    mesh_free(&m);
}

/* As many triangles as the levels can hold, and one more. */
static void depth_limit(void) {
    const uint32_t most = rig_is_tiny() ? rig_triangles(0xFFFFFFFF, 1) : 0;
    for (uint32_t more = 0; more < 2 && most > 0; more++) {
        mesh m = {0};
        packed image;
        fail f = {""};
        const pack_options options = {PLT_SPLIT_SAH, PLT_BUILD_HOST, 1, 2, NULL, 0, NULL, 0, 0};
        shape_exponential(&m, most + more);
        CHECK((pack_mesh(&image, &m, &options, "test", &f) == 0) == (more == 0), "%u: %s",
              most + more, f.text);
        pack_free(&image);
        mesh_free(&m);
    }
    plt_build_job job = {.count = PLT_INDEX_MAX, .leaf_triangles = 1, .treelet_nodes = 1};
    CHECK(PLT_DEPTH_MAX > 27 || job.count > most, "no tree of 27 levels fits");
}

int main(void) {
    test(
        "boxes tight, each triangle in one list, at most K per list, no node of two lists, the "
        "same "
        "twice");
    every_scene();
    test("the same for 0 to 39 triangles");
    few_triangles();
    test("a device's tree is byte for byte the host's");
    for (int scene = 0; scene < SCENES; scene++) {
        same_on_device(scene, 1, 2, PLT_SPLIT_SAH);
        same_on_device(scene, 2, 8, PLT_SPLIT_MEDIAN);
        same_on_device(scene, 4, 3, PLT_SPLIT_SAH);
    }
    CHECK(same >= (rig_is_tiny() ? 28u : 3u * SCENES), "only %u trees were compared", same);
    test("with less room than the bound a tree is built whole or refused");
    short_of_room(1);
    short_of_room(2);
    short_of_room(7);
    test("the depth that this build allows is used up to the last level");
    depth_limit();
    return test_done();
}
