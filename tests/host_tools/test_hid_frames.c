/* test_hid_frames - pictures, films and pipes in
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <unistd.h>

#include "engine/planelet_crc32.h"
#include "host_tools/hid/sources/frames_open.h"
#include "host_tools/picture/picture_file.h"
#include "tests/hid/pattern.h"
#include "tests/test.h"

static char path[256];

static void make_path(const char *name) {
    const char *folder = getenv("TMPDIR");
    snprintf(path, sizeof path, "%s/planelet-%ld-%s", folder == NULL ? "/tmp" : folder,
             (long)getpid(), name);
}

static void write_file(const char *name, const void *bytes, size_t count) {
    make_path(name);
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL && fwrite(bytes, 1, count, file) == count, "%s", path);
    if (file != NULL) {
        fclose(file);
    }
}

/* Reads the file at `path`: how many frames came, the last one in `p`. */
static int read_frames(picture *p, fail *f) {
    static const arg_flag none[] = {{NULL, NULL, NULL}};
    static const arg_command command = {"show", "", "", none, 0, 1, NULL, NULL};
    args a = {.program = "planelet-hid", .command = &command};
    frames s = {0};
    int count = 0, status = frames_open(&s, &a, path, 8, 8, f);
    while (status == 0 && (status = s.next(&s, p, f)) == FRAMES_ONE) {
        count++;
        status = 0;
    }
    frames_close(&s);
    remove(path);
    return status < 0 ? -1 : count;
}

/* Each colour of the pattern is `block` x `block` pixels. */
static void back_again(picture_format format, const char *name, unsigned w, unsigned h,
                       unsigned block, int most) {
    picture from, to = {0};
    fail f = {""};
    make_path(name);
    picture_make(&from, w, h, &f);
    pattern_fill(w, w, h, from.rgb);
    for (size_t i = 0; i < (size_t)w * h; i++) {
        const size_t x = i % w - i % w % block, y = i / w - i / w % block;
        memmove(from.rgb + 3 * i, from.rgb + 3 * (y * w + x), 3);
    }
    output *o = output_open(path, &f);
    CHECK(o != NULL && picture_begin(o, format, w, h, 25, &f) == 0 &&
              picture_frame(o, format, &from, &f) == 0 && output_commit(o, &f) == 0,
          "%s", f.text);
    CHECK(read_frames(&to, &f) == 1, "%s: %s", name, f.text);
    int worst = to.width == w && to.height == h ? 0 : 256;
    for (size_t i = 0; worst < 256 && i < 3 * (size_t)w * h; i++) {
        const int off = abs(from.rgb[i] - to.rgb[i]);
        worst = off > worst ? off : worst;
    }
    CHECK(worst <= most, "%s of %ux%u is off by %d", name, w, h, worst);
    picture_free(&from);
    picture_free(&to);
}

static void own_files(void) {
    test("PNG and PPM of planelet come back as they were, Y4M within 2 of 255, 3 as 4:2:0");
    static const unsigned sides[][2] = {{1, 1}, {17, 5}, {240, 160}, {321, 199}};
    for (unsigned i = 0; i < 4; i++) {
        back_again(PICTURE_PNG, "a.png", sides[i][0], sides[i][1], 1, 0);
        back_again(PICTURE_PPM, "a.ppm", sides[i][0], sides[i][1], 1, 0);
        back_again(PICTURE_Y4M_444, "a.y4m", sides[i][0], sides[i][1], 1, 2);
        back_again(PICTURE_Y4M, "a.y4m", sides[i][0], sides[i][1], 2, 3);
    }
}

static void expect_pixel(const picture *p, unsigned x, unsigned y, int r, int g, int b) {
    const uint8_t *c = p->rgb + 3 * (y * p->width + x);
    CHECK(abs(c[0] - r) <= 1 && abs(c[1] - g) <= 1 && abs(c[2] - b) <= 1,
          "(%u, %u) is %d %d %d, not %d %d %d", x, y, c[0], c[1], c[2], r, g, b);
}

/* White, black and the primaries of BT.601 in limited range, as ffmpeg has. */
static void limited_film(void) {
    picture p = {0};
    fail f = {""};
    static const char film[] =
        "YUV4MPEG2 W4 H2 F30000:1001 Ip A1:1 C420jpeg\n"
        "FRAME\n\xEB\xEB\x10\x10\xEB\xEB\x10\x10\x80\x80\x80\x80"
        "FRAME Ip\n\x51\x51\x29\x29\x51\x51\x29\x29\x5A\xF0\xF0\x6E";
    test("a C420 film of limited range: white, black, red and blue");
    write_file("b.y4m", film, sizeof film - 1);
    CHECK(read_frames(&p, &f) == 2, "%s", f.text);
    expect_pixel(&p, 0, 0, 255, 0, 0);
    expect_pixel(&p, 1, 1, 255, 0, 0);
    expect_pixel(&p, 3, 0, 0, 0, 255);
    write_file("b.y4m", film, 45 + 6 + 12);
    CHECK(read_frames(&p, &f) == 1, "%s", f.text);
    expect_pixel(&p, 0, 1, 255, 255, 255);
    expect_pixel(&p, 2, 0, 0, 0, 0);
    picture_free(&p);
}

static void pnm_stream(void) {
    picture p = {0};
    fail f = {""};
    static const char two[] = "P6 # a comment\n2 1\n255\n\1\2\3\4\5\6P5\n1 2 255\n\7\10";
    test("pictures one after the other in a stream are frames");
    write_file("c.ppm", two, sizeof two - 1);
    CHECK(read_frames(&p, &f) == 2, "%s", f.text);
    expect_pixel(&p, 0, 1, 8, 8, 8);
    picture_free(&p);
}

static void refused(void) {
    static const struct {
        const char *bytes, *said;
        size_t count;
    } cases[] = {{"", "is empty", 0},
                 {"hello", "is no Y4M", 5},
                 {"YUV4MPEG2 W0 H2 C444\n", "frames are 0 x 2", 21},
                 {"YUV4MPEG2 W2 H2 C444p10\n", "C444p10 is not known", 24},
                 {"YUV4MPEG2 W4294967298 H2 C444\n", "W4294967298: a side", 30},
                 {"YUV4MPEG2 W2 H-1 C444\n", "H-1: a side", 22},
                 {"YUV4MPEG2 W2 H32769 C444\n", "H32769: a side", 25},
                 {"YUV4MPEG2 W2 H2 F1:999999999 C444\n", "every 999999999 seconds", 34},
                 {"YUV4MPEG2 W2 H2 F1:61 C444\n", "every 61 seconds", 27},
                 {"YUV4MPEG2 W2 H2 F1:60 C444\nFRAM", "inside a frame", 31},
                 {"YUV4MPEG2 W2 H2 C444\nFRAME\nabc", "inside a frame", 30},
                 {"P6 2 2 65535\n", "is no P6 or P5", 13},
                 {"P6 2 2 255\nabc", "before its last pixel", 14},
                 {"\x89PNG\r\n\x1a\n", "is no PNG", 8}};
    test("files that are no pictures are refused with a reason");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        picture p = {0};
        fail f = {""};
        write_file("d", cases[i].bytes, cases[i].count);
        CHECK(read_frames(&p, &f) == -1 && strstr(f.text, cases[i].said), "case %zu: %s", i,
              f.text);
        picture_free(&p);
    }
}

/* Gives chunks the CRCs of what they hold, so that readers look at it. */
static void mend_chunks(uint8_t *png, size_t bytes) {
    size_t at = 8;
    while (at + 12 <= bytes) {
        const size_t count =
            (size_t)png[at] << 24 | png[at + 1] << 16 | png[at + 2] << 8 | png[at + 3];
        if (count > bytes - at - 12) {
            return;
        }
        const uint32_t crc = plt_crc32(0, png + at + 4, count + 4);
        for (unsigned i = 0; i < 4; i++) {
            png[at + 8 + count + i] = (uint8_t)(crc >> (24 - 8 * i));
        }
        at += 12 + count;
    }
}

static void damaged_pngs(void) {
    picture from;
    fail f = {""};
    uint8_t png[4096], bad[4096];
    test("2,000 damaged and cut PNGs: refused or shown, never a fault");
    make_path("e.png");
    picture_make(&from, 20, 12, &f);
    pattern_fill(3, 20, 12, from.rgb);
    output *o = output_open(path, &f);
    picture_begin(o, PICTURE_PNG, 20, 12, 1, &f);
    picture_frame(o, PICTURE_PNG, &from, &f);
    output_commit(o, &f);
    FILE *file = fopen(path, "rb");
    const size_t bytes = file == NULL ? 0 : fread(png, 1, sizeof png, file);
    if (file != NULL) {
        fclose(file);
    }
    CHECK(bytes > 100, "only %zu bytes to damage", bytes);
    uint32_t seed = 1;
    unsigned shown = 0, refused = 0;
    for (unsigned i = 0; bytes > 100 && i < 2000; i++) {
        picture p = {0};
        fail why = {""};
        memcpy(bad, png, bytes);
        for (unsigned k = 0; k < 1 + i % 4; k++) {
            seed = seed * 1664525u + 1013904223u;
            /* not the sizes: gigabytes of black are slow */
            bad[24 + (seed >> 8) % (bytes - 24)] = (uint8_t)(seed >> 24);
        }
        if (i / 4 % 2 == 1) {
            mend_chunks(bad, bytes);
        }
        write_file("e.png", bad, i % 3 == 0 ? i % bytes : bytes);
        const int got = read_frames(&p, &why);
        CHECK(got == 1 || (got == -1 && why.text[0] != '\0'), "%u: %d", i, got);
        shown += got == 1;
        refused += got == -1;
        picture_free(&p);
    }
    CHECK(shown > 100 && refused > 100, "%u shown, %u refused", shown, refused);
    picture_free(&from);
}

int main(void) {
    own_files();
    limited_film();
    pnm_stream();
    refused();
    damaged_pngs();
    return test_done();
}
