/* images - opens untrusted images, and traces those that open
 *
 * The image is copied to a heap block of exactly its size and the arena has exactly its need,
 * so sanitizers see the first byte beyond. Needs only the engine: the fuzz target links nothing
 * else.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_IMAGES_H
#define HOSTILE_IMAGES_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/bytes.h"
#include "engine/planelet.h"
#include "engine/planelet_crc32.h"
#include "engine/tree/compact/leaf.h"
#include "engine/tree/thesis/checks.h"
#include "tests/reference/room.h"
#include "tests/reference/visits.h"

#define HOSTILE_RAYS 70u
#define HOSTILE_ARENA_MOST (8u << 20)

/* The result of opening and tracing an image. */
typedef struct hostile_result {
    int status;           /* of plt_open */
    plt_fault fault;      /* of plt_open */
    const char *sentence; /* NULL: all guarantees hold */
} hostile_result;

typedef struct hostile_config {
    uint8_t streamed; /* the source is not mapped */
    uint8_t order, packet_side;
    uint8_t residency; /* enum plt_residency */
} hostile_config;

/* ---- sealing -------------------------------------------------------------- */

enum {
    HOSTILE_HEADER = 256,
    HOSTILE_CRC = 20,
    HOSTILE_SECTION = 104, /* of the table, entries of 16 bytes */
    HOSTILE_BLOCKS = 3,    /* kinds */
    HOSTILE_IDS = 4,
    HOSTILE_CHECKS = 6
};

static inline void hostile_seal_header(unsigned char *bytes, uint32_t size) {
    if (size >= HOSTILE_HEADER) {
        plt_put_u32(bytes + HOSTILE_CRC, 0);
        plt_put_u32(bytes + HOSTILE_CRC, plt_crc32(0, bytes, HOSTILE_HEADER));
    }
}

/* A copy to damage; free() it. */
static inline unsigned char *hostile_copy(const unsigned char *image, uint32_t size) {
    unsigned char *bytes = room_get(size);
    memcpy(bytes, image, size);
    return bytes;
}

/* Where section `i` begins, as the table has it. */
static inline uint32_t hostile_begin(const unsigned char *image, uint32_t i) {
    return plt_get_u32(image + HOSTILE_SECTION + 16 * i + 4);
}

/* A section as entry `i` of the table has it. `bytes` is NULL if that is not of this kind, or does
 * not lie in the image. */
typedef struct hostile_section {
    unsigned char *bytes;
    uint32_t count;
} hostile_section;

static inline hostile_section hostile_section_at(unsigned char *image, uint32_t size, uint32_t i,
                                                 uint32_t kind) {
    const unsigned char *entry = image + HOSTILE_SECTION + 16 * i;
    const uint32_t offset = plt_get_u32(entry + 4), count = plt_get_u32(entry + 8);
    const int lies = plt_get_u32(entry) == kind && offset <= size && count <= size - offset;
    const hostile_section s = {lies ? image + offset : NULL, count};
    return s;
}

/* What an image says of the checks of its primitive ids. */
typedef struct hostile_ids {
    hostile_section section; /* no bytes: they have none */
    uint32_t bits, k;
} hostile_ids;

static inline hostile_ids hostile_ids_of(unsigned char *image, uint32_t size) {
    hostile_ids ids = {hostile_section_at(image, size, 1, HOSTILE_IDS), plt_get_u32(image + 216),
                       plt_get_u32(image + 52)};
    const int have_checks = ids.bits >= 258 && ids.bits <= 285 && ids.k <= 4;
    ids.bits -= 256;
    ids.section.bytes = have_checks ? ids.section.bytes : NULL;
    return ids;
}

/* The check of its ids, at the end of its geometry part. */
static inline void hostile_seal_ids(unsigned char *part, const plt_block *b,
                                    const hostile_ids *ids) {
    plt_geometry g;
    plt_geometry_open_counts(&g, b, ids->k);
    const uint64_t from = (uint64_t)g.first_triangle * ids->bits / 8;
    const uint64_t to = (((uint64_t)g.first_triangle + g.triangles) * ids->bits + 7) / 8;
    if (b->leaves > 0 && to <= ids->section.count) {
        const uint16_t check =
            plt_block_ids_check(ids->section.bytes + from, (uint32_t)(to - from));
        part[b->geometry_bytes - 2] = (unsigned char)check;
        part[b->geometry_bytes - 1] = (unsigned char)(check >> 8);
    }
}

/* Makes all checks of the block at `bytes` right, if not NULL that of its ids, too; returns its
 * size, 0 when it does not fit `limit`. */
static inline uint32_t hostile_seal_block(unsigned char *bytes, uint32_t limit, uint32_t bits,
                                          const hostile_ids *ids) {
    plt_block b;
    if (limit < 8 || limit < plt_block_parts_bytes((plt_get_u32(bytes) & 63) + 1, 0, bits)) {
        return 0;
    }
    plt_block_open(&b, bytes, bits);
    if (b.node_bytes > limit || b.geometry_bytes > limit - b.node_bytes) {
        return 0;
    }
    const uint32_t nodes = plt_block_check(bytes, b.node_bytes, 2);
    plt_put_u32(bytes, (plt_get_u32(bytes) & 0xFFFFu) | nodes << 16);
    if (b.geometry_bytes > 0) {
        unsigned char *part = bytes + b.node_bytes;
        if (ids != NULL && ids->section.bytes != NULL) {
            hostile_seal_ids(part, &b, ids);
        }
        const uint32_t geometry = plt_block_check(part, b.geometry_bytes, 6);
        plt_put_u32(part + 4, (plt_get_u32(part + 4) & 0xFFFFu) | geometry << 16);
    }
    return plt_block_bytes(&b);
}

/* Makes the checks of all blocks right, as long as each begins where the one before ends. */
static inline void hostile_seal_blocks(unsigned char *bytes, uint32_t size) {
    const hostile_section blocks = hostile_section_at(bytes, size, 0, HOSTILE_BLOCKS);
    const hostile_ids ids = hostile_ids_of(bytes, size);
    const uint32_t bits = plt_get_u32(bytes + 184);
    if (blocks.bytes == NULL || blocks.count < 8) {
        return;
    }
    for (uint32_t at = 0, block = 1; block > 0 && at < blocks.count - 8; at += block) {
        block = hostile_seal_block(blocks.bytes + at, blocks.count - 8 - at, bits, &ids);
    }
}

/* And those of thesis nodes and records, if there is a section of them. */
static inline void hostile_seal_thesis(unsigned char *bytes, uint32_t size) {
    const hostile_section nodes = hostile_section_at(bytes, size, 0, 1);
    const hostile_section records = hostile_section_at(bytes, size, 1, 2);
    const hostile_section checks = hostile_section_at(bytes, size, 2, HOSTILE_CHECKS);
    const uint32_t page_bytes = PLT_PAGE_RECORDS * PLT_RECORD_BYTES;
    if (nodes.bytes == NULL || records.bytes == NULL || checks.bytes == NULL) {
        return;
    }
    for (uint32_t i = 0; i < nodes.count / PLT_NODE_BYTES && i < checks.count; i++) {
        plt_node node;
        memcpy(&node, nodes.bytes + (size_t)i * PLT_NODE_BYTES, sizeof node);
        checks.bytes[i] = plt_node_check(&node);
    }
    for (uint32_t at = 0; at + page_bytes <= records.count; at += page_bytes) {
        plt_record page[PLT_PAGE_RECORDS];
        uint16_t held;
        memcpy(page, records.bytes + at, sizeof page);
        const uint32_t check = plt_page_check(page, &held);
        for (uint32_t i = 0; i < PLT_PAGE_RECORDS; i++) {
            const uint32_t word = plt_get_u32(&page[i].word[9]) & ~PLT_PRIMITIVE_UNUSED;
            plt_put_u32(&page[i].word[9], word | plt_page_check_bits(check, i));
        }
        memcpy(records.bytes + at, page, sizeof page);
    }
}

/* Makes the checks of parts, the CRCs of the sections that lie inside the image, and the
 * header's right. */
static inline void hostile_seal(unsigned char *bytes, uint32_t size) {
    if (size >= HOSTILE_HEADER) {
        hostile_seal_blocks(bytes, size);
        hostile_seal_thesis(bytes, size);
    }
    for (int i = 0; i < 3 && size >= HOSTILE_HEADER; i++) {
        unsigned char *entry = bytes + HOSTILE_SECTION + 16 * i;
        const uint32_t offset = plt_get_u32(entry + 4), count = plt_get_u32(entry + 8);
        if (offset <= size && count <= size - offset) {
            plt_put_u32(entry + 12, plt_crc32(0, bytes + offset, count));
        }
    }
    hostile_seal_header(bytes, size);
}

/* ---- a source that detects reads beyond its end --------------- */

typedef struct hostile_stream {
    const unsigned char *bytes;
    uint32_t size;
    int beyond; /* was read beyond its end */
} hostile_stream;

static inline int hostile_start(void *context, unsigned tag, uint32_t offset, void *to,
                                uint32_t count) {
    hostile_stream *s = context;
    if (tag > 31 || offset > s->size || count > s->size - offset) {
        s->beyond = 1;
        return -1;
    }
    memcpy(to, s->bytes + offset, count);
    return 0;
}

static inline int hostile_wait(void *context, uint32_t tags) {
    (void)context, (void)tags;
    return 0;
}

/* ---- trying ----------------------------------------------------------------- */

static inline void hostile_rays(plt_ray rays[HOSTILE_RAYS], const plt_info *info) {
    for (uint32_t i = 0; i < HOSTILE_RAYS; i++) {
        uint32_t bits = (i + 1) * 0x9E3779B1u;
        plt_ray r = {{0, 0, 0}, 0.0f, {0, 0, 0}, 3.0e38f};
        for (int a = 0; a < 3; a++) {
            bits = bits * 1664525u + 1013904223u;
            const float share = (float)(bits >> 8) * 5.9604645e-8f;
            r.org[a] = i % 3 == 0 ? info->lo[a] - 1.0f : info->lo[a];
            r.dir[a] = info->lo[a] + share * (info->hi[a] - info->lo[a]) - r.org[a];
        }
        r.dir[i % 3] += i % 5 == 0 ? 1.0f : 0.0f;
        rays[i] = r;
    }
}

static inline const char *hostile_trace(plt_engine *e) {
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    const plt_info *info = plt_engine_info(e);
    plt_stats s;
    hostile_rays(rays, info);
    plt_trace(e, rays, hits, HOSTILE_RAYS, 0);
    plt_stats_get(e, &s);
    for (uint32_t i = 0; i < HOSTILE_RAYS; i++) {
        if (hits[i].triangle != PLT_MISS &&
            !(hits[i].triangle < info->triangles && hits[i].t >= 0.0f)) {
            return "a hit is out of range";
        }
    }
    plt_trace(e, rays, hits, HOSTILE_RAYS, 1);
    return s.node_visits <= visits_most(&s, info->nodes) ? NULL : "a node was visited twice";
}

/* Of a scene that stays in its source: what is wrong shows when it comes. */
static inline const char *hostile_trace_streamed(plt_engine *e) {
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    plt_fault fault;
    const plt_info *info = plt_engine_info(e);
    const uint32_t ids_end = info->primitive_id_bits > 0 ? info->source_triangles : info->triangles;
    hostile_rays(rays, info);
    for (int any = 0; any < 2; any++) {
        const int status = plt_trace(e, rays, hits, HOSTILE_RAYS, any);
        plt_fault_get(e, &fault);
        if (status != PLT_OK) {
            return status == PLT_ERR_IMAGE && fault.kind == 'I' && fault.offset < info->image_bytes
                       ? NULL
                       : "refused without its place";
        }
        for (uint32_t i = 0; i < HOSTILE_RAYS && !any; i++) {
            if (hits[i].triangle != PLT_MISS && hits[i].triangle >= ids_end) {
                return "a hit is out of range";
            }
        }
    }
    return NULL;
}

static inline const char *hostile_refusal(int status, const plt_fault *f, const plt_engine *e) {
    if (e != NULL) {
        return "there is an engine after a failure";
    }
    if (f->message == NULL || f->message[0] == '\0') {
        return "a failure has no message";
    }
    if (status == PLT_ERR_IMAGE && !((f->kind == 'R' || f->kind == 'I') && f->rule > 0)) {
        return "a refusal names no rule";
    }
    return status < 0 && status >= PLT_ERR_ARGUMENT ? NULL : "an unknown status";
}

static inline size_t hostile_arena_bytes(const plt_source *source, const plt_options *options) {
    plt_info info;
    plt_fault fault;
    if (plt_image_info(source, &info, &fault) != PLT_OK) {
        return 4096;
    }
    const size_t need = plt_arena_need(&info, source->mapped != NULL, options);
    return need < HOSTILE_ARENA_MOST ? need : HOSTILE_ARENA_MOST;
}

/* How triangles move: as frames, with records and without, where an image may be without. */
enum hostile_motion { HOSTILE_STILL, HOSTILE_RECORDS, HOSTILE_VERTICES, HOSTILE_BESIDE };

static inline plt_options hostile_options(const plt_source *source, hostile_config config,
                                          unsigned motion) {
    plt_options o = {.packet_side = config.packet_side,
                     .order = config.order,
                     .residency = config.residency,
                     .count_touched = 1,
                     .movable = motion != HOSTILE_STILL};
    plt_options without = o;
    plt_info info;
    plt_fault fault;
    without.records = PLT_RECORDS_NEVER;
    without.beside = motion == HOSTILE_BESIDE;
    return motion >= HOSTILE_VERTICES && plt_image_info(source, &info, &fault) == PLT_OK &&
                   plt_arena_need(&info, 1, &without) > 0
               ? without
               : o;
}

/* Opens a copy of exactly its size in exactly the arena it needs and, if that works, calls
 * `trace`. The copy must not be changed by that. */
static inline hostile_result hostile_try_with(const unsigned char *bytes, uint32_t size,
                                              hostile_config config, unsigned motion,
                                              const char *(*trace)(plt_engine *e)) {
    hostile_result r = {0, {0, 0, 0, 0, NULL}, NULL};
    unsigned char *copy = room_get(size > 0 ? size : 1);
    hostile_stream stream = {copy, size, 0};
    plt_source source = {copy, size, NULL, NULL, NULL};
    if (config.streamed) {
        const plt_source streamed = {NULL, size, &stream, hostile_start, hostile_wait};
        source = streamed;
    }
    if (size > 0) {
        memcpy(copy, bytes, size);
    }
    const plt_options options = hostile_options(&source, config, motion);
    const size_t arena_bytes = hostile_arena_bytes(&source, &options);
    void *arena = room_get(arena_bytes);
    plt_engine *e = NULL;
    r.status = plt_open(&e, arena, arena_bytes, &source, &options, &r.fault);
    r.sentence = r.status == PLT_OK ? trace(e) : hostile_refusal(r.status, &r.fault, e);
    if (size > 0 && memcmp(copy, bytes, size) != 0) {
        r.sentence = "the image was written";
    }
    if (stream.beyond) {
        r.sentence = "the source was read beyond its end";
    }
    free(arena);
    free(copy);
    return r;
}

static inline hostile_result hostile_try_by(const unsigned char *bytes, uint32_t size,
                                            hostile_config config,
                                            const char *(*trace)(plt_engine *e)) {
    return hostile_try_with(bytes, size, config, HOSTILE_STILL, trace);
}

static inline hostile_result hostile_try(const unsigned char *bytes, uint32_t size,
                                         hostile_config config) {
    return hostile_try_by(bytes, size, config, hostile_trace);
}

#endif
