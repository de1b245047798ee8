/* test_picture_difference [OURS.ppm THEIRS.ppm DIFFERENCE.png MOST] - two pictures of one scene
 *
 * Prints the mean difference of 8-bit values over all pixels, and over those that are apart from
 * edges: pixels around which neither picture has a step. Of those it may be at most MOST. The
 * difference is written as a picture, 16 times as bright. Without arguments it compares
 * two that it makes.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/base/input.h"
#include "host_tools/picture/picture_file.h"
#include "tests/test.h"

/* Of 8-bit values between neighbours: more is an edge. */
enum { STEP = 12, BRIGHTER = 16 };

typedef struct difference {
    double all, inside; /* mean, of 8-bit values */
    double share;       /* pixels apart from edges */
    unsigned greatest;  /* of those */
} difference;

/* A number of the head of a picture, behind blanks and comments. */
static const char *head_number(const char *at, unsigned *to) {
    char *end;
    for (; *at == ' ' || *at == '\n' || *at == '#'; at++) {
        at += *at == '#' ? strcspn(at, "\n") : 0;
    }
    *to = (unsigned)strtoul(at, &end, 10);
    return end;
}

static int read_ppm(picture *p, const char *path) {
    input in = {0};
    fail f = {0};
    unsigned width = 0, height = 0, most = 0;
    int good = input_read(&in, path, &f) == 0 && in.size > 2 && memcmp(in.bytes, "P6", 2) == 0;
    CHECK(good, "%s is no P6 picture. %s", path, f.text);
    if (good) {
        const char *text = (const char *)in.bytes;
        const char *at = head_number(head_number(head_number(text + 2, &width), &height), &most);
        good = most == 255 && picture_check_size(width, height, &f) == 0 &&
               in.size == (size_t)(at + 1 - text) + (size_t)3 * width * height &&
               picture_make(p, width, height, &f) == 0;
        CHECK(good, "%s is no picture of 8 bits. %s", path, f.text);
        if (good) {
            memcpy(p->rgb, at + 1, (size_t)3 * width * height);
        }
    }
    input_free(&in);
    return good;
}

static const uint8_t *pixel(const picture *p, unsigned x, unsigned y) {
    return &p->rgb[3 * ((size_t)y * p->width + x)];
}

static unsigned apart(uint8_t a, uint8_t b) {
    return a > b ? (unsigned)(a - b) : (unsigned)(b - a);
}

/* Does a pixel, or one beside it, differ by a step from its neighbours? The border is an edge. */
static int is_edge(const picture *p, unsigned x, unsigned y) {
    if (x < 1 || y < 1 || x + 1 >= p->width || y + 1 >= p->height) {
        return 1;
    }
    for (unsigned k = 0; k < 9; k++) {
        for (unsigned c = 0; c < 3; c++) {
            if (apart(pixel(p, x + k % 3 - 1, y + k / 3 - 1)[c], pixel(p, x, y)[c]) > STEP) {
                return 1;
            }
        }
    }
    return 0;
}

static difference compare(const picture *a, const picture *b, picture *to) {
    difference d = {0};
    uint64_t all = 0, inside = 0, pixels = 0;
    for (unsigned y = 0; y < a->height; y++) {
        for (unsigned x = 0; x < a->width; x++) {
            const int edge = is_edge(a, x, y) || is_edge(b, x, y);
            pixels += !edge;
            for (unsigned c = 0; c < 3; c++) {
                const unsigned by = apart(pixel(a, x, y)[c], pixel(b, x, y)[c]);
                const unsigned bright = by * BRIGHTER;
                all += by;
                inside += edge ? 0 : by;
                d.greatest = !edge && by > d.greatest ? by : d.greatest;
                to->rgb[3 * ((size_t)y * a->width + x) + c] =
                    (uint8_t)(bright < 255 ? bright : 255);
            }
        }
    }
    const double values = 3.0 * a->width * a->height;
    d.all = (double)all / values;
    d.inside = pixels > 0 ? (double)inside / (3.0 * (double)pixels) : 0.0;
    d.share = 3.0 * (double)pixels / values;
    return d;
}

static void write_png(const picture *p, const char *path) {
    fail f = {0};
    output *o = output_open(path, &f);
    CHECK(o != NULL && picture_begin(o, PICTURE_PNG, p->width, p->height, 1, &f) == 0 &&
              picture_frame(o, PICTURE_PNG, p, &f) == 0,
          "%s", f.text);
    CHECK(o != NULL && output_commit(o, &f) == 0, "%s", f.text);
}

static void compare_files(char **path, double most) {
    picture a = {0}, b = {0}, to = {0};
    fail f = {0};
    test("both pictures show the same, edges apart");
    if (read_ppm(&a, path[0]) && read_ppm(&b, path[1])) {
        CHECK(a.width == b.width && a.height == b.height, "sizes differ");
        if (a.width == b.width && a.height == b.height &&
            picture_make(&to, a.width, a.height, &f) == 0) {
            const difference d = compare(&a, &b, &to);
            printf(
                "    mean difference in 8-bit sRGB %.3f, of all pixels %.3f; %.1f %% are apart "
                "from edges, where the greatest is %u\n",
                d.inside, d.all, 100.0 * d.share, d.greatest);
            CHECK(d.share > 0.3, "hardly a pixel is apart from edges");
            CHECK(d.inside <= most, "%.3f is more than %.3f", d.inside, most);
            write_png(&to, path[2]);
        }
    }
    picture_free(&a);
    picture_free(&b);
    picture_free(&to);
}

/* A grey field with a white square; `by` more in every pixel, and the square `beside` pixels on. */
static void paint(picture *p, unsigned by, unsigned beside) {
    for (unsigned y = 0; y < p->height; y++) {
        for (unsigned x = 0; x < p->width; x++) {
            const int in = x >= 8 + beside && x < 16 + beside && y >= 8 && y < 16;
            memset(&p->rgb[3 * ((size_t)y * p->width + x)], (int)((in ? 200u : 100u) + by), 3);
        }
    }
}

static void compare_made(void) {
    picture a = {0}, b = {0}, to = {0};
    fail f = {0};
    test("edges do not count, what is between them does");
    CHECK(picture_make(&a, 32, 32, &f) == 0 && picture_make(&b, 32, 32, &f) == 0 &&
              picture_make(&to, 32, 32, &f) == 0,
          "%s", f.text);
    paint(&a, 0, 0);
    paint(&b, 0, 1);
    const difference moved = compare(&a, &b, &to);
    CHECK(moved.inside == 0.0 && moved.greatest == 0, "%g", moved.inside);
    CHECK(moved.all == 16.0 * 100.0 / 1024.0, "%g", moved.all);
    paint(&b, 5, 0);
    const difference brighter = compare(&a, &b, &to);
    CHECK(brighter.inside == 5.0 && brighter.greatest == 5, "%g", brighter.inside);
    CHECK(brighter.share > 0.5 && brighter.share < 1.0, "%g", brighter.share);
    CHECK(to.rgb[3 * (32 * 2 + 2)] == 80, "five times sixteen");
    picture_free(&a);
    picture_free(&b);
    picture_free(&to);
}

int main(int argc, char **argv) {
    if (argc == 5) {
        compare_files(argv + 1, atof(argv[4]));
    } else {
        compare_made();
    }
    return test_done();
}
