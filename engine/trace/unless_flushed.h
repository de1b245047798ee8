/* unless_flushed - what is left out by lanes that may flush subnormals
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_UNLESS_FLUSHED_H
#define PLT_TRACE_UNLESS_FLUSHED_H

#include "engine/lanes/lanes.h"
#include "engine/trace/mask.h"

/* The groups `*met`, or all that were asked about if a subnormal was flushed meanwhile. */
static inline plt_mask plt_unless_flushed(plt_mask *met, plt_mask groups) {
    if (plt_flushed(met)) {
        plt_flushed_clear();
        return groups;
    }
    return *met;
}

#endif
