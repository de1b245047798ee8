/* scene - an opened image, as render and trace need it
 *
 * SPDX-License-Identifier: MIT */
#ifndef SCENE_H
#define SCENE_H

#include "board/host/host.h"
#include "engine/planelet.h"
#include "host_tools/base/fail.h"
#include "host_tools/cli/args.h"

typedef struct scene {
    host_scene file;
    plt_engine *engine;
    size_t arena_bytes;
} scene;

/* The flags that say how to open: put them into a command's list. */
#define SCENE_FLAGS                                                                                \
    {"--packet", "2|4|8|16", "rays along a packet's side (default 8)"},                            \
        {"--walk", "depth|two-stage", "depth first, or the thesis's two stages (default depth)"},  \
        {"--residency", "resident",                                                                \
         "where the scene is while it is traced: all of it in memory"},                            \
        {"--schedule", "branch", "how packets meet treelets: each walks its branches alone"},      \
        {"--workers", "1", "threads that trace"},                                                  \
        {"--source", "map|read",                                                                   \
         "the image is mapped like flash, or fetched into the arena (default map)"},               \
    {                                                                                              \
        "--arena", "BYTES", "hand the engine so much memory (default 1 GiB)"                       \
    }

/* Opens `path` as the flags say; a wrong flag sets a->wrong. */
int scene_open(scene *s, args *a, const char *path, fail *f);
void scene_close(scene *s);

/* The members that `trace` and `render` statistics share, without braces. */
void scene_print_stats(void *output, const scene *s, double seconds, fail *f);

#endif
