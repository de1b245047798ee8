/* shown - see shown.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/web/shown.h"

#include "host_tools/base/clock.h"
#include "host_tools/hid/device/symbols.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/picture/fit.h"
#include "host_tools/web/port.h"
#include "host_tools/web/viewer.h"
#include "host_tools/web/wire_host.h"

/* Those whose reports a page may send: drivers that wait for their device are for programs. */
static const driver *const of_page[] = {
    &driver_wire_host,     &driver_streamdeck_mini, &driver_streamdeck_original, &driver_streamdeck,
    &driver_streamdeck_xl, &driver_streamdeck_neo,  &driver_streamdeck_plus,     NULL};

static display shown;
static keys_track track;
static picture panel;
static int has_new; /* a frame that the display has not got */
static fail why;

const char *shown_why(void) {
    return why.text;
}

uint32_t shown_device(unsigned index) {
    for (unsigned i = 0; of_page[i] != NULL; i++) {
        for (const driver_id *id = of_page[i]->ids; id->vendor != 0; id++) {
            if (index-- == 0) {
                return (uint32_t)id->vendor << 16 | id->id;
            }
        }
    }
    return 0;
}

int shown_open(unsigned vendor, unsigned id, unsigned out_bytes, unsigned in_bytes) {
    const port_info info = {.vendor = (uint16_t)vendor, .id = (uint16_t)id, .interface = -1};
    const driver *by = driver_for(of_page, &info);
    why.text[0] = '\0';
    if (by == NULL) {
        return fail_set(&why, "display", "no driver is for it; connect another device");
    }
    web_port_begin((report_sizes){out_bytes, in_bytes});
    track = (keys_track){.is_reset = 0};
    has_new = 1;
    return display_open(&shown, by, &info, NULL, &why);
}

const char *shown_name(void) {
    return shown.by != NULL ? shown.by->about : "";
}

unsigned shown_width(void) {
    return shown.port != NULL ? shown.width : 0;
}

unsigned shown_height(void) {
    return shown.port != NULL ? shown.height : 0;
}

uint8_t *shown_room(void) {
    return web_port_room();
}

void shown_came(unsigned bytes) {
    web_port_came(bytes);
}

int shown_tick(void) {
    unsigned count[STEER_ACTIONS];
    int has_turned = 0;
    if (shown.port == NULL) {
        return 0;
    }
    if (display_tick(&shown) != DISPLAY_OK) {
        if (shown.by == &driver_wire_host) {
            why = *wire_host_why();
        }
        return fail_set(&why, "display", "it does not answer; plug it in again and connect it");
    }
    keys_take(&track, &shown.keys, shown.by->keys, clock_seconds(), count);
    for (unsigned action = 0; action < STEER_ACTIONS; action++) {
        for (unsigned i = 0; i < count[action]; i++) {
            viewer_steer(action);
            has_turned = 1;
        }
    }
    return has_turned;
}

int shown_show(void) {
    const picture *frame = viewer_picture();
    has_new |= viewer_is_new();
    if (!has_new || frame->rgb == NULL || frame->width == 0 || shown_width() == 0 ||
        (shown.by == &driver_wire_host && !wire_host_is_idle())) {
        return 0;
    }
    if (picture_resize(&panel, shown.width, shown.height, &why) != 0) {
        return -1;
    }
    fit_picture(frame, &panel, FIT_COVER);
    symbols_draw(&panel, shown.by->keys);
    has_new = 0;
    return shown.by->show(&shown, &panel, &why) == DISPLAY_OK ? 1 : -1;
}

int shown_is_done(void) {
    has_new |= viewer_is_new();
    return !has_new && (shown.by != &driver_wire_host || wire_host_is_done());
}

void shown_close(void) {
    picture_free(&panel);
    display_close(&shown);
}
