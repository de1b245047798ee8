/* test_sample_patterns [PICTURE.ppm] - how near to many samples some patterns of few come
 *
 * Of a picture whose lines are 8 times as close as those of pixels (planelet render --size, 8 times
 * the frame's; without one, a ball and a box of its own), the mean of each pixel's 64 in linear
 * light is what the pixels of a pattern are compared with: as PSNR in bytes of sRGB. Patterns:
 * PLT_SAMPLES_ONE, FOUR and SIXTEEN; FLIPQUAD, a sample on each border of a pixel, shared by both
 * (Akenine-Moeller and Stroem, "Graphics for the masses", 2003); quincunx, the middle by a half and
 * the four corners. Places are those of the picture's pixels, to a 16th.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "tests/reference/frames.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { CLOSE = 8, ONE, FOUR, FLIPQUAD, QUINCUNX, SIXTEEN, PATTERNS_END };

typedef struct lines {
    unsigned width, height;
    uint8_t *rgb;
} lines;

static double light_of(uint8_t byte) {
    const double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

static double srgb_of(double x) {
    return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055);
}

/* The light at a place, in pixels of the frame. */
static double at(const lines *l, double x, double y, unsigned c) {
    const double column = fmin(fmax(floor(x * CLOSE), 0.0), l->width - 1.0);
    const double row = fmin(fmax(floor(y * CLOSE), 0.0), l->height - 1.0);
    return light_of(l->rgb[3 * ((size_t)row * l->width + (size_t)column) + c]);
}

/* Samples of the rotated square of so many along a side. */
static double rotated(const lines *l, unsigned x, unsigned y, unsigned across, unsigned c) {
    const unsigned n = across * across;
    double sum = 0.0;
    for (unsigned i = 0; i < n; i++) {
        const unsigned column = across * (i % across) + across - 1 - i / across;
        const unsigned row = across * (i / across) + i % across;
        sum += at(l, x + (column + 0.5) / n, y + (row + 0.5) / n, c);
    }
    return sum / n;
}

static double pattern_of(const lines *l, int pattern, unsigned x, unsigned y, unsigned c) {
    const double a = (x + y) % 2 ? 0.75 : 0.25; /* flipped from pixel to pixel */
    switch (pattern) {
    case FLIPQUAD:
        return 0.25 * (at(l, x, y + a, c) + at(l, x + 1, y + 1 - a, c) + at(l, x + 1 - a, y, c) +
                       at(l, x + a, y + 1, c));
    case QUINCUNX:
        return 0.5 * at(l, x + 0.5, y + 0.5, c) +
               0.125 * (at(l, x, y, c) + at(l, x + 1, y, c) + at(l, x, y + 1, c) +
                        at(l, x + 1, y + 1, c));
    default:
        return rotated(l, x, y, pattern == ONE ? 1 : pattern == FOUR ? 2 : 4, c);
    }
}

static double psnr_of(const lines *l, int pattern) {
    const unsigned width = l->width / CLOSE, height = l->height / CLOSE;
    double squares = 0.0;
    for (size_t i = 0; i < (size_t)3 * width * height; i++) {
        const unsigned x = (unsigned)(i / 3 % width), y = (unsigned)(i / 3 / width), c = i % 3;
        double light = 0.0;
        for (unsigned k = 0; k < CLOSE * CLOSE; k++) {
            light += at(l, x + (k % CLOSE + 0.5) / CLOSE, y + (k / CLOSE + 0.5) / CLOSE, c);
        }
        const double off =
            srgb_of(light / (CLOSE * CLOSE)) - srgb_of(pattern_of(l, pattern, x, y, c));
        squares += off * off;
    }
    return 10.0 * log10(255.0 * 255.0 * 3.0 * width * height / squares);
}

static void compare(const lines *l) {
    static const char *const name[PATTERNS_END] = {[ONE] = "one",
                                                   [FOUR] = "four",
                                                   [FLIPQUAD] = "flipquad",
                                                   [QUINCUNX] = "quincunx",
                                                   [SIXTEEN] = "sixteen"};
    double psnr[PATTERNS_END] = {0};
    for (int i = ONE; i < PATTERNS_END; i++) {
        psnr[i] = psnr_of(l, i);
        printf("    %-8s %.1f dB\n", name[i], psnr[i]);
    }
    CHECK(psnr[FOUR] > psnr[ONE] && psnr[SIXTEEN] > psnr[FOUR], "more samples are nearer");
    CHECK(psnr[FOUR] > psnr[FLIPQUAD] && psnr[FOUR] > psnr[QUINCUNX], "shared ones are not");
}

static void of_file(const char *path) {
    lines l = {0};
    FILE *file = fopen(path, "rb");
    const int good = file != NULL && fscanf(file, "P6 %u %u 255", &l.width, &l.height) == 2 &&
                     l.width < 32768 && l.height < 32768 && fgetc(file) == '\n';
    const size_t bytes = (size_t)3 * l.width * l.height;
    l.rgb = good ? malloc(bytes) : NULL;
    const int whole = l.rgb != NULL && fread(l.rgb, 1, bytes, file) == bytes;
    CHECK(whole, "%s is no P6 picture", path);
    if (whole) {
        compare(&l);
    }
    free(l.rgb);
    if (file != NULL) {
        fclose(file);
    }
}

static void of_shapes(void) {
    static const float eye[3] = {2, 1.5f, 3}, look[3] = {0, 0, 0};
    const rig_config config = rig_config_of(2, 16, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    const plt_frame f = frame_of(eye, look, 48 * CLOSE, 48 * CLOSE, PLT_SHADE_EYELIGHT);
    mesh m = {0};
    rig r;
    shape_icosphere(&m, rig_is_tiny() ? 1 : 2);
    shape_cube(&m);
    CHECK(rig_open(&r, &m, &config) == PLT_OK, "%s", r.fault.message);
    frame_result result = frame_render(r.engine, &f, 1000);
    compare(&(lines){f.width, f.height, result.rgb});
    free(result.rgb);
    rig_close(&r);
    mesh_free(&m);
}

int main(int argc, char **argv) {
    test("patterns beside 64 samples per pixel");
    if (argc > 1) {
        of_file(argv[1]);
    } else {
        of_shapes();
    }
    return test_done();
}
