/* treelets - see treelets.h
 *
 * target[i] is the index that node i moves to. While node i waits, its entry holds the
 * next of those that wait: the build stack costs no memory of its own. Every block has
 * at most one free slot, its tail; free slots of equal size form a chain, and one bit
 * per size says which chains are not empty.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/thesis/treelets.h"

#include "engine/planelet.h"

#define NONE 0xFFFFFFFFu

#if PLT_WITH_REBUILD
enum { FULL, PARTIAL, LINKS, PERMUTES, FREE_SLOTS, FORMED };
#endif

typedef plt_treelet_forming forming;

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* Steps that nobody else takes cost less code. */
#if PLT_WITH_REBUILD
#define PLT_TREELETS_STEP
#define HAS_LEFT(f) ((f)->left > 0)

static void take(forming *f, uint32_t nodes) {
    f->left -= least(nodes, f->left);
}
#else
#define PLT_TREELETS_STEP static
#define HAS_LEFT(f) 1

static inline void take(forming *f, uint32_t nodes) {
    (void)f;
    (void)nodes;
}
#endif

static uint32_t blocks_bound(uint32_t count, uint32_t size) {
    /* All blocks but one are at least half full: a treelet that opens a block
     * would otherwise have fitted the tail of the emptier one. */
    return count <= size ? 1 : 2 * ((count + size - 1) / size) + 1;
}

uint32_t plt_treelet_slots_bound(uint32_t count, uint32_t treelet_nodes) {
    const uint64_t slots = (uint64_t)blocks_bound(count, treelet_nodes) * treelet_nodes;
    return count == 0 ? 0 : (slots > PLT_INDEX_MAX ? PLT_INDEX_MAX : (uint32_t)slots);
}

size_t plt_treelet_scratch_bytes(uint32_t count, uint32_t treelet_nodes) {
    const size_t size = treelet_nodes;
    return 4 * ((size_t)count + least(count, treelet_nodes) + 2 * size + size / 32 + 1 +
                2 * (size_t)blocks_bound(count, treelet_nodes));
}

static void add_slot(forming *f, uint32_t block) {
    const uint32_t free_nodes = f->size - f->used[block];
    if (free_nodes > 0) {
        f->next[block] = f->head[free_nodes];
        f->head[free_nodes] = block;
        f->sizes[free_nodes / 32] |= 1u << free_nodes % 32;
    }
}

static uint32_t remove_slot(forming *f, uint32_t free_nodes) {
    const uint32_t block = f->head[free_nodes];
    f->head[free_nodes] = f->next[block];
    if (f->head[free_nodes] == NONE) {
        f->sizes[free_nodes / 32] &= ~(1u << free_nodes % 32);
    }
    return block;
}

static uint32_t largest_slot(const forming *f) {
    for (uint32_t w = f->size / 32 + 1; w-- > 0;) {
        for (uint32_t b = 32; f->sizes[w] != 0 && b-- > 0;) {
            if (f->sizes[w] >> b & 1u) {
                return 32 * w + b;
            }
        }
    }
    return 0;
}

/* The slot rule; NONE when the room is used up. */
static uint32_t block_for(forming *f, uint32_t nodes) {
    if (nodes < f->size) {
        const uint32_t largest = largest_slot(f);
        if (f->head[nodes] != NONE) {
            return remove_slot(f, nodes);
        }
        if (largest > nodes) {
            return remove_slot(f, largest);
        }
    }
    if ((uint64_t)(f->blocks + 1) * f->size > f->room) {
        return NONE;
    }
    f->used[f->blocks] = 0;
    return f->blocks++;
}

/* Breadth first from `root` until the treelet is full; other inner children
 * go onto the build stack. Returns the number of members. */
static uint32_t collect(forming *f, uint32_t root) {
    uint32_t count = 1;
    f->members[0] = root;
    for (uint32_t i = 0; i < count; i++) {
        plt_node *node = &f->nodes[f->members[i]];
        for (int c = 0; c < 2; c++) {
            const uint32_t link = plt_node_link(node, c);
            const uint32_t child = plt_link_index(link);
            if (plt_link_is_leaf(link)) {
                continue;
            }
            if (count < f->size) {
                f->members[count++] = child;
            } else {
                plt_node_set_link(node, c, link | PLT_LINK_OUT);
                f->target[child] = f->stack;
                f->stack = child;
            }
        }
    }
    return count;
}

/* Gives the members their indices. */
static int assign_members(forming *f, uint32_t nodes) {
    const uint32_t block = block_for(f, nodes);
    if (block == NONE) {
        return PLT_ERR_ARENA;
    }
    for (uint32_t i = 0; i < nodes; i++) {
        f->target[f->members[i]] = block * f->size + f->used[block] + i;
    }
    f->used[block] += nodes;
    add_slot(f, block);
    return PLT_OK;
}

/* Full treelets get their block at once, depth first; others wait by size (they have no
 * inner edges, so nothing waits for them). */
static int form_full(forming *f) {
    const uint32_t root = f->stack;
    f->stack = f->target[root];
    const uint32_t nodes = collect(f, root);
    take(f, nodes);
    if (nodes == f->size) {
        return assign_members(f, nodes);
    }
    f->target[root] = f->partial[nodes];
    f->partial[nodes] = root;
    return PLT_OK;
}

/* Of `at` nodes, the largest first. */
static int form_partial(forming *f) {
    const uint32_t root = f->partial[f->at];
    if (root == NONE) {
        f->at--;
        return PLT_OK;
    }
    f->partial[f->at] = f->target[root];
    take(f, f->at);
    return assign_members(f, collect(f, root));
}

static void update_links(forming *f) {
    f->root = f->at == 0 ? f->target[0] : f->root;
    for (; f->at < f->count && HAS_LEFT(f); f->at++) {
        take(f, 1);
        for (int c = 0; c < 2; c++) {
            const uint32_t link = plt_node_link(&f->nodes[f->at], c);
            if (!plt_link_is_leaf(link)) {
                const uint32_t index = f->target[plt_link_index(link)];
                plt_node_relink(&f->nodes[f->at], c, plt_link_make(index, link & PLT_LINK_KIND));
            }
        }
    }
}

/* Follows each chain of displaced nodes to its end; from step to step a node is on its way. */
static void permute(forming *f) {
    for (; f->at < f->count && HAS_LEFT(f); f->at++) {
        plt_node carried = f->is_carrying ? f->carried : f->nodes[f->at];
        uint32_t from = f->is_carrying ? f->from : f->at;
        take(f, f->is_carrying ? 0 : 1);
        f->is_carrying = 0;
        while (from < f->count && f->target[from] != NONE) {
            if (!HAS_LEFT(f)) {
                f->is_carrying = 1;
                f->carried = carried;
                f->from = from;
                return;
            }
            const uint32_t to = f->target[from];
            const plt_node displaced = f->nodes[to];
            f->target[from] = NONE;
            f->nodes[to] = carried;
            carried = displaced;
            from = to;
            take(f, 1);
        }
    }
}

static void zero_free_slots(forming *f) {
    const plt_node zero = {{0, 0, 0, 0, 0, 0, 0, 0}};
    for (; f->at < f->blocks && HAS_LEFT(f); f->at++) {
        for (uint32_t i = f->used[f->at]; i < f->size; i++) {
            f->nodes[f->at * f->size + i] = zero;
        }
        take(f, f->size);
    }
}

static void cut_scratch(forming *f, uint32_t *at) {
    f->target = at;
    f->members = f->target + f->count;
    f->partial = f->members + least(f->count, f->size);
    f->head = f->partial + f->size;
    f->sizes = f->head + f->size;
    f->next = f->sizes + f->size / 32 + 1;
    f->used = f->next + blocks_bound(f->count, f->size);
    for (uint32_t i = 0; i < f->size; i++) {
        f->head[i] = f->partial[i] = NONE;
    }
    for (uint32_t i = 0; i < f->size / 32 + 1; i++) {
        f->sizes[i] = 0;
    }
}

PLT_TREELETS_STEP void plt_treelets_begin(forming *f, const plt_treelet_job *job) {
    const forming none = {
        .nodes = job->nodes, .count = job->count, .room = job->room, .size = job->treelet_nodes};
    *f = none;
    cut_scratch(f, job->scratch);
    f->target[0] = NONE;
}

#if PLT_WITH_REBUILD
/* What is done of a phase when it ends, and where the next one begins. */
static void go_on(forming *f, int is_done, uint32_t from) {
    f->phase = (uint8_t)(f->phase + (is_done ? 1 : 0));
    f->at = is_done ? from : f->at;
}

int plt_treelets_step(forming *f, uint32_t nodes) {
    int status = PLT_OK;
    f->left = nodes;
    while (f->left > 0 && f->phase != FORMED && status == PLT_OK) {
        switch (f->phase) {
        case FULL:
            status = form_full(f);
            go_on(f, f->stack == NONE, f->size - 1);
            break;
        case PARTIAL:
            status = f->at > 0 ? form_partial(f) : PLT_OK;
            go_on(f, f->at == 0, 0);
            break;
        case LINKS:
            update_links(f);
            go_on(f, f->at == f->count, 0);
            break;
        case PERMUTES:
            permute(f);
            go_on(f, f->at == f->count, 0);
            break;
        default:
            zero_free_slots(f);
            go_on(f, f->at == f->blocks, 0);
            break;
        }
    }
    return status != PLT_OK || f->phase == FORMED ? status : PLT_MORE;
}
#endif

/* No phase has as many nodes as UINT32_MAX, nor have all together. */
int plt_treelets_form(plt_treelet_job *job) {
    forming f;
    int status = PLT_OK;
    job->node_slots = job->root = 0;
    if (job->count == 0) {
        return PLT_OK;
    }
    plt_treelets_begin(&f, job);
    f.left = UINT32_MAX;
    while (f.stack != NONE && status == PLT_OK) {
        status = form_full(&f);
    }
    for (f.at = f.size - 1; f.at > 0 && status == PLT_OK;) {
        status = form_partial(&f);
    }
    if (status == PLT_OK) {
        job->node_slots = f.blocks * f.size;
        f.at = 0;
        update_links(&f);
        job->root = f.root;
        f.at = 0;
        permute(&f);
        f.at = 0;
        zero_free_slots(&f);
    }
    return status;
}
