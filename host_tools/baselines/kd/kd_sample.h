/* kd_sample - a good cut by the surface area heuristic, from few samples of it
 *
 * Triangles left and right of a plane are counted at eight even places, and then at eight more,
 * where the counts change most. Between places counts are taken to be linear, so that the cost is a
 * quadratic function, whose least value is known. Two passes over the triangles, no sorting.
 *
 * Source: Hunt, Mark, Stoll, "Fast kd-tree construction with an adaptive error-bounded heuristic",
 * 2006.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_SAMPLE_H
#define BASELINES_KD_SAMPLE_H

#include "host_tools/baselines/kd/kd_cost.h"

kd_cut kd_sample(const kd_cell *c);

#endif
