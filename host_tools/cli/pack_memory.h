/* pack_memory - what memory a pack takes, and whether that is given
 *
 * Known when the meshes are read, from their counts, before anything that takes long. What
 * can be left out to take less, without another image, is looking for open edges.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_MEMORY_H
#define PACK_MEMORY_H
#include "host_tools/cli/pack_meshes.h"
#include "host_tools/pack/pack.h"

#define PACK_MEMORY_LEAST 1048576u
#define PACK_MEMORY_MOST 1125899906842624u /* 2^50 */

/* How the image is built: `compact`, when its lattice has bits, or else `thesis`. */
typedef struct pack_plan {
    const pack_options *thesis;
    const compact_options *compact;
    int is_high; /* --quality */
} pack_plan;

/* `needed` is the most that the heap holds at any time (base/heap.h), reading included, and
 * `least` the same without looking for open edges. */
typedef struct pack_memory {
    uint64_t needed, least;
} pack_memory;

/* Of meshes that have been read. -1, and says so, when `least` is over the heap's limit. */
int pack_memory_plan(pack_memory *memory, const pack_meshes *in, const pack_plan *plan, fail *f);

/* A line about it for a person, when there is a limit or it is much. */
void pack_memory_note(const pack_memory *memory, const char *name);

/* After a failure: says that it was the limit, if it was. */
void pack_memory_explain(const char *name, fail *f);

#endif
