/* grid_turn - the rays of a packet that run the same way along one axis, and their bounds
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_GRID_TURN_H
#define PLT_TRACE_GRID_TURN_H

#include "engine/trace/grid_state.h"

/* Sets the next turn up that has rays. 0: there is none. */
int plt_grid_next_turn(plt_grid_state *s, plt_packet *p);

/* Bounds of one ray instead of its group's. */
void plt_grid_one_lane(plt_grid_state *s, const plt_packet *p, unsigned group, unsigned lane);

/* How deep `lanes` of a group seek hits, at least. */
float plt_grid_until(const plt_grid_turn *turn, const plt_packet *p, unsigned group,
                     unsigned lanes);

#endif
