/* gallery - a mesh for every row of the tables: the thesis's own, or what stands in for it
 *
 * Of a folder with meshes, by the names that MEASURING.md lists, those are taken that are there;
 * for the others a scene is made, of as many triangles where that is possible. Animations whose
 * frames are not to be had are the still mesh, twisted about its vertical axis and back.
 *
 * SPDX-License-Identifier: MIT */
#ifndef GALLERY_H
#define GALLERY_H

#include "host_tools/base/fail.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/tables/printed.h"

enum { GALLERY_NOTE = 200 };

typedef struct gallery {
    const char *folder; /* NULL: all scenes are made */
} gallery;

/* What a row's mesh is. */
typedef struct gallery_about {
    int stands_in;           /* 0: it is the thesis's own mesh */
    char note[GALLERY_NOTE]; /* what stands in; "" */
} gallery_about;

/* -1: the folder is none, or has no mesh of any row. */
int gallery_open(gallery *g, const char *folder, fail *f);

/* `m` is all zero, and freed on failure. */
int gallery_still(const gallery *g, unsigned scene, mesh *m, gallery_about *about, fail *f);
/* Step `step` of `steps` that are spread evenly over an animation's frames, the first and the last
 * among them. All have the same triangles. */
int gallery_frame(const gallery *g, unsigned animation, unsigned step, unsigned steps, mesh *m,
                  gallery_about *about, fail *f);

#endif
