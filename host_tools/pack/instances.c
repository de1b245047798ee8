/* instances - see instances.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/instances.h"

#include <string.h>

#include "engine/base/bytes.h"
#include "engine/image/header.h"
#include "engine/image/header_at.h"
#include "engine/image/items.h"
#include "engine/instances/matrices.h"
#include "engine/planelet_crc32.h"
#include "engine/scene/counts.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/image_size.h"

int instances_place(const packed *body, const float matrix[PLT_MATRIX_FLOATS], plt_box *box) {
    plt_placed placed;
    plt_box own;
    float spread = 0.0f;
    memcpy(own.lo, body->info.lo, sizeof own.lo);
    memcpy(own.hi, body->info.hi, sizeof own.hi);
    const int good = plt_placed_set(&placed, matrix, &own, &spread);
    *box = placed.box;
    return good;
}

/* -1: the triangles of all bodies, or of all instances, are more than ids there are. */
static int count(const instance_set *all, plt_info *info, const char *name, fail *f) {
    uint64_t triangles = 0, slots = 0, placed = 0;
    *info = (plt_info){.splits = all->body[0].info.splits,
                       .build = PLT_BUILD_HOST,
                       .treelet_nodes = all->body[0].info.treelet_nodes,
                       .bodies = all->bodies,
                       .instances = all->instances,
                       .frames = all->frames,
                       .frame_rate = all->frame_rate,
                       .key_every = 1};
    for (uint32_t i = 0; i < all->bodies; i++) {
        triangles += all->body[i].info.triangles;
        slots += all->body[i].info.node_slots;
        plt_counts_add(info, &all->body[i].info);
    }
    for (uint32_t i = 0; i < all->instances; i++) {
        placed += all->body[all->body_of[i]].info.triangles;
    }
    if (triangles > PLT_INDEX_MAX || slots > PLT_INDEX_MAX || placed > PLT_PLACED_MOST) {
        return fail_set(f, name,
                        "bodies of %llu triangles and instances of %llu are more than 2^27 - 1 and "
                        "2^32 - 2; reduce their meshes",
                        (unsigned long long)triangles, (unsigned long long)placed);
    }
    info->triangles = (uint32_t)triangles;
    info->node_slots = (uint32_t)slots;
    info->placed_triangles = (uint32_t)placed;
    return 0;
}

/* Where sections begin in an image of a body alone. */
static const unsigned char *nodes_of(const packed *body) {
    return body->bytes + PLT_HEADER_BYTES;
}

static const unsigned char *records_of(const packed *body) {
    return nodes_of(body) + plt_section_bytes(body->info.node_slots, PLT_NODE_BYTES);
}

static void fill(const packed *image, const plt_header *h, const instance_set *all) {
    unsigned char *nodes = image->bytes + h->section[0].offset;
    unsigned char *records = image->bytes + h->section[1].offset;
    unsigned char *to = image->bytes + h->section[2].offset;
    uint32_t slot = 0, record = 0;
    for (uint32_t i = 0; i < all->bodies; i++, to += PLT_BODY_BYTES) {
        const packed *body = &all->body[i];
        const uint32_t slots = body->info.node_slots, count = body->info.triangles;
        memcpy(nodes + (size_t)slot * PLT_NODE_BYTES, nodes_of(body),
               (size_t)slots * PLT_NODE_BYTES);
        memcpy(records + (size_t)record * PLT_RECORD_BYTES, records_of(body),
               (size_t)count * PLT_RECORD_BYTES);
        plt_put_u32(to, plt_get_u32(body->bytes + PLT_AT_ROOT));
        plt_put_u32(to + 4, slot);
        plt_put_u32(to + 8, slots);
        plt_put_u32(to + 12, record);
        plt_put_u32(to + 16, count);
        plt_put_floats(to + PLT_BODY_BOX, body->info.lo, 3);
        plt_put_floats(to + PLT_BODY_BOX + 12, body->info.hi, 3);
        slot += slots;
        record += count;
    }
    for (uint32_t i = 0; i < all->instances; i++) {
        plt_put_u32(to + 4 * (size_t)i, all->body_of[i]);
    }
}

static const char *size_remedy(void) {
    return "use fewer frames, or reduce the meshes";
}

int instances_begin(packed *image, const instance_set *all, const char *name, fail *f) {
    plt_header h = {.root = PLT_LINK_NONE};
    plt_info *info = &h.info;
    uint32_t kind[PLT_SECTIONS_MOST];
    uint64_t size = PLT_HEADER_BYTES;
    if (count(all, info, name, f) != 0) {
        return -1;
    }
    const uint64_t frame_bytes = (uint64_t)all->frames * plt_matrices_frame_bytes(info);
    info->frame_bytes = (uint32_t)frame_bytes;
    for (unsigned i = plt_header_kinds(info, kind); i-- > 0;) {
        size += plt_header_section_bytes(info, kind[i]);
    }
    size = frame_bytes > UINT32_MAX ? frame_bytes : size;
    if (image_size_check(name, info->triangles, size, 0, size_remedy(), f) != 0) {
        return -1;
    }
    image->bytes = heap_get_aligned(size);
    if (image->bytes == NULL) {
        return fail_set(f, name, "out of memory for its frames; pack on a larger machine");
    }
    memset(image->bytes, 0, (size_t)size);
    image->size = (uint32_t)size;
    plt_header_write(image->bytes, &h);
    image->info = h.info;
    fill(image, &h, all);
    return 0;
}

/* Where matrices begin: the last section. */
static uint32_t matrices_at(const packed *image) {
    return image->size - (uint32_t)plt_header_section_bytes(&image->info, PLT_SECTION_MATRICES);
}

void instances_frame(packed *image, const instance_set *all, uint32_t frame,
                     const float (*matrix)[PLT_MATRIX_FLOATS]) {
    const uint32_t bytes = plt_matrices_frame_bytes(&image->info);
    unsigned char *to = image->bytes + matrices_at(image) + (size_t)frame * bytes;
    plt_box box = plt_box_empty();
    for (uint32_t i = 0; i < all->instances; i++) {
        plt_box own;
        plt_put_floats(to + PLT_MATRICES_HEAD + (size_t)i * PLT_MATRIX_BYTES, matrix[i],
                       PLT_MATRIX_FLOATS);
        instances_place(&all->body[all->body_of[i]], matrix[i], &own);
        plt_box_add(&box, &own);
    }
    plt_put_u32(to, plt_matrices_check(to, bytes, frame));
    if (frame == 0) {
        memcpy(image->info.lo, box.lo, sizeof box.lo);
        memcpy(image->info.hi, box.hi, sizeof box.hi);
    }
}

void instances_finish(packed *image) {
    plt_header h = {.info = image->info, .root = PLT_LINK_NONE};
    plt_header_write(image->bytes, &h);
    for (unsigned i = 0; i < PLT_SECTIONS_MOST; i++) {
        h.section[i].crc = plt_crc32(0, image->bytes + h.section[i].offset, h.section[i].bytes);
    }
    plt_header_write(image->bytes, &h);
    image->info = h.info;
}
