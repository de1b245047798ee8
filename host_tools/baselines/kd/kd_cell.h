/* kd_cell - a cell that is not split yet, and what it becomes
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_CELL_H
#define BASELINES_KD_CELL_H

#include "host_tools/baselines/kd/kd_stray.h"

/* Both arrays are heap blocks of the cell's own. */
typedef struct kd_cell {
    float lo[3], hi[3];
    kd_reference *reference;
    uint32_t *stray;
    uint32_t count, strays;
    uint32_t levels; /* that there may be below it */
} kd_cell;

/* Where a cell is cut, and what rays then cost by the surface area heuristic. Without one `cost` is
 * that of a leaf. */
typedef struct kd_cut {
    float cost, at;
    uint8_t axis, is_cut;
} kd_cut;

/* Where a reference of a cell is in the lower and the upper one. */
#define KD_NOWHERE 0xFFFFFFFFu
typedef struct kd_move {
    uint32_t to[2];
    int is_whole; /* all of it is in one cell, as it was */
} kd_move;

/* Of all triangles. -1: no memory. */
int kd_cell_begin(kd_cell *c, const kd_scene *s);

/* Two cells of one, which keeps what it has; of reference i moves[i] says where it is, unless
 * `moves` is NULL. -1: no memory, and there are none. */
int kd_cell_split(const kd_cell *c, const kd_scene *s, const kd_cut *cut, kd_cell to[2],
                  kd_move *moves);

void kd_cell_free(kd_cell *c);
uint64_t kd_cell_bytes(const kd_cell *c); /* of both arrays */

#endif
