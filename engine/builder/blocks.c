/* blocks - see blocks.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks.h"

#include <string.h>

#include "engine/builder/blocks_state.h"

/* Edges that may wait: a full block's for each level of blocks that so many triangles
 * usually take, and one for each level of nodes. */
static uint32_t edges_most(uint32_t count) {
    return (count <= 65536 ? 2u : 4u) * PLT_BLOCK_NODES_MOST + PLT_DEPTH_MAX + 2;
}

size_t plt_blocks_scratch_bytes(uint32_t count) {
    return sizeof(plt_blocks_state) + edges_most(count) * sizeof(plt_block_edge_waiting);
}

static plt_blocks_state *state_of(const plt_blocks_job *job) {
    return job->scratch;
}

void plt_blocks_record_order(plt_blocks_job *job, uint32_t *order) {
    state_of(job)->order = order;
}

/* Nodes that a subtree of `count` triangles is expected to take: 0.55 per triangle for
 * K = 1, 0.3 for K = 2, 0.155 for K = 4. A wrong guess only costs fill. */
static uint32_t nodes_expected(const plt_blocks_job *job, uint32_t count) {
    const uint32_t per_mille =
        job->leaf_triangles == 1 ? 550 : (job->leaf_triangles == 2 ? 300 : 155);
    return count / 1000 * per_mille + count % 1000 * per_mille / 1000;
}

static void push_edge(plt_blocks_state *s, const plt_block_range *r, uint32_t link_at) {
    const plt_block_edge_waiting edge = {r->first, r->count, r->exact, link_at, r->depth};
    s->edge[s->waiting++] = edge;
}

int plt_blocks_begin(plt_blocks_job *job) {
    plt_blocks_state *s = state_of(job);
    const uint32_t n = job->triangles.count;
    memset(s, 0, sizeof *s);
    s->job = job;
    s->edge = (plt_block_edge_waiting *)(void *)(s + 1);
    s->edges_most = edges_most(n);
    s->index_bytes = n <= 65536 ? 2 : 4;
    job->used = job->node_bytes = job->blocks = job->nodes = job->leaves = job->pairs = 0;
    job->written = job->depth = 0;
    job->limit = PLT_BLOCKS_LIMIT_NONE;
    job->root = PLT_LINK_NONE;
    job->box = plt_lattice_box_empty();
    job->peak = (size_t)n * s->index_bytes;
    if (job->peak > job->bytes) {
        return PLT_ERR_ARENA;
    }
    s->permutation = job->memory + (job->bytes - job->peak);
    for (uint32_t i = 0; i < n; i++) {
        const plt_lattice_box b = plt_lattice_triangle_box(&job->triangles, i);
        plt_lattice_box_add(&job->box, &b);
        plt_permute(s, i, i);
    }
    if (n > 0) {
        const plt_block_range all = {0, n, job->box, job->box, 0, 0, 0};
        push_edge(s, &all, PLT_LINK_NONE);
    }
    return PLT_OK;
}

/* Starts the block behind the top edge; `most` bounds its nodes. */
static void begin_block(plt_blocks_state *s, uint32_t most) {
    const plt_block_range root = {
        s->at.first, s->at.count, s->at.bounds, s->at.bounds, (uint16_t)s->at.depth, 0, 0};
    s->pending[0] = root;
    s->pendings = 1;
    s->nodes = 0;
    s->nodes_most = most;
    s->open = 1;
}

/* The range to split next, or -1 when the block is full or complete: the
 * largest, until all fit blocks of their own; then the smallest, if it fits
 * here whole. */
static int choose(const plt_blocks_state *s) {
    int largest = -1, smallest = -1;
    for (uint32_t i = 0; i < s->pendings; i++) {
        const uint32_t count = s->pending[i].count;
        largest = largest < 0 || count > s->pending[largest].count ? (int)i : largest;
        smallest = smallest < 0 || count < s->pending[smallest].count ? (int)i : smallest;
    }
    if (largest < 0 || s->nodes == s->nodes_most) {
        return -1;
    }
    if (s->nodes == 0 || nodes_expected(s->job, s->pending[largest].count) > PLT_BLOCK_NODES_MOST) {
        return largest;
    }
    const uint32_t expected = 1 + nodes_expected(s->job, s->pending[smallest].count);
    return expected <= s->nodes_most - s->nodes ? smallest : -1;
}

/* Six planes in steps from the parent's, rounded outwards, and their owners. */
static void encode_planes(plt_block_node *node, const plt_lattice_box *box,
                          const plt_lattice_box child[2]) {
    node->owners = 0;
    for (uint32_t a = 0; a < 3; a++) {
        const uint32_t step = plt_block_step(box->hi[a] - box->lo[a]);
        const int right_lo = a == 0 || child[1].lo[a] > child[0].lo[a];
        const int right_hi = child[1].hi[a] < child[0].hi[a];
        node->plane[a] = (uint8_t)((child[right_lo].lo[a] - box->lo[a]) / step);
        node->plane[3 + a] = (uint8_t)((box->hi[a] - child[right_hi].hi[a]) / step);
        node->owners |= (uint8_t)(right_lo << a | right_hi << (3 + a));
    }
}

static void set_child(plt_blocks_state *s, const plt_block_range *range, uint32_t index,
                      int child) {
    plt_block_node *node = &s->node[index];
    node->first[child] = range->first;
    node->count[child] = range->count;
    node->kind[child] = PLT_SLOT_LEAF;
    if (range->count > 2 * s->job->leaf_triangles) {
        node->kind[child] = PLT_SLOT_EDGE; /* until it is split in this block */
        s->pending[s->pendings++] = *range;
    }
}

static uint32_t split(plt_blocks_state *s, const plt_block_range *p, plt_lattice_box half[2]) {
    const plt_split_range range = {p->first, p->first + p->count, p->depth, s->job->leaf_triangles,
                                   s->job->splits};
#if PLT_BLOCKS_LEVELS
    if (s->job->levels != NULL) {
        return plt_split_given(s, range.begin, range.end, half);
    }
#endif
    return plt_split_lattice(s, &range, &p->exact, half);
}

static void split_pending(plt_blocks_state *s, uint32_t chosen) {
    const plt_block_range p = s->pending[chosen];
    const uint32_t index = s->nodes++;
    plt_block_node *node = &s->node[index];
    plt_lattice_box half[2], decoded[2];
    s->pending[chosen] = s->pending[--s->pendings];
    node->level = (uint8_t)(p.depth - s->at.depth);
    if (index > 0) {
        s->node[p.parent].kind[p.child] = PLT_SLOT_INNER;
        s->node[p.parent].node[p.child] = (uint8_t)index;
    }
    uint32_t middle = p.first;
    if (p.count > 1) {
        middle = split(s, &p, half);
    } else { /* a scene of one triangle has it twice */
        half[0] = half[1] = p.exact;
    }
    const uint32_t first[2] = {p.first, middle};
    const uint32_t count[2] = {p.count > 1 ? middle - p.first : 1, p.first + p.count - middle};
    const uint32_t left = half[0].lo[0] > half[1].lo[0]; /* the right child owns xmin */
    const plt_lattice_box exact[2] = {half[left], half[left ^ 1]};
    encode_planes(node, &p.decoded, exact);
    plt_block_apply(&p.decoded, node->plane, node->owners, decoded);
    for (uint32_t c = 0; c < 2; c++) {
        const plt_block_range range = {first[left ^ c], count[left ^ c],         decoded[c],
                                       exact[c],        (uint16_t)(p.depth + 1), (uint8_t)index,
                                       (uint8_t)c};
        set_child(s, &range, index, (int)c);
    }
}

/* What is left waits behind edges, the lowest range on top. */
static void push_edges(plt_blocks_state *s, uint32_t block_address, const uint32_t *link_offset) {
    while (s->pendings > 0) {
        uint32_t highest = 0;
        for (uint32_t i = 1; i < s->pendings; i++) {
            highest = s->pending[i].first > s->pending[highest].first ? i : highest;
        }
        const plt_block_range r = s->pending[highest];
        push_edge(s, &r, block_address + link_offset[2 * r.parent + r.child]);
        s->pending[highest] = s->pending[--s->pendings];
    }
}

static int finish_block(plt_blocks_state *s) {
    if (!plt_blocks_collect_geometry(s)) {
        if (s->nodes_most <= 1) {
            return plt_blocks_limited(s, PLT_BLOCKS_LIMIT_BLOCK);
        }
        begin_block(s, s->nodes > 1 ? s->nodes / 2 : 1);
        return PLT_MORE;
    }
    const uint32_t address = s->job->used;
    const int status = plt_blocks_write(s);
    if (status != PLT_OK) {
        return status;
    }
    uint32_t link_offset[2 * PLT_BLOCK_NODES_MOST];
    plt_blocks_link_offsets(s, link_offset);
    push_edges(s, address, link_offset);
    s->open = 0;
    return PLT_MORE;
}

/* Writes the check of the next block: links are complete only when all blocks are. */
static int write_next_check(plt_blocks_state *s) {
    plt_blocks_job *job = s->job;
    if (s->checked == job->used) {
        return PLT_OK;
    }
    unsigned char *bytes = job->memory + s->checked;
    plt_block b;
    plt_block_open(&b, bytes, job->bits);
    const uint32_t check = plt_block_check(bytes, b.node_bytes, 2);
    plt_put_u32(bytes, (plt_get_u32(bytes) & 0xFFFFu) | check << 16);
    s->checked += plt_block_bytes(&b);
    return s->checked == job->used ? PLT_OK : PLT_MORE;
}

int plt_blocks_step(plt_blocks_job *job) {
    plt_blocks_state *s = state_of(job);
    if (!s->open) {
        if (s->waiting == 0) {
            return write_next_check(s);
        }
        s->at = s->edge[--s->waiting];
        /* A block adds at most its nodes to the edges that wait; when room is
         * short blocks get smaller, down to one node per level. */
        const uint32_t room = s->edges_most - 1 - s->waiting;
        const uint32_t spare = room > PLT_DEPTH_MAX ? room - PLT_DEPTH_MAX : 1;
        begin_block(s, spare < PLT_BLOCK_NODES_MOST ? spare : PLT_BLOCK_NODES_MOST);
    }
    const int chosen = choose(s);
    if (chosen < 0) {
        return finish_block(s);
    }
    if (s->pending[chosen].depth >= PLT_DEPTH_MAX) {
        return plt_blocks_limited(s, PLT_BLOCKS_LIMIT_DEPTH);
    }
    split_pending(s, (uint32_t)chosen);
    return PLT_MORE;
}

/* A switch: a table of pointers would be data that start-up has to fill in. */
const char *plt_blocks_limit_message(const plt_blocks_job *job) {
    switch (job->limit) {
    case PLT_BLOCKS_LIMIT_DEPTH:
        return "the scene needs more than PLT_DEPTH_MAX levels";
    case PLT_BLOCKS_LIMIT_BLOCK:
        return "a node's triangles do not fit a block";
    case PLT_BLOCKS_LIMIT_BYTES:
        return "the scene needs more than PLT_BLOCKS_BYTES_MAX of blocks";
    default:
        return "no limit was met";
    }
}
