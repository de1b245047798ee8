/* y4m - uncompressed video that every encoder reads from a pipe
 *
 * Planes Y, Cb, Cr of full size (4:4:4): odd sizes need no rule.
 * Full range BT.601 as in JFIF, in units of 2^-16, rounded to nearest:
 *
 *     Y  =       0.299    R + 0.587    G + 0.114    B
 *     Cb = 128 - 0.168736 R - 0.331264 G + 0.5      B
 *     Cr = 128 + 0.5      R - 0.418688 G - 0.081312 B
 *
 * Each row of integers adds up to exactly 1 or 0: grey stays grey.
 *
 * Sources: ITU-R BT.601-7, 2011; E. Hamilton, "JPEG File Interchange
 * Format", 1992; yuv4mpeg(5), MJPEG tools.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/formats.h"

#define ONE 65536

static const struct plane {
    int red, green, blue, offset;
} planes[3] = {
    {19595, 38470, 7471, 0},
    {-11058, -21710, 32768, 128},
    {32768, -27439, -5329, 128},
};

int y4m_begin(output *o, unsigned width, unsigned height, unsigned frames_per_second, fail *f) {
    return output_print(o, f, "YUV4MPEG2 W%u H%u F%u:1 Ip A1:1 C444 XCOLORRANGE=FULL\n", width,
                        height, frames_per_second);
}

static uint8_t sample(const struct plane *k, const uint8_t *rgb) {
    const int sum = k->red * rgb[0] + k->green * rgb[1] + k->blue * rgb[2] + k->offset * ONE;
    const int value = (sum + ONE / 2) / ONE; /* sum is 0.5 at least */
    return (uint8_t)(value > 255 ? 255 : value);
}

static int write_plane(output *o, const picture *p, const struct plane *k, fail *f) {
    uint8_t part[4096];
    const size_t pixels = (size_t)p->width * p->height;
    size_t held = 0;
    for (size_t i = 0; i < pixels; i++) {
        part[held++] = sample(k, p->rgb + 3 * i);
        if (held == sizeof part || i + 1 == pixels) {
            if (output_write(o, part, held, f)) {
                return -1;
            }
            held = 0;
        }
    }
    return 0;
}

int y4m_frame(output *o, const picture *p, fail *f) {
    if (output_print(o, f, "FRAME\n")) {
        return -1;
    }
    for (unsigned k = 0; k < 3; k++) {
        if (write_plane(o, p, &planes[k], f)) {
            return -1;
        }
    }
    return 0;
}
