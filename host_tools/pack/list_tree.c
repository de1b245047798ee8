/* list_tree - see list_tree.h
 *
 * Stacks hold one waiting child per level: the tree has at most PLT_DEPTH_MAX levels of inner
 * nodes, intermediate nodes one more.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/list_tree.h"

#include "engine/tree/thesis/treelets.h"

enum { LEVELS = PLT_DEPTH_MAX + 3 };

void list_tree_fit(list_tree *t, uint32_t node) {
    list_tree_node *n = &t->node[node];
    const list_tree_node *left = &t->node[n->child[0]], *right = &t->node[n->child[1]];
    const list_tree_boxes mine = list_tree_boxes_of(t, node);
    const list_tree_boxes first = list_tree_boxes_of(t, n->child[0]);
    const list_tree_boxes second = list_tree_boxes_of(t, n->child[1]);
    list_tree_boxes_copy(t, &mine, &first);
    list_tree_boxes_add(t, &mine, &second);
    n->area = list_tree_area(t, &mine, &mine);
    n->triangles = left->triangles + right->triangles;
    n->height = 1 + (left->height > right->height ? left->height : right->height);
}

static plt_box posed_box(const list_tree *t, uint32_t pose, const plt_record *records,
                         uint32_t first, uint32_t end) {
    plt_box all = plt_box_empty();
    for (uint32_t i = first; i < end; i++) {
        const uint32_t id = plt_primitive_id(plt_get_u32(&records[i].word[9]));
        const plt_box box = poses_box(t->poses, pose, id);
        plt_box_add(&all, &box);
    }
    return all;
}

void list_tree_fit_list(list_tree *t, uint32_t node, const plt_record *records, uint32_t first,
                        uint32_t end) {
    list_tree_node *n = &t->node[node];
    const list_tree_boxes mine = list_tree_boxes_of(t, node);
    n->box = plt_records_box(records, first, end);
    for (uint32_t i = 0; t->poses != NULL && i < t->poses->count; i++) {
        mine.posed[i] = posed_box(t, i, records, first, end);
    }
    n->area = list_tree_area(t, &mine, &mine);
    n->child[0] = first;
    n->child[1] = LIST_TREE_NONE;
    n->triangles = end - first;
    n->height = 0;
}

double list_tree_cost(const list_tree *t) {
    double sum = 0.0;
    for (uint32_t i = 0; i < t->nodes; i++) {
        sum += list_tree_is_list(&t->node[i]) ? 0.0 : t->node[i].area;
    }
    return t->node[0].area > 0.0 ? sum / t->node[0].area : 0.0;
}

uint32_t list_tree_nodes(const plt_build_job *job) {
    uint32_t lists = 0;
    for (uint32_t i = 0; i < job->count; i++) {
        lists += (uint32_t)plt_record_is_last(&job->records[i]);
    }
    return lists > 0 ? 2 * lists - 1 : 0;
}

/* ---- reading ---------------------------------------------------------------- */

typedef struct waiting {
    uint32_t link, parent;
    int child;
} waiting;

static uint32_t add_node(list_tree *t, uint32_t parent, int child) {
    const uint32_t node = t->nodes++;
    t->node[node].parent = parent;
    if (parent != LIST_TREE_NONE) {
        t->node[parent].child[child] = node;
    }
    return node;
}

/* Returns the record behind the list. */
static uint32_t add_list(list_tree *t, const plt_record *records, uint32_t first, uint32_t parent,
                         int child) {
    const uint32_t node = add_node(t, parent, child);
    uint32_t end = first;
    while (!plt_record_is_last(&records[end++])) {
    }
    list_tree_fit_list(t, node, records, first, end);
    return end;
}

static void add_lists(list_tree *t, const plt_record *records, const waiting *w) {
    const uint32_t first = plt_link_index(w->link);
    if (plt_link_lists(w->link) == 1) {
        add_list(t, records, first, w->parent, w->child);
        return;
    }
    const uint32_t both = add_node(t, w->parent, w->child);
    const uint32_t second = add_list(t, records, first, both, 0);
    add_list(t, records, second, both, 1);
}

void list_tree_read(list_tree *t, const plt_build_job *job) {
    waiting stack[LEVELS] = {{job->root, LIST_TREE_NONE, 0}};
    uint32_t depth = 1;
    t->nodes = 0;
    while (depth > 0) {
        const waiting w = stack[--depth];
        if (plt_link_is_leaf(w.link)) {
            add_lists(t, job->records, &w);
            continue;
        }
        const plt_node *from = &job->nodes[plt_link_index(w.link)];
        const uint32_t node = add_node(t, w.parent, w.child);
        t->node[node].child[1] = 0; /* no list; known when it is added */
        for (int c = 1; c >= 0; c--) {
            stack[depth++] = (waiting){plt_node_link(from, c), node, c};
        }
    }
    for (uint32_t i = t->nodes; i-- > 0;) { /* children have higher numbers than parents */
        if (!list_tree_is_list(&t->node[i])) {
            list_tree_fit(t, i);
        }
    }
}

/* ---- writing ---------------------------------------------------------------- */

typedef struct writing {
    const list_tree *t;
    plt_build_job *job;
    plt_record *to;
    uint32_t written;
} writing;

/* The triangles below a node, of which there are at most K, as one list. */
static void write_list(writing *w, uint32_t node) {
    uint32_t stack[LEVELS] = {node}, depth = 1;
    while (depth > 0) {
        const list_tree_node *n = &w->t->node[stack[--depth]];
        if (!list_tree_is_list(n)) {
            stack[depth++] = n->child[1];
            stack[depth++] = n->child[0];
            continue;
        }
        for (uint32_t i = 0; i < n->triangles; i++) {
            w->to[w->written] = w->job->records[n->child[0] + i];
            plt_record_set_last(&w->to[w->written++], 0);
        }
    }
    plt_record_set_last(&w->to[w->written - 1], 1);
}

static int becomes_list(const writing *w, uint32_t node) {
    return w->t->node[node].triangles <= w->job->leaf_triangles;
}

/* A list, or an intermediate node. */
static int is_leaf(const writing *w, uint32_t node) {
    const list_tree_node *n = &w->t->node[node];
    return becomes_list(w, node) || (becomes_list(w, n->child[0]) && becomes_list(w, n->child[1]));
}

static uint32_t write_leaf(writing *w, uint32_t node) {
    const list_tree_node *n = &w->t->node[node];
    const uint32_t first = w->written;
    if (becomes_list(w, node)) {
        write_list(w, node);
        return plt_link_make(first, PLT_LINK_LEAF);
    }
    write_list(w, n->child[0]);
    write_list(w, n->child[1]);
    return plt_link_make(first, PLT_LINK_LEAF | PLT_LINK_TWO);
}

static uint32_t write_node(writing *w, const list_tree_node *n) {
    const plt_box box[2] = {w->t->node[n->child[0]].box, w->t->node[n->child[1]].box};
    plt_node_encode(&w->job->nodes[w->job->nodes_used], &n->box, box);
    return plt_link_make(w->job->nodes_used++, 0);
}

/* Depth first, as lists have to lie. */
static void write_nodes(writing *w) {
    waiting stack[LEVELS] = {{0, LIST_TREE_NONE, 0}}; /* links are numbers of nodes here */
    uint32_t depth = 1;
    while (depth > 0) {
        const waiting at = stack[--depth];
        const list_tree_node *n = &w->t->node[at.link];
        const int leaf = is_leaf(w, at.link);
        const uint32_t link = leaf ? write_leaf(w, at.link) : write_node(w, n);
        if (at.parent == LIST_TREE_NONE) {
            w->job->root = link;
        } else {
            plt_node_relink(&w->job->nodes[at.parent], at.child, link);
        }
        for (int c = 1; c >= 0 && !leaf; c--) {
            stack[depth++] = (waiting){n->child[c], plt_link_index(link), c};
        }
    }
}

int list_tree_write(const list_tree *t, plt_build_job *job, plt_record *to) {
    writing w = {t, job, to, 0};
    job->nodes_used = job->node_slots = 0;
    write_nodes(&w);
    if (job->nodes_used == 0) {
        return PLT_OK;
    }
    plt_treelet_job treelets = {.nodes = job->nodes,
                                .count = job->nodes_used,
                                .room = job->room,
                                .treelet_nodes = job->treelet_nodes,
                                .scratch = job->scratch};
    const int status = plt_treelets_form(&treelets);
    job->node_slots = treelets.node_slots;
    job->root = plt_link_make(treelets.root, 0);
    return status;
}
