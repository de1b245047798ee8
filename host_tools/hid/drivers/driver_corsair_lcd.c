/* driver_corsair_lcd - Corsair's round panels of 480x480 on pumps and pump caps
 *
 * A picture is one JPEG file, in output reports of 1024 bytes:
 *
 *     0  02 05 40    report number, command
 *     3  last        1 in the last report: the panel then changes
 *     4  part        u16, 0, 1, ...
 *     6  length      u16, bytes of the file in this report: 1016 but in the last
 *     8  the file, zeros after its end
 *
 * Numbers are little-endian. A file has the best quality, 95 at most, with
 * which it takes a quarter of a byte per pixel, 57 reports, with a chroma
 * sample for 2x2 pixels, as the files have that other programs send. A picture
 * like the last is not sent again.
 *
 * Sources: HydroScreen (UDPSendToFailed); OpenLinkHub (N. Jurkovic), and its
 * lists of devices; NautiBoy, run with a Nautilus cap, facts only. Not run on
 * hardware by us.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/picture/jpeg.h"

enum {
    SIDE = 480,
    PIXELS = SIDE * SIDE,
    FILE_BUDGET = PIXELS / 4,
    REPORT_BYTES = 1024,
    HEAD_BYTES = 8,
    PART_BYTES = REPORT_BYTES - HEAD_BYTES,
    QUALITY_MOST = 95
};

typedef struct corsair_lcd {
    uint8_t shown[3 * PIXELS];
    int known; /* `shown` is on the panel */
    uint8_t file[3 * PIXELS / 2];
} corsair_lcd;

/* With the lowest quality steps are 255. A block's samples have energy for 64 coefficients of 1 or
 * -1, from half a step on, 3 bits each; a 2, from 1.5 steps on, takes the energy of nine. However
 * wild the picture is, its file has room. */
static size_t jpeg_of(corsair_lcd *l, const picture *p) {
    unsigned quality;
    const size_t bytes =
        jpeg_fit(p, JPEG_420, JPEG_QUALITY_LEAST, QUALITY_MOST, &quality, l->file, FILE_BUDGET);
    return bytes <= FILE_BUDGET
               ? bytes
               : jpeg_write(p, JPEG_420, JPEG_QUALITY_LEAST, l->file, sizeof l->file);
}

static int send_part(display *d, unsigned part, size_t file_bytes) {
    const corsair_lcd *l = d->state;
    const size_t at = (size_t)part * PART_BYTES, left = file_bytes - at;
    const size_t bytes = left < PART_BYTES ? left : PART_BYTES;
    uint8_t report[REPORT_BYTES] = {2,
                                    5,
                                    0x40,
                                    left <= PART_BYTES,
                                    (uint8_t)part,
                                    (uint8_t)(part >> 8),
                                    (uint8_t)bytes,
                                    (uint8_t)(bytes >> 8)};
    memcpy(report + HEAD_BYTES, l->file + at, bytes);
    return port_output(d->port, report, sizeof report);
}

static int corsair_lcd_show(display *d, const picture *p, fail *f) {
    corsair_lcd *l = d->state;
    (void)f;
    if (l->known && memcmp(l->shown, p->rgb, sizeof l->shown) == 0) {
        return DISPLAY_OK;
    }
    l->known = 0;
    const size_t bytes = jpeg_of(l, p);
    for (unsigned part = 0; (size_t)part * PART_BYTES < bytes; part++) {
        const int status = send_part(d, part, bytes);
        if (status != PORT_OK || display_is_stopped(d)) {
            return status != PORT_OK ? display_status(status) : DISPLAY_STOPPED;
        }
    }
    memcpy(l->shown, p->rgb, sizeof l->shown);
    l->known = 1;
    return DISPLAY_OK;
}

static void corsair_lcd_forget(display *d, unsigned piece) {
    corsair_lcd *l = d->state;
    (void)piece; /* there is one */
    l->known = 0;
}

static int corsair_lcd_open(display *d, fail *f) {
    d->width = SIDE;
    d->height = SIDE;
    d->pieces = 1;
    d->state = calloc(1, sizeof(corsair_lcd));
    return d->state == NULL ? fail_set(f, NULL, "out of memory; close other programs") : 0;
}

static void corsair_lcd_close(display *d) {
    free(d->state);
    d->state = NULL;
}

static const driver_id ids[] = {
    {0x1B1C, 0x0C33, 0}, {0x1B1C, 0x0C39, 0}, {0x1B1C, 0x0C42, 0}, {0x1B1C, 0x0C43, 0},
    {0x1B1C, 0x0C4E, 0}, {0x1B1C, 0x0C55, 0}, {0x1B1C, 0x0C57, 0}, {0, 0, 0}};

const driver driver_corsair_lcd = {.name = "corsair-lcd",
                                   .about = "Corsair LCD of coolers and pumps, 480x480",
                                   .ids = ids,
                                   .from_notes = 1,
                                   .open = corsair_lcd_open,
                                   .show = corsair_lcd_show,
                                   .forget = corsair_lcd_forget,
                                   .close = corsair_lcd_close};
