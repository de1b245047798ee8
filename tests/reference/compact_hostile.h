/* compact_hostile - opens and traces untrusted compact images and blocks
 *
 * As hostile/images.h, whose source, rays and refusals are used here, but with the guarantees
 * of compact scenes, and with resealing that can leave block checks as they are. Needs only the
 * engine: the fuzz target links nothing else.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_COMPACT_HOSTILE_H
#define REFERENCE_COMPACT_HOSTILE_H

#include "engine/tree/compact/validate.h"
#include "tests/hostile/images.h"
#include "tests/reference/visits.h"

enum { COMPACT_BITS = 184, COMPACT_BEHIND = PLT_BITS_BEHIND };

/* ---- sealing ----------------------------------------------------------------- */

/* Makes the checks of parts (if wanted), the CRCs of sections and the header right: only the
 * forged bytes remain wrong. */
static inline void compact_seal(unsigned char *bytes, uint32_t size, int blocks) {
    if (blocks) {
        hostile_seal(bytes, size);
        return;
    }
    for (uint32_t i = 0; i < 3 && size >= HOSTILE_HEADER; i++) {
        unsigned char *entry = bytes + HOSTILE_SECTION + 16 * i;
        const uint32_t offset = plt_get_u32(entry + 4), count = plt_get_u32(entry + 8);
        if (offset <= size && count <= size - offset) {
            plt_put_u32(entry + 12, plt_crc32(0, bytes + offset, count));
        }
    }
    hostile_seal_header(bytes, size);
}

/* ---- trying -------------------------------------------------------------------- */

/* Rays that are invalid, start inside, are in planes, or hit nothing. */
static inline void compact_odd_rays(plt_ray rays[HOSTILE_RAYS], const plt_info *info) {
    static const uint32_t odd[8] = {0x7FC00000, 0x7F800000, 0xFF800000, 0x80000000,
                                    0x00000001, 0x7F7FFFFF, 0xDD800000, 0x21800000};
    hostile_rays(rays, info);
    for (uint32_t i = 0; i < HOSTILE_RAYS; i++) {
        float words[8];
        memcpy(words, &rays[i], sizeof words);
        for (uint32_t k = 0; k < i % 4; k++) {
            words[(i * 5 + k * 3) % 8] = plt_get_float(&odd[(i + k) % 8]);
        }
        memcpy(&rays[i], words, sizeof words);
    }
}

static inline uint32_t compact_ids_end(const plt_info *info) {
    const int lone = info->source_triangles == 1; /* is stored twice */
    return info->primitive_id_bits > 0 ? info->source_triangles : info->triangles + (uint32_t)lone;
}

/* A hit's primitive id is below `ids_end`. */
static inline const char *compact_trace(plt_engine *e, uint32_t ids_end) {
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    const plt_info *info = plt_engine_info(e);
    plt_stats s;
    for (int odd = 0; odd < 2; odd++) {
        odd ? compact_odd_rays(rays, info) : hostile_rays(rays, info);
        plt_trace(e, rays, hits, HOSTILE_RAYS, 0);
        for (uint32_t i = 0; i < HOSTILE_RAYS; i++) {
            if (hits[i].triangle != PLT_MISS &&
                !(hits[i].triangle < ids_end && hits[i].t >= 0.0f && hits[i].u >= 0.0f &&
                  hits[i].u <= 1.0f && hits[i].v >= 0.0f && hits[i].v <= 1.0f)) {
                return "a hit is out of range";
            }
        }
        plt_trace(e, rays, hits, HOSTILE_RAYS, 1);
    }
    plt_stats_get(e, &s);
    return s.node_visits <= visits_most(&s, info->nodes) ? NULL : "a node was visited twice";
}

static inline const char *compact_trace_any(plt_engine *e) {
    return compact_trace(e, compact_ids_end(plt_engine_info(e)));
}

static inline hostile_result compact_try(const unsigned char *bytes, uint32_t size,
                                         uint8_t streamed, uint8_t packet_side) {
    const hostile_config config = {streamed, PLT_ORDER_DEPTH_FIRST, packet_side, 0};
    return hostile_try_by(bytes, size, config, compact_trace_any);
}

#endif
