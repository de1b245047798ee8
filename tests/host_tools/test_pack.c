/* test_pack - an image holds the mesh, whole and unchanged, and the options
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/image/header.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/link.h"
#include "engine/tree/thesis/node.h"
#include "host_tools/pack/pack.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

/* Triangles that share no vertex, with odd ones among them: degenerate to a
 * point or a line, zeros of both signs, the largest and smallest floats. */
static void make_mesh(mesh *m, uint32_t triangles) {
    static const float odd[] = {0.0f, -0.0f, PLT_COORD_MAX, -PLT_COORD_MAX, 1.0e-40f, -1.0e-40f};
    random_state random = {triangles};
    fail f = {""};
    for (uint32_t i = 0; i < triangles; i++) {
        for (int corner = 0; corner < 3; corner++) {
            float p[3];
            for (int a = 0; a < 3; a++) {
                p[a] = random_float(&random, -10.0f, 10.0f);
                p[a] = i % 5 == 4 ? odd[random_below(&random, 6)] : p[a];
            }
            mesh_add_vertex(m, p[0], p[1], p[2], &f);
        }
        const uint32_t first = 3 * i, second = i % 7 == 6 ? first : first + 1;
        mesh_add_triangle(m, first, second, i % 14 == 13 ? first : first + 2, &f);
    }
}

/* The record's corners, from the one that its rotation names on, are the mesh's. */
static int same_corners(const plt_record *r, const mesh *m, uint32_t id) {
    const uint32_t rotation = plt_get_u32(&r->word[9]) / 0x20000000u % 4; /* SPEC.md, 4.4 */
    for (size_t corner = 0; corner < 3; corner++) {
        const float *vertex = m->vertex + 3 * (size_t)m->triangle[3 * (size_t)id + corner];
        if (memcmp(&r->word[3 * ((rotation + corner) % 3)], vertex, 3 * sizeof *vertex) != 0) {
            return 0;
        }
    }
    return rotation < 3;
}

/* Each primitive id once, each corner bit for bit (on a little-endian host). */
static void check_records(const packed *image, const mesh *m) {
    const plt_info *info = &image->info;
    const plt_record *records =
        (const plt_record *)(const void *)(image->bytes + PLT_HEADER_BYTES +
                                           plt_section_bytes(info->node_slots, PLT_NODE_BYTES));
    unsigned char *seen = calloc(m->triangles + 1, 1);
    CHECK(seen != NULL, "out of memory");
    for (uint32_t i = 0; i < info->triangles && seen != NULL; i++) {
        const uint32_t id = plt_get_u32(&records[i].word[9]) % 0x8000000u; /* SPEC.md, 4.4 */
        CHECK(id < m->triangles && !seen[id], "record %u: primitive id %u", i, id);
        if (id < m->triangles) {
            seen[id] = 1;
            CHECK(same_corners(&records[i], m, id), "record %u: triangle %u", i, id);
        }
    }
    free(seen);
}

static void check_image(const packed *image, const mesh *m, const pack_options *o) {
    const plt_source source = rig_source(image);
    plt_info info;
    plt_fault fault;
    CHECK(plt_image_info(&source, &info, &fault) == PLT_OK, "%s", fault.message);
    CHECK(info.triangles == m->triangles, "%u triangles", info.triangles);
    CHECK(info.image_bytes == image->size, "%u bytes", info.image_bytes);
    CHECK(info.splits == o->splits && info.build == o->build, "%u %u", info.splits, info.build);
    CHECK(info.treelet_nodes == o->treelet_nodes, "%u nodes", info.treelet_nodes);
    CHECK(o->build == PLT_BUILD_NONE || info.leaf_triangles == o->leaf_triangles, "%u triangles",
          info.leaf_triangles);
    check_records(image, m);
}

static void check_options(uint32_t triangles) {
    mesh m = {0};
    make_mesh(&m, triangles);
    for (unsigned i = 0; i < 18; i++) {
        const pack_options options = {.splits = i & 1,
                                      .build = (uint8_t)(i / 2 % 3),
                                      .leaf_triangles = 1u << i / 6,
                                      .treelet_nodes = 1 + 5 * i,
                                      .checks = i / 2 % 2};
        packed image, again;
        fail f = {""};
        CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
        CHECK(pack_mesh(&again, &m, &options, "test", &f) == 0, "%s", f.text);
        if (image.bytes != NULL && again.bytes != NULL) {
            check_image(&image, &m, &options);
            CHECK(image.size == again.size && !memcmp(image.bytes, again.bytes, image.size),
                  "options %u differ the second time", i);
        }
        pack_free(&image);
        pack_free(&again);
    }
    mesh_free(&m);
}

/* The scene of SPEC.md, section 7, with checks: the bytes that it lists. */
typedef struct word_at {
    uint32_t at, word;
} word_at;

static const word_at checked_words[] = {
    {0x10, 0x2c0},       {0x14, 0xE558844F},  {0x64, 3},           {0x78, 2},
    {0x7c, 0x140},       {0x80, 0x140},       {0x84, 0xA38BB899},  {0x88, 6},
    {0x8c, 0x280},       {0x90, 0x40},        {0x94, 0xDB07F5A3},  {0x164, 0x98000000},
    {0x18c, 0x80000001}, {0x1b4, 0x90000002}, {0x1dc, 0x10000000}, {0x204, 0x18000000},
    {0x22c, 0x08000000}, {0x254, 0},          {0x27c, 0x08000000}, {0x280, 0x0A4C}};

static void check_checks(void) {
    static const float corner[9][3] = {{0, 0, 0},    {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0},
                                       {2, 1, 0.5f}, {4, 0, 1}, {5, 0, 1}, {4, 1, 1}};
    const pack_options options = {.splits = PLT_SPLIT_MEDIAN,
                                  .build = PLT_BUILD_HOST,
                                  .leaf_triangles = 1,
                                  .treelet_nodes = 2,
                                  .checks = 1};
    mesh m = {0};
    packed image;
    fail f = {""};
    for (uint32_t i = 0; i < 9; i++) {
        mesh_add_vertex(&m, corner[i][0], corner[i][1], corner[i][2], &f);
    }
    for (uint32_t i = 0; i < 9; i += 3) {
        mesh_add_triangle(&m, i, i + 1, i + 2, &f);
    }
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0 && image.size == 0x2c0, "%s", f.text);
    for (uint32_t i = 0; i < sizeof checked_words / sizeof *checked_words; i++) {
        const uint32_t word = plt_get_u32(image.bytes + checked_words[i].at);
        CHECK(word == checked_words[i].word, "%03x: %08x, not %08x", checked_words[i].at, word,
              checked_words[i].word);
    }
    pack_free(&image);
    mesh_free(&m);
}

static void check_too_many(void) {
    const mesh m = {.triangles = (size_t)PLT_INDEX_MAX + 1};
    const pack_options options = {.leaf_triangles = 1, .treelet_nodes = 1};
    const compact_options compact = {.lattice_bits = 14, .leaf_triangles = 1};
    lattice_loss loss;
    for (int format = 0; format < 2; format++) {
        packed image;
        fail f = {""};
        const int status = format == 0 ? pack_mesh(&image, &m, &options, "large.ply", &f)
                                       : pack_compact(&image, &m, &compact, "large.ply", &loss, &f);
        CHECK(status != 0, "packed");
        CHECK(strncmp(f.text, "large.ply: 134217728 triangles: ", 32) == 0, "%s", f.text);
        CHECK(strchr(f.text, ';') != NULL, "no remedy: %s", f.text);
        CHECK(image.bytes == NULL, "there is an image");
        pack_free(&image);
    }
}

/* A vertex far away that no triangle uses: it is not on the lattice. */
static void check_unused(void) {
    static const float corner[5][3] = {
        {-1.0e6f, -1.0e6f, 1.0e6f}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const compact_options options = {.lattice_bits = 16, .leaf_triangles = 2};
    mesh m = {0};
    packed image;
    lattice_loss loss;
    fail f = {""};
    for (int i = 0; i < 5; i++) {
        mesh_add_vertex(&m, corner[i][0], corner[i][1], corner[i][2], &f);
    }
    mesh_add_triangle(&m, 1, 2, 3, &f);
    mesh_add_triangle(&m, 1, 2, 4, &f);
    CHECK(pack_compact(&image, &m, &options, "test", &loss, &f) == 0, "%s", f.text);
    CHECK(loss.largest_move < 1.0e-4, "moved by %g", loss.largest_move);
    CHECK(loss.merged == 0 && image.info.triangles == 2, "%u triangles", image.info.triangles);
    pack_free(&image);
    mesh_free(&m);
}

int main(void) {
    test("an image holds every triangle once, bit for bit, and the options");
    const uint32_t counts[] = {0, 1, 2, 3, 5, 17, 100};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        check_options(rig_triangles(counts[i], 1));
    }
    test("a mesh of 2^27 triangles is refused before anything is read or allocated");
    check_too_many();
    test("a vertex that no triangle uses does not count in what the lattice cost");
    check_unused();
    test("checks are the bytes of SPEC.md, section 7");
    check_checks();
    return test_done();
}
