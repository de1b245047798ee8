/* test_block_dump - the bytes in SPEC.md section 8 are what its annotation says
 *
 * The second decoder, written from SPEC.md alone, reads them; and the packer makes the same
 * bytes from the section's mesh.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/pack/pack.h"
#include "tests/reference/block_decoder.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

enum { DUMP_BYTES = 448 };

typedef struct dump_line {
    unsigned at;
    const char *hex;
} dump_line;

static const dump_line dump[] = {
    {0x000, "50 4c 41 4e 45 4c 45 54 01 00 00 00 00 01 00 00"},
    {0x010, "c0 01 00 00 d3 20 d8 49"},
    {0x018, "06 00 00 00 01 00 00 00"},
    {0x020, "01 00 00 00 01 00 00 00"},
    {0x028, "01 00 00 00 01 00 00 00"},
    {0x030, "40 00 00 00 02 00 00 00"},
    {0x038, "00 00 00 00 00 00 00 00"},
    {0x040, "01 00 00 00"},
    {0x044, "00 00 00 07"},
    {0x048, "00 00 00 00 00 00 00 00 00 00 00 00"},
    {0x054, "00 e0 7f 45 00 00 20 43 00 00 96 43"},
    {0x060, "00 00 01 01 02 00 00 00"},
    {0x068, "03 00 00 00 00 01 00 00 80 00 00 00 9c a4 ad 8b"},
    {0x078, "04 00 00 00 80 01 00 00 40 00 00 00 d8 78 8e 9f"},
    {0x0a8, "00 00 00 00 00 00 00 00 00 00 00 00"},
    {0x0b4, "00 00 80 3f 0c 00 00 00"},
    {0x0bc, "00 00 00 00 00 00 00 00 00 00 00 00"},
    {0x0c8, "fe 0f 00 00 a0 00 00 00 2c 01 00 00"},
    {0x0d4, "06 00 00 00 05 00 00 00"},
    {0x0dc, "20 00 00 00 38 00 00 00"},
    {0x100, "c0 01 bd de"},
    {0x104, "00 00 00 00 00 00 fe 0f a0 00 2c 01"},
    {0x110, "00 02 00"},
    {0x113, "ea 00 00 ea 46 8c"},
    {0x119, "00 00 00"},
    {0x11c, "00 00 00 50 00 00 68 1e"},
    {0x124, "97 c8 7f 15 a6 01 00 80"},
    {0x14c, "09"},
    {0x180, "a1 91 24 2d"},
};

/* The dump leaves out the positions; their coordinates are listed below it. */
static const uint32_t dump_vertex[10][3] = {
    {105, 0, 0},   {105, 90, 0},   {0, 0, 0},     {0, 90, 20},     {3990, 0, 10},
    {4094, 0, 10}, {4094, 80, 10}, {3990, 80, 0}, {3990, 160, 10}, {4094, 160, 300},
};

static const float dump_mesh[6][9] = {
    {105, 0, 0, 105, 90, 0, 0, 0, 0},           {3990, 0, 10, 4094, 0, 10, 4094, 80, 10},
    {4094, 80, 10, 3990, 80, 0, 3990, 0, 10},   {105, 90, 0, 0, 90, 20, 0, 0, 0},
    {3990, 160, 10, 3990, 80, 0, 4094, 80, 10}, {4094, 160, 300, 3990, 160, 10, 4094, 0, 10},
};

/* The table at the end of the section: canonical corners, primitive id, rotation. */
static const uint32_t dump_table[6][5] = {
    {2, 0, 1, 0, 1}, {2, 1, 3, 3, 1}, {4, 5, 6, 1, 0},
    {4, 6, 7, 2, 1}, {7, 6, 8, 4, 2}, {8, 5, 9, 5, 2},
};

static void put_bits(unsigned char *bytes, size_t bit, uint32_t number, unsigned width) {
    for (unsigned i = 0; i < width; i++) {
        bytes[(bit + i) / 8] |= (unsigned char)((number >> i & 1u) << (bit + i) % 8);
    }
}

static void put_line(unsigned char bytes[DUMP_BYTES], const dump_line *line) {
    unsigned char *to = bytes + line->at;
    for (const char *hex = line->hex; *hex != '\0'; hex += hex[2] == ' ' ? 3 : 2) {
        *to++ = (unsigned char)strtoul(hex, NULL, 16);
    }
}

static void make_dump(unsigned char bytes[DUMP_BYTES]) {
    memset(bytes, 0, DUMP_BYTES);
    for (size_t line = 0; line < sizeof dump / sizeof dump[0]; line++) {
        put_line(bytes, &dump[line]);
    }
    static const unsigned width[3] = {12, 8, 9};
    size_t bit = 8 * (size_t)0x11c + 98;
    for (size_t i = 0; i < 30; i++) {
        put_bits(bytes, bit, dump_vertex[i / 3][i % 3], width[i % 3]);
        bit += width[i % 3];
    }
    CHECK(bit == 8 * (size_t)0x11c + 388, "positions end at %zu", bit);
}

/* The bytes of positions in the dump are those that the text describes. */
static void check_dump_positions(const unsigned char bytes[DUMP_BYTES]) {
    static const unsigned char first[] = {0xa6, 0x01, 0x00, 0x80};
    CHECK(memcmp(bytes + 0x128, first, sizeof first) == 0, "first bytes of the positions");
    CHECK(bytes[0x14c] == 0x09 && bytes[0x14d] == 0, "last byte of the positions");
}

static void check_dump_boxes(const decoded_image *d) {
    static const int32_t lo[2][3] = {{0, 0, 0}, {3978, 0, 0}};
    static const int32_t hi[2][3] = {{116, 90, 20}, {4094, 160, 300}};
    for (int c = 0; c < 2; c++) {
        const decoded_child *child = &d->node[0].child[c];
        CHECK(child->kind == (c == 0 ? DECODED_LEAF : DECODED_PAIR), "child %d", c);
        CHECK(memcmp(child->box.lo, lo[c], sizeof lo[c]) == 0, "child %d: lo", c);
        CHECK(memcmp(child->box.hi, hi[c], sizeof hi[c]) == 0, "child %d: hi", c);
    }
}

/* The triangle at index t of an image is that of a row of the table. */
static void check_dump_triangle(const decoded_image *d, uint32_t t, const uint32_t row[5]) {
    const decoded_triangle *triangle = &d->triangle[t];
    CHECK(triangle->primitive_id == row[3], "index %u: number", t);
    CHECK(triangle->rotation == row[4], "index %u: turn", t);
    for (uint32_t i = 0; i < 9; i++) {
        CHECK(triangle->corner[i / 3][i % 3] == (int32_t)dump_vertex[row[i / 3]][i % 3],
              "index %u: corner %u", t, i / 3);
        const uint32_t from = (i / 3 + 3 - triangle->rotation) % 3;
        CHECK(triangle->point[i / 3][i % 3] == dump_mesh[row[3]][3 * from + i % 3],
              "index %u: corner %u of the mesh", t, from);
    }
}

static void check_dump_triangles(const decoded_image *d) {
    for (uint32_t t = 0; t < 6; t++) {
        check_dump_triangle(d, t, dump_table[t]);
    }
}

static void check_dump(void) {
    test("the dump in SPEC.md section 8 reads as its annotation says");
    unsigned char bytes[DUMP_BYTES];
    decoded_image d;
    make_dump(bytes);
    check_dump_positions(bytes);
    const int status = block_decode(&d, bytes, sizeof bytes);
    CHECK(status == 0, "%s", d.wrong);
    if (status == 0) {
        const decoded_block *block = &d.block[0];
        CHECK(d.triangles == 6 && d.nodes == 1 && d.leaves == 2 && d.pairs == 1, "counts");
        CHECK(d.blocks == 1 && d.depth == 1 && d.header.source_triangles == 6, "counts");
        CHECK(block->nodes_bytes == 28 && block->geometry_bytes == 56, "parts");
        CHECK(block->takes_bytes == 88, "block");
        CHECK(block->vertices == 10 && block->strips == 3 && block->mesh == 0, "header");
        CHECK(d.leaf[0].triangles == 2 && d.leaf[1].triangles == 4, "leaves");
        check_dump_boxes(&d);
        check_dump_triangles(&d);
    }
    block_decode_free(&d);
}

/* The triangles of the dump, each once, in any order. */
static void check_dump_holds(const packed *image) {
    decoded_image d;
    unsigned seen = 0;
    const int status = block_decode(&d, image->bytes, image->size);
    CHECK(status == 0 && d.triangles == 6, "%u triangles; %s", d.triangles, d.wrong);
    for (uint32_t t = 0; t < 6 && status == 0 && d.triangles == 6; t++) {
        for (uint32_t row = 0; row < 6; row++) {
            if (dump_table[row][3] == d.triangle[t].primitive_id) {
                check_dump_triangle(&d, t, dump_table[row]);
                seen |= 1u << row;
            }
        }
    }
    CHECK(seen == 63, "not every triangle is there: %x", seen);
    block_decode_free(&d);
}

static void check_dump_bytes(const packed *image, const unsigned char bytes[DUMP_BYTES]) {
    for (unsigned i = 0; i < DUMP_BYTES && i < image->size; i++) {
        CHECK(image->bytes[i] == bytes[i], "%04x: %02x, not %02x", i, image->bytes[i], bytes[i]);
    }
}

/* With checks of primitive ids: what differs. */
static const dump_line dump_checked[] = {{0x014, "8b af 1e e8"},
                                         {0x074, "a1 e9 b8 52"},
                                         {0x0d8, "05 01 00 00"},
                                         {0x122, "a5 38"},
                                         {0x152, "1d 52"}};

static void check_dump_packs(int checks) {
    unsigned char bytes[DUMP_BYTES];
    mesh m = {0};
    fail f = {""};
    make_dump(bytes);
    for (size_t i = 0; i < sizeof dump_checked / sizeof *dump_checked && checks; i++) {
        put_line(bytes, &dump_checked[i]);
    }
    for (uint32_t i = 0; i < 18; i++) {
        const float *v = &dump_mesh[i / 3][3 * (size_t)(i % 3)];
        mesh_add_vertex(&m, v[0], v[1], v[2], &f);
    }
    for (uint32_t t = 0; t < 6; t++) {
        mesh_add_triangle(&m, 3 * t, 3 * t + 1, 3 * t + 2, &f);
    }
    const compact_options options = {
        .lattice_bits = 12, .numbers = 1, .checks = (uint8_t)checks, .leaf_triangles = 2};
    packed image = {0};
    lattice_loss loss;
    const int status = pack_compact(&image, &m, &options, "dump", &loss, &f);
    CHECK(status == 0 && image.size == DUMP_BYTES, "%u bytes; %s", image.size, f.text);
    check_dump_holds(&image);
    if (!rig_is_tiny()) { /* with fewer bins the tree is another */
        check_dump_bytes(&image, bytes);
    }
    pack_free(&image);
    mesh_free(&m);
}

int main(void) {
    check_dump();
    test(rig_is_tiny() ? "the mesh of SPEC.md section 8 packs to an image that holds it"
                       : "the mesh of SPEC.md section 8 packs to the bytes of its dump");
    check_dump_packs(0);
    check_dump_packs(1);
    return test_done();
}
