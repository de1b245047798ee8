/* grid_turn - see grid_turn.h
 *
 * Where a ray is at two depths says where it is between them. The least of many linear functions is
 * concave, so the line through its values at both depths is nowhere above it: bounds of four rays,
 * or of any number, are the least values at both.
 *
 * Source: Wald et al. 2006, section 3 (bounding planes); for rays of one origin they are exact.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/grid_turn.h"

#include "engine/base/small_stack.h"
#include "engine/trace/ray_bounds.h"
#include "engine/trace/triangle_common.h"

#if PLT_WITH_GRID

#define MARGIN 8.0f            /* times how far origins are moved (DESIGN.md, section 7.9) */
#define DEPTH_LONG 1.00000095f /* 1 + 2^-20: hulls.c */
#define DEPTH_TINY 8.2718061e-25f
#define LENGTH_LEAST 0.0625f /* of the reach */
#define CLOSE 0.0009765625f  /* 2^-10, likewise */

static inline float larger(float a, float b) {
    return a > b ? a : b;
}

static inline float smaller(float a, float b) {
    return a < b ? a : b;
}

/* Lanes that run along z, down or up. */
static unsigned lanes_of(const plt_group_rays *g, int z, int down) {
    if (g->valid == 0 || g->axis_lanes[z] == 0) {
        return 0;
    }
    const unsigned downs = m4_mask(f4_lt(f4_load(g->dir[z]), f4_zero()));
    return g->axis_lanes[z] & (down ? downs : ~downs);
}

/* All groups have four rays that run the same way along one axis, and seek hits without an end. */
static inline int is_plain(const plt_packet *p) {
#if PLT_WITH_HULLS
    return p->along && p->unbounded;
#else
    (void)p;
    return 0;
#endif
}

static plt_mask choose_lanes(plt_grid_state *s, const plt_packet *p, int z, int down) {
    plt_mask groups = 0;
    if (is_plain(p)) {
        memset(s->lanes, 15, sizeof s->lanes);
        return p->slabs.negative[z] == (uint32_t)down ? p->active : 0;
    }
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        const unsigned i = plt_mask_first(m);
        s->lanes[i] = (uint8_t)lanes_of(&p->rays[i], z, down);
        groups |= plt_mask_of(i, s->lanes[i] != 0);
    }
    return groups;
}

/* Lanes that are not of the turn get the value of one that is. */
static inline f4 fill(f4 v, unsigned lanes) {
    float four[4];
    if (lanes == 15) {
        return v;
    }
    f4_store(four, v);
    return f4_select(m4_bits(lanes), v, f4_all(four[__builtin_ctz(lanes)]));
}

/* What the origins of a turn have in common. */
typedef struct origins {
    f4 least, most; /* along the axis; least: the first that is passed */
    f4 furthest, reach;
} origins;

static void add_group(origins *o, const plt_group_rays *g, const plt_grid_turn *t, unsigned lanes) {
    const f4 along = fill(f4_load(g->org[t->z]), lanes);
    o->least = f4_min(o->least, along);
    o->most = f4_max(o->most, along);
    o->reach = f4_max(o->reach, fill(f4_load(g->reach), lanes));
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        o->furthest = f4_max(o->furthest, fill(f4_abs(f4_load(g->org[a])), lanes));
    }
}

static inline float most_lane(f4 a) {
    return -f4_min_lane(f4_neg(a));
}

/* The plane at depth 0 is where the first ray begins; or where the grid does, if that is later. */
static void set_plane(const plt_grid_state *s, plt_grid_turn *t, const plt_packet *p) {
    const float lo = p->scene->lo[t->z], hi = p->scene->hi[t->z];
    float reach = p->reach, furthest = 0.0f;
    t->close = PLT_BOX_FAR;
    if (p->slabs.coherence == PLT_ONE_ORIGIN) {
        t->plane = p->org[t->z];
        t->close = reach * CLOSE;
        for (int a = 0; a < 3; a++) {
            furthest = larger(furthest, __builtin_fabsf(p->org[a]));
        }
    } else {
        origins o = {f4_all(PLT_BOX_FAR), f4_all(-PLT_BOX_FAR), f4_zero(), f4_zero()};
        for (plt_mask m = t->groups; m != 0; m &= m - 1) {
            const unsigned i = plt_mask_first(m);
            add_group(&o, &p->rays[i], t, s->lanes[i]);
        }
        const float first = t->sign > 0.0f ? f4_min_lane(o.least) : most_lane(o.most);
        t->plane = smaller(larger(first, lo), hi);
        furthest = most_lane(o.furthest);
        reach = most_lane(o.reach);
    }
    const float rest = t->sign > 0.0f ? hi - t->plane : t->plane - lo;
    t->length = larger(rest, reach * LENGTH_LEAST);
    t->margin = MARGIN * larger(reach * PLT_BOX_ERROR, furthest * PLT_ORIGIN_ERROR);
}

static void set_offsets(plt_grid_turn *t, const plt_box *scene) {
    const float x = scene->lo[t->x], y = scene->lo[t->y];
    f4_store(t->offset[0], f4_all(t->margin - x));
    f4_store(t->offset[1], f4_all(t->margin - y));
    f4_store(t->offset[2], f4_all(t->margin + x));
    f4_store(t->offset[3], f4_all(t->margin + y));
}

/* Of four rays: where they are at depths 0 and length, and the depths that they seek hits at. */
typedef struct four_rays {
    f4 x[2], y[2];
    f4 from, until;
} four_rays;

static inline void depths_of(const plt_grid_turn *t, const plt_packet *p, unsigned group, f4 *from,
                             f4 *until) {
    const plt_group_rays *g = &p->rays[group];
    const f4 goes = f4_mul(f4_load(p->slabs.group[group].tmax), f4_abs(f4_load(g->dir[t->z])));
    const f4 most = f4_add(f4_mul(goes, f4_all(DEPTH_LONG)), f4_all(DEPTH_TINY));
    *from = f4_mul(f4_all(t->sign), f4_sub(f4_load(g->org[t->z]), f4_all(t->plane)));
    *until = f4_add(*from, most);
}

PLT_APART_ON_SMALL_STACKS static void set_rays(four_rays *r, const plt_grid_turn *t,
                                               const plt_packet *p, unsigned group,
                                               unsigned lanes) {
    const plt_group_rays *g = &p->rays[group];
    const f4 along = f4_load(g->org[t->z]);
    const f4 slope_x = f4_load(g->slope[0]), slope_y = f4_load(g->slope[1]);
    const f4 ahead = f4_sub(f4_all(t->plane), along), way = f4_all(t->sign * t->length);
    const f4 lo_x = f4_all(p->scene->lo[t->x]), lo_y = f4_all(p->scene->lo[t->y]);
    f4 from, until;
    depths_of(t, p, group, &from, &until);
    r->x[0] = fill(f4_add(f4_sub(f4_load(g->org[t->x]), lo_x), f4_mul(slope_x, ahead)), lanes);
    r->y[0] = fill(f4_add(f4_sub(f4_load(g->org[t->y]), lo_y), f4_mul(slope_y, ahead)), lanes);
    r->x[1] = f4_add(r->x[0], fill(f4_mul(slope_x, way), lanes));
    r->y[1] = f4_add(r->y[0], fill(f4_mul(slope_y, way), lanes));
    r->from = fill(from, lanes);
    r->until = fill(until, lanes);
}

/* Rows of four groups become columns; the least lane of each group, and the negated greatest. */
PLT_INLINED void least_and_most(f4 row[4], f4 *least, f4 *minus_most) {
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    *least = f4_min(f4_min(row[0], row[1]), f4_min(row[2], row[3]));
    *minus_most = f4_neg(f4_max(f4_max(row[0], row[1]), f4_max(row[2], row[3])));
}

/* Bounds at one depth, of four groups. */
PLT_APART_ON_SMALL_STACKS static void collect(const four_rays r[4], unsigned end, f4 bound[4]) {
    f4 x[4], y[4];
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        x[i] = r[i].x[end];
        y[i] = r[i].y[end];
    }
    least_and_most(x, &bound[0], &bound[2]);
    least_and_most(y, &bound[1], &bound[3]);
}

/* Groups without rays, which were given those of another. */
static void set_nothing(plt_grid_bounds *b, unsigned lane) {
    for (int i = 0; i < 4; i++) {
        b->base[i][lane] = PLT_BOX_FAR;
        b->rate[i][lane] = 0.0f;
    }
}

PLT_APART_ON_SMALL_STACKS static f4 least_of_rows(const f4 row[4]) {
    f4 a = row[0], b = row[1], c = row[2], d = row[3];
    f4_transpose(&a, &b, &c, &d);
    return f4_min(f4_min(a, b), f4_min(c, d));
}

PLT_APART_ON_SMALL_STACKS static void set_depths(plt_grid_state *s, unsigned quad,
                                                 const four_rays r[4]) {
    f4 from[4], until[4], least, unused;
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        from[i] = r[i].from;
        until[i] = r[i].until;
    }
    least_and_most(from, &least, &unused);
    f4_store(&s->from[4 * quad], f4_max(least, f4_zero()));
    least_and_most(until, &unused, &least);
    f4_store(&s->until[4 * quad], f4_neg(least));
}

/* Groups 4 quad to 4 quad + 3, some of which have rays. */
static void set_quad(plt_grid_state *s, const plt_packet *p, unsigned quad) {
    const plt_grid_turn *t = &s->turn;
    const unsigned with = (unsigned)(t->groups >> (4 * quad)) & 15u;
    const unsigned some = 4 * quad + (unsigned)__builtin_ctz(with);
    const f4 per_length = f4_all(1.0f / t->length);
    plt_grid_bounds *b = &s->group[quad];
    four_rays r[4];
    f4 base[4], end[4];
    for (unsigned i = 0; i < 4; i++) {
        const unsigned group = with >> i & 1u ? 4 * quad + i : some;
        set_rays(&r[i], t, p, group, s->lanes[group]);
    }
    collect(r, 0, base);
    collect(r, 1, end);
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        f4_store(b->base[i], base[i]);
        f4_store(b->rate[i], f4_mul(f4_sub(end[i], base[i]), per_length));
    }
    f4_store(s->ends[quad].base, least_of_rows(base));
    f4_store(s->ends[quad].end, least_of_rows(end));
    set_depths(s, quad, r);
    for (unsigned none = ~with & 15u; none != 0; none &= none - 1) {
        set_nothing(b, (unsigned)__builtin_ctz(none));
    }
}

static void set_lane(plt_grid_bounds *b, unsigned lane, const plt_grid_turn *t, f4 base, f4 end) {
    float four[2][4];
    f4_store(four[0], base);
    f4_store(four[1], f4_mul(f4_sub(end, base), f4_all(1.0f / t->length)));
    for (int i = 0; i < 4; i++) {
        b->base[i][lane] = four[0][i];
        b->rate[i][lane] = four[1][i];
    }
}

/* Quads, and all of them together, from what was found of each. */
static void set_sixteen(plt_grid_state *s, unsigned index) {
    plt_grid_bounds *b = &s->quad[index];
    f4 least_base = f4_all(PLT_BOX_FAR), least_end = least_base;
    for (unsigned lane = 0; lane < 4; lane++) {
        const unsigned quad = 4 * index + lane;
        if (quad >= PLT_GRID_QUADS || (s->turn.groups >> (4 * quad) & 15u) == 0) {
            set_nothing(b, lane);
            continue;
        }
        const f4 base = f4_load(s->ends[quad].base), end = f4_load(s->ends[quad].end);
        set_lane(b, lane, &s->turn, base, end);
        least_base = f4_min(least_base, base);
        least_end = f4_min(least_end, end);
    }
    if ((s->turn.groups >> (16 * index) & 0xFFFFu) == 0) {
        set_nothing(&s->sixteen, index);
    } else {
        set_lane(&s->sixteen, index, &s->turn, least_base, least_end);
    }
}

#if PLT_WITH_HULLS && PLT_LANES_REGISTERS
/* Least and greatest slopes of four groups, whose rays have one origin, along one axis. */
PLT_INLINED void collect_slopes(const plt_group_rays *g, int i, float sign, f4 *least,
                                f4 *minus_most) {
    f4 row[4];
    PLT_UNROLLED for (int k = 0; k < 4; k++) {
        row[k] = f4_mul(f4_load(g[k].slope[i]), f4_all(sign));
    }
    least_and_most(row, least, minus_most);
}

/* The same as set_quad, of a plain packet of one origin, which is on the turn's plane: slopes are
 * what bounds gain with depth. */
static void set_plain_quad(plt_grid_state *s, const plt_packet *p, unsigned quad) {
    const plt_grid_turn *t = &s->turn;
    const plt_group_rays *g = &p->rays[4 * quad];
    const float x = p->org[t->x] - p->scene->lo[t->x], y = p->org[t->y] - p->scene->lo[t->y];
    const f4 base = plt_grid_four(x, y, -x, -y);
    plt_grid_bounds *b = &s->group[quad];
    f4 rate[4];
    collect_slopes(g, 0, t->sign, &rate[0], &rate[2]);
    collect_slopes(g, 1, t->sign, &rate[1], &rate[3]);
    f4_store(b->base[0], f4_lane(base, 0));
    f4_store(b->base[1], f4_lane(base, 1));
    f4_store(b->base[2], f4_lane(base, 2));
    f4_store(b->base[3], f4_lane(base, 3));
    PLT_UNROLLED for (int i = 0; i < 4; i++) {
        f4_store(b->rate[i], rate[i]);
    }
    f4_store(s->ends[quad].base, base);
    f4_store(s->ends[quad].end, f4_add(base, f4_mul(least_of_rows(rate), f4_all(t->length))));
    f4_store(&s->from[4 * quad], f4_zero());
    f4_store(&s->until[4 * quad], f4_all(PLT_BOX_FAR));
}

/* 0: the packet is not as plain as that. */
static int set_plain_quads(plt_grid_state *s, const plt_packet *p) {
    if (!is_plain(p) || p->slabs.coherence != PLT_ONE_ORIGIN || p->groups % 4 != 0) {
        return 0;
    }
    for (unsigned i = 0; i < p->groups / 4; i++) {
        set_plain_quad(s, p, i);
    }
    return 1;
}
#else
static int set_plain_quads(plt_grid_state *s, const plt_packet *p) {
    (void)s;
    (void)p;
    return 0;
}
#endif

static void set_turn(plt_grid_state *s, const plt_packet *p) {
    set_plane(s, &s->turn, p);
    set_offsets(&s->turn, p->scene);
    const int are_set = set_plain_quads(s, p);
    for (unsigned i = 0; i < PLT_GRID_QUADS && !are_set; i++) {
        if ((s->turn.groups >> (4 * i) & 15u) != 0) {
            set_quad(s, p, i);
        }
    }
    for (unsigned i = 0; i < PLT_GRID_SIXTEENS; i++) {
        set_sixteen(s, i);
    }
}

int plt_grid_next_turn(plt_grid_state *s, plt_packet *p) {
    plt_grid_turn *t = &s->turn;
    while (s->turns < 6 && p->active != 0) {
        const int z = (int)(s->turns >> 1), down = (int)(s->turns & 1u);
        s->turns++;
        if (p->axis != PLT_AXES_DIFFER && p->axis != z) {
            continue;
        }
        t->groups = choose_lanes(s, p, z, down);
        if (t->groups != 0) {
            t->z = z;
            t->x = plt_axis_after[z];
            t->y = plt_axis_after[t->x];
            t->sign = down ? -1.0f : 1.0f;
            t->next = t->lanes_left = 0;
            set_turn(s, p);
            return 1;
        }
    }
    return 0;
}

void plt_grid_one_lane(plt_grid_state *s, const plt_packet *p, unsigned group, unsigned lane) {
    plt_grid_bounds *b = &s->group[group / 4];
    const float per_length = 1.0f / s->turn.length;
    four_rays r;
    set_rays(&r, &s->turn, p, group, 1u << lane);
    float x[2][4], y[2][4], from[4], until[4];
    for (int end = 0; end < 2; end++) {
        f4_store(x[end], r.x[end]);
        f4_store(y[end], r.y[end]);
    }
    f4_store(from, r.from);
    f4_store(until, r.until);
    s->from[group] = larger(from[0], 0.0f);
    s->until[group] = until[0];
    const float base[2] = {x[0][0], y[0][0]};
    const float rate[2] = {(x[1][0] - x[0][0]) * per_length, (y[1][0] - y[0][0]) * per_length};
    for (int i = 0; i < 2; i++) {
        b->base[i][group % 4] = base[i];
        b->base[2 + i][group % 4] = -base[i];
        b->rate[i][group % 4] = rate[i];
        b->rate[2 + i][group % 4] = -rate[i];
    }
}

float plt_grid_until(const plt_grid_turn *t, const plt_packet *p, unsigned group, unsigned lanes) {
    f4 from, until;
    depths_of(t, p, group, &from, &until);
    return most_lane(fill(until, lanes));
}

#endif
