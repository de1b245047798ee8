/* model_picolcd - a picoLCD 256x64: four controllers with a page and a column each, of commands and
 * data
 *
 * A controller knows commands (start at row, page, column, on) and data, which go to the column
 * and on to the next.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/hid/model.h"

typedef struct chip {
    unsigned page, column, is_on;
} chip;

static int picolcd_open(model *m) {
    m->state = calloc(4, sizeof(chip));
    return m->state == NULL ? -1 : 0;
}

static void command(model *m, chip *c, uint8_t value) {
    if (value >= 0xB8 && value <= 0xBF) {
        c->page = value & 7u;
    } else if (value >= 0x40 && value <= 0x7F) {
        c->column = value & 63u;
    } else if (value == 0x3F || value == 0x3E) {
        c->is_on = value & 1u;
    } else if (value != 0xC0) {
        model_breach(m, "an unknown command of a controller");
    }
}

static void data(model *m, unsigned which, const uint8_t *columns, unsigned count) {
    chip *c = (chip *)m->state + which;
    if (count > 32 || c->column + count > 64 || !c->is_on) {
        model_breach(m, "columns beyond a controller's, or it is not on");
        return;
    }
    for (unsigned i = 0; i < 8 * count; i++) {
        const unsigned x = 64 * which + c->column + i / 8, y = 8 * c->page + i % 8;
        memset(m->rgb + 3 * (y * 256 + x), columns[i / 8] >> i % 8 & 1 ? 255 : 0, 3);
    }
    c->column += count;
    m->changes += c->column == 64;
    if (c->column == 64 && m->changed != NULL) {
        m->changed(m->context, m);
    }
}

static void picolcd_output(model *m, const uint8_t *r, size_t bytes) {
    const unsigned which = r[1] >> 2;
    chip *c = (chip *)m->state + (which & 3);
    if (bytes == 2 && r[0] == 0x91) {
        m->brightness = r[1];
        return;
    }
    if (bytes != 64 || which > 3) {
        model_breach(m, "not a report of 64 bytes for one of four controllers");
    } else if (r[0] == 0x94 && r[2] == 2 && r[3] == 0 && r[4] == 0x64 && r[6] == 0 &&
               r[7] == 0x64) {
        command(m, c, r[5]);
        command(m, c, r[8]);
    } else if (r[0] == 0x96 && r[2] == 2 && r[3] == 0 && r[4] == 0 && r[6] == 0 && r[7] == 0 &&
               r[9] == 0 && r[10] == 0) {
        command(m, c, r[5]);
        command(m, c, r[8]);
        data(m, which, r + 12, r[11]);
    } else if (r[0] == 0x95 && (r[1] & 3) == 1 && r[2] == 0 && r[3] == 0) {
        data(m, which, r + 5, r[4]);
    } else {
        model_breach(m, "an unknown report");
    }
}

const model_kind model_picolcd = {.name = "picolcd",
                                  .vendor = 0x04D8,
                                  .id = 0xC002,
                                  .width = 256,
                                  .height = 64,
                                  .bits = 1,
                                  .output_number = 0x96,
                                  .input_number = 0x11,
                                  .output_bytes = 63,
                                  .input_bytes = 2,
                                  .open = picolcd_open,
                                  .output = picolcd_output};
