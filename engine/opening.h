/* opening - the steps of plt_open, by the format of the image
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_OPENING_H
#define PLT_OPENING_H

#include "engine/engine.h"

typedef struct plt_opening {
    plt_engine *e;
    plt_fault *fault;
} plt_opening;

/* PLT_ERR_ARENA with the bytes that would be enough. */
int plt_opening_short(const plt_opening *o);

/* The section of a kind: where it lies when the image is mapped and `copy` is 0,
 * else in the arena; its checksum is right. */
int plt_opening_section(const plt_opening *o, uint32_t kind, int copy, const void **bytes);

/* Take the scene, check it or build its tree, and set up the walker. PLT_MORE:
 * blocks are to be built, by plt_opening_step: `steps` splits or blocks at a
 * time, until it returns PLT_OK. */
int plt_opening_thesis(const plt_opening *o);
int plt_opening_compact(const plt_opening *o);
int plt_opening_step(const plt_opening *o, uint32_t steps);

#endif
