/* fault - how the engine says what is wrong
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_FAULT_H
#define PLT_BASE_FAULT_H

#include "engine/planelet.h"

static inline int plt_fault_set(plt_fault *fault, int status, uint32_t offset,
                                const char *message) {
    const plt_fault f = {0, offset, 0, 0, message};
    *fault = f;
    return status;
}

/* An image that opening refuses: rule R`rule` of SPEC.md. */
static inline int plt_refused(plt_fault *fault, uint8_t rule, uint32_t offset,
                              const char *message) {
    plt_fault_set(fault, PLT_ERR_IMAGE, offset, message);
    fault->kind = 'R';
    fault->rule = rule;
    return PLT_ERR_IMAGE;
}

/* Content that breaks invariant I`rule` of SPEC.md. */
static inline int plt_broken(plt_fault *fault, uint8_t rule, uint32_t offset, const char *message) {
    plt_fault_set(fault, PLT_ERR_IMAGE, offset, message);
    fault->kind = 'I';
    fault->rule = rule;
    return PLT_ERR_IMAGE;
}

static inline int plt_limit(plt_fault *fault, const char *message) {
    return plt_fault_set(fault, PLT_ERR_LIMIT, 0, message);
}

static inline int plt_arena_short(plt_fault *fault, size_t need_bytes) {
    plt_fault_set(fault, PLT_ERR_ARENA, 0, "the arena is too small for this scene");
    fault->need_bytes = need_bytes;
    return PLT_ERR_ARENA;
}

#endif
