/* counted_traversal - see counted_traversal.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/counted/counted_traversal.h"

#include "engine/shade/frame_place.h"
#include "engine/trace/format_thesis.h"
#include "engine/trace/packet_rays.h"
#include "host_tools/base/heap.h"
#if PLT_WITH_HULLS
#include "engine/trace/hull_test.h"
#endif

/* ---- what is met --------------------------------------------------------------------- */

static packet_mask *met(counted_set *s, uint32_t index) {
    const uint32_t place = s->place[index];
    if (place < s->count && s->met[place].index == index) {
        return &s->met[place].rays;
    }
    counted_met *added = &s->met[s->count];
    s->place[index] = s->count++;
    added->index = index;
    packet_mask_clear(&added->rays);
    return &added->rays;
}

/* The rays of some lanes of a group. */
static void add_lanes(packet_mask *to, const plt_packet *p, unsigned group, unsigned lanes) {
    packet_mask_add(to, group, lanes & p->rays[group].valid);
}

static void add_groups(packet_mask *to, const plt_packet *p, plt_mask groups) {
    for (; groups != 0; groups &= groups - 1) {
        add_lanes(to, p, plt_mask_first(groups), 15);
    }
}

/* Of entries of groups: depth first, and in two stages. */
static inline void meet_node_by_groups(const plt_traversal *t, const plt_packet *p, uint32_t link,
                                       plt_mask groups) {
    counted_traversal *c = (counted_traversal *)(uintptr_t)t;
    add_groups(met(&c->nodes, plt_link_index(link)), p, groups);
}

#if PLT_WITH_HULLS
/* All groups below some lanes of a hull lie side by side for each lane. */
static inline void meet_node_by_hull(const plt_traversal *t, const plt_packet *p, uint32_t link,
                                     unsigned hull, unsigned lanes) {
    counted_traversal *c = (counted_traversal *)(uintptr_t)t;
    packet_mask *to = met(&c->nodes, plt_link_index(link));
    if (hull >= p->first_group) {
        add_lanes(to, p, hull - p->first_group, lanes);
        return;
    }
    for (; lanes != 0; lanes &= lanes - 1) {
        unsigned first = plt_hull_below(hull, plt_lane_first(lanes)), last = first;
        while (first < p->first_group) {
            first = plt_hull_below(first, 0);
            last = plt_hull_below(last, 3);
        }
        for (unsigned g = first; g <= last && g < p->first_group + p->groups; g++) {
            add_lanes(to, p, g - p->first_group, 15);
        }
    }
}
#endif

static inline void meet_leaf(const plt_traversal *t, const plt_packet *p, uint32_t link,
                             plt_mask groups) {
    counted_traversal *c = (counted_traversal *)(uintptr_t)t;
    uint32_t i = plt_link_index(link);
    for (uint32_t lists = plt_link_lists(link); lists > 0; i++) {
        add_groups(met(&c->triangles, i), p, groups);
        lists -= (uint32_t)plt_record_is_last(&t->scene->thesis.records[i]);
    }
}

/* ---- the engine's orders -------------------------------------------------------------- */

/* Orders call the format by these names, where `p` is the packet and `at` the entry. */
#define format_leaf(t, p, place, groups)                                                           \
    (meet_leaf(t, p, (place)->link, groups), (format_leaf)(t, p, place, groups))

#define format_decode(t, place, children)                                                          \
    (meet_node_by_groups(t, p, (place)->link, at->groups), (format_decode)(t, place, children))
#include "engine/trace/order_depth_first.h"
#include "engine/trace/order_two_stage.h"
#undef format_decode

#define format_decode(t, place, children)                                                          \
    (meet_node_by_hull(t, p, (place)->link, at->hull, at->lanes),                                  \
     (format_decode)(t, place, children))
#include "engine/trace/order_hulls.h"
#undef format_decode
#undef format_leaf

size_t plt_counted_entry_bytes(unsigned order);
size_t plt_counted_state_bytes(void);
void plt_counted_state_init(plt_traversal *t);
void plt_counted_begin(plt_traversal *t, plt_packet *p);
int plt_counted_traverse(plt_traversal *t, plt_packet *p, uint32_t visits);

#define FORMAT_NAME counted
#define FORMAT_ORDERS(ROW)                                                                         \
    ROW(DEPTH_FIRST, depth_first) FORMAT_ORDER_HULLS(ROW) ROW(TWO_STAGE, two_stage)
#include "engine/trace/traverse_format.h"

/* ---- packets --------------------------------------------------------------------------- */

static void free_set(counted_set *s) {
    heap_drop(s->place);
    heap_drop(s->met);
    *s = (counted_set){.place = NULL};
}

static int fit_set(counted_set *s, uint32_t count) {
    if (s->place != NULL && s->room >= count) {
        return 0;
    }
    free_set(s);
    s->place = heap_get_zeroed((uint64_t)count * sizeof *s->place + 1);
    s->met = heap_get((uint64_t)count * sizeof *s->met + 1);
    s->room = count;
    return s->place != NULL && s->met != NULL ? 0 : -1;
}

int counted_begin(counted_traversal *c, const plt_traversal *t) {
    const plt_stats stats = c->t.stats;
    c->t = *t;
    c->t.stats = stats;
    c->t.touched = NULL;
    if (fit_set(&c->nodes, t->scene->info.node_slots) != 0 ||
        fit_set(&c->triangles, t->scene->info.triangles) != 0) {
        counted_close(c);
        return -1;
    }
    return 0;
}

void counted_close(counted_traversal *c) {
    free_set(&c->nodes);
    free_set(&c->triangles);
}

/* What the packet of so many rays has met. */
static void tally(counted_traversal *c, const plt_packet *p, uint32_t rays) {
    c->counts.packets++;
    c->counts.signs += p->slabs.coherence != PLT_MIXED;
    for (uint32_t i = 0; i < c->nodes.count; i++) {
        packet_count_node(&c->counts, rays, packet_mask_count(&c->nodes.met[i].rays));
    }
    for (uint32_t i = 0; i < c->triangles.count; i++) {
        packet_count_triangles(&c->counts, 1, rays, packet_mask_count(&c->triangles.met[i].rays));
    }
    c->nodes.count = c->triangles.count = 0;
}

/* A packet that is set up: `asked` rays of which `there` may hit something. */
static void run(counted_traversal *c, plt_packet *p, uint32_t asked, uint32_t there) {
    c->counts.rays += asked;
    plt_traversal_begin(&c->t, p, asked);
    while (plt_counted_traverse(&c->t, p, UINT32_MAX) == PLT_MORE) {
    }
    if (there > 0) {
        tally(c, p, there);
    }
}

static uint32_t rays_of(const plt_packet *p) {
    uint32_t rays = 0;
    for (unsigned g = 0; g < p->groups; g++) {
        rays += (uint32_t)__builtin_popcount(p->rays[g].valid);
    }
    return rays;
}

void counted_trace(counted_traversal *c, plt_packet *p, const plt_ray *rays, plt_hit *hits,
                   uint32_t count, int any) {
    plt_packet_set_rays(p, &c->t.scene->box, rays, count, any);
    run(c, p, count, rays_of(p));
    plt_packet_store(p, hits, count);
}

void counted_square(counted_traversal *c, plt_packet *p, const plt_view *view,
                    const plt_pixels *pixels) {
    const uint32_t width = plt_least(pixels->side, pixels->x_end - pixels->x);
    const uint32_t rays = width * plt_least(pixels->side, pixels->y_end - pixels->y);
    plt_view_packet(view, &c->t.scene->box, p, pixels);
    run(c, p, rays, rays);
}
