/* kind - what every structure has: the functions behind structure.h
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KIND_H
#define BASELINES_KIND_H

#include "engine/planelet.h"
#include "host_tools/base/fail.h"
#include "host_tools/baselines/base/structure_types.h"
#include "host_tools/mesh/mesh.h"

/* `self` is what open returned. Rays and bytes are asked of statistics in one call. */
typedef struct structure_kind {
    const char *name;
    const char *about; /* a phrase */
    unsigned variant;  /* handed to open */
    void *(*open)(unsigned variant, const mesh *m, const structure_options *o, const char *name,
                  fail *f);
    int (*move)(void *self, const mesh *m, fail *f);
    int (*trace)(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any, fail *f);
    void (*count)(const void *self, structure_statistics *to);
    void (*forget)(void *self);
    void (*close)(void *self);
    const structure_switch *switches; /* NULL: there are none; one without a name ends them */
    uint8_t one_by_one; /* 1: tools trace rays one by one, unless a switch asks for packets */
    /* Whether switches go together, each being one of its group; NULL: all do. -1: it says which do
     * not, and those that would. */
    int (*suits)(const structure_options *o, fail *f);
} structure_kind;

#endif
