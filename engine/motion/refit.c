/* refit - see refit.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/refit.h"

#define REFIT_LISTS(job, link) plt_lists_box4((job)->records, link)
#include "engine/motion/refit_nodes.h"

void plt_refit_begin(plt_refit_job *job) {
    job->top = job->levels;
    job->link = job->root;
    job->areas.ratios = job->areas.sum = 0;
}

int plt_refit_step(plt_refit_job *job, uint32_t lists) {
    return PLT_WITH_REBUILD && job->areas.is_wanted ? step(job, lists, 1) : step(job, lists, 0);
}

void plt_refit(plt_refit_job *job) {
    plt_refit_begin(job);
    plt_refit_step(job, UINT32_MAX);
}
