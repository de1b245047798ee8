/* compact_rig - see compact_rig.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/compact_rig.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "host_tools/pack/lattice_snap.h"

enum { SECTION_AT = 104, NUMBER_BITS_AT = 216 };

static uint32_t word_at(const unsigned char *b) {
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

compact_config compact_config_of(uint32_t leaf_triangles, uint8_t bits, uint8_t build,
                                 uint8_t splits) {
    const compact_config config = {
        .pack = {.splits = splits,
                 .build = build,
                 .lattice_bits = bits,
                 .numbers = 1,
                 .checks = 1,
                 .leaf_triangles = leaf_triangles},
        .run = {PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8, PLT_ORDER_DEPTH_FIRST}};
    return config;
}

packed compact_packed(mesh *m, const compact_config *config) {
    packed image = {.size = 0};
    fail f = {""};
    lattice_loss loss;
    if (pack_compact(&image, m, &config->pack, "test", &loss, &f) != 0) {
        image.bytes = NULL;
    }
    mesh_free(m);
    return image;
}

int compact_open(rig *r, const mesh *m, const compact_config *config) {
    fail f = {""};
    lattice_loss loss;
    memset(r, 0, sizeof *r);
    r->fault.message = "the packer refused";
    if (pack_compact(&r->image, m, &config->pack, "test", &loss, &f) != 0) {
        return PLT_ERR_LIMIT;
    }
    r->arena_bytes = plt_arena_need(&r->image.info, 1, &config->run);
    r->arena = aligned_alloc(PLT_ALIGN, (r->arena_bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN);
    if (r->arena == NULL) {
        return PLT_ERR_ARENA;
    }
    memset(r->arena, 0xA5, r->arena_bytes);
    const plt_source source = rig_source(&r->image);
    return plt_open(&r->engine, r->arena, r->arena_bytes, &source, &config->run, &r->fault);
}

const char *compact_name(const compact_config *config) {
    static char name[96];
    snprintf(name, sizeof name, "K %u %u bits %s %s%s side %u", config->pack.leaf_triangles,
             config->pack.lattice_bits,
             config->pack.floats ? "floats"
                                 : (config->pack.build == PLT_BUILD_HOST ? "host" : "device"),
             config->pack.splits == PLT_SPLIT_SAH ? "sah" : "median",
             config->pack.numbers ? "" : " no ids", config->run.packet_side);
    return name;
}

const unsigned char *compact_section(const packed *image, unsigned index) {
    return image->bytes + word_at(image->bytes + SECTION_AT + 16 * index + 4);
}

void compact_primitive_id(const packed *image, uint32_t index, uint32_t *id, uint32_t *rotation) {
    const unsigned char *bytes = compact_section(image, 1);
    const uint32_t bits = word_at(image->bytes + NUMBER_BITS_AT) & 0xFFu; /* above: checks */
    uint32_t entry = 0;
    for (uint32_t i = 0; i < bits; i++) {
        const uint64_t at = (uint64_t)index * bits + i;
        entry |= (uint32_t)(bytes[at / 8] >> at % 8 & 1) << i;
    }
    *rotation = entry & 3;
    *id = entry >> 2;
}

static void must(int status, const fail *f) {
    if (status != 0) {
        printf("FAIL a test's mesh: %s\n", f->text);
        exit(1);
    }
}

static void add(mesh *m, const float corner[3][3]) {
    fail f = {""};
    const uint32_t first = (uint32_t)m->vertices;
    for (int c = 0; c < 3; c++) {
        must(mesh_add_vertex(m, corner[c][0], corner[c][1], corner[c][2], &f), &f);
    }
    must(mesh_add_triangle(m, first, first + 1, first + 2, &f), &f);
}

/* Triangle `i` of the remaining ones, in the order of the mesh. */
static void corners_of(const snapped *s, uint32_t i, float corner[3][3]) {
    const unsigned char *at = s->corners + (size_t)i * 9 * s->width;
    for (int k = 0; k < 9; k++, at += s->width) {
        const uint32_t q = s->width == 2 ? at[0] | (uint32_t)at[1] << 8 : word_at(at);
        corner[k / 3][k % 3] = s->lattice.origin[k % 3] + s->lattice.step * (float)q;
    }
}

mesh compact_mesh(const mesh *m, uint8_t bits) {
    mesh to = {0};
    fail f = {""};
    snapped s;
    uint32_t left = 0;
    must(lattice_snap(&s, m, bits, "test", &f), &f);
    for (uint32_t i = 0; i < m->triangles && s.count > 0; i++) {
        float corner[3][3];
        const int there = left < s.count && s.source[left] == i;
        corners_of(&s, there ? left : 0, corner);
        if (!there) {
            memcpy(corner[1], corner[0], sizeof corner[0]);
            memcpy(corner[2], corner[0], sizeof corner[0]);
        }
        left += (uint32_t)there;
        add(&to, (const float(*)[3])corner);
    }
    snapped_free(&s);
    return to;
}

mesh compact_mesh_in_order(const packed *image, const mesh *moved) {
    mesh to = {0};
    for (uint32_t index = 0; index < image->info.triangles; index++) {
        uint32_t id, rotation;
        float corner[3][3];
        compact_primitive_id(image, index, &id, &rotation);
        for (uint32_t c = 0; c < 3;
             c++) { /* the rotation counts from the least corner to the first */
            const uint32_t from = moved->triangle[3 * id + (3 - rotation + c) % 3];
            memcpy(corner[c], moved->vertex + 3 * (size_t)from, sizeof corner[c]);
        }
        add(&to, (const float(*)[3])corner);
    }
    return to;
}

const plt_block_tree *compact_tree(const rig *r) {
    return &r->engine->scene.compact;
}

uint32_t compact_triangles(uint32_t wanted, uint32_t leaf_triangles) {
    const uint32_t levels = PLT_DEPTH_MAX - 1 < 20 ? PLT_DEPTH_MAX - 1 : 20;
    const uint32_t most = leaf_triangles << levels;
    return wanted < most ? wanted : most;
}
