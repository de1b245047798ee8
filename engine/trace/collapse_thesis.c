/* collapse_thesis - the wide form of thesis nodes and float records
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/format_thesis.h"

#include "engine/trace/collapse.h"

void plt_thesis_collapse(plt_traversal *t, plt_wide_build *build) {
    collapse(t, build);
}
