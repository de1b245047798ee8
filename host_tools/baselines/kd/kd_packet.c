/* kd_packet - see kd_packet.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_packet.h"

#include <math.h>

int kd_packet_fits(const kd_packet *p, const kd_scene *s) {
    int fits = 1;
    for (uint32_t i = 0; i < p->count; i++) {
        for (int a = 0; a < 3; a++) {
            fits &= p->ray[i].negative[a] == p->ray[0].negative[a];
        }
        fits &= !kd_is_far(s, &p->ray[i]);
    }
    return fits;
}

/* Lanes without a ray have no part. */
static void begin(kd_packet *p, const kd_tree *t, kd_parts *parts) {
    parts->node = 0;
    for (uint32_t i = 0; i < KD_PACKET; i++) {
        const lone_ray *r = &p->ray[i < p->count ? i : 0];
        for (int a = 0; a < 3; a++) {
            p->early[a][i] = r->early[a];
            p->late[a][i] = r->late[a];
            p->rdir[a][i] = r->rdir[a];
        }
        p->limit[i] = i < p->count ? r->tmax : -1.0f;
        parts->from[i] = r->tmin;
        parts->to[i] = p->limit[i];
        for (int a = 0; a < 3; a++) {
            const float enter = lone_ray_early(r, a, r->negative[a] ? t->hi[a] : t->lo[a]);
            const float leave = lone_ray_late(r, a, r->negative[a] ? t->lo[a] : t->hi[a]);
            parts->from[i] = enter > parts->from[i] ? enter : parts->from[i];
            parts->to[i] = leave < parts->to[i] ? leave : parts->to[i];
        }
    }
}

/* Rays that have a part. */
static uint32_t count_parts(const kd_parts *p) {
    uint32_t count = 0;
    for (int i = 0; i < KD_PACKET; i++) {
        count += p->from[i] <= p->to[i];
    }
    return count;
}

static int is_anywhere(const kd_parts *p) {
    return count_parts(p) > 0;
}

/* Parts of the child that comes first in `here`, of the other in `later`. */
static void cut(const kd_packet *p, int axis, float plane, kd_parts *here, kd_parts *later) {
    const float *early = p->early[axis], *late = p->late[axis], *rdir = p->rdir[axis];
    for (int i = 0; i < KD_PACKET; i++) {
        const float from = here->from[i], to = here->to[i];
        const float enter = (plane - early[i]) * rdir[i], leave = (plane - late[i]) * rdir[i];
        later->from[i] = enter > from ? enter : from;
        later->to[i] = to;
        here->to[i] = leave < to ? leave : to;
    }
}

/* To the child that comes first; whether `later` is to be visited, too. */
static int step(const kd_packet *p, const kd_node *n, kd_parts *here, kd_parts *later) {
    const uint32_t axis = n->link & 3u, lower = n->link >> 2;
    const uint32_t backwards = (uint32_t)p->ray[0].negative[axis];
    cut(p, (int)axis, n->at.plane, here, later);
    here->node = lower + backwards;
    later->node = lower + 1 - backwards;
    if (!is_anywhere(here)) {
        *here = *later;
        return 0;
    }
    return is_anywhere(later);
}

/* A triangle against those rays of `wanted` that it has not been tested with. */
static void meet(kd_packet *p, kd_tracing *k, uint64_t *tested, uint32_t triangle,
                 uint64_t wanted) {
    if (k->mailbox[triangle] != k->number) {
        k->mailbox[triangle] = k->number;
        tested[triangle] = 0;
    }
    uint64_t left = wanted & ~tested[triangle];
    tested[triangle] |= wanted;
    if (left != 0) {
        const uint32_t active = (uint32_t)__builtin_popcountll(left);
        packet_count_triangles(&k->packets, 1, p->count, active);
    }
    for (; left != 0; left &= left - 1) {
        const int i = __builtin_ctzll(left);
        k->counts.tests++;
        if (p->limit[i] >= 0.0f &&
            lone_ray_meet(&p->ray[i], &k->scene->triangles->record[triangle])) {
            p->limit[i] = k->any ? -1.0f : p->ray[i].tmax;
        }
    }
}

static uint64_t grazing(const kd_packet *p, const kd_plane *plane, uint64_t active) {
    uint64_t found = 0;
    for (; active != 0; active &= active - 1) {
        const int i = __builtin_ctzll(active);
        found |= (uint64_t)(kd_is_grazing(plane, p->ray[i].dir) != 0) << i;
    }
    return found;
}

static void visit_leaf(kd_packet *p, kd_tracing *k, uint64_t *tested, const kd_node *n,
                       const kd_parts *parts) {
    const uint32_t count = n->link >> 2, *item = k->tree->item + n->at.first;
    const uint32_t strays = item[count];
    uint64_t active = 0;
    for (int i = 0; i < KD_PACKET; i++) {
        active |= (uint64_t)(parts->from[i] <= parts->to[i]) << i;
    }
    for (uint32_t i = 0; i < count; i++) {
        meet(p, k, tested, item[i], active);
    }
    item += count + 1;
    for (uint32_t i = 0; i < strays; i++) {
        const uint64_t these = grazing(p, &k->scene->plane[item[i]], active);
        k->counts.sieved += (uint64_t)__builtin_popcountll(active & ~these);
        meet(p, k, tested, item[i], these);
    }
}

/* What has been found meanwhile makes parts shorter. */
static void shorten(const kd_packet *p, kd_parts *parts) {
    for (int i = 0; i < KD_PACKET; i++) {
        parts->to[i] = p->limit[i] < parts->to[i] ? p->limit[i] : parts->to[i];
    }
}

int kd_packet_trace(kd_packet *p, kd_tracing *k, uint64_t *tested) {
    unsigned entries = 0;
    kd_parts here;
    begin(p, k->tree, &here);
    p->stack[entries++] = here;
    while (entries > 0) {
        here = p->stack[--entries];
        shorten(p, &here);
        if (!is_anywhere(&here)) {
            continue;
        }
        while (k->tree->node[here.node].link == KD_UNSPLIT ||
               (k->tree->node[here.node].link & 3u) != KD_LEAF) {
            if (k->tree->node[here.node].link == KD_UNSPLIT) {
                if (kd_build_node(k->tree, k->scene, here.node) != 0) {
                    return -1;
                }
                continue;
            }
            k->counts.visits++;
            k->counts.planes += KD_PACKET / 4;
            packet_count_node(&k->packets, p->count, count_parts(&here));
            entries += (unsigned)step(p, &k->tree->node[here.node], &here, &p->stack[entries]);
        }
        k->counts.visits++;
        visit_leaf(p, k, tested, &k->tree->node[here.node], &here);
    }
    return 0;
}
