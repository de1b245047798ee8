/* refit - see refit.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/refit.h"

#include "engine/lanes/lanes.h"

#if PLT_LANES_REGISTERS
/* Records that are asked for so many ahead: they come in a row, but a processor that looks ahead by
 * itself ends with each page, and is late. What lies behind the last one is not read. */
enum { AHEAD = 48 };

static inline plt_box4 lists_box(const plt_refit_job *job, uint32_t link) {
    const uintptr_t records = (uintptr_t)job->records;
    plt_prefetch((const void *)(records + (plt_link_index(link) + AHEAD) * sizeof(plt_record)));
    return plt_lists_box4(job->records, link);
}

#define REFIT_LISTS(job, link) lists_box(job, link)
#else
#define REFIT_LISTS(job, link) plt_lists_box4((job)->records, link)
#endif
#include "engine/motion/refit_nodes.h"

void plt_refit_begin(plt_refit_job *job) {
    job->top = job->levels;
    job->link = job->root;
    job->areas.ratios = job->areas.sum = 0;
}

int plt_refit_step(plt_refit_job *job, uint32_t lists) {
#if PLT_LANES_REGISTERS
    return PLT_WITH_REBUILD && job->areas.is_wanted ? step(job, lists, 1) : step(job, lists, 0);
#else
    return step(job, lists, PLT_WITH_REBUILD && job->areas.is_wanted);
#endif
}

#if PLT_WITH_SUBTREES
void plt_refit_to(plt_refit_job *job, uint32_t stop) {
    plt_refit_level *top = job->top;
    uint32_t link = job->link;
    while (link != PLT_LINK_NONE && (plt_link_is_leaf(link) || plt_link_index(link) != stop)) {
        if (plt_link_is_leaf(link)) {
            plt_box4 box = plt_lists_box4(job->records, link);
            link = ascend(job, &box, &top, 1);
        } else {
            link = descend_one(job, link, &top);
        }
    }
    job->top = top;
    job->link = link;
}

void plt_refit_put(plt_refit_job *job, const plt_box *box) {
    plt_box4 b = plt_box4_load(box);
    job->link = ascend(job, &b, &job->top, 1);
    if (job->link == PLT_LINK_NONE) {
        plt_box4_store(b, &job->box);
    }
}
#endif

void plt_refit(plt_refit_job *job) {
    plt_refit_begin(job);
    plt_refit_step(job, UINT32_MAX);
}
