/* frame_decoder - an image's sequence, read as SPEC.md, section 4.15, says, bit by bit
 *
 * Shares no code with the engine or the packer: header, topology, blocks and checks are read here
 * by themselves, one bit at a time.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_FRAME_DECODER_H
#define REFERENCE_FRAME_DECODER_H

#include <stddef.h>
#include <stdint.h>

typedef struct frame_decoder {
    uint32_t triangles, vertices, frames, rate, key_every, frame_bytes, bits;
    float origin[3], step;
    const unsigned char *topology, *section; /* the second: frames */
    const char *sentence;                    /* NULL, or what is wrong with the image */
} frame_decoder;

/* Of an image with a sequence. */
frame_decoder frame_decoder_of(const unsigned char *image, uint32_t bytes);

/* Frame `k` by all that it depends on, three floats per vertex in `position`. Bytes of the frames
 * that were read; 0, and d->sentence says why: they are wrong. */
uint32_t frame_decode(frame_decoder *d, uint32_t k, float *position);

/* Vertex of corner `corner` of triangle `id`. */
uint32_t frame_vertex(const frame_decoder *d, uint32_t id, unsigned corner);

#endif
