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

typedef struct forming {
    plt_node *nodes;
    uint32_t count, room, size; /* size: N */
    uint32_t blocks;
    uint32_t stack;    /* top of the edges that wait */
    uint32_t *target;  /* [count] */
    uint32_t *members; /* [min(count, N)] */
    uint32_t *partial; /* [N] first treelet of that size that waits for its slot */
    uint32_t *head;    /* [N] first block whose free slot has that size */
    uint32_t *sizes;   /* [N / 32 + 1] */
    uint32_t *next;    /* [blocks] */
    uint32_t *used;    /* [blocks] */
} forming;

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

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
    f->stack = 0;
    f->target[0] = NONE;
    while (f->stack != NONE) {
        const uint32_t root = f->stack;
        f->stack = f->target[root];
        const uint32_t nodes = collect(f, root);
        if (nodes < f->size) {
            f->target[root] = f->partial[nodes];
            f->partial[nodes] = root;
        } else if (assign_members(f, nodes) != PLT_OK) {
            return PLT_ERR_ARENA;
        }
    }
    return PLT_OK;
}

static int form_partial(forming *f) {
    for (uint32_t nodes = f->size; nodes-- > 1;) {
        while (f->partial[nodes] != NONE) {
            const uint32_t root = f->partial[nodes];
            f->partial[nodes] = f->target[root];
            if (assign_members(f, collect(f, root)) != PLT_OK) {
                return PLT_ERR_ARENA;
            }
        }
    }
    return PLT_OK;
}

static void update_links(forming *f) {
    for (uint32_t i = 0; i < f->count; i++) {
        for (int c = 0; c < 2; c++) {
            const uint32_t link = plt_node_link(&f->nodes[i], c);
            if (!plt_link_is_leaf(link)) {
                const uint32_t index = f->target[plt_link_index(link)];
                plt_node_relink(&f->nodes[i], c, plt_link_make(index, link & PLT_LINK_KIND));
            }
        }
    }
}

/* Follows each chain of displaced nodes to its end. */
static void permute(forming *f) {
    for (uint32_t i = 0; i < f->count; i++) {
        plt_node carried = f->nodes[i];
        uint32_t from = i;
        while (f->target[from] != NONE) {
            const uint32_t to = f->target[from];
            const plt_node displaced = f->nodes[to];
            f->target[from] = NONE;
            f->nodes[to] = carried;
            carried = displaced;
            if (to >= f->count) {
                break;
            }
            from = to;
        }
    }
}

static void zero_free_slots(forming *f) {
    const plt_node zero = {{0, 0, 0, 0, 0, 0, 0, 0}};
    for (uint32_t b = 0; b < f->blocks; b++) {
        for (uint32_t i = f->used[b]; i < f->size; i++) {
            f->nodes[b * f->size + i] = zero;
        }
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

int plt_treelets_form(plt_treelet_job *job) {
    job->node_slots = job->root = 0;
    if (job->count == 0) {
        return PLT_OK;
    }
    forming f = {
        .nodes = job->nodes, .count = job->count, .room = job->room, .size = job->treelet_nodes};
    cut_scratch(&f, job->scratch);
    const int status = form_full(&f) == PLT_OK ? form_partial(&f) : PLT_ERR_ARENA;
    if (status == PLT_OK) {
        job->node_slots = f.blocks * f.size;
        job->root = f.target[0];
        update_links(&f);
        permute(&f);
        zero_free_slots(&f);
    }
    return status;
}
