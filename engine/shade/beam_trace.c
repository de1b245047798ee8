/* beam_trace - the beam on its way through a scene: where it begins, and what is counted
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"
#include "engine/trace/block_entry.h"
#include "engine/trace/treelet_entry.h"

/* Where the beam is inside the scene's box. */
static plt_beam_entry root_entry(const plt_beam *b, const plt_box *box) {
    plt_beam_entry e = {0.0f, -PLT_VIEW_FAR, 0};
    for (int a = 0; a < 3; a++) {
        plt_beam_bound(&e, &b->plane[a], box->lo[a]);
        plt_beam_bound(&e, &b->plane[3 + a], box->hi[a]);
    }
    return e;
}

void plt_beam_state_init(plt_traversal *t) {
#if PLT_WITH_COMPACT
    if (t->scene->format == PLT_FORMAT_COMPACT) {
        plt_block_state_init((plt_block_state *)t->state);
    }
#else
    (void)t;
#endif
}

static int push_nodes(plt_traversal *t, const plt_beam_entry *root) {
    plt_beam_entry *to = (plt_beam_entry *)t->stack;
    *to = *root;
    to->link = t->scene->thesis.root;
    plt_treelet_state_init(t);
    return to->link != PLT_LINK_NONE;
}

static int push_blocks(plt_traversal *t, const plt_beam_entry *root) {
    plt_beam_block_entry *to = (plt_beam_block_entry *)t->stack;
    to->enter = root->enter;
    to->minus_leave = root->minus_leave;
    to->link = t->scene->compact.root;
    to->target = PLT_SLOT_EDGE;
    ((plt_block_state *)t->state)->current = NULL;
    return to->link != PLT_LINK_NONE;
}

void plt_beam_push_root(plt_beam *b, plt_traversal *t) {
    const plt_beam_entry root = root_entry(b, &t->scene->box);
    t->waiting = 0;
    if (!plt_beam_meets(b, root.enter, root.minus_leave)) {
        return;
    }
    switch (t->scene->format) {
    case PLT_FORMAT_THESIS:
        t->waiting = (uint32_t)push_nodes(t, &root);
        break;
    case PLT_FORMAT_COMPACT:
        t->waiting = (uint32_t)push_blocks(t, &root);
        break;
    default:
        t->waiting = t->scene->list.count > 0;
        break;
    }
}

static void count(plt_stats *s, const plt_beam_counts *c) {
    s->node_visits += c->nodes;
    s->group_tests += 2 * (uint64_t)c->nodes;
    s->triangle_tests += c->triangles;
}

int plt_beam_trace(plt_beam *b, plt_traversal *t, uint32_t visits) {
    plt_beam_counts c = {0, 0};
    switch (t->scene->format) {
#if PLT_WITH_THESIS
    case PLT_FORMAT_THESIS:
        c = plt_beam_trace_nodes(b, t, visits);
        break;
    case PLT_FORMAT_LIST:
        if (t->waiting > 0) {
            c.triangles = plt_beam_lists(b, 0, t->scene->list.count, 1);
            t->waiting = 0;
        }
        break;
#endif
#if PLT_WITH_COMPACT
    case PLT_FORMAT_COMPACT:
        c = plt_beam_trace_blocks(b, t, visits);
        break;
#endif
    default:
        break;
    }
    count(&t->stats, &c);
    return t->waiting > 0 ? PLT_MORE : PLT_OK;
}
