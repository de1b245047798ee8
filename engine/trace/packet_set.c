/* packet_set - rays set up as groups, and what they have in common: packet.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/packet_group.h"
#include "engine/trace/packet_quick.h"

void plt_packet_init(plt_packet *packet, void *memory, unsigned side) {
    const unsigned groups = side * side / 4;
    packet->slabs.group = memory;
    packet->rays = (plt_group_rays *)(void *)(packet->slabs.group + groups);
#if PLT_WITH_HULLS
    packet->hull = (plt_hull *)(void *)(packet->rays + groups);
    packet->first_group = (groups - 1) / 3;
    packet->capacity = groups;
#endif
}

#if PLT_WITH_HULLS
static inline float larger(float a, float b) {
    return a > b ? a : b;
}

void plt_packet_set_reach(plt_packet *p, float reach, float furthest) {
    const float moved = larger(reach * PLT_BOX_ERROR, furthest * PLT_ORIGIN_ERROR);
    p->reach = reach;
    p->least_slack = reach * reach * PLT_CLOSE_ERROR;
    p->least_sure = reach * moved * PLT_SURE_ERROR;
}

void plt_group_set_slabs(plt_packet *p, unsigned index) {
    const plt_group_rays *g = &p->rays[index];
    f4 org[3], dir[3];
    for (int a = 0; a < 3; a++) {
        org[a] = f4_load(g->org[a]);
        dir[a] = f4_load(g->dir[a]);
    }
    if (p->moved) {
        set_reciprocals(&p->slabs.group[index], dir);
        f4_store(p->rays[index].reach, f4_all(p->reach));
    } else {
        set_slabs(p, index, org, dir);
    }
    p->ready |= plt_mask_of(index, 1);
}

void plt_packet_make_ready(plt_packet *p) {
    f4 reach = f4_zero(), furthest = f4_zero();
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        const plt_group_rays *g = &p->rays[plt_mask_first(m)];
        const f4 org[3] = {f4_load(g->org[0]), f4_load(g->org[1]), f4_load(g->org[2])};
        plt_group_make_ready(p, plt_mask_first(m));
        reach = f4_max(reach, f4_load(g->reach));
        furthest = f4_max(furthest, largest_of(org));
    }
    plt_packet_set_reach(p, -f4_min_lane(f4_neg(reach)), -f4_min_lane(f4_neg(furthest)));
}
#endif

#if PLT_QUICK_LANES
/* Where the other lanes find them. */
static void give_rays(plt_packet *p, unsigned index, const f4 org[3], const f4 dir[3], f4 tmin,
                      f4 tmax) {
    plt_group_slabs *s = &p->slabs.group[index];
    plt_group_rays *g = &p->rays[index];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        f4_store(g->org[a], org[a]);
        f4_store(g->dir[a], dir[a]);
    }
    f4_store(s->tmin, tmin);
    f4_store(s->tmax, tmax);
}
#endif

void plt_packet_set_group(plt_packet *p, unsigned index, const f4 org[3], const f4 dir[3], f4 tmin,
                          f4 tmax, unsigned count) {
    int has_rays;
#if PLT_QUICK_LANES
    give_rays(p, index, org, dir, tmin, tmax);
    if (!plt_packet_set_quickly(p, index, count, &has_rays))
#endif
    {
        has_rays = set_group(p, index, org, dir, tmin, tmax, count);
    }
    p->active |= plt_mask_of(index, has_rays);
}

void plt_packet_begin(plt_packet *packet, const plt_box *scene, unsigned groups, int any) {
    packet->scene = scene;
    packet->groups = groups;
    packet->active = 0;
#if PLT_WITH_HULLS
    packet->ready = packet->changed = 0;
    packet->unbounded = packet->surfaces = packet->moved = 0;
#endif
    packet->any = (uint8_t)(any != 0);
}

/* Origin and signs of one ray, which all others are compared with. */
static void copy_ray(plt_packet *p, unsigned group, unsigned lane) {
    const plt_group_slabs *s = &p->slabs.group[group];
    const plt_group_rays *g = &p->rays[group];
    plt_group_make_ready(p, group);
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        p->org[a] = g->org[a][lane];
        p->slabs.near_org[a] = s->near_org[a][lane];
        p->slabs.far_org[a] = s->far_org[a][lane];
        p->slabs.negative[a] = g->dir[a][lane] < 0.0f;
        p->slabs.backwards[a] = 0u - p->slabs.negative[a];
    }
    p->org[3] = p->slabs.near_org[3] = p->slabs.far_org[3] = 0.0f;
    p->slabs.backwards[3] = 0;
#if PLT_WITH_HULLS
    const float *o = p->org;
    plt_packet_set_reach(
        p, g->reach[lane],
        larger(larger(__builtin_fabsf(o[0]), __builtin_fabsf(o[1])), __builtin_fabsf(o[2])));
#else
    p->reach = g->reach[lane];
    p->least_slack = g->least_slack[lane];
#endif
}

static inline void share(plt_packet *p, const plt_common *c) {
    for (int a = 0; a < 3; a++) {
        p->forward[a] = c->forward[a];
    }
    p->forward[3] = 0.0f;
    if ((c->axes & (c->axes - 1)) == 0) {
        p->axis = (uint8_t)(c->axes >> 1); /* 1, 2, 4 to 0, 1, 2 */
    }
    /* One origin needs one sign, too: moved origins follow the sign. */
    if ((c->other_sign[0] | c->other_sign[1] | c->other_sign[2]) != 0) {
        p->slabs.coherence = PLT_MIXED;
    } else if (c->is_apart != 0) {
        p->slabs.coherence = PLT_ONE_SIGN;
    }
#if PLT_WITH_HULLS
    p->along = p->axis != PLT_AXES_DIFFER && c->other_sign[p->axis] == 0;
#endif
}

static void share_nothing(plt_packet *p) {
    p->slabs.coherence = PLT_ONE_ORIGIN;
    p->axis = PLT_AXES_DIFFER;
#if PLT_WITH_HULLS
    p->along = 0;
#endif
}

void plt_packet_finish(plt_packet *p) {
    share_nothing(p);
    if (p->active == 0) {
        return;
    }
    const unsigned first = plt_mask_first(p->active);
    unsigned lane = 0;
    while (!(p->rays[first].valid >> lane & 1u)) {
        lane++;
    }
    copy_ray(p, first, lane);
    plt_common c;
#if PLT_QUICK_LANES
    plt_packet_compare_quickly(p, &c);
#else
    compare_groups(p, &c);
#endif
    share(p, &c);
}

#if PLT_WITH_HULLS
void plt_packet_share(plt_packet *p, const plt_common *c) {
    share_nothing(p);
    copy_ray(p, 0, 0);
    share(p, c);
}
#endif
