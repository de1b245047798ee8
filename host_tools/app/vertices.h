/* vertices - whether a sequence has records of its triangles, by the flags
 *
 * SPDX-License-Identifier: MIT */
#ifndef VERTICES_H
#define VERTICES_H

#include "host_tools/app/args.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/output.h"

#define VERTICES_FLAGS                                                                             \
    {"--records", "auto|always|never",                                                             \
     "of an image's frames: triangles have records in memory, or are made of their vertices "      \
     "whenever a ray comes to them; auto is what the arena has room for (default auto)"},          \
    {                                                                                              \
        "--beside", NULL,                                                                          \
            "without records: the next frame's tree is refitted beside the one that is shown, if " \
            "the arena has room for its nodes"                                                     \
    }

/* Reads the flags into the scene's options; `plays`: the image's frames are shown. Refuses through
 * args_complain. */
void vertices_read(scene *s, args *a, int plays);

/* JSON members, each ending in ",\n". */
void vertices_print(output *o, const scene *s, fail *f);

#endif
