/* forming - see forming.h
 *
 * Treelets are chosen one after the other, from a stack of nodes at which one begins: its nodes,
 * breadth first, follow those of the one before. Slots are given out afterwards: to all treelets
 * in turn, or to complete ones and then to the others, the largest first, of equals the last.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/treelets/forming.h"

#include "host_tools/base/heap.h"
#include "host_tools/treelets/full.h"
#include "host_tools/treelets/slots.h"

#define NONE TREELET_NO_NODE

typedef struct forming {
    const treelet_tree *tree;
    const treelet_wish *wish;
    treelet_layout *to;
    uint32_t *stack, waiting; /* nodes at which a treelet begins */
    uint32_t *members;        /* all nodes, treelet by treelet */
    uint32_t *first;          /* of each treelet: where its members are; and behind the last */
    uint32_t *front, fronts; /* nodes that are next: a heap, or a stack; and how many of them ... */
    uint32_t *take;          /* ... the treelet takes below each */
    treelet_costs costs;
    const treelet_prices *prices;
} forming;

static float area_of(const forming *f, uint32_t node) {
    return f->tree->area != NULL ? f->tree->area[node] : 0.0f;
}

/* ---- the largest of those that are next ------------------------------------------- */

/* Of equals the one that came first: `take` counts here. */
static int is_before(const forming *f, uint32_t a, uint32_t b) {
    const float left = area_of(f, f->front[a]), right = area_of(f, f->front[b]);
    return left != right ? left > right : f->take[a] < f->take[b];
}

static void swap(forming *f, uint32_t a, uint32_t b) {
    const uint32_t node = f->front[a], turn = f->take[a];
    f->front[a] = f->front[b];
    f->take[a] = f->take[b];
    f->front[b] = node;
    f->take[b] = turn;
}

static void add_to_heap(forming *f, uint32_t node, uint32_t turn) {
    uint32_t at = f->fronts++;
    f->front[at] = node;
    f->take[at] = turn;
    for (; at > 0 && is_before(f, at, (at - 1) / 2); at = (at - 1) / 2) {
        swap(f, at, (at - 1) / 2);
    }
}

static uint32_t take_from_heap(forming *f) {
    const uint32_t first = f->front[0];
    swap(f, 0, --f->fronts);
    for (uint32_t at = 0;;) {
        uint32_t best = at;
        for (uint32_t k = 2 * at + 1; k <= 2 * at + 2 && k < f->fronts; k++) {
            best = is_before(f, k, best) ? k : best;
        }
        if (best == at) {
            return first;
        }
        swap(f, at, best);
        at = best;
    }
}

static void choose_by_area(forming *f, uint32_t root, uint32_t number) {
    uint32_t count = 0, turn = 0;
    f->fronts = 0;
    add_to_heap(f, root, turn++);
    while (count < f->wish->size && f->fronts > 0) {
        const uint32_t node = take_from_heap(f), *child = f->tree->child[node];
        f->to->treelet[node] = number;
        count++;
        for (int k = 0; k < 2; k++) {
            if (child[k] != NONE) {
                add_to_heap(f, child[k], turn++);
            }
        }
    }
}

/* ---- so that few stay incomplete --------------------------------------------------- */

static void choose_to_fill(forming *f, uint32_t root, uint32_t number) {
    const uint32_t below = f->costs.below[root];
    f->fronts = 1;
    f->front[0] = root;
    f->take[0] = below < f->wish->size ? below : f->wish->size;
    while (f->fronts > 0) {
        const uint32_t node = f->front[--f->fronts], take = f->take[f->fronts];
        const uint32_t left = treelet_costs_left(&f->costs, node, take);
        const uint32_t share[2] = {left, take - 1 - left};
        f->to->treelet[node] = number;
        for (int k = 0; k < 2; k++) {
            if (share[k] > 0) {
                f->front[f->fronts] = f->tree->child[node][k];
                f->take[f->fronts++] = share[k];
            }
        }
    }
}

/* ---- treelets, depth first ----------------------------------------------------------- */

/* Whether a child of a member belongs to the treelet; breadth first it does while there is room. */
static int belongs(const forming *f, uint32_t child, uint32_t number, uint32_t count) {
    return f->wish->fill == TREELET_FILL_BFS ? count < f->wish->size
                                             : f->to->treelet[child] == number;
}

/* Members in their order; nodes at which others begin go onto the stack. */
static uint32_t collect(forming *f, uint32_t root, uint32_t number) {
    uint32_t count = 1, *member = f->members + f->first[number];
    member[0] = root;
    for (uint32_t i = 0; i < count; i++) {
        f->to->treelet[member[i]] = number;
        for (int k = 0; k < 2; k++) {
            const uint32_t child = f->tree->child[member[i]][k];
            if (child == NONE) {
                continue;
            }
            if (belongs(f, child, number, count)) {
                member[count++] = child;
            } else {
                f->to->treelet[child] = number; /* until its own turn: of the one above */
                f->stack[f->waiting++] = child;
            }
        }
    }
    return count;
}

static void choose_all(forming *f) {
    f->stack[f->waiting++] = 0;
    while (f->waiting > 0) {
        const uint32_t root = f->stack[--f->waiting], number = f->to->treelets++;
        f->to->parity[number] = number > 0 ? f->to->parity[f->to->treelet[root]] ^ 1u : 0;
        if (f->wish->fill == TREELET_FILL_AREA) {
            choose_by_area(f, root, number);
        } else if (f->wish->fill == TREELET_FILL_FULL) {
            choose_to_fill(f, root, number);
        }
        const uint32_t count = collect(f, root, number);
        f->first[number + 1] = f->first[number] + count;
        f->to->complete += count == f->wish->size;
    }
}

/* ---- slots ----------------------------------------------------------------------------- */

static uint32_t nodes_of(const forming *f, uint32_t treelet) {
    return f->first[treelet + 1] - f->first[treelet];
}

static int place(forming *f, treelet_blocks *b, uint32_t treelet) {
    const uint32_t nodes = nodes_of(f, treelet);
    const uint32_t block = treelet_blocks_find(b, nodes);
    if ((uint64_t)b->blocks * b->size > UINT32_MAX) {
        return TREELETS_NO_ROOM;
    }
    const uint32_t slot = block * b->size + b->used[block];
    for (uint32_t i = 0; i < nodes; i++) {
        f->to->slot[f->members[f->first[treelet] + i]] = slot + i;
    }
    treelet_blocks_fill(b, block, nodes);
    return 0;
}

/* Treelets of less than N nodes by size, each a chain that begins with the last. */
static int place_largest_first(forming *f, treelet_blocks *b) {
    uint32_t *head = heap_get((uint64_t)b->size * sizeof *head), *next = f->stack;
    int status = 0;
    if (head == NULL) {
        return TREELETS_NO_MEMORY;
    }
    for (uint32_t i = 0; i < b->size; i++) {
        head[i] = NONE;
    }
    for (uint32_t t = 0; t < f->to->treelets; t++) {
        const uint32_t nodes = nodes_of(f, t);
        if (nodes < b->size) {
            next[t] = head[nodes];
            head[nodes] = t;
        }
    }
    for (uint32_t nodes = b->size; nodes-- > 1;) {
        for (uint32_t t = head[nodes]; t != NONE && status == 0; t = next[t]) {
            status = place(f, b, t);
        }
    }
    heap_drop(head);
    return status;
}

static int place_all(forming *f) {
    const int is_last = f->wish->slots == TREELET_SLOTS_THESIS;
    treelet_blocks b;
    int status = 0;
    if (treelet_blocks_make(&b, f->wish->size, f->wish->slots, f->to->treelets) != 0) {
        return TREELETS_NO_MEMORY;
    }
    for (uint32_t t = 0; t < f->to->treelets && status == 0; t++) {
        if (!is_last || nodes_of(f, t) == f->wish->size) {
            status = place(f, &b, t);
        }
    }
    status = status == 0 && is_last ? place_largest_first(f, &b) : status;
    f->to->blocks = b.blocks;
    for (uint32_t i = 0; i < b.blocks; i++) {
        f->to->unfilled_blocks += b.used[i] < b.size;
    }
    treelet_blocks_free(&b);
    return status;
}

/* ---- memory ------------------------------------------------------------------------------ */

static uint32_t *get(uint64_t count) {
    return heap_get(count * sizeof(uint32_t));
}

static int make_room(forming *f) {
    const uint32_t nodes = f->tree->nodes;
    f->stack = get(nodes);
    f->members = get(nodes);
    f->first = get((uint64_t)nodes + 1);
    f->front = get(nodes);
    f->take = get(nodes);
    f->to->slot = get(nodes);
    f->to->treelet = get(nodes);
    f->to->parity = heap_get(nodes);
    if (f->stack == NULL || f->members == NULL || f->first == NULL || f->front == NULL ||
        f->take == NULL || f->to->slot == NULL || f->to->treelet == NULL || f->to->parity == NULL) {
        return TREELETS_NO_MEMORY;
    }
    f->first[0] = 0;
    for (uint32_t i = 0; i < nodes; i++) {
        f->to->treelet[i] = NONE;
    }
    return 0;
}

/* Every node after its parent. */
static void order_nodes(forming *f) {
    uint32_t count = 0, waiting = 1;
    f->stack[0] = 0;
    while (waiting > 0) {
        const uint32_t node = f->stack[--waiting];
        f->members[count++] = node;
        for (int k = 0; k < 2; k++) {
            if (f->tree->child[node][k] != NONE) {
                f->stack[waiting++] = f->tree->child[node][k];
            }
        }
    }
}

static int form(forming *f) {
    if (make_room(f) != 0) {
        return TREELETS_NO_MEMORY;
    }
    if (f->wish->fill == TREELET_FILL_FULL) {
        order_nodes(f);
        if (treelet_costs_make(&f->costs, f->tree, f->wish->size, f->members, f->prices) != 0) {
            return TREELETS_NO_MEMORY;
        }
    }
    choose_all(f);
    treelet_costs_free(&f->costs);
    return place_all(f);
}

static int form_once(treelet_layout *to, const treelet_tree *tree, const treelet_wish *wish,
                     const treelet_prices *prices) {
    forming f = {.tree = tree, .wish = wish, .to = to, .prices = prices};
    *to = (treelet_layout){.treelets = 0};
    const int status = tree->nodes > 0 ? form(&f) : 0;
    heap_drop(f.stack);
    heap_drop(f.members);
    heap_drop(f.first);
    heap_drop(f.front);
    heap_drop(f.take);
    if (status != 0) {
        treelets_free(to);
    }
    return status;
}

/* ---- prices ------------------------------------------------------------------------------ */

/* The first have the fewest incomplete treelets that are entered seldom; with the others there are
 * some more, but small ones, which fill what the large ones leave. */
static const treelet_prices prices[] = {
    {2.0f, 0.0f, 0.5f}, {2.0f, 0.0f, 0.1f}, {0.5f, 1.0f, 0.1f}, {4.0f, 1.0f, 0.1f}};
enum { PRICES = sizeof prices / sizeof *prices };

static int fits_well(const treelet_layout *l, const treelet_tree *tree, const treelet_wish *wish) {
    return wish->fill != TREELET_FILL_FULL || wish->slots != TREELET_SLOTS_THESIS ||
           (uint64_t)l->blocks * wish->size < (uint64_t)tree->nodes + wish->size;
}

int treelets_form(treelet_layout *to, const treelet_tree *tree, const treelet_wish *wish) {
    int status = form_once(to, tree, wish, &prices[0]);
    for (int i = 1; i < PRICES && status == 0 && !fits_well(to, tree, wish); i++) {
        treelet_layout other;
        status = form_once(&other, tree, wish, &prices[i]);
        if (status == 0 && other.blocks < to->blocks) {
            const treelet_layout worse = *to;
            *to = other;
            other = worse;
        }
        treelets_free(&other);
    }
    if (status != 0) {
        treelets_free(to);
    }
    return status;
}

void treelets_free(treelet_layout *layout) {
    heap_drop(layout->slot);
    heap_drop(layout->treelet);
    heap_drop(layout->parity);
    *layout = (treelet_layout){.treelets = 0};
}
