/* sequences - opens untrusted images with frames, shows all, and traces each
 *
 * The image is copied to a heap block of exactly its size and the arena has exactly its need, so
 * sanitizers see the first byte beyond.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_SEQUENCES_H
#define HOSTILE_SEQUENCES_H

#include "engine/motion/frame_block.h"
#include "tests/hostile/frames.h"

/* ---- sealing ---------------------------------------------------------------- */

/* Makes the checks of all blocks of a frame right, as long as each fits. */
static inline void hostile_seal_frame(unsigned char *at, uint32_t bytes, uint32_t vertices,
                                      uint32_t bits, uint32_t frame) {
    for (uint32_t block = 0; vertices > 0; block++) {
        const uint32_t count = vertices < PLT_FRAME_BLOCK ? vertices : PLT_FRAME_BLOCK;
        if (bytes < plt_frame_bytes_for(0, bits, 0)) {
            return;
        }
        const uint32_t size = plt_frame_block_bytes(at, count, bits);
        if (size == 0 || size > bytes) {
            return;
        }
        plt_put_u32(at, plt_frame_block_check(at, size, frame, block));
        at += size;
        bytes -= size;
        vertices -= count;
    }
}

static inline void hostile_seal_frames(unsigned char *section, uint32_t count, uint32_t frames,
                                       uint32_t vertices, uint32_t bits) {
    for (uint32_t i = 0; i < frames && i < HOSTILE_FRAMES_MOST && count / 4 > i + 1; i++) {
        const uint32_t begin = plt_get_u32(section + 4 * i), end = plt_get_u32(section + 4 * i + 4);
        if (begin >= 4 * (frames + 1) && begin <= end && end <= count &&
            count - end >= PLT_BITS_BEHIND && vertices <= 4 * count) {
            hostile_seal_frame(section + begin, end - begin, vertices, bits, i);
        }
    }
}

/* Blocks, sections and header. */
static inline void hostile_seal_sequence(unsigned char *bytes, uint32_t size) {
    const uint32_t frames = size >= HOSTILE_HEADER ? plt_get_u32(bytes + HOSTILE_AT_FRAMES) : 0;
    const uint32_t bits = size >= HOSTILE_HEADER ? plt_get_u32(bytes + 184) : 0;
    if (size >= HOSTILE_HEADER) {
        hostile_seal_blocks(bytes, size);
    }
    for (unsigned i = 0; i < 4 && size >= HOSTILE_HEADER; i++) {
        unsigned char *entry = bytes + HOSTILE_SECTION + 16 * i;
        const hostile_section s = hostile_section_at(bytes, size, i, plt_get_u32(entry));
        if (s.bytes != NULL && i == 3 && bits <= 21) {
            hostile_seal_frames(s.bytes, s.count, frames, plt_get_u32(bytes + 188),
                                bits > 0 ? bits : PLT_FRAME_FLOAT_BITS);
        }
        const uint64_t offsets = 4 * ((uint64_t)frames + 1);
        const uint32_t summed = i == 3 && offsets < s.count ? (uint32_t)offsets : s.count;
        if (s.bytes != NULL) {
            plt_put_u32(entry + 12, plt_crc32(0, s.bytes, summed));
        }
    }
    hostile_seal_header(bytes, size);
}

/* ---- trying ------------------------------------------------------------------ */

static inline const char *hostile_show(plt_engine *e) {
    return hostile_show_frames(e, 25, hostile_trace);
}

static inline hostile_result hostile_try_sequence(const unsigned char *bytes, uint32_t size,
                                                  hostile_config config, unsigned motion) {
    return hostile_try_with(bytes, size, config, motion, hostile_show);
}

#endif
