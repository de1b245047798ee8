/* pack_textures - the pictures of materials: what of them an image keeps
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_TEXTURES_H
#define PACK_TEXTURES_H
#include "host_tools/app/args.h"
#include "host_tools/mesh/corners.h"
#include "host_tools/mesh/materials.h"
#include "host_tools/pack/material_section.h"
#include "host_tools/pack/texture_section.h"

#define PACK_TEXTURES_FLAGS                                                                        \
    {                                                                                              \
        "--textures", "rgb565|blocks|none",                                                        \
            "with --materials: pictures that MTL names by map_Kd, PNG or PPM: 2 bytes per texel, " \
            "or half a byte and less true; a third more for smaller copies (default rgb565)"       \
    }

/* A picture that was read, or could not be: then it has no pixels. */
typedef struct pack_picture {
    const char *path; /* of a map; not owned */
    unsigned number;  /* of the picture; PACK_NO_PICTURE: it was not read */
} pack_picture;

#define PACK_NO_PICTURE 0xFFFFu

typedef struct pack_textures {
    int wanted;          /* 0: none */
    int wants_texcoords; /* nobody else does */
    uint8_t format;
    pack_picture *file; /* by path; owned */
    size_t files;
    picture *picture; /* that differ; owned */
    unsigned pictures;
    texture_stats stats;
} pack_textures;

/* The flag; `materials`: those are wanted. A wrong one sets a->wrong. Textures want the corners'
 * texture coordinates, unless --texcoords says what becomes of those. */
void pack_textures_read(pack_textures *t, args *a, int materials, mesh_corners *c);

/* The meshes and pictures are read: without texture coordinates there are no textures, and
 * coordinates that only textures want are left out where there are none. */
void pack_textures_settle(pack_textures *t, mesh_corners *c, const char *name);

/* Reads the pictures of all materials that triangles have. One that cannot be used is said, or with
 * `strict` a failure. */
int pack_textures_open(pack_textures *t, const mesh_materials *m, int strict, fail *f);

/* Adds them to an image that has the materials; `number`: as material_section_add sets it. */
int pack_textures_add(pack_textures *t, const mesh_materials *m, const uint16_t *number,
                      packed *image, const char *name, fail *f);

/* Lines about what there is, and what is left out. */
void pack_textures_say(const pack_textures *t, const mesh_materials *m, const char *name);
void pack_textures_free(pack_textures *t);

#endif
