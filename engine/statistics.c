/* figures - what a caller may ask of an engine
 *
 * SPDX-License-Identifier: MIT */
#include "engine/engine.h"

const plt_info *plt_engine_info(const plt_engine *e) {
    return &e->header.info;
}

void plt_stats_get(const plt_engine *e, plt_stats *stats) {
    *stats = e->walker.stats;
}

void plt_stats_reset(plt_engine *e) {
    memset(&e->walker.stats, 0, sizeof e->walker.stats);
    memset(e->walker.touched, 0, 4 * (size_t)e->touched_words);
}

size_t plt_arena_used(const plt_engine *e) {
    return e->arena.used;
}

size_t plt_arena_peak(const plt_engine *e) {
    return e->arena.peak;
}
