/* test_picture_frames - PPM and Y4M byte for byte, refusals, full disks
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "host_tools/picture/picture_file.h"
#include "tests/test.h"

#define FOLDER "build/test-tmp"

/* Six pixels, 3 x 2: red green blue / black grey white. */
static uint8_t six[18] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 119, 119, 119, 255, 255, 255};

static void write_frames(const char *path, const picture *p, unsigned frames) {
    fail f = {""};
    picture_format format = PICTURE_PNG;
    CHECK(!picture_format_of(path, &format, &f), "%s", f.text);
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
    write_frames(FOLDER "/six.ppm", &p, 1);
    expect(FOLDER "/six.ppm", ppm, sizeof ppm);

    test("Y4M: two frames of 3 x 2 pixels are exactly these bytes, full range BT.601");
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
    write_frames(FOLDER "/six.y4m", &p, 2);
    expect(FOLDER "/six.y4m", y4m, sizeof y4m);
}

/* Reads the planes back by the textbook formula in floating point. */
static void test_y4m_inverse(void) {
    picture p;
    fail f = {""};
    test("Y4M: 97 x 61 colours come back from the planes to within 2 of 255");
    CHECK(!picture_make(&p, 97, 61, &f), "%s", f.text);
    for (unsigned i = 0; i < 97 * 61 * 3; i++) {
        p.rgb[i] = (uint8_t)(i * 2654435761u >> 24);
    }
    write_frames(FOLDER "/colours.y4m", &p, 1);
    FILE *file = fopen(FOLDER "/colours.y4m", "rb");
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
    static const char *const names[3] = {"PNG", "PPM", "Y4M"};
    struct stat before, after;
    test("full disk: every format fails with one line, for small and large pictures");
    CHECK(stat("/dev/full", &before) == 0 && S_ISCHR(before.st_mode), "no /dev/full here");
    for (unsigned i = 0; i < 6; i++) {
        picture p;
        fail f = {""}, made = {""};
        const picture_format format = (picture_format)(i % 3);
        const unsigned side = i < 3 ? 4 : 700;
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
        CHECK(wrong && f.text[0] && !strchr(f.text, '\n'), "%s: \"%s\"", names[i % 3], f.text);
        CHECK(strstr(f.text, "/dev/full") != NULL, "%s: \"%s\"", names[i % 3], f.text);
        picture_free(&p);
    }
    CHECK(stat("/dev/full", &after) == 0 && S_ISCHR(after.st_mode), "/dev/full was replaced");
}

int main(void) {
    mkdir("build", 0777);
    mkdir(FOLDER, 0777);
    test_bytes();
    test_y4m_inverse();
    test_refusals();
    test_full_disk();
    return test_done();
}
