/* compact_rig - a mesh as compact blocks, and the same positions as a mesh
 *
 * The packer (lattice_snap) moves a mesh to the lattice, the scene's quantisation grid; thesis
 * nodes and brute force get the moved mesh.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_COMPACT_RIG_H
#define REFERENCE_COMPACT_RIG_H

#include "engine/tree/compact/validate.h"
#include "tests/reference/rig.h"

typedef struct compact_config {
    compact_options pack;
    plt_options run;
} compact_config;

/* K, bits, build and splits; with primitive ids; the largest packet of this build. */
compact_config compact_config_of(uint32_t leaf_triangles, uint8_t bits, uint8_t build,
                                 uint8_t splits);

/* The image of a mesh, which is freed; without bytes if the packer refused. */
packed compact_packed(mesh *m, const compact_config *config);

/* As rig_open; closed by rig_close. */
int compact_open(rig *r, const mesh *m, const compact_config *config);

/* The name of a configuration, for messages; overwritten by the next call. */
const char *compact_name(const compact_config *config);

/* Where section `index` begins, read here and not by the engine. */
const unsigned char *compact_section(const packed *image, unsigned index);

/* Primitive id and rotation of the triangle with image index `index`, from the image. */
void compact_primitive_id(const packed *image, uint32_t index, uint32_t *id, uint32_t *rotation);

/* The mesh with triangle i of `m` at its lattice position. A triangle that has lost its area
 * becomes a point of another: it is never hit and widens no box. */
mesh compact_mesh(const mesh *m, uint8_t bits);

/* Triangle i has image index i in `image`, which has primitive ids, least corner
 * first: what the image is without primitive ids. `moved` is of compact_mesh. */
mesh compact_mesh_in_order(const packed *image, const mesh *moved);

/* The tree of an opened engine. */
const plt_block_tree *compact_tree(const rig *r);

/* Most triangles, up to `wanted`, that this build's depth can hold. */
uint32_t compact_triangles(uint32_t wanted, uint32_t leaf_triangles);

#endif
