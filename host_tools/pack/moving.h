/* moving - compact blocks with room for every frame of a sequence
 *
 * Vertices are one if the mesh says so, wherever they are in the first frame, as they may part
 * later. So blocks are built of their numbers, and get their positions by the engine's own refit.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_MOVING_H
#define PACK_MOVING_H
#include "engine/builder/blocks_job.h"
#include "engine/image/header.h"
#include "engine/motion/frame_block.h"
#include "host_tools/pack/pack_options.h"
#include "host_tools/pack/snapped.h"

/* All triangles of the mesh, whose vertices lie on the lattice already; of no area, too. -1: out of
 * memory. */
int moving_snap(snapped *s, const mesh *m, const plt_lattice *lattice);

/* Has the builder make blocks of the triangles in `s`, which may have come into another order. -1:
 * out of memory; moving_end in any case. */
int moving_begin(plt_blocks_job *job, const snapped *s, const mesh *m, const moving_vertices *v,
                 int has_ids);

/* Once they are built: the numbers of the blocks' vertices are the caller's. */
void moving_end(plt_blocks_job *job, moving_vertices *v);

/* Puts all vertices where `vertex` says into the blocks at `blocks`, and ids (NULL: there are
 * none), of frame `frame`; checks are right then. `numbers`: of their vertices, as in the image.
 * The box of all goes to `box`. -1: out of memory. */
int moving_put(const plt_header *h, unsigned char *blocks, unsigned char *ids, uint32_t frame,
               const plt_frame_vertex *vertex, const unsigned char *numbers, plt_lattice_box *box);

/* The header's box is that one. */
void moving_set_box(plt_header *h, const plt_lattice_box *box);

#endif
