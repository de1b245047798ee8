/* test_image_hostile - damaged, forged and malicious images
 *
 * Every image is opened mapped and streamed, copied to exactly its size, in exactly the arena
 * it needs (hostile/images.h): sanitizers check the rest.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/header.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"
#include "tests/hostile/attacks.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

static packed image_of(uint32_t triangles, uint8_t build, uint32_t k, uint32_t n) {
    mesh m = {0};
    packed image;
    fail f = {""};
    const pack_options options = {
        .splits = PLT_SPLIT_SAH, .build = build, .leaf_triangles = k, .treelet_nodes = n};
    shape_soup(&m, triangles, 0.8f, triangles);
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

/* Both orders alternately. */
static hostile_result open_once(const unsigned char *bytes, uint32_t size, uint8_t streamed,
                                uint32_t at) {
    const hostile_config config = {streamed, (uint8_t)((at ^ streamed) & 1), 2, 0};
    return hostile_try(bytes, size, config);
}

/* ---- forgeries: checksums are right ---------------------------------------------------- */

static void sealed_flips(const packed *image, uint32_t step) {
    for (uint32_t at = 0; at < image->size; at += step) {
        for (int bit = 0; bit < 9; bit++) {
            const unsigned char pattern = bit < 8 ? (unsigned char)(1u << bit) : 0xFF;
            image->bytes[at] ^= pattern;
            hostile_seal(image->bytes, image->size);
            meet(image->bytes, image->size, "a sealed flip", at);
            image->bytes[at] ^= pattern;
        }
    }
    hostile_seal(image->bytes, image->size);
}

/* Two random header words at a time, each set to one of a few values. */
static void header_pairs(const packed *image, uint32_t rounds) {
    random_state r = {6};
    unsigned char *bytes = room_get(image->size);
    for (uint32_t i = 0; i < rounds; i++) {
        memcpy(bytes, image->bytes, image->size);
        for (int k = 0; k < 2; k++) {
            unsigned char *word = bytes + 24 + 4 * random_below(&r, 28);
            const uint32_t value = plt_get_u32(word);
            plt_put_u32(word, random_below(&r, 2) ? random_below(&r, 40)
                                                  : value + random_below(&r, 5) - 2);
        }
        hostile_seal(bytes, image->size);
        meet(bytes, image->size, "header words", i);
    }
    free(bytes);
}

/* ---- traps: links and records that lead out of range ------------------------------------ */

static unsigned char *node_at(const packed *image, uint32_t node) {
    return image->bytes + 256 + 32 * (size_t)node;
}

static unsigned char *record_at(const packed *image, uint32_t record) {
    return image->bytes + 256 + image->info.node_bytes + 40 * (size_t)record;
}

static uint32_t by_limit; /* traps that a tiny limit met first */

/* The changed image must break invariant `rule`; then it is restored. */
static void breaks(packed *image, unsigned char *word, uint32_t value, uint8_t rule,
                   const char *what) {
    const uint32_t was = plt_get_u32(word);
    plt_put_u32(word, value);
    hostile_seal(image->bytes, image->size);
    const hostile_result r = meet(image->bytes, image->size, what, value);
    /* With a tiny limit a cycle is too deep before all nodes have been counted. */
    const int limit = rig_is_tiny() && r.status == PLT_ERR_LIMIT;
    CHECK(limit || (r.status == PLT_ERR_IMAGE && r.fault.kind == 'I' && r.fault.rule == rule),
          "%s: status %d, rule %c%u, not I%u", what, r.status, r.fault.kind ? r.fault.kind : '-',
          r.fault.rule, rule);
    by_limit += (uint32_t)limit;
    plt_put_u32(word, was);
    hostile_seal(image->bytes, image->size);
}

/* A link from a node to another node, for the traps to change: a second one, so that a
 * traversal meets a list before it, and twice if it leads back (I4; else I2 ends it). */
static unsigned char *some_inner_link(const packed *image, uint32_t *node) {
    for (uint32_t i = image->info.node_slots; i-- > 1;) {
        unsigned char *link = node_at(image, i) + 24 + 4;
        const uint32_t value = plt_get_u32(link);
        if ((value & 1) == 0 && value >> 5 != 0) {
            *node = i;
            return link;
        }
    }
    return NULL;
}

static unsigned char *some_leaf_link(const packed *image) {
    for (uint32_t i = 0; i < image->info.node_slots; i++) {
        for (int c = 0; c < 2; c++) {
            unsigned char *link = node_at(image, i) + 24 + 4 * c;
            if (plt_get_u32(link) & 1) {
                return link;
            }
        }
    }
    return NULL;
}

static void bent_links(packed *image) {
    uint32_t node = 0;
    unsigned char *inner = some_inner_link(image, &node), *leaf = some_leaf_link(image);
    CHECK(inner != NULL && leaf != NULL, "no link to change");
    if (inner == NULL || leaf == NULL) {
        return;
    }
    const uint32_t owners = plt_get_u32(inner) & 0x1C, slots = image->info.node_slots;
    breaks(image, inner, owners | node << 5, 4, "a node below itself");
    breaks(image, inner, owners | 0, 1, "the root below a node");
    breaks(image, inner, owners | 2 | 0, 4, "the root below an edge");
    breaks(image, inner, owners | slots << 5, 1, "a node just beyond the last");
    breaks(image, inner, owners | 0xFFFFFFE0u, 1, "a node far beyond");
    breaks(image, leaf, 0xFFFFFFE0u | 1, 4, "a list far beyond");
    breaks(image, leaf, image->info.triangles << 5 | 1, 4, "a list just beyond");
    breaks(image, image->bytes + 68, slots << 5, 1, "a root beyond the last");
    breaks(image, image->bytes + 68, 0xFFFFFFFF, 4, "no root");
    breaks(image, image->bytes + 68, 1, 4, "a root of one list");
    breaks(image, record_at(image, image->info.triangles - 1) + 36, 0, 3,
           "no end of the last list");
}

static void bent_values(packed *image) {
    static const uint32_t bad[4] = {0x7FC00000, 0x7F800000, 0xFF800000, 0x7F7FFFFF};
    for (int i = 0; i < 4; i++) {
        breaks(image, record_at(image, 2) + 16, bad[i], 5, "a corner that is no coordinate");
        breaks(image, node_at(image, 1) + 8, bad[i], 6, "a plane that is no coordinate");
    }
    breaks(image, record_at(image, 1) + 36, 0x07FFFFFF, 7, "a primitive id beyond the last");
    breaks(image, record_at(image, 1) + 36, 0x80000000 | image->info.triangles, 7,
           "a primitive id just beyond");
    static const uint8_t count_at[6] = {28, 36, 40, 44, 56, 64};
    for (int i = 0; i < 6; i++) {
        unsigned char *word = image->bytes + count_at[i];
        breaks(image, word, plt_get_u32(word) - 1, 8, "a count too small");
    }
    breaks(image, image->bytes + 60, plt_get_u32(image->bytes + 60) + 1, 8, "a need too large");
    breaks(image, image->bytes + 56, plt_get_u32(image->bytes + 56) + 7, 8,
           "a local need too large");
}

/* `levels` nodes in a row, each with a list and the next; the last with two. */
static packed chain(uint32_t levels) {
    packed image = {.size = 0};
    plt_header h = {.info = {.triangles = levels + 1,
                             .nodes = levels,
                             .node_slots = levels,
                             .leaf_lists = levels + 1,
                             .treelets = levels,
                             .treelet_nodes = 1,
                             .leaf_triangles = 1,
                             .local_stack_entries = 0,
                             .global_stack_entries = levels + 1,
                             .depth_stack_entries = levels,
                             .hi = {1, 1, 1}}};
    unsigned char header[256];
    plt_header_write(header, &h);
    image.size = h.info.image_bytes;
    image.info = h.info;
    image.bytes = room_get(image.size);
    memset(image.bytes, 0, image.size);
    memcpy(image.bytes, header, 256);
    for (uint32_t i = 0; i < levels; i++) {
        const int last = i + 1 == levels;
        plt_put_u32(node_at(&image, i) + 24, i << 5 | 1);
        plt_put_u32(node_at(&image, i) + 28, (i + 1) << 5 | (last ? 1 : 2));
    }
    for (uint32_t i = 0; i <= levels; i++) {
        const float corner[9] = {0, 0, 0, 1, 0, 0, 0, 1, 1};
        plt_put_floats(record_at(&image, i), corner, 9);
        plt_put_u32(record_at(&image, i) + 36, i | 0x80000000u);
    }
    hostile_seal(image.bytes, image.size);
    return image;
}

static void deep_chains(void) {
    for (uint32_t levels = 2; levels < 2000; levels += levels < PLT_DEPTH_MAX + 3 ? 1 : 177) {
        packed image = chain(levels);
        const hostile_result r = meet(image.bytes, image.size, "a chain", levels);
        const int due =
            levels <= PLT_DEPTH_MAX && levels + 1 <= PLT_GLOBAL_STACK_MAX ? PLT_OK : PLT_ERR_LIMIT;
        CHECK(r.status == due, "%u levels: status %d", levels, r.status);
        free(image.bytes);
    }
}

/* Many links to the same list: refused quickly. */
static void shared_children(void) {
    packed image = chain(PLT_DEPTH_MAX < 40 ? PLT_DEPTH_MAX : 40);
    for (uint32_t i = 0; i + 1 < image.info.node_slots; i++) {
        plt_put_u32(node_at(&image, i) + 24, (i + 1) << 5 | 2);
    }
    hostile_seal(image.bytes, image.size);
    const hostile_result r = meet(image.bytes, image.size, "2^40 paths", 0);
    CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == 'I', "status %d", r.status);
    free(image.bytes);
}

static void long_lists(void) { /* every list is all remaining records: n^2 / 2 in all */
    packed image = chain(PLT_DEPTH_MAX < 60 ? PLT_DEPTH_MAX : 60);
    for (uint32_t i = 0; i + 1 < image.info.triangles; i++) {
        plt_put_u32(record_at(&image, i) + 36, i);
    }
    hostile_seal(image.bytes, image.size);
    const hostile_result r = meet(image.bytes, image.size, "overlapping lists", 0);
    CHECK(r.status == PLT_ERR_IMAGE && r.fault.rule == 4, "status %d, rule %u", r.status,
          r.fault.rule);
    free(image.bytes);
}

static void all_builds(void (*attack)(const packed *image)) {
    for (uint8_t build = 0; build < 3; build++) {
        packed image = image_of(12, build, 1, 2);
        attack(&image);
        pack_free(&image);
    }
    packed nothing = image_of(0, PLT_BUILD_HOST, 1, 1);
    attack(&nothing);
    pack_free(&nothing);
}

static void every_sealed_flip(const packed *image) {
    sealed_flips(image, 1);
}

static void many_pairs(const packed *image) {
    header_pairs(image, 3000);
}

int main(void) {
    test("an image with any byte damaged is refused by a rule");
    all_builds(flips);
    test("an image too short or too long is refused by a rule");
    all_builds(lengths);
    CHECK(opened == 0, "%u opened", opened);
    test("extreme header words with a correct checksum do no harm");
    all_builds(header_words);
    all_builds(many_pairs);
    test("flipped bits with correct checksums do no harm");
    all_builds(every_sealed_flip);
    packed large = image_of(rig_triangles(100, 2), PLT_BUILD_HOST, 2, 3);
    sealed_flips(&large, 3);
    CHECK(opened > 1000 && refused > 1000, "%u opened, %u refused", opened, refused);
    printf("    %u images opened, %u refused\n", opened, refused);
    test("links that lead out of range, in cycles or twice to one node break an invariant");
    bent_links(&large);
    shared_children();
    long_lists();
    test("forged corners, planes, primitive ids and counts break an invariant");
    bent_values(&large);
    CHECK(by_limit <= 2, "%u traps ended at a limit", by_limit);
    test("a chain of up to PLT_DEPTH_MAX nodes opens, a longer one is over the limit");
    deep_chains();
    pack_free(&large);
    return test_done();
}
