/* test_hid_streamdeck - Stream Decks that take JPEG files, on a fake of hidapi
 *
 * The model and these bytes come from the same published notes as the driver; files are read by a
 * decoder that knows T.81 only. Nothing here ran on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "tests/hid/pattern.h"
#include "tests/reference/display_bench.h"

enum { KINDS = 4 };

static const model_kind *const kinds[KINDS] = {&model_deck, &model_deck_xl, &model_deck_neo,
                                               &model_deck_plus};

static int show(bench *b) {
    fail f = {""};
    record.count = 0;
    return b->display.by->show(&b->display, &b->shown, &f);
}

static void sentence(const model_kind *kind, const char *text) {
    char whole[160];
    snprintf(whole, sizeof whole, "%s: %s", kind->name, text);
    test(whole);
}

/* A picture as a scene has it: shades that change slowly, and edges. */
static void shaded(picture *p, unsigned turn) {
    for (unsigned y = 0; y < p->height; y++) {
        for (unsigned x = 0; x < p->width; x++) {
            uint8_t *rgb = p->rgb + 3 * ((size_t)y * p->width + x);
            const double dx = x - p->width / 2.0, dy = y - p->height / 2.0;
            const double far = sqrt(dx * dx + dy * dy) / p->height;
            const int inside = far < 0.4;
            rgb[0] = (uint8_t)(inside ? 240 - 300 * far : 40 + y * 60 / p->height + turn);
            rgb[1] = (uint8_t)(inside ? 200 - 200 * far : 60 + x * 60 / p->width);
            rgb[2] = (uint8_t)(inside ? 90 + turn : 120);
        }
    }
    for (unsigned y = 192; p->height == 237 && y < 237; y++) { /* beside a Neo's window */
        memset(p->rgb + 3 * (size_t)y * p->width, 0, 3 * 96);
        memset(p->rgb + 3 * ((size_t)y * p->width + 288), 0, 3 * 96);
    }
}

static void near_enough(const model_kind *kind) {
    bench b;
    sentence(kind, "shaded pictures are on the panel to at least 38 dB");
    open_bench(&b, kind);
    for (unsigned turn = 0; turn < 3; turn++) {
        double sum = 0;
        shaded(&b.shown, turn);
        CHECK(show(&b) == DISPLAY_OK, "turn %u", turn);
        const size_t count = (size_t)3 * b.shown.width * b.shown.height;
        for (size_t i = 0; i < count; i++) {
            const double off = (double)b.shown.rgb[i] - b.model->rgb[i];
            sum += off * off;
        }
        const double decibels = 10 * log10(255 * 255 / (sum / (double)count));
        CHECK(decibels >= 38, "%.1f dB", decibels);
        printf("    %s: %.1f dB, %u reports\n", kind->name, decibels, record.count);
    }
    close_bench(&b);
}

static void pattern(const model_kind *kind) {
    bench b;
    sentence(kind, "patterns with noise and thin lines are on the panel, and no other");
    open_bench(&b, kind);
    for (unsigned n = 0; n < 6; n++) {
        pattern_fill(n, b.shown.width, b.shown.height, b.shown.rgb);
        CHECK(show(&b) == DISPLAY_OK, "picture %u", n);
        CHECK(model_shows_pattern(b.model, n, 1) == (int)n, "picture %u", n);
        CHECK(model_shows_pattern(b.model, n + 1, 1) == -1, "picture %u is another one", n);
    }
    close_bench(&b);
}

static void changes(const model_kind *kind) {
    bench b;
    sentence(kind, "only keys that changed are sent again");
    open_bench(&b, kind);
    shaded(&b.shown, 0);
    CHECK(show(&b) == DISPLAY_OK, "first");
    CHECK(show(&b) == DISPLAY_OK && record.count == 0, "%u reports for nothing", record.count);
    const unsigned changed = b.model->changes;
    b.shown.rgb[0] ^= 0xFF;
    CHECK(show(&b) == DISPLAY_OK, "one key");
    CHECK(b.model->changes == changed + 1, "%u changes", b.model->changes - changed);
    for (unsigned i = 0; i < record.count; i++) {
        CHECK(record.bytes[i][1] == 7 && record.bytes[i][2] == 0, "not key 0");
    }
    const unsigned last = b.shown.width * b.shown.height - 1;
    const unsigned command = kind == &model_deck_plus ? 0x0C : kind == &model_deck_neo ? 0x0B : 7;
    b.shown.rgb[3 * (kind == &model_deck_neo ? last - 96 : last)] ^= 0xFF;
    CHECK(show(&b) == DISPLAY_OK, "the last pixel");
    CHECK(b.model->changes == changed + 2, "%u changes", b.model->changes - changed);
    CHECK(record.count > 0 && record.bytes[0][1] == command, "%02x", record.bytes[0][1]);
    close_bench(&b);
}

static void budget(const model_kind *kind) {
    bench b;
    uint32_t seed = 7;
    sentence(kind, "noise takes no more reports than 1.5 bytes per pixel");
    open_bench(&b, kind);
    for (unsigned i = 0; i < 3 * b.shown.width * b.shown.height; i++) {
        seed = seed * 1664525u + 1013904223u;
        b.shown.rgb[i] = (uint8_t)(seed >> 24);
    }
    CHECK(show(&b) == DISPLAY_OK, "noise");
    const unsigned side = kind->width == 360 ? 72 : kind->height == 300 ? 120 : 96;
    const unsigned keys = kind->width / side * (kind->height / side);
    const unsigned most = keys * ((side * side * 3 / 2 + 1015) / 1016) +
                          (kind->height == 300   ? (800 * 100 * 3 / 2 + 1007) / 1008
                           : kind->height == 237 ? (248 * 58 * 3 / 2 + 1015) / 1016
                                                 : 0);
    CHECK(record.count <= most && record.count > keys, "%u reports of %u", record.count, most);
    close_bench(&b);
}

static void unplugged(const model_kind *kind) {
    bench b;
    fail f = {""};
    sentence(kind, "unplugged before any report it says so");
    for (unsigned after = 1; after < 5; after++) {
        open_bench(&b, kind);
        fake_bus.unplug_after = after;
        pattern_fill(after, b.shown.width, b.shown.height, b.shown.rgb);
        CHECK(b.display.by->show(&b.display, &b.shown, &f) == DISPLAY_GONE, "%u", after);
        CHECK(f.text[0] == '\0', "no sentence: it may come back");
        close_bench(&b);
    }
}

static void features(const model_kind *kind) {
    bench b;
    fail f = {""};
    static const uint8_t brightness[32] = {3, 8, 70}, reset[32] = {3, 2};
    sentence(kind, "brightness and the device's own picture are the bytes of the notes");
    open_bench(&b, kind);
    CHECK(b.display.by->brightness(&b.display, 70, &f) == DISPLAY_OK, "%s", f.text);
    CHECK(b.display.by->release(&b.display, &f) == DISPLAY_OK, "%s", f.text);
    CHECK(record.count == 2 && memcmp(record.bytes[0], brightness, 32) == 0 &&
              memcmp(record.bytes[1], reset, 32) == 0,
          "%u reports", record.count);
    CHECK(b.model->brightness == 70 && b.model->releases == 1, "%d", b.model->brightness);
    close_bench(&b);
}

static void head_bytes(void) {
    bench b;
    test("streamdeck: a key of one colour is one report, with the bytes of the notes");
    open_bench(&b, &model_deck);
    memset(b.shown.rgb, 200, (size_t)3 * b.shown.width * b.shown.height);
    CHECK(show(&b) == DISPLAY_OK, "grey");
    CHECK(record.count == 15, "%u reports", record.count);
    for (unsigned i = 0; i < record.count; i++) {
        const uint8_t *r = record.bytes[i];
        const unsigned bytes = r[4] + 256u * r[5];
        CHECK(r[0] == 2 && r[1] == 7 && r[2] == i && r[3] == 1 && r[6] == 0 && r[7] == 0, "%u", i);
        CHECK(r[8] == 0xFF && r[9] == 0xD8 && r[8 + bytes - 2] == 0xFF && r[8 + bytes - 1] == 0xD9,
              "no JPEG file of %u bytes", bytes);
    }
    close_bench(&b);
    test("streamdeck-plus: the strip is a file of 800x100 with the bytes of the notes");
    open_bench(&b, &model_deck_plus);
    CHECK(show(&b) == DISPLAY_OK, "black");
    static const uint8_t head[10] = {2, 0x0C, 0, 0, 0, 0, 0x20, 0x03, 100, 0};
    CHECK(record.count == 11, "%u reports", record.count);
    for (unsigned part = 0; part < 3; part++) {
        const uint8_t *r = record.bytes[8 + part];
        const unsigned bytes = r[13] + 256u * r[14];
        CHECK(memcmp(r, head, 10) == 0 && r[10] == (part == 2) && r[11] == part && r[12] == 0 &&
                  r[15] == 0,
              "part %u", part);
        CHECK(part == 2 ? bytes < 1008 : bytes == 1008, "%u bytes in part %u", bytes, part);
    }
    close_bench(&b);
    test("streamdeck-neo: the window is a file of 248x58 with the bytes of the notes");
    open_bench(&b, &model_deck_neo);
    memset(b.shown.rgb, 90, (size_t)3 * b.shown.width * b.shown.height);
    CHECK(show(&b) == DISPLAY_OK, "grey");
    const uint8_t *r = record.bytes[8], *end = record.bytes[9];
    const unsigned bytes = end[4] + 256u * end[5];
    CHECK(record.count == 10, "%u reports", record.count);
    CHECK(memcmp(r, "\2\13\0\0\370\3\0\0\377\330", 10) == 0, "the first report");
    CHECK(memcmp(end, "\2\13\0\1", 4) == 0 && end[6] == 1 && end[7] == 0, "the second");
    CHECK(end[8 + bytes - 2] == 0xFF && end[8 + bytes - 1] == 0xD9, "no end");
    test("streamdeck-neo: what is beside the window is not sent");
    b.shown.rgb[3 * ((size_t)200 * 384 + 95)] = 0;
    b.shown.rgb[3 * ((size_t)200 * 384 + 288)] = 0;
    CHECK(show(&b) == DISPLAY_OK && record.count == 0, "%u reports", record.count);
    close_bench(&b);
}

/* ---- keys and dials --------------------------------------------------------------------- */

/* Changes of each entry of the driver's list that a report makes. */
static void hear(bench *b, const uint8_t *report, size_t bytes, uint8_t changes[KEYS_MOST]) {
    const keys_state before = b->display.keys;
    add(report, bytes);
    CHECK(b->display.by->tick(&b->display) == DISPLAY_OK, "gone");
    CHECK(queue.at == queue.count, "a report waits");
    for (unsigned k = 0; k < KEYS_MOST; k++) {
        changes[k] = (uint8_t)(b->display.keys.changes[k] - before.changes[k]);
    }
}

static int is_alone(const uint8_t changes[KEYS_MOST], unsigned key, unsigned by) {
    for (unsigned k = 0; k < KEYS_MOST; k++) {
        if (changes[k] != (k == key ? by : 0)) {
            return 0;
        }
    }
    return 1;
}

static void keys(const model_kind *kind) {
    bench b;
    uint8_t changes[KEYS_MOST];
    sentence(kind, "the first two rows of keys are heard, each by itself");
    open_bench(&b, kind);
    const unsigned side = kind->width == 360 ? 72 : kind->height == 300 ? 120 : 96;
    const unsigned columns = kind->width / side, count = columns * (kind->height / side);
    for (unsigned key = 0; key < count; key++) {
        uint8_t report[64] = {1, 0, (uint8_t)count};
        const unsigned column = key % columns, row = key / columns;
        const int has_one = column < 4 && row < 2;
        report[4 + key] = 1;
        hear(&b, report, sizeof report, changes);
        CHECK(is_alone(changes, has_one ? column + 4 * row : KEYS_MOST, 1), "key %u", key);
        report[4 + key] = 0;
        hear(&b, report, sizeof report, changes);
        CHECK(is_alone(changes, has_one ? column + 4 * row : KEYS_MOST, 1), "key %u is up", key);
    }
    for (unsigned k = 0; k < 8; k++) {
        const display_key *of = &b.display.by->keys[k];
        CHECK(of->x / side == k % 4 && of->y / side == k / 4, "the symbol of %s", of->name);
    }
    test("streamdeck: short reports, and others, are no keys'");
    const uint8_t other[20] = {2, 0, 15, 0, 1}, nothing[20] = {1, 0, 0, 0, 1},
                  unknown[20] = {1, 7, 15, 0, 1}, small[6] = {1, 0, 15, 0, 0, 1};
    hear(&b, other, sizeof other, changes);
    CHECK(is_alone(changes, KEYS_MOST, 0), "another number");
    hear(&b, unknown, sizeof unknown, changes);
    CHECK(is_alone(changes, KEYS_MOST, 0), "another command");
    hear(&b, nothing, sizeof nothing, changes);
    CHECK(is_alone(changes, KEYS_MOST, 0), "of no bytes");
    hear(&b, small, sizeof small, changes);
    CHECK(is_alone(changes, KEYS_MOST, 0), "short");
    close_bench(&b);
}

static void dials(void) {
    bench b;
    uint8_t changes[KEYS_MOST];
    test("streamdeck-plus: a step of a dial is a press, and no turn is more than eight");
    open_bench(&b, &model_deck_plus);
    for (unsigned dial = 0; dial < 4; dial++) {
        static const int8_t turns[] = {1, -1, 3, -5, 127, -128};
        for (unsigned i = 0; i < sizeof turns; i++) {
            uint8_t report[14] = {1, 3, 5, 0, 1};
            const unsigned size = (unsigned)(turns[i] < 0 ? -turns[i] : turns[i]);
            report[5 + dial] = (uint8_t)turns[i];
            hear(&b, report, sizeof report, changes);
            CHECK(is_alone(changes, dial < 3 ? 8 + 2 * dial + (turns[i] > 0) : KEYS_MOST,
                           2 * (size < 8 ? size : 8)),
                  "dial %u by %d", dial, turns[i]);
        }
    }
    const uint8_t pressed[14] = {1, 3, 5, 0, 0, 1, 1, 1, 1};
    hear(&b, pressed, sizeof pressed, changes);
    CHECK(is_alone(changes, KEYS_MOST, 0), "a dial that is pressed turns nothing");
    close_bench(&b);
    test("streamdeck: what has no dials is not turned by them");
    open_bench(&b, &model_deck);
    const uint8_t turned[14] = {1, 3, 5, 0, 1, 1, 1, 1, 1};
    hear(&b, turned, sizeof turned, changes);
    CHECK(is_alone(changes, KEYS_MOST, 0), "turned");
    close_bench(&b);
}

int main(void) {
    for (unsigned i = 0; i < KINDS; i++) {
        near_enough(kinds[i]);
        pattern(kinds[i]);
        changes(kinds[i]);
        budget(kinds[i]);
        unplugged(kinds[i]);
        features(kinds[i]);
        keys(kinds[i]);
    }
    near_enough(&model_corsair_lcd);
    dials();
    head_bytes();
    return test_done();
}
