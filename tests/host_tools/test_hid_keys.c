/* test_hid_keys - keys of displays: pressed, held, released, unplugged; and scenes turned by them
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <unistd.h>

#include "host_tools/app/scene.h"
#include "host_tools/app/view.h"
#include "host_tools/base/clock.h"
#include "host_tools/hid/device/session.h"
#include "host_tools/hid/device/symbols.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/sources/frames_kinds.h"
#include "host_tools/hid/sources/frames_open.h"
#include "tests/hid/model.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* ---- what a key asks for -------------------------------------------------------------- */

static const display_key some[] = {{"a", STEER_LEFT, 0, 0},
                                   {"b", STEER_NEARER, 0, 0},
                                   {"c", STEER_FARTHER, 0, 0},
                                   {NULL, STEER_LEFT, 0, 0}};

static unsigned asked(keys_track *t, const keys_state *now, double clock,
                      enum steer_action action) {
    unsigned count[STEER_ACTIONS];
    keys_take(t, now, some, clock, count);
    return count[action];
}

static void presses(void) {
    keys_track t = {.is_reset = 0};
    keys_state s = {.changes = {0}};
    test("a press counts once, and ten between two looks count, at most eight");
    CHECK(asked(&t, &s, 1.0, STEER_LEFT) == 0, "nothing was pressed");
    keys_set(&s, 0, 1);
    keys_set(&s, 0, 1);
    CHECK(asked(&t, &s, 1.0, STEER_LEFT) == 1 && asked(&t, &s, 1.0, STEER_LEFT) == 0, "once");
    keys_set(&s, 0, 0);
    CHECK(asked(&t, &s, 1.1, STEER_LEFT) == 0, "released");
    for (unsigned presses = 1; presses < 12; presses++) {
        for (unsigned i = 0; i < presses; i++) {
            keys_set(&s, 0, 1);
            keys_set(&s, 0, 0);
        }
        CHECK(asked(&t, &s, 1.1, STEER_LEFT) == (presses < 8 ? presses : 8), "%u", presses);
    }
    test("... beyond 256 changes, too");
    for (int i = 0; i < 600; i++) {
        keys_set(&s, 0, 1);
        keys_set(&s, 0, 0);
        CHECK(asked(&t, &s, 1.1, STEER_LEFT) == 1, "press %d", i);
    }
    test("a key beyond the list, or beyond all, does nothing");
    keys_set(&s, KEYS_MOST, 1);
    keys_set(&s, 9, 1);
    CHECK(asked(&t, &s, 1.1, STEER_LEFT) == 0, "something");
}

static void held(void) {
    keys_track t = {.is_reset = 0};
    keys_state s = {.changes = {0}};
    unsigned times = 0;
    test("a key that is held goes on ten times a second, after a third of one");
    keys_set(&s, 0, 1);
    for (int ms = 0; ms <= 1355; ms += 5) {
        times += asked(&t, &s, 5.0 + 1e-3 * ms, STEER_LEFT);
        CHECK(ms >= 345 || times == 1, "%u after %d ms", times, ms);
    }
    CHECK(times == 12, "%u times in 1.355 s", times);
    test("... but a look that comes late does not catch up for ever");
    CHECK(asked(&t, &s, 60.0, STEER_LEFT) == 4, "too often");
    CHECK(asked(&t, &s, 60.05, STEER_LEFT) == 0 && asked(&t, &s, 60.11, STEER_LEFT) == 1, "then");
    test("... and ends when it is released");
    keys_set(&s, 0, 0);
    CHECK(asked(&t, &s, 90.0, STEER_LEFT) == 0, "it goes on");
}

static void both(void) {
    unsigned count[STEER_ACTIONS];
    keys_track t = {.is_reset = 0};
    keys_state s = {.changes = {0}};
    test("nearer and farther together are the first view, once, and no zoom until both are up");
    keys_set(&s, 1, 1);
    CHECK(asked(&t, &s, 1.0, STEER_NEARER) == 1, "the first alone");
    keys_set(&s, 2, 1);
    keys_take(&t, &s, some, 1.1, count);
    CHECK(count[STEER_RESET] == 1 && count[STEER_NEARER] == 0 && count[STEER_FARTHER] == 0, "both");
    keys_take(&t, &s, some, 3.0, count);
    CHECK(count[STEER_RESET] == 0 && count[STEER_NEARER] == 0 && count[STEER_FARTHER] == 0, "held");
    keys_set(&s, 1, 0);
    keys_take(&t, &s, some, 3.5, count);
    CHECK(count[STEER_FARTHER] == 0, "one is still down");
    keys_set(&s, 2, 0);
    keys_take(&t, &s, some, 3.6, count);
    keys_set(&s, 2, 1);
    keys_take(&t, &s, some, 3.7, count);
    CHECK(count[STEER_FARTHER] == 1, "it zooms again");
    keys_take(&t, &s, NULL, 3.7, count);
    CHECK(count[STEER_FARTHER] == 0, "a display without keys");
}

/* ---- displays ------------------------------------------------------------------------- */

static uint8_t inputs[64][80]; /* to be sent instead of what the model has: length, bytes */
static unsigned input_count, input_at, input_endless;

static void on_output(void *context, const uint8_t *report, size_t bytes) {
    model *m = context;
    m->kind->output(m, report, bytes);
}

static size_t on_input(void *context, uint8_t *report, size_t room) {
    model *m = context;
    if (input_count == 0) {
        return m->kind->input(m, report, room);
    }
    if (input_at == input_count) {
        if (!input_endless) {
            return 0;
        }
        input_at = 0;
    }
    const size_t bytes = inputs[input_at][0] < room ? inputs[input_at][0] : room;
    memcpy(report, inputs[input_at++] + 1, bytes);
    return bytes;
}

static void add_input(const uint8_t *report, uint8_t bytes) {
    inputs[input_count][0] = bytes;
    memcpy(inputs[input_count++] + 1, report, bytes);
}

typedef struct bench {
    model *model;
    fake_device device;
    session session;
    picture shown;
} bench;

static void open_bench(bench *b, const model_kind *kind, int has_keys) {
    fail f = {""};
    memset(b, 0, sizeof *b);
    input_count = input_at = input_endless = 0;
    fake_bus_reset();
    b->model = model_make(kind, (model_shape){.width = 64, .height = 48, .has_keys = has_keys});
    b->device = (fake_device){.path = "1-1:1.0",
                              .vendor = kind->vendor,
                              .product = kind->id,
                              .serial = L"SN1",
                              .numbered = kind->output_number != 0,
                              .context = b->model,
                              .output = on_output,
                              .input = on_input};
    fake_plug(0, &b->device);
    b->session = (session){.wish.drivers = drivers, .brightness = -1, .patience = 3.0};
    CHECK(session_open(&b->session, &f) == 0, "%s", f.text);
}

static void close_bench(bench *b) {
    session_close(&b->session);
    CHECK(b->model->wrong == 0, "%s", b->model->why);
    CHECK(fake_bus.open == 0 && fake_bus.wrong == 0, "hidapi was used as it should");
    picture_free(&b->shown);
    model_free(b->model);
}

/* How often, in the next 60 ms. */
static unsigned heard(bench *b, enum steer_action action) {
    unsigned sum = 0, count[STEER_ACTIONS];
    for (int i = 0; i < 60; i++) {
        session_tick(&b->session);
        session_steer(&b->session, count);
        sum += count[action];
        clock_sleep(1e-3);
    }
    return sum;
}

static void press(bench *b, unsigned key) {
    b->model->kind->key(b->model, key, 1);
    b->model->kind->key(b->model, key, 0);
}

static void every_key(const model_kind *kind) {
    bench b;
    open_bench(&b, kind, 1);
    const display_key *keys = b.session.display.by->keys;
    for (unsigned k = 0; keys[k].name != NULL; k++) {
        CHECK(heard(&b, keys[k].action) == 0, "%s: not pressed", keys[k].name);
        press(&b, k);
        press(&b, k);
        CHECK(heard(&b, keys[k].action) == 2, "%s: %s twice", kind->name, keys[k].name);
    }
    close_bench(&b);
}

static void held_and_unplugged(const model_kind *kind) {
    bench b;
    fail f = {""};
    unsigned count[STEER_ACTIONS];
    open_bench(&b, kind, 1);
    picture_make(&b.shown, b.session.panel.width, b.session.panel.height, &f);
    b.model->kind->key(b.model, 3, 1);
    CHECK(heard(&b, b.session.display.by->keys[3].action) == 1, "%s: not heard", kind->name);
    fake_unplug(0);
    session_tick(&b.session);
    model *next = model_make(kind, (model_shape){.width = 64, .height = 48, .has_keys = 1});
    model_free(b.model);
    b.model = next;
    b.device.context = next;
    fake_plug(0, &b.device);
    CHECK(session_show(&b.session, &b.shown, &f) == 0 && b.session.reconnects == 1, "%s", f.text);
    clock_sleep(0.5);
    CHECK(heard(&b, b.session.display.by->keys[3].action) == 0, "%s: still held", kind->name);
    press(&b, 3);
    CHECK(heard(&b, b.session.display.by->keys[3].action) == 1, "%s: not heard again", kind->name);
    session_steer(&b.session, count);
    close_bench(&b);
}

static void older_firmware(void) {
    bench b;
    fail f = {""};
    test("planelet: an older firmware without keys shows pictures as ever");
    open_bench(&b, &model_planelet, 0);
    picture_make(&b.shown, 64, 48, &f);
    CHECK(session_show(&b.session, &b.shown, &f) == 0 && session_confirm(&b.session, &f) == 0, "%s",
          f.text);
    press(&b, 0);
    CHECK(heard(&b, STEER_LEFT) == 0, "keys of nobody");
    close_bench(&b);
}

static void strange_reports(void) {
    static const uint8_t down[17] = {1, 0, 0, 0, 1}, up[17] = {1}, other[17] = {2, 0, 0, 0, 1};
    static const uint8_t small[6] = {1, 0, 0, 0, 1, 0}, least[7] = {1, 0, 0, 0, 0xFF};
    uint8_t large[64] = {1, 0, 0, 0, 1};
    bench b;
    memset(large + 7, 0xFF, sizeof large - 7);
    test("mini: a report that is short, or of another number, is no key's; a long one is");
    open_bench(&b, &model_mini, 1);
    add_input(other, sizeof other);
    add_input(small, sizeof small);
    CHECK(heard(&b, STEER_LEFT) == 0, "taken");
    add_input(large, sizeof large);
    CHECK(heard(&b, STEER_LEFT) == 1, "not taken");
    add_input(up, sizeof up);
    add_input(least, sizeof least);
    CHECK(heard(&b, STEER_LEFT) == 1, "not taken, with another byte than 1");
    test("mini: a device that never stops to report does not hold up anything");
    add_input(up, sizeof up);
    add_input(down, sizeof down);
    input_endless = 1;
    const double began = clock_seconds();
    session_tick(&b.session);
    CHECK(clock_seconds() - began < 0.2, "%.3f s", clock_seconds() - began);
    input_endless = 0;
    test("mini: reports of any bytes and lengths");
    random_state r = {7};
    for (int round = 0; round < 200; round++) {
        input_count = input_at = 0;
        for (int i = 0; i < 60; i++) {
            uint8_t bytes[79];
            for (size_t k = 0; k < sizeof bytes; k++) {
                bytes[k] = (uint8_t)(random_below(&r, 3) ? random_below(&r, 2) : random_bits(&r));
            }
            add_input(bytes, (uint8_t)(1 + random_below(&r, sizeof bytes)));
        }
        unsigned count[STEER_ACTIONS];
        session_tick(&b.session);
        session_steer(&b.session, count);
        for (unsigned a = 0; a < STEER_ACTIONS; a++) {
            CHECK(count[a] <= 8, "%u times", count[a]);
        }
    }
    close_bench(&b);
}

/* ---- a scene -------------------------------------------------------------------------- */

static char path[256];

static const arg_flag flags[] = {{"--shader", "NAME", ""},
                                 {"--turn", "SECONDS", ""},
                                 {"--bare", NULL, ""},
                                 VIEW_FLAGS,
                                 SCENE_FLAGS,
                                 {NULL, NULL, NULL}};
static const arg_command command = {"show", "", "", flags, 0, 1, NULL, NULL};

static void write_scene(void) {
    const char *folder = getenv("TMPDIR");
    mesh m = {0};
    rig r;
    const rig_config config =
        rig_config_of(2, rig_is_tiny() ? 1 : 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_soup(&m, rig_triangles(60, 2), 0.8f, 3);
    CHECK(rig_open(&r, &m, &config) == PLT_OK, "%s", r.fault.message);
    snprintf(path, sizeof path, "%s/planelet-%ld-keys.plt", folder == NULL ? "/tmp" : folder,
             (long)getpid());
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL && fwrite(r.image.bytes, 1, r.image.size, file) == r.image.size, "%s", path);
    if (file != NULL) {
        fclose(file);
    }
    rig_close(&r);
    mesh_free(&m);
}

typedef struct turning {
    bench bench;
    args args;
    frames source;
    unsigned pictures;
} turning;

static void steer_by(void *context, unsigned count[STEER_ACTIONS]) {
    session_steer(context, count);
}

static int tick(void *context) {
    session_tick(context);
    return 0;
}

static void open_turning(turning *t, const model_kind *kind, const char *seconds, int is_bare) {
    fail f = {""};
    static char turn[] = "--turn", bare[] = "--bare";
    char number[16];
    char *words[] = {turn, number, path, bare, NULL};
    snprintf(number, sizeof number, "%s", seconds);
    open_bench(&t->bench, kind, 1);
    CHECK(args_parse(&t->args, "planelet-hid", &command, is_bare ? 4 : 3, words) == ARGS_GO_ON,
          "flags");
    t->source = (frames){.from = {.tick = tick, .context = &t->bench.session},
                         .keys = t->bench.session.display.by->keys,
                         .steer = steer_by};
    CHECK(frames_open(&t->source, &t->args, path, t->bench.session.panel.width,
                      t->bench.session.panel.height, &f) == 0,
          "%s", f.text);
    t->pictures = 0;
}

static void close_turning(turning *t) {
    frames_close(&t->source);
    args_free(&t->args);
    close_bench(&t->bench);
}

/* As planelet-hid show does. */
static void show_next(turning *t) {
    fail f = {""};
    CHECK(t->source.next(&t->source, &t->bench.shown, &f) == FRAMES_ONE, "%s", f.text);
    CHECK(session_show(&t->bench.session, &t->bench.shown, &f) == 0 &&
              session_confirm(&t->bench.session, &f) == 0,
          "%s", f.text);
    t->pictures++;
}

/* What is on the panel when two pictures that follow each other are the same. */
static uint8_t *settled(turning *t) {
    const size_t bytes = 3 * (size_t)t->bench.model->width * t->bench.model->height;
    uint8_t *last = calloc(1, bytes);
    int same = 0;
    for (int i = 0; i < 40 && !same; i++) {
        show_next(t);
        same = i > 0 && memcmp(last, t->bench.model->rgb, bytes) == 0;
        memcpy(last, t->bench.model->rgb, bytes);
    }
    CHECK(same, "it never comes to rest");
    return last;
}

static int is_same(const turning *t, const uint8_t *a, const uint8_t *b) {
    return memcmp(a, b, 3 * (size_t)t->bench.model->width * t->bench.model->height) == 0;
}

static unsigned key_for(const turning *t, enum steer_action action) {
    const display_key *keys = t->bench.session.display.by->keys;
    for (unsigned k = 0; keys[k].name != NULL; k++) {
        if (keys[k].action == action) {
            return k;
        }
    }
    return KEYS_MOST;
}

/* Until the report of it has come. */
static void listen_for(turning *t) {
    for (int i = 0; i < 30; i++) {
        session_tick(&t->bench.session);
        clock_sleep(1e-3);
    }
}

static void press_for(turning *t, enum steer_action action) {
    press(&t->bench, key_for(t, action));
    listen_for(t);
}

static void reset(turning *t) {
    const unsigned nearer = key_for(t, STEER_NEARER), farther = key_for(t, STEER_FARTHER);
    model *m = t->bench.model;
    if (key_for(t, STEER_RESET) < KEYS_MOST) {
        press_for(t, STEER_RESET);
        return;
    }
    m->kind->key(m, nearer, 1);
    m->kind->key(m, farther, 1);
    listen_for(t);
    show_next(t);
    m->kind->key(m, nearer, 0);
    m->kind->key(m, farther, 0);
    listen_for(t);
}

static void turned(const model_kind *kind) {
    static const enum steer_action there[] = {STEER_LEFT, STEER_UP, STEER_NEARER};
    static const enum steer_action back[] = {STEER_RIGHT, STEER_DOWN, STEER_FARTHER};
    turning t;
    open_turning(&t, kind, "0", 0);
    listen_for(&t); /* the device, too, knows that a session is up */
    reset(&t);
    uint8_t *first = settled(&t);
    for (int i = 0; i < 3; i++) {
        press_for(&t, there[i]);
        uint8_t *other = settled(&t);
        CHECK(!is_same(&t, first, other), "%s: key %d does nothing", kind->name, i);
        free(other);
        press_for(&t, back[i]);
        other = settled(&t);
        CHECK(is_same(&t, first, other), "%s: key %d does not go back", kind->name, i);
        free(other);
    }
    for (int i = 0; i < 3; i++) {
        press_for(&t, there[i]);
    }
    uint8_t *other = settled(&t);
    CHECK(!is_same(&t, first, other), "%s: nothing", kind->name);
    free(other);
    reset(&t);
    other = settled(&t);
    CHECK(is_same(&t, first, other), "%s: not the first view again", kind->name);
    free(other);
    free(first);
    close_turning(&t);
}

static void by_clock_until_a_key(void) {
    turning t;
    test("planelet: the camera circles until a key is pressed, and then is at rest");
    open_turning(&t, &model_planelet, "2", 0);
    uint8_t *last = calloc(3, 64 * 48);
    for (int i = 0; i < 4; i++) {
        show_next(&t);
        CHECK(!is_same(&t, last, t.bench.model->rgb), "picture %d stands still", i);
        memcpy(last, t.bench.model->rgb, 3 * 64 * 48);
        clock_sleep(0.1);
    }
    free(last);
    press_for(&t, STEER_UP);
    const unsigned before = t.pictures;
    free(settled(&t));
    CHECK(t.pictures - before <= 8, "%u pictures to come to rest", t.pictures - before);
    test("planelet: at rest a picture is shown again every half second, no more");
    const double began = clock_seconds();
    show_next(&t);
    show_next(&t);
    CHECK(clock_seconds() - began > 0.8, "%.2f s for two", clock_seconds() - began);
    close_turning(&t);
}

static unsigned pixels_that_differ(const uint8_t *a, const uint8_t *b, unsigned width, unsigned x,
                                   unsigned y, unsigned w, unsigned h) {
    unsigned sum = 0;
    for (unsigned j = y; j < y + h; j++) {
        for (unsigned i = x; i < x + w; i++) {
            sum += memcmp(a + 3 * (j * width + i), b + 3 * (j * width + i), 3) != 0;
        }
    }
    return sum;
}

static void symbols(void) {
    turning t;
    test("mini: each key has a symbol in its corner, and nothing else is another; --bare: none");
    open_turning(&t, &model_mini, "0", 1);
    show_next(&t);
    uint8_t *bare = malloc(3 * 240 * 160);
    memcpy(bare, t.bench.model->rgb, 3 * 240 * 160);
    close_turning(&t);
    open_turning(&t, &model_mini, "0", 0);
    show_next(&t);
    const uint8_t *with = t.bench.model->rgb;
    unsigned sum = 0;
    for (unsigned k = 0; k < 6; k++) {
        const unsigned n =
            pixels_that_differ(with, bare, 240, k % 3 * 80 + 4, k / 3 * 80 + 80 - SYMBOL_SIDE - 4,
                               SYMBOL_SIDE, SYMBOL_SIDE);
        CHECK(n > 30, "key %u: %u pixels", k, n);
        sum += n;
    }
    CHECK(sum == pixels_that_differ(with, bare, 240, 0, 0, 240, 160), "more than the symbols");
    close_turning(&t);
    free(bare);
    test("a symbol at the edge of a small picture is cut, not written beyond");
    static const display_key corner[] = {{"x", STEER_RESET, 5, 3}, {NULL, STEER_LEFT, 0, 0}};
    picture p = {0};
    fail f = {""};
    CHECK(picture_make(&p, 8, 6, &f) == 0, "%s", f.text);
    symbols_draw(&p, corner);
    symbols_draw(&p, NULL);
    picture_free(&p);
}

int main(void) {
    if (freopen("/dev/null", "w", stderr) == NULL) {
        return 1;
    }
    presses();
    held();
    both();
    test("planelet: every key is heard, each press once");
    every_key(&model_planelet);
    test("mini: every key is heard, each press once");
    every_key(&model_mini);
    test("planelet, mini: a key that was held when the display was unplugged is not held after it");
    held_and_unplugged(&model_planelet);
    held_and_unplugged(&model_mini);
    older_firmware();
    strange_reports();
    write_scene();
    test("planelet: keys turn a scene, zoom, and show the first view again");
    turned(&model_planelet);
    test("mini: keys turn a scene, zoom, and show the first view again");
    turned(&model_mini);
    by_clock_until_a_key();
    symbols();
    unlink(path);
    return test_done();
}
