/* lattice_tally - what would come of moving a vertex of many triangles, kept up to date
 *
 * A vertex has eight grid points around it. Of each a tally knows how many of the
 * vertex's triangles would lose their area there, and how many lines fewer there would be.
 * When another vertex moves, only the triangles that it shares change in the tally: slivers
 * from one vertex are mended in linear time.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_LATTICE_TALLY_H
#define HOST_LATTICE_TALLY_H
#include "host_tools/pack/lattice_around.h"

/* POINT: also of two, or a line in the mesh */
enum lattice_state { LATTICE_AREA, LATTICE_LINE, LATTICE_POINT };

typedef struct lattice_target {
    lattice_position at;
    double far2; /* square of how far the vertex is from there, in steps; or infinite */
    int64_t lost, fewer;
} lattice_target;

typedef struct lattice_tally {
    lattice_target target[8];
    uint32_t moves; /* of the vertex, so far */
} lattice_tally;

/* A mesh while corners move. Only entries of first vertices in `moved` are looked at. */
typedef struct lattice_moving {
    const snapped *s;
    const mesh *m;
    lattice_position *moved; /* where each vertex is */
    lattice_around around;
    uint32_t *tally_of; /* of each vertex, from 1; 0: none */
    lattice_tally *tally;
    uint32_t tallies, tally_room;
} lattice_moving;

/* What becomes of a triangle when the first vertex `vertex` goes to `to`. */
enum lattice_state lattice_state_of(const lattice_moving *d, size_t triangle, uint32_t vertex,
                                    const lattice_position *to);

/* The eight grid points around a first vertex; `lost` and `fewer` are 0. */
void lattice_targets(const lattice_moving *d, uint32_t vertex, lattice_target target[8]);

/* Adds to one target what a triangle of the vertex contributes, `times` 1 or -1. */
void lattice_target_add(const lattice_moving *d, uint32_t vertex, size_t triangle,
                        lattice_target *target, int times);

/* The tally of a first vertex, made at the first call; NULL when memory is out. Another
 * call may move it. */
lattice_tally *lattice_tally_for(lattice_moving *d, uint32_t vertex);

/* Moves a first vertex; all tallies are right again. */
void lattice_move_to(lattice_moving *d, uint32_t vertex, const lattice_position *to);

#endif
