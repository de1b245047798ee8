/* grid_rig - a mesh opened twice, as a tree and as a grid in an arena of a chosen size
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_GRID_RIG_H
#define REFERENCE_GRID_RIG_H

#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

enum { GRID_GUARD = 64 };

typedef struct grid_rig {
    rig tree;
    unsigned char *arena;
    size_t bytes;
    plt_engine *engine;
    plt_fault fault;
} grid_rig;

/* `spare`: bytes beyond the grid's need. 0: it is not there, and that is a failure unless the
 * packer refused. */
static inline int grid_rig_open(grid_rig *g, const mesh *m, const rig_config *config,
                                size_t spare) {
    plt_options o = config->run;
    memset(g, 0, sizeof *g);
    if (rig_open(&g->tree, m, config) != PLT_OK) {
        CHECK(rig_is_tiny(), "%s: %s", rig_name(config), g->tree.fault.message);
        rig_close(&g->tree);
        return 0;
    }
    o.structure = PLT_STRUCTURE_GRID;
    const plt_source source = rig_source(&g->tree.image);
    g->bytes = plt_arena_need(&g->tree.image.info, 1, &o) + spare / PLT_ALIGN * PLT_ALIGN;
    g->arena = aligned_alloc(PLT_ALIGN, g->bytes + GRID_GUARD);
    memset(g->arena, 0x5A, g->bytes + GRID_GUARD);
    for (size_t i = 0; i < g->bytes / 4; i++) { /* what lay there looks like marks of bundles */
        ((uint32_t *)(void *)g->arena)[i] = 1 + (uint32_t)i % 7;
    }
    const int status = plt_open(&g->engine, g->arena, g->bytes, &source, &o, &g->fault);
    CHECK(status == PLT_OK, "%s: %s", rig_name(config), g->fault.message);
    return status == PLT_OK;
}

static inline void grid_rig_close(grid_rig *g) {
    for (unsigned i = 0; g->arena != NULL && i < GRID_GUARD; i++) {
        CHECK(g->arena[g->bytes + i] == 0x5A, "written behind the arena");
    }
    free(g->arena);
    rig_close(&g->tree);
}

static inline const plt_grid *grid_of(const grid_rig *g) {
    return g->engine->scene.gridded.grid;
}

#endif
