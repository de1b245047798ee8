/* measure_nodes - treelets of the thesis's nodes, and the engine's orders of traversal over them
 *
 * SPDX-License-Identifier: MIT */
#ifndef MEASURE_NODES_H
#define MEASURE_NODES_H

#include "host_tools/tables/figures.h"
#include "host_tools/tables/stage.h"

/* "median,leaf-1,treelet-64": as the packer makes them, without rays. */
int measure_packing(stage *s, const char *text, figures *to, fail *f);

/* "depth,64" or "two-stage,64": packets of 4x4 over such nodes, of spatial medians and one triangle
 * per leaf, in treelets of that size. The stage has its rays. */
int measure_order(stage *s, const char *text, figures *to, fail *f);

/* "64" or "64,near": packets of 4x4 through treelets of that size by Figure 4.2 (figure_42.h). */
int measure_figure_42(stage *s, const char *text, figures *to, fail *f);

/* "64": the same nodes in treelets of that size, breadth first, in slots by the thesis's rule. */
int measure_slots(stage *s, const char *text, figures *to, fail *f);

#endif
