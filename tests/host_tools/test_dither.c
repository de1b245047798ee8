/* test_dither - the thresholds are what the method makes, even at every level, and pictures do not
 * crawl
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/dither.h"

#include <math.h>
#include <stdlib.h>

#include "tests/reference/void_and_cluster.h"
#include "tests/test.h"

enum { WIDTH = 160, HEIGHT = 96, PIXELS = WIDTH * HEIGHT };

static void is_blue_noise(void) {
    static uint16_t ranks[VAC_COUNT];
    test("the thresholds are those of the void-and-cluster method");
    vac_ranks(ranks);
    for (unsigned i = 0; i < VAC_COUNT; i++) {
        const unsigned of = dither_threshold[i / VAC_SIDE][i % VAC_SIDE];
        CHECK(of == ranks[i] * 255u / VAC_COUNT, "place %u: %u, not %u", i, of,
              ranks[i] * 255u / VAC_COUNT);
    }
}

static unsigned lit_in(unsigned grey, unsigned left, unsigned top, unsigned side) {
    const uint8_t rgb[3] = {(uint8_t)grey, (uint8_t)grey, (uint8_t)grey};
    unsigned lit = 0;
    for (unsigned i = 0; i < side * side; i++) {
        lit += dither_is_lit(rgb, left + i % side, top + i / side) != 0;
    }
    return lit;
}

/* A random pattern would be off by 4 of 64 in a square, one deviation. */
static void levels(void) {
    unsigned off_most = 0;
    test("of a grey of L, L / 255 of all places light up, and in squares of 8x8 about as many");
    for (unsigned grey = 0; grey < 256; grey++) {
        const double lit = lit_in(grey, 0, 0, VAC_SIDE), right = grey * VAC_COUNT / 255.0;
        CHECK(fabs(lit - right) <= 3, "%g of grey %u, not %g", lit, grey, right);
        for (unsigned square = 0; square < 64; square++) {
            const double here = lit_in(grey, square % 8 * 4, square / 8 * 4, 8);
            const unsigned off = (unsigned)fabs(here - grey * 64 / 255.0);
            off_most = off > off_most ? off : off_most;
        }
    }
    CHECK(lit_in(0, 0, 0, VAC_SIDE) == 0 && lit_in(255, 0, 0, VAC_SIDE) == VAC_COUNT, "ends");
    CHECK(off_most <= 6, "%u of 64 in a square", off_most);
    printf("    squares of 8x8 are off by at most %u of 64\n", off_most);
}

/* ---- what the eye sees as waves ----------------------------------------------------------- */

/* The share of a pattern's energy in its slowest waves, up to an eighth of those that it could
 * have along each axis. */
static double slow_share(unsigned grey) {
    const uint8_t rgb[3] = {(uint8_t)grey, (uint8_t)grey, (uint8_t)grey};
    double slow = 0, all = 0;
    for (unsigned v = 0; v < VAC_SIDE; v++) {
        for (unsigned u = 0; u < VAC_SIDE; u++) {
            double re = 0, im = 0;
            for (unsigned i = 0; (u > 0 || v > 0) && i < VAC_COUNT; i++) {
                if (dither_is_lit(rgb, i % VAC_SIDE, i / VAC_SIDE)) {
                    const double phase =
                        2 * 3.14159265358979 / VAC_SIDE * (u * (i % VAC_SIDE) + v * (i / VAC_SIDE));
                    re += cos(phase);
                    im += sin(phase);
                }
            }
            const unsigned slower = vac_distance(u, 0), other = vac_distance(v, 0);
            all += re * re + im * im;
            slow += slower <= 4 && other <= 4 ? re * re + im * im : 0;
        }
    }
    return slow / all;
}

static void spectrum(void) {
    test("patterns have next to none of their energy in slow waves: noise would have 8 %");
    for (unsigned grey = 32; grey < 256; grey += 32) {
        const double share = slow_share(grey);
        CHECK(share < 0.02, "%.1f %% at grey %u", 100 * share, grey);
        printf("    grey %u: %.2f %%\n", grey, 100 * share);
    }
}

/* ---- motion --------------------------------------------------------------------------------- */

/* A ramp, and a bright disk that stands `at` from the left. */
static void scene(uint8_t rgb[3 * PIXELS], unsigned at) {
    for (unsigned i = 0; i < PIXELS; i++) {
        const int dx = (int)(i % WIDTH) - (int)at, dy = (int)(i / WIDTH) - HEIGHT / 2;
        const unsigned disk = dx * dx + dy * dy < 400;
        memset(rgb + 3 * i, (int)(disk ? 230 : 20 + i % WIDTH), 3);
    }
}

static void dithered(const uint8_t rgb[3 * PIXELS], uint8_t lit[PIXELS]) {
    for (unsigned i = 0; i < PIXELS; i++) {
        lit[i] = dither_is_lit(rgb + 3 * i, i % WIDTH, i / WIDTH) != 0;
    }
}

/* Floyd and Steinberg's, to compare with. */
static void diffused(const uint8_t rgb[3 * PIXELS], uint8_t lit[PIXELS]) {
    static int grey[PIXELS + WIDTH + 1];
    memset(grey, 0, sizeof grey);
    for (unsigned i = 0; i < PIXELS; i++) {
        grey[i] += 16 * rgb[3 * i];
        lit[i] = grey[i] > 16 * 127;
        const int off = (grey[i] - (lit[i] ? 16 * 255 : 0)) / 16;
        grey[i + 1] += 7 * off;
        grey[i + WIDTH - 1] += 3 * off;
        grey[i + WIDTH] += 5 * off;
        grey[i + WIDTH + 1] += off;
    }
}

/* Bits that changed although their pixels did not. */
static unsigned crawling(void (*by)(const uint8_t rgb[3 * PIXELS], uint8_t lit[PIXELS]),
                         unsigned at, unsigned then) {
    static uint8_t rgb[2][3 * PIXELS], lit[2][PIXELS];
    unsigned count = 0;
    scene(rgb[0], at);
    scene(rgb[1], then);
    by(rgb[0], lit[0]);
    by(rgb[1], lit[1]);
    for (unsigned i = 0; i < PIXELS; i++) {
        count += lit[0][i] != lit[1][i] && rgb[0][3 * i] == rgb[1][3 * i];
    }
    return count;
}

static void motion(void) {
    unsigned ours = 0, theirs = 0;
    test("a picture that moves changes no bit whose pixel stays");
    for (unsigned at = 30; at < 130; at++) {
        ours += crawling(dithered, at, at + 1);
        theirs += crawling(diffused, at, at + 1);
    }
    CHECK(ours == 0, "%u bits in 100 frames", ours);
    CHECK(theirs > 1000, "errors that are diffused change %u: the test sees nothing", theirs);
    printf("    in 100 frames %u bits; diffused errors would change %u\n", ours, theirs);
}

/* ---- six bits -------------------------------------------------------------------------------- */

static void six_bits(void) {
    test("of six bits: one of the two nearest levels, and right in the mean");
    for (unsigned value = 0; value < 256; value++) {
        double sum = 0;
        for (unsigned i = 0; i < VAC_COUNT; i++) {
            const unsigned is = dither_six_bits((uint8_t)value, i % VAC_SIDE, i / VAC_SIDE);
            const double level = (is >> 2) * 255 / 63.0;
            CHECK(fabs(level - value) < 255 / 63.0, "%u becomes %u", value, is);
            CHECK((is & 3) == is >> 6, "%u: the lower bits of %u", value, is);
            sum += level;
        }
        CHECK(fabs(sum / VAC_COUNT - value) < 0.02, "%u becomes %g", value, sum / VAC_COUNT);
    }
}

int main(void) {
    is_blue_noise();
    levels();
    spectrum();
    motion();
    six_bits();
    return test_done();
}
