/* model_logitech - a Logitech G13: six bands of eight rows, of which 43 are there
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "tests/hid/model.h"

static void logitech_output(model *m, const uint8_t *r, size_t bytes) {
    if (bytes != 992 || r[0] != 3) {
        model_breach(m, "not a picture of 992 bytes");
        return;
    }
    for (unsigned i = 1; i < 32; i++) {
        if (r[i] != 0) {
            model_breach(m, "a byte before the picture that is not 0");
        }
    }
    for (unsigned i = 0; i < 160 * 48; i++) {
        const unsigned x = i % 160, y = i / 160, lit = r[32 + y / 8 * 160 + x] >> y % 8 & 1;
        if (y < 43) {
            memset(m->rgb + 3 * i, lit ? 255 : 0, 3);
        } else if (lit) {
            model_breach(m, "a pixel below the panel");
        }
    }
    m->changes++;
    if (m->changed != NULL) {
        m->changed(m->context, m);
    }
}

const model_kind model_logitech = {.name = "logitech",
                                   .vendor = 0x046D,
                                   .id = 0xC21C,
                                   .width = 160,
                                   .height = 43,
                                   .bits = 1,
                                   .output_number = 3,
                                   .input_number = 1,
                                   .output_bytes = 991,
                                   .input_bytes = 7,
                                   .output = logitech_output};
