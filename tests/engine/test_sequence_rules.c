/* test_sequence_rules - each rule of SPEC.md about sequences, by number and offset
 *
 * A valid image with one thing changed and its checksums made right, so that no earlier rule
 * refuses it; and damage that they find.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hostile/sequences.h"
#include "tests/reference/sequence_rig.h"
#include "tests/test.h"

#define NAN_BITS 0x7FC00000u
#define TWO_40 0x53800000u /* 2^40 as a float */

enum { FRAMES = 5, VERTICES = 60 };

/* Of floats, and on a lattice of 14 bits. */
static packed make_image(uint32_t bits, uint32_t key_every) {
    const sequence_config c = {.scene = rig_config_of(2, 1, PLT_BUILD_HOST, PLT_SPLIT_SAH),
                               .frames = FRAMES,
                               .key_every = key_every,
                               .lattice_bits = bits,
                               .is_mapped = 1};
    return sequence_rig_image(&c, VERTICES / 3, 3);
}

static uint32_t frame_at(const unsigned char *bytes, uint32_t frame) {
    return hostile_begin(bytes, 3) + plt_get_u32(bytes + hostile_begin(bytes, 3) + 4 * frame);
}

static hostile_result open_image(const unsigned char *bytes, uint32_t size, uint8_t streamed,
                                 unsigned motion) {
    const hostile_config config = {streamed, 0, 2, 0};
    return hostile_try_sequence(bytes, size, config, motion);
}

static void refused(unsigned char *bytes, uint32_t size, char kind, unsigned rule,
                    uint32_t offset) {
    hostile_seal_sequence(bytes, size);
    for (unsigned i = 0; i < 6; i++) {
        const hostile_result r = open_image(bytes, size, (uint8_t)(i % 2), HOSTILE_RECORDS + i / 2);
        CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == kind && r.fault.rule == rule &&
                  r.fault.offset == offset,
              "status %d, %c%u at %u, not %c%u at %u (%s)", r.status,
              r.fault.kind ? r.fault.kind : '-', r.fault.rule, r.fault.offset, kind, rule, offset,
              r.fault.message);
    }
}

/* ---- the header --------------------------------------------------------------------- */

typedef struct change {
    uint32_t at, value, rule, offset;
} change;

static void header_words(uint32_t bits, const change *changes, size_t count) {
    packed image = make_image(bits, 2);
    for (size_t i = 0; i < count; i++) {
        unsigned char *bytes = hostile_copy(image.bytes, image.size);
        plt_put_u32(bytes + changes[i].at, changes[i].value);
        refused(bytes, image.size, 'R', changes[i].rule, changes[i].offset);
        free(bytes);
    }
    pack_free(&image);
}

static void every_header_word(void) {
    static const change lattice[] = {
        {188, 0, 15, 188},
        {188, 1u << 27, 15, 188},
        {192, 0, 10, 100},
        {192, 0xFFFFFFFF, 15, 188},
        {192, 0x10000000, 15, 188},
        {196, 0, 15, 188},
        {196, 1001, 15, 188},
        {200, 0, 15, 188},
        {204, 0, 15, 188},
        {204, 4 * FRAMES, 15, 188},
        {204, 4 * FRAMES + 4, 11, 152},
        {204, 0xFFFFFFFF, 11, 152},
        {208, 1, 16, 208},
        {212, 1, 12, 212},
        {216, 5, 12, 216},
        {228, 1u << 24, 17, 228},
        {184, 11, 15, 188},
        {184, 22, 15, 188},
        {184, 0, 15, 188},
        {180, 0, 15, 188},
        {180, NAN_BITS, 15, 188},
        {180, TWO_40, 15, 188},
        {168, NAN_BITS, 15, 188},
        {172, TWO_40 + 1, 15, 188},
        {176, TWO_40 | 0x80000001, 15, 188},
        {188, 1u << 20, 11, 136},
        {100, 2, 10, 100},
        {136, 8, 11, 136},
        {152, 7, 11, 152},
    };
    static const change floats[] = {
        {184, 14, 15, 188}, {180, 1, 15, 188}, {168, 1, 15, 188}, {176, 0x80000001, 15, 188}};
    header_words(14, lattice, sizeof lattice / sizeof lattice[0]);
    header_words(0, floats, sizeof floats / sizeof floats[0]);
}

/* ---- offsets and topology ----------------------------------------------------------- */

static void every_offset(void) {
    packed image = make_image(14, 2);
    for (uint32_t i = 0; i <= FRAMES; i++) {
        const uint32_t at = hostile_begin(image.bytes, 3) + 4 * i,
                       was = plt_get_u32(image.bytes + at);
        const uint32_t values[] = {0,       was - 4,    was + 4,
                                   was + 1, 0xFFFFFFFC, image.info.frame_bytes + 4};
        for (unsigned v = 0; v < 6; v++) {
            const int is_inner = i > 0 && i < FRAMES;
            unsigned char *bytes = hostile_copy(image.bytes, image.size);
            plt_put_u32(bytes + at, values[v]);
            if (is_inner && (v == 1 || v == 2)) { /* still behind each other: blocks do not fit */
                hostile_seal_sequence(bytes, image.size);
                hostile_frames_all = (hostile_frames){0, 0};
                /* Without records frame 0 is read when the image is opened. */
                const unsigned motion = i > 1 ? HOSTILE_RECORDS + i % 3 : HOSTILE_RECORDS;
                hostile_result r = open_image(bytes, image.size, 0, motion);
                CHECK(r.status == PLT_OK && r.sentence == NULL && hostile_frames_all.refused > 0,
                      "offset %u: %s", i, r.sentence);
                r = open_image(bytes, image.size, 0, HOSTILE_VERTICES);
                CHECK(i > 1 || (r.status == PLT_ERR_IMAGE && r.fault.rule == 25), "offset %u", i);
            } else {
                refused(bytes, image.size, 'I', 23, at);
            }
            free(bytes);
        }
    }
    pack_free(&image);
}

/* Six bits per vertex; 60 to 63 are not there. */
static void every_index(void) {
    packed image = make_image(0, 2);
    for (uint32_t i = 0; i < VERTICES; i++) {
        unsigned char *bytes = hostile_copy(image.bytes, image.size);
        for (uint32_t b = 6 * i; b < 6 * i + 6; b++) {
            bytes[hostile_begin(bytes, 2) + b / 8] |= (unsigned char)(1u << b % 8);
        }
        refused(bytes, image.size, 'I', 24, hostile_begin(bytes, 2) + i / 3 * 18 / 8);
        free(bytes);
    }
    pack_free(&image);
}

/* ---- frames --------------------------------------------------------------------------- */

static plt_engine *engine;
static unsigned char arena[1 << 20] __attribute__((aligned(16)));

/* Shows frame `k` of a mapped image. */
static int show(const unsigned char *bytes, uint32_t size, uint32_t k, plt_fault *fault) {
    const plt_source source = {bytes, size, NULL, NULL, NULL};
    const plt_options options = {.packet_side = 2, .movable = 1};
    const int status = plt_open(&engine, arena, sizeof arena, &source, &options, fault);
    return status == PLT_OK ? plt_sequence_show(engine, k, fault) : status;
}

static void breaks(const unsigned char *bytes, uint32_t size, uint32_t frame, unsigned rule,
                   uint32_t offset, const char *what) {
    plt_fault fault;
    const int status = show(bytes, size, frame, &fault);
    CHECK(status == PLT_ERR_IMAGE && fault.kind == 'I' && fault.rule == rule &&
              fault.offset == offset && plt_sequence_failed(engine) == frame,
          "%s: status %d, I%u at %u, not I%u at %u: %s", what, status, fault.rule, fault.offset,
          rule, offset, fault.message);
}

/* Every bit of a frame, its padding included, is looked at, in every place it may lie. */
static void every_flip(void) {
    for (uint32_t bits = 0; bits <= 14; bits += 14) {
        packed image = make_image(bits, 2);
        const uint32_t begin = frame_at(image.bytes, 3), end = frame_at(image.bytes, 4);
        for (uint32_t bit = 8 * begin; bit < 8 * end; bit++) {
            plt_fault fault;
            image.bytes[bit / 8] ^= (unsigned char)(1u << bit % 8);
            const int status = show(image.bytes, image.size, 3, &fault);
            CHECK(status == PLT_ERR_IMAGE && fault.rule == 25 && plt_sequence_failed(engine) == 3,
                  "bit %u: %d", bit, status);
            image.bytes[bit / 8] ^= (unsigned char)(1u << bit % 8);
        }
        pack_free(&image);
    }
}

/* A frame where another one should be, with all its checks. */
static void exchanged(void) {
    packed image = make_image(0, 1);
    unsigned char *bytes = hostile_copy(image.bytes, image.size);
    const uint32_t one = frame_at(bytes, 1), two = frame_at(bytes, 2), three = frame_at(bytes, 3);
    memcpy(bytes + one, image.bytes + two, two - one < three - two ? two - one : three - two);
    breaks(bytes, image.size, 1, 25, one, "another frame");
    free(bytes);
    pack_free(&image);
}

static void forged_blocks(void) {
    packed image = make_image(0, 1);
    const uint32_t at = frame_at(image.bytes, 2);
    unsigned char *bytes = hostile_copy(image.bytes, image.size);
    bytes[at + 4] |= 0x3F; /* width 63 */
    hostile_seal_sequence(bytes, image.size);
    breaks(bytes, image.size, 2, 25, at, "a width above 32");
    memcpy(bytes, image.bytes, image.size);
    bytes[at + 4] = (unsigned char)((bytes[at + 4] & 0xC0) | 32);
    hostile_seal_sequence(bytes, image.size);
    breaks(bytes, image.size, 2, 25, at, "a block that is longer than its frame");
    memcpy(bytes, image.bytes, image.size);
    bytes[at + 4] = (unsigned char)(bytes[at + 4] & 0xC0);
    hostile_seal_sequence(bytes, image.size);
    plt_fault fault;
    CHECK(show(bytes, image.size, 2, &fault) == PLT_ERR_IMAGE && fault.rule == 25 &&
              strstr(fault.message, "behind its last block"),
          "%s", fault.message);
    free(bytes);
    pack_free(&image);
}

/* All bits of the three widths to x, which has no room for so many: the block is as long as it was.
 */
static void forged_widths(void) {
    packed image = make_image(14, 1);
    const uint32_t at = frame_at(image.bytes, 2);
    const uint32_t widths = plt_get_u32(image.bytes + at + 4);
    const uint32_t sum = (widths & 63) + (widths >> 6 & 63) + (widths >> 12 & 63);
    CHECK(sum > 14 && sum < 64, "%u bits", sum);
    plt_put_u32(image.bytes + at + 4, (widths & ~0x3FFFFu) | sum);
    plt_put_u32(image.bytes + at, /* the check: sealing would leave it alone */
                plt_frame_block_check(image.bytes + at, frame_at(image.bytes, 3) - at, 2, 0));
    hostile_seal_header(image.bytes, image.size);
    breaks(image.bytes, image.size, 2, 25, at, "a width above that of a coordinate");
    pack_free(&image);
}

/* Least values of x are moved by so much that some float is none. */
static void forged_floats(void) {
    static const uint32_t bad[] = {NAN_BITS,
                                   0x7F800000,
                                   TWO_40 + 1,
                                   0xFF800000 ^ 0x7FFFFFFF,
                                   (TWO_40 + 1) ^ 0xFFFFFFFF,
                                   0xFFC00000 ^ 0x7FFFFFFF};
    packed image = make_image(0, 1);
    const uint32_t at = frame_at(image.bytes, 2);
    for (unsigned i = 0; i < 6; i++) {
        unsigned char *bytes = hostile_copy(image.bytes, image.size);
        plt_fault fault;
        for (uint32_t b = 0; b < 32; b++) { /* the least x, from bit 50 on */
            const uint32_t bit = 8 * at + 50 + b;
            bytes[bit / 8] =
                (unsigned char)((bytes[bit / 8] & ~(1u << bit % 8)) | (bad[i] >> b & 1) << bit % 8);
        }
        hostile_seal_sequence(bytes, image.size);
        breaks(bytes, image.size, 2, 26, at, "a position that is no number");
        CHECK(show(bytes, image.size, 1, &fault) == PLT_OK, "others are as they were");
        free(bytes);
    }
    pack_free(&image);
}

static void exact_range(void) {
    mesh m = {0};
    plt_fault fault;
    fail f = {""};
    const sequence_options o = {1, 25, 1, sequence_lattice(0), 0};
    sequence s;
    packed far;
    mesh_add_vertex(&m, PLT_COORD_MAX, -PLT_COORD_MAX, 0.0f, &f);
    mesh_add_vertex(&m, -PLT_COORD_MAX, PLT_COORD_MAX, -0.0f, &f);
    mesh_add_vertex(&m, 0.0f, 1.0f, PLT_COORD_MAX, &f);
    mesh_add_triangle(&m, 0, 1, 2, &f);
    rig_config c = rig_config_of(1, 1, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.pack.checks = 0;
    CHECK(pack_mesh(&far, &m, &c.pack, "test", &f) == 0 &&
              sequence_begin(&s, &m, &o, "test", &f) == 0 &&
              sequence_add(&s, &m, "test", &f) == 0 &&
              sequence_finish(&s, &far, &m, "test", &f) == 0,
          "%s", f.text);
    CHECK(show(far.bytes, far.size, 0, &fault) == PLT_OK, "at 2^40: %s", fault.message);
    sequence_free(&s);
    pack_free(&far);
    mesh_free(&m);
}

/* SPEC.md, section 4.15, the example. */
static void example(void) {
    static const unsigned char due[] = {0x0c, 0,    0,    0,    0x1c, 0,    0,    0,    0x28, 0,
                                        0,    0,    0x28, 0xa7, 0x25, 0x9c, 0x03, 0x20, 0x14, 0,
                                        0,    0x10, 0,    0xc2, 0x01, 0,    0,    0,    0x61, 0xcb,
                                        0xf8, 0x60, 0x02, 0,    0xfc, 0x7f, 0,    0,    0,    0x09};
    static const float at[2][9] = {{5, 0, 7, 6, 0, 4, 9, 0, 4}, {4, 1, 7, 6, 1, 4, 10, 1, 4}};
    const sequence_options o = {2, 25, 2, {{0, 0, 0, 0}, 1.0f, 12}, 0};
    mesh m = {0};
    fail f = {""};
    sequence s;
    for (unsigned i = 0; i < 3; i++) {
        mesh_add_vertex(&m, at[0][3 * i], at[0][3 * i + 1], at[0][3 * i + 2], &f);
    }
    mesh_add_triangle(&m, 0, 1, 2, &f);
    CHECK(sequence_begin(&s, &m, &o, "test", &f) == 0 && sequence_add(&s, &m, "test", &f) == 0,
          "%s", f.text);
    memcpy(m.vertex, at[1], sizeof at[1]);
    CHECK(sequence_add(&s, &m, "test", &f) == 0, "%s", f.text);
    CHECK(s.size == sizeof due && memcmp(s.bytes, due, sizeof due) == 0, "%u bytes",
          (unsigned)s.size);
    sequence_free(&s);
    mesh_free(&m);
}

int main(void) {
    test("the example of the specification is what the packer writes");
    example();
    test("each refusal of a header with a sequence names its rule and offset");
    every_header_word();
    test("an offset that does not lie behind the one before it is refused");
    every_offset();
    test("a triangle with a vertex that is not there is refused");
    every_index();
    test("every bit of a frame is checked when it comes");
    every_flip();
    test("... and that it is the frame that was asked for");
    exchanged();
    test("blocks that do not fill their frame are refused, whatever their checks say");
    forged_blocks();
    forged_widths();
    test("positions that are no numbers, or beyond 2^40, are refused");
    forged_floats();
    test("... and those at 2^40 are not");
    exact_range();
    return test_done();
}
