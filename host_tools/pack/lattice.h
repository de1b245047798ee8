/* lattice - a mesh moved onto the lattice, the scene's quantisation grid
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_H
#define HOST_LATTICE_H
#include <stdint.h>

#include "engine/base/lattice.h"
#include "host_tools/base/fail.h"
#include "host_tools/mesh/mesh.h"

/* What moving cost; printed by pack. */
typedef struct lattice_loss {
    double largest_move;  /* of a vertex, as a fraction of the longest side */
    uint64_t flat_before; /* triangles that had no area in the mesh */
    uint64_t flat_now;    /* and those that lost theirs on the lattice */
    uint64_t merged;      /* positions that differed and no longer do */
    uint64_t mended;      /* corners moved to give slivers an area again */
    uint64_t t_junctions; /* dropped slivers whose middle corner lies on an edge */
} lattice_loss;

typedef struct snapped {
    plt_lattice lattice;
    plt_box mesh_box;       /* of the mesh's triangles, where it was */
    plt_lattice_box box;    /* of the triangles that are left */
    unsigned char *corners; /* 9 coordinates each, of `width` bytes; owned */
    uint32_t width;
    uint32_t *source;  /* primitive id of each; owned */
    uint8_t *rotation; /* engine/tree/primitive_id.h; owned */
    uint32_t count;
    lattice_loss loss;
} snapped;

/* Bits that keep every vertex within `tolerance` (a fraction of the longest
 * side) of where it was; 0 when 21 are not enough. */
uint32_t lattice_bits_for(double tolerance);

/* Leaves the mesh where it is: `corners` become the triangles' boxes (6
 * coordinates each), rounded outwards, of all triangles. */
int lattice_boxes(snapped *s, const mesh *m, uint32_t bits, const char *name, fail *f);

/* Moves the mesh. Triangles without area on the lattice are left out. Refuses a
 * lattice finer than the floats around it. */
int lattice_snap(snapped *s, const mesh *m, uint32_t bits, const char *name, fail *f);
void lattice_free(snapped *s);

#endif
