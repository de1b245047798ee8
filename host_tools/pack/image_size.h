/* image_size - how large an image may be, and how small it can be at best
 *
 * Sizes and offsets in an image have 32 bits, a triangle's number 27, and the address of a
 * compact block 24 bits, times 8 (SPEC.md, 2 and 4.8). What a scene takes at best is known from
 * the number of its triangles, before the tree is built.
 *
 * SPDX-License-Identifier: MIT */
#ifndef IMAGE_SIZE_H
#define IMAGE_SIZE_H
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "host_tools/pack/pack_options.h"

/* -1, and says so, when no image holds so many triangles of a mesh, whatever their tree is. What a
 * lattice leaves of them is not known then: that is checked when it is. */
int image_size_check_thesis(const char *name, uint64_t triangles, const pack_options *options,
                            fail *f);
int image_size_check_compact(const char *name, uint64_t triangles, const compact_options *options,
                             fail *f);
/* The same of triangles on the lattice, with coordinates of `width` bytes. */
int image_size_check_lattice(const char *name, uint64_t triangles, const compact_options *options,
                             uint32_t width, fail *f);

/* Room in which the blocks of so many triangles are always built. */
uint64_t image_size_room_blocks(uint64_t triangles);

/* What would make it smaller, for a message. */
const char *image_size_remedy_thesis(const pack_options *options);
const char *image_size_remedy_compact(const compact_options *options);

/* -1, and says so, when that is more than an image may have. `at_least`: the bytes are what it
 * would have at best. */
int image_size_check(const char *name, uint64_t triangles, uint64_t bytes, int at_least,
                     const char *remedy, fail *f);
#endif
