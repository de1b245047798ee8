/* test_wire_speed - bytes per frame and frames per second over full-speed USB
 *
 * Frames of 320 x 240 RGB565 in the views that `planelet render` chooses, 25 per
 * second, over the fake cable at one report of 64 bytes per millisecond.
 * A frame counts when it was acknowledged whole; one that is ready while
 * another is on its way is left out. Arguments: scene images to orbit, beside
 * the scenes that planelet makes.
 *
 *   exact   every tile for itself           needs nothing of the panel
 *   delta   and only what differs           a panel that can be read
 *   12 fps  and off by as many steps as it  while it moves; then exact
 *           takes to let so many through
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "board/host/host.h"
#include "host_tools/app/view.h"
#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/rig.h"
#include "tests/reference/wire_rig.h"
#include "tests/test.h"

enum { WIDTH = 320, HEIGHT = 240, FILM = 50, FRAME_MS = 40, ORBIT = 120, GOAL = 12 };

static uint8_t *film[FILM];
static size_t arena_bytes = 64u << 20;

static plt_camera camera_of(const plt_info *info, unsigned width, unsigned height) {
    static const arg_flag flags[] = {VIEW_FLAGS, {NULL, NULL, NULL}};
    static const arg_command command = {.flags = flags};
    args none = {.command = &command};
    plt_camera c;
    view_camera(&none, info, width, height, &c);
    return c;
}

static void render(plt_engine *engine, const plt_frame *frame, uint8_t *rgb) {
    uint32_t pixels = 0;
    CHECK(plt_render_begin(engine, frame) == PLT_OK, "the camera");
    for (int status = PLT_MORE; status > 0;) {
        status = plt_render_step(engine, 100000);
        if (status == PLT_TILE) {
            plt_tile t;
            plt_render_tile(engine, &t);
            for (unsigned y = 0; y < t.height; y++) {
                memcpy(rgb + 3 * ((size_t)(t.y + y) * frame->width + t.x),
                       t.rgb + 3 * (size_t)y * t.width, 3 * (size_t)t.width);
            }
            pixels += (uint32_t)t.width * t.height;
        }
    }
    CHECK(pixels == (uint32_t)frame->width * frame->height, "%u pixels", pixels);
}

static plt_engine *engine_of(const plt_source *source) {
    static const plt_options options = {.packet_side =
                                            PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8};
    plt_engine *engine;
    plt_fault fault;
    const int status =
        plt_open(&engine, host_arena(arena_bytes), arena_bytes, source, &options, &fault);
    CHECK(status == PLT_OK, "%s", fault.message);
    return status == PLT_OK ? engine : NULL;
}

/* Frame i of an orbit; every scene is 320 x 240. */
static void render_orbit(plt_engine *engine, int frames) {
    plt_frame frame = {.width = WIDTH, .height = HEIGHT};
    const plt_camera start = camera_of(plt_engine_info(engine), WIDTH, HEIGHT);
    for (int i = 0; i < frames; i++) {
        frame.camera = start;
        if (i > 0) {
            view_orbit(&start, (double)i / ORBIT, &frame.camera);
        }
        render(engine, &frame, film[i]);
    }
}

static plt_engine *engine_of_mesh(const mesh *m, packed *image) {
    const pack_options options = {PLT_SPLIT_SAH, PLT_BUILD_HOST, 2, 32, NULL, 0, NULL, 0, 0};
    fail f = {""};
    CHECK(pack_mesh(image, m, &options, "film", &f) == 0, "%s", f.text);
    const plt_source source = {image->bytes, (uint32_t)image->size, NULL, NULL, NULL};
    return engine_of(&source);
}

static void film_marbles(void) {
    for (unsigned i = 0; i < FILM; i++) {
        mesh m = {0};
        packed image;
        fail f = {""};
        plt_frame frame = {.width = WIDTH, .height = HEIGHT};
        CHECK(scene_marbles(&m, SCENE_MARBLES_MOST, i, &f) == 0, "%s", f.text);
        plt_engine *engine = engine_of_mesh(&m, &image);
        static plt_camera still;
        still = i == 0 ? camera_of(plt_engine_info(engine), WIDTH, HEIGHT) : still;
        frame.camera = still;
        render(engine, &frame, film[i]);
        pack_free(&image);
        mesh_free(&m);
    }
}

static void film_mesh(int (*make)(mesh *, uint64_t, fail *), uint64_t triangles) {
    mesh m = {0};
    packed image;
    fail f = {""};
    CHECK(make(&m, triangles, &f) == 0, "%s", f.text);
    render_orbit(engine_of_mesh(&m, &image), FILM);
    pack_free(&image);
    mesh_free(&m);
}

typedef struct measurement {
    double fps, bytes; /* frames per second; bytes of messages per frame */
    double near;       /* steps, of all frames */
    uint32_t key;      /* of the first frame */
} measurement;

/* Plays the film in a loop there and back, for `ms`. */
static measurement play(rig_shape shape, unsigned goal, uint32_t ms) {
    static wire_rig pair;
    wire_rig_open(&pair, shape, 1);
    pair.cable.paced = 1;
    wire_frames_rate(&pair.out, goal);
    measurement result = {0, 0, 0, 0};
    uint32_t shown = 0, frames = 0, payload = 0, since = 0, last = UINT32_MAX;
    for (uint32_t t = 0; t < ms + since; t++) {
        fake_cable_step(&pair.cable);
        const uint32_t now = t / FRAME_MS % (2 * FILM - 2),
                       i = now < FILM ? now : 2 * FILM - 2 - now;
        if (!wire_frames_out_idle(&pair.out) || t / FRAME_MS == last) {
            continue;
        }
        if (last != UINT32_MAX && since == 0) { /* the key frame has gone */
            since = t;
            frames = pair.host.stats.frames_out;
            result.key = payload = pair.host.stats.payload_out;
        }
        last = t / FRAME_MS;
        wire_frames_show(&pair.out, film[i], 3 * WIDTH);
        result.near += pair.out.near;
        shown++;
    }
    CHECK(shown > 0 && since > 0, "%u frames were shown", shown);
    result.near /= shown > 0 ? shown : 1;
    frames = pair.host.stats.frames_out - frames;
    result.fps = 1000.0 * frames / ms;
    CHECK(frames > 0, "no frame came whole");
    result.bytes = (double)(pair.host.stats.payload_out - payload) / (frames ? frames : 1);
    CHECK(pair.host.stats.frames_bad == 0 && pair.device.stats.reports_lost == 0,
          "%u bad frames, %u reports lost", pair.host.stats.frames_bad,
          pair.device.stats.reports_lost);
    wire_rig_close(&pair);
    return result;
}

static void report(const char *scene, measurement fps[3]) {
    rig_shape shape = {WIDTH, HEIGHT, WIRE_RGB565, 64, 64, 16, 0};
    fps[0] = play(shape, 0, 4000);
    shape.reads = 1;
    fps[1] = play(shape, 0, 4000);
    fps[2] = play(shape, GOAL, 4000);
    printf(
        "    %-28s first %6u bytes; exact %6.0f, %4.1f fps; delta %6.0f, %4.1f fps; "
        "goal %d: near %.1f, %6.0f, %4.1f fps\n",
        scene, fps[0].key, fps[0].bytes, fps[0].fps, fps[1].bytes, fps[1].fps, GOAL, fps[2].near,
        fps[2].bytes, fps[2].fps);
}

static void measure_file(const char *path) {
    host_scene file;
    measurement f[3];
    test(path);
    const int status = host_scene_map(&file, path);
    CHECK(status == 0, "it cannot be read");
    if (status == 0) {
        arena_bytes = 1u << 28;
        plt_engine *engine = engine_of(&file.source);
        if (engine != NULL) {
            render_orbit(engine, FILM);
            report(path, f);
        }
    }
    host_scene_close(&file);
}

static void measure_oled(void) {
    const rig_shape shape = {128, 64, WIRE_MONO1, 64, 64, 16, 1};
    for (int i = 0; i < FILM; i++) { /* the middle of the film, 1 to 1 */
        for (unsigned y = 0; y < 64; y++) {
            memmove(film[i] + 3 * WIDTH * y, film[i] + 3 * (WIDTH * (y + 90) + 100), 3 * 128);
        }
    }
    static wire_rig pair;
    wire_rig_open(&pair, shape, 1);
    pair.cable.paced = 1;
    for (uint32_t t = 0, i = 0; t < 2000; t++) {
        fake_cable_step(&pair.cable);
        if (wire_frames_out_idle(&pair.out)) {
            wire_frames_show(&pair.out, film[i++ % FILM], 3 * WIDTH);
        }
    }
    printf("    128x64 1 bit, marbles: %u bytes, %.1f fps\n",
           pair.host.stats.payload_out / (pair.host.stats.frames_out + 1),
           pair.host.stats.frames_out / 2.0);
    test("128 x 64 at 1 bit, a new frame as soon as one has gone: at least 50 frames per second");
    CHECK(pair.host.stats.frames_out >= 100, "%u in 2 s", pair.host.stats.frames_out);
    wire_rig_close(&pair);
}

/* Such a build has nothing to measure; it must say why. */
static void test_tiny(void) {
    mesh m = {0};
    rig r;
    fail f = {""};
    const rig_config config = rig_config_of(2, 32, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    test("a build with tiny limits refuses the scene of a film, and says that it is a limit");
    CHECK(scene_knot(&m, 20000, &f) == 0, "%s", f.text);
    CHECK(rig_open(&r, &m, &config) == PLT_ERR_LIMIT, "%s", r.fault.message);
    rig_close(&r);
    mesh_free(&m);
}

int main(int count, char **words) {
    measurement f[3];
    if (rig_is_tiny()) {
        test_tiny();
        return test_done();
    }
    for (int i = 0; i < FILM; i++) {
        film[i] = malloc(3u * WIDTH * HEIGHT);
    }
    test("with a goal of 12 frames per second: marbles before a static camera, at least 12");
    film_marbles();
    report("109 marbles, still camera", f);
    CHECK(f[2].fps >= GOAL, "%.1f", f[2].fps);
    measure_oled();
    test(
        "an orbit round a knot: at least 4 frames per second exact, nothing asked of the panel; 12 "
        "with the goal");
    film_mesh(scene_knot, 20000);
    report("20,000 knot, orbit", f);
    CHECK(f[0].fps >= 4.0 && f[2].fps >= GOAL, "%.1f, %.1f with the goal", f[0].fps, f[2].fps);
    test("an orbit round a terrain, which fills the picture: at least 3 exact, 12 with the goal");
    film_mesh(scene_terrain, 20000);
    report("20,000 terrain, orbit", f);
    CHECK(f[0].fps >= 3.0 && f[2].fps >= GOAL, "%.1f, %.1f with the goal", f[0].fps, f[2].fps);
    for (int i = 1; i < count; i++) {
        measure_file(words[i]);
    }
    for (int i = 0; i < FILM; i++) {
        free(film[i]);
    }
    return test_done();
}
