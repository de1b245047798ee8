/* test_wire_trace - the trace in platform/WIRE.md is what the code does
 *
 * A tiny session, every report of it explained. With --print it goes to
 * standard output, to be put into WIRE.md between the lines ```trace and ```.
 *
 * SPDX-License-Identifier: MIT */
#include <stdarg.h>
#include <stdlib.h>

#include "platform/wire/base.h"
#include "tests/reference/random.h"
#include "tests/test.h"

static char text[16384];
static size_t used;

__attribute__((format(printf, 1, 2))) static void put(const char *format, ...) {
    va_list list;
    va_start(list, format);
    used += (size_t)vsnprintf(text + used, sizeof text - used, format, list);
    va_end(list);
}

static void put_bytes(const uint8_t *at, size_t count) {
    for (size_t i = 0; i < count; i++) {
        put("%02X%s", at[i], i + 1 < count ? " " : "");
    }
}

static const char *name_of(unsigned type) {
    static const char *const control[] = {"HELLO",      "WELCOME",   "ACK",         "PING",
                                          "FRAME_GOOD", "FRAME_BAD", "SCENE_OFFER", "SCENE_STATE",
                                          "VIEW",       "VIEW_HAVE", "BLOCK_ASK",   "BLOCK_REFUSE",
                                          "ERROR",      "SET",       "STATS_ASK",   "STATS"};
    static const char *const data[] = {"PAD", "FRAME_END", "SCENE_DATA", "BLOCK_DATA"};
    static const char *const coder[] = {"TILE raw", "TILE solid", "TILE runs", "TILE predicted"};
    return type >= 0x80   ? coder[type >> 5 & 3]
           : type >= 0x10 ? control[type - 0x10]
                          : data[type & 3];
}

static void explain(const char *who, const uint8_t *report, size_t bytes) {
    const int is_control = report[5] >> 7;
    put("%s  ", who);
    put_bytes(report, 4);
    put("  %02X %02X    checksum, number %u, %s\n", report[4], report[5], report[4],
        is_control ? "control" : "data");
    for (size_t at = 6; at < bytes && report[at] != WIRE_PAD;) {
        const size_t head = report[at] >= 0x80 ? 3 : 2, body = report[at + head - 1];
        put("        ");
        put_bytes(report + at, head);
        put("  ");
        put_bytes(report + at + head, body);
        put("    %s", name_of(report[at]));
        if (report[at] >= 0x80) {
            put(", frame %u, tile %u", report[at] >> 2 & 7u,
                (report[at] & 3u) << 8 | report[at + 1]);
        }
        put("\n");
        at += head + body;
    }
}

enum { WIDTH = 20, HEIGHT = 4, BYTES = 64 };

static void exchange(wire_peer *host, wire_peer *device, uint32_t now) {
    uint8_t report[BYTES];
    size_t n;
    wire_poll(host, now);
    wire_poll(device, now);
    while ((n = wire_next_report(host, report, now)) > 0) {
        explain("host  ", report, n);
        wire_on_report(device, report, n, now);
    }
    while ((n = wire_next_report(device, report, now)) > 0) {
        explain("device", report, n);
        wire_on_report(host, report, n, now);
    }
}

static void session(void) {
    const wire_setup hs = {.role = WIRE_HOST,
                           .caps = {.session = 1,
                                    .in_bytes = BYTES,
                                    .out_bytes = BYTES,
                                    .credits = 16,
                                    .features = WIRE_SENDS}};
    const wire_setup ds = {.role = WIRE_DEVICE,
                           .caps = {.session = 2,
                                    .width = WIDTH,
                                    .height = HEIGHT,
                                    .format = WIRE_GREY8,
                                    .formats = 4,
                                    .in_bytes = BYTES,
                                    .out_bytes = BYTES,
                                    .credits = 8,
                                    .features = WIRE_SHOWS}};
    static uint8_t pixels[HEIGHT][WIDTH], rgb[HEIGHT][3 * WIDTH];
    const wire_panel panel = {&pixels[0][0], WIDTH, NULL, NULL};
    static wire_frames_out out;
    static wire_frames_in in;
    wire_peer host, device;
    wire_peer_open(&host, &hs, 0);
    wire_peer_open(&device, &ds, 0);
    wire_frames_out_open(&out, &host);
    wire_frames_in_open(&in, &device, &panel);
    for (uint32_t now = 1; now < 4; now++) {
        exchange(&host, &device, now);
    }
    for (unsigned y = 0; y < HEIGHT; y++) {
        for (unsigned x = 0; x < WIDTH; x++) {
            rgb[y][3 * x] = rgb[y][3 * x + 1] = rgb[y][3 * x + 2] =
                (uint8_t)(x >= 16 ? 0x60 : 10 * y + x);
        }
    }
    wire_frames_show(&out, &rgb[0][0], 3 * WIDTH);
    for (uint32_t now = 4; now < 8; now++) {
        exchange(&host, &device, now);
    }
    test("the tiny session ends with the picture on the panel");
    CHECK(wire_frames_out_done(&out), "not done");
    for (unsigned y = 0; y < HEIGHT; y++) {
        for (unsigned x = 0; x < WIDTH; x++) {
            CHECK(pixels[y][x] == rgb[y][3 * x], "pixel %u, %u", x, y);
        }
    }
}

int main(int count, char **words) {
    static char page[1 << 17];
    session();
    if (count > 1 && strcmp(words[1], "--print") == 0) {
        fputs(text, stdout);
        return 0;
    }
    test("its trace is the one in platform/WIRE.md");
    FILE *file = fopen("platform/WIRE.md", "rb");
    CHECK(file != NULL, "no such file: run the test at the top of the repository");
    if (file != NULL) {
        page[fread(page, 1, sizeof page - 1, file)] = '\0';
        fclose(file);
        const char *at = strstr(page, "```trace\n");
        CHECK(at != NULL && strncmp(at + 9, text, used) == 0 &&
                  strncmp(at + 9 + used, "```", 3) == 0,
              "it is not; run this program with --print");
    }
    return test_done();
}
