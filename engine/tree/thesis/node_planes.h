/* node_planes - do the planes of a node lie in the scene's box?
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_THESIS_NODE_PLANES_H
#define PLT_TREE_THESIS_NODE_PLANES_H

#include <stddef.h>

#include "engine/base/between.h"
#include "engine/lanes/unroll.h"
#include "engine/tree/thesis/node.h"

/* Of the planes of a node the first that is neither in the box nor 0, or NULL. */
static inline const uint32_t *plt_node_outside(const plt_between box[3], const plt_node *node) {
    PLT_UNROLLED for (uint32_t k = 0; k < 6; k += 3) {
        PLT_UNROLLED for (uint32_t a = 0; a < 3; a++) {
            const uint32_t *plane = &node->word[k + a];
            if (!plt_is_between(&box[a], plane) && plt_get_float(plane) != 0.0f) {
                return plane;
            }
        }
    }
    return NULL;
}

#endif
