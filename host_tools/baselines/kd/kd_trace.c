/* kd_trace - see kd_trace.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_trace.h"

#include <math.h>

/* What is left of a ray in a node. */
typedef struct part {
    uint32_t node;
    float from, to;
} part;

static void meet(kd_tracing *k, lone_ray *r, uint32_t triangle) {
    k->mailbox[triangle] = k->number;
    k->counts.tests++;
    lone_ray_meet(r, &k->scene->triangles->record[triangle]);
}

static void visit_leaf(kd_tracing *k, lone_ray *r, const kd_node *n) {
    const uint32_t count = n->link >> 2, *item = k->tree->item + n->at.first;
    const uint32_t strays = item[count];
    for (uint32_t i = 0; i < count; i++) {
        if (k->mailbox[item[i]] != k->number) {
            meet(k, r, item[i]);
        }
    }
    item += count + 1;
    for (uint32_t i = 0; i < strays; i++) {
        if (k->mailbox[item[i]] != k->number && kd_is_grazing(&k->scene->plane[item[i]], r->dir)) {
            meet(k, r, item[i]);
        } else {
            k->counts.sieved++;
        }
    }
}

static int is_done(const kd_tracing *k, const lone_ray *r) {
    return k->any && r->id != PLT_MISS;
}

/* Goes to the child that the ray is in first, and returns whether `later` is the other. */
static inline int step(const kd_node *n, const lone_ray *r, part *p, part *later) {
    const uint32_t axis = n->link & 3u, lower = n->link >> 2;
    const float early = lone_ray_early(r, (int)axis, n->at.plane);
    const float late = lone_ray_late(r, (int)axis, n->at.plane);
    const uint32_t first = lower + (uint32_t)r->negative[axis];
    const uint32_t second = lower + 1 - (uint32_t)r->negative[axis];
    const int meets_first = p->from <= late, meets_second = early <= p->to;
    *later = (part){second, early > p->from ? early : p->from, p->to};
    if (!meets_first) {
        *p = *later;
        return 0;
    }
    *p = (part){first, p->from, late < p->to ? late : p->to};
    return meets_second;
}

/* The root's part of a ray; 0: it has none. */
static int begin(const kd_tracing *k, const lone_ray *r, int is_far, part *p) {
    *p = (part){0, is_far ? -INFINITY : r->tmin, is_far ? INFINITY : r->tmax};
    for (int a = 0; a < 3; a++) {
        const float enter = lone_ray_early(r, a, r->negative[a] ? k->tree->hi[a] : k->tree->lo[a]);
        const float leave = lone_ray_late(r, a, r->negative[a] ? k->tree->lo[a] : k->tree->hi[a]);
        p->from = enter > p->from ? enter : p->from;
        p->to = leave < p->to ? leave : p->to;
    }
    return p->from <= p->to;
}

/* To a leaf, with what waits on the way on the stack. -1: no memory. */
static int descend(kd_tracing *k, const lone_ray *r, part *p, part *stack, unsigned *entries) {
    for (;;) {
        const kd_node *n = &k->tree->node[p->node];
        if (n->link == KD_UNSPLIT) {
            if (kd_build_node(k->tree, k->scene, p->node) != 0) {
                return -1;
            }
            continue;
        }
        k->counts.visits++;
        if ((n->link & 3u) == KD_LEAF) {
            return 0;
        }
        k->counts.planes++;
        *entries += (unsigned)step(n, r, p, &stack[*entries]);
    }
}

int kd_trace(kd_tracing *k, lone_ray *r) {
    const int is_far = kd_is_far(k->scene, r);
    part stack[KD_STACK], p;
    unsigned entries = 0;
    if (!begin(k, r, is_far, &p)) {
        return 0;
    }
    for (;;) {
        if (descend(k, r, &p, stack, &entries) != 0) {
            return -1;
        }
        visit_leaf(k, r, &k->tree->node[p.node]);
        do { /* what begins behind the hit is of no use */
            if (entries == 0 || is_done(k, r)) {
                return 0;
            }
            p = stack[--entries];
        } while (!is_far && p.from > r->tmax);
        p.to = !is_far && r->tmax < p.to ? r->tmax : p.to;
    }
}
