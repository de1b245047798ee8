/* y4m - uncompressed video that every encoder reads from a pipe
 *
 * BT.601. 4:2:0 is what encoders make files of that browsers play: chroma of half the
 * width and height, rounded up, each sample the mean of the 2 x 2 pixels around it (at an
 * odd edge, of those there are). That is the siting of JPEG and MPEG-1, which C420jpeg
 * says, and the range is limited (Y 16 to 235, C 16 to 240), which all assume who do not
 * read the XCOLORRANGE behind it. With R, G and B from 0 to 255, in units of 2^-16:
 *
 *     Y  =  16 + 0.256788 R + 0.504129 G + 0.097906 B
 *     Cb = 128 - 0.148223 R - 0.290993 G + 0.439216 B
 *     Cr = 128 + 0.439216 R - 0.367788 G - 0.071427 B
 *
 * 4:4:4 keeps every pixel's colour, in full range as in JFIF:
 *
 *     Y  =       0.299    R + 0.587    G + 0.114    B
 *     Cb = 128 - 0.168736 R - 0.331264 G + 0.5      B
 *     Cr = 128 + 0.5      R - 0.418688 G - 0.081312 B
 *
 * All are rounded to nearest, once. Chroma rows of integers add up to exactly 0: grey
 * stays grey. A Y4M cannot say its matrix; where it matters, tell the encoder
 * (ffmpeg: -colorspace smpte170m).
 *
 * Sources: ITU-R BT.601-7, 2011; E. Hamilton, "JPEG File Interchange
 * Format", 1992; yuv4mpeg(5), MJPEG tools.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/formats.h"

enum { ONE = 65536 /* 2^16 */ };

typedef struct plane {
    int red, green, blue, offset;
    unsigned side; /* of the square of pixels that a sample is the mean of */
} plane;

static const plane full[3] = {
    {19595, 38470, 7471, 0, 1},
    {-11058, -21710, 32768, 128, 1},
    {32768, -27439, -5329, 128, 1},
};
static const plane limited[3] = {
    {16829, 33039, 6416, 16, 1},
    {-9714, -19070, 28784, 128, 2},
    {28784, -24103, -4681, 128, 2},
};

int y4m_begin(output *o, y4m_chroma chroma, unsigned width, unsigned height,
              unsigned frames_per_second, fail *f) {
    return output_print(
        o, f, "YUV4MPEG2 W%u H%u F%u:1 Ip A1:1 %s\n", width, height, frames_per_second,
        chroma == Y4M_444 ? "C444 XCOLORRANGE=FULL" : "C420jpeg XCOLORRANGE=LIMITED");
}

/* The mean of the pixels from (x, y) to before (right, below): at most four. */
static uint8_t sample(const plane *k, const picture *p, unsigned x, unsigned y) {
    const unsigned right = x + k->side < p->width ? x + k->side : p->width;
    const unsigned below = y + k->side < p->height ? y + k->side : p->height;
    const int pixels = (int)((right - x) * (below - y));
    int sum = pixels * (k->offset * ONE + ONE / 2); /* with the half of rounding */
    for (unsigned j = y; j < below; j++) {
        const uint8_t *rgb = p->rgb + 3 * ((size_t)j * p->width + x);
        for (unsigned i = x; i < right; i++, rgb += 3) {
            sum += k->red * rgb[0] + k->green * rgb[1] + k->blue * rgb[2];
        }
    }
    /* One, two or four pixels; the sum is positive, as no sample is below 0. */
    const int value = sum >> (16 + (pixels > 1) + (pixels > 2));
    return (uint8_t)(value > 255 ? 255 : value);
}

static int write_plane(output *o, const picture *p, const plane *k, fail *f) {
    uint8_t row[PICTURE_SIDE_MAX];
    for (unsigned y = 0; y < p->height; y += k->side) {
        size_t held = 0;
        for (unsigned x = 0; x < p->width; x += k->side) {
            row[held++] = sample(k, p, x, y);
        }
        if (output_write(o, row, held, f)) {
            return -1;
        }
    }
    return 0;
}

int y4m_frame(output *o, y4m_chroma chroma, const picture *p, fail *f) {
    if (output_print(o, f, "FRAME\n")) {
        return -1;
    }
    for (unsigned k = 0; k < 3; k++) {
        if (write_plane(o, p, chroma == Y4M_444 ? &full[k] : &limited[k], f)) {
            return -1;
        }
    }
    return 0;
}
