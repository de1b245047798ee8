/* sequence - the frames of an image: which vertices are there, and how others come
 *
 * Invariant: vertices are those of frame `at`, whole and checked, or `at` is PLT_FRAME_NONE. What
 * is shown are records, or vertices of their own, which are not touched here: so a frame can be
 * read while another one is rendered, and one that fails leaves the last one as it is.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_SEQUENCE_H
#define PLT_MOTION_SEQUENCE_H

#include "engine/image/header.h"
#include "engine/motion/frame_reader.h"
#include "engine/motion/vertices.h"

#define PLT_FRAME_NONE UINT32_MAX

typedef struct plt_sequence {
    plt_vertices vertices;
    plt_frame_vertex *vertex; /* those of `vertices`, for writing */
#if PLT_WITH_VERTICES
    const plt_frame_vertex *base; /* where frame `at` is: there, or still shown, so that what comes
                                   * goes beside it */
#endif
    const unsigned char *offsets; /* of each frame in the section, and behind the last one */
    plt_frame_reader reader;
    uint32_t count, frames, key_every; /* count: of vertices */
    uint32_t section;                  /* where frames lie in the image */
    uint32_t word_bits;                /* of a coordinate */
    uint32_t at;                       /* the frame that is there, or PLT_FRAME_NONE */
    uint32_t next, wanted;             /* the frame that comes, up to the one that is asked for */
    uint32_t block;                    /* of the frame that comes, the first that is not there */
    uint32_t failed;                   /* the frame that did not come */
    uint8_t is_reading;                /* frames next .. wanted are asked for */
} plt_sequence;

/* Where the parts lie; those of mapped images in the image. */
typedef struct plt_sequence_room {
    unsigned char *topology, *offsets; /* NULL: mapped */
    unsigned char *window;             /* likewise */
    plt_frame_vertex *vertex;
} plt_sequence_room;

/* Bytes of these parts, of an image with frames. */
uint64_t plt_sequence_topology_bytes(const plt_info *info);
uint64_t plt_sequence_offsets_bytes(const plt_info *info);
uint64_t plt_sequence_vertices_bytes(const plt_info *info);

/* Reads topology and offsets of the image, and checks them: R13, I23, I24. */
int plt_sequence_open(plt_sequence *s, const plt_header *header, const plt_source *source,
                      const plt_sequence_room *room, plt_fault *fault);

/* Begins to bring frame `frame` (below s->frames), which may be there already. */
void plt_sequence_seek(plt_sequence *s, uint32_t frame);

/* So many blocks more. PLT_MORE; PLT_OK: the frame that was asked for is there. */
int plt_sequence_read(plt_sequence *s, uint32_t blocks, plt_fault *fault);

#endif
