/* pack_treelets - see pack_treelets.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/pack_treelets.h"

#include <string.h>

#include "engine/builder/build.h"
#include "engine/image/items.h"
#include "host_tools/base/heap.h"

enum { LEAST_SIZE = 8, MOST_SIZE = LEAST_SIZE << (PACK_TREELET_SIZES - 1) };

int pack_treelets_differ(const pack_options *o) {
    return o->build == PLT_BUILD_HOST &&
           (o->treelet_nodes == PACK_TREELET_AUTO || o->fill != TREELET_FILL_BFS ||
            o->slots != TREELET_SLOTS_THESIS);
}

/* A random line that meets the root's box meets another one in it with the odds of their areas. */
static double odds(const treelet_tree *t, uint32_t node) {
    return t->area[0] > 0.0f ? (double)t->area[node] / (double)t->area[0] : 1.0;
}

/* `nodes` has room for a number of each treelet. */
static void weigh(pack_treelet_score *s, const treelet_layout *l, const treelet_tree *t,
                  uint32_t *nodes) {
    memset(nodes, 0, l->treelets * sizeof *nodes);
    for (uint32_t i = 0; i < t->nodes; i++) {
        nodes[l->treelet[i]]++;
    }
    double loaded = nodes[0];
    s->entered = 1.0;
    for (uint32_t i = 0; i < t->nodes; i++) {
        for (int k = 0; k < 2; k++) {
            const uint32_t child = t->child[i][k];
            if (child != TREELET_NO_NODE && treelets_leaves(l, i, child)) {
                s->entered += odds(t, child);
                loaded += odds(t, child) * nodes[l->treelet[child]];
            }
        }
    }
    const double slots = (double)l->blocks * s->size;
    s->cost = (PACK_TREELET_ENTERING * s->entered + loaded) * slots / t->nodes;
    s->free_slots = (uint64_t)l->blocks * s->size - t->nodes;
    s->treelets = l->treelets;
    s->complete = l->complete;
}

static int try_size(treelet_layout *l, const treelet_tree *t, const pack_options *o, uint32_t size,
                    pack_treelet_score *s) {
    const treelet_wish wish = {size, o->fill, o->slots};
    const int status = treelets_form(l, t, &wish);
    uint32_t *count = status == 0 ? heap_get((uint64_t)l->treelets * sizeof *count) : NULL;
    if (count == NULL) {
        treelets_free(l);
        return status != 0 ? status : TREELETS_NO_MEMORY;
    }
    s->size = size;
    weigh(s, l, t, count);
    heap_drop(count);
    return 0;
}

static int try_all(treelet_layout *to, const treelet_tree *t, const pack_options *o,
                   pack_treelets_stats *stats) {
    for (uint32_t size = LEAST_SIZE; size <= MOST_SIZE; size *= 2) {
        treelet_layout l;
        const uint32_t at = stats->tried;
        const int status = try_size(&l, t, o, size, &stats->of[at]);
        if (status != 0) {
            treelets_free(to);
            return status;
        }
        stats->tried++;
        if (at > 0 && stats->of[at].cost >= stats->of[stats->best].cost) {
            treelets_free(&l);
            continue;
        }
        treelets_free(to);
        *to = l;
        stats->best = at;
    }
    return 0;
}

int pack_treelets_form(treelet_layout *to, const node_tree *t, const pack_options *o,
                       pack_treelets_stats *stats) {
    *stats = (pack_treelets_stats){.tried = 0};
    *to = (treelet_layout){.treelets = 0};
    if (o->treelet_nodes == PACK_TREELET_AUTO) {
        return try_all(to, &t->tree, o, stats);
    }
    const int status = try_size(to, &t->tree, o, o->treelet_nodes, &stats->of[0]);
    stats->tried = status == 0;
    return status;
}

/* A path has PLT_DEPTH_MAX nodes at most, so subtrees have that many times all nodes together. */
static uint64_t costs_bytes(uint32_t size, uint64_t nodes) {
    const uint64_t each = size < PLT_DEPTH_MAX ? size : PLT_DEPTH_MAX;
    return nodes * (4 + sizeof(size_t) + 4 * (each + 1));
}

uint64_t pack_treelets_bytes(const pack_options *o, uint64_t nodes) {
    const int is_auto = o->treelet_nodes == PACK_TREELET_AUTO,
              is_full = o->fill == TREELET_FILL_FULL;
    const uint32_t size = is_auto ? MOST_SIZE : o->treelet_nodes;
    const uint64_t layouts = 2 + (is_auto && is_full); /* the best size's; of this size two */
    const uint64_t tree = 16 * nodes, layout = 9 * nodes, forming = 20 * nodes + 4;
    const uint64_t costs = is_full ? costs_bytes(size, nodes) : 0;
    const uint64_t blocks = 20 * nodes + 8 * (uint64_t)size;
    return tree + layouts * layout + forming + (costs > blocks ? costs : blocks) +
           16 * heap_cost(0);
}

uint64_t pack_treelets_slots(const pack_options *o, uint32_t nodes) {
    const uint32_t size = o->treelet_nodes == PACK_TREELET_AUTO ? MOST_SIZE : o->treelet_nodes;
    const uint64_t apart = (uint64_t)nodes * size;
    return o->slots == TREELET_SLOTS_NONE ? (apart < PLT_INDEX_MAX ? apart : PLT_INDEX_MAX)
                                          : plt_build_slots_bound(nodes, size);
}
