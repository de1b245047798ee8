/* rebuild - the public calls by which a tree is built anew while triangles move
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "engine/base/fault.h"
#include "engine/engine.h"
#include "engine/move.h"

/* In group tests; a triangle test takes as long as two. */
static uint64_t work_done(const plt_engine *e) {
    const plt_stats *s = &e->traversal.stats;
    return s->group_tests + 2 * s->triangle_tests;
}

static void count_work(plt_engine *e) {
    const uint64_t work = work_done(e);
    plt_moving_count(&e->moving, work - e->moving.work);
    e->moving.work = work;
}

void plt_rebuild_before_reset(plt_engine *e) {
    count_work(e);
    e->moving.work = 0;
}

uint64_t plt_rebuild_excess(const plt_engine *e) {
    plt_moving now = e->moving;
    plt_moving_count(&now, work_done(e) - now.work);
    return now.excess;
}

uint64_t plt_rebuild_cost(const plt_info *info) {
    return (uint64_t)PLT_REBUILD_WORK * info->triangles;
}

/* The scene's box is what it was: nothing has moved. */
static void set_info(plt_engine *e) {
    plt_info *info = &e->scene.info, built = e->moving.rebuild.info;
    memcpy(built.lo, info->lo, sizeof built.lo);
    memcpy(built.hi, info->hi, sizeof built.hi);
    *info = built;
}

/* Which blocks were touched has no meaning in another tree. */
static void begin_touched(plt_traversal *t) {
    if (t->touched != NULL) {
        t->touched_words = plt_touched_words(PLT_FORMAT_THESIS, &t->scene->info);
        memset(t->touched, 0, 4 * (size_t)t->touched_words);
    }
}

static void swap(plt_engine *e) {
    plt_moving *m = &e->moving;
    count_work(e);
    plt_rebuild_swap(&m->rebuild, &e->scene.thesis);
    set_info(e);
    m->areas = m->areas_built = m->rebuild.refit.areas;
    m->box = m->rebuild.refit.box;
    m->excess = 0;
    m->tried = 0.0f;
    m->rebuilds++;
    begin_touched(&e->traversal);
    plt_traversal_drop(&e->traversal);
}

void plt_rebuild_before_move(plt_engine *e, int some) {
    plt_rebuild *r = &e->moving.rebuild;
    count_work(e);
    if (plt_rebuild_must_end(r)) {
        plt_rebuild_end(r, &e->scene.thesis, some);
        swap(e);
        e->moving.is_new = !some;
    }
}

int plt_rebuild_begin(plt_engine *e, plt_fault *fault) {
    plt_rebuild *r = &e->moving.rebuild;
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    if (r->records == NULL) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             "the scene was not opened for its tree to be rebuilt");
    }
    if (r->phase == PLT_REBUILD_IDLE && e->scene.info.triangles > 0) {
        plt_rebuild_start(r, &e->scene.info);
    }
    return PLT_OK;
}

/* It has cost about what a tree costs: it is not due again before as much has been lost anew. */
static void give_up(plt_engine *e) {
    const float now = plt_degradation(&e->moving);
    count_work(e);
    e->moving.excess = 0;
    e->moving.tried = now > 0.0f ? now : 0.0f;
}

static int failed(const plt_engine *e, int status, plt_fault *fault) {
    if (status == PLT_ERR_ARENA) {
        plt_fault_set(fault, status, 0,
                      "the arena has no room for the new tree, the old one stays");
        fault->need_bytes = plt_arena_need(&e->scene.info, e->source.mapped != NULL, &e->options);
        return status;
    }
    return plt_fault_set(fault, status, 0,
                         "the new tree needs more levels or stack entries than this build allows, "
                         "the old one stays");
}

int plt_rebuild_step(plt_engine *e, uint32_t triangles, plt_fault *fault) {
    plt_rebuild *r = &e->moving.rebuild;
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    if (r->phase == PLT_REBUILD_IDLE) {
        return PLT_OK;
    }
    const int status = plt_rebuild_work(r, &e->scene.thesis, triangles > 0 ? triangles : 1);
    if (status < PLT_OK) {
        give_up(e);
        return failed(e, status, fault);
    }
    if (r->phase != PLT_REBUILD_READY || !e->rendering.done) {
        return PLT_MORE;
    }
    swap(e);
    return PLT_OK;
}

/* By so many percent of what the tree was when it was built, or a new one was given up. */
static int is_worse_by(const plt_moving *m, float percent) {
    return 100.0f * (plt_degradation(m) - m->tried) >= percent * (1.0f + m->tried);
}

int plt_rebuild_due(const plt_engine *e, unsigned when, unsigned percent) {
    const plt_rebuild *r = &e->moving.rebuild;
    if (r->records == NULL || r->phase != PLT_REBUILD_IDLE || e->scene.thesis.node_slots == 0) {
        return 0;
    }
    switch (when) {
    case PLT_REBUILD_ALWAYS:
        return 1;
    case PLT_REBUILD_THRESHOLD:
        return is_worse_by(&e->moving, (float)(int32_t)percent);
    case PLT_REBUILD_COST:
        return plt_rebuild_excess(e) >= plt_rebuild_cost(&e->scene.info);
    default:
        return 0;
    }
}
