/* panel - a Planelet display as a program in WebAssembly: what a fake device of WebHID has in it
 *
 * 96x64 pixels of RGB888, reports of 64 bytes, keys.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/web/exports.h"
#include "platform/wire/wire.h"

enum { WIDTH = 96, HEIGHT = 64, REPORT = 64, CREDITS = 16 };

WEB_EXPORT(int, panel_open)(uint32_t session, uint32_t now_ms);
WEB_EXPORT(uint8_t *, panel_report)(void);
WEB_EXPORT(void, panel_take)(uint32_t bytes, uint32_t now_ms);
WEB_EXPORT(uint32_t, panel_give)(uint32_t now_ms);
WEB_EXPORT(void, panel_key)(unsigned key, int is_down);
WEB_EXPORT(const uint8_t *, panel_pixels)(void);
WEB_EXPORT(uint32_t, panel_shown)(void);

static wire_peer peer;
static wire_frames_in in;
static wire_keys_out keys;
static uint8_t pixels[3 * WIDTH * HEIGHT], report[REPORT];

int panel_open(uint32_t session, uint32_t now_ms) {
    const wire_setup setup = {.role = WIRE_DEVICE,
                              .caps = {.session = session,
                                       .width = WIDTH,
                                       .height = HEIGHT,
                                       .formats = 1u << WIRE_RGB888,
                                       .format = WIRE_RGB888,
                                       .in_bytes = REPORT,
                                       .out_bytes = REPORT,
                                       .features = WIRE_SHOWS | WIRE_READS,
                                       .credits = CREDITS}};
    const wire_panel panel = {.pixels = pixels, .stride = 3 * WIDTH};
    if (wire_peer_open(&peer, &setup, now_ms) != WIRE_OK ||
        wire_frames_in_open(&in, &peer, &panel) != WIRE_OK) {
        return -1;
    }
    wire_keys_out_open(&keys, &peer);
    wire_on_link(&peer, 1, now_ms);
    return 0;
}

uint8_t *panel_report(void) {
    return report;
}

void panel_take(uint32_t bytes, uint32_t now_ms) {
    wire_on_report(&peer, report, bytes, now_ms);
}

uint32_t panel_give(uint32_t now_ms) {
    wire_poll(&peer, now_ms);
    return (uint32_t)wire_next_report(&peer, report, now_ms);
}

void panel_key(unsigned key, int is_down) {
    wire_key_set(&keys, key, is_down);
}

const uint8_t *panel_pixels(void) {
    return pixels;
}

uint32_t panel_shown(void) {
    return wire_frames_shown(&in);
}
