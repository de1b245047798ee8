/* test_image_rules - each refusal of SPEC.md, section 5.1, by rule and offset
 *
 * A valid image with one thing changed and its checksums made right, so that no earlier rule
 * refuses it; the CRC's check value; and a header by hand.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/header.h"
#include "tests/hostile/images.h"
#include "tests/reference/rig.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

static packed image;

static void make_image(void) {
    mesh m = {0};
    fail f = {""};
    const pack_options options = {PLT_SPLIT_SAH, PLT_BUILD_HOST, 1, 3, NULL, 0, NULL, 0, 0};
    shape_soup(&m, 20, 0.8f, 1);
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    mesh_free(&m);
}

typedef struct change {
    uint32_t at, value;
    unsigned bytes; /* 1 or 4 */
    unsigned rule, offset;
} change;

#define NAN_BITS 0x7FC00000u
#define TWO_40 0x53800000u /* 2^40 as a float */

/* In the order of the rules. `offset` as in the specification's table. */
static const change changes[] = {
    {0, 'Q', 1, 2, 0},
    {7, 't', 1, 2, 0},
    {8, 0, 1, 3, 8},
    {8, 2, 1, 3, 8},
    {9, 1, 1, 3, 8},
    {12, 255, 4, 4, 12},
    {12, 0, 4, 4, 12},
    {16, 0xFFFFFFFF, 4, 6, 16},
    {24, 1u << 27, 4, 7, 24},
    {28, 0x7FFFFFFF, 4, 7, 24},
    {32, 1u << 27, 4, 7, 24},
    {48, 0, 4, 7, 24},
    {48, 1u << 27, 4, 7, 24},
    {48, 1000, 4, 7, 24},
    {52, 0, 4, 7, 24},
    {96, 2, 1, 8, 96},
    {98, 1, 1, 14, 168},
    {98, 2, 1, 8, 96},
    {99, 1, 1, 8, 96},
    {72, NAN_BITS, 4, 9, 72},
    {80, NAN_BITS, 4, 9, 72},
    {84, NAN_BITS, 4, 9, 72},
    {92, TWO_40 + 1, 4, 9, 72},
    {76, (TWO_40 + 1) | 0x80000000u, 4, 9, 72},
    {72, 0x7F800000, 4, 9, 72},
    {88, 0xFF800000, 4, 9, 72},
    {100, 1, 4, 10, 100},
    {100, 4, 4, 10, 100},
    {100, 3, 4, 11, 120}, /* with checks records come in whole pages */
    {104, 2, 4, 11, 104},
    {108, 255, 4, 11, 104},
    {112, 0, 4, 11, 104},
    {112, 0xFFFFFFC0, 4, 11, 104},
    {120, 1, 4, 11, 120},
    {124, 256, 4, 11, 120},
    {128, 0, 4, 11, 120},
    {136, 1, 1, 12, 136},
    {200, 0x80, 1, 12, 200},
    {216, 5, 4, 12, 216},
    {228, 8, 4, 17, 228},
    {231, 1, 1, 17, 228},
    {228, 1, 4, 17, 16}, /* there is no table behind */
};

static hostile_result changed(const change *c) {
    const hostile_config config = {(uint8_t)(c->at & 1), 0, 2, 0};
    unsigned char *bytes = room_get(image.size);
    memcpy(bytes, image.bytes, image.size);
    if (c->bytes == 1) {
        bytes[c->at] = (unsigned char)c->value;
    } else {
        plt_put_u32(bytes + c->at, c->value);
    }
    hostile_seal_header(bytes, image.size);
    const hostile_result r = hostile_try(bytes, image.size, config);
    free(bytes);
    return r;
}

static void every_change(void) {
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        const change *c = &changes[i];
        const hostile_result r = changed(c);
        CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == 'R' && r.fault.rule == c->rule,
              "byte %u = %x: status %d, %c%u, not R%u (%s)", c->at, c->value, r.status,
              r.fault.kind ? r.fault.kind : '-', r.fault.rule, c->rule, r.fault.message);
        CHECK(r.fault.offset == c->offset, "byte %u: offset %u, not %u", c->at, r.fault.offset,
              c->offset);
    }
}

static void refused(const unsigned char *bytes, uint32_t size, unsigned rule, uint32_t offset) {
    for (uint8_t streamed = 0; streamed < 2; streamed++) {
        const hostile_config config = {streamed, 0, 2, 0};
        const hostile_result r = hostile_try(bytes, size, config);
        CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == 'R' && r.fault.rule == rule &&
                  r.fault.offset == offset,
              "status %d, rule %u at %u, not %u at %u", r.status, r.fault.rule, r.fault.offset,
              rule, offset);
    }
}

static void sizes_and_checksums(void) {
    unsigned char *bytes = room_get(image.size);
    memcpy(bytes, image.bytes, image.size);
    refused(bytes, 255, 1, 255);
    refused(bytes, 0, 1, 0);
    refused(bytes, image.size - 1, 6, 16);
    bytes[20] ^= 1;
    refused(bytes, image.size, 5, 20);
    bytes[20] ^= 1;
    bytes[256] ^= 1;
    refused(bytes, image.size, 13, 256);
    bytes[256] ^= 1;
    bytes[image.size - 1] ^= 1; /* padding */
    refused(bytes, image.size, 13, 256 + image.info.node_bytes);
    free(bytes);
    /* The sections are valid, but something follows them. */
    unsigned char *longer = room_get(image.size + 64);
    memcpy(longer, image.bytes, image.size);
    memset(longer + image.size, 0, 64);
    plt_put_u32(longer + 16, image.size + 64);
    hostile_seal_header(longer, image.size + 64);
    refused(longer, image.size + 64, 11, 16);
    free(longer);
}

/* The minor version is information, and so is the shift. */
static void tolerated(void) {
    const change minor = {10, 7, 1, 0, 0}, minor_high = {11, 1, 1, 0, 0};
    CHECK(changed(&minor).status == PLT_OK && changed(&minor_high).status == PLT_OK,
          "a minor version is refused");
    for (uint32_t at = 232; at < 256; at += 4) {
        const change shift = {at, 0xFFFFFFFF, 4, 0, 0}; /* NaN, too */
        CHECK(changed(&shift).status == PLT_OK, "a shift is refused at %u", at);
    }
    const change larger_k = {52, 9, 4, 0, 0};
    CHECK(changed(&larger_k).status == PLT_OK, "K above the longest list is refused");
}

/* Of the section of checks, and of what a builder has yet to build. */
static void checked(void) {
    static const change wrong[] = {
        {100, 2, 4, 11, 120}, {136, 5, 4, 11, 136}, {140, 256, 4, 11, 136},
        {144, 0, 4, 11, 136}, {152, 1, 1, 12, 152}, {128, 800, 4, 11, 120},
    };
    const packed unchecked = image;
    mesh m = {0};
    fail f = {""};
    const pack_options options = {PLT_SPLIT_SAH, PLT_BUILD_HOST, 1, 3, NULL, 1, NULL, 0, 0};
    shape_soup(&m, 20, 0.8f, 1);
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    CHECK(plt_get_u32(image.bytes + 128) == 960, "20 triangles take three pages");
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const hostile_result r = changed(&wrong[i]);
        CHECK(r.status == PLT_ERR_IMAGE && r.fault.rule == wrong[i].rule &&
                  r.fault.offset == wrong[i].offset,
              "byte %u: R%u at %u", wrong[i].at, r.fault.rule, r.fault.offset);
    }
    image.bytes[image.size - 1] ^= 1; /* which scenes that are read whole do not look at */
    image.bytes[plt_get_u32(image.bytes + 140)] ^= 1;
    const change none = {10, 0, 1, 0, 0};
    CHECK(changed(&none).status == PLT_OK, "section 6 is looked at");
    pack_free(&image);
    mesh_free(&m);
    image = unchecked;
}

/* Bytes of the specification's table, read without the engine. */
static void by_hand(void) {
    const unsigned char *b = image.bytes;
    CHECK(memcmp(b, "PLANELET\1\0\0\0\0\1\0\0", 16) == 0, "magic, version, header size");
    CHECK(b[24] == 20 && b[25] == 0, "triangles");
    CHECK(b[48] == 3 && b[52] == 1 && b[96] == 0 && b[97] == 0, "N, K, splits, build");
    CHECK(b[100] == 2 && b[104] == 1 && b[108] == 0 && b[109] == 1 && b[120] == 2, "sections");
    CHECK(image.size % 64 == 0 &&
              image.size == 256 + image.info.node_bytes + image.info.triangle_bytes,
          "%u bytes", image.size);
    CHECK(image.info.nodes + 1 == image.info.leaf_lists + image.info.intermediate_lists,
          "a tree of nodes with two children each");
    CHECK(plt_crc32(0, "123456789", 9) == 0xCBF43926, "the check value");
    CHECK(plt_crc32(plt_crc32(0, "1234", 4), "56789", 5) == 0xCBF43926, "in two pieces");
    CHECK(plt_crc32(0, "", 0) == 0, "of nothing");
}

/* A header is read as it was written, for any valid counts. */
static void round_trip(void) {
    plt_header h, again;
    plt_fault fault;
    unsigned char bytes[256];
    CHECK(plt_header_read(&h, image.bytes, image.size, &fault) == PLT_OK, "%s", fault.message);
    CHECK(memcmp(&h.info, &image.info, offsetof(plt_info, build)) == 0, "info");
    plt_header_write(bytes, &h);
    CHECK(memcmp(bytes, image.bytes, 256) == 0, "bytes");
    CHECK(plt_header_read(&again, bytes, image.size, &fault) == PLT_OK && again.root == h.root,
          "again");
}

int main(void) {
    make_image();
    test("each refusal names its rule and offset");
    every_change();
    test("... also for sizes and checksums");
    sizes_and_checksums();
    test("... and of an image with checks");
    checked();
    test("what the specification tolerates is tolerated");
    tolerated();
    test("the header's bytes are those of the specification");
    by_hand();
    test("a header read and written again has the same bytes");
    round_trip();
    pack_free(&image);
    return test_done();
}
