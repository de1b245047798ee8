/* quality - see quality.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/quality.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/base/clock.h"
#include "host_tools/base/heap.h"
#include "host_tools/base/progress.h"
#include "host_tools/pack/list_tree.h"
#include "host_tools/pack/pose_tree.h"
#include "host_tools/pack/reinsert.h"

#define GAIN_LEAST 0.001 /* of the cost, by a pass: or it is the last one */
#define PASSES_MOST 20u
#define CLOCK_STEP 1024u /* nodes between two looks at the clock */

/* A node and its area when the pass begins. */
typedef struct turn {
    double area;
    uint32_t node;
} turn;

typedef struct improving {
    list_tree tree;
    turn *turns;
    double began, seconds;
    quality_stats *stats;
    progress bar;
} improving;

/* The largest first, of equals the one with the lower number. */
static int by_area(const void *left, const void *right) {
    const turn *a = left, *b = right;
    if (a->area != b->area) {
        return a->area < b->area ? 1 : -1;
    }
    return a->node < b->node ? -1 : 1;
}

static void sort_turns(improving *w) {
    for (uint32_t i = 0; i < w->tree.nodes; i++) {
        w->turns[i] = (turn){w->tree.node[i].area, i};
    }
    qsort(w->turns, w->tree.nodes, sizeof *w->turns, by_area);
}

static int is_late(const improving *w) {
    return w->seconds > 0.0 && clock_seconds() - w->began >= w->seconds;
}

static void pass(improving *w) {
    sort_turns(w);
    for (uint32_t i = 0; i < w->tree.nodes && !w->stats->out_of_time; i++) {
        w->stats->moves += (uint32_t)reinsert(&w->tree, w->turns[i].node);
        if (i % CLOCK_STEP == CLOCK_STEP - 1) {
            w->stats->out_of_time = is_late(w);
            progress_show(&w->bar, (uint64_t)w->stats->passes * w->tree.nodes + i);
        }
    }
    w->stats->passes++;
    w->stats->after = list_tree_cost(&w->tree);
}

static void improve(improving *w) {
    double last;
    w->stats->after = list_tree_cost(&w->tree);
    progress_begin(&w->bar, "improving the tree, nodes looked at", 0);
    do {
        last = w->stats->after;
        pass(w);
    } while (last - w->stats->after > GAIN_LEAST * last && w->stats->passes < PASSES_MOST &&
             !w->stats->out_of_time);
    progress_end(&w->bar);
}

static int write_back(const improving *w, plt_build_job *job) {
    const size_t bytes = job->count * sizeof *job->records;
    plt_record *ordered = heap_get(bytes);
    if (ordered == NULL) {
        return PLT_ERR_ARENA;
    }
    const int status = list_tree_write(&w->tree, job, ordered);
    memcpy(job->records, ordered, bytes);
    heap_drop(ordered);
    return status;
}

uint64_t quality_bytes(uint64_t triangles) {
    return triangles * (2 * (sizeof(list_tree_node) + sizeof(turn)) + sizeof(plt_record)) +
           3 * heap_cost(0);
}

/* A tree for all poses takes the place of the job's, if it costs less. */
static int begin_anew(improving *w, plt_build_job *job) {
    const size_t bytes = job->count * sizeof *job->records;
    plt_record *ordered = heap_get(bytes);
    int status = PLT_ERR_ARENA;
    if (ordered != NULL) {
        const double end = w->seconds > 0.0 ? w->began + w->seconds : 0.0;
        progress_begin(&w->bar, "building a tree for all frames, triangles", job->count);
        status = pose_tree_build(&w->tree, job, ordered, end, &w->bar);
        progress_end(&w->bar);
    }
    w->stats->out_of_time = status == PLT_MORE;
    if (status == PLT_OK && list_tree_cost(&w->tree) < w->stats->before) {
        memcpy(job->records, ordered, bytes);
    } else if (status != PLT_ERR_ARENA) {
        list_tree_read(&w->tree, job);
        status = PLT_OK;
    }
    heap_drop(ordered);
    return status;
}

static int read_and_improve(improving *w, plt_build_job *job) {
    int status = PLT_OK;
    list_tree_read(&w->tree, job);
    w->stats->before = list_tree_cost(&w->tree);
    if (w->tree.poses != NULL) {
        status = begin_anew(w, job);
    }
    if (status == PLT_OK) {
        improve(w);
        status = w->stats->after < w->stats->before ? write_back(w, job) : PLT_OK;
    }
    return status;
}

int quality_improve(plt_build_job *job, uint32_t seconds, const poses *p, quality_stats *stats) {
    const uint64_t nodes = p != NULL ? 2 * (uint64_t)job->count : list_tree_nodes(job);
    improving w = {.began = clock_seconds(), .seconds = seconds, .stats = stats};
    int status = PLT_ERR_ARENA;
    *stats = (quality_stats){.frames = p != NULL ? p->count + 1 : 1};
    if (job->nodes_used == 0) {
        return PLT_OK;
    }
    w.tree.poses = p;
    w.tree.node = heap_get(nodes * sizeof *w.tree.node);
    w.tree.posed = p != NULL ? heap_get(nodes * p->count * sizeof *w.tree.posed) : NULL;
    w.turns = heap_get(nodes * sizeof *w.turns);
    if (w.tree.node != NULL && w.turns != NULL && (p == NULL || w.tree.posed != NULL)) {
        status = read_and_improve(&w, job);
    }
    stats->seconds = clock_seconds() - w.began;
    heap_drop(w.tree.node);
    heap_drop(w.tree.posed);
    heap_drop(w.turns);
    return status;
}
