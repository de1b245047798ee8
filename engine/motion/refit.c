/* refit - see refit.h
 *
 * Post-order, left first, as lists lie: a node is encoded when both of its children's boxes are
 * known, and its own goes up.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/refit.h"

#include "engine/lanes/unroll.h"
#include "engine/motion/node_box.h"
#include "engine/planelet.h"

static inline void keep(plt_refit_level *l, plt_box4 box) {
    f4_store(l->lo, box.lo);
    f4_store(l->hi, box.hi);
    l->is_done = 1;
}

static inline plt_box4 kept(const plt_refit_level *l) {
    const plt_box4 box = {f4_load(l->lo), f4_load(l->hi)};
    return box;
}

/* Both children's boxes into node `n`, whose own is the result. */
PLT_INLINED plt_box4 fit(plt_refit_job *job, uint32_t n, plt_box4 left, plt_box4 right,
                         int counts_areas) {
    const plt_box4 box = plt_node_fit(&job->nodes[n], left, right);
    if (counts_areas) {
        plt_areas_add(&job->areas, 1, box, left, right);
    }
    return box;
}

/* Down to the leftmost leaf below `link`, which is a node, every node on the way a level. */
static inline uint32_t descend(const plt_refit_job *job, uint32_t link, plt_refit_level **top) {
    do {
        (*top)->node = plt_link_index(link);
        (*top)->is_done = 0;
        link = plt_node_link(&job->nodes[(*top)->node], 0);
        ++*top;
    } while (!plt_link_is_leaf(link));
    return link;
}

/* Encodes all nodes that `box` was the last child of; then it is the left child of another one,
 * whose right link is the result, or the root's: PLT_LINK_NONE. */
PLT_INLINED uint32_t ascend(plt_refit_job *job, plt_box4 *box, plt_refit_level **top,
                            int counts_areas) {
    while (*top != job->levels) {
        plt_refit_level *l = *top - 1;
        if (!l->is_done) {
            keep(l, *box);
            return plt_node_link(&job->nodes[l->node], 1);
        }
        *box = fit(job, l->node, kept(l), *box, counts_areas);
        --*top;
    }
    return PLT_LINK_NONE;
}

void plt_refit_begin(plt_refit_job *job) {
    job->top = job->levels;
    job->link = job->root;
    job->areas.ratios = job->areas.sum = 0;
}

/* The box of one more list: of a right child, whose node is done then, too. */
PLT_INLINED plt_box4 right_leaf(plt_refit_job *job, uint32_t link, plt_refit_level **top,
                                int counts_areas) {
    const plt_box4 box = plt_lists_box4(job->records, link);
    if (*top == job->levels) {
        return box; /* the tree is a list */
    }
    const plt_refit_level *l = --*top;
    return fit(job, l->node, kept(l), box, counts_areas);
}

/* Inlined twice: sums of areas would cost those who do not want them a quarter of the whole. */
PLT_INLINED int step(plt_refit_job *job, uint32_t lists, int counts_areas) {
    plt_refit_level *top = job->top;
    uint32_t link = job->link;
    plt_box4 box;
    do {
        if (plt_link_is_leaf(link)) {
            box = right_leaf(job, link, &top, counts_areas);
        } else {
            link = descend(job, link, &top);
            box = plt_lists_box4(job->records, link);
            plt_refit_level *l = top - 1;
            const uint32_t right = plt_node_link(&job->nodes[l->node], 1);
            if (!plt_link_is_leaf(right)) {
                keep(l, box);
                link = right;
                continue;
            }
            box = fit(job, l->node, box, plt_lists_box4(job->records, right), counts_areas);
            lists -= lists > 1;
            top--;
        }
        link = ascend(job, &box, &top, counts_areas);
    } while (link != PLT_LINK_NONE && --lists > 0);
    job->top = top;
    job->link = link;
    if (link != PLT_LINK_NONE) {
        return PLT_MORE;
    }
    plt_box4_store(box, &job->box);
    return PLT_OK;
}

int plt_refit_step(plt_refit_job *job, uint32_t lists) {
    return PLT_WITH_REBUILD && job->areas.is_wanted ? step(job, lists, 1) : step(job, lists, 0);
}

void plt_refit(plt_refit_job *job) {
    plt_refit_begin(job);
    plt_refit_step(job, UINT32_MAX);
}
