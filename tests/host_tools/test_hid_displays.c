/* test_hid_displays - real displays' reports, byte for byte, on a fake of hidapi
 *
 * The models and these bytes come from the same published notes as the
 * drivers: they show agreement with the notes. Nothing here ran on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/picture/dither.h"
#include "tests/hid/pattern.h"
#include "tests/reference/display_bench.h"

static void show(bench *b, unsigned number) {
    fail f = {""};
    pattern_fill(number, b->shown.width, b->shown.height, b->shown.rgb);
    CHECK(b->display.by->show(&b->display, &b->shown, &f) == DISPLAY_OK, "%s", f.text);
}

static void every_pixel(const model_kind *kind) {
    bench b;
    char sentence[120];
    snprintf(sentence, sizeof sentence, "%s: 20 pictures are on the panel, every pixel",
             kind->name);
    test(sentence);
    open_bench(&b, kind);
    for (unsigned n = 0; n < 20; n++) {
        show(&b, n);
        CHECK(model_shows_pattern(b.model, n, 1) == (int)n, "picture %u", n);
    }
    close_bench(&b);
}

static void brightness(const model_kind *kind, unsigned percent, int expected) {
    bench b;
    fail f = {""};
    char sentence[120];
    snprintf(sentence, sizeof sentence, "%s: brightness %u %% arrives as %d", kind->name, percent,
             expected);
    test(sentence);
    open_bench(&b, kind);
    CHECK(b.display.by->brightness(&b.display, percent, &f) == DISPLAY_OK, "%s", f.text);
    CHECK(b.model->brightness == expected, "%d", b.model->brightness);
    close_bench(&b);
}

static void expect(unsigned report, size_t at, const char *hex) {
    for (size_t i = 0; hex[2 * i] != '\0'; i++) {
        const char digits[] = {hex[2 * i], hex[2 * i + 1], '\0'};
        const unsigned want = (unsigned)strtoul(digits, NULL, 16);
        CHECK(record.bytes[report][at + i] == want, "report %u, byte %zu is %02x, not %02x", report,
              at + i, record.bytes[report][at + i], want);
    }
}

static void paint(bench *b, unsigned x, unsigned y, uint32_t rgb) {
    uint8_t *p = b->shown.rgb + 3 * ((size_t)y * b->shown.width + x);
    p[0] = (uint8_t)(rgb >> 16);
    p[1] = (uint8_t)(rgb >> 8);
    p[2] = (uint8_t)rgb;
}

static void show_painted(bench *b) {
    fail f = {""};
    record.count = 0;
    CHECK(b->display.by->show(&b->display, &b->shown, &f) == DISPLAY_OK, "%s", f.text);
}

static void mini_bytes(void) {
    bench b;
    test("streamdeck-mini: header, BMP head and pixels are the bytes of the notes");
    open_bench(&b, &model_mini);
    CHECK(record.count == 1 && record.size[0] == 1024, "%u reports at the start", record.count);
    expect(0, 0, "020000000000000000000000000000000000");
    paint(&b, 79, 0, 0x112233);   /* key 0, top right: the first pixel of its file */
    paint(&b, 79, 1, 0x445566);   /* below it: the second */
    paint(&b, 80, 159, 0x778899); /* key 4, bottom left: the last */
    show_painted(&b);
    CHECK(record.count == 120 && record.size[0] == 1024, "%u reports", record.count);
    expect(0, 0, "02010000000100000000000000000000");
    expect(0, 16,
           "424d364b0000000000003600000028000000500000005000000001001800"
           "00000000004b0000130b0000130b00000000000000000000");
    expect(0, 70, "332211665544000000");
    expect(1, 0, "02010100000100000000000000000000");
    expect(19, 0, "02011300010100000000000000000000");
    expect(99, 0, "02011300010500000000000000000000");
    /* 19254 bytes are 19 pages of 1008 and 102 */
    expect(99, 16 + 99, "998877");
    expect(99, 16 + 102, "000000");
    close_bench(&b);
    test("streamdeck-mini: only keys that changed are sent again");
    open_bench(&b, &model_mini);
    show_painted(&b);
    paint(&b, 239, 159, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 20, "%u reports", record.count);
    expect(0, 0, "020100000006");
    show_painted(&b);
    CHECK(record.count == 0, "%u reports", record.count);
    test("streamdeck-mini: ... and one that is to be sent in any case");
    b.display.by->forget(&b.display, 2);
    show_painted(&b);
    CHECK(record.count == 20, "%u reports", record.count);
    expect(0, 0, "020100000003");
    close_bench(&b);
}

static void nexus_bytes(void) {
    bench b;
    fail f = {""};
    test("nexus: 121 reports, blocks and lengths of the notes, blue first");
    open_bench(&b, &model_nexus);
    paint(&b, 0, 0, 0x112233);
    paint(&b, 639, 47, 0x445566);
    show_painted(&b);
    CHECK(record.count == 121 && record.size[120] == 1024, "%u reports", record.count);
    const uint8_t *first = record.bytes[0] + 8, *last = record.bytes[120] + 8 + 956;
    expect(0, 0, "020540000000f803");
    expect(1, 0, "020540000100f803");
    expect(120, 0, "020540017800c003");
    CHECK(first[0] == dither_six_bits(0x33, 0, 0) && first[1] == dither_six_bits(0x22, 0, 0) &&
              first[2] == dither_six_bits(0x11, 0, 0) && first[3] == 0,
          "%02x%02x%02x%02x", first[0], first[1], first[2], first[3]);
    CHECK(last[0] == dither_six_bits(0x66, 639, 47) && last[2] == dither_six_bits(0x44, 639, 47) &&
              last[3] == 0 && last[4] == 0,
          "%02x%02x%02x%02x", last[0], last[1], last[2], last[3]);
    test("nexus: the return to its own picture, and brightness up, are the bytes of the notes");
    record.count = 0;
    CHECK(b.display.by->release(&b.display, &f) == DISPLAY_OK, "%s", f.text);
    CHECK(record.count == 2 && record.size[0] == 32, "%u reports", record.count);
    expect(0, 0, "030d010100000000");
    expect(1, 0, "0301640000000000");
    close_bench(&b);
}

static void oled_bytes(void) {
    bench b;
    test("nova: two windows of 64 columns, lowest bit on top");
    open_bench(&b, &model_nova);
    paint(&b, 0, 0, 0xFFFFFF);
    paint(&b, 0, 9, 0xFFFFFF);
    paint(&b, 65, 63, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 2 && record.size[1] == 1024, "%u reports", record.count);
    expect(0, 0, "06930000404001020000000000000000");
    expect(1, 0, "0693400040400000000000000000000000000000008000");
    close_bench(&b);
    test("nova-elite: the same, report number 1");
    open_bench(&b, &model_nova_elite);
    paint(&b, 65, 63, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 2 && record.size[1] == 1024, "%u reports", record.count);
    expect(0, 0, "019300004040000000000000");
    expect(1, 0, "0193400040400000000000000000000000000000008000");
    close_bench(&b);
}

static void apex_bytes(void) {
    bench b;
    test("apex: one report of 642 bytes without a number, rows, highest bit left");
    open_bench(&b, &model_apex);
    paint(&b, 0, 0, 0xFFFFFF);
    paint(&b, 9, 1, 0xFFFFFF);
    paint(&b, 127, 39, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 1 && record.size[0] == 642, "%u reports", record.count);
    expect(0, 0, "6180");
    expect(0, 17, "0040");
    expect(0, 640, "0100");
    CHECK(fake_bus.features == 1 && fake_bus.outputs == 0, "%llu feature reports",
          (unsigned long long)fake_bus.features);
    close_bench(&b);
    test("apex-2023: one report of 644 bytes without a number, pages, lowest bit on top");
    open_bench(&b, &model_apex_2023);
    paint(&b, 0, 0, 0xFFFFFF);
    paint(&b, 9, 1, 0xFFFFFF);
    paint(&b, 0, 8, 0xFFFFFF);
    paint(&b, 127, 39, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 1 && record.size[0] == 644, "%u reports", record.count);
    expect(0, 0, "1f8101000000000000000002");
    expect(0, 2 + 128, "0100");
    expect(0, 2 + 639, "800000");
    close_bench(&b);
}

static void logitech_bytes(void) {
    bench b;
    test("logitech: 03, 31 zeros, six bands of 160 columns, lowest bit on top");
    open_bench(&b, &model_logitech);
    paint(&b, 0, 0, 0xFFFFFF);
    paint(&b, 1, 7, 0xFFFFFF);
    paint(&b, 2, 8, 0xFFFFFF);
    paint(&b, 159, 42, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 1 && record.size[0] == 992, "%u reports", record.count);
    expect(0, 0, "030000000000000000000000000000000000000000000000000000000000000001800000");
    expect(0, 32 + 160, "00000100");
    expect(0, 991, "04");
    close_bench(&b);
}

static void picolcd_bytes(void) {
    bench b;
    test("picolcd: each controller is started, then its pages come in halves");
    open_bench(&b, &model_picolcd);
    CHECK(record.count == 4 && record.size[3] == 64, "%u reports", record.count);
    expect(0, 0, "94000200643f0064c00000");
    expect(3, 0, "940c0200643f0064c00000");
    paint(&b, 0, 0, 0xFFFFFF);
    paint(&b, 33, 15, 0xFFFFFF);
    paint(&b, 255, 63, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 64 && record.size[0] == 64, "%u reports", record.count);
    expect(0, 0,
           "96000200"
           "00b8000040000020"
           "010000");
    expect(1, 0,
           "9501000020"
           "0000");
    expect(2, 0, "9600020000b900004000002000");
    expect(3, 0,
           "9501000020"
           "008000");
    expect(62, 0, "960c020000bf000040000020");
    expect(63, 0, "950d000020");
    expect(63, 36, "800000");
    test("picolcd: only pages that changed are sent again");
    paint(&b, 200, 20, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 2, "%u reports", record.count);
    expect(0, 0,
           "960c020000ba000040000020"
           "0000000000000000"
           "10");
    show_painted(&b);
    CHECK(record.count == 0, "%u reports", record.count);
    close_bench(&b);
}

static void original_bytes(void) {
    bench b;
    test("streamdeck-original: halves of a BMP file in two reports of 8191 bytes, keys mirrored");
    open_bench(&b, &model_original);
    paint(&b, 71, 0, 0x112233);    /* key 0, top right: the first pixel of its file */
    paint(&b, 70, 0, 0x445566);    /* left of it: the second */
    paint(&b, 288, 215, 0x778899); /* key 14, bottom left: the last of its file */
    show_painted(&b);
    CHECK(record.count == 30 && record.size[0] == 8191, "%u reports", record.count);
    expect(0, 0, "02010100000500000000000000000000");
    expect(0, 16,
           "424df63c0000000000003600000028000000480000004800000001001800"
           "00000000c03c0000c40e0000c40e00000000000000000000");
    expect(0, 70, "332211665544000000");
    expect(0, 16 + 7803, "000000");
    expect(1, 0, "02010200010500000000000000000000");
    expect(2, 0, "02010100000400000000000000000000");
    expect(29, 0, "02010200010b00000000000000000000");
    expect(29, 16 + 7800, "998877000000");
    test("streamdeck-original: only keys that changed are sent again");
    paint(&b, 359, 0, 0xFFFFFF);
    show_painted(&b);
    CHECK(record.count == 2, "%u reports", record.count);
    expect(0, 0, "020101000001");
    close_bench(&b);
}

static void original_keys(void) {
    bench b;
    test("streamdeck-original: a key is heard from the right, as it is counted there");
    open_bench(&b, &model_original);
    for (unsigned key = 0; key < 15; key++) {
        uint8_t report[16] = {1};
        const unsigned column = key % 5, row = key / 5, entry = column + 4 * row;
        const int steers = column < 4 && row < 2;
        const keys_state before = b.display.keys;
        report[1 + 5 * row + 4 - column] = 1;
        add(report, sizeof report);
        CHECK(b.display.by->tick(&b.display) == DISPLAY_OK, "gone");
        for (unsigned k = 0; k < KEYS_MOST; k++) {
            const unsigned changed = (uint8_t)(b.display.keys.changes[k] - before.changes[k]);
            CHECK(changed == (steers && k == entry), "key %u: entry %u", key, k);
        }
        const uint8_t up[16] = {1};
        add(up, sizeof up);
        b.display.by->tick(&b.display);
    }
    close_bench(&b);
}

static void corsair_bytes(void) {
    bench b;
    uint32_t seed = 7;
    test("corsair-lcd: a JPEG file in parts of 1016 bytes");
    open_bench(&b, &model_corsair_lcd);
    memset(b.shown.rgb, 77, (size_t)3 * 480 * 480);
    show_painted(&b);
    const unsigned last = record.count - 1;
    const size_t bytes = record.bytes[last][6] + 256u * record.bytes[last][7];
    CHECK(record.count > 1 && record.size[0] == 1024, "%u reports", record.count);
    expect(0, 0, "020540000000f803ffd8ffe0");
    expect(1, 0, "020540000100f803");
    CHECK(record.bytes[last][3] == 1 && record.bytes[last][4] == last, "the last");
    expect(last, 8 + bytes - 2, "ffd900");
    show_painted(&b);
    CHECK(record.count == 0, "%u reports for nothing", record.count);
    test("corsair-lcd: noise, and the wildest of it, takes its budget, or a little more");
    for (unsigned wild = 0; wild < 2; wild++) {
        for (unsigned i = 0; i < 3 * 480 * 480; i++) {
            seed = seed * 1664525u + 1013904223u;
            b.shown.rgb[i] = (uint8_t)(wild ? seed >> 31 ? 255 : 0 : seed >> 24);
        }
        show_painted(&b);
        CHECK(record.count > 0 && record.count <= (wild ? 120 : 57), "%u", record.count);
    }
    close_bench(&b);
}

static void nova_patience(void) {
    bench b;
    fail f = {""};
    test("nova: feature reports that are refused are sent again, ten times at most");
    open_bench(&b, &model_nova);
    fake_bus.refuse_features = 3;
    show(&b, 5);
    CHECK(model_shows_pattern(b.model, 5, 1) == 5, "after three refusals");
    fake_bus.refuse_features = 1000;
    CHECK(b.display.by->show(&b.display, &b.shown, &f) == DISPLAY_GONE, "gone after ten each");
    CHECK(fake_bus.refuse_features == 980, "both windows: %u", 1000 - fake_bus.refuse_features);
    fake_bus.refuse_features = 0;
    test("nova: what is not acknowledged counts as delivered, and the right half comes, too");
    fake_bus.late_ms = 200;
    show(&b, 6);
    CHECK(model_shows_pattern(b.model, 6, 1) == 6, "half a picture");
    test("nova: ... but not once it is unplugged");
    fake_bus.unplug_after = 1;
    CHECK(b.display.by->show(&b.display, &b.shown, &f) == DISPLAY_GONE, "delivered to nobody");
    close_bench(&b);
}

static void half_grey(void) {
    bench b;
    test("nova: half grey lights half of the pixels, and of every 8x8 square about half");
    open_bench(&b, &model_nova);
    memset(b.shown.rgb, 128, 3 * 128 * 64);
    show_painted(&b);
    unsigned all = 0;
    for (unsigned square = 0; square < 128; square++) {
        unsigned lit = 0;
        for (unsigned i = 0; i < 64; i++) {
            const unsigned x = square % 16 * 8 + i % 8, y = square / 16 * 8 + i / 8;
            lit += b.model->rgb[3 * (y * 128 + x)] != 0;
        }
        CHECK(lit >= 29 && lit <= 35, "%u of 64 in square %u", lit, square);
        all += lit;
    }
    CHECK(all == 8 * 515, "%u of 8192", all); /* as many of 1024 thresholds are below 128 */
    close_bench(&b);
}

static void release(const model_kind *kind) {
    bench b;
    fail f = {""};
    char sentence[120];
    snprintf(sentence, sizeof sentence, "%s: the display gets its own picture back", kind->name);
    test(sentence);
    open_bench(&b, kind);
    CHECK(b.display.by->release(&b.display, &f) == DISPLAY_OK, "%s", f.text);
    CHECK(b.model->releases == 1, "%u", b.model->releases);
    close_bench(&b);
}

static void unplugged(const model_kind *kind) {
    bench b;
    fail f = {""};
    char sentence[120];
    snprintf(sentence, sizeof sentence, "%s: unplugged before any report it says so", kind->name);
    test(sentence);
    for (unsigned after = 1; after < 3; after++) {
        open_bench(&b, kind);
        fake_bus.unplug_after = after;
        int status = DISPLAY_OK;
        for (unsigned n = 0; n < 3 && status == DISPLAY_OK; n++) {
            pattern_fill(n, b.shown.width, b.shown.height, b.shown.rgb);
            status = b.display.by->show(&b.display, &b.shown, &f);
        }
        CHECK(status == DISPLAY_GONE, "%d after %u reports", status, after);
        CHECK(f.text[0] == '\0', "no sentence: it may come back");
        close_bench(&b);
    }
}

int main(void) {
    static const model_kind *const kinds[] = {
        &model_mini,      &model_original, &model_nova,    &model_nova_elite, &model_apex,
        &model_apex_2023, &model_logitech, &model_picolcd, &model_nexus,      &model_corsair_lcd};
    for (unsigned i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        every_pixel(kinds[i]);
        unplugged(kinds[i]);
    }
    mini_bytes();
    nexus_bytes();
    oled_bytes();
    apex_bytes();
    logitech_bytes();
    picolcd_bytes();
    original_bytes();
    original_keys();
    corsair_bytes();
    nova_patience();
    half_grey();
    brightness(&model_mini, 70, 70);
    brightness(&model_original, 70, 70);
    brightness(&model_nexus, 0, 0);
    brightness(&model_nova, 0, 1);
    brightness(&model_nova, 55, 6);
    brightness(&model_nova_elite, 55, 6);
    brightness(&model_picolcd, 100, 255);
    brightness(&model_picolcd, 50, 128);
    release(&model_mini);
    release(&model_original);
    release(&model_nova);
    release(&model_nova_elite);
    release(&model_nexus);
    return test_done();
}
