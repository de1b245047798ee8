/* bkd_trace - rays through a B-KD tree
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BKD_TRACE_H
#define BASELINES_BKD_TRACE_H

#include "host_tools/baselines/planes/planes_trace.h"

/* `nodes` is a bkd_tree. A lone ray, or the packet that has begun. */
void bkd_trace_lone(planes_tracing *t, lone_ray *r);
void bkd_trace_packet(planes_tracing *t);

#endif
