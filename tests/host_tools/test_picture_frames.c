/* test_picture_frames - PPM and Y4M byte for byte, refusals, full disks
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "host_tools/picture/picture_file.h"
#include "tests/test.h"

/* Six pixels, 3 x 2: red green blue / black grey white. */
static uint8_t six[18] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 119, 119, 119, 255, 255, 255};

static void write_frames(const char *path, picture_format format, const picture *p,
                         unsigned frames) {
    fail f = {""};
    output *o = output_open(path, &f);
    CHECK(o && !picture_begin(o, format, p->width, p->height, 25, &f), "%s", f.text);
    for (unsigned i = 0; i < frames; i++) {
        CHECK(!picture_frame(o, format, p, &f), "%s", f.text);
    }
    CHECK(!output_commit(o, &f), "%s", f.text);
}

static void expect(const char *path, const void *bytes, size_t size) {
    uint8_t got[1024];
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL, "%s is not there", path);
    if (file) {
        const size_t count = fread(got, 1, sizeof got, file);
        CHECK(count == size, "%zu bytes, not %zu", count, size);
        CHECK(count == size && memcmp(got, bytes, size) == 0, "%s: bytes differ", path);
        fclose(file);
    }
}

static void test_bytes(void) {
    const picture p = {six, 3, 2};
    uint8_t ppm[11 + 18];
    test("PPM: a picture of 3 x 2 pixels is exactly these 29 bytes");
    memcpy(ppm, "P6\n3 2\n255\n", 11);
    memcpy(ppm + 11, six, 18);
    write_frames(TEST_FOLDER "six.ppm", PICTURE_PPM, &p, 1);
    expect(TEST_FOLDER "six.ppm", ppm, sizeof ppm);

    test("Y4M 4:4:4: two frames of 3 x 2 pixels are exactly these bytes, full range BT.601");
    static const uint8_t frame[] =
        "FRAME\n"
        "\x4C\x96\x1D\x00\x77\xFF"  /* Y 76 150 29 0 119 255 */
        "\x55\x2C\xFF\x80\x80\x80"  /* Cb 85 44 255 128 .. */
        "\xFF\x15\x6B\x80\x80\x80"; /* Cr 255 21 107 128 .. */
    static const char head[] = "YUV4MPEG2 W3 H2 F25:1 Ip A1:1 C444 XCOLORRANGE=FULL\n";
    uint8_t y4m[sizeof head - 1 + 2 * (sizeof frame - 1)];
    memcpy(y4m, head, sizeof head - 1);
    memcpy(y4m + sizeof head - 1, frame, sizeof frame - 1);
    memcpy(y4m + sizeof head - 1 + sizeof frame - 1, frame, sizeof frame - 1);
    write_frames(TEST_FOLDER "six.y4m", PICTURE_Y4M_444, &p, 2);
    expect(TEST_FOLDER "six.y4m", y4m, sizeof y4m);
}

/* Red green blue / black grey white, 3 x 2: the chroma of the second column is that of
 * blue and white alone. Y is 16 + 219 times 0.299, 0.587, 0.114; C 128 + 224 times the mean
 * of four, or of two: Cb (-0.1687 - 0.3313 + 0 + 0) / 4 and (0.5 + 0) / 2. */
static void test_bytes_420(void) {
    const picture p = {six, 3, 2}, one = {six, 1, 1};
    test("Y4M 4:2:0: 3 x 2 pixels are exactly these bytes, limited range, odd edges averaged");
    static const char film[] =
        "YUV4MPEG2 W3 H2 F25:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n"
        "FRAME\n"
        "\x51\x91\x29\x10\x76\xEB" /* Y 81 145 41 16 118 235 */
        "\x64\xB8"                 /* Cb 100 184 */
        "\x85\x77";                /* Cr 133 119 */
    write_frames(TEST_FOLDER "six.y4m", PICTURE_Y4M, &p, 1);
    expect(TEST_FOLDER "six.y4m", film, sizeof film - 1);
    static const char pixel[] =
        "YUV4MPEG2 W1 H1 F25:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n"
        "FRAME\n\x51\x5A\xF0";
    write_frames(TEST_FOLDER "one.y4m", PICTURE_Y4M, &one, 1);
    expect(TEST_FOLDER "one.y4m", pixel, sizeof pixel - 1);
}

/* The planes of a 4:2:0 film against means in floating point, for sides of each parity. */
static void test_means_420(void) {
    static const unsigned sides[][2] = {{97, 61}, {64, 33}, {33, 64}, {2, 2}, {1, 7}, {7, 1}};
    static const double rows[3][4] = {
        {16, .299 * 219 / 255, .587 * 219 / 255, .114 * 219 / 255},
        {128, -.168736 * 224 / 255, -.331264 * 224 / 255, 112. / 255},
        {128, 112. / 255, -.418688 * 224 / 255, -.081312 * 224 / 255}};
    test(
        "Y4M 4:2:0: every sample is the mean of its pixels to within rounding, sizes odd and even");
    for (unsigned s = 0; s < sizeof sides / sizeof sides[0]; s++) {
        const unsigned w = sides[s][0], h = sides[s][1];
        uint8_t planes[3 * 97 * 64];
        char line[100];
        picture p;
        fail f = {""};
        CHECK(!picture_make(&p, w, h, &f), "%s", f.text);
        for (unsigned i = 0; i < w * h * 3; i++) {
            p.rgb[i] = (uint8_t)(i % 7 == 0 ? 255 : i * 2654435761u >> 24);
        }
        write_frames(TEST_FOLDER "means.y4m", PICTURE_Y4M, &p, 1);
        FILE *file = fopen(TEST_FOLDER "means.y4m", "rb");
        const size_t bytes = (size_t)w * h + 2 * (size_t)((w + 1) / 2) * ((h + 1) / 2);
        CHECK(file && fgets(line, sizeof line, file) && fgets(line, sizeof line, file) &&
                  fread(planes, 1, bytes, file) == bytes && fgetc(file) == EOF,
              "%u x %u: not %zu bytes", w, h, bytes);
        const uint8_t *at = planes;
        for (unsigned k = 0; k < 3; k++) {
            const unsigned side = k == 0 ? 1 : 2;
            for (unsigned y = 0; y < h; y += side) {
                for (unsigned x = 0; x < w; x += side, at++) {
                    double sum = 0, pixels = 0;
                    for (unsigned j = y; j < y + side && j < h; j++) {
                        for (unsigned i = x; i < x + side && i < w; i++, pixels++) {
                            const uint8_t *c = p.rgb + 3 * (j * w + i);
                            sum += rows[k][0] + rows[k][1] * c[0] + rows[k][2] * c[1] +
                                   rows[k][3] * c[2];
                        }
                    }
                    const double off = sum / pixels - *at;
                    CHECK(off < 0.51 && off > -0.51, "plane %u at %u, %u is off by %g", k, x, y,
                          off);
                }
            }
        }
        if (file) {
            fclose(file);
        }
        picture_free(&p);
    }
}

/* Reads the planes back by the textbook formula in floating point. */
static void test_y4m_inverse(void) {
    picture p;
    fail f = {""};
    test("Y4M 4:4:4: 97 x 61 colours come back from the planes to within 2 of 255");
    CHECK(!picture_make(&p, 97, 61, &f), "%s", f.text);
    for (unsigned i = 0; i < 97 * 61 * 3; i++) {
        p.rgb[i] = (uint8_t)(i * 2654435761u >> 24);
    }
    write_frames(TEST_FOLDER "colours.y4m", PICTURE_Y4M_444, &p, 1);
    FILE *file = fopen(TEST_FOLDER "colours.y4m", "rb");
    uint8_t plane[3][97 * 61];
    char line[100];
    CHECK(file && fgets(line, sizeof line, file) && fgets(line, sizeof line, file) &&
              fread(plane, 1, sizeof plane, file) == sizeof plane && fgetc(file) == EOF,
          "not the right size");
    for (unsigned i = 0; i < 97 * 61; i++) {
        const double y = plane[0][i], cb = plane[1][i] - 128.0, cr = plane[2][i] - 128.0;
        const double rgb[3] = {y + 1.402 * cr, y - 0.344136 * cb - 0.714136 * cr, y + 1.772 * cb};
        for (unsigned c = 0; c < 3; c++) {
            const double off = rgb[c] - p.rgb[3 * i + c];
            CHECK(off < 2 && off > -2, "pixel %u channel %u is off by %g", i, c, off);
        }
    }
    if (file) {
        fclose(file);
    }
    picture_free(&p);
}

static void test_refusals(void) {
    fail f = {""};
    picture p;
    picture_format format = PICTURE_PPM;
    test("format: the ending decides in any case; - keeps the caller's choice");
    CHECK(!picture_format_of("a.b.PnG", &format, &f) && format == PICTURE_PNG, "%s", f.text);
    CHECK(!picture_format_of("-", &format, &f) && format == PICTURE_PNG, "%s", f.text);
    CHECK(!picture_format_of("x.Y4M", &format, &f) && format == PICTURE_Y4M, "%s", f.text);

    test("format: another ending is refused in one line that names the three");
    CHECK(picture_format_of("picture.jpeg", &format, &f) == -1, "accepted");
    CHECK(strstr(f.text, ".png") && strstr(f.text, ".ppm") && strstr(f.text, ".y4m"), "%s", f.text);
    CHECK(picture_format_of("png", &format, &f) == -1, "accepted");

    test("picture: sides of 0 and above the maximum are refused, and nothing is left");
    static const unsigned bad[][2] = {{0, 1}, {1, 0}, {PICTURE_SIDE_MAX + 1, 1}, {1, 4294967295u}};
    for (unsigned i = 0; i < 4; i++) {
        fail why = {""};
        CHECK(picture_make(&p, bad[i][0], bad[i][1], &why) == -1 && why.text[0], "made");
        CHECK(!p.rgb && !p.width && !p.height, "something was left");
        picture_free(&p);
    }
    test("video at 0 frames per second is refused");
    fail why = {""};
    CHECK(picture_begin(NULL, PICTURE_Y4M, 2, 2, 0, &why) == -1 && why.text[0], "begun");
}

static void test_full_disk(void) {
    static const char *const names[4] = {"PNG", "PPM", "Y4M", "Y4M 4:4:4"};
    struct stat before, after;
    test("full disk: every format fails with one line, for small and large pictures");
    CHECK(stat("/dev/full", &before) == 0 && S_ISCHR(before.st_mode), "no /dev/full here");
    for (unsigned i = 0; i < 8; i++) {
        picture p;
        fail f = {""}, made = {""};
        const picture_format format = (picture_format)(i % 4);
        const unsigned side = i < 4 ? 4 : 700;
        picture_make(&p, side, side, &made);
        output *o = output_open("/dev/full", &f);
        CHECK(o != NULL, "%s", f.text);
        int wrong =
            picture_begin(o, format, side, side, 25, &f) || picture_frame(o, format, &p, &f);
        if (wrong) {
            output_abandon(o);
        } else {
            wrong = output_commit(o, &f);
        }
        CHECK(wrong && f.text[0] && !strchr(f.text, '\n'), "%s: \"%s\"", names[i % 4], f.text);
        CHECK(strstr(f.text, "/dev/full") != NULL, "%s: \"%s\"", names[i % 4], f.text);
        picture_free(&p);
    }
    CHECK(stat("/dev/full", &after) == 0 && S_ISCHR(after.st_mode), "/dev/full was replaced");
}

int main(void) {
    mkdir(TEST_FOLDER, 0777);
    test_bytes();
    test_bytes_420();
    test_means_420();
    test_y4m_inverse();
    test_refusals();
    test_full_disk();
    return test_done();
}
