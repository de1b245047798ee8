/* full - see full.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/treelets/full.h"

#include "host_tools/base/heap.h"

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

static uint32_t most_taken(const treelet_costs *c, uint32_t node) {
    return node == TREELET_NO_NODE ? 0 : least(c->below[node], c->size);
}

static const float nothing[1] = {0.0f};

static const float *costs_of(const treelet_costs *c, uint32_t node) {
    return node == TREELET_NO_NODE ? nothing : c->cost + c->at[node];
}

/* to[i + j] = min(left[i] + right[j]). */
static void combine(float *to, uint32_t most, const float *left, uint32_t of_left,
                    const float *right, uint32_t of_right) {
    for (uint32_t k = 0; k <= most; k++) {
        to[k] = 1e30f;
    }
    for (uint32_t i = 0; i <= least(of_left, most); i++) {
        const uint32_t end = least(of_right, most - i);
        const float from = left[i];
        float *out = to + i;
        for (uint32_t j = 0; j <= end; j++) {
            const float sum = from + right[j];
            out[j] = sum < out[j] ? sum : out[j];
        }
    }
}

static void subtract_least(float *cost, uint32_t most) {
    float lowest = cost[0];
    for (uint32_t k = 1; k <= most; k++) {
        lowest = cost[k] < lowest ? cost[k] : lowest;
    }
    for (uint32_t k = 0; k <= most; k++) {
        cost[k] -= lowest;
    }
}

/* A treelet that begins at the node, and has so many nodes if they are less than N. */
static float price_of(const treelet_costs *c, uint32_t node, uint32_t nodes) {
    const float *area = c->tree->area, share = (float)nodes / (float)c->size;
    const float size = c->prices.per_size * share + (share > 0.5f ? c->prices.above_half : 0.0f);
    const float visits = area != NULL && area[0] > 0.0f ? area[node] / area[0] : 0.0f;
    const float treelets = (float)c->tree->nodes / (float)c->size;
    return c->prices.visits * treelets * visits + (nodes < c->size ? 1.0f + size : 0.0f);
}

static void fill_costs(treelet_costs *c, uint32_t node) {
    const uint32_t *child = c->tree->child[node], most = most_taken(c, node);
    float *cost = c->cost + c->at[node];
    combine(cost + 1, most - 1, costs_of(c, child[0]), most_taken(c, child[0]),
            costs_of(c, child[1]), most_taken(c, child[1]));
    cost[0] = (most < c->size ? 0.0f : cost[most]) + price_of(c, node, most);
    subtract_least(cost, most);
}

static void count_below(treelet_costs *c, const uint32_t *order) {
    uint64_t at = 0;
    for (uint32_t i = c->tree->nodes; i-- > 0;) {
        const uint32_t node = order[i], *child = c->tree->child[node];
        c->below[node] = 1;
        for (int k = 0; k < 2; k++) {
            c->below[node] += child[k] != TREELET_NO_NODE ? c->below[child[k]] : 0;
        }
        c->at[node] = (size_t)at; /* of more than there can be nothing is got */
        at += (uint64_t)most_taken(c, node) + 1;
    }
    c->cost = heap_get(at * sizeof *c->cost);
}

int treelet_costs_make(treelet_costs *c, const treelet_tree *tree, uint32_t size,
                       const uint32_t *order, const treelet_prices *prices) {
    *c = (treelet_costs){.tree = tree, .size = size, .prices = *prices};
    c->below = heap_get((uint64_t)tree->nodes * sizeof *c->below);
    c->at = heap_get((uint64_t)tree->nodes * sizeof *c->at);
    if (c->below != NULL && c->at != NULL) {
        count_below(c, order);
    }
    if (c->cost == NULL) {
        treelet_costs_free(c);
        return -1;
    }
    for (uint32_t i = tree->nodes; i-- > 0;) {
        fill_costs(c, order[i]);
    }
    return 0;
}

void treelet_costs_free(treelet_costs *c) {
    heap_drop(c->below);
    heap_drop(c->at);
    heap_drop(c->cost);
    c->below = NULL;
    c->at = NULL;
    c->cost = NULL;
}

/* Of equal costs as near to the child's share of what is below as it can be: so that a treelet
 * spreads as the tree does. */
uint32_t treelet_costs_left(const treelet_costs *c, uint32_t node, uint32_t take) {
    const uint32_t *child = c->tree->child[node];
    const uint32_t of_left = most_taken(c, child[0]), of_right = most_taken(c, child[1]);
    const float *left = costs_of(c, child[0]), *right = costs_of(c, child[1]);
    const uint32_t rest = take - 1, first = rest > of_right ? rest - of_right : 0;
    const uint64_t all = (uint64_t)of_left + of_right;
    const uint32_t share = all > 0 ? (uint32_t)((uint64_t)rest * of_left / all) : 0;
    uint32_t best = first;
    float lowest = 2e30f;
    uint32_t distance = 0;
    for (uint32_t i = first; i <= least(of_left, rest); i++) {
        const float sum = left[i] + right[rest - i];
        const uint32_t far = i > share ? i - share : share - i;
        if (sum < lowest || (sum == lowest && far < distance)) {
            best = i;
            lowest = sum;
            distance = far;
        }
    }
    return best;
}
