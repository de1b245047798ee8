/* sequence - frames of one topology, coded behind the scene that is packed from the first
 *
 * Frames come one after the other; of the one before, its coordinates are kept, no more. The code
 * of SPEC.md, section 4.15.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_SEQUENCE_H
#define PACK_SEQUENCE_H
#include "engine/base/lattice.h"
#include "engine/motion/frame_block.h"
#include "host_tools/pack/pack.h"

typedef struct sequence_options {
    uint32_t frames;     /* that will be added */
    uint32_t frame_rate; /* per second, 1 .. PLT_FRAME_RATE_MOST */
    uint32_t key_every;  /* from 1 */
    plt_lattice lattice; /* that all frames lie on; bits 0: floats, as they are */
    uint8_t stills;      /* compact blocks, all of them once for each frame, to be streamed */
} sequence_options;

typedef struct sequence {
    sequence_options options;
    uint32_t *number;          /* of each vertex of the mesh that triangles use; owned */
    size_t mesh_vertices;      /* there are so many */
    uint32_t vertices, frames; /* used ones; frames added so far */
    uint32_t word_bits;
    plt_frame_vertex *before, *now; /* the frames that differ; owned */
    unsigned char *bytes;           /* offsets, then frames; of stills vertices alone; owned */
    uint64_t size, room;
    moving_vertices moving; /* for pack_compact; its result owned */
} sequence;

/* Nothing but what of `first` all frames share. `name` is for errors. -1: out of memory; `s` is to
 * be freed in any case. */
int sequence_begin(sequence *s, const mesh *first, const sequence_options *options,
                   const char *name, fail *f);

/* The next frame: vertices as many as of the first, each coordinate within the lattice's box. */
int sequence_add(sequence *s, const mesh *frame, const char *name, fail *f);

/* Puts the frames behind `image`, which was packed from the first of them (on the lattice:
 * sequence_snap; compact blocks with compact_options.moving). Both are as they were if it fails. */
int sequence_finish(sequence *s, packed *image, const mesh *first, const char *name, fail *f);

void sequence_free(sequence *s);

/* Moves all vertices onto the lattice: the positions that the engine shows. */
void sequence_snap(mesh *m, const plt_lattice *lattice);

#endif
