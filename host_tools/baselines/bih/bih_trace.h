/* bih_trace - rays through a bounding interval hierarchy
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BIH_TRACE_H
#define BASELINES_BIH_TRACE_H

#include "host_tools/baselines/planes/planes_trace.h"

/* `nodes` is a bih_tree. A lone ray, or the packet that has begun. */
void bih_trace_lone(planes_tracing *t, lone_ray *r);
void bih_trace_packet(planes_tracing *t);

#endif
