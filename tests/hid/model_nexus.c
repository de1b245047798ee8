/* model_nexus - a Corsair iCUE Nexus: blocks in order, the last one shows them
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/hid/model.h"

enum { WIDTH = 640, HEIGHT = 48, BLOCKS = 121 };

typedef struct nexus {
    uint8_t bgrx[4 * WIDTH * HEIGHT];
    unsigned next; /* block */
} nexus;

static int nexus_open(model *m) {
    m->state = calloc(1, sizeof(nexus));
    return m->state == NULL ? -1 : 0;
}

static void nexus_show(model *m) {
    const nexus *n = m->state;
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++) {
        m->rgb[3 * i] = n->bgrx[4 * i + 2];
        m->rgb[3 * i + 1] = n->bgrx[4 * i + 1];
        m->rgb[3 * i + 2] = n->bgrx[4 * i];
    }
    m->changes++;
    if (m->changed != NULL) {
        m->changed(m->context, m);
    }
}

static void nexus_output(model *m, const uint8_t *r, size_t bytes) {
    nexus *n = m->state;
    if (bytes != 1024 || r[0] != 2 || r[1] != 5 || r[2] != 0x40) {
        model_breach(m, "not an image report of 1024 bytes");
        return;
    }
    const unsigned block = r[4] | (unsigned)r[5] << 8, length = r[6] | (unsigned)r[7] << 8;
    const unsigned last = block == BLOCKS - 1;
    n->next = block == 0 ? 0 : n->next; /* a new frame may begin at any time */
    if (block != n->next || length != (last ? 960u : 1016u) || r[3] != last) {
        model_breach(m, "block out of order, or its length or last flag is wrong");
        return;
    }
    memcpy(n->bgrx + 1016 * (size_t)block, r + 8, length);
    n->next++;
    if (last) {
        nexus_show(m);
    }
}

static void nexus_feature(model *m, const uint8_t *r, size_t bytes) {
    if (bytes == 32 && r[0] == 3 && r[1] == 1 && r[2] <= 100) {
        m->brightness = r[2];
    } else if (bytes == 32 && r[0] == 3 && r[1] == 0x0D && r[2] == 1 && r[3] == 1) {
        m->releases++;
    } else {
        model_breach(m, "a feature report that is neither brightness nor return");
    }
}

const model_kind model_nexus = {.name = "nexus",
                                .vendor = 0x1B1C,
                                .id = 0x1B8E,
                                .width = WIDTH,
                                .height = HEIGHT,
                                .bits = 6,
                                .output_number = 2,
                                .feature_number = 3,
                                .input_number = 1,
                                .output_bytes = 1023,
                                .feature_bytes = 31,
                                .input_bytes = 63,
                                .open = nexus_open,
                                .output = nexus_output,
                                .feature = nexus_feature};
