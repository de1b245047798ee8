/* snapped - triangles, or their boxes, on the lattice: what the packer writes
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_SNAPPED_H
#define HOST_SNAPPED_H
#include <stdint.h>

#include "engine/base/box.h"
#include "engine/base/lattice.h"
#include "engine/planelet_config.h"
#include "host_tools/base/fail.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/pack/lattice.h"

/* What moving cost; printed by pack. */
typedef struct lattice_loss {
    uint32_t bits; /* of the lattice chosen, and its step */
    float step;
    double largest_move;  /* of a vertex, as a fraction of the mesh's longest side */
    uint64_t vertices;    /* that triangles on the lattice use, or would but for their area */
    uint64_t unmoved;     /* of them, those that stayed exactly where they were */
    uint64_t flat_before; /* triangles that had no area in the mesh */
    uint64_t flat_now;    /* and those that lost theirs on the lattice */
    uint64_t merged;      /* positions that differed and no longer do */
    uint64_t mended;      /* corners moved to give slivers an area again */
    uint64_t t_junctions; /* dropped slivers whose middle corner lies on an edge */
} lattice_loss;

typedef struct snapped {
    plt_lattice lattice;
    plt_box mesh_box;       /* of the triangles that count (extent.h), where they were */
    plt_lattice_box box;    /* of the triangles that are left */
    unsigned char *corners; /* 9 coordinates each, of boxes 6, of `width` bytes; owned */
    uint32_t width;
    uint32_t *source;  /* primitive id of each; owned */
    uint8_t *rotation; /* engine/tree/primitive_id.h; owned; NULL for boxes */
    uint32_t count;
    lattice_loss loss;
} snapped;

typedef struct lattice_position {
    uint32_t q[3];
} lattice_position;

/* q[0] of a vertex that no triangle uses which counts: it has no position on the lattice. */
#define LATTICE_UNUSED UINT32_MAX

/* A coordinate of the mesh in steps from the origin, not rounded. */
static inline double lattice_steps(const snapped *s, const float p[3], int axis) {
    return ((double)p[axis] - (double)s->lattice.origin[axis]) / (double)s->lattice.step;
}

/* The greatest number of steps along an axis: of the lattice, and within the coordinates of
 * the engine. Every number up to it is good. */
static inline uint32_t lattice_most(const snapped *s, int axis) {
    uint32_t most = (1u << s->lattice.bits) - 1u;
    while (most > 0 && plt_lattice_float(&s->lattice, axis, most) > PLT_COORD_MAX) {
        const double over =
            (double)plt_lattice_float(&s->lattice, axis, most) - (double)PLT_COORD_MAX;
        const double back = over / (double)s->lattice.step;
        most = back < (double)most ? most - (uint32_t)back - (back < 1) : 0;
    }
    return most;
}

/* Empty, with the lattice for the mesh: for triangles that count, or for boxes of all. */
int snapped_begin(snapped *s, const mesh *m, const lattice_wish *wish, int are_boxes,
                  const char *name, fail *f);

/* Room for so many triangles of 3 positions, the corners, or 2, of boxes. -1 when memory is out;
 * snapped_free frees it in either case. */
int snapped_make_room(snapped *s, size_t triangles, uint32_t positions);

/* One more triangle, of so many positions, made of the mesh's triangle `source`. */
void snapped_add(snapped *s, const lattice_position *p, uint32_t positions, uint32_t source);

void snapped_free(snapped *s);

#endif
