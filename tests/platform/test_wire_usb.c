/* test_wire_usb - the glue of platform/PORTING.md, compiled and run
 *
 * A small USB stack with TinyUSB's calls (their names and types as its
 * documentation gives them; nothing of it is copied) carries reports between
 * a host and the firmware of a display written as PORTING.md shows it.
 *
 * SPDX-License-Identifier: MIT */
#include <stdbool.h>
#include <stdlib.h>

#include "platform/wire/wire.h"
#include "tests/test.h"

/* ---- what tusb.h declares ------------------------------------------------------------ */

typedef enum {
    HID_REPORT_TYPE_INVALID,
    HID_REPORT_TYPE_INPUT,
    HID_REPORT_TYPE_OUTPUT
} hid_report_type_t;

bool tud_hid_ready(void);
bool tud_hid_report(uint8_t report_id, const void *report, uint16_t len);
void tud_hid_set_report_cb(uint8_t instance, uint8_t report_id, hid_report_type_t type,
                           const uint8_t *buffer, uint16_t size);
void tud_hid_report_complete_cb(uint8_t instance, const uint8_t *report, uint16_t len);
void tud_mount_cb(void);
void tud_umount_cb(void);
uint32_t board_millis(void);

/* ---- the firmware, as in PORTING.md ------------------------------------------------------ */

static wire_peer peer;
static wire_frames_in frames;
static uint8_t report[64];

static void send_next(void) {
    const size_t n = tud_hid_ready() ? wire_next_report(&peer, report, board_millis()) : 0;
    if (n > 0) {
        tud_hid_report(0, report, (uint16_t)n);
    }
}

void tud_hid_set_report_cb(uint8_t instance, uint8_t report_id, hid_report_type_t type,
                           const uint8_t *buffer, uint16_t size) {
    (void)instance, (void)report_id, (void)type;
    wire_on_report(&peer, buffer, size, board_millis());
}

void tud_hid_report_complete_cb(uint8_t instance, const uint8_t *sent, uint16_t len) {
    (void)instance, (void)sent, (void)len;
    send_next();
}

void tud_mount_cb(void) {
    wire_on_link(&peer, 1, board_millis());
}

void tud_umount_cb(void) {
    wire_on_link(&peer, 0, board_millis());
}

static void main_loop(void) {
    wire_poll(&peer, board_millis());
    send_next();
}

/* ---- the stack and the host ---------------------------------------------------------------- */

enum { WIDTH = 40, HEIGHT = 30 };

static uint32_t now;
static uint8_t in_endpoint[64];
static int in_is_full, is_mounted;
static uint8_t panel[HEIGHT][WIDTH * 2];
static uint32_t rows_outside;

uint32_t board_millis(void) {
    return now;
}

bool tud_hid_ready(void) {
    return is_mounted && !in_is_full;
}

bool tud_hid_report(uint8_t report_id, const void *data, uint16_t len) {
    if (!tud_hid_ready() || report_id != 0 || len != 64) {
        return false;
    }
    memcpy(in_endpoint, data, 64);
    in_is_full = 1;
    return true;
}

/* A window of a display controller. */
static void lcd_row(void *context, unsigned x, unsigned y, unsigned width, const uint8_t *pixels) {
    (void)context;
    if (x + width > WIDTH || y >= HEIGHT) {
        rows_outside++;
        return;
    }
    memcpy(&panel[y][2 * x], pixels, 2 * width);
}

/* A millisecond of the bus: one report in each direction. */
static void bus(wire_peer *host) {
    uint8_t out[64];
    now++;
    if (in_is_full) {
        wire_on_report(host, in_endpoint, 64, now);
        in_is_full = 0;
        tud_hid_report_complete_cb(0, in_endpoint, 64);
    }
    wire_poll(host, now);
    if (is_mounted && wire_next_report(host, out, now) > 0) {
        tud_hid_set_report_cb(0, 0, HID_REPORT_TYPE_OUTPUT, out, 64);
    }
    main_loop();
}

int main(void) {
    const wire_setup device_setup = {.role = WIRE_DEVICE,
                                     .caps = {.session = 11,
                                              .width = WIDTH,
                                              .height = HEIGHT,
                                              .format = WIRE_RGB565,
                                              .in_bytes = 64,
                                              .out_bytes = 64,
                                              .credits = 8,
                                              .features = WIRE_SHOWS}};
    const wire_setup host_setup = {
        .role = WIRE_HOST,
        .caps = {
            .session = 22, .in_bytes = 64, .out_bytes = 64, .credits = 16, .features = WIRE_SENDS}};
    const wire_panel lcd = {.row = lcd_row};
    static wire_frames_out out;
    wire_peer host;
    static uint8_t rgb[HEIGHT][WIDTH * 3], wanted[WIDTH * 2];

    wire_peer_open(&peer, &device_setup, now);
    wire_frames_in_open(&frames, &peer, &lcd);
    wire_peer_open(&host, &host_setup, now);
    wire_frames_out_open(&out, &host);

    test("the glue of PORTING.md shows frames, before and after the cable was out");
    for (int plug = 0; plug < 2; plug++) {
        is_mounted = 1;
        tud_mount_cb();
        wire_on_link(&host, 1, now);
        for (int i = 0; i < 300 && !wire_is_up(&host); i++) {
            bus(&host);
        }
        for (unsigned y = 0; y < HEIGHT; y++) {
            for (unsigned x = 0; x < 3 * WIDTH; x++) {
                rgb[y][x] = (uint8_t)(x * 3 + y * 7 + 40 * (unsigned)plug);
            }
        }
        CHECK(wire_frames_show(&out, &rgb[0][0], 3 * WIDTH) == WIRE_OK, "no session");
        for (int i = 0; i < 3000 && !wire_frames_out_done(&out); i++) {
            bus(&host);
        }
        for (unsigned y = 0; y < HEIGHT; y++) {
            wire_row_from_rgb(wanted, WIRE_RGB565, rgb[y], WIDTH, 0, y);
            CHECK(memcmp(wanted, panel[y], sizeof wanted) == 0, "row %u differs", y);
        }
        is_mounted = in_is_full = 0;
        tud_umount_cb();
        wire_on_link(&host, 0, now);
        CHECK(!wire_is_up(&peer) && rows_outside == 0, "still up");
    }
    return test_done();
}
