/* traverse_grid - packets through a grid, slice after slice
 *
 * What groups of rays may meet in a slice is a rectangle of cells; their references are all looked
 * at, but each record once per bundle. Slices come front to back, and a group that has hits in
 * front of a slice is done for good: so a record that was met once need not be met again.
 *
 * Source: Wald, Ize, Kensler, Knoll, Parker, "Ray tracing animated scenes using coherent grid
 * traversal", 2006. Why hits are those of any tree: DESIGN.md, section 7.9.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/small_stack.h"
#include "engine/grid/macro.h"
#include "engine/lanes/lane.h"
#include "engine/trace/grid_bundle.h"
#include "engine/trace/grid_cull.h"
#include "engine/trace/grid_turn.h"
#include "engine/trace/leaf_records.h"
#include "engine/trace/traverse_formats.h"
#include "engine/tree/record_rows.h"

#if PLT_WITH_GRID

enum { WAITING = 8 * PLT_GRID_TOGETHER };

/* What is the same for all references of a slice. */
typedef struct visit {
    plt_traversal *t;
    plt_packet *p;
    plt_grid_state *s;
    const plt_record *records;
    uint32_t *mailbox;
    uint32_t met, mark;      /* what the bundle finds there, and leaves */
    uint32_t *waiting, wait; /* records to be looked at, and how many there are */
    plt_mask groups;         /* that seek hits there */
    plt_mask tested;
    uint32_t cells, references;
    uint64_t tests; /* a group each */
} visit;

/* Of the triangle's box. */
static inline float longest_side(const f4 c[3]) {
    const f4 lo = f4_min(f4_min(c[0], c[1]), c[2]), hi = f4_max(f4_max(c[0], c[1]), c[2]);
    const f4 side = f4_sub(hi, lo), after = f4_turn(side);
    float longest[4];
    f4_store(longest, f4_max(f4_max(side, after), f4_turn(after)));
    return longest[0];
}

static inline void test_groups(visit *v, const plt_record *record, plt_mask groups) {
    f4 corner[3];
    plt_record_rows(record, corner);
#if PLT_WITH_HULLS
    const plt_triangle_rows rows = {{corner[0], corner[1], corner[2]},
                                    plt_get_u32(&record->word[9])};
    plt_triangles_groups(v->p, &rows, 1, NULL, longest_side(corner), groups);
#else
    plt_record_groups(v->p, record, longest_side(corner), groups);
#endif
    v->tested |= groups;
    v->tests += plt_mask_count(groups);
}

/* Lane `lane` of it in all lanes. */
static inline f4 all_of_lane(const f4 *v, unsigned lane) {
    return f4_all(plt_lane(v, lane));
}

/* Of `groups` those that may meet the record of a lane. */
PLT_APART_ON_SMALL_STACKS static plt_mask groups_that_meet(const plt_grid_state *s,
                                                           const plt_grid_sides *of, unsigned lane,
                                                           plt_mask groups, int by_rates) {
    const plt_grid_sides sides = {{all_of_lane(&of->to[0], lane), all_of_lane(&of->to[1], lane),
                                   all_of_lane(&of->to[2], lane), all_of_lane(&of->to[3], lane)},
                                  all_of_lane(&of->near, lane),
                                  all_of_lane(&of->far, lane)};
#if PLT_LANES_REGISTERS
    if (by_rates) {
        return plt_grid_meet_limits(s, &sides, groups);
    }
#endif
    (void)by_rates;
    return plt_grid_meet_groups(s, &sides, groups);
}

/* Records of `lanes`, which the bundle may meet. */
PLT_GRID_PART void test_four(visit *v, const plt_record *const record[PLT_GRID_TOGETHER],
                             unsigned lanes, const plt_grid_sides *of, int by_rates) {
    const plt_grid_state *s = v->s;
    const unsigned without_groups = PLT_GRID_WITHOUT_GROUPS | PLT_GRID_WITHOUT_CULLING;
    for (; lanes != 0; lanes &= lanes - 1) {
        const unsigned lane = (unsigned)__builtin_ctz(lanes);
        plt_mask groups = v->groups & v->p->active;
        if ((groups & (groups - 1)) != 0 && (s->without & without_groups) == 0) {
            groups = groups_that_meet(s, of, lane, groups, by_rates);
        }
        if (groups != 0) {
            test_groups(v, record[lane], groups);
        }
    }
}

/* Looks at records that wait, `count` of them, from 1 to PLT_GRID_TOGETHER. */
static void visit_records(visit *v, const uint32_t *waiting, uint32_t count) {
    const plt_grid_state *s = v->s;
    const plt_record *record[PLT_GRID_TOGETHER];
    plt_grid_sides sides;
    for (unsigned i = 0; i < PLT_GRID_TOGETHER; i++) {
        record[i] = &v->records[waiting[i < count ? i : 0]];
    }
    unsigned lanes = plt_grid_cull(s, record, &sides);
    lanes = ((s->without & PLT_GRID_WITHOUT_CULLING) == 0 ? lanes : 15u) & ((1u << count) - 1u);
#if PLT_LANES_REGISTERS
    if (lanes == 0) {
        return;
    }
    if ((lanes & ~m4_mask(f4_le(f4_all(s->turn.close), sides.near))) == 0) {
        plt_grid_set_limits(s, &sides);
        test_four(v, record, lanes, &sides, 1);
        return;
    }
#endif
    test_four(v, record, lanes, &sides, 0);
}

/* ... at all of them. */
static void visit_waiting(visit *v) {
    const uint32_t count = v->wait;
    v->wait = 0;
    for (uint32_t i = 0; i < count; i += PLT_GRID_TOGETHER) {
        const uint32_t left = count - i;
        visit_records(v, v->waiting + i, left < PLT_GRID_TOGETHER ? left : PLT_GRID_TOGETHER);
    }
}

/* Lets the records of references from `first` on wait that the bundle has not met, up to `end`, or
 * one that is a crowded cell's: where it stops. No jump depends on which were met: half of them
 * would be foreseen wrong. */
static uint32_t add_references(visit *v, const uint32_t *reference, uint32_t first, uint32_t end) {
    uint32_t *const mailbox = v->mailbox, *const waiting = v->waiting;
    const uint32_t met = v->met, mark = v->mark;
    uint32_t wait = v->wait;
    for (; first < end && (reference[first] & PLT_GRID_CROWDED) == 0; first++) {
        const uint32_t index = reference[first];
        waiting[wait] = index;
        wait += mailbox[index] != met;
        mailbox[index] = mark;
        if (wait == WAITING) {
            v->wait = wait;
            visit_waiting(v);
            wait = 0;
        }
    }
    v->wait = wait;
    return first;
}

/* What the bundle's groups may reach of a slice. 0: nothing. */
static int overlap(const plt_grid_view *view, const plt_grid_turn *t, const plt_grid_level *l,
                   float front, float back, plt_grid_patch *c) {
    const f4 near = f4_all(front > 0.0f ? front : 0.0f), far = f4_all(back > 0.0f ? back : 0.0f);
    float bound[4];
    f4_store(bound, f4_sub(plt_grid_least(view->base, view->rate, near, far), view->margin));
    return plt_grid_between(c, 0, bound[0], -bound[2], l->last[t->x]) &&
           plt_grid_between(c, 1, bound[1], -bound[3], l->last[t->y]);
}

/* Cells of one slice of a crowded cell. */
static void visit_inner(visit *v, const plt_grid_level *l, int32_t slice, const plt_grid_patch *c) {
    const plt_grid_turn *t = &v->s->turn;
    plt_grid_runs runs = plt_grid_runs_of(l, t->x, t->y, t->z, slice, c);
    uint32_t first, end;
    while (plt_grid_next_run(&runs, &first, &end)) {
        v->cells += runs.cells;
        v->references += end - first;
        add_references(v, l->reference, first, end);
    }
}

/* Ends a slice: how deep groups seek hits that have found some. */
static void set_until(visit *v) {
    plt_grid_state *s = v->s;
    plt_packet *p = v->p;
    visit_waiting(v);
    plt_mask tested = v->tested;
    v->tested = 0;
#if PLT_WITH_HULLS
    tested = p->changed;
    p->changed = 0;
#endif
    for (plt_mask m = tested; m != 0; m &= m - 1) {
        const unsigned group = plt_mask_first(m);
        s->until[group] = plt_grid_until(&s->turn, p, group, s->lanes[group]);
        s->bundle.soonest = -PLT_BOX_FAR;
    }
}

/* 1: a group that is looked for seeks hits at that depth. */
static int any_reaches(const visit *v, float depth) {
    for (plt_mask m = v->groups & v->p->active; m != 0; m &= m - 1) {
        if (v->s->until[plt_mask_first(m)] >= depth) {
            return 1;
        }
    }
    return 0;
}

/* What the bundle reaches of a slice of a crowded cell. 0: nothing; -1: nor of those behind it. */
PLT_APART_ON_SMALL_STACKS static int reach_inner(const visit *v, const plt_grid_level *l,
                                                 int32_t slice, plt_grid_patch *r) {
    const plt_grid_turn *t = &v->s->turn;
    const plt_grid_view view = plt_grid_view_of(v->s, v->p, l);
    const float lower = view.plane + (float)slice * view.size;
    const float upper = view.plane + (float)(slice + 1) * view.size;
    const float front = t->sign > 0.0f ? lower : upper, back = t->sign > 0.0f ? upper : lower;
    if (!any_reaches(v, front - view.slack)) {
        return -1;
    }
    return overlap(&view, t, l, front, back, r);
}

/* A record is tested for all groups that reach the cell's own slice, whatever they have hit
 * meanwhile: it may lie in other cells of that slice, too, and is not met there again. */
static void visit_crowded(visit *v, const plt_grid_level *l) {
    const plt_grid_turn *t = &v->s->turn;
    const int32_t step = t->sign > 0.0f ? 1 : -1, count = (int32_t)l->cells[t->z];
    int32_t slice;
    plt_grid_patch r;
    if (!plt_grid_first_slice(t, l, 0.0f, &slice)) {
        return;
    }
    for (; slice >= 0 && slice < count; slice += step) {
        const int reached = reach_inner(v, l, slice, &r);
        if (reached < 0) {
            return;
        }
        if (reached) {
            visit_inner(v, l, slice, &r);
            set_until(v);
        }
    }
}

/* A run of references of the top level, maybe of several cells. */
static void visit_run(visit *v, const plt_grid *grid, uint32_t first, uint32_t end) {
    const uint32_t *reference = grid->top.reference;
    v->references += end - first;
    while ((first = add_references(v, reference, first, end)) < end) {
        visit_crowded(v, &grid->crowded[reference[first] & ~PLT_GRID_CROWDED]);
        first += reference[first + 1];
    }
}

/* Cells of one slice of the top level. */
static void visit_cells(visit *v, const plt_grid *grid, int32_t slice, const plt_grid_patch *c) {
    const plt_grid_turn *t = &v->s->turn;
    plt_grid_runs runs = plt_grid_runs_of(&grid->top, t->x, t->y, t->z, slice, c);
    uint32_t first, end;
    while (plt_grid_next_run(&runs, &first, &end)) {
        v->cells += runs.cells;
        visit_run(v, grid, first, end);
    }
}

/* Groups of the bundle that seek hits at this depth. */
static void drop_groups(plt_grid_state *s, const plt_packet *p, float depth) {
    plt_grid_bundle *u = &s->bundle;
    plt_mask still = 0;
    float soonest = PLT_BOX_FAR;
    for (plt_mask m = u->groups & p->active; m != 0; m &= m - 1) {
        const unsigned group = plt_mask_first(m);
        const float until = s->until[group];
        if (until >= depth) {
            still |= plt_mask_of(group, 1);
            soonest = until < soonest ? until : soonest;
        }
    }
    u->soonest = soonest;
    if (still != u->groups) {
        u->groups = still;
        if (still != 0) {
            plt_grid_set_bounds(s);
        }
    }
}

#if PLT_WITH_MACRO_CELLS
/* Goes on to the end of a slab in which the bundle reaches no macro cell that has references. 0: it
 * reaches one, or was there before. */
static int skip_slab(const plt_grid_view *view, const plt_grid_turn *t, const plt_grid *grid,
                     plt_grid_bundle *u) {
    const int32_t slab = u->slice / PLT_GRID_MACRO, most = (int32_t)grid->top.cells[t->z] - 1;
    const int32_t lowest = slab * PLT_GRID_MACRO, end = lowest + PLT_GRID_MACRO - 1;
    const int32_t highest = end < most ? end : most;
    plt_grid_patch r;
    if (slab == u->slab) {
        return 0;
    }
    const float lower = view->plane + (float)lowest * view->size;
    const float upper = view->plane + (float)(highest + 1) * view->size;
    const float front = u->step > 0 ? lower : upper, back = u->step > 0 ? upper : lower;
    u->slab = slab;
    if (overlap(view, t, &grid->top, front, back, &r) &&
        !plt_grid_macro_is_empty(grid, t->x, t->y, t->z, slab, &r)) {
        return 0;
    }
    u->slice = (u->step > 0 ? highest : lowest) + u->step;
    u->groups = u->slice < 0 || u->slice > most ? 0 : u->groups;
    return 1;
}
#endif

/* What the bundle reaches of its current slice. 0: nothing; -1: it has gone on already. */
PLT_APART_ON_SMALL_STACKS static int reach_slice(const plt_grid *grid, const plt_packet *p,
                                                 plt_grid_state *s, plt_grid_patch *r) {
    const plt_grid_level *top = &grid->top;
    plt_grid_bundle *u = &s->bundle;
    const int32_t slice = u->slice;
    const float plane = s->turn.sign * (top->lo[s->turn.z] - s->turn.plane);
    const float size = s->turn.sign * top->size[s->turn.z];
    const float lower = plane + (float)slice * size, upper = plane + (float)(slice + 1) * size;
    const float front = u->step > 0 ? lower : upper, back = u->step > 0 ? upper : lower;
    const float depth = front - s->turn.margin - PLT_GRID_CELL_ERROR * top->size[s->turn.z];
    if (depth > u->soonest || (u->groups & ~p->active) != 0) {
        drop_groups(s, p, depth);
    }
    if (u->groups == 0) {
        return -1;
    }
    const plt_grid_view view = plt_grid_view_of(s, p, top);
#if PLT_WITH_MACRO_CELLS
    if ((s->without & PLT_GRID_WITHOUT_MACRO) == 0 && skip_slab(&view, &s->turn, grid, u)) {
        return -1;
    }
#endif
    return overlap(&view, &s->turn, top, front, back, r) &&
           ((s->without & PLT_GRID_WITHOUT_RECTANGLES) != 0 ||
            plt_grid_cut(r, &grid->rect[s->turn.z][slice]));
}

/* The bundle's current slice, and on to the next. Returns cells looked at, and 1. */
static uint32_t visit_slice(plt_traversal *t, plt_packet *p, plt_grid_state *s) {
    const plt_grid *grid = t->scene->gridded.grid;
    plt_grid_bundle *u = &s->bundle;
    plt_grid_patch r;
    const int reached = reach_slice(grid, p, s, &r);
    if (reached < 0) {
        return 1;
    }
    const int32_t slice = u->slice;
    uint32_t waiting[WAITING];
    visit v = {.t = t,
               .p = p,
               .s = s,
               .records = t->scene->gridded.records,
               .mailbox = plt_grid_mailbox(s),
               .met = u->stamp,
               .mark = (s->without & PLT_GRID_WITHOUT_MAILBOX) != 0 ? 0 : u->stamp,
               .waiting = waiting,
               .groups = u->groups};
    if (reached) {
        visit_cells(&v, grid, slice, &r);
        set_until(&v);
    }
    u->slice += u->step;
    if (slice == u->last) {
        u->groups = 0;
    }
    t->stats.node_visits += v.cells;
    t->stats.group_tests += v.references;
    t->stats.triangle_tests += v.tests;
    return v.cells + 1;
}

/* To the next bundle, of this turn or another. 0: there is none. */
static int next_bundle(plt_traversal *t, plt_packet *p, plt_grid_state *s) {
    const plt_gridded *scene = &t->scene->gridded;
    while (!plt_grid_next_bundle(s, p, &scene->grid->top, scene->count)) {
        if (!plt_grid_next_turn(s, p)) {
            return 0;
        }
    }
    return 1;
}

/* ---- the functions of traverse_formats.h ---------------------------------------- */

size_t plt_grid_entry_bytes(unsigned order) {
    return order == PLT_ORDER_DEPTH_FIRST; /* no stack, but this order */
}

size_t plt_grid_state_bytes(void) {
    return sizeof(plt_grid_state);
}

void plt_grid_state_init(plt_traversal *t) {
    plt_grid_state_clear(plt_grid_state_of(t), t->scene->gridded.count);
}

void plt_grid_begin(plt_traversal *t, plt_packet *p) {
    plt_grid_state *s = plt_grid_state_of(t);
#if PLT_WITH_HULLS
    p->changed = 0;
    p->moved = p->slabs.coherence == PLT_ONE_ORIGIN && p->active != 0;
    if (!p->moved) {
        plt_packet_make_ready(p);
    }
#endif
    s->turns = 0;
    s->bundle.groups = 0;
    s->turn.groups = 0;
    s->turn.next = PLT_GROUPS_MAX;
    s->turn.lanes_left = 0;
    t->waiting = p->active != 0 && t->scene->gridded.count > 0;
}

int plt_grid_traverse(plt_traversal *t, plt_packet *p, uint32_t visits) {
    plt_grid_state *s = plt_grid_state_of(t);
    while (t->waiting > 0 && visits > 0) {
        if (s->bundle.groups == 0 && !next_bundle(t, p, s)) {
            t->waiting = 0;
            break;
        }
        const uint32_t used = visit_slice(t, p, s);
        visits -= used < visits ? used : visits;
        if (p->active == 0) {
            t->waiting = 0;
        }
    }
    return t->waiting > 0 ? PLT_MORE : PLT_OK;
}

#endif
