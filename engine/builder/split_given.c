/* split_given - splits of a tree that is known already, for a host that has made a better one
 *
 * Triangles are in the order of its leaves, and levels[i] is the depth of the node that
 * parts triangle i from the one before: of a range that is a subtree, the least of its levels,
 * but for the first, is where its root parts it.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks_state.h"

#if PLT_BLOCKS_LEVELS
uint32_t plt_split_given(const plt_blocks_state *s, uint32_t begin, uint32_t end,
                         plt_lattice_box child[2]) {
    const uint16_t *levels = s->job->levels;
    uint32_t middle = begin + 1;
    for (uint32_t i = begin + 2; i < end; i++) {
        middle = levels[i] < levels[middle] ? i : middle;
    }
    child[0] = child[1] = plt_lattice_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const plt_lattice_box b = plt_lattice_triangle_box(&s->job->triangles, plt_permuted(s, i));
        plt_lattice_box_add(&child[i >= middle], &b);
    }
    return middle;
}
#endif
