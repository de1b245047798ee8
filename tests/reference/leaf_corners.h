/* leaf_corners - a leaf's triangles, each with its own three lattice corners
 *
 * SPDX-License-Identifier: MIT */
#ifndef TESTS_REFERENCE_LEAF_CORNERS_H
#define TESTS_REFERENCE_LEAF_CORNERS_H

#include <string.h>

#include "engine/tree/compact/leaf.h"

static inline void leaf_corners(const plt_geometry *g, uint32_t first, uint32_t count,
                                uint32_t corner[][3][3]) {
    plt_leaf u;
    plt_leaf_read(g, first, count, &u);
    for (uint32_t i = 0; i < count; i++) {
        for (unsigned c = 0; c < 3; c++) {
            memcpy(corner[i][c], u.vertex[plt_leaf_corner(&u, i, c)].number, sizeof corner[i][c]);
        }
    }
}

#endif
