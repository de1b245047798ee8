/* test_instances_render - pictures of bodies that matrices place
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "tests/reference/instances_rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { WIDTH = 61, HEIGHT = 47, PIXELS = WIDTH * HEIGHT };

typedef struct picture {
    uint8_t rgb[3 * PIXELS];
} picture;

static plt_frame frame_of(uint8_t shader, float far) {
    const plt_frame f = {
        .camera = {{2.0f * far, 1.1f * far, 7.0f * far}, {0.1f, 0, 0}, {0, 1, 0}, 0.6f / far},
        .width = WIDTH,
        .height = HEIGHT,
        .shader = shader};
    return f;
}

/* A step of `visits` nodes at a time. */
static void render(plt_engine *e, const plt_frame *f, uint32_t visits, picture *p) {
    int status;
    memset(p, 0, sizeof *p);
    CHECK(plt_render_begin(e, f) == PLT_OK, "begin");
    while ((status = plt_render_step(e, visits)) > PLT_OK) {
        plt_tile t;
        plt_render_tile(e, &t);
        for (uint32_t y = 0; status == PLT_TILE && y < t.height; y++) {
            memcpy(&p->rgb[3 * ((t.y + y) * WIDTH + t.x)], &t.rgb[3 * y * t.width], 3u * t.width);
        }
    }
    CHECK(status == PLT_OK, "status %d", status);
}

static instances_config config_of(enum instances_kind kind) {
    const instances_config c = {
        rig_config_of(2, rig_is_tiny() ? 1 : 16, PLT_BUILD_HOST, PLT_SPLIT_SAH),
        14,
        kind,
        3.0f,
        1,
        21 + (uint64_t)kind};
    return c;
}

/* The pictures of all packets and orders, and in steps of any size, are one. */
static void alike(enum instances_kind kind, uint8_t shader, float far) {
    const plt_frame f = frame_of(shader, far);
    static picture first, other;
    int has_first = 0;
    for (unsigned side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        for (uint8_t order = 0; order < 2; order++) {
            instances_config c = config_of(kind);
            instances_rig s;
            c.scene.run.packet_side = (uint8_t)side;
            c.scene.run.order = order;
            if (instances_rig_start(&s, &c) == PLT_OK) {
                render(s.engine, &f, side == 4 ? 1 : 100000, has_first ? &other : &first);
                CHECK(!has_first || memcmp(&first, &other, sizeof first) == 0, "%s",
                      rig_name(&c.scene));
                has_first = 1;
            }
            CHECK(instances_rig_close(&s), "arena");
        }
    }
}

/* Beside the frame of a scene that is packed flat: colours of ids and of normals. */
static void beside_flat(enum instances_kind kind, uint8_t shader) {
    const plt_frame f = frame_of(shader, 1.0f);
    const instances_config c = config_of(kind);
    static picture own, flat_own;
    instances_rig s;
    rig flat_rig;
    mesh flat = {0};
    uint32_t differ = 0, lit = 0;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        instances_rig_flatten(&s, (const float(*)[PLT_MATRIX_FLOATS])s.matrix[0], &flat);
        rig_config fc = c.scene;
        fc.pack.build = PLT_BUILD_NONE;
        CHECK(rig_open(&flat_rig, &flat, &fc) == PLT_OK, "%s", flat_rig.fault.message);
        render(s.engine, &f, 100000, &own);
        render(flat_rig.engine, &f, 100000, &flat_own);
        for (uint32_t i = 0; i < PIXELS; i++) {
            int most = 0;
            for (uint32_t k = 3 * i; k < 3 * i + 3; k++) {
                most = abs(own.rgb[k] - flat_own.rgb[k]) > most ? abs(own.rgb[k] - flat_own.rgb[k])
                                                                : most;
            }
            differ += most > 1;
            lit += own.rgb[3 * i] > own.rgb[3 * i + 2] || own.rgb[3 * i + 1] > own.rgb[3 * i + 2];
        }
        /* Two instances in five lie in one place, and which of them is hit is rounding. */
        const uint32_t ties = shader == PLT_SHADE_TRIANGLE ? PIXELS / 8 : PIXELS / 200;
        CHECK(differ <= ties && lit > PIXELS / 20, "%u of %d pixels differ, %u lit", differ,
              (int)PIXELS, lit);
        rig_close(&flat_rig);
        mesh_free(&flat);
    }
    CHECK(instances_rig_close(&s), "arena");
}

int main(void) {
    test("pictures are the same for all packets, orders and steps, from near and very far");
    for (int kind = INSTANCES_RIGID; kind <= INSTANCES_SKEWED; kind++) {
        alike((enum instances_kind)kind, PLT_SHADE_EYELIGHT, 1.0f);
        alike((enum instances_kind)kind, PLT_SHADE_NORMAL, 1.0f);
        alike((enum instances_kind)kind, PLT_SHADE_TRIANGLE, 3000.0f);
    }
    test("pictures are those of a scene that is packed flat, but for rounding");
    for (int kind = INSTANCES_RIGID; kind <= INSTANCES_SKEWED; kind++) {
        beside_flat((enum instances_kind)kind, PLT_SHADE_EYELIGHT);
        beside_flat((enum instances_kind)kind, PLT_SHADE_NORMAL);
        beside_flat((enum instances_kind)kind, PLT_SHADE_TRIANGLE);
    }
    return test_done();
}
