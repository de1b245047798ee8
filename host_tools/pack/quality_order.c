/* quality_order - see quality_order.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/quality_order.h"

#include <string.h>

#include "engine/builder/lattice_triangles.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/list_tree.h"

enum { IN_A_LIST = UINT16_MAX, TREELET = 64 };

/* A triangle with that box: lattices have at most 21 bits, which floats hold. */
static void box_record(plt_record *r, const plt_lattice_box *b, uint32_t id) {
    float p[9];
    for (int a = 0; a < 3; a++) {
        p[a] = p[6 + a] = (float)b->lo[a];
        p[3 + a] = (float)b->hi[a];
    }
    plt_put_floats((unsigned char *)r->word, p, 9);
    plt_put_u32(&r->word[9], id);
}

static void box_records(const snapped *s, int are_boxes, plt_record *records) {
    const plt_lattice_triangles t = {
        .bytes = s->corners, .count = s->count, .width = s->width, .boxes = are_boxes != 0};
    for (uint32_t i = 0; i < s->count; i++) {
        const plt_lattice_box b = plt_lattice_triangle_box(&t, i);
        box_record(&records[i], &b, i);
    }
}

typedef struct step {
    uint32_t node;
    uint16_t level; /* of the node that parts it from what is to its left */
    uint16_t depth;
} step;

/* order[i]: the record that is the i-th in the tree's order. */
static void order_of(const list_tree *t, uint32_t *order, uint16_t *levels) {
    step stack[PLT_DEPTH_MAX + 3] = {{0, 0, 0}};
    uint32_t waiting = 1, at = 0;
    while (waiting > 0) {
        const step here = stack[--waiting];
        const list_tree_node *n = &t->node[here.node];
        if (!list_tree_is_list(n)) {
            const uint16_t below = (uint16_t)(here.depth + 1);
            stack[waiting++] = (step){n->child[1], here.depth, below};
            stack[waiting++] = (step){n->child[0], here.level, below};
            continue;
        }
        for (uint32_t i = 0; i < n->triangles; i++, at++) {
            levels[at] = i == 0 ? here.level : IN_A_LIST;
            order[at] = n->child[0] + i;
        }
    }
}

/* Moves elements of `bytes` bytes into that order; `to` has room for all. */
static void put_in_order(void *elements, size_t bytes, const uint32_t *order, uint32_t count,
                         unsigned char *to) {
    for (size_t i = 0; i < count; i++) {
        memcpy(to + i * bytes, (unsigned char *)elements + order[i] * bytes, bytes);
    }
    memcpy(elements, to, count * bytes);
}

static void reorder(snapped *s, int are_boxes, const uint32_t *order, unsigned char *room) {
    put_in_order(s->corners, (are_boxes ? 6u : 9u) * s->width, order, s->count, room);
    put_in_order(s->source, sizeof *s->source, order, s->count, room);
    if (s->rotation != NULL) {
        put_in_order(s->rotation, sizeof *s->rotation, order, s->count, room);
    }
}

/* `records` become the tree's; afterwards they are room for moving what they stand for. */
static int improve(plt_build_job *job, uint32_t seconds, quality_stats *stats, uint32_t *order,
                   uint16_t *levels) {
    list_tree t = {.node = NULL};
    int status = plt_build(job);
    if (status == PLT_OK) {
        status = quality_improve(job, seconds, NULL, stats);
    }
    if (status != PLT_OK) {
        return status;
    }
    t.node = heap_get((uint64_t)list_tree_nodes(job) * sizeof *t.node);
    if (t.node == NULL) {
        return PLT_ERR_ARENA;
    }
    list_tree_read(&t, job);
    order_of(&t, order, levels);
    for (uint32_t i = 0; i < job->count; i++) {
        order[i] = plt_get_u32(&job->records[order[i]].word[9]) & ~PLT_RECORD_LAST;
    }
    heap_drop(t.node);
    return PLT_OK;
}

int quality_order(snapped *s, uint8_t splits, uint32_t leaf_triangles, int are_boxes,
                  uint32_t seconds, quality_stats *stats, uint16_t *levels) {
    const uint32_t nodes = plt_build_nodes_bound(s->count);
    plt_record *records = heap_get((uint64_t)s->count * sizeof *records);
    uint32_t *order = heap_get((uint64_t)s->count * sizeof *order);
    plt_build_job job = {.records = records,
                         .count = s->count,
                         .room = plt_build_slots_bound(nodes, TREELET),
                         .leaf_triangles = leaf_triangles,
                         .treelet_nodes = TREELET,
                         .splits = splits,
                         .scratch_bytes = plt_build_scratch_bytes(nodes, TREELET)};
    job.nodes = heap_get((uint64_t)job.room * sizeof *job.nodes);
    job.scratch = heap_get_aligned(job.scratch_bytes);
    int status = PLT_ERR_ARENA;
    if (records != NULL && order != NULL && job.nodes != NULL && job.scratch != NULL) {
        box_records(s, are_boxes, records);
        status = improve(&job, seconds, stats, order, levels);
    }
    if (status == PLT_OK) {
        reorder(s, are_boxes, order, (unsigned char *)records);
    }
    heap_drop(records);
    heap_drop(order);
    heap_drop(job.nodes);
    heap_drop(job.scratch);
    return status;
}
