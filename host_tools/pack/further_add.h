/* further_add - one more section among those of a finished image (SPEC.md, 4.18)
 *
 * SPDX-License-Identifier: MIT */
#ifndef FURTHER_ADD_H
#define FURTHER_ADD_H
#include "host_tools/pack/pack.h"

/* The most bytes that it takes beside the section: a longer table. */
#define FURTHER_ADD_MORE 128u

/* Of a `kind` that is not there yet. `section`: `size` bytes, a multiple of 64; with what it
 * takes the image has less than 4 GiB. -1, and the image as it was: memory is out. */
int further_add(packed *image, uint32_t kind, const unsigned char *section, uint32_t size,
                const char *name, fail *f);

#endif
