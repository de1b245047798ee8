/* planes_view - a node of one axis, whatever its layout
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PLANES_VIEW_H
#define BASELINES_PLANES_VIEW_H

#include <stdint.h>

/* Child 0 is the one with the lower centre when the tree is built. Of a BIH, which has only hi[0]
 * and lo[1], the others are beyond all coordinates. */
typedef struct planes_view {
    uint32_t axis, link[2];
    float lo[2], hi[2];
} planes_view;

#endif
