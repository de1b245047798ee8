/* test_node_bytes [IMAGE RAYS] - how many bytes of nodes rays touch in a scene of compact blocks
 *
 * Each block once, as an ideal store would fetch it. IMAGE has compact blocks, RAYS is a file as
 * planelet trace reads it. Without them it takes a small scene and is one test more; the figures
 * are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/tree/compact/block.h"
#include "host_tools/base/input.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

typedef struct touched {
    uint64_t bytes, blocks, of;
} touched;

static int is_touched(const plt_engine *e, uint32_t address) {
    const uint32_t bit = address / 8;
    return (int)(e->traversal.touched[bit / 32] >> bit % 32 & 1u);
}

static touched count_nodes(const plt_engine *e) {
    const plt_block_tree *tree = &e->scene.compact;
    const uint32_t end = e->scene.info.node_bytes + e->scene.info.triangle_bytes;
    touched t = {0, 0, 0};
    for (uint32_t at = 0; at < end; t.of++) {
        plt_block b;
        plt_block_open(&b, tree->bytes + at, tree->lattice.bits);
        if (is_touched(e, at)) {
            t.bytes += b.node_bytes;
            t.blocks++;
        }
        at += plt_block_bytes(&b);
    }
    return t;
}

static void trace(const void *image, uint32_t bytes, const plt_ray *rays, uint32_t count) {
    const plt_source source = {.mapped = image, .bytes = bytes};
    const plt_options o = {.packet_side = PLT_PACKET_SIDE_MAX, .count_touched = 1};
    plt_info info = {0};
    plt_fault fault;
    plt_engine *e = NULL;
    plt_hit *hits = malloc((size_t)count * sizeof *hits);
    CHECK(plt_image_info(&source, &info, &fault) == PLT_OK, "%s", fault.message);
    CHECK(info.nodes_format == PLT_NODES_COMPACT, "pack it with --nodes compact");
    const size_t need = plt_arena_need(&info, 1, &o);
    void *arena = aligned_alloc(PLT_ALIGN, need / PLT_ALIGN * PLT_ALIGN + PLT_ALIGN);
    if (info.nodes_format == PLT_NODES_COMPACT &&
        plt_open(&e, arena, need, &source, &o, &fault) == PLT_OK) {
        plt_stats q;
        CHECK(plt_trace(e, rays, hits, count, 0) == PLT_OK, "the rays");
        plt_stats_get(e, &q);
        const touched t = count_nodes(e);
        printf("    %llu bytes of nodes in %llu of %llu blocks; with geometry %llu\n",
               (unsigned long long)t.bytes, (unsigned long long)t.blocks, (unsigned long long)t.of,
               (unsigned long long)q.bytes_touched_once);
        CHECK(t.bytes > 0 && t.bytes <= info.node_bytes, "of %u bytes of nodes", info.node_bytes);
        CHECK(t.bytes < q.bytes_touched_once, "without geometry");
    }
    CHECK(e != NULL, "%s", fault.message);
    free(arena);
    free(hits);
}

static void trace_small(void) {
    enum { RAYS = 4000 };
    static plt_ray rays[RAYS];
    mesh m = {0};
    random_state r = {1};
    shape_soup(&m, compact_triangles(4000, 2), 0.1f, 7);
    rays_camera(rays, RAYS, &m, &r);
    const compact_config c = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    packed image = compact_packed(&m, &c); /* frees it */
    trace(image.bytes, image.size, rays, RAYS);
    pack_free(&image);
}

static void trace_files(const char *image, const char *rays) {
    input scene = {0}, file = {0};
    fail f = {""};
    const int status = input_read(&scene, image, &f) != 0 || input_read(&file, rays, &f) != 0;
    CHECK(status == 0, "%s", f.text);
    if (status == 0) {
        trace(scene.bytes, (uint32_t)scene.size, (const plt_ray *)(const void *)file.bytes,
              (uint32_t)(file.size / sizeof(plt_ray)));
    }
    input_free(&file);
    input_free(&scene);
}

int main(int count, char **argument) {
    test("of the nodes of a scene, what rays touch is counted once");
    if (count == 3) {
        trace_files(argument[1], argument[2]);
    } else {
        trace_small();
    }
    return test_done();
}
