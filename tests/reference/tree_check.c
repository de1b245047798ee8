/* tree_check - see tree_check.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/tree_check.h"

#include <stdlib.h>
#include <string.h>

typedef struct bounds {
    float lo[3], hi[3];
} bounds;

typedef struct checking {
    const tree_view *v;
    tree_facts *facts;
    unsigned char *node_seen, *record_seen, *id_seen;
    uint32_t *queue; /* of a treelet */
} checking;

uint32_t tree_word(const unsigned char *at) {
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static float number(const unsigned char *at) {
    const uint32_t bits = tree_word(at);
    float x;
    memcpy(&x, &bits, 4);
    return x;
}

int tree_is_leaf(uint32_t link) {
    return link % 2 == 1;
}

static uint32_t link_of(const tree_view *v, uint32_t node, int child) {
    return tree_word(v->nodes + 32 * (size_t)node + 24 + 4 * child);
}

static int leaves_treelet(uint32_t link) {
    return (link >> 1) % 2 == 1;
}

tree_view tree_view_of(const packed *image) {
    const unsigned char *b = image->bytes; /* offsets: SPEC.md, section 2 */
    tree_view v = {b + tree_word(b + 108),
                   b + tree_word(b + 124),
                   tree_word(b + 32),
                   tree_word(b + 24),
                   tree_word(b + 68),
                   tree_word(b + 48),
                   tree_word(b + 52),
                   {0, 0, 0},
                   {0, 0, 0},
                   0};
    for (int a = 0; a < 3; a++) {
        v.lo[a] = number(b + 72 + 4 * a);
        v.hi[a] = number(b + 84 + 4 * a);
    }
    return v;
}

static void broken(checking *c, const char *sentence) {
    c->facts->sentence = c->facts->broken++ == 0 ? sentence : c->facts->sentence;
}

static uint32_t larger(uint32_t a, uint32_t b) {
    return a > b ? a : b;
}

/* ---- lists and boxes --------------------------------------------------------- */

static void join(bounds *b, const bounds *with) {
    for (int a = 0; a < 3; a++) {
        b->lo[a] = with->lo[a] < b->lo[a] ? with->lo[a] : b->lo[a];
        b->hi[a] = with->hi[a] > b->hi[a] ? with->hi[a] : b->hi[a];
    }
}

static const bounds nothing = {{1e38f, 1e38f, 1e38f}, {-1e38f, -1e38f, -1e38f}};

static uint32_t check_list(checking *c, uint32_t record, bounds *b) {
    uint32_t length = 0;
    for (int last = 0; !last; record++, length++) {
        if (record >= c->v->count) {
            broken(c, "a list runs beyond the last record");
            break;
        }
        const unsigned char *at = c->v->records + 40 * (size_t)record;
        const uint32_t name = tree_word(at + 36) & 0x07FFFFFF;
        if (name >= c->v->count || c->id_seen[name]++ || c->record_seen[record]++) {
            broken(c, "a triangle occurs twice or has no primitive id");
        }
        for (int k = 0; k < 3; k++) {
            const bounds corner = {
                {number(at + 12 * k), number(at + 12 * k + 4), number(at + 12 * k + 8)},
                {number(at + 12 * k), number(at + 12 * k + 4), number(at + 12 * k + 8)}};
            join(b, &corner);
        }
        last = (int)(tree_word(at + 36) >> 31);
    }
    c->facts->longest_list = larger(c->facts->longest_list, length);
    if (length > c->v->leaf_triangles) {
        broken(c, "a list is longer than K");
    }
    return record;
}

static void check_leaf(checking *c, uint32_t link, bounds *b) {
    const uint32_t next = check_list(c, link >> 5, b);
    if (leaves_treelet(link)) {
        check_list(c, next, b);
        c->facts->twos++;
    } else {
        c->facts->lists++;
    }
}

static int same_bounds(const bounds *a, const bounds *b) {
    for (int i = 0; i < 3; i++) {
        if (a->lo[i] != b->lo[i] || a->hi[i] != b->hi[i]) {
            return 0;
        }
    }
    return 1;
}

/* Figure 3.5: bits 4 3 2 of the links say for x y z that the stored plane
 * belongs to the right child. */
static void split_bounds(const tree_view *v, uint32_t node, const bounds *parent, bounds child[2]) {
    const unsigned char *at = v->nodes + 32 * (size_t)node;
    for (int a = 0; a < 3; a++) {
        const int min_right = (int)(link_of(v, node, 0) >> (4 - a)) & 1;
        const int max_right = (int)(link_of(v, node, 1) >> (4 - a)) & 1;
        child[min_right].lo[a] = number(at + 4 * a);
        child[!min_right].lo[a] = parent->lo[a];
        child[max_right].hi[a] = number(at + 12 + 4 * a);
        child[!max_right].hi[a] = parent->hi[a];
    }
}

static bounds check_below(checking *c, uint32_t link, const bounds *given, uint32_t level) {
    bounds b = nothing;
    if (tree_is_leaf(link)) {
        check_leaf(c, link, &b);
    } else if (link >> 5 >= c->v->slots || c->node_seen[link >> 5]++) {
        broken(c, "a link leads nowhere or to a node that has a parent");
        return *given;
    } else {
        const uint32_t node = link >> 5;
        bounds child[2];
        int single[2];
        c->facts->nodes++;
        c->facts->levels = larger(c->facts->levels, level + 1);
        split_bounds(c->v, node, given, child);
        for (int k = 0; k < 2; k++) {
            const bounds found = check_below(c, link_of(c->v, node, k), &child[k], level + 1);
            join(&b, &found);
            single[k] = (link_of(c->v, node, k) & 3) == 1;
        }
        if (single[0] && single[1]) {
            broken(c, "a node has two lists for children");
        }
    }
    if (!same_bounds(&b, given)) {
        broken(c, "a box is not the exact box of its contents");
    }
    return b;
}

/* ---- treelets ---------------------------------------------------------------- */

static void check_treelet(checking *c, uint32_t root) {
    const uint32_t most = c->v->treelet_nodes;
    uint32_t count = 1, *queue = malloc(4 * ((size_t)most + 2));
    queue[0] = root;
    c->facts->treelets++;
    for (uint32_t i = 0; i < count; i++) {
        if (!c->v->is_patched && queue[i] != root + i) {
            broken(c, "a treelet's nodes are not consecutive and breadth first");
        }
        for (int k = 0; k < 2; k++) {
            const uint32_t link = link_of(c->v, queue[i], k);
            if (tree_is_leaf(link)) {
                continue;
            }
            if (leaves_treelet(link)) {
                check_treelet(c, link >> 5);
            } else if (count <= most) {
                queue[count++] = link >> 5;
            }
        }
    }
    const uint32_t last = c->v->is_patched ? root : root + count - 1;
    for (uint32_t i = 0; i < count && i <= most; i++) {
        if (queue[i] / most != root / most) {
            broken(c, "a link that stays in a treelet leaves its block");
        }
    }
    if (count > most || root / most != last / most) {
        broken(c, "a treelet is larger than N or crosses a block");
    }
    c->facts->largest_treelet = larger(c->facts->largest_treelet, count);
    free(queue);
}

static void check_free_slots(checking *c) {
    static const unsigned char zero[32];
    for (uint32_t i = 0; i < c->v->slots; i++) {
        const size_t planes = c->v->is_patched ? 24 : 0;
        if (!c->node_seen[i] &&
            memcmp(c->v->nodes + 32 * (size_t)i + planes, zero, 32 - planes) != 0) {
            broken(c, "a free slot is not zero");
        }
    }
}

/* ---- stack needs, from what the traversals do ------------------------------------ */

static uint32_t local_need(const tree_view *v, uint32_t node) {
    uint32_t need[2] = {0, 0}, inner = 0;
    for (int k = 0; k < 2; k++) {
        const uint32_t link = link_of(v, node, k);
        if ((link & 3) == 0) {
            need[k] = local_need(v, link >> 5);
            inner++;
        }
    }
    return larger(need[0], need[1]) + (inner == 2);
}

static uint32_t depth_need(const tree_view *v, uint32_t link) {
    return tree_is_leaf(link) ? 0
                              : 1 + larger(depth_need(v, link_of(v, link >> 5, 0)),
                                           depth_need(v, link_of(v, link >> 5, 1)));
}

/* The header's local need is the largest of all treelets, also of those that
 * edges lead to. */
static void edges_of(const tree_view *v, uint32_t node, uint32_t *edges, uint32_t *below,
                     uint32_t *local);

static uint32_t global_need(const tree_view *v, uint32_t root, uint32_t *local) {
    uint32_t edges = 0, below = 0;
    *local = larger(*local, local_need(v, root));
    edges_of(v, root, &edges, &below, local);
    return below > 1 ? edges - 1 + below : edges;
}

static void edges_of(const tree_view *v, uint32_t node, uint32_t *edges, uint32_t *below,
                     uint32_t *local) {
    for (int k = 0; k < 2; k++) {
        const uint32_t link = link_of(v, node, k);
        if ((link & 3) == 0) {
            edges_of(v, link >> 5, edges, below, local);
            continue;
        }
        ++*edges;
        if (!tree_is_leaf(link)) {
            *below = larger(*below, global_need(v, link >> 5, local));
        }
    }
}

static void find_needs(const tree_view *v, tree_facts *facts) {
    facts->global = facts->depth = 1;
    if (!tree_is_leaf(v->root)) {
        facts->depth = larger(1, depth_need(v, v->root));
        facts->global = larger(1, global_need(v, v->root >> 5, &facts->local));
    }
}

tree_facts tree_check(const tree_view *v) {
    tree_facts facts = {.sentence = "a good tree"};
    if (v->count == 0) {
        facts.broken = v->root != 0xFFFFFFFF || v->slots != 0;
        return facts;
    }
    checking c = {v,   &facts, calloc(v->slots + 1, 1), calloc(v->count, 1), calloc(v->count, 1),
                  NULL};
    bounds scene;
    memcpy(scene.lo, v->lo, sizeof scene.lo);
    memcpy(scene.hi, v->hi, sizeof scene.hi);
    check_below(&c, v->root, &scene, 0);
    for (uint32_t i = 0; i < v->count; i++) {
        if (!c.record_seen[i] || !c.id_seen[i]) {
            broken(&c, "a triangle is in no list");
            break;
        }
    }
    if (!tree_is_leaf(v->root) && facts.broken == 0) {
        check_treelet(&c, v->root >> 5);
        check_free_slots(&c);
    }
    if (facts.broken == 0) {
        find_needs(v, &facts);
    }
    free(c.node_seen);
    free(c.record_seen);
    free(c.id_seen);
    return facts;
}

/* ---- traversals that only count --------------------------------------------------- */

typedef struct stack {
    uint32_t *link;
    uint32_t used, most;
} stack;

static void push(stack *s, uint32_t link) {
    s->link[s->used++] = link;
    s->most = larger(s->most, s->used);
}

static stack stack_for(const tree_view *v) {
    const stack s = {malloc(4 * (2 * (size_t)v->slots + 4)), 0, 0};
    return s;
}

/* The children that are hit, in visiting order; returns how many. */
static int ordered(const tree_view *v, tree_traversal *t, uint32_t node, uint32_t child[2]) {
    const uint32_t link[2] = {link_of(v, node, 0), link_of(v, node, 1)};
    const unsigned bits = t->order(t->context, node, link[0], link[1]);
    int count = 0;
    for (unsigned k = 0; k < 2; k++) {
        const unsigned c = k ^ (bits >> 2 & 1);
        if (bits >> c & 1) {
            child[count++] = link[c];
        }
    }
    return count;
}

void tree_traverse_depth_first(const tree_view *v, tree_traversal *t) {
    stack s = stack_for(v);
    push(&s, v->root);
    while (s.used > 0) {
        uint32_t at = s.link[--s.used], child[2];
        while (!tree_is_leaf(at)) {
            const int hit = ordered(v, t, at >> 5, child);
            if (hit == 2) {
                push(&s, child[1]);
            }
            if (hit == 0) {
                break;
            }
            at = child[0];
        }
    }
    t->depth = s.most;
    free(s.link);
}

/* One path down inside a treelet: the second inner child is pushed. */
static void traverse_path(const tree_view *v, tree_traversal *t, uint32_t at, stack *global,
                          stack *local) {
    for (int deeper = 1; deeper;) {
        uint32_t child[2];
        const int hit = ordered(v, t, at >> 5, child);
        deeper = 0;
        for (int k = 0; k < hit; k++) {
            if ((child[k] & 3) != 0) {
                push(global, child[k]);
            } else if (deeper++ == 0) {
                at = child[k];
            } else {
                push(local, child[k]);
            }
        }
    }
}

/* Sorting may put any edge on top: this puts the one that needs most there. */
static void worst_on_top(const tree_view *v, stack *s, uint32_t first) {
    uint32_t worst = first, need = 0, ignored = 0;
    for (uint32_t i = first; i < s->used; i++) {
        const uint32_t link = s->link[i];
        const uint32_t n = tree_is_leaf(link) ? 0 : global_need(v, link >> 5, &ignored);
        worst = n > need ? i : worst;
        need = larger(n, need);
    }
    if (s->used > first) {
        const uint32_t top = s->link[s->used - 1];
        s->link[s->used - 1] = s->link[worst];
        s->link[worst] = top;
    }
}

void tree_traverse_two_stage(const tree_view *v, tree_traversal *t) {
    stack global = stack_for(v), local = stack_for(v);
    push(&global, v->root);
    while (global.used > 0) {
        const uint32_t at = global.link[--global.used], first = global.used;
        if (!tree_is_leaf(at)) {
            traverse_path(v, t, at, &global, &local);
            while (local.used > 0) {
                traverse_path(v, t, local.link[--local.used], &global, &local);
            }
            worst_on_top(v, &global, first);
        }
    }
    t->local = local.most;
    t->global = global.most;
    free(global.link);
    free(local.link);
}

unsigned tree_deepest_order(void *view, uint32_t node, uint32_t left, uint32_t right) {
    (void)node;
    return 3u | (depth_need(view, right) > depth_need(view, left)) << 2;
}

unsigned tree_bushiest_order(void *view, uint32_t node, uint32_t left, uint32_t right) {
    (void)node;
    const int inner = (left & 3) == 0 && (right & 3) == 0;
    return 3u | (inner && local_need(view, right >> 5) > local_need(view, left >> 5)) << 2;
}
