/* frame_scenes - see frame_scenes.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/frame_scenes.h"

#include <math.h>

#include "engine/engine.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

const plt_record *frame_scenes_record(const plt_scene *s, uint32_t id) {
    const plt_record *r = s->format == PLT_FORMAT_LIST ? s->list.records : s->thesis.records;
    while (plt_primitive_id(plt_get_u32(&r->word[9])) != id) {
        r++;
    }
    return r;
}

static rig opened(const mesh *m, random_state *r) {
    rig_config config = rig_config_of(1 + random_below(r, 4), 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    rig opened;
    config.run.packet_side = (uint8_t)(2u << random_below(r, 4));
    if (config.run.packet_side > PLT_PACKET_SIDE_MAX) {
        config.run.packet_side = PLT_PACKET_SIDE_MAX;
    }
    config.run.order = random_below(r, 5) == 0 ? PLT_ORDER_TWO_STAGE : PLT_ORDER_DEPTH_FIRST;
    const int status = rig_open(&opened, m, &config);
    CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%s",
          opened.fault.message);
    return opened;
}

static plt_frame any_frame(const frame_scenes *s, random_state *r) {
    plt_frame f = {.width = (uint16_t)(1 + random_below(r, s->side_most)),
                   .height = (uint16_t)(1 + random_below(r, s->side_most))};
    const float away = random_below(r, 3) ? 3.0f : 0.9f; /* outside, or inside */
    for (int a = 0; a < 3; a++) {
        f.camera.eye[a] = away * random_float(r, -1.0f, 1.0f);
        f.camera.look[a] = random_float(r, -0.5f, 0.5f);
    }
    f.camera.up[random_below(r, 3)] = 1.0f;
    f.camera.tan_half_fov = tanf(random_float(r, 0.05f, 1.2f));
    s->set(&f, r);
    return f;
}

/* Of the mesh, which is freed. */
static void cameras(const frame_scenes *s, mesh *m, uint32_t frames, const char *what) {
    random_state r = {frames};
    for (uint32_t i = 0; i < frames; i++) {
        rig scene = opened(m, &r);
        const plt_frame f = any_frame(s, &r);
        s->each(&scene, &f, what);
        rig_close(&scene);
    }
    mesh_free(m);
}

void frame_scenes_anywhere(const frame_scenes *s) {
    mesh m = {0};
    shape_soup(&m, rig_triangles(300, 1), 0.4f, 1);
    cameras(s, &m, 40, "large triangles");
    shape_soup(&m, rig_triangles(3000, 1), 0.04f, 2);
    cameras(s, &m, 40, "small triangles");
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    cameras(s, &m, 40, "a sphere");
    shape_needles(&m, rig_triangles(200, 1) / 4);
    cameras(s, &m, 40, "slivers");
    shape_coincident(&m, 5);
    shape_degenerate(&m);
    cameras(s, &m, 30, "odd triangles");
}

/* Two sheets of squares, the upper one moved, that lie on or close above one another. */
static void sheets(mesh *m, float apart, float moved) {
    shape_sheet(m, 4, 1);
    shape_transform(m, 1.0f, moved, apart, moved);
    shape_sheet(m, 4, 1);
}

void frame_scenes_down(const frame_scenes *s) {
    static const float apart[4] = {0.0f, 1e-6f, 1e-3f, 0.1f};
    random_state r = {7};
    for (uint32_t i = 0; i < 96; i++) {
        mesh m = {0};
        sheets(&m, apart[i % 4], random_below(&r, 2) ? 0.0f : 0.25f);
        rig scene = opened(&m, &r);
        const float x = 0.25f * (float)random_below(&r, 9) - 1.0f, height = (i & 8) ? 2.0f : -1.37f;
        const uint32_t third = s->side_most / 3;
        plt_frame f = {.width = (uint16_t)(third + random_below(&r, 2 * third)),
                       .height = (uint16_t)(third + random_below(&r, 2 * third)),
                       .camera = {.eye = {x, height, 0.0f},
                                  .look = {x, 0.0f, 0.0f},
                                  .up = {0, 0, 1},
                                  .tan_half_fov = (i & 16) ? 0.5f : 1.0f}};
        s->set(&f, &r);
        s->each(&scene, &f, "sheets");
        rig_close(&scene);
        mesh_free(&m);
    }
}
