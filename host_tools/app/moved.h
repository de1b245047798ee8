/* moved - the frames of a sequence of meshes, put into a scene one after the other
 *
 * SPDX-License-Identifier: MIT */
#ifndef MOVED_H
#define MOVED_H

#include "host_tools/app/args.h"
#include "host_tools/app/frame_range.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/fail.h"

#define MOVED_FLAGS                                                                                \
    {"--moved", "MESH",                                                                            \
     "the scene in motion: its triangles go where those of MESH are in each of "                   \
     "--frames, a recipe with sequences, or files with the frame's number for a '{}' in their "    \
     "name: 000, 001 ...; the scene was packed from one of them (thesis nodes, resident)"},        \
    {                                                                                              \
        "--frames", "A:B",                                                                         \
            "frames A to B - 1 of --moved (default 0:1), or of those in the image, 0 to "          \
            "99999"                                                                                \
    }

typedef struct moved {
    const char *mesh; /* NULL: the frames are the image's, or nothing moves */
    int is_played;    /* they are the image's */
    frame_range range;
    double read_seconds, move_seconds; /* of all so far: the second without reading */
} moved;

/* Reads the flags, and sets what the scene's options need. Refuses through args_complain. */
void moved_read(moved *m, scene *s, args *a);

/* 1: there are frames, of meshes or of the image. */
static inline int moved_is(const moved *m) {
    return m->mesh != NULL || m->is_played;
}

/* The triangles of all of the scene's engines, open on `path`, go where those of frame
 * m->range.first + `index` are. -1: `f` names the frame. */
int moved_to(moved *m, scene *s, const char *path, unsigned index, fail *f);

/* JSON members, each ending in ",\n". `repeat`: runs that times are over. */
void moved_print(output *o, const moved *m, unsigned repeat, fail *f);

#endif
