/* planes_packet - packets through trees of one axis per node, once for every layout
 *
 * Written against the same nodes as planes_lone.h, whose instances include this, too.
 *
 * A packet goes by what is left of each of its rays: at a node the planes of both children are
 * passed by four rays at a time, each once, and the interval of a child is the node's, clipped. Or
 * it goes by the box that planes have left of the scene's, which is kept on the stack and met
 * anew; six planes instead of those of one axis, but the first rays or the hull of all may answer
 * for the others (packet_box.h), and a place of the stack takes 60 bytes instead of 2 KiB.
 *
 * The child on the side that the rays come from, or the first of them, is first (thesis, section
 * 3.5.4).
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_PLANES_PACKET_H
#define BASELINES_PLANES_PACKET_H

#include "host_tools/baselines/packet/packet_triangles.h"
#include "host_tools/baselines/planes/planes_trace.h"

/* ---- by what is left of rays ---------------------------------------------------------- */

/* Those of a place whose interval has something left, now that hits may have been found. */
static inline unsigned planes_rest_narrow(packet_state *p, planes_rest *at) {
    packet_mask in;
    unsigned all = 0;
    packet_mask_clear(&in);
    for (unsigned g = packet_mask_next(&at->in, 0); g < PACKET_GROUPS;
         g = packet_mask_next(&at->in, g + 1)) {
        const f4 to = f4_min(f4_load(at->to[g]), f4_load(p->rays.slabs.group[g].tmax));
        const unsigned lanes =
            m4_mask(f4_le(f4_load(at->from[g]), to)) & packet_mask_lanes(&at->in, g);
        f4_store(at->to[g], to);
        packet_mask_add(&in, g, lanes);
        all |= lanes;
    }
    at->in = in;
    return all;
}

/* Clips what is left of a group by both planes across an axis. */
PLT_INLINED void planes_rest_clip(const plt_planes *b, unsigned axis, const plt_group_slabs *s,
                                  enum plt_coherence kind, f4 *from, f4 *to) {
    const f4 rate = f4_load(s->rdir[axis]);
    f4 near, far;
    plt_plane_depths(b, (int)axis, s, rate, rate, kind, &near, &far);
    *from = f4_max(near, *from);
    *to = f4_min(far, *to);
}

/* Keeps it, with those of `lanes` that have something left. */
static inline unsigned planes_rest_keep(planes_rest *at, unsigned g, f4 from, f4 to,
                                        unsigned lanes) {
    const unsigned left = m4_mask(f4_le(from, to)) & lanes;
    f4_store(at->from[g], from);
    f4_store(at->to[g], to);
    packet_mask_add(&at->in, g, left);
    return left;
}

/* Both children of a node: the second in the place of the node itself, the first in another. */
PLT_INLINED void planes_rest_part(packet_state *p, const planes_view *v, planes_rest *first,
                                  planes_rest *second, enum plt_coherence kind) {
    const unsigned swap = packet_is_backwards(p, v->axis);
    const packet_mask in = second->in;
    planes_rest *const to[2] = {first, second};
    plt_planes b[2];
    for (unsigned c = 0; c < 2; c++) {
        const f4 lo = f4_all(v->lo[c ^ swap]), hi = f4_all(v->hi[c ^ swap]);
        plt_planes_set(&b[c], &p->rays.slabs, lo, hi, kind);
        to[c]->link = v->link[c ^ swap];
        packet_mask_clear(&to[c]->in);
    }
    for (unsigned g = packet_mask_next(&in, 0); g < PACKET_GROUPS;
         g = packet_mask_next(&in, g + 1)) {
        const f4 from = f4_load(second->from[g]), upto = f4_load(second->to[g]);
        p->counts.group_tests++;
        for (unsigned c = 0; c < 2; c++) {
            f4 enter = from, leave = upto;
            planes_rest_clip(&b[c], v->axis, &p->rays.slabs.group[g], kind, &enter, &leave);
            planes_rest_keep(to[c], g, enter, leave, packet_mask_lanes(&in, g));
        }
    }
}

/* The whole packet, at the root; whether a ray meets the scene's box. */
PLT_INLINED int planes_rest_begin(planes_tracing *t, planes_rest *at, enum plt_coherence kind) {
    packet_state *p = &t->packet;
    unsigned all = 0;
    packet_mask whole;
    plt_planes b;
    plt_planes_set(&b, &p->rays.slabs, packet_box_lo(&t->box), packet_box_hi(&t->box), kind);
    packet_all(p, &whole);
    packet_mask_clear(&at->in);
    at->link = planes_node_root(t->nodes);
    for (unsigned g = packet_mask_next(&whole, 0); g < PACKET_GROUPS;
         g = packet_mask_next(&whole, g + 1)) {
        const plt_group_slabs *s = &p->rays.slabs.group[g];
        f4 from = f4_load(s->tmin), to = f4_load(s->tmax);
        for (unsigned a = 0; a < 3; a++) {
            planes_rest_clip(&b, a, s, kind, &from, &to);
        }
        all |= planes_rest_keep(at, g, from, to, packet_mask_lanes(&whole, g));
    }
    return all != 0;
}

static void planes_packet_leaf(planes_tracing *t, uint32_t link, plt_mask groups, uint32_t active) {
    t->counts.leaves++;
    packet_meet_triangles(&t->packet, t->record + planes_node_leaf(t->nodes, link), t->longest,
                          groups, active);
}

PLT_INLINED void planes_packet_by_rest(planes_tracing *t, enum plt_coherence kind) {
    packet_state *p = &t->packet;
    planes_rest *place[PLANES_DEPTH]; /* of the stack, so that two can be exchanged */
    unsigned entries = 1;
    for (unsigned i = 0; i < PLANES_DEPTH; i++) {
        place[i] = &t->rest[i];
    }
    if (!planes_rest_begin(t, place[0], kind)) {
        return;
    }
    while (entries > 0 && !packet_is_done(p)) {
        planes_rest *at = place[entries - 1];
        const int is_left = planes_rest_narrow(p, at) != 0;
        if (!is_left || planes_node_is_leaf(t->nodes, at->link)) {
            entries--;
            if (is_left) {
                planes_packet_leaf(t, at->link, packet_mask_groups(&at->in),
                                   packet_mask_count(&at->in));
            }
            continue;
        }
        const planes_view v = planes_node_view(t->nodes, at->link);
        packet_count_node(&p->counts, p->count, packet_mask_count(&at->in));
        planes_rest_part(p, &v, place[entries], at, kind);
        entries++;
    }
}

/* ---- by what is left of the scene's box ------------------------------------------------- */

static inline plt_box planes_room_child(const plt_box *in, const planes_view *v, unsigned c) {
    plt_box b = *in;
    b.lo[v->axis] = v->lo[c] > b.lo[v->axis] ? v->lo[c] : b.lo[v->axis];
    b.hi[v->axis] = v->hi[c] < b.hi[v->axis] ? v->hi[c] : b.hi[v->axis];
    return b;
}

/* Whether rays of a place may meet its box, and those that may. */
PLT_INLINED int planes_room_meet(planes_tracing *t, planes_room *at, packet_steps steps,
                                 enum plt_coherence kind) {
    const f4 lo = packet_box_lo(&at->box), hi = packet_box_hi(&at->box);
    const packet_mask in = at->in;
    return t->way.bits ? packet_meet_bits(&t->packet, lo, hi, kind, steps, &in, &at->in)
                       : packet_meet_range(&t->packet, lo, hi, kind, steps, &at->range);
}

static inline plt_mask planes_room_groups(const planes_tracing *t, const planes_room *at) {
    return t->way.bits ? packet_mask_groups(&at->in) : packet_range_groups(&at->range);
}

static inline uint32_t planes_room_rays(const planes_tracing *t, const planes_room *at) {
    return t->way.bits ? packet_mask_count(&at->in) : packet_range_rays(&t->packet, &at->range);
}

/* The second child in the place of the node itself, the first above it. */
static inline void planes_room_part(const planes_view *v, unsigned swap, planes_room *at) {
    const plt_box box = at->box;
    at[1] = at[0];
    for (unsigned i = 0; i < 2; i++) {
        const unsigned c = (i == 0) ^ swap;
        at[i].link = v->link[c];
        at[i].box = planes_room_child(&box, v, c);
    }
}

PLT_INLINED void planes_packet_by_room(planes_tracing *t, enum plt_coherence kind) {
    packet_state *p = &t->packet;
    packet_steps steps = {0, 0}; /* of the scene's box, which no node has */
    unsigned entries = 1;
    t->room[0] =
        (planes_room){.link = planes_node_root(t->nodes), .range = p->whole, .box = t->box};
    packet_all(p, &t->room[0].in);
    while (entries > 0 && !packet_is_done(p)) {
        planes_room *at = &t->room[entries - 1];
        const int meets = planes_room_meet(t, at, steps, kind);
        steps = t->way.steps;
        if (!meets || planes_node_is_leaf(t->nodes, at->link)) {
            entries--;
            if (meets) {
                planes_packet_leaf(t, at->link, planes_room_groups(t, at), planes_room_rays(t, at));
            }
            continue;
        }
        const planes_view v = planes_node_view(t->nodes, at->link);
        packet_count_node(&p->counts, p->count, planes_room_rays(t, at));
        planes_room_part(&v, packet_is_backwards(p, v.axis), at);
        entries++;
    }
}

/* ---- the packet that has begun --------------------------------------------------------- */

PLT_INLINED void planes_packet_go(planes_tracing *t, enum plt_coherence kind) {
    if (t->way.boxes) {
        planes_packet_by_room(t, kind);
    } else {
        planes_packet_by_rest(t, kind);
    }
}

static void planes_trace_packet(planes_tracing *t) {
    switch (t->packet.rays.slabs.coherence) {
    case PLT_ONE_ORIGIN:
        planes_packet_go(t, PLT_ONE_ORIGIN);
        break;
    case PLT_ONE_SIGN:
        planes_packet_go(t, PLT_ONE_SIGN);
        break;
    default:
        planes_packet_go(t, PLT_MIXED);
    }
}

#endif
