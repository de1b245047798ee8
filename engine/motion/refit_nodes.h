/* refit_nodes - a refit of thesis nodes in steps, whatever their lists are
 *
 * Post-order, left first, as lists lie: a node is encoded when both of its children's boxes are
 * known, and its own goes up.
 *
 * Included once by each refit_NAME.c, with REFIT_LISTS(job, link), the box of one list or of two.
 *
 * SPDX-License-Identifier: MIT */
#ifdef REFIT_LISTS /* else there is nothing to make */

#include "engine/lanes/unroll.h"
#include "engine/motion/refit_job.h"
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

/* Down to the leftmost leaf below `link`, every node on the way a level. */
static uint32_t descend(const plt_refit_job *job, uint32_t link, plt_refit_level **top) {
    while (!plt_link_is_leaf(link)) {
        (*top)->node = plt_link_index(link);
        (*top)->is_done = 0;
        link = plt_node_link(&job->nodes[(*top)->node], 0);
        ++*top;
    }
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
        const plt_box4 left = kept(l), right = *box;
        *box = plt_node_fit(&job->nodes[l->node], left, right);
        if (counts_areas) {
            plt_areas_add(&job->areas, 1, *box, left, right);
        }
        --*top;
    }
    return PLT_LINK_NONE;
}

/* Inlined twice: sums of areas would cost those who do not want them a quarter of the whole. */
PLT_INLINED int step(plt_refit_job *job, uint32_t lists, int counts_areas) {
    plt_refit_level *top = job->top;
    uint32_t link = job->link;
    plt_box4 box;
    do {
        link = descend(job, link, &top);
        box = REFIT_LISTS(job, link);
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

#endif
