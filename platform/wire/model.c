/* model - see model.h
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/wire/model.h"

/* How likely a 0 is in a new tile, in 1/256: measured over frames of the
 * scenes that planelet makes and of others like them. In the order of the
 * chances: same; first, class by class; exact; second; third. */
enum { START_COARSE, START_NEAR, START_FINE, STARTS };

static const uint8_t start_chance[STARTS][MODEL_CHANCES] = {
    /* 4 to 6 bits per sample, exact */
    {239, 203, 187, 175, 174, 156, 134, 110, 86,  95,  72,  59,  53,  53,  56,  27,  95,  91,  37,
     43,  31,  36,  24,  10,  128, 215, 119, 128, 128, 142, 124, 145, 158, 206, 171, 181, 147, 136,
     115, 200, 42,  145, 162, 144, 162, 216, 195, 175, 112, 144, 118, 204, 42,  164, 156, 201, 187,
     217, 164, 188, 127, 151, 130, 198, 57,  104, 146, 161, 188, 229, 170, 174, 76,  140, 134, 198,
     72,  64,  102, 149, 169, 219, 147, 178, 220, 129, 103, 236, 100, 106, 82,  128, 139, 128, 128,
     229, 223, 233, 246, 224, 196, 195, 144, 128, 125, 59,  154, 222, 209, 238, 249, 224, 183, 196},
    /* steps of several */
    {235, 196, 161, 159, 153, 144, 115, 81,  81,  85,  71,  58,  56,  49,  51,  26,  101, 90,  44,
     42,  37,  37,  26,  12,  149, 198, 113, 202, 42,  175, 198, 213, 236, 254, 184, 194, 114, 154,
     123, 208, 44,  160, 185, 223, 248, 254, 184, 196, 88,  136, 132, 202, 60,  108, 172, 210, 232,
     254, 160, 195, 126, 127, 132, 207, 63,  112, 147, 208, 242, 254, 153, 185, 57,  127, 152, 219,
     56,  44,  75,  160, 247, 254, 132, 160, 222, 231, 181, 232, 236, 196, 103, 128, 141, 128, 128,
     250, 239, 230, 229, 228, 226, 229, 174, 128, 111, 16,  197, 247, 227, 246, 252, 128, 205, 188},
    /* 8 bits per sample, exact or nearly so */
    {248, 214, 161, 196, 178, 172, 128, 77,  207, 193, 47,  74,  19,  57,  50,  11,  55,
     77,  14,  47,  12,  33,  10,  3,   210, 189, 152, 221, 39,  148, 42,  52,  63,  116,
     155, 164, 84,  114, 121, 169, 77,  70,  82,  133, 142, 153, 143, 167, 52,  86,  126,
     165, 85,  42,  42,  76,  144, 192, 137, 162, 90,  91,  131, 172, 90,  38,  27,  46,
     77,  150, 136, 154, 48,  112, 147, 184, 91,  30,  16,  25,  46,  121, 135, 154, 150,
     83,  78,  200, 87,  81,  76,  128, 136, 128, 128, 221, 61,  36,  182, 222, 232, 134,
     126, 128, 129, 28,  194, 222, 35,  13,  86,  213, 226, 170}};

/* By six pixels around: bits from the left, from above (3), and above those,
 * or what is there. */
static const uint8_t start_mono[64] = {
    204, 56,  231, 75, 243, 123, 237, 107, 254, 235, 221, 155, 230, 25, 247, 173,
    243, 140, 202, 84, 215, 109, 95,  26,  218, 116, 240, 78,  106, 16, 199, 182,
    20,  23,  144, 22, 112, 14,  104, 9,   226, 161, 115, 67,  73,  6,  73,  17,
    11,  13,  154, 9,  84,  18,  15,  2,   81,  34,  67,  5,   19,  6,  89,  21};

/* From so many steps on, 8-bit samples behave like those of 6 bits. */
enum { MANY_STEPS = 9 };

static const uint8_t *start_of(const wire_model *m) {
    if (m->format == WIRE_MONO1) {
        return start_mono;
    }
    const int is_fine = wire_sample_most(m->format, 0) == 255;
    const int is_near = m->step >= (is_fine ? MANY_STEPS : 2);
    return start_chance[is_near ? START_NEAR : is_fine ? START_FINE : START_COARSE];
}

void wire_model_start(wire_model *m, wire_tile_shape shape, unsigned flags) {
    memset(m, 0, sizeof *m);
    m->format = shape.format;
    m->width = shape.width;
    m->flags = (uint8_t)flags;
    m->step = (uint8_t)(2 * (flags & MODEL_NEAR) + 1);
    const unsigned chances = m->format == WIRE_MONO1 ? sizeof start_mono : MODEL_CHANCES;
    const uint8_t *start = start_of(m);
    for (unsigned i = 0; i < chances; i++) {
        m->chance[i] = (uint16_t)(start[i] << 8);
    }
    for (unsigned i = 0; i < 3; i++) {
        m->corner.v[i] = (uint8_t)(wire_sample_most(m->format, i) / 2);
    }
}
