/* validate_compact - the blocks of a scene against the rules and its counts
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCENE_VALIDATE_COMPACT_H
#define PLT_SCENE_VALIDATE_COMPACT_H

#include "engine/scene/opening.h"

/* Every block keeps the rules of SPEC.md; `counted`: what all of them hold. Offsets of
 * faults count from the first block. */
int plt_compact_validate(const plt_opening *o, plt_info *counted);

#endif
