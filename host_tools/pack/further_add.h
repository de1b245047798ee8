/* further_add - one more section behind those of a finished image (SPEC.md, 4.18)
 *
 * SPDX-License-Identifier: MIT */
#ifndef FURTHER_ADD_H
#define FURTHER_ADD_H
#include "host_tools/pack/pack.h"

/* `kind` is above those that are there. `section`: `size` bytes, a multiple of 64. -1, and the
 * image as it was: memory is out, or it gets too large, against which `remedy` helps. */
int further_add(packed *image, uint32_t kind, const unsigned char *section, uint32_t size,
                const char *name, const char *remedy, fail *f);

#endif
