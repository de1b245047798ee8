/* matrices - the frames of an image with instances: a matrix each, and how they come
 *
 * Invariant: matrices are those of frame `at`, whole and checked, or `at` is PLT_MATRICES_NONE.
 * What rays meet are instances as they were placed, which are not touched here: so a frame can be
 * read while another one is rendered, and one that fails leaves the last one as it is.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_INSTANCES_MATRICES_H
#define PLT_INSTANCES_MATRICES_H

#include "engine/base/bytes.h"
#include "engine/image/header.h"
#include "engine/image/items.h"
#include "engine/instances/placed.h"

#define PLT_MATRICES_NONE UINT32_MAX

typedef struct plt_matrices {
    const plt_source *source;
    unsigned char *bytes; /* of a frame, as it lies in the image; in the arena */
    uint32_t section, frame_bytes;
    uint32_t frames;
    uint32_t at;            /* the frame that is there, or PLT_MATRICES_NONE */
    uint32_t wanted, there; /* the frame that comes, and its bytes that have */
    uint32_t crc;           /* of those, but for the first four */
    uint32_t failed;        /* the frame that did not come */
    uint8_t tries;          /* that are left */
    uint8_t is_reading;     /* a frame is asked for */
} plt_matrices;

/* Bytes of a frame; all frames of the header's image have as many. */
static inline uint32_t plt_matrices_frame_bytes(const plt_info *info) {
    return PLT_MATRICES_HEAD + info->instances * PLT_MATRIX_BYTES;
}

/* `room`: for the bytes of a frame. */
void plt_matrices_init(plt_matrices *m, const plt_header *header, const plt_source *source,
                       void *room);

/* Begins to bring frame `frame`, below m->frames, which may be there already. */
void plt_matrices_seek(plt_matrices *m, uint32_t frame);

/* So many blocks of 64 matrices more. PLT_MORE; PLT_OK: the frame that was asked for is there. */
int plt_matrices_read(plt_matrices *m, uint32_t blocks, plt_fault *fault);

/* What the frame's check has to be, `bytes` being all of it. */
uint32_t plt_matrices_check(const unsigned char *bytes, uint32_t count, uint32_t frame);

/* Of the frame that is there. */
static inline void plt_matrices_get(const plt_matrices *m, uint32_t instance,
                                    float to[PLT_MATRIX_FLOATS]) {
    plt_get_floats(to, m->bytes + PLT_MATRICES_HEAD + (size_t)instance * PLT_MATRIX_BYTES,
                   PLT_MATRIX_FLOATS);
}

#endif
