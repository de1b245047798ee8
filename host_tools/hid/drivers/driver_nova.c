/* driver_nova - SteelSeries Arctis Nova Pro, Elite and Omni: the OLED of the base station
 *
 * 128x64 pixels of one bit, sent as two windows of 64x64, each one feature
 * report of 1024 bytes:
 *
 *     0  06 93       report number, command; 01 for 06 with an Elite or Omni
 *     2  x y w h     the window
 *     6  w columns of h / 8 bytes from left to right, lowest bit on top; dithered
 *
 * The device refuses a feature report now and then; it is then sent again,
 * up to ten times, after 1, 4, 9 ... ms. Both windows are sent, whatever
 * becomes of the first. Brightness (1 .. 10) and the return to the device's own
 * picture are output reports of 64 bytes.
 *
 * Source: ggoled (JerwuQu); what it says of the Elite is from a pull request
 * by an owner (macrooli); of the Omni only the list of interfaces is known. Facts
 * only. Not run on hardware.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/retry.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/picture/dither.h"

enum {
    WIDTH = 128,
    HEIGHT = 64,
    WINDOW = 64,
    FEATURE_BYTES = 1024,
    OUTPUT_BYTES = 64,
    NUMBER = 6,
    NUMBER_ELITE = 1,
    DRAW = 0x93,
    BRIGHTNESS = 0x85,
    RETURN = 0x95,
    TRIES = 10
};

static const double LONGEST = 5.0; /* seconds that tries may begin in */

static int send_feature(display *d, const uint8_t *report) {
    retry tries;
    int status = PORT_GONE;
    retry_begin(&tries, LONGEST, NULL);
    while (status != PORT_OK && tries.tries < TRIES &&
           retry_next(&tries, 1e-3 * (tries.tries * tries.tries)) == RETRY_AGAIN) {
        status = port_feature(d->port, report, FEATURE_BYTES);
        tries.stop = d->stop; /* not before: a signal between two windows would leave half */
    }
    return status;
}

static uint8_t number_of(const display *d) {
    return d->by == &driver_nova_elite ? NUMBER_ELITE : NUMBER;
}

static int send_window(display *d, const picture *p, unsigned left) {
    uint8_t report[FEATURE_BYTES] = {number_of(d), DRAW, (uint8_t)left, 0, WINDOW, HEIGHT};
    for (unsigned i = 0; i < WINDOW * HEIGHT; i++) {
        const unsigned x = left + i / HEIGHT, y = i % HEIGHT;
        if (dither_is_lit(p->rgb + 3 * (y * WIDTH + x), x, y)) {
            report[6 + i / 8] |= (uint8_t)(1 << i % 8);
        }
    }
    return send_feature(d, report);
}

static int nova_show(display *d, const picture *p, fail *f) {
    int status = PORT_OK;
    (void)f;
    for (unsigned left = 0; left < WIDTH; left += WINDOW) {
        const int sent = send_window(d, p, left);
        status = sent != PORT_OK ? sent : status;
    }
    return display_status(status);
}

static int send_output(display *d, uint8_t command, uint8_t value) {
    const uint8_t report[OUTPUT_BYTES] = {number_of(d), command, value};
    return display_status(port_output(d->port, report, sizeof report));
}

static int nova_brightness(display *d, unsigned percent, fail *f) {
    const unsigned level = (percent + 5) / 10;
    (void)f;
    return send_output(d, BRIGHTNESS, (uint8_t)(level < 1 ? 1 : level));
}

static int nova_release(display *d, fail *f) {
    (void)f;
    return send_output(d, RETURN, 0);
}

static int nova_open(display *d, fail *f) {
    (void)f;
    d->width = WIDTH;
    d->height = HEIGHT;
    return DISPLAY_OK;
}

static const driver_id ids[] = {{0x1038, 0x12CB, 4},
                                {0x1038, 0x12CD, 4},
                                {0x1038, 0x12E0, 4},
                                {0x1038, 0x12E5, 4},
                                {0x1038, 0x12FA, 4},
                                {0x1038, 0x225D, 4},
                                {0, 0, 0}};
static const driver_id ids_elite[] = {{0x1038, 0x2244, 3}, {0x1038, 0x2290, 3}, {0, 0, 0}};

#define NOVA(of_name, of_about, of_ids)                                                            \
    {                                                                                              \
        .name = of_name, .about = of_about, .ids = of_ids, .from_notes = 1, .open = nova_open,     \
        .show = nova_show, .brightness = nova_brightness, .release = nova_release                  \
    }

const driver driver_nova =
    NOVA("nova", "SteelSeries Arctis Nova Pro base station, 128x64, 1 bit", ids);
const driver driver_nova_elite = NOVA(
    "nova-elite", "SteelSeries Arctis Nova Elite and Omni base station, 128x64, 1 bit", ids_elite);
