/* test_texture - texels, levels and mixtures of textures against double precision; tiles that are
 * fetched; sections that are forged
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "engine/base/rules.h"
#include "engine/planelet_crc32.h"
#include "tests/reference/room.h"
#include "tests/reference/texture_rig.h"
#include "tests/test.h"

enum { SAMPLES = 4000 };

static double wrapped(double x, int clamp) {
    return clamp ? fmin(fmax(x, 0.0), 1.0) : x - floor(x);
}

static uint32_t inside(long i, uint32_t side, int clamp) {
    const long s = (long)side;
    return (uint32_t)(clamp ? (i < 0 ? 0 : i >= s ? s - 1 : i) : (i % s + s) % s);
}

/* The mixture of the four texels around a point, each in light. */
static void mixture(const texture_reference *r, double x, double y, int clamp, double to[3]) {
    const double left = floor(x - 0.5), top = floor(y - 0.5);
    to[0] = to[1] = to[2] = 0.0;
    for (int k = 0; k < 4; k++) {
        const double wx = k % 2 ? x - 0.5 - left : 1 - (x - 0.5 - left);
        const double wy = k / 2 ? y - 0.5 - top : 1 - (y - 0.5 - top);
        double rgb[3];
        texture_reference_texel(r, inside((long)left + k % 2, r->width, clamp),
                                inside((long)top + k / 2, r->height, clamp), rgb);
        for (int c = 0; c < 3; c++) {
            to[c] += wx * wy * texture_reference_light(rgb[c]);
        }
    }
}

/* By the areas of texels: the level whose texel is nearest to a pixel in size. */
static unsigned level_of(double texels, unsigned levels) {
    unsigned level = 0;
    while (level + 1 < levels && texels > 2 * pow(4, level)) {
        level++;
    }
    return level;
}

static void point(const texture_paint *p, const texture_reference *r, const float uv[2], double *x,
                  double *y) {
    const float u = p->scale[0] * uv[0] + p->offset[0], v = p->scale[1] * uv[1] + p->offset[1];
    *x = wrapped((double)u, p->clamp) * r->width;
    *y = r->height - wrapped((double)v, p->clamp) * r->height;
}

static void compare(uint8_t format, uint8_t filter) {
    texture_scene s;
    plt_textures t;
    plt_source source;
    random_state r = {7u + format};
    texture_scene_make(&s, format, 5);
    CHECK(texture_scene_open(&s, &t, &source, NULL, 0) == PLT_OK, "opened");
    t.filter = filter;
    double worst = 0.0;
    for (int i = 0; i < SAMPLES; i++) {
        const uint32_t m = random_below(&r, TEXTURE_PICTURES);
        const texture_paint *p = &s.paint[m];
        const picture *shown = &s.picture[m];
        const float uv[2] = {random_float(&r, -2, 3), random_float(&r, -2, 3)};
        const float area = (float)pow(2.0, (double)random_float(&r, -20, 2));
        const double texels =
            (double)area * fabs((double)(p->scale[0] * p->scale[1])) * shown->width * shown->height;
        const unsigned levels = plt_texture_levels(shown->width, shown->height);
        const texture_reference level = texture_reference_level(&s, m, level_of(texels, levels));
        double x, y, expected[3];
        float light[3];
        CHECK(plt_texture_sample(&t, m, uv, area, light) == PLT_OK, "sampled");
        point(p, &level, uv, &x, &y);
        if (filter == PLT_TEXTURES_NEAREST) {
            if (fabs(x - round(x)) < 0.01 || fabs(y - round(y)) < 0.01) {
                continue; /* between two texels */
            }
            x = floor(x) + 0.5;
            y = floor(y) + 0.5;
        }
        mixture(&level, x, y, p->clamp, expected);
        for (int c = 0; c < 3; c++) {
            const double off = fabs(expected[c] - (double)light[c]);
            worst = off > worst ? off : worst;
        }
    }
    /* A position is off by at most 1/256 of a texel, and by what a float is off at 3 * 70 texels;
     * light by a 65,535th. */
    const double most = filter == PLT_TEXTURES_NEAREST ? 2.0 / 65535 : 2.0 / 256 + 0.001;
    CHECK(worst < most, "off by %g, %g at most", worst, most);
    texture_scene_free(&s);
}

static void samples(void) {
    test("nearest texels are those of the sections, as light, whatever format and level");
    compare(PLT_TEXTURE_RGB565, PLT_TEXTURES_NEAREST);
    compare(PLT_TEXTURE_BLOCKS, PLT_TEXTURES_NEAREST);
    test("bilinear ones are mixtures in light, within what positions are rounded by");
    compare(PLT_TEXTURE_RGB565, PLT_TEXTURES_BILINEAR);
    compare(PLT_TEXTURE_BLOCKS, PLT_TEXTURES_BILINEAR);
}

/* A level in double precision. */
typedef struct exact {
    uint32_t width, height;
    double *light; /* owned */
} exact;

/* The mean of what lies under a part of a level. */
static double area_mean(const exact *l, double x0, double x1, double y0, double y1, int c) {
    double sum = 0.0;
    for (uint32_t y = (uint32_t)y0; y < l->height && y < y1; y++) {
        for (uint32_t x = (uint32_t)x0; x < l->width && x < x1; x++) {
            const double w = fmin(x + 1.0, x1) - fmax(x, x0), h = fmin(y + 1.0, y1) - fmax(y, y0);
            sum += w * h * l->light[3 * (y * l->width + x) + (uint32_t)c];
        }
    }
    return sum / ((x1 - x0) * (y1 - y0));
}

static exact exact_first(const picture *p) {
    exact l = {p->width, p->height, malloc(3 * sizeof(double) * p->width * p->height)};
    for (uint32_t i = 0; i < 3 * p->width * p->height; i++) {
        l.light[i] = texture_reference_light(p->rgb[i]);
    }
    return l;
}

static void halve(exact *l) {
    exact n = {l->width > 1 ? l->width / 2 : 1, l->height > 1 ? l->height / 2 : 1, NULL};
    const double w = (double)l->width / n.width, h = (double)l->height / n.height;
    n.light = malloc(3 * sizeof(double) * n.width * n.height);
    for (uint32_t i = 0; i < 3 * n.width * n.height; i++) {
        const uint32_t x = i / 3 % n.width, y = i / 3 / n.width;
        n.light[i] = area_mean(l, x * w, (x + 1) * w, y * h, (y + 1) * h, (int)(i % 3));
    }
    free(l->light);
    *l = n;
}

static double byte_of(double light) {
    return 255 * (light <= 0.0031308 ? light * 12.92 : 1.055 * pow(light, 1 / 2.4) - 0.055);
}

/* Steps of 5 and 6 bits are 8.2 and 4 of 255, those of bytes before them 1. */
static void check_level(const exact *e, const texture_reference *l) {
    static const double most[3] = {4.7, 2.6, 4.7};
    CHECK(e->width == l->width && e->height == l->height, "sides");
    for (uint32_t i = 0; i < l->width * l->height; i++) {
        double rgb[3];
        texture_reference_texel(l, i % l->width, i / l->width, rgb);
        for (uint32_t c = 0; c < 3; c++) {
            const double byte = byte_of(e->light[3 * i + c]);
            CHECK(fabs(byte - rgb[c]) < most[c], "%u: %g, %g", i, byte, rgb[c]);
        }
    }
}

static void levels(void) {
    texture_scene s;
    test("each level is the mean in linear light of what lies under it, to the nearest 565");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 9);
    for (uint32_t m = 0; m < TEXTURE_PICTURES; m++) {
        exact l = exact_first(&s.picture[m]);
        const unsigned count = plt_texture_levels(l.width, l.height);
        for (unsigned k = 0; k < count; k++) {
            const texture_reference stored = texture_reference_level(&s, m, k);
            check_level(&l, &stored);
            halve(&l);
        }
        free(l.light);
    }
    CHECK(s.stats.psnr > 38 && s.stats.psnr < 50, "%g dB", s.stats.psnr);
    texture_scene_free(&s);
}

static void blocks(void) {
    texture_scene s;
    test("blocks of smooth pictures are near them, and those of noise not far");
    texture_scene_make(&s, PLT_TEXTURE_BLOCKS, 9);
    for (uint32_t m = 0; m < TEXTURE_PICTURES; m++) {
        const picture *p = &s.picture[m];
        const texture_reference l = texture_reference_level(&s, m, 0);
        double squares = 0.0;
        for (uint32_t i = 0; i < p->width * p->height; i++) {
            double rgb[3];
            texture_reference_texel(&l, i % p->width, i / p->width, rgb);
            for (int c = 0; c < 3; c++) {
                squares += pow(rgb[c] - p->rgb[3 * i + c], 2);
            }
        }
        const double off = sqrt(squares / (3.0 * p->width * p->height));
        CHECK(off < (m % 2 == 0 ? 14 : 60), "%u: off by %g of 255", m, off);
    }
    texture_scene_free(&s);
}

/* Odd coordinates: none is a reason to read elsewhere. */
static void odd(void) {
    static const float coordinates[] = {
        0.0f,   -0.0f,    1.0f,      -1.0f, 2.0f, 1e-30f,      -1e-9f,      1e9f,
        -1e30f, INFINITY, -INFINITY, NAN,   0.5f, 16777216.0f, 4194303.75f, 0.99999994f};
    const int count = sizeof coordinates / sizeof coordinates[0];
    texture_scene s;
    plt_textures t;
    plt_source source;
    test("coordinates and areas that are huge, infinite or none give light of 0 .. 1");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 2);
    CHECK(texture_scene_open(&s, &t, &source, NULL, 0) == PLT_OK, "opened");
    for (int i = 0; i < count * count * count; i++) {
        const float uv[2] = {coordinates[i % count], coordinates[i / count % count]};
        for (uint32_t m = 0; m < LIT_MATERIALS + 3; m++) {
            float light[3] = {-1, -1, -1};
            t.filter = (uint8_t)(1 + (i + m) % 2);
            CHECK(plt_texture_sample(&t, m, uv, coordinates[i / count / count], light) == PLT_OK,
                  "sampled");
            for (int c = 0; c < 3; c++) {
                CHECK(light[c] >= 0 && light[c] <= 1, "%g", (double)light[c]);
                CHECK(light[c] == 1 || m < TEXTURE_PICTURES, "%g without texture",
                      (double)light[c]);
            }
        }
    }
    test("a picture's upper left pixel is at u 0 and v 1");
    const texture_reference l = texture_reference_level(&s, 0, 0);
    const float corner[2] = {0.5f / 64, 1 - 0.5f / 64};
    float light[3];
    double rgb[3];
    t.filter = PLT_TEXTURES_BILINEAR;
    texture_reference_texel(&l, 0, 0, rgb);
    CHECK(plt_texture_sample(&t, 0, corner, 0, light) == PLT_OK, "sampled");
    for (int c = 0; c < 3; c++) {
        CHECK(fabs((double)light[c] - texture_reference_light(rgb[c])) < 1e-4, "%d", c);
    }
    texture_scene_free(&s);
}

/* ---- tiles that are fetched -------------------------------------------------------------- */

static uint64_t hash_of(plt_textures *t, int *status) {
    random_state r = {11};
    uint64_t hash = 0;
    *status = PLT_OK;
    for (int i = 0; i < SAMPLES && *status == PLT_OK; i++) {
        const float uv[2] = {random_float(&r, -1, 2), random_float(&r, -1, 2)};
        float light[3] = {0, 0, 0};
        *status = plt_texture_sample(t, random_below(&r, TEXTURE_PICTURES), uv,
                                     random_float(&r, 0, 0.01f), light);
        hash = hash * 31 + plt_crc32(0, light, sizeof light);
    }
    return hash;
}

static void rooms(void) {
    texture_scene s;
    plt_textures t;
    plt_source source;
    int status;
    test("tiles that are fetched to a room of any size give what mapped ones do");
    texture_scene_make(&s, PLT_TEXTURE_BLOCKS, 3);
    CHECK(texture_scene_open(&s, &t, &source, NULL, 0) == PLT_OK, "opened");
    const uint64_t mapped = hash_of(&t, &status);
    CHECK(t.tiles.stats.fetched == 0 && t.tiles.stats.found == 0, "nothing is fetched");
    uint64_t before = UINT64_MAX;
    for (uint32_t slots = 1; slots < 100; slots = 2 * slots + 1) {
        const uint32_t bytes = slots * PLT_TEXTURE_LEAST + (slots > 4 ? 100 : 0);
        void *room = room_get(bytes);
        CHECK(texture_scene_open(&s, &t, &source, room, bytes) == PLT_OK, "opened");
        CHECK(hash_of(&t, &status) == mapped && status == PLT_OK, "%u slots", slots);
        CHECK(t.tiles.stats.fetched > 0 && t.tiles.stats.fetched < before, "%u slots: %llu", slots,
              (unsigned long long)t.tiles.stats.fetched);
        CHECK(t.tiles.stats.bytes_fetched == 132 * t.tiles.stats.fetched, "bytes");
        before = t.tiles.stats.fetched;
        free(room);
    }
    CHECK(before <= s.tile_bytes / 132, "%llu tiles fetched of %u", (unsigned long long)before,
          s.tile_bytes / 132);
    texture_scene_free(&s);
}

static struct {
    const unsigned char *image;
    uint32_t starts, fails_at, times, flips; /* flips: a bit of the bytes, in place of failing */
} faulty;

static int start_faulty(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    (void)context;
    (void)tag;
    const uint32_t now = faulty.starts++;
    const int is_due = now >= faulty.fails_at && now < faulty.fails_at + faulty.times;
    memcpy(to, faulty.image + offset, count);
    if (is_due && faulty.flips > 0) {
        ((unsigned char *)to)[(faulty.flips - 1) / 8 % count] ^=
            (unsigned char)(1u << faulty.flips % 8);
        return 0;
    }
    return is_due ? -1 : 0;
}

static int try_faulty(const texture_scene *s, plt_textures *t, uint32_t fails_at, uint32_t times,
                      uint32_t flips) {
    static unsigned char room[8 * PLT_TEXTURE_LEAST] __attribute__((aligned(8)));
    plt_source source;
    int status;
    faulty.image = s->image.bytes;
    faulty.starts = 0;
    faulty.fails_at = fails_at;
    faulty.times = times;
    faulty.flips = flips;
    CHECK(texture_scene_open(s, t, &source, room, sizeof room) == PLT_OK, "opened");
    source.start = start_faulty;
    hash_of(t, &status);
    return status;
}

static void faults(void) {
    texture_scene s;
    plt_textures t;
    test("a tile that comes wrong or not at all comes again, and if it stays so is an error");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 3);
    for (uint32_t at = 0; at < 40; at++) {
        const uint32_t least = PLT_TRANSFER_BYTES < 132 ? 132 / PLT_TRANSFER_BYTES : 0;
        CHECK(try_faulty(&s, &t, at, 1, 0) == PLT_OK && t.tiles.stats.retries == 1, "late");
        CHECK(try_faulty(&s, &t, at, 1, 1 + at * 27) == PLT_OK && t.tiles.stats.retries == 1,
              "flipped");
        CHECK(try_faulty(&s, &t, at, 1000 + least, 0) == PLT_ERR_SOURCE && t.tiles.failed, "never");
        const int status = try_faulty(&s, &t, at, 1000 + least, 1 + at * 27);
        CHECK(status == PLT_ERR_IMAGE && t.tiles.failed && t.tiles.fault.kind == 'I' &&
                  t.tiles.fault.rule == PLT_I30_TILES &&
                  (t.tiles.fault.offset - s.tiles_at) % 132 == 0,
              "%d", status);
    }
    test("the check of a tile is of its number, too: another's is refused");
    unsigned char *tiles = s.image.bytes + s.tiles_at, tile[132];
    memcpy(tile, tiles, sizeof tile);
    memmove(tiles, tiles + 132, 66 * 132);
    memcpy(tiles + 66 * 132, tile, sizeof tile);
    CHECK(try_faulty(&s, &t, 0, 0, 0) == PLT_ERR_IMAGE, "exchanged");
    texture_scene_free(&s);
}

/* ---- sections that are forged ------------------------------------------------------------ */

static void forge(const texture_scene *s, uint32_t at, uint32_t value, uint32_t fault_at,
                  const char *what) {
    unsigned char *word = s->image.bytes + s->at + at;
    const uint32_t was = plt_get_u32(word);
    plt_directory d;
    plt_fault fault = {.message = ""};
    plt_put_u32(word, value);
    const int status =
        plt_directory_read(&d, s->image.bytes + s->at, s->bytes, s->tile_bytes, 1000, &fault);
    CHECK(status == PLT_ERR_IMAGE && fault.kind == 'R' && fault.rule == PLT_R20_TEXTURES &&
              fault.offset == 1000 + fault_at,
          "%s %x at %u: %d, %c%u at %u", what, value, at, status, fault.kind, fault.rule,
          fault.offset);
    plt_put_u32(word, was);
}

static void forged(void) {
    texture_scene s;
    test("counts, sides, levels, formats and tiles that are not as they must be are refused (R20)");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 3);
    for (uint32_t at = 0; at < 16; at += 4) {
        const uint32_t is = plt_get_u32(s.image.bytes + s.at + at);
        const uint32_t fault_at = 0;
        forge(&s, at, is + 0x01000000u, fault_at, "head");
        forge(&s, at, 0xFFFFFFFFu, fault_at, "head");
        if (at < 12) {
            forge(&s, at, 0, fault_at, "head");
        }
    }
    forge(&s, 8, plt_get_u32(s.image.bytes + s.at + 8) + 1, 0, "tiles");
    for (uint32_t i = 0; i < TEXTURE_PICTURES; i++) {
        const uint32_t at = 16 + 12 * i;
        const uint32_t sides = plt_get_u32(s.image.bytes + s.at + at),
                       rest = plt_get_u32(s.image.bytes + s.at + at + 4),
                       first = plt_get_u32(s.image.bytes + s.at + at + 8);
        forge(&s, at, sides & 0xFFFF0000u, at, "width");
        forge(&s, at, sides & 0xFFFFu, at, "height");
        forge(&s, at, (sides & 0xFFFFu) | 0x40010000u, at, "height");
        forge(&s, at, (sides & 0xFFFF0000u) | 0x4001u, at, "width");
        forge(&s, at + 4, rest & ~255u, at, "levels");
        forge(&s, at + 4, rest + 1, at, "levels");
        forge(&s, at + 4, rest | 0x200u, at, "format");
        forge(&s, at + 4, rest | 0x10000u, at, "reserved");
        forge(&s, at + 4, rest | 0x80000000u, at, "reserved");
        forge(&s, at + 8, first + 1, at, "first");
    }
    test("a material's texture that is not there, a flag or number out of range is refused (R20)");
    for (uint32_t i = 0; i <= LIT_MATERIALS; i++) {
        const uint32_t at = 16 + 12 * TEXTURE_PICTURES + 20 * i;
        const uint32_t word = plt_get_u32(s.image.bytes + s.at + at);
        forge(&s, at, (word & ~255u) | (TEXTURE_PICTURES + 1), at, "texture");
        forge(&s, at, word | 0x200u, at, "clamp");
        forge(&s, at, word | 0x10000u, at, "reserved");
        for (uint32_t k = 4; k < 20; k += 4) {
            const float wrong[4] = {NAN, INFINITY, nextafterf(65536, 1e30f), -65537};
            for (int w = 0; w < 4; w++) {
                forge(&s, at + k, plt_bits_of(wrong[w]), at, "number");
            }
        }
    }
    test("a section of another length is refused, and one whose tiles are");
    plt_directory d;
    plt_fault fault;
    const unsigned char *section = s.image.bytes + s.at;
    CHECK(plt_directory_read(&d, section, s.bytes + 64, s.tile_bytes, 0, &fault) == PLT_ERR_IMAGE,
          "longer");
    CHECK(plt_directory_read(&d, section, s.bytes, s.tile_bytes + 64, 0, &fault) == PLT_ERR_IMAGE,
          "more tiles");
    CHECK(plt_directory_read(&d, section, s.bytes, 0, 0, &fault) == PLT_ERR_IMAGE, "no tiles");
    texture_scene_free(&s);
}

int main(void) {
    samples();
    levels();
    blocks();
    odd();
    rooms();
    faults();
    forged();
    return test_done();
}
