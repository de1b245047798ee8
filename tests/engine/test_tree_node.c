/* test_tree_node - the thesis node: encoding and decoding, and bytes worked out by hand
 *
 * The literal node's bytes were worked out by hand from figure 3.5 of Karrenberg 2007:
 * planes_min, planes_max, left link, right link, all words little-endian.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "engine/tree/compact/leaf.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/checks.h"
#include "engine/tree/thesis/node.h"
#include "host_tools/pack/checks.h"
#include "tests/reference/random.h"
#include "tests/test.h"

static plt_box box_of(const float lo[3], const float hi[3]) {
    const plt_box b = {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
    return b;
}

/* Two of a few values, so planes are often shared and extents zero. */
static void interval(random_state *r, int kind, float *lo, float *hi) {
    float a = random_float(r, -100.0f, 100.0f), b = random_float(r, -100.0f, 100.0f);
    if (kind == 1) {
        a = (float)random_below(r, 4) - 1.5f;
        b = (float)random_below(r, 4) - 1.5f;
    } else if (kind == 2) {
        a = ldexpf(a, (int)random_below(r, 160) - 120);
        b = random_below(r, 3) ? -a : a;
    }
    *lo = a < b ? a : b;
    *hi = a < b ? b : a;
}

static void random_children(random_state *r, int kind, plt_box child[2]) {
    for (int c = 0; c < 2; c++) {
        for (int a = 0; a < 3; a++) {
            interval(r, kind, &child[c].lo[a], &child[c].hi[a]);
        }
    }
    if (random_below(r, 8) == 0) {
        child[1] = child[0];
    }
}

static void round_trip(random_state *r, int kind) {
    plt_box child[2], found[2];
    plt_node node;
    random_children(r, kind, child);
    plt_box parent = child[0];
    plt_box_add(&parent, &child[1]);
    memset(&node, 0xFF, sizeof node);
    plt_node_encode(&node, &parent, child);
    for (int c = 0; c < 2; c++) {
        const uint32_t link = plt_link_make(random_below(r, PLT_INDEX_MAX), random_below(r, 4));
        plt_node_relink(&node, c, link);
        CHECK((plt_node_link(&node, c) & ~PLT_LINK_OWNERS) == link, "the link is kept");
    }
    plt_node_decode(&node, &parent, found);
    CHECK(memcmp(found, child, sizeof found) == 0, "kind %d: x %g .. %g and %g .. %g", kind,
          (double)child[0].lo[0], (double)child[0].hi[0], (double)child[1].lo[0],
          (double)child[1].hi[0]);
}

/* A chain of nested boxes, decoded from the root's box alone. */
static void nested(random_state *r) {
    enum { LEVELS = 40 };
    plt_node node[LEVELS];
    plt_box box[LEVELS + 1];
    for (int a = 0; a < 3; a++) {
        box[0].lo[a] = -1.0f;
        box[0].hi[a] = 1.0f;
    }
    for (int i = 0; i < LEVELS; i++) { /* left: all but a slab; right: the slab */
        plt_box child[2] = {box[i], box[i]};
        const unsigned axis = random_below(r, 3);
        const float cut = random_float(r, box[i].lo[axis], box[i].hi[axis]);
        child[0].hi[axis] = child[1].lo[axis] = cut;
        plt_node_encode(&node[i], &box[i], child);
        box[i + 1] = child[i & 1];
    }
    plt_box at = box[0];
    for (int i = 0; i < LEVELS; i++) {
        plt_box child[2];
        plt_node_decode(&node[i], &at, child);
        at = child[i & 1];
        CHECK(memcmp(&at, &box[i + 1], sizeof at) == 0, "level %d", i + 1);
    }
}

/* Left child x 0 .. 2, y -1 .. 1, z 0 .. 1; right child x 1 .. 4, y -2 .. 0.5,
 * z 0 .. 1. Of the parent 0 .. 4, -2 .. 1, 0 .. 1: x min is the left's, so the
 * right's 1 is stored (bit 4 of the left link); y min the right's, so the
 * left's -1; z is shared, stored for the left. x max is the right's, so the
 * left's 2; y max the left's, so the right's 0.5 (bit 3 of the right link). */
static const unsigned char literal[PLT_NODE_BYTES] = {
    0x00, 0x00, 0x80, 0x3F, 0x00, 0x00, 0x80, 0xBF, 0x00, 0x00, 0x00, 0x00, /* 1 -1 0 */
    0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00, 0x3F, 0x00, 0x00, 0x80, 0x3F, /* 2 0.5 1 */
    0x50, 0x01, 0x00, 0x00, /* left: index 10, x owned by the right, inner */
    0x6B, 0x02, 0x00, 0x00  /* right: index 19, y owned by the right, leaf, two lists */
};

static void by_hand(void) {
    const float left_lo[3] = {0, -1, 0}, left_hi[3] = {2, 1, 1};
    const float right_lo[3] = {1, -2, 0}, right_hi[3] = {4, 0.5f, 1};
    const float lo[3] = {0, -2, 0}, hi[3] = {4, 1, 1};
    const plt_box child[2] = {box_of(left_lo, left_hi), box_of(right_lo, right_hi)};
    const plt_box parent = box_of(lo, hi);
    plt_box found[2];
    plt_node node;
    memcpy(&node, literal, sizeof node);
    plt_node_decode(&node, &parent, found);
    CHECK(memcmp(found, child, sizeof found) == 0, "decoded boxes");
    CHECK(plt_link_index(plt_node_link(&node, 0)) == 10 &&
              plt_link_is_inner(plt_node_link(&node, 0)),
          "left link");
    const uint32_t right = plt_node_link(&node, 1);
    CHECK(plt_link_index(right) == 19 && plt_link_is_leaf(right) && plt_link_lists(right) == 2,
          "right link");
    plt_node_encode(&node, &parent, child);
    plt_node_relink(&node, 0, plt_link_make(10, 0));
    plt_node_relink(&node, 1, plt_link_make(19, PLT_LINK_LEAF | PLT_LINK_TWO));
    CHECK(memcmp(&node, literal, sizeof node) == 0, "encoded bytes");
}

static void links(void) {
    static const uint32_t index[4] = {0, 1, 12345, PLT_INDEX_MAX};
    for (int i = 0; i < 4; i++) {
        for (uint32_t kind = 0; kind < 4; kind++) {
            const uint32_t link = plt_link_make(index[i], kind);
            CHECK(link == index[i] * 32 + kind, "%08x", link);
            CHECK(plt_link_index(link | PLT_LINK_OWNERS) == index[i], "%08x", link);
            CHECK(plt_link_is_leaf(link) == (kind == 1 || kind == 3), "%08x", link);
            CHECK(plt_link_is_inner(link | PLT_LINK_OWNERS) == (kind == 0), "%08x", link);
            CHECK(plt_link_lists(link) == (kind >= 2 ? 2u : 1u), "%08x", link);
        }
    }
    CHECK(plt_owner_bit(0) == 16 && plt_owner_bit(1) == 8 && plt_owner_bit(2) == 4, "owners");
}

/* Corners, primitive id, last bit: 40 bytes, worked out by hand. */
static void record(void) {
    const float corner[9] = {1, 2, 3, -4, 5, -6, 0.5f, 0.25f, 7};
    plt_record r;
    memset(&r, 0, sizeof r);
    plt_put_floats((unsigned char *)r.word, corner, 9);
    plt_put_u32(&r.word[9], 0x01020304);
    plt_record_set_last(&r, 1);
    const unsigned char *bytes = (const unsigned char *)&r;
    CHECK(bytes[0] == 0 && bytes[2] == 0x80 && bytes[3] == 0x3F, "1.0");
    CHECK(bytes[36] == 4 && bytes[37] == 3 && bytes[38] == 2 && bytes[39] == 0x81, "number");
    CHECK(plt_record_is_last(&r) && plt_primitive_id(plt_get_u32(&r.word[9])) == 0x01020304,
          "last");
    plt_record_set_last(&r, 0);
    CHECK(!plt_record_is_last(&r) && plt_primitive_id(plt_get_u32(&r.word[9])) == 0x01020304,
          "not last");
    const plt_box b = plt_record_box(&r);
    const float lo[3] = {-4, 0.25f, -6}, hi[3] = {1, 5, 7};
    CHECK(memcmp(b.lo, lo, sizeof lo) == 0 && memcmp(b.hi, hi, sizeof hi) == 0, "box");
}

/* ---- checks (SPEC.md, 4.14) ------------------------------------------------------- */

/* A checksum is linear: what one wrong bit does to it does not depend on the other bits. */
static void node_bits(random_state *r) {
    plt_node node;
    for (int i = 0; i < 8; i++) {
        node.word[i] = random_bits(r);
    }
    const uint8_t check = plt_node_check(&node);
    for (uint32_t bit = 0; bit < 256; bit++) {
        node.word[bit / 32] ^= 1u << bit % 32;
        CHECK(plt_node_check(&node) != check, "bit %u of a node is not noticed", bit);
        node.word[bit / 32] ^= 1u << bit % 32;
    }
}

static int page_is_right(const plt_record *page) {
    uint16_t held;
    return plt_page_check(page, &held) == held;
}

static void page_bits(random_state *r) {
    plt_record page[PLT_PAGE_RECORDS];
    for (uint32_t i = 0; i < 10 * PLT_PAGE_RECORDS; i++) {
        page[i / 10].word[i % 10] = random_bits(r);
    }
    checks_put_records(page, PLT_PAGE_RECORDS);
    CHECK(page_is_right(page), "a page as it is packed");
    for (uint32_t bit = 0; bit < 320 * PLT_PAGE_RECORDS; bit++) {
        uint32_t *word = &page[bit / 320].word[bit / 32 % 10];
        *word ^= 1u << bit % 32;
        CHECK(!page_is_right(page), "bit %u of a page is not noticed", bit);
        *word ^= 1u << bit % 32;
    }
    plt_record swapped = page[2];
    page[2] = page[5];
    page[5] = swapped;
    CHECK(!page_is_right(page), "two records of a page in each other's place");
}

/* Primitive ids of the largest block, of 29 bits. */
static void id_bits(random_state *r) {
    enum { BYTES = PLT_BLOCK_TRIANGLES_MOST * 29 / 8 };
    static unsigned char ids[BYTES];
    for (uint32_t i = 0; i < BYTES; i++) {
        ids[i] = (unsigned char)random_bits(r);
    }
    const uint16_t check = plt_block_ids_check(ids, BYTES);
    for (uint32_t bit = 0; bit < 8 * BYTES; bit++) {
        ids[bit / 8] ^= (unsigned char)(1u << bit % 8);
        CHECK(plt_block_ids_check(ids, BYTES) != check, "bit %u of ids is not noticed", bit);
        ids[bit / 8] ^= (unsigned char)(1u << bit % 8);
    }
}

int main(void) {
    random_state r = {1};
    test("decoding gives back both children's boxes exactly");
    for (int i = 0; i < 90000; i++) {
        round_trip(&r, i % 3);
    }
    test("boxes stay exact through forty levels of nodes");
    for (int i = 0; i < 200; i++) {
        nested(&r);
    }
    test("a node worked out by hand from figure 3.5 is decoded and encoded correctly");
    by_hand();
    test("a link has its index above five bits of kind and owners");
    links();
    test("a record has three corners, its primitive id and the last bit in 40 bytes");
    record();
    test("one wrong bit of a node, a page of records or primitive ids changes its check");
    node_bits(&r);
    page_bits(&r);
    id_bits(&r);
    return test_done();
}
