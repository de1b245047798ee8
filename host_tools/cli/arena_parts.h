/* arena_parts - what an arena must hold for an image, part by part
 *
 * Parts of 0 bytes are left out. The need is the sum of what stays and the greatest
 * of the sums of the other lifetimes (planelet.h).
 *
 * SPDX-License-Identifier: MIT */
#ifndef ARENA_PARTS_H
#define ARENA_PARTS_H
#include "engine/planelet.h"

/* A line per part. */
void arena_parts_print(const plt_info *info, int mapped, const plt_options *options);

/* An array of {"name", "bytes", "lifetime"}, as the value of a member of an object. */
void arena_parts_print_json(const plt_info *info, int mapped, const plt_options *options);

#endif
