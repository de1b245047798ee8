/* grid_bundle - see grid_bundle.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/grid_bundle.h"

#include "engine/trace/grid_turn.h"

#if PLT_WITH_GRID

#define WIDE 8.0f /* cells: what is wider is quartered */

static inline float smaller(float a, float b) {
    return a < b ? a : b;
}

static inline plt_mask block_of(unsigned first, unsigned size) {
    return ((plt_mask) ~(plt_mask)0 >> (8 * sizeof(plt_mask) - size)) << first;
}

/* The largest block that may begin there. */
static unsigned largest_block(unsigned first) {
    unsigned size = 1;
    while (4 * size <= PLT_GROUPS_MAX && first % (4 * size) == 0) {
        size *= 4;
    }
    return size;
}

static void set_one(plt_grid_state *s) {
    const plt_grid_bounds *b = &s->group[s->bundle.first / 4];
    for (int i = 0; i < 4; i++) {
        s->bundle.base[i] = b->base[i][s->bundle.first % 4];
        s->bundle.rate[i] = b->rate[i][s->bundle.first % 4];
    }
}

static void set_some(plt_grid_state *s) {
    plt_mask m = s->bundle.groups;
    f4 base = f4_all(PLT_BOX_FAR), end = base;
    while (m != 0) {
        const unsigned quad = plt_mask_first(m) / 4;
        base = f4_min(base, f4_load(s->ends[quad].base));
        end = f4_min(end, f4_load(s->ends[quad].end));
        m &= ~((plt_mask)15 << (4 * quad));
    }
    f4_store(s->bundle.base, base);
    f4_store(s->bundle.rate, f4_mul(f4_sub(end, base), f4_all(1.0f / s->turn.length)));
}

void plt_grid_set_bounds(plt_grid_state *s) {
    const plt_mask m = s->bundle.groups;
    s->bundle.first = plt_mask_first(m);
    if ((m & (m - 1)) == 0) {
        set_one(s);
    } else {
        set_some(s);
    }
    for (int i = 0; i < 4; i++) {
        f4_store(s->bundle.all.base[i], f4_all(s->bundle.base[i]));
        f4_store(s->bundle.all.rate[i], f4_all(s->bundle.rate[i]));
    }
}

static float least_from(const plt_grid_state *s) {
    float from = PLT_BOX_FAR;
    for (plt_mask m = s->bundle.groups; m != 0; m &= m - 1) {
        from = smaller(from, s->from[plt_mask_first(m)]);
    }
    return from;
}

/* How many cells wide it is, at the wider end. */
static float width_of(const plt_grid_state *s, const plt_packet *p, const plt_grid_level *top) {
    const plt_grid_view v = plt_grid_view_of(s, p, top);
    float near[4], far[4], widest = 0.0f;
    f4_store(near, v.base);
    f4_store(far, f4_add(v.base, f4_mul(v.rate, f4_all(s->turn.length))));
    for (int i = 0; i < 2; i++) {
        widest = -near[i] - near[i + 2] > widest ? -near[i] - near[i + 2] : widest;
        widest = -far[i] - far[i + 2] > widest ? -far[i] - far[i + 2] : widest;
    }
    return widest;
}

/* Rays of group `next`, one by one. */
static void take_lane(plt_grid_state *s, const plt_packet *p) {
    plt_grid_turn *t = &s->turn;
    const unsigned lane = (unsigned)__builtin_ctz(t->lanes_left);
    t->lanes_left &= (uint8_t)(t->lanes_left - 1);
    s->lanes[t->next] = (uint8_t)(1u << lane);
    plt_grid_one_lane(s, p, t->next, lane);
    s->bundle.groups = plt_mask_of(t->next, 1);
    plt_grid_set_bounds(s);
    t->next += t->lanes_left == 0;
}

/* The next groups that are close together. 0: there are none. */
static int take_groups(plt_grid_state *s, const plt_packet *p, const plt_grid_level *top) {
    plt_grid_turn *t = &s->turn;
    if (t->lanes_left != 0) {
        take_lane(s, p);
        return 1;
    }
    while (t->next < p->groups) {
        for (unsigned size = largest_block(t->next);; size /= 4) {
            s->bundle.groups = t->groups & p->active & block_of(t->next, size);
            if (s->bundle.groups == 0) {
                t->next += size;
                break;
            }
            plt_grid_set_bounds(s);
            if (width_of(s, p, top) <= WIDE) {
                t->next += size;
                return 1;
            }
            if (size == 1) {
                t->lanes_left = s->lanes[t->next];
                take_lane(s, p);
                return 1;
            }
        }
    }
    return 0;
}

int plt_grid_next_bundle(plt_grid_state *s, const plt_packet *p, const plt_grid_level *top,
                         uint32_t records) {
    const plt_grid_turn *t = &s->turn;
    plt_grid_bundle *u = &s->bundle;
    while (take_groups(s, p, top)) {
        if (plt_grid_first_slice(t, top, least_from(s), &u->slice)) {
            u->slab = -1;
            u->step = t->sign > 0.0f ? 1 : -1;
            u->last = t->sign > 0.0f ? (int32_t)top->cells[t->z] - 1 : 0;
            u->soonest = -PLT_BOX_FAR;
            u->stamp = plt_grid_next_stamp(s, records);
            return 1;
        }
    }
    u->groups = 0;
    return 0;
}

#endif
