/* format_streamed_thesis - thesis nodes and float records that are fetched when a packet needs
 * them; the operations of format.h
 *
 * Boxes are those of resident nodes, and so are hits. The state of the format is a stream
 * (memory/treelet_stream.h). A leaf is read by its records alone, whichever treelet is current.
 *
 * A scene that is not read when it is opened claims how deep it is; so every treelet says how
 * deep it is itself, and is refused where the stack might not hold what it pushes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_FORMAT_STREAMED_THESIS_H
#define PLT_TRACE_FORMAT_STREAMED_THESIS_H

#define PLT_TREELETS_STREAMED 1
#define FORMAT_MEETS PLT_WITH_BATCH

#include "engine/base/rules.h"
#include "engine/memory/prefetch.h"
#include "engine/memory/treelet_stream.h"
#include "engine/trace/format.h"
#include "engine/trace/format_meets.h"
#include "engine/trace/kept.h"
#include "engine/trace/leaf_records.h"
#include "engine/trace/tasks.h"
#include "engine/trace/thesis_place.h"

enum { FORMAT_TIGHTENS = 0, FORMAT_LEAVES_WAIT = 1 };

typedef plt_treelet_stream format_state;

static inline void format_state_init(plt_traversal *t) {
    format_state *s = (format_state *)t->state;
    const plt_scene *scene = t->scene;
    s->image = scene->treelets;
    s->fetcher.source = s->image.source;
    s->fetcher.stats = &t->stats;
    s->fetcher.touched = t->touched;
    plt_between_set(s->scene.box, scene->info.lo, scene->info.hi);
    s->scene.treelet_nodes = scene->thesis.treelet_nodes;
    s->scene.node_slots = scene->thesis.node_slots;
    s->scene.triangles = scene->thesis.records_count;
    s->longest_list = scene->info.leaf_triangles;
    plt_treelet_stream_init(s, t->store, t->store_bytes);
    plt_prefetch_begin(&s->fetcher, t->prefetch);
}

static inline int format_root(plt_traversal *t, format_place *place) {
    const plt_tree *tree = &t->scene->thesis;
    place_set_box(place, &t->scene->box);
    place->link = tree->root;
    place->scope = tree->node_slots / tree->treelet_nodes;
    ((format_state *)t->state)->first = PLT_MISS;
    return tree->root != PLT_LINK_NONE;
}

#if PLT_WITH_PREFETCH
/* What a place leads to is asked for. */
static inline void expect_place(format_state *s, const format_place *place) {
    if (format_is_leaf(place)) {
        plt_treelet_stream_expect_records(s, plt_link_index(place->link));
    } else {
        plt_treelet_stream_expect(s, plt_link_index(place->link), place->scope);
    }
}

/* The treelet is asked for, then what waits on the stack, the next one first. An entry of every
 * order begins with its place. */
static inline void look_ahead(plt_traversal *t, const format_place *place) {
    format_state *s = (format_state *)t->state;
    const unsigned char *top = (const unsigned char *)t->stack + t->waiting * t->entry_bytes;
    const uint32_t most = t->waiting < s->fetcher.ahead ? t->waiting : s->fetcher.ahead;
    expect_place(s, place);
    for (uint32_t i = 0; i < most; i++) {
        top -= t->entry_bytes;
        expect_place(s, (const format_place *)(const void *)top);
    }
}
#endif

static inline int format_enter(plt_traversal *t, const format_place *place) {
    format_state *s = (format_state *)t->state;
#if PLT_WITH_PREFETCH
    if (s->fetcher.ahead > 0 && !plt_meets(t) &&
        !plt_treelet_stream_is_in(s, plt_link_index(place->link), place->scope)) {
        look_ahead(t, place);
    }
#endif
    const int status = plt_treelet_stream_open(s, plt_link_index(place->link), place->scope);
    const uint32_t room = t->scene->info.depth_stack_entries + PLT_STACK_SLACK;
    return status == PLT_OK && t->waiting + plt_treelet_stream_depth(s) > room
               ? plt_treelet_stream_refuse(s, PLT_I8_COUNTS)
               : status;
}

static inline int format_cross(plt_traversal *t, const format_place *place) {
    return format_is_edge(place) ? format_enter(t, place) : PLT_OK;
}

#if FORMAT_MEETS
static inline int format_wait(plt_traversal *t, const format_place *place, float distance,
                              const void *entry, size_t bytes) {
    return plt_tasks_wait(t->tasks, place->link, place->scope, distance, entry, bytes,
                          sizeof *place);
}
#endif

static inline int format_return(plt_traversal *t, const format_place *place) {
    return format_is_leaf(place) ? PLT_OK : format_enter(t, place);
}

/* Lists of a node's leaves are probably needed next. */
static inline void expect_lists(format_state *s, const plt_node *node) {
#if PLT_WITH_PREFETCH
    for (int i = 0; s->fetcher.ahead > 0 && i < 2; i++) {
        const uint32_t link = plt_node_link(node, i);
        if (plt_link_is_leaf(link)) {
            plt_treelet_stream_expect_records(s, plt_link_index(link));
        }
    }
#else
    (void)s;
    (void)node;
#endif
}

static inline void format_decode(const plt_traversal *t, const format_place *place,
                                 format_children *c) {
    c->stream = (format_state *)t->state;
    c->scope = place->scope;
    expect_lists(c->stream, plt_treelet_stream_node(c->stream, plt_link_index(place->link)));
    children_decode(c, plt_treelet_stream_node(c->stream, plt_link_index(place->link)), place);
}

static inline void format_child(const format_children *c, unsigned child, format_place *place) {
    children_place(c, child, place);
    place->scope = (place->link & PLT_LINK_KIND) == PLT_LINK_OUT
                       ? plt_treelet_stream_edge(c->stream, plt_link_index(place->link))
                       : c->scope;
}

static inline void keep_records(const plt_traversal *t, const plt_packet *p,
                                const plt_lists_left *left, plt_mask groups) {
#if PLT_WITH_PAGES
    if (plt_keeps(t, p)) {
        plt_keep_records(t->kept, p, left->at, left->record - left->count, left->count, groups);
    }
#else
    (void)t;
    (void)p;
    (void)left;
    (void)groups;
#endif
}

/* Lists that go on in the next page are tested record by record up to there. */
static inline int format_leaf(plt_traversal *t, plt_packet *p, const format_place *place,
                              plt_mask groups) {
    plt_lists_left left = {plt_link_index(place->link), plt_link_lists(place->link), 0, NULL, 0};
    const float longest = place_longest_side(place);
    while (left.lists > 0) {
        const uint32_t lists = left.lists;
        const int status = plt_treelet_stream_read((format_state *)t->state, &left);
        if (status != PLT_OK) {
            return status;
        }
        if (left.lists == 0) {
            plt_records_groups(p, left.at, lists, longest, groups);
        }
        for (uint32_t i = 0; i < left.count && left.lists > 0; i++) {
            plt_record_groups(p, &left.at[i], longest, groups);
        }
        t->stats.triangle_tests += (uint64_t)left.count * plt_mask_count(groups);
        keep_records(t, p, &left, groups);
    }
    return PLT_OK;
}

#endif
