/* sequence - see sequence.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/sequence.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"

static uint32_t frame_begin(const plt_sequence *s, uint32_t frame) {
    return s->section + plt_get_u32(s->offsets + 4 * (size_t)frame);
}

static uint32_t blocks_of(const plt_sequence *s) {
    return (s->count + PLT_FRAME_BLOCK - 1) / PLT_FRAME_BLOCK;
}

void plt_sequence_seek(plt_sequence *s, uint32_t frame) {
    const uint32_t key = frame - frame % s->key_every;
    if (s->is_reading && s->wanted == frame) {
        return;
    }
    s->next = s->at != PLT_FRAME_NONE && s->at >= key && s->at <= frame ? s->at + 1 : key;
    s->wanted = frame;
    s->block = 0;
    s->is_reading = s->next <= frame;
    if (s->is_reading) {
        plt_frame_reader_begin(&s->reader, frame_begin(s, s->next), frame_begin(s, frame + 1));
    }
}

/* ---- a block ---------------------------------------------------------------------- */

static int broken(const plt_sequence *s, plt_fault *fault, const char *message) {
    return plt_broken(fault, PLT_I25_FRAME, s->reader.offset, message);
}

/* A block where it has come and is what its check says. */
static int fetch_block(plt_sequence *s, uint32_t vertices, const unsigned char **block,
                       uint32_t *bytes, plt_fault *fault) {
    plt_frame_reader *r = &s->reader;
    const uint32_t left = frame_begin(s, s->next + 1) - r->offset;
    const uint32_t head = plt_frame_bytes_for(0, s->word_bits, 0);
    if (left < head) {
        return broken(s, fault, "a frame ends before its last block");
    }
    const unsigned char *at = plt_frame_reader_need(r, head);
    if (at != NULL) {
        *bytes = plt_frame_block_bytes(at, vertices, s->word_bits);
        if (*bytes == 0 || *bytes > left) {
            return broken(s, fault, "a block of a frame does not fit it");
        }
        at = plt_frame_reader_need(r, *bytes);
    }
    if (at == NULL) {
        return plt_fault_set(fault, PLT_ERR_SOURCE, r->offset, "the source failed to deliver");
    }
    if (plt_get_u32(at) != plt_frame_block_check(at, *bytes, s->next, s->block)) {
        return broken(s, fault, "a block of a frame is damaged (checksum)");
    }
    *block = at;
    return PLT_OK;
}

/* The frame that others differ from is shown, and stays. */
static void bring_base(const plt_sequence *s, plt_frame_vertex *vertex, uint32_t vertices) {
#if PLT_WITH_VERTICES
    if (s->base != s->vertex) {
        memcpy(vertex, s->base + (vertex - s->vertex), vertices * sizeof *vertex);
    }
#else
    (void)s;
    (void)vertex;
    (void)vertices;
#endif
}

static int apply_block(plt_sequence *s, const unsigned char *block, uint32_t vertices,
                       plt_fault *fault) {
    plt_frame_vertex *vertex = s->vertex + (size_t)s->block * PLT_FRAME_BLOCK;
    bring_base(s, vertex, vertices);
    plt_frame_block_apply(block, vertex, vertices, s->word_bits, s->next % s->key_every == 0);
    if (s->word_bits == PLT_FRAME_FLOAT_BITS && !plt_frame_floats_valid(vertex, vertices)) {
        return plt_broken(fault, PLT_I26_POSITIONS, s->reader.offset,
                          "a position of a frame is not a number, or beyond 2^40");
    }
    return PLT_OK;
}

static int read_block(plt_sequence *s, plt_fault *fault) {
    const uint32_t first = s->block * PLT_FRAME_BLOCK, left = s->count - first;
    const uint32_t vertices = left < PLT_FRAME_BLOCK ? left : PLT_FRAME_BLOCK;
    const unsigned char *block = NULL;
    uint32_t bytes = 0, tries = s->reader.window != NULL ? PLT_FETCH_TRIES : 1;
    int status;
    while ((status = fetch_block(s, vertices, &block, &bytes, fault)) != PLT_OK && --tries > 0) {
        plt_frame_reader_begin(&s->reader, s->reader.offset, s->reader.end);
    }
    if (status == PLT_OK) {
        status = apply_block(s, block, vertices, fault);
    }
    if (status == PLT_OK) {
        plt_frame_reader_skip(&s->reader, bytes);
        s->block++;
    }
    return status;
}

/* ---- frames ----------------------------------------------------------------------- */

/* Its last block is there: it ends where the next one begins. */
static int finish_frame(plt_sequence *s, plt_fault *fault) {
    if (s->reader.offset != frame_begin(s, s->next + 1)) {
        return broken(s, fault, "a frame goes on behind its last block");
    }
    s->at = s->next++;
    s->block = 0;
#if PLT_WITH_VERTICES
    s->base = s->vertex;
#endif
    return PLT_OK;
}

int plt_sequence_read(plt_sequence *s, uint32_t blocks, plt_fault *fault) {
    int status = PLT_OK;
    for (; s->is_reading && status == PLT_OK && blocks > 0; blocks--) {
        s->at = PLT_FRAME_NONE;
        status = read_block(s, fault);
        if (status == PLT_OK && s->block == blocks_of(s)) {
            status = finish_frame(s, fault);
        }
        s->is_reading = s->next <= s->wanted;
    }
    plt_frame_reader_settle(&s->reader);
    if (status != PLT_OK) {
        s->failed = s->next;
        s->at = PLT_FRAME_NONE;
        s->is_reading = 0;
        return status;
    }
    return s->is_reading ? PLT_MORE : PLT_OK;
}
