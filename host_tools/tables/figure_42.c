/* figure_42 - see figure_42.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/figure_42.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/base/triangle_set.h"
#include "host_tools/baselines/bph/bph_planes.h"

/* ---- the tree ------------------------------------------------------------------ */

static int build(figure_42 *t, const mesh *m) {
    const binary_options how = {.splits = PLT_SPLIT_MEDIAN, .leaf = 1};
    const bph_format format = {.most = 1};
    triangle_set set = {.record = NULL};
    binary_tree binary = {.node = NULL};
    int status = triangle_set_fill(&set, m);
    if (status == 0) {
        status = binary_tree_build(&binary, set.record, set.count, &set.box, &how);
    }
    if (status == 0 && set.count > 0) {
        status = bph_convert(&t->tree, &binary, &format) == BPH_CONVERTED ? 0 : -1;
    }
    binary_tree_free(&binary);
    triangle_set_free(&set);
    return status;
}

static int form(figure_42 *t, uint32_t size) {
    const treelet_wish wish = {.size = size};
    uint32_t(*child)[2] = heap_get((uint64_t)t->tree.nodes * sizeof *child);
    int status = child != NULL ? 0 : -1;
    for (uint32_t i = 0; i < t->tree.nodes && status == 0; i++) {
        for (int c = 0; c < 2; c++) {
            const uint32_t link = bph_tree_edge(&t->tree, i, c).link;
            child[i][c] = plt_link_is_leaf(link) ? TREELET_NO_NODE : plt_link_index(link);
        }
    }
    if (status == 0) {
        const treelet_tree tree = {.child = (const uint32_t(*)[2])child, .nodes = t->tree.nodes};
        status = treelets_form(&t->layout, &tree, &wish);
    }
    heap_drop(child);
    return status == 0 ? 0 : -1;
}

int figure_42_open(figure_42 *t, const mesh *m, uint32_t size) {
    memset(t, 0, sizeof *t);
    int status = build(t, m);
    if (status == 0 && t->tree.nodes > 0) {
        status = form(t, size);
    }
    if (status != 0) {
        figure_42_close(t);
    }
    return status;
}

void figure_42_close(figure_42 *t) {
    heap_drop(t->global.entry);
    heap_drop(t->local.entry);
    treelets_free(&t->layout);
    bph_tree_free(&t->tree);
    memset(t, 0, sizeof *t);
}

/* ---- packets ------------------------------------------------------------------- */

static void push(figure_42 *t, figure_42_stack *s, const figure_42_entry *e) {
    if (s->count == s->room) {
        const uint32_t room = 2 * s->room + 256;
        figure_42_entry *grown = heap_resize(s->entry, (uint64_t)room * sizeof *grown);
        if (grown == NULL) {
            t->is_short = 1;
            return;
        }
        s->entry = grown;
        s->room = room;
    }
    s->entry[s->count++] = *e;
}

/* Cuts the intervals of the entry's rays; those that have nothing left are out. 0: all are. */
static int cut(const figure_42 *t, const bph_planes *planes, figure_42_entry *e) {
    bph_set left = {{0}};
    for (uint32_t i = 0; i < t->packet.count; i++) {
        if (bph_set_has(&e->rays, i)) {
            e->to[i] = t->packet.limit[i] < e->to[i] ? t->packet.limit[i] : e->to[i];
            if (bph_planes_cut(planes, &t->packet, i, &e->from[i], &e->to[i])) {
                bph_set_add(&left, i);
            }
        }
    }
    e->rays = left;
    return !bph_set_is_empty(&left);
}

static int is_hidden(const figure_42 *t, figure_42_entry *e) {
    const bph_planes none = {.count = 0};
    return !cut(t, &none, e);
}

static void meet_lists(figure_42 *t, const figure_42_entry *e) {
    bph_packet *p = &t->packet;
    const uint32_t end = bph_edge_end(&t->tree, &e->edge);
    for (uint32_t k = plt_link_index(e->edge.link); k < end; k++) {
        t->triangles++;
        for (uint32_t i = 0; i < p->count; i++) {
            if (bph_set_has(&e->rays, i) && lone_ray_meet(&p->ray[i], &t->tree.record[k])) {
                p->limit[i] = p->ray[i].tmax;
            }
        }
    }
}

/* Whether an edge stays within the treelet of node `from`. */
static int is_local(const figure_42 *t, uint32_t from, const figure_42_entry *child) {
    return !plt_link_is_leaf(child->edge.link) &&
           !treelets_leaves(&t->layout, from, plt_link_index(child->edge.link));
}

/* Which of two children is pushed first: the left one, or as near_last says. */
static int first_of(const figure_42 *t, uint32_t node, const figure_42_entry child[2]) {
    const float left = child[0].from[bph_set_first(&child[0].rays)];
    const float right = child[1].from[bph_set_first(&child[1].rays)];
    const int near = right < left;
    if (!t->near_last) {
        return 0;
    }
    return is_local(t, node, &child[0]) && is_local(t, node, &child[1]) ? near : 1 - near;
}

static void push_child(figure_42 *t, uint32_t node, const figure_42_entry *child) {
    push(t, is_local(t, node, child) ? &t->local : &t->global, child);
}

static void visit(figure_42 *t, const figure_42_entry *at) {
    const uint32_t node = plt_link_index(at->edge.link);
    figure_42_entry child[2] = {*at, *at};
    int is_met[2];
    t->nodes++;
    for (int c = 0; c < 2; c++) {
        const bph_planes owned = bph_planes_owned(&t->tree.node[node], c);
        child[c].edge = bph_tree_edge(&t->tree, node, c);
        is_met[c] = cut(t, &owned, &child[c]);
    }
    const int first = is_met[0] && is_met[1] ? first_of(t, node, child) : 0;
    for (int i = 0; i < 2; i++) {
        const int c = i == 0 ? first : 1 - first;
        if (is_met[c]) {
            push_child(t, node, &child[c]);
        }
    }
}

static void traverse(figure_42 *t) {
    const bph_planes box = bph_planes_of_box(&t->tree.box);
    figure_42_entry at = {.edge = t->tree.root, .rays = t->packet.open};
    memcpy(at.from, t->packet.tmin, sizeof at.from);
    memcpy(at.to, t->packet.limit, sizeof at.to);
    t->packets++;
    if (cut(t, &box, &at)) {
        push(t, &t->global, &at);
    }
    while (t->global.count > 0) {
        at = t->global.entry[--t->global.count];
        if (is_hidden(t, &at)) {
            continue;
        }
        if (plt_link_is_leaf(at.edge.link)) {
            meet_lists(t, &at);
            continue;
        }
        push(t, &t->local, &at);
        while (t->local.count > 0) {
            at = t->local.entry[--t->local.count];
            visit(t, &at);
        }
    }
}

static void trace_packet(figure_42 *t, const plt_ray *rays, plt_hit *hits) {
    bph_packet *p = &t->packet;
    uint8_t of[FIGURE_42_RAYS];
    p->count = 0;
    for (uint8_t i = 0; i < FIGURE_42_RAYS; i++) {
        lone_ray_store_miss(&hits[i], 0);
        of[p->count] = i;
        p->count += lone_ray_set(&p->ray[p->count], &t->tree.box, &rays[i]) != 0;
    }
    if (p->count > 0) {
        bph_packet_begin(p);
        traverse(t);
    }
    for (uint32_t i = 0; i < p->count; i++) {
        lone_ray_store(&p->ray[i], &hits[of[i]], 0);
    }
}

int figure_42_trace(figure_42 *t, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    for (uint32_t at = 0; at + FIGURE_42_RAYS <= count; at += FIGURE_42_RAYS) {
        trace_packet(t, rays + at, hits + at);
    }
    return t->is_short ? -1 : 0;
}
