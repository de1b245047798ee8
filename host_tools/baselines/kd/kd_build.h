/* kd_build - kd-trees: exactly or approximately by the surface area heuristic, whole or on demand
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_BUILD_H
#define BASELINES_KD_BUILD_H

#include "host_tools/baselines/kd/kd_tree.h"

typedef struct kd_way {
    uint8_t is_exact;   /* 1: by all places (kd_sweep.h); 0: by samples (kd_sample.h) */
    uint8_t is_clipped; /* 1: cells refer to what reaches into them; 0: to whose box does */
    uint8_t is_lazy;    /* 1: nodes are split when a ray comes to them; not of exact ones */
} kd_way;

/* All of it, or the root alone. -1: no memory; the tree can only be freed then, or begun anew. */
int kd_build(kd_tree *t, const kd_scene *s, const kd_way *way);

/* Makes an inner node or a leaf of one that is not split: by samples. */
int kd_build_node(kd_tree *t, const kd_scene *s, uint32_t node);

#endif
