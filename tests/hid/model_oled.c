/* model_oled - SteelSeries OLEDs: Arctis Nova in columns, Apex in rows, the Apex of 2023 in pages
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "tests/hid/model.h"

static void light(model *m, unsigned x, unsigned y, unsigned lit) {
    memset(m->rgb + 3 * (y * m->width + x), lit ? 255 : 0, 3);
}

static void report_change(model *m) {
    m->changes++;
    if (m->changed != NULL) {
        m->changed(m->context, m);
    }
}

static void nova_feature(model *m, const uint8_t *r, size_t bytes) {
    if (bytes != 1024 || r[0] != m->kind->feature_number || r[1] != 0x93) {
        model_breach(m, "not a draw report of 1024 bytes");
        return;
    }
    const unsigned x = r[2], y = r[3], w = r[4], h = r[5], rows = (y % 8 + h + 7) / 8;
    if (w == 0 || h == 0 || w > 64 || x + w > m->width || y + h > m->height ||
        6 + w * rows > bytes) {
        model_breach(m, "a window outside the panel, or wider than 64");
        return;
    }
    for (unsigned i = 0; i < w * h; i++) {
        const unsigned column = i / h, row = i % h;
        light(m, x + column, y + row, r[6 + column * rows + row / 8] >> row % 8 & 1);
    }
    report_change(m);
}

static void nova_output(model *m, const uint8_t *r, size_t bytes) {
    if (bytes == 64 && r[0] == m->kind->output_number && r[1] == 0x85 && r[2] >= 1 && r[2] <= 10) {
        m->brightness = r[2];
    } else if (bytes == 64 && r[0] == m->kind->output_number && r[1] == 0x95) {
        m->releases++;
    } else {
        model_breach(m, "an output report that is neither brightness nor return");
    }
}

#define NOVA(of, product, at, number)                                                              \
    {                                                                                              \
        .name = of, .vendor = 0x1038, .id = product, .interface = at, .width = 128, .height = 64,  \
        .bits = 1, .output_number = number, .feature_number = number, .input_number = 7,           \
        .output_bytes = 63, .feature_bytes = 1023, .input_bytes = 63, .output = nova_output,       \
        .feature = nova_feature                                                                    \
    }

const model_kind model_nova = NOVA("nova", 0x12CB, 4, 6);
const model_kind model_nova_elite = NOVA("nova-elite", 0x2244, 3, 1);

static void apex_feature(model *m, const uint8_t *r, size_t bytes) {
    if (bytes != 642 || r[0] != 0x61 || r[641] != 0) {
        model_breach(m, "not a draw report of 642 bytes");
        return;
    }
    for (unsigned i = 0; i < 128 * 40; i++) {
        light(m, i % 128, i / 128, r[1 + i / 8] >> (7 - i % 8) & 1);
    }
    report_change(m);
}

static void apex_2023_feature(model *m, const uint8_t *r, size_t bytes) {
    if (bytes != 644 || r[0] != 0x1F || r[1] != 0x81 || r[642] != 0 || r[643] != 0) {
        model_breach(m, "not a draw report of 644 bytes");
        return;
    }
    for (unsigned i = 0; i < 128 * 40; i++) {
        light(m, i % 128, i / 128, r[2 + i / 1024 * 128 + i % 128] >> i / 128 % 8 & 1);
    }
    report_change(m);
}

static void apex_output(model *m, const uint8_t *r, size_t bytes) {
    (void)r;
    (void)bytes;
    model_breach(m, "an output report");
}

/* Reports have no numbers. */
#define APEX(of, product, size, draw)                                                              \
    {                                                                                              \
        .name = of, .vendor = 0x1038, .id = product, .interface = 1, .width = 128, .height = 40,   \
        .bits = 1, .output_bytes = 64, .feature_bytes = size, .input_bytes = 64,                   \
        .output = apex_output, .feature = draw                                                     \
    }

const model_kind model_apex = APEX("apex", 0x1618, 642, apex_feature);
const model_kind model_apex_2023 = APEX("apex-2023", 0x1628, 644, apex_2023_feature);
