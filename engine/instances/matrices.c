/* matrices - see matrices.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/instances/matrices.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/planelet_crc32.h"

enum { BLOCK_BYTES = 64 * PLT_MATRIX_BYTES };

/* The check covers the frame's number: one that comes from another place is noticed. */
static uint32_t check_begin(uint32_t frame) {
    unsigned char number[4];
    plt_put_u32(number, frame);
    return plt_crc32(0, number, sizeof number);
}

uint32_t plt_matrices_check(const unsigned char *bytes, uint32_t count, uint32_t frame) {
    return plt_crc32(check_begin(frame), bytes + PLT_MATRICES_HEAD, count - PLT_MATRICES_HEAD);
}

void plt_matrices_init(plt_matrices *m, const plt_header *header, const plt_source *source,
                       void *room) {
    *m = (plt_matrices){.source = source,
                        .bytes = room,
                        .section = plt_header_section(header, PLT_SECTION_MATRICES)->offset,
                        .frame_bytes = plt_matrices_frame_bytes(&header->info),
                        .frames = header->info.frames,
                        .at = PLT_MATRICES_NONE};
}

static void begin(plt_matrices *m) {
    m->there = 0;
    m->crc = check_begin(m->wanted);
}

void plt_matrices_seek(plt_matrices *m, uint32_t frame) {
    if (m->is_reading && m->wanted == frame) {
        return;
    }
    m->wanted = frame;
    m->is_reading = m->at != frame;
    m->tries = m->source->mapped != NULL ? 1 : PLT_FETCH_TRIES;
    begin(m);
}

static uint32_t offset_of(const plt_matrices *m) {
    return m->section + m->wanted * m->frame_bytes;
}

/* The next `count` bytes at most. */
static int read_some(plt_matrices *m, uint32_t count, plt_fault *fault) {
    const uint32_t left = m->frame_bytes - m->there, now = count < left ? count : left;
    unsigned char *to = m->bytes + m->there;
    const int status = plt_fetch(m->source, offset_of(m) + m->there, to, now, fault);
    if (status == PLT_OK) {
        const uint32_t head = m->there == 0 ? PLT_MATRICES_HEAD : 0;
        m->crc = plt_crc32(m->crc, to + head, now - head);
        m->there += now;
    }
    return status;
}

static int read_block(plt_matrices *m, plt_fault *fault) {
    const int status = read_some(m, PLT_MATRICES_HEAD + BLOCK_BYTES, fault);
    if (status == PLT_OK && m->there == m->frame_bytes && plt_get_u32(m->bytes) != m->crc) {
        return plt_broken(fault, PLT_I28_MATRICES, offset_of(m),
                          "a frame of matrices is damaged (checksum)");
    }
    return status;
}

int plt_matrices_read(plt_matrices *m, uint32_t blocks, plt_fault *fault) {
    for (; m->is_reading && blocks > 0; blocks--) {
        m->at = PLT_MATRICES_NONE;
        const int status = read_block(m, fault);
        if (status != PLT_OK && --m->tries > 0) {
            begin(m); /* all of it is asked for again */
        } else if (status != PLT_OK) {
            m->failed = m->wanted;
            m->is_reading = 0;
            return status;
        } else if (m->there == m->frame_bytes) {
            m->at = m->wanted;
            m->is_reading = 0;
        }
    }
    return m->is_reading ? PLT_MORE : PLT_OK;
}
