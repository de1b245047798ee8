/* pack_materials - materials: what of those of OBJ files an image keeps
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_MATERIALS_H
#define PACK_MATERIALS_H
#include "host_tools/app/args.h"
#include "host_tools/cli/pack_meshes.h"
#include "host_tools/cli/pack_textures.h"
#include "host_tools/pack/material_section.h"

#define PACK_MATERIALS_FLAGS                                                                       \
    {"--materials", "keep|none",                                                                   \
     "what triangles are made of, for --shader whitted and textures: those of OBJ files and "      \
     "their MTL, 64 bytes each and 5 per run of triangles (default none)"},                        \
        PACK_TEXTURES_FLAGS, {                                                                     \
        "--strict", NULL, "refuse materials that are not found, in place of a word about them"     \
    }

typedef struct pack_materials {
    int wanted, strict;
    mesh_materials materials;
    material_stats stats;
    pack_textures textures;
} pack_materials;

/* The flags; a wrong one sets a->wrong. Textures want the corners' texture coordinates. */
void pack_materials_read(pack_materials *p, args *a, mesh_corners *corners);

/* Once the meshes are read: says what was not found, or with --strict fails. */
int pack_materials_check(pack_materials *p, const pack_meshes *in, fail *f);
/* Adds them to the finished image. */
int pack_materials_add(pack_materials *p, const pack_meshes *in, packed *image, fail *f);
/* A line about what there is. */
void pack_materials_say(const pack_materials *p, const pack_meshes *in, const packed *image);
void pack_materials_free(pack_materials *p);

#endif
