/* bph_trace - see bph_trace.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bph/bph_trace.h"

#include <stddef.h>

static int is_mixed(const bph_tracing *t) {
    return t->way.is_mixed || !t->packet.is_equal;
}

static int keeps_boxes(const bph_way *way) {
    return way->is_naive || way->hits_early || way->has_frustum;
}

uint32_t bph_trace_entry_bytes(const bph_way *way, uint32_t rays) {
    const uint32_t mask = way->active == BPH_MASK    ? (rays + 7) / 8
                          : way->active == BPH_RANGE ? 2
                                                     : 0;
    return 4 + mask + (keeps_boxes(way) ? (uint32_t)sizeof(plt_box) : 0) + way->hits_early +
           (way->is_naive ? 0 : rays * 2 * (uint32_t)sizeof(float));
}

/* ---- rays ------------------------------------------------------------------------ */

static void tally_planes(bph_tracing *t, const bph_planes *b, const bph_set *rays) {
    const uint32_t count = bph_set_count(rays);
    t->tally.distances += (uint64_t)b->count * count;
    t->tally.matches += (uint64_t)b->count * (is_mixed(t) ? count : 1);
}

/* The rays of `hit`, which go on, and those between them, or all. */
static void narrow(const bph_tracing *t, bph_entry *e, const bph_set *hit, const bph_set *before) {
    const uint32_t first = bph_set_first(hit);
    e->nearest = e->at.from[first];
    e->rays = *hit;
    if (t->way.active == BPH_RANGE) {
        const bph_set range = bph_set_range(first, bph_set_last(hit));
        e->rays = bph_set_both(&range, before);
    } else if (t->way.active == BPH_ALL) {
        e->rays = *before;
    }
}

/* Cuts the intervals of `rays` from `in`; whether something is left of any. */
static int cut(bph_tracing *t, const bph_planes *b, const bph_intervals *in, bph_entry *e) {
    const bph_set rays = e->rays;
    bph_planes_cut_all(b, &t->packet, bph_set_first(&rays), bph_set_last(&rays), is_mixed(t), in,
                       &e->at);
    tally_planes(t, b, &rays);
    const bph_set hit = bph_intervals_left(&e->at, &rays);
    if (bph_set_is_empty(&hit)) {
        return 0;
    }
    e->is_incomplete = 0;
    narrow(t, e, &hit, &rays);
    return 1;
}

/* Intervals as they are before anything is met. */
static void begin_intervals(const bph_packet *p, bph_intervals *to) {
    memcpy(to->from, p->tmin, sizeof p->tmin);
    memcpy(to->to, p->limit, sizeof p->limit);
}

static int test_box(bph_tracing *t, const plt_box *box, bph_entry *e) {
    const bph_planes planes = bph_planes_of_box(box);
    begin_intervals(&t->packet, &e->at);
    return cut(t, &planes, &e->at, e);
}

/* The first of the entry's rays, whose interval before is from .. to. */
static int hits_early(bph_tracing *t, const bph_planes *b, float from, float to, bph_entry *e) {
    const uint32_t first = bph_set_first(&e->rays);
    t->tally.early_tests++;
    t->tally.distances += b->count;
    t->tally.matches += b->count;
    if (!bph_planes_cut(b, &t->packet, first, &from, &to)) {
        return 0;
    }
    t->tally.early_hits++;
    e->nearest = from;
    e->is_incomplete = !t->way.is_naive;
    return 1;
}

static int hits_box_early(bph_tracing *t, const plt_box *box, bph_entry *e) {
    const bph_planes planes = bph_planes_of_box(box);
    const uint32_t first = bph_set_first(&e->rays);
    return hits_early(t, &planes, t->packet.tmin[first], t->packet.limit[first], e);
}

static int misses_frustum(bph_tracing *t, const plt_box *box) {
    if (!t->way.has_frustum || is_mixed(t)) {
        return 0;
    }
    const bph_planes planes = bph_planes_of_box(box);
    const int misses = bph_planes_miss(&planes, &t->packet);
    t->tally.frustum_tests++;
    t->tally.frustum_exits += (uint64_t)misses;
    return misses;
}

/* A box of which nothing is known: early hit, early miss, all rays. */
static int meet_box(bph_tracing *t, const plt_box *box, bph_entry *e) {
    return (t->way.hits_early && hits_box_early(t, box, e)) ||
           (!misses_frustum(t, box) && test_box(t, box, e));
}

/* ---- triangles ------------------------------------------------------------------- */

static void meet_triangle(bph_tracing *t, const plt_record *triangle, const bph_set *rays) {
    bph_packet *p = &t->packet;
    for (uint32_t w = 0; w < BPH_WORDS; w++) {
        for (uint64_t rest = rays->word[w] & p->open.word[w]; rest != 0; rest &= rest - 1) {
            const uint32_t i = 64 * w + (uint32_t)__builtin_ctzll(rest);
            t->tally.tests++;
            if (lone_ray_meet(&p->ray[i], triangle)) {
                t->hits++;
                p->limit[i] = t->any ? -1.0f : p->ray[i].tmax;
                p->open.word[w] &= t->any ? ~(1ull << i % 64) : UINT64_MAX;
            }
        }
    }
}

static void meet_list(bph_tracing *t, uint32_t first, uint32_t end, const bph_set *rays) {
    packet_count_triangles(&t->counts, end - first, t->packet.count, bph_set_count(rays));
    for (uint32_t i = first; i < end; i++) {
        meet_triangle(t, &t->tree->record[i], rays);
    }
}

/* Its lists' boxes are made anew from their triangles. */
static void meet_recomputed(bph_tracing *t, const bph_entry *at) {
    const uint32_t first = plt_link_index(at->edge.link);
    const uint32_t middle = bph_list_end(t->tree, first);
    const uint32_t place[3] = {first, middle, bph_list_end(t->tree, middle)};
    for (int i = 0; i < 2; i++) {
        const plt_box box = plt_records_box(t->tree->record, place[i], place[i + 1]);
        bph_entry *list = &t->child[0];
        list->rays = bph_set_both(&at->rays, &t->packet.open);
        t->tally.recomputed++;
        if (!bph_set_is_empty(&list->rays) && meet_box(t, &box, list)) {
            meet_list(t, place[i], place[i + 1], &list->rays);
        }
    }
}

static void meet_lists(bph_tracing *t, const bph_entry *at) {
    const uint64_t hits = t->hits;
    if (t->way.recomputes && plt_link_lists(at->edge.link) == 2) {
        meet_recomputed(t, at);
    } else {
        meet_list(t, plt_link_index(at->edge.link), bph_edge_end(t->tree, &at->edge), &at->rays);
    }
    if (hits != t->hits) {
        bph_packet_shorten(&t->packet);
    }
}

/* ---- nodes ----------------------------------------------------------------------- */

enum { OUT, IN, DOUBT };

/* What early hit and frustum know of a child. */
static int judge(bph_tracing *t, const bph_entry *at, const bph_planes *owned, bph_entry *child) {
    if (t->way.hits_early) {
        const uint32_t first = bph_set_first(&at->rays);
        const int hits = t->way.is_naive || at->is_incomplete
                             ? hits_box_early(t, &child->box, child)
                             : hits_early(t, owned, at->at.from[first], at->at.to[first], child);
        if (hits) {
            return IN;
        }
    }
    return misses_frustum(t, &child->box) ? OUT : DOUBT;
}

/* Each box that is in doubt, as a box. */
static void test_boxes(bph_tracing *t, const bph_entry *at, int is[2]) {
    for (int c = 0; c < 2; c++) {
        if (is[c] == DOUBT) {
            t->tally.reconstructions += at->is_incomplete;
            is[c] = test_box(t, &t->child[c].box, &t->child[c]) ? IN : OUT;
        }
    }
}

/* Both children in one pass. One that was entered early comes out so; one that the frustum misses
 * is missed by all rays. */
static void clip_both(bph_tracing *t, const bph_entry *at, const bph_planes owned[2], int is[2]) {
    for (int c = 0; c < 2; c++) {
        is[c] = cut(t, &owned[c], &at->at, &t->child[c]) ? IN : OUT;
    }
}

static void begin_children(bph_tracing *t, const bph_entry *at, const plt_node *node) {
    plt_box box[2];
    if (keeps_boxes(&t->way)) {
        plt_node_decode(node, &at->box, box);
    }
    for (int c = 0; c < 2; c++) {
        bph_entry *child = &t->child[c];
        child->edge = bph_tree_edge(t->tree, plt_link_index(at->edge.link), c);
        child->rays = at->rays;
        child->hits = t->hits;
        child->is_incomplete = 0;
        if (keeps_boxes(&t->way)) {
            child->box = box[c];
        }
    }
}

/* Of intervals no more than there are. */
static void copy_entry(const bph_tracing *t, bph_entry *to, const bph_entry *from) {
    memcpy(to, from, offsetof(bph_entry, at));
    if (!t->way.is_naive && !from->is_incomplete) {
        memcpy(to->at.from, from->at.from, t->packet.count * sizeof(float));
        memcpy(to->at.to, from->at.to, t->packet.count * sizeof(float));
    }
}

/* Those that are met onto the stack, the first to be visited last. */
static uint32_t push_children(bph_tracing *t, uint32_t waiting, const int is[2]) {
    const int right_first = !t->way.is_left_first && is[0] == IN && is[1] == IN &&
                            t->child[1].nearest < t->child[0].nearest;
    for (int i = 0; i < 2; i++) {
        const int c = right_first ? i : 1 - i;
        if (is[c] == IN) {
            copy_entry(t, &t->stack[waiting++], &t->child[c]);
        }
    }
    return waiting;
}

static uint32_t visit(bph_tracing *t, const bph_entry *at, uint32_t waiting) {
    const plt_node *node = &t->tree->node[plt_link_index(at->edge.link)];
    const bph_planes owned[2] = {bph_planes_owned(node, 0), bph_planes_owned(node, 1)};
    int is[2];
    packet_count_node(&t->counts, t->packet.count, bph_set_count(&at->rays));
    begin_children(t, at, node);
    for (int c = 0; c < 2; c++) {
        is[c] = judge(t, at, &owned[c], &t->child[c]);
    }
    if (is[0] == DOUBT || is[1] == DOUBT) {
        if (t->way.is_naive || at->is_incomplete) {
            test_boxes(t, at, is);
        } else {
            clip_both(t, at, owned, is);
        }
    }
    return push_children(t, waiting, is);
}

/* What has waited, since hits have come. */
static int is_hidden(bph_tracing *t, bph_entry *e) {
    if (t->hits == e->hits) {
        return 0;
    }
    e->rays = bph_set_both(&e->rays, &t->packet.open);
    if (bph_set_is_empty(&e->rays)) {
        return 1;
    }
    if (t->way.is_naive || e->is_incomplete) {
        return !meet_box(t, &e->box, e);
    }
    for (uint32_t i = 0; i < t->packet.count; i++) {
        e->at.to[i] = t->packet.limit[i] < e->at.to[i] ? t->packet.limit[i] : e->at.to[i];
    }
    const bph_set hit = bph_intervals_left(&e->at, &e->rays), before = e->rays;
    if (bph_set_is_empty(&hit)) {
        return 1;
    }
    narrow(t, e, &hit, &before);
    return 0;
}

static uint32_t push_root(bph_tracing *t) {
    bph_entry *root = &t->stack[0];
    root->edge = t->tree->root;
    root->box = t->tree->box;
    root->rays = t->packet.open;
    root->hits = t->hits;
    root->is_incomplete = 0;
    return meet_box(t, &root->box, root) ? 1 : 0;
}

void bph_trace(bph_tracing *t) {
    bph_entry at;
    t->counts.packets++;
    t->counts.signs += t->packet.is_equal;
    for (uint32_t waiting = push_root(t); waiting > 0 && !bph_set_is_empty(&t->packet.open);) {
        copy_entry(t, &at, &t->stack[--waiting]);
        if (is_hidden(t, &at)) {
            continue;
        }
        if (plt_link_is_leaf(at.edge.link)) {
            meet_lists(t, &at);
        } else {
            waiting = visit(t, &at, waiting);
        }
    }
}
