/* pose_tree - see pose_tree.h
 *
 * Depth is guaranteed as by engine/builder/build.c: a range is halved by count where only that can
 * end in the levels that are left.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/pose_tree.h"

#include "engine/builder/split.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/pose_split.h"

enum { LEVELS = PLT_DEPTH_MAX + 3 };

typedef struct waiting {
    uint32_t begin, end, depth, parent;
    int child;
} waiting;

/* Returns the new node, linked from its parent. */
static uint32_t add_node(list_tree *t, const waiting *w) {
    const uint32_t node = t->nodes++;
    t->node[node].parent = w->parent;
    if (w->parent != LIST_TREE_NONE) {
        t->node[w->parent].child[w->child] = node;
    }
    return node;
}

static uint32_t split(pose_split *s, const plt_build_job *job, const waiting *w) {
    const uint32_t count = w->end - w->begin;
    return plt_levels_needed(count, job->leaf_triangles) + w->depth < PLT_DEPTH_MAX
               ? pose_split_range(s, w->begin, w->end)
               : w->begin + count / 2;
}

/* Nodes, and of lists their records; `ordered` gets those. */
static int build(list_tree *t, pose_split *s, const plt_build_job *job, plt_record *ordered,
                 double end, progress *bar) {
    waiting stack[LEVELS] = {{0, job->count, 0, LIST_TREE_NONE, 0}};
    uint32_t depth = 1;
    t->nodes = 0;
    while (depth > 0) {
        const waiting w = stack[--depth];
        const uint32_t node = add_node(t, &w);
        if (w.end - w.begin > job->leaf_triangles) {
            if (end > 0.0 && clock_seconds() >= end) {
                return PLT_MORE;
            }
            const uint32_t middle = split(s, job, &w), below = w.depth + 1;
            t->node[node].child[1] = 0; /* no list; known when it is added */
            stack[depth++] = (waiting){middle, w.end, below, node, 1};
            stack[depth++] = (waiting){w.begin, middle, below, node, 0};
            continue;
        }
        for (uint32_t i = w.begin; i < w.end; i++) {
            ordered[i] = job->records[s->order[i]];
        }
        list_tree_fit_list(t, node, ordered, w.begin, w.end);
        progress_show(bar, w.end);
    }
    return PLT_OK;
}

static int build_and_fit(list_tree *t, pose_split *s, const plt_build_job *job, plt_record *ordered,
                         double end, progress *bar) {
    const int status = build(t, s, job, ordered, end, bar);
    for (uint32_t i = t->nodes; status == PLT_OK && i-- > 0;) { /* children behind parents */
        if (!list_tree_is_list(&t->node[i])) {
            list_tree_fit(t, i);
        }
    }
    return status;
}

int pose_tree_build(list_tree *t, const plt_build_job *job, plt_record *ordered, double end,
                    progress *bar) {
    pose_split *s = heap_get_aligned(sizeof *s);
    int status = PLT_ERR_ARENA;
    if (s != NULL && pose_split_begin(s, job, t->poses) == 0) {
        status = build_and_fit(t, s, job, ordered, end, bar);
    }
    if (s != NULL) {
        pose_split_free(s);
    }
    heap_drop(s);
    return status;
}
