/* test_instances_rules - each rule of SPEC.md about instances, by number and offset
 *
 * A valid image with one thing changed and its checksums made right, so that no earlier rule
 * refuses it; and damage that they find.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/thesis/link.h"
#include "tests/hostile/instances.h"
#include "tests/reference/instances_rig.h"
#include "tests/test.h"

#define NAN_BITS 0x7FC00000u
#define TWO_40 0x53800000u /* 2^40 as a float */
#define ONE 0x3F800000u
#define MINUS_ZERO 0x80000000u

enum { INSTANCES = 4, FRAME = PLT_MATRICES_HEAD + INSTANCES * PLT_MATRIX_BYTES };

static packed make_image(void) {
    const instances_config c = {
        rig_config_of(2, 1, PLT_BUILD_HOST, PLT_SPLIT_SAH), INSTANCES, INSTANCES_RIGID, 4.0f, 1, 2};
    return instances_rig_image(&c);
}

static hostile_result open_image(const unsigned char *bytes, uint32_t size, uint8_t streamed) {
    const hostile_config config = {streamed, 0, 2, 0};
    return hostile_try_instances(bytes, size, config);
}

static void check(const unsigned char *bytes, uint32_t size, char kind, unsigned rule,
                  uint32_t offset) {
    for (uint8_t streamed = 0; streamed < 2; streamed++) {
        const hostile_result r = open_image(bytes, size, streamed);
        CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == kind && r.fault.rule == rule &&
                  r.fault.offset == offset,
              "status %d, %c%u at %u, not %c%u at %u (%s)", r.status,
              r.fault.kind ? r.fault.kind : '-', r.fault.rule, r.fault.offset, kind, rule, offset,
              r.fault.message);
    }
}

/* One word of an image is another. */
static void refused(const packed *image, uint32_t at, uint32_t value, char kind, unsigned rule,
                    uint32_t offset) {
    unsigned char *bytes = hostile_copy(image->bytes, image->size);
    plt_put_u32(bytes + at, value);
    hostile_seal_instances(bytes, image->size);
    check(bytes, image->size, kind, rule, offset);
    free(bytes);
}

typedef struct change {
    uint32_t at, value, rule, offset;
} change;

static void header(const packed *image) {
    static const change changes[] = {
        {188, 0, 16, 208},          {188, 0x7FFFFFFF, 16, 208}, {188, 2, 11, 136},
        {192, 0, 16, 208},          {192, 0xFFFFFFFF, 16, 208}, {196, 0, 16, 208},
        {196, 1001, 16, 208},       {200, 2, 16, 208},          {200, 0, 16, 208},
        {204, 4, 16, 208},          {208, 65537, 16, 208},      {208, 3, 16, 208},
        {208, 0xFFFFFFFF, 16, 208}, {212, 3, 16, 208},          {212, 0xFFFFFFFF, 16, 208},
        {216, 5, 12, 216},          {168, ONE, 12, 170},        {172, NAN_BITS, 12, 174},
        {180, ONE, 12, 182},        {184, 12, 12, 184},         {68, 0, 16, 208},
        {100, 3, 10, 100},          {136, 8, 11, 136},          {152, 7, 11, 152},
        {168, MINUS_ZERO, 12, 171}, {180, MINUS_ZERO, 12, 183}};
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        const change *c = &changes[i];
        refused(image, c->at, c->value, 'R', c->rule, c->offset);
    }
}

/* Of body 1: ranges, box and root; the place of an instance's body. */
static void bodies(const packed *image) {
    const uint32_t table = hostile_begin(image->bytes, 2), body = table + PLT_BODY_BYTES;
    const unsigned char *at = image->bytes + body;
    const uint32_t instances = table + 3 * PLT_BODY_BYTES;
    refused(image, body, PLT_LINK_NONE, 'I', 27, body);
    refused(image, body + 4, plt_get_u32(at + 4) + 1, 'I', 27, body);
    refused(image, body + 4, 0, 'I', 27, body);
    refused(image, body + 8, 0xFFFFFFFF, 'I', 27, body);
    refused(image, body + 12, plt_get_u32(at + 12) - 1, 'I', 27, body);
    refused(image, body + 16, 0, 'I', 27, body);
    refused(image, body + 16, 0xFFFFFFF0, 'I', 27, body);
    refused(image, body + 20, 1, 'I', 27, body);
    refused(image, body + 24, NAN_BITS, 'I', 27, body);
    refused(image, body + 28, TWO_40 + 1, 'I', 27, body);
    refused(image, body + 40, TWO_40 | 0x80000001, 'I', 27, body);
    refused(image, instances + 8, 3, 'I', 27, instances + 8);
    refused(image, instances, 0xFFFFFFFF, 'I', 27, instances);
    refused(image, 212, plt_get_u32(image->bytes + 212) + 1, 'I', 27, table);
    refused(image, 28, plt_get_u32(image->bytes + 28) - 1, 'I', 8, 28);
    refused(image, body, 0x7FFFFFE2u, 'I', 1, body);
    refused(image, body + 24, 0x3F000000, 'I', 5,
            hostile_begin(image->bytes, 1) + PLT_RECORD_BYTES * plt_get_u32(at + 12));
}

/* A node of body 1 with a link beyond its own slots, and a record with an id that is not of it. */
static void trees(const packed *image) {
    const unsigned char *at = image->bytes + hostile_begin(image->bytes, 2) + PLT_BODY_BYTES;
    const uint32_t node = hostile_begin(image->bytes, 0) + PLT_NODE_BYTES * plt_get_u32(at + 4);
    const uint32_t record =
        hostile_begin(image->bytes, 1) + PLT_RECORD_BYTES * plt_get_u32(at + 12);
    const uint32_t link = plt_get_u32(image->bytes + node + 24);
    refused(image, node + 24, (link & PLT_LINK_OWNERS) | 0x7FFFFFE2u, 'I', 1, node);
    refused(image, record + 36, plt_get_u32(at + 16) | 0x80000000u, 'I', 7, record + 36);
}

/* A frame that opening does not read. */
static void shown(const packed *image, uint32_t at, uint32_t value, int seals, unsigned rule,
                  uint32_t offset) {
    unsigned char *bytes = hostile_copy(image->bytes, image->size);
    plt_engine *e;
    plt_fault fault;
    plt_put_u32(bytes + at, value);
    if (seals) {
        hostile_seal_instances(bytes, image->size);
    }
    const plt_options o = {.packet_side = 2};
    const plt_source source = {bytes, image->size, NULL, NULL, NULL};
    void *arena = aligned_alloc(PLT_ALIGN, plt_arena_need(&image->info, 1, &o));
    CHECK(plt_open(&e, arena, plt_arena_need(&image->info, 1, &o), &source, &o, &fault) == PLT_OK,
          "%s", fault.message);
    CHECK(plt_sequence_show(e, 1, &fault) == PLT_OK, "%s", fault.message);
    CHECK(plt_sequence_show(e, 2, &fault) == PLT_ERR_IMAGE && fault.kind == 'I' &&
              fault.rule == rule && fault.offset == offset && plt_sequence_failed(e) == 2,
          "frame %u, %c%u at %u: %s", plt_sequence_failed(e), fault.kind, fault.rule, fault.offset,
          fault.message);
    CHECK(plt_sequence_show(e, 3, &fault) == PLT_OK, "%s", fault.message);
    free(arena);
    free(bytes);
}

static void frames(const packed *image) {
    const uint32_t at = hostile_begin(image->bytes, 3), two = at + 2 * FRAME;
    shown(image, two, 0, 0, 28, two);
    shown(image, two + 60, ONE, 0, 28, two);
    for (uint32_t i = 0; i < INSTANCES; i++) {
        const uint32_t matrix = two + PLT_MATRICES_HEAD + i * PLT_MATRIX_BYTES;
        shown(image, matrix + 4 * i, NAN_BITS, 1, 29, matrix);
        shown(image, matrix + 12, TWO_40 + 1, 1, 29, matrix);
        shown(image, matrix + 20, 0x49800001, 1, 29, matrix); /* 2^20 and more */
    }
    refused(image, at + PLT_MATRICES_HEAD, NAN_BITS, 'I', 29, at + PLT_MATRICES_HEAD);
}

/* Each byte of sections and header that is damaged without a new checksum. */
static void damage(const packed *image) {
    unsigned char *bytes = hostile_copy(image->bytes, image->size);
    const uint32_t end = hostile_begin(image->bytes, 3) + FRAME;
    uint32_t found = 0, all = 0;
    for (uint32_t at = 0; at < end; at += at < 256 ? 1 : 13) {
        bytes[at] ^= 16;
        const hostile_result r = open_image(bytes, image->size, (uint8_t)(at & 1));
        found += r.status == PLT_ERR_IMAGE;
        all++;
        bytes[at] ^= 16;
    }
    CHECK(found == all, "%u of %u", found, all);
    free(bytes);
}

int main(void) {
    packed image = make_image();
    test("an image with instances opens, all frames show, and hits are in range");
    CHECK(open_image(image.bytes, image.size, 0).sentence == NULL &&
              open_image(image.bytes, image.size, 1).sentence == NULL,
          "as it was packed");
    test("each field of the header that is out of range is refused by its rule");
    header(&image);
    test("each field of bodies and instances that is out of range is refused by its rule");
    bodies(&image);
    trees(&image);
    test("matrices that are damaged, or cannot be inverted, refuse their frame and no other");
    frames(&image);
    test("damage anywhere but in later frames is found when the image is opened");
    damage(&image);
    pack_free(&image);
    return test_done();
}
