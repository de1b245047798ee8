/* beam_trace - the beam on its way through a scene: where it begins, and what is counted
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"
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
    switch (t->scene->format) {
#if PLT_WITH_COMPACT
    case PLT_FORMAT_COMPACT:
        plt_beam_resident_init(t);
        break;
#endif
#if PLT_WITH_STREAMED_COMPACT
    case PLT_FORMAT_STREAMED:
        plt_beam_streamed_init(t);
        break;
#endif
#if PLT_WITH_GRID
    case PLT_FORMAT_GRID:
        plt_beam_grid_init(t);
        break;
#endif
    default: /* nodes: plt_beam_push_root */
        break;
    }
}

#if PLT_WITH_THESIS
static void push_nodes(plt_traversal *t, const plt_beam_entry *root) {
    plt_beam_entry *to = (plt_beam_entry *)t->stack;
    *to = *root;
    to->link = t->scene->thesis.root;
    plt_treelet_state_init(t);
    t->waiting = to->link != PLT_LINK_NONE;
}
#endif

void plt_beam_push_root(plt_beam *b, plt_traversal *t) {
    const plt_beam_entry root = root_entry(b, &t->scene->box);
    t->waiting = 0;
    if (!plt_beam_meets(b, root.enter, root.minus_leave)) {
        return;
    }
    switch (t->scene->format) {
#if PLT_WITH_THESIS
    case PLT_FORMAT_THESIS:
        push_nodes(t, &root);
        break;
#endif
#if PLT_WITH_GRID
    case PLT_FORMAT_GRID:
        plt_beam_grid_push(b, t);
        break;
#endif
#if PLT_WITH_VERTICES
    case PLT_FORMAT_VERTICES:
        push_nodes(t, &root);
        break;
#endif
#if PLT_WITH_COMPACT
    case PLT_FORMAT_COMPACT:
        plt_beam_resident_push(b, t, &root);
        break;
#endif
#if PLT_WITH_STREAMED_COMPACT
    case PLT_FORMAT_STREAMED:
        plt_beam_streamed_push(b, t, &root);
        break;
#endif
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
    int status = PLT_OK;
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
#if PLT_WITH_GRID
    case PLT_FORMAT_GRID:
        c = plt_beam_grid_trace(b, t, visits);
        break;
#endif
#if PLT_WITH_VERTICES
    case PLT_FORMAT_VERTICES:
        c = plt_beam_trace_vertices(b, t, visits);
        break;
#endif
#if PLT_WITH_COMPACT
    case PLT_FORMAT_COMPACT:
        status = plt_beam_resident_trace(b, t, visits, &c);
        break;
#endif
#if PLT_WITH_STREAMED_COMPACT
    case PLT_FORMAT_STREAMED:
        status = plt_beam_streamed_trace(b, t, visits, &c);
        break;
#endif
    default:
        break;
    }
    count(&t->stats, &c);
    return t->waiting > 0 ? PLT_MORE : status;
}
