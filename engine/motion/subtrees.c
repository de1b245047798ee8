/* subtrees - see subtrees.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/subtrees.h"

#if PLT_WITH_SUBTREES

#include "engine/builder/split.h"

/* A node on the path from the root. */
typedef struct finding_level {
    uint32_t node, next_child;
    uint32_t first, nodes; /* records and nodes before it */
} finding_level;

typedef struct finding {
    plt_subtrees *s;
    const plt_tree *tree;
    uint32_t most, leaf_triangles, room;
    finding_level *levels;
    uint32_t depth;        /* levels in use */
    uint32_t first, nodes; /* records and nodes so far */
} finding;

uint32_t plt_subtree_room(uint32_t triangles, uint32_t nodes, uint32_t most) {
    const uint32_t count = plt_subtree_triangles(triangles, most);
    const uint32_t bound = count < 3 ? 0 : count - 2;
    const uint32_t share = count == 0 ? 0 : nodes / (triangles / count);
    const uint32_t room = share + share / 4 + 8;
    return room < bound ? room : bound;
}

size_t plt_subtrees_scratch_bytes(void) {
    return PLT_DEPTH_MAX * sizeof(finding_level);
}

static void push(finding *f, uint32_t node) {
    const finding_level l = {node, 0, f->first, f->nodes++};
    f->levels[f->depth++] = l;
}

static int can_be_rebuilt(const finding *f, uint32_t count, uint32_t nodes) {
    const uint32_t levels = f->depth + plt_levels_needed(count, f->leaf_triangles);
    return count <= f->most && count >= f->most / 4 && count > 2 * f->leaf_triangles &&
           nodes <= f->room && levels < PLT_DEPTH_MAX;
}

/* All that is below the last level is known: is it a subtree, and instead of those below? */
static void pop(finding *f) {
    const finding_level *l = &f->levels[--f->depth];
    const uint32_t count = f->first - l->first, nodes = f->nodes - l->nodes;
    plt_subtrees *s = f->s;
    if (!can_be_rebuilt(f, count, nodes)) {
        return;
    }
    while (s->count > 0 && s->at[s->count - 1].first >= l->first) {
        s->count--;
    }
    const plt_subtree none = {0};
    plt_subtree *to = &s->at[s->count++];
    *to = none;
    to->first = l->first;
    to->count = count;
    to->root = l->node;
    to->parent = f->depth == 0 ? PLT_SUBTREE_NONE : 2 * l[-1].node + l[-1].next_child - 1;
    to->slots = nodes;
    to->free = PLT_SUBTREE_NONE;
    to->depth = f->depth;
}

static void skip_lists(finding *f, uint32_t link) {
    for (uint32_t lists = plt_link_lists(link); lists > 0; f->first++) {
        lists -= (uint32_t)plt_record_is_last(&f->tree->records[f->first]);
    }
}

void plt_subtrees_find(plt_subtrees *s, const plt_tree *tree, uint32_t most,
                       uint32_t leaf_triangles, uint32_t room, void *scratch) {
    finding f = {.s = s,
                 .tree = tree,
                 .most = plt_subtree_triangles(tree->records_count, most),
                 .leaf_triangles = leaf_triangles,
                 .room = room,
                 .levels = scratch};
    s->count = 0;
    if (plt_link_is_leaf(tree->root)) {
        return;
    }
    push(&f, plt_link_index(tree->root));
    while (f.depth > 0) {
        finding_level *l = &f.levels[f.depth - 1];
        if (l->next_child == 2) {
            pop(&f);
            continue;
        }
        const uint32_t link = plt_node_link(&tree->nodes[l->node], (int)l->next_child++);
        if (plt_link_is_leaf(link)) {
            skip_lists(&f, link);
        } else {
            push(&f, plt_link_index(link));
        }
    }
}

void plt_subtrees_refit(plt_subtrees *s, plt_refit_job *job) {
    plt_refit_begin(job);
    for (plt_subtree *p = s->at; p < s->at + s->count; p++) {
        plt_refit_to(job, p->root);
        plt_refit_job part = {.nodes = job->nodes,
                              .records = job->records,
                              .root = plt_link_make(p->root, 0),
                              .levels = job->top,
                              .areas = job->areas};
        plt_refit(&part);
        p->ratios = part.areas.ratios;
        p->sum = part.areas.sum;
        job->areas.ratios += p->ratios;
        job->areas.sum += p->sum;
        plt_refit_put(job, &part.box);
    }
    if (job->link != PLT_LINK_NONE) {
        (void)plt_refit_step(job, UINT32_MAX);
    }
}

void plt_subtrees_are_new(plt_subtrees *s) {
    for (plt_subtree *p = s->at; p < s->at + s->count; p++) {
        p->ratios_built = p->ratios;
        p->sum_built = p->sum;
    }
}

plt_subtree *plt_subtrees_of(const plt_subtrees *s, uint32_t record, uint32_t depth) {
    uint32_t low = 0, high = s->count; /* those before `low` begin at `record` or before it */
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        const int is_before = s->at[middle].first <= record;
        low = is_before ? middle + 1 : low;
        high = is_before ? high : middle;
    }
    plt_subtree *p = low > 0 ? &s->at[low - 1] : NULL;
    return p != NULL && record - p->first < p->count && depth >= p->depth ? p : NULL;
}

#endif
