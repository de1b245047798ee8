/* model_planelet - a display with Planelet's wire, as a firmware would be
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/base/clock.h"
#include "platform/wire/wire.h"
#include "tests/hid/model.h"

enum { WINDOW = 16 };

typedef struct own {
    wire_peer peer;
    wire_frames_in in;
    wire_keys_out keys;
    uint32_t shown;
    uint8_t pixels[]; /* of a panel that can be read, in its format */
} own;

static void take_row(void *context, unsigned x, unsigned y, unsigned width, const uint8_t *pixels) {
    model *m = context;
    wire_row_to_rgb(m->rgb + 3 * ((size_t)y * m->width + x), m->format, pixels, width);
}

/* A panel that is read keeps its format; m->rgb follows frame by frame. */
static void copy_panel(model *m) {
    const own *o = m->state;
    const uint32_t stride = wire_row_bytes(m->format, m->width);
    for (unsigned y = 0; y < m->height; y++) {
        wire_row_to_rgb(m->rgb + 3 * (size_t)y * m->width, m->format, o->pixels + y * stride,
                        m->width);
    }
}

static int own_open(model *m) {
    const uint32_t stride = wire_row_bytes(m->format, m->width);
    own *o = calloc(1, sizeof *o + (m->reads ? (size_t)stride * m->height : 0));
    m->state = o;
    if (o == NULL) {
        return -1;
    }
    const wire_setup setup = {
        .role = WIRE_DEVICE,
        .caps = {.session = clock_ms() * 2654435761u,
                 .width = (uint16_t)m->width,
                 .height = (uint16_t)m->height,
                 .formats = (uint16_t)(1u << m->format),
                 .format = (uint8_t)m->format,
                 .in_bytes = (uint16_t)m->report_bytes,
                 .out_bytes = (uint16_t)m->in_bytes,
                 .features = (uint8_t)(WIRE_SHOWS | WIRE_BRIGHTNESS | (m->reads ? WIRE_READS : 0)),
                 .credits = WINDOW}};
    const wire_panel panel = {.pixels = m->reads ? o->pixels : NULL,
                              .stride = stride,
                              .row = m->reads ? NULL : take_row,
                              .context = m};
    if (wire_peer_open(&o->peer, &setup, clock_ms()) != WIRE_OK ||
        wire_frames_in_open(&o->in, &o->peer, &panel) != WIRE_OK) {
        return -1;
    }
    if (m->has_keys) {
        wire_keys_out_open(&o->keys, &o->peer);
    }
    return 0;
}

static void own_key(model *m, unsigned key, int is_down) {
    own *o = m->state;
    if (m->has_keys) {
        wire_key_set(&o->keys, key, is_down);
    }
}

static void own_output(model *m, const uint8_t *report, size_t bytes) {
    own *o = m->state;
    unsigned percent = 0;
    wire_on_report(&o->peer, report, bytes, clock_ms());
    if (wire_setting_read(&o->peer, &percent) == WIRE_SET_BRIGHTNESS) {
        m->brightness = (int)percent;
    }
    if (wire_frames_shown(&o->in) != o->shown) {
        o->shown = wire_frames_shown(&o->in);
        m->changes++;
        if (m->reads && m->changed != NULL) {
            copy_panel(m);
        }
        if (m->changed != NULL) {
            m->changed(m->context, m);
        }
    }
}

static size_t own_input(model *m, uint8_t *report, size_t room) {
    own *o = m->state;
    wire_poll(&o->peer, clock_ms());
    return room < m->in_bytes ? 0 : wire_next_report(&o->peer, report, clock_ms());
}

const model_kind model_planelet = {.name = "planelet",
                                   .vendor = 0x1209,
                                   .id = 0x0001,
                                   .input_bytes = 64,
                                   .open = own_open,
                                   .output = own_output,
                                   .input = own_input,
                                   .key = own_key};
