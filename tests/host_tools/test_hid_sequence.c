/* test_hid_sequence - a scene whose image holds frames, as a source of pictures
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <unistd.h>

#include "board/hash.h"
#include "host_tools/app/scene.h"
#include "host_tools/app/view.h"
#include "host_tools/base/clock.h"
#include "host_tools/hid/sources/frames_kinds.h"
#include "host_tools/hid/sources/frames_open.h"
#include "tests/reference/frames.h"
#include "tests/reference/sequence_rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { SIDE = 32, FRAMES = 5, LONGEST = 20 }; /* seconds until all were seen, on a busy machine */

static char path[256];

static const arg_flag flags[] = {{"--shader", "NAME", ""},
                                 {"--turn", "SECONDS", ""},
                                 VIEW_FLAGS,
                                 SCENE_FLAGS,
                                 {NULL, NULL, NULL}};
static const arg_command command = {"show", "", "", flags, 0, 1, NULL, NULL};

/* Five frames, 25 per second, in a file. */
static void make_scene(sequence_rig *s, int is_damaged) {
    const char *folder = getenv("TMPDIR");
    const sequence_config c = {
        .scene = rig_config_of(2, rig_is_tiny() ? 1 : 16, PLT_BUILD_HOST, PLT_SPLIT_SAH),
        .frames = FRAMES,
        .key_every = 1,
        .is_mapped = 1};
    mesh m = {0};
    shape_soup(&m, rig_triangles(200, 2), 0.5f, 3);
    sequence_rig_pack(s, &m, &c);
    mesh_free(&m);
    if (is_damaged) {
        const uint32_t section = plt_get_u32(s->image.bytes + 104 + 16 * 3 + 4);
        s->image.bytes[section + plt_get_u32(s->image.bytes + section + 4 * 2) + 50] ^= 1;
    }
    snprintf(path, sizeof path, "%s/planelet-%ld-sequence.plt", folder == NULL ? "/tmp" : folder,
             (long)getpid());
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL && fwrite(s->image.bytes, 1, s->image.size, file) == s->image.size, "%s",
          path);
    if (file != NULL) {
        fclose(file);
    }
    CHECK(sequence_rig_open(s, &c, 0) == PLT_OK, "%s", s->fault.message);
}

/* What frame `k` looks like from a camera that stands still. */
static uint64_t hash_of(sequence_rig *s, args *a, const plt_camera *camera, uint32_t k) {
    const plt_frame f = {
        .camera = *camera, .width = SIDE, .height = SIDE, .shader = view_shader(a)};
    CHECK(plt_sequence_show(s->engine, k, &s->fault) == PLT_OK, "%s", s->fault.message);
    return frame_hash(s->engine, &f, 4096);
}

/* Opens the file as planelet-hid show --turn 0 does. */
static int open_source(frames *source, args *a, fail *f) {
    static char turn[] = "--turn", zero[] = "0";
    char *words[] = {turn, zero, path, NULL};
    CHECK(args_parse(a, "planelet-hid", &command, 3, words) == ARGS_GO_ON, "flags");
    *source = (frames){.next = NULL};
    return frames_open(source, a, path, SIDE, SIDE, f);
}

static void by_the_clock(void) {
    sequence_rig s;
    args a;
    frames source;
    picture p = {0};
    fail f = {""};
    plt_camera camera;
    uint64_t due[FRAMES];
    unsigned seen = 0, others = 0;
    make_scene(&s, 0);
    CHECK(open_source(&source, &a, &f) == 0, "%s", f.text);
    const view_subject all = {.info = plt_engine_info(s.engine)};
    view_fit(&a, &all, SIDE, SIDE, &camera);
    for (uint32_t k = 0; k < FRAMES; k++) {
        due[k] = hash_of(&s, &a, &camera, k);
    }
    const double began = clock_seconds();
    while (seen != (1u << FRAMES) - 1 && clock_seconds() < began + LONGEST) {
        CHECK(source.next(&source, &p, &f) == FRAMES_ONE, "%s", f.text);
        const uint64_t hash = hash_bytes(p.rgb, (size_t)3 * SIDE * SIDE);
        uint32_t k = 0;
        while (k < FRAMES && due[k] != hash) {
            k++;
        }
        seen |= k < FRAMES ? 1u << k : 0;
        others += k == FRAMES;
    }
    CHECK(seen == (1u << FRAMES) - 1 && others == 0, "frames %x, %u others", seen, others);
    frames_close(&source);
    args_free(&a);
    picture_free(&p);
    sequence_rig_close(&s);
    remove(path);
}

static void damaged(void) {
    sequence_rig s;
    args a;
    frames source;
    picture p = {0};
    fail f = {""};
    int status = FRAMES_ONE;
    unsigned shown = 0;
    make_scene(&s, 1);
    CHECK(open_source(&source, &a, &f) == 0, "%s", f.text);
    const double began = clock_seconds();
    while (status == FRAMES_ONE && clock_seconds() < began + LONGEST) {
        status = source.next(&source, &p, &f);
        shown += status == FRAMES_ONE;
    }
    CHECK(status == FRAMES_FAILED && shown > 0 && strstr(f.text, "frame 2: ") == f.text &&
              strstr(f.text, path) != NULL && strstr(f.text, "I25") != NULL,
          "%u shown, then %d: %s", shown, status, f.text);
    frames_close(&source);
    args_free(&a);
    picture_free(&p);
    sequence_rig_close(&s);
    remove(path);
}

int main(void) {
    test("a scene with frames: each picture is that of a frame, and all come by the clock");
    by_the_clock();
    test("... a frame that is damaged ends it, and is named");
    damaged();
    return test_done();
}
