/* pack_surface - normals, colours, texture coordinates: what of a mesh's an image keeps, or what is
 * made of it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_SURFACE_H
#define PACK_SURFACE_H
#include "host_tools/app/args.h"
#include "host_tools/cli/pack_meshes.h"
#include "host_tools/pack/surface.h"

#define PACK_SURFACE_FLAGS                                                                         \
    {"--normals", "keep|none",                                                                     \
     "normals of corners, for --shader smooth: those of the meshes (PLY nx ny nz, OBJ vn), 1 to "  \
     "1.5 bytes per triangle where neighbours share them (default none)"},                         \
        {"--smooth", "DEGREES",                                                                    \
         "normals of corners, made of the triangles that meet there at no more than that angle, "  \
         "0 "                                                                                      \
         "to 180"},                                                                                \
        {"--colours", "keep|none",                                                                 \
         "colours of corners (PLY red green blue, OBJ v x y z r g b), 0.6 bytes per triangle, or " \
         "0.9 and a palette where 255 would be far off (default none)"},                           \
        {"--texcoords", "keep|fine|none",                                                          \
         "texture coordinates of corners (PLY u v or s t, OBJ vt), in 24 bits, 1.9 bytes per "     \
         "triangle, or in 32 (default none)"},                                                     \
    {                                                                                              \
        "--surface", "tables|pages",                                                               \
            "how an image has normals, colours and texture coordinates: in tables that are "       \
            "resident, or page by page, so that they are streamed, too, for 0.2 bytes per "        \
            "triangle more each (default tables)"                                                  \
    }

typedef struct pack_surface {
    int smooths;    /* --smooth */
    double degrees; /* ... so much */
    int paged;      /* --surface pages */
    mesh_corners corners;
    surface_stats stats;
} pack_surface;

/* The flags; a wrong one sets a->wrong. */
void pack_surface_read(pack_surface *s, args *a);
/* --surface, once it is known what corners are to have: textures want coordinates, too. */
void pack_surface_check(const pack_surface *s, args *a);
int pack_surface_wanted(const pack_surface *s);

/* Of meshes as they will be packed: makes normals, if they are asked for; fails when there are none
 * to keep. */
int pack_surface_prepare(pack_surface *s, const pack_meshes *in, fail *f);
/* Adds them to the finished image. */
int pack_surface_add(pack_surface *s, const pack_meshes *in, packed *image, fail *f);
/* A line each about what there is. */
void pack_surface_say(const pack_surface *s, const packed *image);
void pack_surface_free(pack_surface *s);

#endif
