/* test_opening_loops - the loops over all bytes of an image that is opened: checksums, ranges
 *
 * Both are written for few instructions; here they are compared with what they mean.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/between.h"
#include "engine/base/crc32_long.h"
#include "engine/engine.h"
#include "engine/planelet_crc32.h"
#include "tests/hostile/images.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/random.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* Bit by bit, as in ISO 3309. */
static uint32_t crc_by_bits(const unsigned char *bytes, size_t count) {
    uint32_t crc = UINT32_MAX;
    for (size_t i = 0; i < count; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0);
        }
    }
    return ~crc;
}

enum { BYTES = 40000, SCRATCH = 3000, GUARD = 0x5A5A5A5A };

static unsigned char bytes[BYTES];

static void short_sums(void) {
    CHECK(plt_crc32(0, "123456789", 9) == 0xCBF43926u, "%08x", plt_crc32(0, "123456789", 9));
    for (size_t from = 0; from < 8; from++) {
        for (size_t count = 0; count < 70; count++) {
            const size_t half = count / 3;
            const uint32_t crc = crc_by_bits(bytes + from, count);
            CHECK(plt_crc32(0, bytes + from, count) == crc, "%zu bytes", count);
            CHECK(plt_crc32(plt_crc32(0, bytes + from, half), bytes + from + half, count - half) ==
                      crc,
                  "%zu bytes in two", count);
        }
    }
}

/* Of `words` of scratch, on whose contents nothing depends and behind which nothing is written. */
static void long_sum(size_t from, size_t count, size_t words) {
    static uint32_t scratch[SCRATCH + 1];
    for (size_t i = 0; i <= words; i++) {
        scratch[i] = GUARD;
    }
    CHECK(plt_crc32_long(bytes + from, count, scratch, words) == crc_by_bits(bytes + from, count),
          "%zu bytes from %zu, %zu words", count, from, words);
    CHECK(scratch[words] == GUARD, "%zu words", words);
}

static void long_sums(void) {
    random_state r = {1};
    long_sum(0, 0, 0);
    for (size_t count = 4780; count < 4820; count++) { /* where it begins */
        long_sum(count % 5, count, 512 + count % 3);
    }
    for (size_t words = 450; words < 600; words++) {
        long_sum(0, 9000 + words % 17, words);
    }
    for (int i = 0; i < 300; i++) {
        long_sum(random_below(&r, 16), random_below(&r, BYTES - 16), random_below(&r, SCRATCH));
    }
}

/* ---- whether opening has scratch for the fast sum ------------------------------------- */

enum { SCRATCH_LEAST = 455 * 4, LONG = 4800 };

static uint32_t sums_tried;

/* In an arena of exactly the need, of whose bytes none is written but the engine, a copy of the
 * section and scratch: its sum is wrong, and nothing else is done. With tiny limits what runs later
 * may be too little for scratch. */
static void sum_is_long(const char *name, const packed *image, unsigned char *copy,
                        uint32_t section_bytes, unsigned packet_side, int mapped) {
    const plt_options options = {.packet_side = (uint8_t)packet_side};
    const size_t need = plt_arena_need(&image->info, mapped, &options);
    hostile_stream stream = {copy, (uint32_t)image->size, 0};
    const plt_source source = {mapped ? copy : NULL, (uint32_t)image->size, &stream, hostile_start,
                               hostile_wait};
    const size_t from =
        plt_arena_cut_bytes(sizeof(plt_engine)) +
        (mapped && image->info.build != PLT_BUILD_DEVICE ? 0 : plt_arena_cut_bytes(section_bytes));
    unsigned char *arena = aligned_alloc(PLT_ALIGN, need);
    plt_engine *engine;
    plt_fault fault;
    uint32_t written = 0;
    memset(arena, 0x5A, need);
    const int status = plt_open(&engine, arena, need, &source, &options, &fault);
    for (size_t i = from; i < need; i++) {
        written += arena[i] != 0x5A;
    }
    CHECK(status == PLT_ERR_IMAGE && fault.rule == 13, "%s: %s", name, fault.message);
    CHECK(rig_is_tiny() || written > SCRATCH_LEAST / 2,
          "%s, mapped %d, packets of %u: %u bytes are written", name, mapped, packet_side, written);
    sums_tried++;
    free(arena);
}

static void sums_are_long(const char *name, packed *image) {
    static const uint8_t sides[] = {0, 2, 4, 8, 16};
    unsigned char *copy = aligned_alloc(64, (image->size + 63) / 64 * 64);
    memcpy(copy, image->bytes, image->size);
    unsigned char *section = copy + HOSTILE_SECTION; /* the first that is not empty */
    section += plt_get_u32(section + 8) == 0 ? 16 : 0;
    const uint32_t section_bytes = plt_get_u32(section + 8);
    section[12] ^= 1;
    hostile_seal_header(copy, (uint32_t)image->size);
    for (unsigned i = 0; i < 2 * sizeof sides; i++) {
        if (sides[i / 2] <= PLT_PACKET_SIDE_MAX && section_bytes >= LONG) {
            sum_is_long(name, image, copy, section_bytes, sides[i / 2], (int)(i & 1));
        }
    }
    free(copy);
    pack_free(image);
}

static packed thesis_image(uint32_t triangles, uint8_t build) {
    const pack_options options = {PLT_SPLIT_SAH, build, 2, 8, NULL, 0, NULL, 0, 0};
    packed image = {.size = 0};
    fail f = {""};
    mesh m = {0};
    shape_soup(&m, triangles, 0.1f, 1);
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

static void scratch_of_openings(void) {
    compact_config config = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    mesh m = {0};
    packed list = thesis_image(300, PLT_BUILD_NONE);
    packed nodes = thesis_image(rig_triangles(1000, 2), PLT_BUILD_HOST);
    packed device = thesis_image(rig_triangles(1000, 2), PLT_BUILD_DEVICE);
    sums_are_long("a list", &list);
    sums_are_long("thesis nodes", &nodes);
    sums_are_long("thesis nodes, built here", &device);
    shape_soup(&m, compact_triangles(1000, 2), 0.1f, 1);
    packed blocks = compact_packed(&m, &config);
    sums_are_long("compact blocks", &blocks);
    CHECK(sums_tried >= (rig_is_tiny() ? 4 : 40), "%u sums", sums_tried);
}

static void one_range(float lo, float hi, float x) {
    const float l[3] = {lo, hi, lo}, h[3] = {hi, lo, hi};
    plt_between b[3];
    uint32_t bits;
    plt_between_set(b, l, h);
    plt_put_float(&bits, x);
    CHECK(plt_is_between(&b[0], &bits) == (lo <= x && x <= hi) || (x == 0.0f && !(lo <= hi)),
          "%a in %a .. %a", (double)x, (double)lo, (double)hi);
    CHECK(plt_is_between(&b[1], &bits) == (hi <= x && x <= lo) || (x == 0.0f && !(hi <= lo)),
          "%a in %a .. %a", (double)x, (double)hi, (double)lo);
}

static float any_float(random_state *r) {
    const uint32_t bits = random_below(r, 0x10000) << 16 | random_below(r, 0x10000);
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static void ranges(void) {
    static const float odd[] = {0.0f,       -0.0f,     1.0f,     -1.0f,           0x1p-149f,
                                -0x1p-149f, 0x1p40f,   -0x1p40f, 1.00000012f,     INFINITY,
                                -INFINITY,  NAN,       -NAN,     0x1.fffffep127f, 0x1p-126f,
                                -0x1p-126f, -2.00002f, 3e-3f,    -0x1.fffffep127f};
    enum { ODD = sizeof odd / sizeof *odd };
    random_state r = {2};
    for (int i = 0; i < ODD * ODD * ODD; i++) {
        one_range(odd[i % ODD], odd[i / ODD % ODD], odd[i / ODD / ODD]);
    }
    for (int i = 0; i < 100000; i++) {
        one_range(any_float(&r), any_float(&r), any_float(&r));
    }
}

int main(void) {
    random_state r = {3};
    for (int i = 0; i < BYTES; i++) {
        bytes[i] = (unsigned char)random_below(&r, 256);
    }
    test("the CRC-32 is that of ISO 3309, at any address, in one piece or two");
    short_sums();
    test("... of many bytes, whatever the scratch: the same, and no more scratch is used");
    long_sums();
    test("opening has the scratch for it in any arena that is large enough, of any packets");
    scratch_of_openings();
    test("floats are in a range by their bits where they are as floats; a NaN never");
    ranges();
    return test_done();
}
