/* collapse_compact - the wide form of compact blocks
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/blocks_resident.h"
#include "engine/trace/format_compact.h"

#include "engine/trace/collapse.h"

void plt_compact_collapse(plt_traversal *t, plt_wide_build *build) {
    collapse(t, build);
}
