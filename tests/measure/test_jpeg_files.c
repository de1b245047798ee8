/* test_jpeg_files [FOLDER SIDE | PICTURE.png TIMES | SAMPLING] - JPEG files for other decoders, and
 * their cost
 *
 * With a folder: writes a picture of each size up to SIDE x SIDE in every sampling, by turns of all
 * qualities, as WIDTHxHEIGHT-SAMPLING.jpg. With a picture: encodes it TIMES times and prints what a
 * pixel costs, and the size in each sampling at qualities 50, 75 and 90. With a sampling, 0 to 2,
 * it encodes what tests/boards/jpeg.c does, and prints its hash. Without arguments it encodes a
 * picture that it makes.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>

#include "host_tools/base/clock.h"
#include "host_tools/base/input.h"
#include "host_tools/picture/jpeg.h"
#include "host_tools/picture/png.h"
#include "tests/boards/jpeg_picture.h"
#include "tests/test.h"

static const char *const names[JPEG_SAMPLINGS] = {"444", "422", "420"};

static int save(const char *path, const uint8_t *bytes, size_t count) {
    FILE *file = fopen(path, "wb");
    const int good = file != NULL && fwrite(bytes, 1, count, file) == count;
    return file != NULL && fclose(file) == 0 && good;
}

static void all_sizes(const char *folder, unsigned side) {
    test("every size and sampling is written");
    for (unsigned i = 0; i < side * side * JPEG_SAMPLINGS; i++) {
        const unsigned width = 1 + i % side, height = 1 + i / side % side, s = i / side / side;
        char path[1024];
        picture p = {0};
        fail f = {0};
        if (picture_make(&p, width, height, &f) != 0) {
            CHECK(0, "%ux%u", width, height);
            return;
        }
        for (unsigned k = 0; k < 3 * width * height; k++) {
            p.rgb[k] = (uint8_t)(k * 7 + k / width * (5 + k % 3 * 9));
        }
        const size_t most = jpeg_most(width, height);
        uint8_t *file = malloc(most);
        const size_t bytes = jpeg_write(&p, (jpeg_sampling)s, 1 + i % 100, file, most);
        snprintf(path, sizeof path, "%s/%ux%u-%s.jpg", folder, width, height, names[s]);
        CHECK(bytes <= most && save(path, file, bytes), "%s", path);
        free(file);
        picture_free(&p);
    }
}

static void costs(const picture *p, unsigned times) {
    static const unsigned qualities[] = {50, 75, 90};
    const size_t most = jpeg_most(p->width, p->height);
    uint8_t *file = malloc(most);
    test("the picture is encoded");
    for (unsigned s = 0; s < JPEG_SAMPLINGS; s++) {
        for (unsigned q = 0; q < 3; q++) {
            size_t bytes = 0;
            double best = 1e9;
            for (unsigned i = 0; i < times; i++) {
                const double began = clock_processor_seconds();
                bytes = jpeg_write(p, (jpeg_sampling)s, qualities[q], file, most);
                const double took = clock_processor_seconds() - began;
                best = took < best ? took : best;
            }
            CHECK(bytes <= most, "%zu", bytes);
            printf("    %s quality %u: %zu bytes, %.1f ns per pixel\n", names[s], qualities[q],
                   bytes, best * 1e9 / p->width / p->height);
        }
    }
    free(file);
}

/* For a tool that counts instructions of jpeg_write. */
static void as_boards_do(jpeg_sampling sampling) {
    static uint8_t rgb[3 * JPEG_PICTURE_SIDE * JPEG_PICTURE_SIDE], file[sizeof rgb];
    const picture p = {rgb, JPEG_PICTURE_SIDE, JPEG_PICTURE_SIDE};
    test("the picture of boards is encoded");
    jpeg_picture_fill(rgb);
    const size_t bytes = jpeg_write(&p, sampling, JPEG_PICTURE_QUALITY, file, sizeof file);
    CHECK(bytes <= sizeof file, "%zu", bytes);
    printf("hash %08x\n", (unsigned)jpeg_picture_hash(file, bytes));
}

int main(int argc, char **argv) {
    picture p = {0};
    fail f = {0};
    input in = {0};
    if (argc == 3 && strtoul(argv[2], NULL, 10) > 0 && strstr(argv[1], ".png") == NULL) {
        all_sizes(argv[1], (unsigned)strtoul(argv[2], NULL, 10));
        return test_done();
    }
    if (argc == 2) {
        as_boards_do((jpeg_sampling)(argv[1][0] - '0'));
        return test_done();
    }
    if (argc == 3) {
        if (input_read(&in, argv[1], &f) != 0 ||
            png_read(&p, in.bytes, in.size, argv[1], &f) != 0) {
            fprintf(stderr, "test_jpeg_files: %s\n", f.text);
            return 1;
        }
    } else if (picture_make(&p, 320, 240, &f) != 0) {
        return 1;
    }
    costs(&p, argc == 3 ? (unsigned)strtoul(argv[2], NULL, 10) : 1);
    picture_free(&p);
    input_free(&in);
    return test_done();
}
