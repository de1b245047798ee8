/* test_render - frames: the same picture in every configuration, each pixel once, in steps
 *
 * PLANELET_GOLDEN=write prints the table of golden/frames.txt with the hashes of this build.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/scenes/scenes.h"
#include "tests/hostile/images.h"
#include "tests/reference/frames.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#define GOLDEN "tests/golden/frames.txt"

static const float eye[3] = {3.0f, 2.5f, 5.0f}, origin[3] = {0, 0, 0};

static mesh some_scene(void) {
    mesh m = {0};
    fail f = {""};
    scene_knot(&m, rig_triangles(1200, 1), &f);
    return m;
}

static rig opened(const mesh *m, const rig_config *config) {
    rig r;
    const int status = rig_open(&r, m, config);
    CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%s: %s",
          rig_name(config), r.fault.message);
    return r;
}

static rig plain(const mesh *m) {
    const rig_config config = rig_config_of(2, 2, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    return opened(m, &config);
}

/* ---- one picture -------------------------------------------------------------- */

static uint64_t one_hash(const mesh *m, const plt_frame *frame) {
    const rig_config config = rig_config_of(1, 1, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    rig r = opened(m, &config);
    const uint64_t hash = frame_hash(r.engine, frame, 1000000);
    rig_close(&r);
    return hash;
}

static void every_config(const mesh *m, const plt_frame *frame, uint64_t due) {
    static const uint32_t budget[3] = {1, 7, 1000000};
    uint32_t compared = 0;
    for (unsigned i = 0; i < 2 * 3 * 4 * 2; i++) {
        rig_config config = rig_config_of(1 + i % 2, i % 2 ? 3 : 64, i / 2 % 3, PLT_SPLIT_SAH);
        config.run.packet_side = (uint8_t)(2u << i / 6 % 4);
        config.run.order = (uint8_t)(i / 24);
        if (config.run.packet_side > PLT_PACKET_SIDE_MAX) {
            continue;
        }
        rig r = opened(m, &config);
        for (int b = 0; b < 3 && r.engine != NULL; b++) {
            CHECK(frame_hash(r.engine, frame, budget[b]) == due, "%s, %u visits per step",
                  rig_name(&config), budget[b]);
            compared++;
        }
        rig_close(&r);
    }
    /* A tiny build has one packet size, and refuses some of its 12 trees. */
    CHECK(compared >= (rig_is_tiny() ? 24u : 144u), "only %u pictures were compared", compared);
}

static void streamed(const mesh *m, const plt_frame *frame, uint64_t due) {
    rig r = plain(m);
    hostile_stream stream = {r.image.bytes, r.image.size, 0};
    const plt_source source = {NULL, r.image.size, &stream, hostile_start, hostile_wait};
    const plt_options options = {
        .packet_side = 2, .order = PLT_ORDER_TWO_STAGE, .count_touched = 1};
    const size_t need = plt_arena_need(&r.image.info, 0, &options);
    void *arena = aligned_alloc(PLT_ALIGN, need);
    plt_engine *e;
    plt_fault fault;
    CHECK(plt_open(&e, arena, need, &source, &options, &fault) == PLT_OK, "%s", fault.message);
    CHECK(e != NULL && frame_hash(e, frame, 50) == due, "streamed");
    free(arena);
    rig_close(&r);
}

static void same_picture(void) {
    mesh m = some_scene();
    const plt_frame frame = frame_of(eye, origin, 37, 29, PLT_SHADE_EYELIGHT);
    const uint64_t due = one_hash(&m, &frame);
    every_config(&m, &frame, due);
    streamed(&m, &frame, due);
    mesh_free(&m);
}

/* ---- tiles and steps ------------------------------------------------------------ */

static void sizes(void) {
    static const uint16_t size[9][2] = {{1, 1},   {17, 33}, {640, 48},  {1, 100},  {100, 1},
                                        {16, 16}, {15, 17}, {65535, 1}, {1, 65535}};
    mesh m = some_scene();
    rig r = plain(&m);
    for (int i = 0; i < 9 && r.engine != NULL; i++) {
        const plt_frame frame = frame_of(eye, origin, size[i][0], size[i][1], PLT_SHADE_NORMAL);
        const frame_result f = frame_render(r.engine, &frame, 1000);
        const uint32_t due = (size[i][0] + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE *
                             ((size[i][1] + PLT_TILE_SIDE - 1u) / PLT_TILE_SIDE);
        CHECK(f.status == PLT_OK && f.wrong == 0, "%u x %u: %u pixels", size[i][0], size[i][1],
              f.wrong);
        CHECK(f.tiles == due, "%u x %u: %u tiles, not %u", size[i][0], size[i][1], f.tiles, due);
        CHECK(plt_render_step(r.engine, 5) == PLT_OK, "a step after the last");
        free(f.rgb);
    }
    rig_close(&r);
    mesh_free(&m);
}

static uint32_t bounded; /* frames whose steps were looked at */

static void bounded_steps(uint8_t order, uint32_t n) {
    static const uint32_t budget[5] = {0, 1, 7, 100, 100000};
    mesh m = some_scene();
    rig_config config = rig_config_of(2, n, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    config.run.order = order;
    rig r = opened(&m, &config);
    for (int i = 0; i < 5 && r.engine != NULL; i++) {
        const plt_frame frame = frame_of(eye, origin, 40, 30, PLT_SHADE_EYELIGHT);
        const plt_info *info = plt_engine_info(r.engine);
        const uint32_t entry = order == PLT_ORDER_TWO_STAGE ? n : info->depth_stack_entries;
        const frame_result f = frame_render(r.engine, &frame, budget[i]);
        CHECK(f.most_visits <= budget[i] + (uint64_t)entry, "%s: %" PRIu64 " visits of %u + %u",
              rig_name(&config), f.most_visits, budget[i], entry);
        CHECK(budget[i] > 1 || f.steps > 200, "%" PRIu64 " steps", f.steps);
        bounded++;
        free(f.rgb);
    }
    rig_close(&r);
    mesh_free(&m);
}

static void interrupted(void) {
    mesh m = some_scene();
    rig r = plain(&m);
    const plt_frame frame = frame_of(eye, origin, 40, 30, PLT_SHADE_EYELIGHT);
    const plt_frame other = frame_of(origin, eye, 20, 50, PLT_SHADE_TRIANGLE);
    const plt_ray ray = {{0, 0, 9}, 0, {0, 0, -1}, 100};
    plt_hit hit;
    const uint64_t due = frame_hash(r.engine, &frame, 100);
    CHECK(plt_render_step(r.engine, 1) == PLT_OK, "a step without a frame");
    for (int steps = 0; steps < 60; steps++) {
        CHECK(plt_render_begin(r.engine, &other) == PLT_OK, "begin");
        for (int i = 0; i < steps; i++) {
            plt_render_step(r.engine, 3);
        }
        if (steps % 2) {
            plt_trace(r.engine, &ray, &hit, 1, steps % 4 == 1);
            CHECK(plt_render_step(r.engine, 1) == PLT_OK, "tracing ends a frame");
        }
        CHECK(frame_hash(r.engine, &frame, 100) == due, "after %d steps of another frame", steps);
    }
    rig_close(&r);
    mesh_free(&m);
}

/* ---- cameras and shaders ---------------------------------------------------------- */

static void refuse(plt_engine *e, plt_frame frame, const char *what) {
    const plt_frame good = frame_of(eye, origin, 8, 8, 0);
    plt_render_begin(e, &good);
    CHECK(plt_render_begin(e, &frame) == PLT_ERR_ARGUMENT, "%s", what);
    CHECK(plt_render_step(e, 10) == PLT_OK, "%s: there is something to render", what);
}

static void camera_errors(plt_engine *e) {
    const plt_frame good = frame_of(eye, origin, 8, 8, 0);
    const float bad[6] = {NAN, INFINITY, -INFINITY, 3e12f, -3e12f, 3e38f};
    plt_frame f = good;
    CHECK(plt_render_begin(e, &good) == PLT_OK, "a good camera");
    memcpy(f.camera.look, f.camera.eye, sizeof f.camera.eye);
    refuse(e, f, "looks at its own position");
    f = good;
    memset(f.camera.up, 0, sizeof f.camera.up);
    refuse(e, f, "no up");
    for (int a = 0; a < 3; a++) {
        f.camera.up[a] = -2.0f * eye[a];
    }
    refuse(e, f, "up along the view");
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 9; k++) {
            f = good;
            memcpy((char *)&f.camera + 4 * k, &bad[i], 4);
            refuse(e, f, "a value out of range");
        }
    }
    const float fov[6] = {0.0f, -0.5f, NAN, INFINITY, 1e7f, 1e-7f};
    for (int i = 0; i < 6; i++) {
        f = good;
        f.camera.tan_half_fov = fov[i];
        refuse(e, f, "an angle out of range");
    }
    f = good;
    f.width = 0;
    refuse(e, f, "no width");
    f = good;
    f.height = 0;
    refuse(e, f, "no height");
    for (unsigned shader = 3; shader < 256; shader++) { /* nothing has normals, or light */
        if (PLT_WITH_DIAGRAMS && (shader == PLT_SHADE_DEPTH || shader == PLT_SHADE_HEAT)) {
            continue;
        }
        f = good;
        f.shader = (uint8_t)shader;
        refuse(e, f, "an unknown shader");
    }
}

static int is_colour(const uint8_t *rgb, int r, int g, int b) {
    return rgb[0] == r && rgb[1] == g && rgb[2] == b;
}

/* Two walls at z = 0, left of x = 0 and above y = 0 only, seen straight on. */
static frame_result wall(uint8_t shader, float eye_z) {
    mesh m = {0};
    fail f = {""};
    static const float p[6][2] = {{-9, 0}, {0, 0}, {0, 9}, {-9, 0}, {0, 9}, {-9, 9}};
    for (uint32_t i = 0; i < 6; i++) {
        mesh_add_vertex(&m, p[i][0], p[i][1], 0.0f, &f);
    }
    mesh_add_triangle(&m, 0, 1, 2, &f);
    mesh_add_triangle(&m, 3, 4, 5, &f);
    rig r = plain(&m);
    const float from[3] = {0, 0, eye_z};
    const plt_frame frame = frame_of(from, origin, 20, 20, shader);
    const frame_result result = frame_render(r.engine, &frame, 100);
    rig_close(&r);
    mesh_free(&m);
    return result;
}

static const uint8_t *pixel(const frame_result *f, int x, int y) {
    return f->rgb + 3 * (20 * y + x);
}

static void shaders(void) {
    const frame_result grey = wall(PLT_SHADE_EYELIGHT, 4), normal = wall(PLT_SHADE_NORMAL, 4);
    const frame_result flat = wall(PLT_SHADE_TRIANGLE, 4), behind = wall(PLT_SHADE_NORMAL, -4);
    const uint8_t *sky = pixel(&grey, 12, 0), *ground = pixel(&grey, 12, 19);
    CHECK(pixel(&grey, 9, 9)[0] >= 254 && pixel(&grey, 9, 9)[2] < pixel(&grey, 9, 9)[1],
          "facing the eye: clay, bright");
    CHECK(pixel(&grey, 0, 0)[0] < pixel(&grey, 9, 9)[0], "darker at the edge");
    CHECK(sky[0] < ground[0] && sky[1] < ground[1] && sky[2] < ground[2], "sky");
    CHECK(is_colour(pixel(&grey, 0, 19), ground[0], ground[1], ground[2]), "lower left is free");
    CHECK(is_colour(pixel(&normal, 12, 0), sky[0], sky[1], sky[2]), "upper right is free");
    CHECK(is_colour(pixel(&normal, 2, 2), 128, 128, 255), "towards +z: blue");
    /* From behind, x runs in the other direction and the normal still faces the eye. */
    CHECK(is_colour(pixel(&behind, 17, 2), 128, 128, 0), "towards -z");
    CHECK(is_colour(pixel(&behind, 2, 2), sky[0], sky[1], sky[2]) || pixel(&behind, 2, 2)[2] < 128,
          "left of the picture is +x from behind");
    CHECK(memcmp(pixel(&flat, 1, 0), pixel(&flat, 8, 8), 3) != 0, "two triangles, two colours");
    free(grey.rgb);
    free(normal.rgb);
    free(flat.rgb);
    free(behind.rgb);
}

/* ---- golden frames -------------------------------------------------------------------- */

typedef struct golden {
    char scene[16];
    uint32_t number;
    float eye[3], look[3];
    unsigned width, height, shader;
    uint64_t hash;
} golden;

static int read_golden(FILE *file, golden *g) {
    char line[256];
    while (fgets(line, sizeof line, file) != NULL) {
        if (line[0] != '#' &&
            sscanf(line, "%15s %u %f %f %f %f %f %f %u %u %u %" SCNx64, g->scene, &g->number,
                   &g->eye[0], &g->eye[1], &g->eye[2], &g->look[0], &g->look[1], &g->look[2],
                   &g->width, &g->height, &g->shader, &g->hash) == 12) {
            return 1;
        }
    }
    return 0;
}

static mesh golden_mesh(const golden *g) {
    mesh m = {0};
    fail f = {""};
    const int status = g->scene[0] == 'g'   ? scene_ground(&m, &f)
                       : g->scene[0] == 'k' ? scene_knot(&m, g->number, &f)
                       : g->scene[0] == 't' ? scene_terrain(&m, g->number, &f)
                                            : scene_marbles(&m, SCENE_MARBLES_MOST, g->number, &f);
    CHECK(status == 0, "%s: %s", g->scene, f.text);
    return m;
}

static void check_golden(const golden *g, int write) {
    mesh m = golden_mesh(g);
    const int fits = !rig_is_tiny();
    const rig_config config =
        rig_config_of(2, 8, fits ? PLT_BUILD_HOST : PLT_BUILD_NONE, PLT_SPLIT_SAH);
    rig r = opened(&m, &config);
    const plt_frame frame =
        frame_of(g->eye, g->look, (uint16_t)g->width, (uint16_t)g->height, (uint8_t)g->shader);
    const uint64_t found = frame_hash(r.engine, &frame, 100000);
    CHECK(found == g->hash, "%s %u, shader %u: %016" PRIx64, g->scene, g->number, g->shader, found);
    if (write) {
        printf("%-8s %5u  %g %g %g  %g %g %g  %u %u %u  %016" PRIx64 "\n", g->scene, g->number,
               (double)g->eye[0], (double)g->eye[1], (double)g->eye[2], (double)g->look[0],
               (double)g->look[1], (double)g->look[2], g->width, g->height, g->shader, found);
    }
    rig_close(&r);
    mesh_free(&m);
}

static void golden_frames(void) {
    const char *write = getenv("PLANELET_GOLDEN");
    golden g = {0};
    uint32_t count = 0;
    FILE *file = fopen(GOLDEN, "r");
    CHECK(file != NULL, "no " GOLDEN " here: run in the root of the repository");
    while (file != NULL && read_golden(file, &g)) {
        check_golden(&g, write != NULL);
        count++;
    }
    CHECK(count == 12, "%u frames", count);
    if (file != NULL) {
        fclose(file);
    }
}

int main(void) {
    test("the picture is the same for every packet, order, build, K, N, source and step");
    same_picture();
    test("tiles cover every pixel exactly once, at any size");
    sizes();
    test("a step visits no more nodes than its budget and one stack entry");
    bounded_steps(PLT_ORDER_DEPTH_FIRST, 3);
    bounded_steps(PLT_ORDER_TWO_STAGE, 3);
    bounded_steps(PLT_ORDER_TWO_STAGE, 64);
    CHECK(bounded >= (rig_is_tiny() ? 10u : 15u), "only the steps of %u frames", bounded);
    test("a frame that was dropped has no effect on the next");
    interrupted();
    mesh m = some_scene();
    rig r = plain(&m);
    test("cameras, sizes and shaders out of range are refused");
    camera_errors(r.engine);
    rig_close(&r);
    mesh_free(&m);
    test("shaders show facing, normal and primitive id; the sky is above, left is left");
    shaders();
    test("golden frames have their hashes");
    golden_frames();
    return test_done();
}
