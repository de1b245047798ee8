/* stream_compact - images of compact blocks for stream_rig.h, right ones, deep ones and forged ones
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_STREAM_COMPACT_H
#define REFERENCE_STREAM_COMPACT_H

#include "tests/reference/compact_hostile.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/reference/stream_rig.h"

/* Primitive ids: none, with checks, or without, as images had them before there were any. */
enum { NO_IDS = 0, IDS = 1, IDS_UNCHECKED = 2 };

static inline void fill_subject(subject *s, uint32_t triangles, uint32_t k, uint8_t bits, int ids) {
    mesh m = {0};
    random_state r = {triangles + k};
    shape_soup(&m, compact_triangles(triangles, k), 0.1f, 3 + k);
    rays_mixed(s->rays, RAYS, &m, &r);
    compact_config c = compact_config_of(k, bits, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.pack.numbers = ids != NO_IDS;
    c.pack.checks = ids != IDS_UNCHECKED;
    s->image = compact_packed(&m, &c);
    set_due(s);
}

static inline void forge(packed *image, uint32_t blocks, random_state *r) {
    unsigned char *section = image->bytes + PLT_HEADER_BYTES;
    for (uint32_t times = 1 + random_below(r, 3); times > 0; times--) {
        const uint32_t at = random_below(r, blocks);
        switch (random_below(r, 4)) {
        case 0:
            section[at] ^= (unsigned char)(1u << random_below(r, 8));
            break;
        case 1:
            section[at] = (unsigned char)random_bits(r);
            break;
        case 2: /* a word that may be a link, from elsewhere */
            memcpy(section + (at & ~3u), section + (random_below(r, blocks) & ~3u), 4);
            break;
        default:
            section[at] = random_below(r, 2) ? 0 : 0xFF;
        }
    }
}

/* Versions of the image, the first as it is, the others forged with right checks. */
static inline void forge_versions(changing *c, const subject *s) {
    const uint32_t blocks = s->image.info.node_bytes + s->image.info.triangle_bytes;
    for (unsigned i = 0; i < VERSIONS; i++) {
        packed copy = s->image;
        copy.bytes = c->version[i] = room_get(s->image.size);
        memcpy(copy.bytes, s->image.bytes, s->image.size);
        for (unsigned times = 0; i > 0 && times < 6; times++) {
            forge(&copy, blocks, &c->random);
        }
        compact_seal(copy.bytes, copy.size, 1);
    }
}

/* The byte of counts of each geometry part, which says where ids lie, has a wrong bit. */
static inline void garble_counts(const subject *s, unsigned char *bytes) {
    const uint32_t used = s->image.info.node_bytes + s->image.info.triangle_bytes;
    plt_block b;
    for (uint32_t at = PLT_HEADER_BYTES; at < PLT_HEADER_BYTES + used; at += plt_block_bytes(&b)) {
        plt_block_open(&b, s->image.bytes + at, s->image.info.lattice_bits);
        if (b.geometry_bytes > 0) {
            bytes[at + b.node_bytes] ^= 8;
        }
    }
}

static inline void add_triangle(mesh *m, const float corner[3][3]) {
    fail f = {""};
    const uint32_t first = 3 * (uint32_t)m->triangles;
    for (int i = 0; i < 3; i++) {
        mesh_add_vertex(m, corner[i][0], corner[i][1], corner[i][2], &f);
    }
    CHECK(mesh_add_triangle(m, first, first + 1, first + 2, &f) == 0, "%s", f.text);
}

/* Clusters at ever smaller distances: a tree that is a chain, so that blocks are as deep as they
 * can be. It is a valid scene. */
static inline packed deep_image(uint32_t seed, plt_ray rays[RAYS]) {
    mesh m = {0};
    random_state r = {seed};
    float at = 1.0f;
    for (unsigned level = 0; level < 18; level++, at *= 0.5f) {
        for (unsigned i = 0; i < 3; i++) {
            const float x = at * random_float(&r, 0.9f, 1.0f), y = at * random_float(&r, 0, 1);
            const float z = at * random_float(&r, 0, 1), e = at * 0.05f;
            const float corner[3][3] = {{x, y, z}, {x + e, y, z}, {x, y + e, z + e}};
            add_triangle(&m, corner);
        }
    }
    rays_mixed(rays, RAYS, &m, &r);
    compact_config c = compact_config_of(1, 21, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    return compact_packed(&m, &c);
}

#endif
