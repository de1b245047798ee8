/* rebuilds - when the tree of a scene in motion is built anew, by the flags
 *
 * SPDX-License-Identifier: MIT */
#ifndef REBUILDS_H
#define REBUILDS_H

#include "host_tools/app/args.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/output.h"

#define REBUILDS_FLAGS                                                                             \
    {"--rebuild", "never|always|threshold:PERCENT|cost",                                           \
     "of frames: build the tree anew in the arena, beside the old one, before every frame; "       \
     "when the ratios of nodes' areas have grown by so many percent, 1 to 1000; or when the work " \
     "that a new tree would have saved has reached its cost (default never)"},                     \
        {"--rebuild-step", "TRIANGLES",                                                            \
         "looked at for that per frame, 1 to 4000000000, a tree taking some log2(n) times "        \
         "all n (default a whole tree)"},                                                          \
    {                                                                                              \
        "--rebuild-most", "TRIANGLES",                                                             \
            "of a subtree, 16 to 4000000000: subtrees are rebuilt one by one, each in its own "    \
            "slots and in an arena without room for a second tree (default the whole tree)"        \
    }

typedef struct rebuilds {
    unsigned when, percent; /* enum plt_rebuild_when */
    uint32_t step;          /* triangles per frame; 0xFFFFFFFF: a whole tree */
    unsigned given_up;      /* trees that the arena has no room for */
    double seconds;         /* of all so far */
    float most;             /* degradation of any frame */
} rebuilds;

/* Reads the flags, and sets what the scene's options need; `moves`: with --moved. Refuses through
 * args_complain. */
void rebuilds_read(rebuilds *r, scene *s, args *a, int moves);

/* A frame has moved: what is due of a rebuild, in all of the scene's engines. */
void rebuilds_go_on(rebuilds *r, const scene *s);

/* JSON members, each ending in ",\n". `repeat`: runs that times are over. */
void rebuilds_print(output *o, const rebuilds *r, const scene *s, unsigned repeat, fail *f);

#endif
