/* instances - opens untrusted images with instances, shows all frames, and traces each
 *
 * As hostile/images.h has it of others.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_INSTANCES_H
#define HOSTILE_INSTANCES_H

#include "engine/instances/matrices.h"
#include "tests/hostile/frames.h"

enum { HOSTILE_INSTANCES_MOST = 4096 };

/* Makes the checks of all frames right, and of all sections and the header. */
static inline void hostile_seal_instances(unsigned char *bytes, uint32_t size) {
    if (size < HOSTILE_HEADER) {
        return;
    }
    const uint32_t frames = plt_get_u32(bytes + HOSTILE_AT_FRAMES),
                   instances = plt_get_u32(bytes + 208);
    for (uint32_t i = 0; i < 4; i++) {
        unsigned char *entry = bytes + HOSTILE_SECTION + 16 * i;
        const hostile_section s = hostile_section_at(bytes, size, i, plt_get_u32(entry));
        const uint32_t frame = PLT_MATRICES_HEAD + instances * PLT_MATRIX_BYTES;
        for (uint32_t k = 0; i == 3 && s.bytes != NULL && instances <= HOSTILE_INSTANCES_MOST &&
                             k < frames && k < HOSTILE_FRAMES_MOST && (k + 1) * frame <= s.count;
             k++) {
            unsigned char *at = s.bytes + k * frame;
            plt_put_u32(at, plt_matrices_check(at, frame, k));
        }
        if (s.bytes != NULL) {
            plt_put_u32(entry + 12, plt_crc32(0, s.bytes, s.count));
        }
    }
    hostile_seal_header(bytes, size);
}

/* Hits name triangles that are there. */
static inline const char *hostile_trace_instances(plt_engine *e) {
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    const plt_info *info = plt_engine_info(e);
    hostile_rays(rays, info);
    for (int any = 0; any < 2; any++) {
        if (plt_trace(e, rays, hits, HOSTILE_RAYS, any) != PLT_OK) {
            return "a trace failed";
        }
        for (uint32_t i = 0; i < HOSTILE_RAYS && !any; i++) {
            plt_instance to;
            if (hits[i].triangle != PLT_MISS &&
                !(plt_instance_find(e, hits[i].triangle, &to) == PLT_OK && hits[i].t >= 0.0f)) {
                return "a hit is out of range";
            }
        }
    }
    return NULL;
}

static inline const char *hostile_show_instances(plt_engine *e) {
    return hostile_show_frames(e, 28, hostile_trace_instances);
}

static inline hostile_result hostile_try_instances(const unsigned char *bytes, uint32_t size,
                                                   hostile_config config) {
    return hostile_try_with(bytes, size, config, 0, hostile_show_instances);
}

#endif
