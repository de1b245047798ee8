/* test_wire_device - scenes and blocks over the wire, and the engine behind it
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

enum { WIDTH = 75, HEIGHT = 52, MEMORY = 1 << 18, IMAGE_MOST = 40000 };

#include "board/hash.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/wire_device_rig.h"

/* ---- a scene image ------------------------------------------------------------------ */

static struct {
    wire_peer host, device;
    wire_scene_out out;
    wire_scene_in in;
    fake_cable cable;
    uint8_t image[IMAGE_MOST], *to;
} s;

static void open_scene_pair(uint32_t bytes, uint32_t room, uint64_t seed) {
    memset(&s, 0, sizeof s);
    fake_cable_open(&s.cable, &s.host, &s.device, seed);
    for (uint32_t i = 0; i < bytes; i++) {
        s.image[i] = (uint8_t)random_bits(&s.cable.random);
    }
    s.to = malloc(room);
    wire_peer_open(&s.host, &host_setup, s.cable.now_ms);
    wire_peer_open(&s.device, &device_setup, s.cable.now_ms);
    wire_scene_out_open(&s.out, &s.host, s.image, bytes);
    wire_scene_in_open(&s.in, &s.device, s.to, room);
}

/* Steps until it is here; milliseconds, or -1. */
static int scene_comes(uint32_t most) {
    uint32_t bytes;
    for (uint32_t i = 0; i < most; i++) {
        if (wire_scene_in_state(&s.in, &bytes) == WIRE_SCENE_HERE) {
            return (int)i;
        }
        fake_cable_step(&s.cable);
    }
    return -1;
}

static void test_scene(void) {
    test("an image arrives whole, whatever its size and the cable");
    for (uint32_t n = 0; n < 60; n++) {
        const uint32_t bytes = n < 5 ? n * 120 + 1 : 200 * n;
        open_scene_pair(bytes, bytes, n);
        if (n % 3 > 0) {
            s.cable.faults =
                (fake_faults){3000, 3000, 3000, 1000, 2000, n % 4, n % 5 == 1 ? 20 : 0};
        }
        CHECK(scene_comes(60000) >= 0, "%u bytes, cable %u: %u are there", bytes, n, s.in.has);
        CHECK(memcmp(s.to, s.image, bytes) == 0, "%u bytes differ", bytes);
        free(s.to);
    }
    test("after a cut in the middle only the rest is sent");
    open_scene_pair(IMAGE_MOST, IMAGE_MOST, 99);
    s.cable.paced = 1;
    while (s.in.has < IMAGE_MOST / 2) {
        fake_cable_step(&s.cable);
    }
    const uint32_t before = s.device.stats.payload_in;
    fake_cable_unplug(&s.cable, 300);
    CHECK(scene_comes(5000) >= 0, "%u are there", s.in.has);
    const uint32_t after = s.device.stats.payload_in - before;
    CHECK(memcmp(s.to, s.image, IMAGE_MOST) == 0, "differs");
    CHECK(after < IMAGE_MOST / 2 + IMAGE_MOST / 20, "%u bytes for the second half", after);
    test("another image replaces it; one that is too large is refused and said so");
    s.image[0] ^= 1;
    wire_scene_out_open(&s.out, &s.host, s.image, 1000);
    for (int i = 0; i < 500; i++) {
        fake_cable_step(&s.cable);
    }
    uint32_t has;
    CHECK(scene_comes(10) >= 0 && memcmp(s.to, s.image, 1000) == 0, "not replaced");
    CHECK(wire_scene_out_state(&s.out, &has) == WIRE_SCENE_HERE && has == 1000, "has %u", has);
    s.in.room = 999;
    s.image[0] ^= 1;
    wire_scene_out_open(&s.out, &s.host, s.image, 1000);
    for (int i = 0; i < 500; i++) {
        fake_cable_step(&s.cable);
    }
    CHECK(wire_scene_out_state(&s.out, &has) == WIRE_SCENE_LARGE, "taken");
    free(s.to);
}

/* ---- blocks -------------------------------------------------------------------------- */

static struct {
    wire_peer host, device;
    wire_blocks_out out;
    wire_blocks_in in;
    fake_cable cable;
    uint32_t patience;
    uint8_t image[IMAGE_MOST];
} b;

static int pump(void *context) {
    (void)context;
    fake_cable_step(&b.cable);
    return b.patience-- > 0 ? 0 : -1;
}

static void open_block_pair(uint64_t seed) {
    memset(&b, 0, sizeof b);
    fake_cable_open(&b.cable, &b.host, &b.device, seed);
    for (uint32_t i = 0; i < IMAGE_MOST; i++) {
        b.image[i] = (uint8_t)random_bits(&b.cable.random);
    }
    wire_peer_open(&b.host, &host_setup, b.cable.now_ms);
    wire_peer_open(&b.device, &device_setup, b.cable.now_ms);
    wire_blocks_out_open(&b.out, &b.host, b.image, IMAGE_MOST);
    wire_blocks_in_open(&b.in, &b.device, pump, NULL);
    b.patience = 200000;
}

static void test_blocks(void) {
    test("blocks asked for in any number and order arrive in their places over a bad cable");
    for (uint32_t n = 0; n < 20; n++) {
        open_block_pair(n);
        b.cable.faults = (fake_faults){n * 200, n * 200, n * 200, n * 50, n * 100, n % 5, n % 4};
        for (int round = 0; round < 10; round++) {
            uint8_t *to[12];
            uint32_t at[12], count[12];
            for (unsigned i = 0; i < 12; i++) {
                count[i] = random_below(&b.cable.random, 900);
                at[i] = random_below(&b.cable.random, IMAGE_MOST - count[i]);
                to[i] = malloc(count[i] + 1u);
                to[i][count[i]] = 0x5A;
                CHECK(wire_source_start(&b.in, i % 8, at[i], to[i], count[i]) == 0, "start");
                if (i == 5) {
                    CHECK(wire_source_wait(&b.in, 0xF) == 0, "wait");
                }
            }
            CHECK(wire_source_wait(&b.in, UINT32_MAX) == 0, "wait");
            for (unsigned i = 0; i < 12; i++) {
                CHECK(memcmp(to[i], b.image + at[i], count[i]) == 0 && to[i][count[i]] == 0x5A,
                      "block of %u at %u", count[i], at[i]);
                free(to[i]);
            }
        }
    }
    test("a request outside the image is refused; a dead cable ends the wait");
    open_block_pair(1);
    uint8_t to[64];
    CHECK(wire_source_start(&b.in, 1, IMAGE_MOST - 10, to, 11) == 0, "start");
    CHECK(wire_source_wait(&b.in, 2) == -1, "given");
    fake_cable_unplug(&b.cable, 1 << 30);
    b.patience = 1000;
    CHECK(wire_source_start(&b.in, 1, 0, to, 10) == 0, "start");
    CHECK(wire_source_wait(&b.in, 2) == -1, "waited");
}

/* ---- the engine as a device -------------------------------------------------------------- */

static const wire_view views[2] = {
    {.eye = {3, 2, 4}, .look = {0, 0, 0}, .up = {0, 1, 0}, .tan_half_fov = 0.4f},
    {.eye = {-3, 1, 4},
     .look = {0, 0.1f, 0},
     .up = {0, 1, 0},
     .tan_half_fov = 0.35f,
     .shader = PLT_SHADE_NORMAL}};

static void open_engine(const packed *image, uint64_t seed) {
    open_rig(image->bytes, (uint32_t)image->size, 4, seed);
}

/* The hash of the panel when `frames` more frames came whole. */
static uint64_t engine_frame(uint32_t most) {
    for (uint32_t i = 0; i < most; i++) {
        fake_cable_step(&e.cable);
        for (int n = 0; n < 4; n++) {
            wire_device_run(&e.device, 2000);
        }
        if (e.device.frames > 0 && wire_frames_out_done(&e.device.out) && e.view.have &&
            !e.device.view.fresh && !e.device.is_viewed) {
            return hash_bytes(e.panel, sizeof e.panel);
        }
    }
    return 0;
}

static uint64_t direct_frame(plt_engine *engine, const wire_view *v) {
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    render_direct(engine, v, rgb);
    return hash_bytes(rgb, sizeof rgb);
}

static void test_engine(void) {
    mesh m = {0};
    rig direct;
    const rig_config config = rig_config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    test("scene and view go in, and the frame that comes back has the hash of a direct render");
    CHECK(rig_open(&direct, &m, &config) == PLT_OK, "%s", direct.fault.message);
    for (uint32_t n = 0; n < 8; n++) {
        open_engine(&direct.image, n);
        if (n % 2) {
            e.cable.paced = 1;
            e.cable.faults = (fake_faults){1500, 1500, 1500, 500, 1000, n / 4, n == 7 ? 5 : 0};
        }
        for (int i = 0; i < 2; i++) {
            wire_view_send(&e.view, &views[i]);
            const uint64_t hash = engine_frame(40000);
            CHECK(hash == direct_frame(direct.engine, &views[i]), "cable %u, view %d: %016llx", n,
                  i, (unsigned long long)hash);
        }
    }
    test("an image that the engine refuses is reported to the host with its rule");
    packed bad = direct.image;
    bad.bytes = malloc(bad.size);
    memcpy(bad.bytes, direct.image.bytes, bad.size);
    bad.bytes[20] ^= 0xFF;
    open_engine(&bad, 1);
    wire_view_send(&e.view, &views[0]);
    CHECK(engine_frame(3000) == 0, "rendered");
    uint32_t detail, has;
    CHECK(wire_scene_out_state(&e.scene, &has) == WIRE_SCENE_REFUSED, "not refused");
    CHECK(wire_error_read(&e.host, &detail) == WIRE_E_SCENE && detail >> 24 > 0, "detail %u",
          detail);
    test("then a good one is taken, without a reset");
    wire_scene_out_open(&e.scene, &e.host, direct.image.bytes, (uint32_t)direct.image.size);
    CHECK(engine_frame(20000) == direct_frame(direct.engine, &views[0]), "hash");
    test("a view without a direction is reported, and the next one is rendered");
    wire_view blind = views[0];
    memcpy(blind.look, blind.eye, sizeof blind.eye);
    wire_view_send(&e.view, &blind);
    engine_frame(3000);
    CHECK(wire_error_read(&e.host, &detail) == WIRE_E_VIEW, "not reported");
    wire_view_send(&e.view, &views[1]);
    CHECK(engine_frame(20000) == direct_frame(direct.engine, &views[1]), "hash");
    free(bad.bytes);
    rig_close(&direct);
    mesh_free(&m);
}

/* ---- a scene that is replaced in the middle of a frame ----------------------------------------
 */

/* Steps until some tiles of the first frame have left, and others have not. */
static int is_begun(void) {
    for (int i = 0; i < 20000 && e.device.out.sent < 3; i++) {
        fake_cable_step(&e.cable);
        wire_device_run(&e.device, 20);
    }
    return e.device.out.in_frame && e.device.out.sent < e.device.out.tiles;
}

/* The hash of the panel at the first frame that has the mark of the view. */
static uint64_t marked_frame(void) {
    const uint32_t seen = wire_frames_shown(&e.frames);
    for (int i = 0; i < 20000; i++) {
        fake_cable_step(&e.cable);
        wire_device_run(&e.device, 2000);
        if (wire_frames_shown(&e.frames) != seen &&
            wire_frames_mark(&e.frames) == e.view.view.number) {
            return hash_bytes(e.panel, sizeof e.panel);
        }
    }
    return 0;
}

static void test_orphan(void) {
    mesh m[2] = {{0}};
    rig of[2];
    const rig_config config = rig_config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    test("a frame whose scene is replaced before it is whole never has the mark of its view");
    for (unsigned i = 0; i < 2; i++) {
        shape_icosphere(&m[i], i);
        CHECK(rig_open(&of[i], &m[i], &config) == PLT_OK, "%s", of[i].fault.message);
    }
    open_engine(&of[0].image, 1);
    wire_view_send(&e.view, &views[0]);
    CHECK(is_begun(), "%u tiles, no frame that is not whole", e.device.out.sent);
    wire_scene_out_open(&e.scene, &e.host, of[1].image.bytes, (uint32_t)of[1].image.size);
    const uint64_t hash = marked_frame();
    CHECK(hash == direct_frame(of[1].engine, &views[0]), "%016llx", (unsigned long long)hash);
    CHECK(e.host.stats.frames_in > 1, "the frame that is not whole did not end");
    for (unsigned i = 0; i < 2; i++) {
        rig_close(&of[i]);
        mesh_free(&m[i]);
    }
}

static void test_other_tiles(void) {
    static const plt_options options = {.packet_side = PLT_PACKET_SIDE_MAX};
    test("an engine whose tiles are not those of the wire is refused as a device");
    CHECK(wire_device_open(&e.device, &device_setup, &options, e.memory, sizeof e.memory, 0) ==
              WIRE_ERR_SETUP,
          "it was opened");
}

int main(void) {
    test_scene();
    test_blocks();
    if (PLT_TILE_SIDE == WIRE_TILE_SIDE) {
        test_engine();
        test_orphan();
    } else {
        test_other_tiles();
    }
    return test_done();
}
