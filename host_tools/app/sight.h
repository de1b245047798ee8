/* sight - what is seen of a scene, asked of an engine by rays
 *
 * The box of a scene is larger than what is in it, mostly much. Some ten thousand rays from a
 * camera that sees all of the box say what a camera must see that comes as near as it may. As a
 * hit depends on nothing but ray, triangle and box, all residencies, trees and machines find the
 * same.
 *
 * SPDX-License-Identifier: MIT */
#ifndef SIGHT_H
#define SIGHT_H

#include "board/host/host.h"
#include "engine/planelet.h"
#include "host_tools/app/fitting.h"

typedef struct sight {
    plt_engine *engine; /* that is asked; NULL: the box is all that is known */
    void *arena;        /* of an engine of its own; NULL: it has none */
    host_scene file;    /* which that engine reads */
} sight;

#define SIGHT_CLOSED                                                                               \
    {                                                                                              \
        .file = {.file = -1 }                                                                      \
    }

/* `resident` is an engine with all of the scene in memory. Where there is none, an engine of its
 * own is opened, so that no store is warm before a picture begins: it streams if the image can be
 * streamed, with a store of a MiB. If that cannot be had, nothing is seen, and that is no error. An
 * image with frames is not looked at: what is to be seen later may be elsewhere. `s` stays where it
 * is until it is closed, before `file` is. */
void sight_open(sight *s, const host_scene *file, plt_engine *resident);
void sight_close(sight *s);

/* Adds what `camera` sees, by `side` x `side` rays over all its frame, to `f`: hits, each widened
 * by the distance to the next ray. Returns how many there were; -1: the engine cannot say. */
int sight_add(const sight *s, const plt_camera *camera, double aspect, unsigned side, fitting *f);

#endif
