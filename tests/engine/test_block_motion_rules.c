/* test_block_motion_rules - each rule of SPEC.md about compact blocks that move
 *
 * A valid image with one thing changed and its checks and checksums made right, so that no earlier
 * rule refuses it.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/compact/leaf.h"
#include "tests/hostile/sequences.h"
#include "tests/reference/sequence_rig.h"
#include "tests/test.h"

#define NAN_BITS 0x7FC00000u

enum { FRAMES = 5, TRIANGLES = 20, BITS = 14 };

static packed make_image(int without_ids) {
    const sequence_config c = {.scene = rig_config_of(2, 1, PLT_BUILD_HOST, PLT_SPLIT_SAH),
                               .frames = FRAMES,
                               .key_every = 2,
                               .lattice_bits = BITS,
                               .is_mapped = 1,
                               .is_compact = 1,
                               .without_ids = without_ids};
    return sequence_rig_image(&c, TRIANGLES, 3);
}

static void refused(unsigned char *bytes, uint32_t size, char kind, unsigned rule, uint32_t offset,
                    const char *what) {
    hostile_seal_sequence(bytes, size);
    for (uint8_t streamed = 0; streamed < 2; streamed++) {
        const hostile_config config = {streamed, 0, 2, 0};
        const hostile_result r = hostile_try_sequence(bytes, size, config, HOSTILE_RECORDS);
        CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == kind && r.fault.rule == rule &&
                  r.fault.offset == offset,
              "%s: status %d, %c%u at %u, not %c%u at %u (%s)", what, r.status,
              r.fault.kind ? r.fault.kind : '-', r.fault.rule, r.fault.offset, kind, rule, offset,
              r.fault.message);
    }
}

typedef struct change {
    uint32_t at, value, rule, offset;
} change;

static void every_header_word(void) {
    static const change changes[] = {
        {96, 0x03010000, 15, 188}, /* stills have no frame bytes */
        {96, 0x04010000, 8, 96},   /* a geometry format that is not there */
        {96, 0x02000000, 7, 24},   /* thesis nodes do not have this one, but other counts */
        {96, 0x02010100, 7, 28},   /* built by a device */
        {184, 11, 14, 168},
        {184, 22, 14, 168},
        {180, NAN_BITS, 14, 168},
        {168, NAN_BITS, 14, 168},
        {72, 0x40000001, 14, 168}, /* the box is none */
        {84, NAN_BITS, 14, 168},
        {188, 0, 15, 188},
        {188, 1u << 27, 15, 188},
        {192, 0, 15, 188},
        {192, 0xFFFFFFFF, 15, 188},
        {196, 0, 15, 188},
        {196, 1001, 15, 188},
        {200, 0, 15, 188},
        {204, 4 * FRAMES, 15, 188},
        {204, 0xFFFFFFFF, 11, 152},
        {208, 3 * TRIANGLES + 1, 15, 188},
        {208, 3 * TRIANGLES - 1, 'I', 0},
        {208, 0, 'I', 0},
        {216, 256 + 7, 15, 188}, /* checks of ids */
        {100, 3, 10, 100},
        {228, 1, 17, 16}, /* there is no table behind */
        {136, 8, 11, 136},
    };
    packed image = make_image(0);
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        char what[40];
        unsigned char *bytes = hostile_copy(image.bytes, image.size);
        snprintf(what, sizeof what, "%u at %u", changes[i].value, changes[i].at);
        plt_put_u32(bytes + changes[i].at, changes[i].value);
        if (changes[i].rule == 'I') {
            refused(bytes, image.size, 'I', 24, 208, what);
        } else {
            refused(bytes, image.size, 'R', changes[i].rule, changes[i].offset, what);
        }
        free(bytes);
    }
    unsigned char *bytes = hostile_copy(image.bytes, image.size);
    bytes[84] ^= 1;
    refused(bytes, image.size, 'R', 14, 188, "a box beside the points of the lattice");
    free(bytes);
    pack_free(&image);
}

/* Six bits per vertex of the blocks; 60 to 63 are not there. */
static void every_number(void) {
    packed image = make_image(0);
    CHECK(image.info.block_vertices == 3 * TRIANGLES && image.info.vertices == 60, "%u and %u",
          image.info.block_vertices, image.info.vertices);
    for (uint32_t i = 0; i < image.info.block_vertices; i++) {
        unsigned char *bytes = hostile_copy(image.bytes, image.size);
        for (uint32_t b = 6 * i; b < 6 * i + 6; b++) {
            bytes[hostile_begin(bytes, 2) + b / 8] |= (unsigned char)(1u << b % 8);
        }
        refused(bytes, image.size, 'I', 24, hostile_begin(bytes, 2) + 6 * i / 8, "a number");
        free(bytes);
    }
    pack_free(&image);
}

typedef struct first_block {
    plt_block b;
    plt_geometry g;
    unsigned char *part;
} first_block;

/* The first block that has triangles. */
static first_block open_first(unsigned char *bytes) {
    const plt_lattice_box frame = {{0, 0, 0},
                                   {(1u << BITS) - 1, (1u << BITS) - 1, (1u << BITS) - 1}};
    first_block f;
    unsigned char *at = bytes + hostile_begin(bytes, 0);
    plt_block_open(&f.b, at, BITS);
    while (f.b.leaves == 0) {
        at += plt_block_bytes(&f.b);
        plt_block_open(&f.b, at, BITS);
    }
    plt_geometry_open(&f.g, &f.b, &frame, 2);
    f.part = at + f.b.node_bytes;
    return f;
}

/* Below the bounds as well as above them. */
static void vertices_outside(void) {
    packed image = make_image(0);
    for (unsigned a = 0; a < 3; a++) {
        for (unsigned beyond = 0; beyond < 2; beyond++) {
            unsigned char *bytes = hostile_copy(image.bytes, image.size);
            const first_block f = open_first(bytes);
            plt_lattice_box bounds;
            plt_block_bounds(&f.b, BITS, &bounds);
            const uint32_t value = beyond ? bounds.hi[a] + 1 : bounds.lo[a] - 1;
            for (uint32_t k = 0; k < BITS; k++) {
                const uint32_t bit = f.g.positions + BITS * a + k;
                f.part[bit / 8] = (unsigned char)((f.part[bit / 8] & ~(1u << bit % 8)) |
                                                  (value >> k & 1u) << bit % 8);
            }
            refused(bytes, image.size, 'I', 21, (uint32_t)(f.b.bytes - bytes), "outside");
            free(bytes);
        }
    }
    pack_free(&image);
}

/* The string of turns has to end within the part: with one vertex more it does not, or the ones of
 * the string of new vertices are not as many. A turn that is none gives some rotation. */
static void turns(void) {
    packed image = make_image(0);
    unsigned char *bytes = hostile_copy(image.bytes, image.size);
    const first_block f = open_first(bytes);
    const uint32_t end = f.g.positions + 3 * BITS * f.g.vertices + 2 * f.g.triangles;
    CHECK(end <= 8 * f.b.geometry_bytes && end > 8 * f.b.geometry_bytes - 64,
          "%u of %u bits: positions, then two bits per triangle", end, 8 * f.b.geometry_bytes);
    for (uint32_t bit = end - 2 * f.g.triangles; bit < end; bit++) {
        f.part[bit / 8] |= (unsigned char)(1u << bit % 8);
    }
    hostile_seal_sequence(bytes, image.size);
    const hostile_config config = {0, 0, 2, 0};
    const hostile_result r = hostile_try_sequence(bytes, image.size, config, HOSTILE_RECORDS);
    CHECK(r.status == PLT_OK && r.sentence == NULL, "%d: %s", r.status, r.sentence);
    free(bytes);
    pack_free(&image);
}

/* Eight bytes less of a part whose turns alone need them. */
static void short_part(void) {
    for (uint32_t n = TRIANGLES; n < TRIANGLES + 40; n++) {
        const sequence_config c = {.scene = rig_config_of(2, 1, PLT_BUILD_HOST, PLT_SPLIT_SAH),
                                   .frames = 1,
                                   .key_every = 1,
                                   .lattice_bits = BITS,
                                   .is_mapped = 1,
                                   .is_compact = 1};
        packed image = sequence_rig_image(&c, n, 3);
        first_block f = open_first(image.bytes);
        const uint32_t positions_end = f.g.positions + 3 * BITS * f.g.vertices;
        if (image.info.treelets == 1 && positions_end <= 8 * (f.b.geometry_bytes - 8)) {
            unsigned char *head = image.bytes + hostile_begin(image.bytes, 0);
            plt_put_u32(head, plt_get_u32(head) - (1u << 6)); /* G is 8 bytes less */
            plt_put_u32(image.bytes + 224, image.info.triangle_bytes - 8);
            refused(image.bytes, image.size, 'I', 14, hostile_begin(image.bytes, 0), "short");
            n = TRIANGLES + 40;
        }
        pack_free(&image);
    }
}

int main(void) {
    test("each refusal of a header names its rule and offset");
    every_header_word();
    test("a vertex of a block that is not there is refused");
    every_number();
    test("a position outside of its block is refused");
    vertices_outside();
    test("turns of triangles lie within their part, and are any");
    turns();
    short_part();
    return test_done();
}
