/* validate_compact - see validate_compact.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/validate_compact.h"

#include "engine/tree/compact/validate.h"

int plt_compact_validate(const plt_opening *o, plt_info *counted) {
    const size_t mark = o->arena->used;
    *counted = o->scene->info;
    plt_blocks_validate_level *levels = plt_opening_cut(o, PLT_PART_VALIDATION);
    if (levels == NULL) {
        return plt_opening_arena_error(o);
    }
    const int status = plt_blocks_validate(&o->scene->compact, levels, counted, o->fault);
    plt_arena_release(o->arena, mark);
    return status;
}
