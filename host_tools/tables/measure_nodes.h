/* measure_nodes - the thesis's nodes as the packer makes them, and in treelets
 *
 * SPDX-License-Identifier: MIT */
#ifndef MEASURE_NODES_H
#define MEASURE_NODES_H

#include "host_tools/tables/figures.h"
#include "host_tools/tables/stage.h"

/* "median,leaf-1,treelet-64": as the packer makes them, without rays. */
int measure_packing(stage *s, const char *text, figures *to, fail *f);

/* "64": nodes of spatial medians with one triangle per leaf in treelets of that size, breadth
 * first, in slots by the thesis's rule. */
int measure_slots(stage *s, const char *text, figures *to, fail *f);

#endif
