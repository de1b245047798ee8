/* unless_flushed - what is left out by lanes that may flush subnormals
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_UNLESS_FLUSHED_H
#define PLT_TRACE_UNLESS_FLUSHED_H

#include "engine/lanes/lanes.h"
#include "engine/trace/mask.h"

/* 1: a subnormal was flushed before `results` were there. The next question begins anew. */
static inline int plt_was_flushed(const void *results) {
    const int was = plt_flushed(results);
    if (was) {
        plt_flushed_clear();
    }
    return was;
}

/* The groups `*met`, or all that were asked about if a subnormal was flushed meanwhile. */
static inline plt_mask plt_unless_flushed(plt_mask *met, plt_mask groups) {
    return plt_was_flushed(met) ? groups : *met;
}

#endif
