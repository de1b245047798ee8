/* sequence_rig - frames of a mesh that deforms, packed and opened
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_SEQUENCE_RIG_H
#define REFERENCE_SEQUENCE_RIG_H

#include "board/fake/fake.h"
#include "host_tools/pack/sequence.h"
#include "tests/reference/rig.h"

enum { SEQUENCE_FRAMES_MOST = 16 };

typedef struct sequence_config {
    rig_config scene;
    uint32_t frames, key_every;
    uint32_t lattice_bits; /* 0: floats */
    int is_mapped;
    int is_compact;  /* blocks that move, of the scene's K and splits; on a lattice */
    int without_ids; /* ... and without primitive ids */
    int is_stills;   /* ... and streamed, as blocks for each frame */
} sequence_config;

typedef struct sequence_rig {
    mesh frame[SEQUENCE_FRAMES_MOST]; /* as they are shown: on the lattice, if there is one */
    uint32_t frames;
    packed image;
    fake_link link; /* not mapped: the image comes through it */
    unsigned char *arena;
    size_t arena_bytes;
    plt_engine *engine;
    plt_fault fault;
} sequence_rig;

/* Frame `k` of `first`: each vertex has gone somewhere, some of them nowhere; no vertex is farther
 * than 4 from the origin if those of `first` are in the cube -1 .. 1. */
void sequence_deform(mesh *m, const mesh *first, uint32_t k);

/* The lattice of so many bits over the cube -4 .. 4; bits 0: none. */
plt_lattice sequence_lattice(uint32_t bits);

/* Deforms `first`, moves all frames onto the lattice and packs them. */
void sequence_rig_pack(sequence_rig *r, const mesh *first, const sequence_config *config);

/* The image alone, of a soup of so many triangles; pack_free() it. */
packed sequence_rig_image(const sequence_config *config, uint32_t triangles, uint64_t seed);

/* Opens the image in an arena of just its need, less `short_by` bytes. A status of plt_open. */
int sequence_rig_open(sequence_rig *r, const sequence_config *config, size_t short_by);

/* Both. */
int sequence_rig_start(sequence_rig *r, const mesh *first, const sequence_config *config);

/* 1: nothing was written behind the arena. Frees all. */
int sequence_rig_close(sequence_rig *r);

#endif
