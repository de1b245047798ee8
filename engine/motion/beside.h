/* beside - the next frame's tree, refitted beside the one that is on screen
 *
 * Vertices of a scene without records are there twice: those that are shown, and those that the
 * next frame comes into. Where nodes are, too, the next frame's are refitted in bounded steps while
 * rays meet the others, and then the two change places.
 *
 * Keeps: rays meet a whole frame, nodes and vertices of one.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOTION_BESIDE_H
#define PLT_MOTION_BESIDE_H

#include "engine/motion/refit.h"
#include "engine/motion/sequence.h"
#include "engine/tree/thesis/tree.h"

#if PLT_WITH_VERTICES

enum plt_beside_phase {
    PLT_BESIDE_IDLE,   /* nodes beside are of no frame */
    PLT_BESIDE_REFITS, /* they become those of the frame that has come */
    PLT_BESIDE_READY   /* they are */
};

typedef struct plt_beside {
    plt_node *nodes; /* as many as the scene has; NULL: there is no room */
    plt_vertex_lists coming;
    plt_refit_job refit;
    uint8_t phase; /* enum plt_beside_phase */
} plt_beside;

/* Room for nodes (NULL: none) beside those of `tree`, which they become. */
void plt_beside_set(plt_beside *b, plt_node *nodes, const plt_tree *tree, plt_refit_level *levels);

/* The frame that has come is shown already. */
static inline int plt_beside_is_shown(const plt_sequence *s) {
    return s->base != s->vertex;
}

/* Some `lists` leaf links more of the frame that has come: PLT_MORE, or PLT_OK: it can be shown at
 * once, or there is no room. */
int plt_beside_step(plt_beside *b, const plt_sequence *s, const plt_tree *tree,
                    const plt_vertex_lists *shown, uint32_t lists);

/* The frame that has come is the scene's from now on. Returns its box: of all triangles. */
plt_box plt_beside_show(plt_beside *b, plt_sequence *s, plt_tree *tree, plt_vertex_lists *shown);

#endif

#endif
