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

/* Where four lanes are one register all of a step is one function, of which there are two: sums of
 * areas would cost those who do not want them a quarter of the whole. Elsewhere calls are cheap
 * beside the rest, and code is not. */
#if PLT_LANES_REGISTERS
#define PLT_REFIT_PART PLT_INLINED
#else
#define PLT_REFIT_PART static
#endif

static inline void keep(plt_refit_level *l, plt_box4 box) {
    f4_store(l->lo, box.lo);
    f4_store(l->hi, box.hi);
    l->is_done = 1;
}

static inline plt_box4 kept(const plt_refit_level *l) {
    const plt_box4 box = {f4_load(l->lo), f4_load(l->hi)};
    return box;
}

/* Both children's boxes, `box` that of the right one, into node `n`: its own is in `box`. */
PLT_REFIT_PART void fit(plt_refit_job *job, uint32_t n, const plt_box4 *left, plt_box4 *box,
                        int counts_areas) {
    const plt_box4 right = *box;
    *box = plt_node_fit(&job->nodes[n], *left, right);
    if (counts_areas) {
        plt_areas_add(&job->areas, 1, *box, *left, right);
    }
}

/* The right child of node `n`, if it is a node, is asked for. */
static inline void ask_for_right(const plt_refit_job *job, uint32_t n) {
#if PLT_LANES_REGISTERS
    const uint32_t right = plt_node_link(&job->nodes[n], 1);
    plt_prefetch(&job->nodes[plt_link_is_leaf(right) ? n : plt_link_index(right)]);
#else
    (void)job;
    (void)n;
#endif
}

/* From a node to its left child. */
static inline uint32_t descend_one(const plt_refit_job *job, uint32_t link, plt_refit_level **top) {
    ask_for_right(job, plt_link_index(link));
    (*top)->node = plt_link_index(link);
    (*top)->is_done = 0;
    ++*top;
    return plt_node_link(&job->nodes[plt_link_index(link)], 0);
}

/* Down to the leftmost leaf below `link`, which is a node, every node on the way a level. */
static inline uint32_t descend(const plt_refit_job *job, uint32_t link, plt_refit_level **top) {
    do {
        link = descend_one(job, link, top);
    } while (!plt_link_is_leaf(link));
    return link;
}

/* Encodes all nodes that `box` was the last child of; then it is the left child of another one,
 * whose right link is the result, or the root's: PLT_LINK_NONE. */
PLT_REFIT_PART uint32_t ascend(plt_refit_job *job, plt_box4 *box, plt_refit_level **top,
                               int counts_areas) {
    while (*top != job->levels) {
        plt_refit_level *l = *top - 1;
        if (!l->is_done) {
            keep(l, *box);
            return plt_node_link(&job->nodes[l->node], 1);
        }
        const plt_box4 left = kept(l);
        fit(job, l->node, &left, box, counts_areas);
        --*top;
    }
    return PLT_LINK_NONE;
}

/* Both of its children are lists: `box` is that of the left one, and in the end its own. */
PLT_REFIT_PART void fit_lists(plt_refit_job *job, uint32_t n, uint32_t right, plt_box4 *box,
                              int counts_areas) {
    const plt_box4 left = *box;
    *box = REFIT_LISTS(job, right);
    fit(job, n, &left, box, counts_areas);
}

PLT_REFIT_PART int step(plt_refit_job *job, uint32_t lists, int counts_areas) {
    plt_refit_level *top = job->top;
    uint32_t link = job->link;
    plt_box4 box;
    do {
        const int is_left = !plt_link_is_leaf(link);
        if (is_left) {
            link = descend(job, link, &top);
        }
        box = REFIT_LISTS(job, link);
        if (is_left) { /* whose parent is there, and not done */
            plt_refit_level *l = top - 1;
            link = plt_node_link(&job->nodes[l->node], 1);
            if (!plt_link_is_leaf(link)) {
                keep(l, box);
                continue;
            }
            fit_lists(job, l->node, link, &box, counts_areas);
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

#endif
