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

#if PLT_WITH_SUBTREES
static plt_subtree *worst(const plt_engine *e) {
    return plt_moving_worst(&e->moving, work_done(e) - e->moving.work);
}

static int has_subtrees(const plt_engine *e) {
    return e->options.rebuild_most > 0;
}
#endif

uint64_t plt_rebuild_excess(const plt_engine *e) {
#if PLT_WITH_SUBTREES
    if (has_subtrees(e)) {
        const plt_subtree *p = worst(e);
        return p == NULL ? 0 : plt_subtree_excess(&e->moving, p, work_done(e) - e->moving.work);
    }
#endif
    plt_moving now = e->moving;
    plt_moving_count(&now, work_done(e) - now.work);
    return now.excess;
}

uint64_t plt_rebuild_cost(const plt_engine *e) {
#if PLT_WITH_SUBTREES
    if (has_subtrees(e)) {
        const plt_subtree *p = worst(e);
        return p == NULL ? 0 : (uint64_t)PLT_REBUILD_WORK * p->count;
    }
#endif
    return (uint64_t)PLT_REBUILD_WORK * e->scene.info.triangles;
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

#if PLT_WITH_SUBTREES
/* What its areas were is taken off the sums of all, and what they are now put there. */
static void swap_part(plt_engine *e) {
    plt_moving *m = &e->moving;
    plt_subtree *p = m->rebuild.part;
    m->areas.ratios -= p->ratios;
    m->areas.sum -= p->sum;
    m->areas_built.ratios -= p->ratios_built;
    m->areas_built.sum -= p->sum_built;
    plt_rebuild_swap_part(&m->rebuild, &e->scene.thesis);
    m->areas.ratios += p->ratios;
    m->areas.sum += p->sum;
    p->ratios_built = p->ratios;
    p->sum_built = p->sum;
    m->areas_built.ratios += p->ratios;
    m->areas_built.sum += p->sum;
    p->excess = 0;
    p->tried = 0.0f;
    m->rebuilt += p->count;
}
#endif

static void swap_whole(plt_engine *e) {
    plt_moving *m = &e->moving;
    plt_rebuild_swap(&m->rebuild, &e->scene.thesis);
    m->areas = m->areas_built = m->rebuild.refit.areas;
    m->box = m->rebuild.refit.box;
    m->excess = 0;
    m->tried = 0.0f;
#if PLT_WITH_SUBTREES
    m->rebuilt += e->scene.info.triangles;
#endif
}

static int is_part(const plt_engine *e) {
#if PLT_WITH_SUBTREES
    return e->moving.rebuild.part != NULL;
#else
    (void)e;
    return 0;
#endif
}

static void swap(plt_engine *e) {
    count_work(e);
#if PLT_WITH_SUBTREES
    if (is_part(e)) {
        swap_part(e);
    } else {
        swap_whole(e);
    }
#else
    swap_whole(e);
#endif
    set_info(e);
    e->moving.rebuilds++;
    begin_touched(&e->traversal);
    plt_traversal_drop(&e->traversal);
}

void plt_rebuild_before_move(plt_engine *e, int some) {
    plt_rebuild *r = &e->moving.rebuild;
    count_work(e);
    if (plt_rebuild_must_end(r)) {
        const int refits = some || is_part(e);
        plt_rebuild_end(r, &e->scene.thesis, refits);
        swap(e);
        e->moving.is_new = !refits;
    }
}

static void start(plt_engine *e) {
    plt_rebuild *r = &e->moving.rebuild;
#if PLT_WITH_SUBTREES
    if (has_subtrees(e)) {
        plt_subtree *p = worst(e);
        if (p != NULL) {
            plt_rebuild_start_part(r, &e->scene.info, p, e->moving.areas.scale);
        }
        return;
    }
#endif
    plt_rebuild_start(r, &e->scene.info);
}

int plt_rebuild_begin(plt_engine *e, plt_fault *fault) {
    plt_rebuild *r = &e->moving.rebuild;
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    if (r->records == NULL) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             "the scene was not opened for its tree to be rebuilt");
    }
    if (r->phase == PLT_REBUILD_IDLE && e->scene.info.triangles > 0) {
        start(e);
    }
    return PLT_OK;
}

/* It has cost about what a tree costs: it is not due again before as much has been lost anew. */
static void give_up(plt_engine *e) {
    const float now = plt_degradation(&e->moving);
    count_work(e);
#if PLT_WITH_SUBTREES
    if (is_part(e)) {
        plt_subtree *p = e->moving.rebuild.part;
        const float worse = plt_subtree_degradation(p);
        p->excess = 0;
        p->tried = worse > 0.0f ? worse : 0.0f;
        return;
    }
#endif
    e->moving.excess = 0;
    e->moving.tried = now > 0.0f ? now : 0.0f;
}

static int failed(const plt_engine *e, int status, plt_fault *fault) {
    if (status == PLT_ERR_ARENA) {
        plt_fault_set(fault, status, 0,
                      "the arena has no room for the new tree, the old one stays");
        fault->need_bytes =
            is_part(e) ? 0 : plt_arena_need(&e->scene.info, e->source.mapped != NULL, &e->options);
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
static int is_worse_by(const plt_engine *e, float percent) {
    const plt_moving *m = &e->moving;
    float now = plt_degradation(m), tried = m->tried;
#if PLT_WITH_SUBTREES
    if (has_subtrees(e)) {
        const plt_subtree *p = worst(e);
        now = plt_subtree_degradation(p);
        tried = p->tried;
    }
#endif
    return 100.0f * (now - tried) >= percent * (1.0f + tried);
}

int plt_rebuild_due(const plt_engine *e, unsigned when, unsigned percent) {
    const plt_rebuild *r = &e->moving.rebuild;
    if (r->records == NULL || r->phase != PLT_REBUILD_IDLE || e->scene.thesis.node_slots == 0) {
        return 0;
    }
#if PLT_WITH_SUBTREES
    if (has_subtrees(e) && e->moving.subtrees.count == 0) {
        return 0;
    }
#endif
    switch (when) {
    case PLT_REBUILD_ALWAYS:
        return 1;
    case PLT_REBUILD_THRESHOLD:
        return is_worse_by(e, (float)(int32_t)percent);
    case PLT_REBUILD_COST:
        return plt_rebuild_excess(e) >= plt_rebuild_cost(e);
    default:
        return 0;
    }
}
