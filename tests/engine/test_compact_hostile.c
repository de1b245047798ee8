/* test_compact_hostile - damaged, forged and malicious compact images
 *
 * Every image is opened mapped and streamed, copied to exactly its size, in exactly the arena
 * it needs (reference/compact_hostile.h): sanitizers check the rest.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hostile/attacks.h"
#include "tests/reference/compact_hostile.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/random.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { AT_COUNTS = 24, AT_ROOT = 68, AT_LATTICE = 168, AT_BOX = 188, AT_SOURCE = 212 };

typedef struct kind {
    uint8_t build, floats, numbers, bits;
    uint32_t k;
} kind;

static const kind kinds[] = {{PLT_BUILD_HOST, 0, 1, 14, 2},
                             {PLT_BUILD_HOST, 0, 0, 21, 4},
                             {PLT_BUILD_HOST, 1, 0, 16, 1},
                             {PLT_BUILD_DEVICE, 0, 0, 12, 2},
                             {PLT_BUILD_DEVICE, 0, 0, 17, 1}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* A soup; if `triangles` is 0xFFFFFFFF a sphere, whose triangles share corners. */
#define SPHERE 0xFFFFFFFFu

static packed image_of(const kind *of, uint32_t triangles) {
    mesh m = {0};
    packed image;
    fail f = {""};
    lattice_loss loss;
    const compact_options options = {.splits = PLT_SPLIT_SAH,
                                     .build = of->build,
                                     .lattice_bits = of->bits,
                                     .numbers = of->numbers,
                                     .floats = of->floats,
                                     .leaf_triangles = of->k};
    if (triangles == SPHERE) {
        shape_icosphere(&m, 3);
    } else {
        shape_soup(&m, triangles, 0.8f, triangles);
    }
    CHECK(pack_compact(&image, &m, &options, "test", &loss, &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

static hostile_result open_once(const unsigned char *bytes, uint32_t size, uint8_t streamed,
                                uint32_t at) {
    (void)at;
    return compact_try(bytes, size, streamed, 2);
}

static void every_kind(uint32_t triangles, void (*attack)(const packed *image)) {
    for (int i = 0; i < KINDS; i++) {
        packed image = image_of(&kinds[i], triangles);
        attack(&image);
        CHECK(meet(image.bytes, image.size, "the unchanged image", 0).status == PLT_OK,
              "kind %d was not restored", i);
        pack_free(&image);
    }
}

/* ---- accidents: every one is detected ---------------------------------------------- */

/* A block's own checks detect a flip even when section and header CRCs are made right, except
 * in the padding between blocks, less than 8 bytes each. */
static void flips_in_blocks(const packed *image) {
    const uint32_t bytes = image->info.node_bytes + image->info.triangle_bytes;
    uint32_t unnoticed = 0, by_check = 0;
    if (image->info.build != PLT_BUILD_HOST) {
        return;
    }
    for (uint32_t at = 256; at < 256 + bytes; at++) {
        image->bytes[at] ^= 0x10;
        compact_seal(image->bytes, image->size, 0);
        const hostile_result r = meet(image->bytes, image->size, "a flip in a block", at);
        unnoticed += r.status == PLT_OK;
        by_check += r.fault.rule == 13;
        CHECK(r.status == PLT_OK || (r.status == PLT_ERR_IMAGE && r.fault.kind == 'I'),
              "at %u: status %d", at, r.status);
        image->bytes[at] ^= 0x10;
    }
    compact_seal(image->bytes, image->size, 0);
    CHECK(unnoticed < 8 * image->info.treelets, "%u flips of %u bytes were not detected", unnoticed,
          bytes);
    CHECK(by_check > bytes / 2, "%u of %u flips were detected by a check", by_check, bytes);
}

/* Cut short, with the header's size changed to match. */
static void sealed_lengths(const packed *image) {
    unsigned char *shorter = room_get(image->size);
    for (uint32_t size = 256; size < image->size; size += 4) {
        memcpy(shorter, image->bytes, image->size);
        plt_put_u32(shorter + 16, size);
        compact_seal(shorter, size, 1);
        must_refuse(shorter, size, "a size that the header confirms", size);
    }
    free(shorter);
}

/* ---- forgeries: checks are right ---------------------------------------------------------- */

/* Two random header words at a time, each set to one of a few values. */
static void header_pairs(const packed *image) {
    random_state r = {6};
    unsigned char *bytes = room_get(image->size);
    for (uint32_t i = 0; i < 2000; i++) {
        memcpy(bytes, image->bytes, image->size);
        for (int k = 0; k < 2; k++) {
            unsigned char *word = bytes + 24 + 4 * random_below(&r, 51);
            const uint32_t value = plt_get_u32(word);
            plt_put_u32(word, random_below(&r, 2) ? random_below(&r, 40)
                                                  : value + random_below(&r, 5) - 2);
        }
        compact_seal(bytes, image->size, 1);
        meet(bytes, image->size, "header words", i);
    }
    free(bytes);
}

static void sealed_flips(const packed *image) {
    unsigned char *bytes = room_get(image->size);
    for (uint32_t at = 0; at < image->size; at++) {
        for (int bit = 0; bit < 9; bit++) {
            memcpy(bytes, image->bytes, image->size);
            bytes[at] ^= bit < 8 ? (unsigned char)(1u << bit) : 0xFF;
            compact_seal(bytes, image->size, 1);
            meet(bytes, image->size, "a sealed flip", at);
        }
    }
    free(bytes);
}

/* ---- traps ------------------------------------------------------------------------------ */

/* The image with these bytes and correct checks must break invariant `rule` (0: it must open;
 * 255: either, without harm). Frees the bytes. */
static void must_break(const packed *image, unsigned char *bytes, uint32_t at, uint8_t rule,
                       const char *what) {
    compact_seal(bytes, image->size, 1);
    const hostile_result r = meet(bytes, image->size, what, at);
    const int good = rule == 0
                         ? r.status == PLT_OK
                         : r.status == PLT_ERR_IMAGE && r.fault.kind == 'I' && r.fault.rule == rule;
    CHECK(good || rule == 255, "%s: status %d, rule %c%u, not I%u", what, r.status,
          r.fault.kind ? r.fault.kind : '-', r.fault.rule, rule);
    free(bytes);
}

/* `count` bytes at `at` become `value`. */
static void bend(const packed *image, uint32_t at, uint64_t value, uint32_t count, uint8_t rule,
                 const char *what) {
    unsigned char *bytes = hostile_copy(image->bytes, image->size);
    for (uint32_t i = 0; i < count; i++) {
        bytes[at + i] = (unsigned char)(value >> 8 * i);
    }
    must_break(image, bytes, at, rule, what);
}

typedef struct some_block {
    plt_block b;
    plt_geometry g;
    uint32_t bits, bounds_at, mask_at, links_at, geometry_at; /* bytes of the image */
} some_block;

static some_block open_at(const packed *image, uint32_t address) {
    some_block f = {.bits = plt_get_u32(image->bytes + COMPACT_BITS)};
    plt_lattice_box bounds;
    plt_block_open(&f.b, image->bytes + 256 + address, f.bits);
    plt_block_bounds(&f.b, f.bits, &bounds);
    f.bounds_at = 256 + address + 4;
    f.mask_at = f.bounds_at + plt_block_bounds_bytes(f.bits);
    f.links_at = (uint32_t)(f.b.links - image->bytes);
    f.geometry_at = (uint32_t)(f.b.geometry - image->bytes);
    if (f.b.geometry_bytes > 0) {
        plt_geometry_open(&f.g, &f.b, &bounds, image->info.leaf_triangles);
    }
    return f;
}

static uint32_t second_address(const packed *image) {
    const some_block f = open_at(image, 0);
    return plt_block_bytes(&f.b);
}

static void bent_links(const packed *image) {
    const some_block f = open_at(image, 0);
    const uint32_t used = image->info.node_bytes + image->info.triangle_bytes;
    const uint32_t link = plt_get_u32(image->bytes + f.links_at);
    const uint32_t second = plt_get_u32(image->bytes + f.links_at + 4);
    CHECK(f.b.edges >= 2, "%u edges are too few to change", f.b.edges);
    bend(image, f.links_at, link & 0xFF000000u, 4, 17, "a link to the root");
    bend(image, f.links_at, second, 4, 17, "two links to one block");
    bend(image, f.links_at, link + 1, 4, 17, "a link into a block");
    bend(image, f.links_at, (link & 0xFF000000u) | used / 8, 4, 17, "a link beyond the last");
    bend(image, f.links_at, 0xFFFFFFFF, 4, 17, "a link far beyond");
    bend(image, f.links_at, link ^ 0x01000000u, 4, 17, "a link of another size");
    bend(image, f.links_at, (uint64_t)link << 32 | second, 8, 0, "links exchanged");
    bend(image, AT_ROOT, second, 4, 17, "a root that is not the first");
    bend(image, AT_ROOT, 0xFFFFFFFF, 4, 17, "no root");
    bend(image, AT_COUNTS, 0, 4, 255, "no triangles");
}

static uint32_t last_address(const packed *image) {
    const uint32_t used = image->info.node_bytes + image->info.triangle_bytes;
    uint32_t at = 0;
    for (uint32_t next = 0; next < used;) {
        const some_block f = open_at(image, next);
        at = next;
        next += plt_block_bytes(&f.b);
    }
    return at;
}

static void bent_sizes(const packed *image) {
    const uint32_t at = 256 + last_address(image), head = plt_get_u32(image->bytes + at);
    bend(image, at, (head & ~63u) | ((head + 1) & 63u), 4, 255, "a node more");
    bend(image, at, head & ~63u, 4, 255, "one node");
    bend(image, at, head | 0xFFC0u, 4, 10, "a geometry part beyond the section");
    bend(image, at, head & ~0xFFC0u, 4, 14, "no geometry part");
    bend(image, at, head - (1u << 6), 4, 14, "a geometry part that ends too early");
    bend(image, at, (head & ~0xFFC0u) | 1u << 6, 4, 14, "a geometry part of its header");
}

static void bent_kinds(const packed *image) {
    const some_block f = open_at(image, 0);
    const uint32_t mask_bytes = (2 * f.b.nodes + 7) / 8;
    bend(image, f.mask_at, 0, 1, 11, "a root without inner children");
    unsigned char *bytes = hostile_copy(image->bytes, image->size);
    memset(bytes + f.mask_at, 0xFF, mask_bytes);
    memset(bytes + f.mask_at + mask_bytes, 0, mask_bytes);
    must_break(image, bytes, f.mask_at, 11, "nothing but inner children");
    bytes = hostile_copy(image->bytes, image->size);
    memset(bytes + f.mask_at, 0xFF, 2 * mask_bytes);
    must_break(image, bytes, f.mask_at, 255, "nothing but edges");
}

/* Low and high of one axis exchanged, and bytes of extreme values. */
static void bent_bounds(const packed *image) {
    const some_block f = open_at(image, second_address(image));
    const uint32_t bounds_bytes = plt_block_bounds_bytes(f.bits), width = f.bits <= 16 ? 16 : 21;
    for (uint32_t axis = 0; axis < 3; axis++) {
        plt_lattice_box bounds;
        unsigned char *bytes = hostile_copy(image->bytes, image->size), *at = bytes + f.bounds_at;
        plt_block_bounds(&f.b, f.bits, &bounds);
        memset(at, 0, bounds_bytes);
        for (uint32_t a = 0; a < 3; a++) {
            plt_bits_put(at, a * width, width, a == axis ? bounds.hi[a] : bounds.lo[a]);
            plt_bits_put(at, (a + 3) * width, width, a == axis ? bounds.lo[a] : bounds.hi[a]);
        }
        must_break(image, bytes, f.bounds_at, 12, "bounds with hi below lo");
    }
    for (uint32_t i = 0; i < bounds_bytes; i++) {
        bend(image, f.bounds_at + i, 0xFF, 1, 255, "changed bounds");
        bend(image, f.bounds_at + i, 0, 1, 255, "changed bounds");
    }
    bend(image, f.bounds_at, 0xFFFFFFFFFFFFFFFFu, 6, 12, "bounds beyond the lattice");
}

/* Counts, strips and references of the last block, which has leaves. */
static void bent_geometry(const packed *image) {
    const some_block f = open_at(image, last_address(image));
    const uint32_t word0 = plt_get_u32(image->bytes + f.geometry_at);
    const uint32_t word1 = plt_get_u32(image->bytes + f.geometry_at + 4);
    const uint32_t strings[4] = {f.g.counts, f.g.starts, f.g.news, f.g.refs};
    bend(image, f.geometry_at, word0 ^ 1, 4, 18, "a first triangle that is not the first");
    bend(image, f.geometry_at, word0 ^ 0x08000000u, 4, 14, "a vertex more or less");
    bend(image, f.geometry_at + 4, word1 | 0x3Fu, 4, 14, "2,000 vertices");
    bend(image, f.geometry_at + 4, word1 ^ 0x40u, 4, 0, "another mesh"); /* SPEC 5.4 */
    for (uint32_t i = 0; i < 32; i++) {
        const uint32_t at = f.geometry_at + strings[i / 8] / 8;
        bend(image, at, 0xFFu << i % 8, 1, 255, "a changed string");
        bend(image, at, 0xFFu >> i % 8, 1, 255, "a changed string");
    }
}

static uint32_t bit_at(const packed *image, const some_block *f, uint32_t bit) {
    return image->bytes[f->geometry_at + bit / 8] >> bit % 8 & 1u;
}

/* The start of a strip moved to the next triangle: a leaf that began there no longer starts a
 * strip. */
static void moved_starts(const packed *image, const some_block *f) {
    uint32_t by_rule = 0;
    for (uint32_t bit = f->g.starts; bit + 1 < f->g.swaps; bit++) {
        if (bit_at(image, f, bit) && !bit_at(image, f, bit + 1)) {
            unsigned char *bytes = hostile_copy(image->bytes, image->size);
            bytes[f->geometry_at + bit / 8] ^= (unsigned char)(1u << bit % 8);
            bytes[f->geometry_at + (bit + 1) / 8] ^= (unsigned char)(1u << (bit + 1) % 8);
            compact_seal(bytes, image->size, 1);
            const hostile_result r = meet(bytes, image->size, "a moved start", bit);
            by_rule += r.fault.rule == 15;
            free(bytes);
        }
    }
    CHECK(image->info.leaf_triangles == 1 || by_rule > 0, "no leaf without a start was detected");
}

/* The first reference that is not new names the last vertex, or one beyond it. */
static void bent_references(const packed *image, const some_block *f) {
    const uint32_t known = f->g.vertices < 4 ? 0 : f->g.slots - f->g.vertices;
    CHECK(known > 0 && f->g.ref_bits > 0, "no reference to change");
    for (uint32_t beyond = 0; beyond < 2; beyond++) {
        unsigned char *bytes = hostile_copy(image->bytes, image->size);
        for (uint32_t i = 0; i < f->g.ref_bits; i++) {
            const uint32_t bit = f->g.refs + i;
            const uint32_t value = beyond ? 1 : (f->g.vertices - 1) >> i & 1;
            bytes[f->geometry_at + bit / 8] &= (unsigned char)~(1u << bit % 8);
            bytes[f->geometry_at + bit / 8] |= (unsigned char)(value << bit % 8);
        }
        must_break(image, bytes, f->geometry_at, 16, "a vertex not yet met");
    }
}

static void bent_strips(const packed *image) {
    const some_block f = open_at(image, second_address(image));
    for (uint32_t bit = f.g.starts; bit < f.g.positions; bit++) {
        unsigned char *bytes = hostile_copy(image->bytes, image->size);
        bytes[f.geometry_at + bit / 8] ^= (unsigned char)(1u << bit % 8);
        compact_seal(bytes, image->size, 1);
        const hostile_result r = meet(bytes, image->size, "a strip's bit", bit);
        const int swap = bit >= f.g.swaps && bit < f.g.news, ref = bit >= f.g.refs;
        CHECK(swap || ref ? r.status == PLT_OK || r.fault.rule == 16
                          : r.status == PLT_ERR_IMAGE && r.fault.rule >= 14,
              "bit %u: status %d, rule %u", bit, r.status, r.fault.rule);
        free(bytes);
    }
    moved_starts(image, &f);
    bent_references(image, &f);
}

static void bent_counts(const packed *image) {
    static const uint32_t counts[] = {24, 28, 36, 40, 44, 64, 220, 224};
    for (unsigned i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        const uint32_t was = plt_get_u32(image->bytes + counts[i]);
        bend(image, counts[i], was - 1, 4, 255, "a count too small");
        bend(image, counts[i], was + 1, 4, 255, "a count too large");
    }
    const uint32_t depth = plt_get_u32(image->bytes + 64);
    bend(image, 64, depth - 1, 4, 18, "a stack too small");
    bend(image, 64, depth + 1, 4, 18, "a stack too large");
    bend(image, 64, 0, 4, 18, "no stack");
    bend(image, 36, plt_get_u32(image->bytes + 36) - 1, 4, 18, "a list too few");
}

static void bent_primitive_ids(const packed *image) {
    const uint32_t at = plt_get_u32(image->bytes + HOSTILE_SECTION + 16 + 4);
    const uint32_t source = image->info.source_triangles;
    bend(image, at, 0xFFFFFFFF, 4, 19, "primitive ids beyond the last");
    bend(image, at, 3, 1, 19, "a rotation of 3");
    bend(image, AT_SOURCE, source - 1, 4, 19, "fewer source triangles than primitive ids");
    bend(image, AT_SOURCE, source + 5, 4, 0, "more source triangles than primitive ids");
}

/* Corners for a device build, which trusts nothing about them either. */
static void bent_corners(const packed *image) {
    const uint32_t width = plt_corner_width(image->info.lattice_bits),
                   bits = image->info.lattice_bits;
    const uint32_t bytes = image->info.triangles * 9 * width;
    const uint32_t hi = plt_get_u32(image->bytes + AT_BOX + 12);
    random_state r = {8};
    for (uint32_t at = 256; at < 256 + bytes; at += width) {
        bend(image, at, 0xFFFFFFFF, width, 20, "a corner beyond the lattice");
        bend(image, at, random_below(&r, 1u << bits), width, 255, "a corner elsewhere");
    }
    bend(image, 256, hi + 1u, width, 20, "a corner just outside the box");
    unsigned char *flat = room_get(image->size);
    for (int value = 0; value < 3; value++) { /* all triangles in one point, or none has area */
        memcpy(flat, image->bytes, image->size);
        for (uint32_t i = 0; i < bytes / width; i++) {
            const unsigned char *box = flat + AT_BOX + (value == 1 ? 12 : 0) + 4 * (i % 3);
            memcpy(flat + 256 + i * width, value == 2 ? flat + 256 + i % 9 * width : box, width);
        }
        compact_seal(flat, image->size, 1);
        CHECK(meet(flat, image->size, "corners in one point", 0).status == PLT_OK, "refused");
    }
    free(flat);
}

static void all_traps(void) {
    static const kind host = {PLT_BUILD_HOST, 0, 1, 14, 2}, fine = {PLT_BUILD_HOST, 0, 1, 21, 1};
    const kind *const both[2] = {&host, &fine};
    for (int i = 0; i < 2 && !rig_is_tiny(); i++) { /* tiny trees have fewer than two edges */
        packed image = image_of(both[i], SPHERE);
        CHECK(image.info.treelets >= 3, "%u blocks", image.info.treelets);
        test(i ? "... and one of 21 bits, K 1"
               : "forged links, nodes, strips, counts and primitive ids "
                 "break their invariants: 14 bits, K 2");
        bent_links(&image);
        bent_sizes(&image);
        bent_kinds(&image);
        bent_bounds(&image);
        bent_geometry(&image);
        bent_strips(&image);
        bent_counts(&image);
        bent_primitive_ids(&image);
        pack_free(&image);
    }
}

int main(void) {
    test("a compact image with any byte damaged is refused by a rule");
    every_kind(9, flips);
    test("an image too short or too long is refused, also when the header's size matches");
    every_kind(9, lengths);
    every_kind(9, sealed_lengths);
    test("a block with any byte damaged is detected by its own checks");
    every_kind(40, flips_in_blocks);
    test("extreme header words with a correct checksum do no harm");
    every_kind(9, header_words);
    every_kind(9, header_pairs);
    test("flipped bits with correct checksums and checks do no harm");
    every_kind(13, sealed_flips);
    CHECK(opened > 1000 && refused > 1000, "%u opened, %u refused", opened, refused);
    all_traps();
    test("forged corners do no harm to the device's builder");
    for (int i = 3; i < KINDS; i++) {
        packed image = image_of(&kinds[i], 30);
        bent_corners(&image);
        pack_free(&image);
    }
    printf("    %u images opened, %u refused\n", opened, refused);
    return test_done();
}
