/* budget - how many bytes each part of an arena takes
 *
 * Every cut of the arena has its size here, once: plt_arena_need adds up what
 * opening cuts.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUDGET_H
#define PLT_BUDGET_H

#include "engine/engine.h"

int plt_options_valid(const plt_options *options);
int plt_budget_walk_valid(const plt_info *info, const plt_options *options);
size_t plt_budget_groups(const plt_options *options);
uint32_t plt_budget_touched_words(const plt_info *info);
uint32_t plt_budget_main_stack(const plt_info *info, const plt_options *options);
uint32_t plt_budget_local_stack(const plt_info *info, const plt_options *options);
size_t plt_budget_entry(const plt_info *info); /* of either stack */
size_t plt_budget_open_blocks(const plt_info *info);
size_t plt_budget_survey(const plt_info *info);

/* Counts and sizes of the worst tree that an image without one can give. */
plt_info plt_budget_worst_tree(const plt_info *info);

#endif
