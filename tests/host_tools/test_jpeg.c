/* test_jpeg - JPEG files against a decoder that knows T.81 only
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/jpeg.h"

#include "engine/planelet_crc32.h"
#include "host_tools/picture/jpeg_block.h"
#include "tests/reference/jpeg_decode.h"
#include "tests/test.h"

static uint32_t seed = 1;

static unsigned random_below(unsigned limit) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % limit;
}

/* ---- pictures -------------------------------------------------------------------------- */

/* Smooth slopes in all channels with an edge and a little grain. */
static uint8_t plain(unsigned c, unsigned x, unsigned y) {
    const unsigned slope = c == 0 ? 3 * x + y : c == 1 ? 2 * x + 3 * y : 255 + x - 2 * y;
    return (uint8_t)((x / 11 + y / 7) % 2 ? slope % 256 : 90 + slope % 64);
}

static picture make(unsigned width, unsigned height, int noise) {
    picture p = {0};
    fail f = {0};
    CHECK(picture_make(&p, width, height, &f) == 0, "%ux%u", width, height);
    for (unsigned i = 0; i < 3 * width * height; i++) {
        p.rgb[i] = noise == 0   ? plain(i % 3, i / 3 % width, i / 3 / width)
                   : noise == 1 ? (uint8_t)random_below(256)
                                : (uint8_t)(255 * random_below(2));
    }
    return p;
}

/* ---- what a file should hold ----------------------------------------------------------- */

static const double weights[3][3] = {
    {0.299, 0.587, 0.114}, {-0.168736, -0.331264, 0.5}, {0.5, -0.418688, -0.081312}};

static double exact(const picture *p, unsigned c, unsigned x, unsigned y) {
    const uint8_t *rgb = p->rgb + 3 * ((size_t)y * p->width + x);
    const double sum = weights[c][0] * rgb[0] + weights[c][1] * rgb[1] + weights[c][2] * rgb[2];
    return c == 0 ? sum : sum + 128;
}

/* Mean over a chroma sample, whose pixels beyond the border are the last ones. */
static double exact_mean(const picture *p, unsigned c, unsigned x, unsigned y,
                         const jpeg_decoded *d) {
    const unsigned across = c ? d->across : 1, down = c ? d->down : 1;
    double sum = 0;
    for (unsigned j = y / down * down; j < y / down * down + down; j++) {
        for (unsigned i = x / across * across; i < x / across * across + across; i++) {
            sum += exact(p, c, i < p->width ? i : p->width - 1, j < p->height ? j : p->height - 1);
        }
    }
    return sum / (across * down);
}

/* Root of the mean square that samples are off, of 255. */
static double error_of(const picture *p, const jpeg_decoded *d) {
    double sum = 0;
    for (unsigned c = 0; c < 3; c++) {
        for (unsigned y = 0; y < p->height; y++) {
            for (unsigned x = 0; x < p->width; x++) {
                const double off = jpeg_component(d, c, x, y) - exact_mean(p, c, x, y, d);
                sum += off * off;
            }
        }
    }
    return sqrt(sum / 3 / p->width / p->height);
}

/* Its error, or a failed check. */
static double decodes(const picture *p, jpeg_sampling sampling, unsigned quality) {
    const size_t most = jpeg_most(p->width, p->height);
    uint8_t *file = malloc(most);
    const size_t bytes = jpeg_write(p, sampling, quality, file, most);
    jpeg_decoded d = {.trouble = "too large"};
    double error = 1e9;
    if (bytes <= most) {
        d = jpeg_decode(file, bytes);
    }
    CHECK(d.trouble == NULL, "%ux%u, sampling %d, quality %u: %s", p->width, p->height,
          (int)sampling, quality, d.trouble ? d.trouble : "");
    if (d.trouble == NULL) {
        CHECK(d.width == p->width && d.height == p->height, "%ux%u", d.width, d.height);
        CHECK(d.across == (sampling == JPEG_444 ? 1u : 2u) && d.down == (sampling == JPEG_420) + 1u,
              "%ux%u", d.across, d.down);
        error = error_of(p, &d);
    }
    jpeg_decoded_free(&d);
    free(file);
    return error;
}

/* ---- properties ------------------------------------------------------------------------ */

static double exact_coefficient(const int16_t block[64], unsigned u, unsigned v) {
    double sum = 0;
    for (unsigned y = 0; y < 8; y++) {
        for (unsigned x = 0; x < 8; x++) {
            sum += block[8 * y + x] * cos((2 * x + 1) * u * acos(-1) / 16) *
                   cos((2 * y + 1) * v * acos(-1) / 16);
        }
    }
    return sum / 4 * (u ? 1 : sqrt(0.5)) * (v ? 1 : sqrt(0.5));
}

static void transform(void) {
    test("coefficients are within 0.6 of the exact ones, 0.5 of that their rounding");
    uint8_t ones[64];
    double worst = 0;
    memset(ones, 1, sizeof ones);
    for (unsigned round = 0; round < 400; round++) {
        int16_t block[64], out[64];
        for (unsigned i = 0; i < 64; i++) {
            block[i] = round == 0       ? 127
                       : round == 1     ? -127
                       : round % 2 == 0 ? (int16_t)(random_below(2) ? 127 : -128)
                                        : (int16_t)((int)random_below(256) - 128);
        }
        memcpy(out, block, sizeof out);
        jpeg_transform(out, ones);
        for (unsigned i = 0; i < 64; i++) {
            const double off = fabs(out[i] - exact_coefficient(block, i % 8, i / 8));
            worst = off > worst ? off : worst;
            CHECK(off < 0.6, "coefficient %u of block %u is off by %g", i, round, off);
        }
    }
    CHECK(worst > 0.49, "worst is %g: was anything rounded?", worst);
    test("a block of the least samples, whose mean has no code, is the nearest that has one");
    int16_t least[64];
    for (unsigned i = 0; i < 64; i++) {
        least[i] = -128;
    }
    jpeg_transform(least, ones);
    CHECK(least[0] == -1023, "%d", least[0]);
    test("coefficients are divided by their own steps, alike on both sides of 0");
    uint8_t steps[64];
    for (unsigned i = 0; i < 64; i++) {
        steps[i] = (uint8_t)(16 + i);
    }
    int16_t flat[64];
    for (int sign = -1; sign <= 1; sign += 2) {
        for (unsigned i = 0; i < 64; i++) {
            flat[i] = (int16_t)(sign * 6); /* 48 of 16 */
        }
        jpeg_transform(flat, steps);
        CHECK(flat[0] == 3 * sign, "%d", flat[0]);
        for (unsigned i = 1; i < 64; i++) {
            CHECK(flat[i] == 0, "%u is %d", i, flat[i]);
        }
    }
}

static void sizes(void) {
    test("all sizes to 33x33 are read again, in every sampling");
    for (unsigned height = 1; height <= 33; height += height < 18 ? 1 : 5) {
        for (unsigned width = 1; width <= 33; width += width < 18 ? 1 : 5) {
            picture p = make(width, height, 0);
            for (int sampling = 0; sampling < JPEG_SAMPLINGS; sampling++) {
                const double error = decodes(&p, (jpeg_sampling)sampling, 100);
                CHECK(error < 1.0, "%ux%u, sampling %d: off by %g", width, height, sampling, error);
            }
            picture_free(&p);
        }
    }
}

static void qualities(void) {
    test("each quality is read again, and lies no further off than the one before it by much");
    picture p = make(67, 45, 0);
    double before = 1e9;
    for (unsigned quality = 1; quality <= 100; quality++) {
        const double error = decodes(&p, JPEG_420, quality);
        CHECK(error < 1.15 * before, "%u: off by %g, after %g", quality, error, before);
        before = error;
    }
    CHECK(before < 0.7, "the best is off by %g", before);
    picture_free(&p);
    test("noise of two values and of all, which has every code, is read again");
    for (int noise = 1; noise <= 2; noise++) {
        p = make(96, 64, noise);
        for (int sampling = 0; sampling < JPEG_SAMPLINGS; sampling++) {
            for (unsigned quality = 1; quality <= 100; quality += 3) {
                const double error = decodes(&p, (jpeg_sampling)sampling, quality);
                CHECK(quality < 100 || error < 2.0, "%u: off by %g", quality, error);
            }
        }
        picture_free(&p);
    }
}

static void fitting(void) {
    test("a file that fits is of the highest quality that does, and no byte lies behind it");
    picture p = make(80, 80, 0);
    uint8_t file[16384 + 1], other[16384];
    for (size_t room = 700; room < 16000; room += 611) {
        unsigned quality = 0;
        file[room] = 0xA5;
        const size_t bytes = jpeg_fit(&p, JPEG_420, 1, 95, &quality, file, room);
        CHECK(file[room] == 0xA5, "of %zu bytes", room);
        if (bytes > room) {
            CHECK(jpeg_write(&p, JPEG_420, 1, other, sizeof other) > room, "%zu", room);
            continue;
        }
        CHECK(jpeg_write(&p, JPEG_420, quality, other, sizeof other) == bytes &&
                  memcmp(file, other, bytes) == 0,
              "of %zu bytes", room);
        CHECK(quality == 95 || jpeg_write(&p, JPEG_420, quality + 1, other, sizeof other) > room,
              "%zu: %u is not the highest", room, quality);
    }
    test("what does not fit is counted, not written");
    memset(file, 0xA5, sizeof file);
    const size_t bytes = jpeg_write(&p, JPEG_444, 60, file, 100);
    CHECK(bytes == jpeg_write(&p, JPEG_444, 60, other, sizeof other), "%zu", bytes);
    for (size_t i = 100; i < sizeof file; i++) {
        CHECK(file[i] == 0xA5, "byte %zu", i);
    }
    picture_free(&p);
}

static void golden(void) {
    test("the bytes are those of every other machine");
    static const uint32_t crc[JPEG_SAMPLINGS] = {0x3170F3B0, 0x461DC3C4, 0xEEC04AAB};
    picture p = make(59, 43, 0);
    uint8_t file[16384];
    for (int sampling = 0; sampling < JPEG_SAMPLINGS; sampling++) {
        const size_t bytes = jpeg_write(&p, (jpeg_sampling)sampling, 85, file, sizeof file);
        const uint32_t is = plt_crc32(0, file, (uint32_t)bytes);
        CHECK(is == crc[sampling], "sampling %d: 0x%08X, %zu bytes", sampling, (unsigned)is, bytes);
    }
    picture_free(&p);
}

int main(void) {
    transform();
    sizes();
    qualities();
    fitting();
    golden();
    return test_done();
}
