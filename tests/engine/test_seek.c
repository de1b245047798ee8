/* test_seek - a frame goes on with any of its tiles
 *
 * The order of a frame without a seek is kept: where each tile was, and its pixels. Then
 * every tile is looked for, from every kind of state, and is the same.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/hostile/images.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/frames.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { TILE_BYTES = 3 * PLT_TILE_SIDE * PLT_TILE_SIDE, VISITS = 1000 };

typedef struct kept {
    uint16_t x, y, width, height;
    uint8_t rgb[TILE_BYTES];
} kept;

static const float eye[3] = {1.5f, 1.2f, 2.5f}, centre[3] = {0.5f, 0.5f, 0.5f};

/* The next tile; 0: there is none. */
static int next(plt_engine *e, kept *k) {
    int status = PLT_MORE;
    while (status == PLT_MORE) {
        status = plt_render_step(e, VISITS);
    }
    if (status != PLT_TILE) {
        CHECK(status == PLT_OK, "status %d", status);
        return 0;
    }
    plt_tile tile;
    plt_render_tile(e, &tile);
    memset(k, 0, sizeof *k);
    k->x = tile.x;
    k->y = tile.y;
    k->width = tile.width;
    k->height = tile.height;
    memcpy(k->rgb, tile.rgb, 3u * tile.width * tile.height);
    return 1;
}

static uint32_t tiles_of(const plt_frame *f) {
    return (f->width + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE *
           ((f->height + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE);
}

static void expect(plt_engine *e, const kept *due, uint32_t tile) {
    kept found;
    CHECK(next(e, &found) && memcmp(&found, due, sizeof found) == 0,
          "tile %u: at %u, %u, not %u, %u, or other pixels", tile, found.x, found.y, due->x,
          due->y);
}

/* From the last tile to the first; after one that is half traced; and the one behind it. */
static void every_tile(plt_engine *e, const plt_frame *frame, const kept *due, uint32_t count) {
    CHECK(plt_render_begin(e, frame) == PLT_OK, "begin");
    for (uint32_t i = count; i-- > 0;) {
        CHECK(plt_render_seek(e, i, 1 + i % 3) == PLT_OK, "tile %u of %u", i, count);
        expect(e, &due[i], i);
        if (i + 1 < count && i % 3 == 0) {
            expect(e, &due[i + 1], i + 1);
        }
        for (uint32_t steps = 0; steps < i % 4 && i + 5 < count; steps++) {
            plt_render_step(e, 1);
        }
    }
}

static void refused(plt_engine *e, const plt_frame *frame, const kept *due, uint32_t count) {
    const plt_ray ray = {{0, 0, 9}, 0, {0, 0, -1}, 100};
    plt_hit hit;
    kept last;
    CHECK(plt_render_begin(e, frame) == PLT_OK && plt_render_tiles(e) == count, "%u tiles",
          plt_render_tiles(e));
    CHECK(plt_render_seek(e, count, 1) == PLT_ERR_ARGUMENT, "no tile of that number");
    CHECK(plt_render_seek(e, UINT32_MAX, 1) == PLT_ERR_ARGUMENT, "no tile of that number");
    CHECK(plt_render_seek(e, 0, 0) == PLT_ERR_ARGUMENT, "no tile is wanted");
    expect(e, &due[0], 0);
    CHECK(plt_render_seek(e, count - 1, 1) == PLT_OK, "the last");
    CHECK(next(e, &last) && !next(e, &last), "something comes behind the last tile");
    CHECK(plt_render_tiles(e) == 0 && plt_render_seek(e, 0, 1) == PLT_ERR_ARGUMENT,
          "it is complete");
    plt_render_begin(e, frame);
    plt_trace(e, &ray, &hit, 1, 0);
    CHECK(plt_render_tiles(e) == 0 && plt_render_seek(e, 0, 1) == PLT_ERR_ARGUMENT, "it was ended");
}

static void frame_of_engine(plt_engine *e, uint16_t width, uint16_t height) {
    const plt_frame frame = frame_of(eye, centre, width, height, PLT_SHADE_NORMAL);
    const uint32_t count = tiles_of(&frame);
    kept *due = calloc(count + 1, sizeof *due);
    uint32_t came = 0;
    plt_render_begin(e, &frame);
    while (came <= count && next(e, &due[came])) {
        came++;
    }
    CHECK(came == count, "%u x %u: %u tiles, not %u", width, height, came, count);
    every_tile(e, &frame, due, count);
    refused(e, &frame, due, count);
    free(due);
}

/* Less than a square of the curve, a row of them, several rows with a narrow square first. */
static void frames(plt_engine *e) {
    static const uint16_t tiles[6][2] = {{1, 1}, {3, 2}, {8, 8}, {20, 3}, {5, 19}, {19, 27}};
    for (int i = 0; i < 6 && e != NULL; i++) {
        const uint16_t width = (uint16_t)(tiles[i][0] * PLT_TILE_SIDE);
        const uint16_t height = (uint16_t)(tiles[i][1] * PLT_TILE_SIDE);
        frame_of_engine(e, width, height);
        frame_of_engine(e, (uint16_t)(width - 1), (uint16_t)(height - PLT_TILE_SIDE + 1));
    }
}

static void compact(uint8_t residency, uint16_t batch) {
    mesh m = {0};
    shape_soup(&m, compact_triangles(300, 2), 0.1f, 7);
    compact_config c = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    packed image = compact_packed(&m, &c); /* frees it */
    hostile_stream stream = {image.bytes, image.size, 0};
    const plt_source source = {NULL, image.size, &stream, hostile_start, hostile_wait};
    const plt_options options = {
        .packet_side = 2, .residency = residency, .schedule = batch > 0, .batch = batch};
    const size_t need = plt_arena_need(&image.info, 0, &options);
    void *arena = aligned_alloc(PLT_ALIGN, need);
    plt_engine *e;
    plt_fault fault;
    CHECK(plt_open(&e, arena, need, &source, &options, &fault) == PLT_OK, "%s", fault.message);
    frames(e);
    free(arena);
    pack_free(&image);
}

static void thesis(uint8_t side) {
    mesh m = {0};
    shape_soup(&m, rig_triangles(300, 2), 0.1f, 7);
    rig_config config = rig_config_of(2, 2, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    config.run.packet_side = side;
    rig r;
    CHECK(rig_open(&r, &m, &config) == PLT_OK, "%s", r.fault.message);
    frames(r.engine);
    rig_close(&r);
    mesh_free(&m);
}

int main(void) {
    test("tiles of thesis nodes, row by row");
    thesis(2);
    thesis(PLT_PACKET_SIDE_MAX);
    test("tiles of compact blocks, row by row");
    compact(PLT_RESIDENCY_WHOLE, 0);
    test("tiles of a streamed scene, along the curves");
    compact(PLT_RESIDENCY_STREAMED, 0);
    test("... by batches, which a seek drops, and which end where the tiles that are wanted do");
    compact(PLT_RESIDENCY_STREAMED, 1);
    compact(PLT_RESIDENCY_STREAMED, 7);
    compact(PLT_RESIDENCY_STREAMED, 200);
    return test_done();
}
