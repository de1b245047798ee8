/* compact_rig - a mesh as compact blocks, and the same positions as a mesh
 *
 * What a lattice does to a mesh is asked of the packer (lattice_snap); the
 * meshes made of that here are what thesis nodes and brute force are given.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_COMPACT_RIG_H
#define REFERENCE_COMPACT_RIG_H

#include "engine/tree/compact/validate.h"
#include "tests/reference/rig.h"

typedef struct compact_way {
    compact_options pack;
    plt_options run;
} compact_way;

/* K, bits, build and splits; numbers kept; the largest packet of this build. */
compact_way compact_way_of(uint32_t leaf_triangles, uint8_t bits, uint8_t build, uint8_t splits);

/* The image of a mesh, which is freed; without bytes if the packer refused. */
packed compact_packed(mesh *m, const compact_way *way);

/* As rig_open; closed by rig_close. */
int compact_open(rig *r, const mesh *m, const compact_way *way);

/* The name of a way, for messages; overwritten by the next call. */
const char *compact_name(const compact_way *way);

/* Where section `index` begins, read here and not by the engine. */
const unsigned char *compact_section(const packed *image, unsigned index);

/* Number and rotation of the triangle at `place`, from the numbers of the image. */
void compact_number(const packed *image, uint32_t place, uint32_t *number, uint32_t *rotation);

/* Triangle i of `m` where the lattice puts it. One that has lost its area is a
 * point of another, so that it is never hit and widens no box. */
mesh compact_mesh(const mesh *m, uint8_t bits);

/* Triangle i is the one at place i of `image`, which has numbers, least corner
 * first: what the image is without numbers. `moved` is of compact_mesh. */
mesh compact_mesh_in_order(const packed *image, const mesh *moved);

/* The tree of an opened engine. */
const plt_block_tree *compact_tree(const rig *r);

/* Most triangles, up to `wanted`, that this build's depth can hold. */
uint32_t compact_triangles(uint32_t wanted, uint32_t leaf_triangles);

#endif
