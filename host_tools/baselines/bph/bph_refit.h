/* bph_refit - boxes of triangles that have moved, as the thesis updates them
 *
 * From the leaves upwards. All lists are looked at; a node whose children's boxes are what they
 * were, as they are reconstructed from its own, is left as it is. Else it is encoded anew, as
 * another child may own a plane now.
 *
 * Source: Karrenberg 2007, section 3.6.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BPH_REFIT_H
#define BASELINES_BPH_REFIT_H

#include "host_tools/baselines/bph/bph_tree.h"

/* Of the tree's records, which have their new corners. Returns how many nodes were left as they
 * were; BPH_REFIT_NO_MEMORY: and the tree is as it was, boxes of old. */
#define BPH_REFIT_NO_MEMORY 0xFFFFFFFFu
uint32_t bph_refit(bph_tree *t);

#endif
