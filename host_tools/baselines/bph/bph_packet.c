/* bph_packet - see bph_packet.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bph/bph_packet.h"

static void widen(float bounds[2], float x) {
    bounds[0] = x < bounds[0] ? x : bounds[0];
    bounds[1] = x > bounds[1] ? x : bounds[1];
}

static void set_ray(bph_packet *p, uint32_t i) {
    const lone_ray *r = &p->ray[i];
    for (int a = 0; a < 3; a++) {
        p->early[a][i] = r->early[a];
        p->late[a][i] = r->late[a];
        p->rdir[a][i] = r->rdir[a];
        p->negative[a][i] = (uint8_t)r->negative[a];
        p->is_equal &= r->negative[a] == p->ray[0].negative[a];
        widen(p->hull[a].early, r->early[a]);
        widen(p->hull[a].late, r->late[a]);
        widen(p->hull[a].rdir, r->rdir[a]);
    }
    p->tmin[i] = r->tmin;
    p->limit[i] = r->tmax;
    p->tmin_least = r->tmin < p->tmin_least ? r->tmin : p->tmin_least;
    bph_set_add(&p->open, i);
}

void bph_packet_begin(bph_packet *p) {
    static const bph_hull_axis empty = {
        {PLT_BOX_FAR, -PLT_BOX_FAR}, {PLT_BOX_FAR, -PLT_BOX_FAR}, {PLT_BOX_FAR, -PLT_BOX_FAR}};
    p->open = (bph_set){{0}};
    p->is_equal = 1;
    p->tmin_least = PLT_BOX_FAR;
    for (int a = 0; a < 3; a++) {
        p->hull[a] = empty;
    }
    for (uint32_t i = 0; i < p->count; i++) {
        set_ray(p, i);
    }
    bph_packet_shorten(p);
}

void bph_packet_shorten(bph_packet *p) {
    p->limit_most = -1.0f;
    for (uint32_t i = 0; i < p->count; i++) {
        p->limit_most = p->limit[i] > p->limit_most ? p->limit[i] : p->limit_most;
    }
}
