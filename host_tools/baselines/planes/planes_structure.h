/* planes_structure - a tree of one axis per node as a structure, whatever its layout
 *
 * Triangles that have moved keep their tree where a layout can be refitted; else they get a new
 * one.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PLANES_STRUCTURE_H
#define BASELINES_PLANES_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"
#include "host_tools/baselines/planes/planes_trace.h"

/* What a layout is: functions of its own tree, `nodes`, which begins all zero. */
typedef struct planes_layout {
    size_t bytes_of_it; /* of `nodes` */
    /* Of a binary tree of some nodes; `form`: which one of several. -1: no memory, and none is
     * there. */
    int (*make)(void *nodes, binary_tree *t, unsigned form);
    int (*refit)(void *nodes, const plt_record *records); /* NULL: it is made anew; -1: likewise,
                                                           * and it is as it was */
    void (*drop)(void *nodes);
    uint64_t (*bytes)(const void *nodes);
    void (*lone)(planes_tracing *t, lone_ray *r);
    void (*packet)(planes_tracing *t);
    binary_options build; /* where no switch says otherwise */
} planes_layout;

/* Groups of choices beside those of all kinds. */
enum {
    PLANES_FORM = STRUCTURE_OWN, /* 0, or the `form` */
    PLANES_WAY                   /* enum planes_ways */
};

enum planes_ways { PLANES_BY_REST = 1, PLANES_BY_ROOM };

#define PLANES_WAY_SWITCHES                                                                        \
    {"intervals", "packets keep what is left of each ray", PLANES_WAY, PLANES_BY_REST}, {          \
        "boxes", "packets keep what is left of the scene's box", PLANES_WAY, PLANES_BY_ROOM        \
    }

/* The functions of a kind whose open hands over its layout. */
void *planes_open(const planes_layout *layout, const mesh *m, const structure_options *o,
                  const char *name, fail *f);
int planes_move(void *self, const mesh *m, fail *f);
int planes_trace(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any, fail *f);
void planes_count(const void *self, structure_statistics *to);
void planes_forget(void *self);
void planes_close(void *self);
int planes_suits(const structure_options *o, fail *f);

#endif
