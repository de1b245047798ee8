/* room - memory aligned as the engine asks, of just so many bytes, for sanitizers
 *
 * malloc does so on most CPUs, but not on all: on Arm with 32 bits it gives multiples of 8.
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_ROOM_H
#define REFERENCE_ROOM_H

#include <stddef.h>

/* Aligned to PLT_ALIGN; the caller's, to be given to free. NULL: there is none. */
void *room_get(size_t bytes);

#endif
