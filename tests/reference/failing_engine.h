/* failing_engine - the engine's calls that trace, over format_failing.h
 *
 * rays.c, rendering.c and calls.c are compiled once more, with failing_ for plt_ in the
 * names of what they define, and with a traversal of the tests' format. The engine itself
 * stays beside them under its own names. For one source file per program.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_FAILING_ENGINE_H
#define REFERENCE_FAILING_ENGINE_H

#include "engine/engine.h"
#include "engine/trace/rays.h"
#include "tests/reference/format_failing.h"

/* The orders come after the format. */
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_hulls.h"
#include "engine/trace/order_two_stage.h"

/* ---- what a traverse_NAME.c and traverse.c give --------------------------------------- */

size_t plt_failing_entry_bytes(unsigned order);
size_t plt_failing_state_bytes(void);
void plt_failing_state_init(plt_traversal *t);
void plt_failing_begin(plt_traversal *t, plt_packet *p);
int plt_failing_traverse(plt_traversal *t, plt_packet *p, uint32_t visits);

#define FORMAT_NAME failing
#define FORMAT_ORDERS(ROW)                                                                         \
    ROW(DEPTH_FIRST, depth_first) FORMAT_ORDER_HULLS(ROW) ROW(TWO_STAGE, two_stage)
#include "engine/trace/traverse_format.h"

static void failing_traversal_begin(plt_traversal *t, plt_packet *p, uint32_t rays) {
#if PLT_WITH_HULLS
    if (plt_order_for(t, p) == PLT_ORDER_HULLS) {
        plt_hulls_set(p);
    } else {
        plt_packet_make_ready(p);
    }
#endif
    t->stats.packets++;
    t->stats.rays += rays;
    t->stats.mixed_packets += p->slabs.coherence == PLT_MIXED;
    plt_failing_begin(t, p);
}

static int failing_traverse(plt_traversal *t, plt_packet *p, uint32_t visits) {
    return plt_failing_traverse(t, p, visits);
}

/* ---- the same calls under other names --------------------------------------------------- */

#define FAILING_DECLARE(name) extern __typeof__(plt_##name) failing_##name
FAILING_DECLARE(trace_packet);
FAILING_DECLARE(batch_packets);
FAILING_DECLARE(rendering_begin_batches);
FAILING_DECLARE(rendering_ahead);
FAILING_DECLARE(rendering_init);
FAILING_DECLARE(rendering_begin);
FAILING_DECLARE(rendering_step);
FAILING_DECLARE(rendering_tile);
FAILING_DECLARE(engine_info);
FAILING_DECLARE(trace);
FAILING_DECLARE(render_begin);
FAILING_DECLARE(render_step);
FAILING_DECLARE(render_tile);
FAILING_DECLARE(stats_get);
FAILING_DECLARE(fault_get);
FAILING_DECLARE(stats_reset);
FAILING_DECLARE(packet_side);
FAILING_DECLARE(arena_used);
FAILING_DECLARE(arena_peak);

/* The format of the tests has no beams, whatever the scene says that it is. */
#undef PLT_WITH_BEAMS
#define PLT_WITH_BEAMS 0
#define plt_traversal_begin failing_traversal_begin
#define plt_traverse failing_traverse
#define plt_batch_packets failing_batch_packets
#define plt_rendering_begin_batches failing_rendering_begin_batches
#define plt_rendering_ahead failing_rendering_ahead
#define plt_trace_packet failing_trace_packet
#define plt_rendering_init failing_rendering_init
#define plt_rendering_begin failing_rendering_begin
#define plt_rendering_step failing_rendering_step
#define plt_rendering_tile failing_rendering_tile
#define plt_engine_info failing_engine_info
#define plt_trace failing_trace
#define plt_render_begin failing_render_begin
#define plt_render_step failing_render_step
#define plt_render_tile failing_render_tile
#define plt_stats_get failing_stats_get
#define plt_fault_get failing_fault_get
#define plt_stats_reset failing_stats_reset
#define plt_packet_side failing_packet_side
#define plt_arena_used failing_arena_used
#define plt_arena_peak failing_arena_peak

#include "engine/calls.c"
#include "engine/shade/rendering.c"
#include "engine/trace/rays.c"

#undef plt_traversal_begin
#undef plt_traverse
#undef plt_batch_packets
#undef plt_rendering_begin_batches
#undef plt_rendering_ahead
#undef plt_trace_packet
#undef plt_rendering_init
#undef plt_rendering_begin
#undef plt_rendering_step
#undef plt_rendering_tile
#undef plt_engine_info
#undef plt_trace
#undef plt_render_begin
#undef plt_render_step
#undef plt_render_tile
#undef plt_stats_get
#undef plt_fault_get
#undef plt_stats_reset
#undef plt_packet_side
#undef plt_arena_used
#undef plt_arena_peak

#endif
