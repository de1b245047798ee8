/* traverse_instances - packets through the tree over instances, and into their bodies
 *
 * Where a packet meets an instance, its groups are brought into the body's space and traverse the
 * body's tree with intervals that end at the nearest hits so far. A distance is the same in both
 * spaces, as directions keep the length that the matrix gives them. Of equal distances the lower id
 * wins, which counts triangles instance by instance: so what is hit does not depend on the order of
 * visits. Why no hit is lost: DESIGN.md, section 5.7.
 *
 * Source: Wald, Benthin, Slusallek, "Distributed interactive ray tracing of dynamic scenes", 2003.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "engine/trace/boxes.h"
#include "engine/trace/format.h"
#include "engine/trace/hulls.h"
#include "engine/trace/instances_state.h"
#include "engine/trace/traverse_formats.h"

#if PLT_WITH_INSTANCES

#if PLT_WITH_HULLS
/* Of fewer groups that go into a body, hulls cost more than they save: 2 % of all instructions of
 * rolling marbles, 8 % if none has hulls (DESIGN.md, section 5.7). */
enum { HULLS_FROM = 9 };
#endif

/* ---- into a body, and out of it --------------------------------------------------- */

static void describe_body(const plt_traversal *t, plt_instances_state *s, uint32_t body) {
    const plt_instanced *scene = &t->scene->instanced;
    plt_body b;
    plt_body_get(&scene->bodies, body, &b);
    s->body.box = b.box;
    s->body.format = PLT_FORMAT_THESIS;
    s->body.thesis = (plt_tree){.nodes = scene->nodes + b.first_slot,
                                .records = scene->records + b.first_record,
                                .node_slots = b.slots,
                                .records_count = b.records,
                                .treelet_nodes = scene->treelet_nodes,
                                .root = b.root};
    if (t->touched != NULL) { /* each body begins with a word of its own */
        s->inner.touched = t->touched + b.first_slot / scene->treelet_nodes / 32 + body;
    }
}

static void set_group(const plt_placed *placed, const plt_packet *p, plt_packet *q,
                      unsigned index) {
    const plt_group_rays *g = &p->rays[index];
    const plt_group_slabs *slabs = &p->slabs.group[index];
    f4 org[3], dir[3], org_there[3], dir_there[3];
    for (int a = 0; a < 3; a++) {
        org[a] = f4_load(g->org[a]);
        dir[a] = f4_load(g->dir[a]);
    }
    plt_placed_ray(placed, org, dir, org_there, dir_there);
    plt_packet_set_group(q, index, org_there, dir_there, f4_load(slabs->tmin), f4_load(slabs->tmax),
                         4);
}

static void enter(plt_traversal *t, const plt_packet *p, uint32_t instance, plt_mask groups) {
    plt_instances_state *s = plt_instances_state_of(t);
    const plt_placed *placed = &t->scene->instanced.placed[instance];
    plt_packet *q = &s->packet;
    describe_body(t, s, placed->body);
    plt_packet_begin(q, &s->body.box, p->groups, p->any);
#if PLT_WITH_HULLS
    q->surfaces = p->surfaces;
#endif
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        set_group(placed, p, q, plt_mask_first(m));
    }
    s->visited = q->active;
    s->instance = instance;
    s->is_inside = q->active != 0;
    if (!s->is_inside) {
        return;
    }
    plt_packet_finish(q);
#if PLT_WITH_HULLS
    q->along &= plt_mask_count(q->active) >= (uint32_t)HULLS_FROM;
    if (plt_order_for(&s->inner, q) == PLT_ORDER_HULLS) {
        plt_hulls_set(q);
    } else {
        plt_packet_make_ready(q);
    }
#endif
    plt_thesis_begin(&s->inner, q);
}

static inline void keep(float to[4], m4 take, f4 value) {
    f4_store(to, f4_select(take, value, f4_load(to)));
}

static void take_surface(const plt_placed *placed, int surfaces, const plt_group_rays *from,
                         plt_group_rays *to, m4 take) {
    if (surfaces) {
        const f4 there[3] = {f4_load(from->normal[0]), f4_load(from->normal[1]),
                             f4_load(from->normal[2])};
        f4 normal[3];
        plt_placed_normal(placed, there, normal);
        for (int a = 0; a < 3; a++) {
            keep(to->normal[a], take, normal[a]);
        }
    }
    if (!surfaces || !PLT_WITH_HULLS) {
        keep(to->u, take, f4_load(from->u));
        keep(to->v, take, f4_load(from->v));
    }
}

/* Hits in the body that are nearer than those before, or as near and of a lower id. */
static void take_hits(const plt_instances_state *s, const plt_placed *placed, plt_packet *p,
                      unsigned index) {
    const plt_packet *q = &s->packet;
    plt_group_slabs *to = &p->slabs.group[index];
    plt_group_rays *g = &p->rays[index];
    const u4 there = u4_load(q->rays[index].id), before = u4_load(g->id);
    const u4 id = u4_add(there, u4_all(placed->first_id));
    const f4 t = f4_load(q->slabs.group[index].tmax), tmax = f4_load(to->tmax);
    const m4 missed = u4_eq(there, u4_all(PLT_MISS));
    const m4 tie = m4_and(f4_eq(t, tmax), u4_lt(id, before));
    const m4 take = m4_andnot(p->any ? m4_bits(15) : m4_or(f4_lt(t, tmax), tie), missed);
    keep(to->tmax, take, t);
    u4_store(g->id, u4_select(take, id, before));
    if (p->any) {
        const unsigned seeking = m4_mask(f4_le(f4_load(to->tmin), f4_load(to->tmax)));
        p->active &= ~plt_mask_of(index, seeking == 0);
        return;
    }
#if PLT_WITH_HULLS
    take_surface(placed, p->surfaces, &q->rays[index], g, take);
#else
    take_surface(placed, 1, &q->rays[index], g, take);
#endif
}

static void leave(plt_traversal *t, plt_packet *p) {
    plt_instances_state *s = plt_instances_state_of(t);
    const plt_placed *placed = &t->scene->instanced.placed[s->instance];
    for (plt_mask m = s->visited; m != 0; m &= m - 1) {
        take_hits(s, placed, p, plt_mask_first(m));
    }
    s->is_inside = 0;
}

/* Goes on inside; returns the nodes visited there, and 1. */
static uint32_t visit_body(plt_traversal *t, plt_packet *p, uint32_t visits) {
    plt_instances_state *s = plt_instances_state_of(t);
    const uint64_t before = t->stats.node_visits;
    s->inner.stats = t->stats;
    const int status = plt_thesis_traverse(&s->inner, &s->packet, visits);
    t->stats = s->inner.stats;
    const uint64_t used = t->stats.node_visits - before + 1;
    if (status == PLT_MORE) {
        return visits;
    }
    leave(t, p);
    return used < visits ? (uint32_t)used : visits;
}

/* ---- the tree over instances ------------------------------------------------------ */

static const plt_box *box_of(const plt_instanced *scene, const plt_top_entry *e) {
    return e->parent == PLT_MISS ? &scene->placed[e->child & ~PLT_TOP_LEAF].box
                                 : &scene->top[e->parent / 2].box[e->parent % 2];
}

static plt_top_entry child_of(const plt_instanced *scene, uint32_t node, unsigned child,
                              plt_mask groups) {
    const plt_top_entry e = {scene->top[node].child[child], 2 * node + child, groups};
    return e;
}

/* Visits the node of an entry, and goes on to the nearer child that is met; the other one, if it
 * is met, too, waits. 0: none is. */
static int visit_node(plt_traversal *t, const plt_packet *p, plt_top_entry *at) {
    plt_instances_state *s = plt_instances_state_of(t);
    const plt_instanced *scene = &t->scene->instanced;
    const uint32_t node = at->child;
    const plt_box *box = scene->top[node].box;
    plt_mask hit[2];
    t->stats.group_tests += 2 * plt_box_pair(&p->slabs, box, at->groups, hit);
    t->stats.node_visits++;
    unsigned near = plt_nearer_child(p, box);
    if (hit[near] == 0) {
        near ^= 1;
    } else if (hit[near ^ 1] != 0) {
        s->entry[s->waiting++] = child_of(scene, node, near ^ 1, hit[near ^ 1]);
    }
    if (hit[near] == 0) {
        return 0;
    }
    *at = child_of(scene, node, near, hit[near]);
    return 1;
}

/* From an entry down to an instance, or to nothing. Returns nodes visited, and 1. */
static uint32_t descend(plt_traversal *t, const plt_packet *p) {
    plt_instances_state *s = plt_instances_state_of(t);
    const plt_instanced *scene = &t->scene->instanced;
    plt_top_entry at = s->entry[--s->waiting];
    uint32_t used = 1;
    at.groups &= p->active;
    at.groups = at.groups != 0 && (at.parent != PLT_MISS || (at.child & PLT_TOP_LEAF) != 0)
                    ? plt_box_groups(&p->slabs, box_of(scene, &at), at.groups)
                    : at.groups;
    if (at.groups == 0) {
        return used;
    }
    for (; (at.child & PLT_TOP_LEAF) == 0; used++) {
        if (!visit_node(t, p, &at)) {
            return used;
        }
    }
    enter(t, p, at.child & ~PLT_TOP_LEAF, at.groups);
    return used;
}

/* ---- the functions of traverse_formats.h ------------------------------------------ */

/* The stack is that of the bodies; the top tree's is in the state. */
size_t plt_instances_entry_bytes(unsigned order) {
    return plt_thesis_entry_bytes(order);
}

size_t plt_instances_state_bytes(void) {
    return sizeof(plt_instances_state);
}

void plt_instances_state_init(plt_traversal *t) {
    plt_instances_state *s = plt_instances_state_of(t);
    memset(s, 0, sizeof *s);
    s->inner = *t;
    s->inner.scene = &s->body;
    s->inner.state = &s->treelet;
    s->inner.touched = NULL;
    plt_thesis_state_init(&s->inner);
}

/* Origins are moved so that no box is missed whose instance is met. */
static void widen(const plt_traversal *t, plt_packet *p) {
    const float spread = t->scene->instanced.spread;
    plt_slab_array *all = &p->slabs;
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        const unsigned index = plt_mask_first(m);
        plt_group_slabs *slabs = &all->group[index];
        const plt_group_rays *g = &p->rays[index];
        for (int a = 0; a < 3; a++) {
            const f4 margin = plt_placed_margin(spread, f4_load(g->reach), f4_load(g->org[a]));
            const m4 back = f4_lt(f4_load(g->dir[a]), f4_zero());
            const f4 towards = f4_select(back, f4_neg(margin), margin);
            f4_store(slabs->near_org[a], f4_add(f4_load(slabs->near_org[a]), towards));
            f4_store(slabs->far_org[a], f4_sub(f4_load(slabs->far_org[a]), towards));
        }
    }
    if (p->active != 0 && all->coherence == PLT_ONE_ORIGIN) {
        const plt_group_slabs *first = &all->group[plt_mask_first(p->active)];
        const unsigned lane = (unsigned)__builtin_ctz(p->rays[plt_mask_first(p->active)].valid);
        for (int a = 0; a < 3; a++) {
            all->near_org[a] = first->near_org[a][lane];
            all->far_org[a] = first->far_org[a][lane];
        }
    }
}

void plt_instances_begin(plt_traversal *t, plt_packet *p) {
    plt_instances_state *s = plt_instances_state_of(t);
    const plt_instanced *scene = &t->scene->instanced;
    plt_packet_make_ready(p);
    widen(t, p);
    s->is_inside = 0;
    s->waiting = p->active != 0;
    s->entry[0] = (plt_top_entry){scene->root, PLT_MISS, p->active};
    t->waiting = s->waiting;
}

int plt_instances_traverse(plt_traversal *t, plt_packet *p, uint32_t visits) {
    plt_instances_state *s = plt_instances_state_of(t);
    while (t->waiting > 0 && visits > 0) {
        const uint32_t used = s->is_inside ? visit_body(t, p, visits) : descend(t, p);
        visits -= used < visits ? used : visits;
        t->waiting = p->active != 0 || s->is_inside ? s->waiting + s->is_inside : 0;
    }
    return t->waiting > 0 ? PLT_MORE : PLT_OK;
}

#endif
