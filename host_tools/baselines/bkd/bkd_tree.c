/* bkd_tree - see bkd_tree.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bkd/bkd_tree.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/planes/planes_axis.h"

/* ---- planes ------------------------------------------------------------------------ */

/* 24 bits of a float that are no more than it, or no less. Coordinates are finite, and far from
 * the largest float. */
static void put_small_plane(uint8_t to[3], float plane, int is_up) {
    uint32_t bits;
    memcpy(&bits, &plane, sizeof bits);
    const int is_negative = bits >> 31 != 0;
    if ((bits & 0xFFu) != 0 && is_negative != is_up) {
        bits += 0x100; /* away from zero */
    }
    to[0] = (uint8_t)(bits >> 8);
    to[1] = (uint8_t)(bits >> 16);
    to[2] = (uint8_t)(bits >> 24);
}

static void put_planes(bkd_tree *b, uint32_t place, int child, float lo, float hi) {
    if (b->small != NULL) {
        put_small_plane(b->small[place].plane[child][0], lo, 0);
        put_small_plane(b->small[place].plane[child][1], hi, 1);
    } else {
        b->exact[place].plane[child][0] = lo;
        b->exact[place].plane[child][1] = hi;
    }
}

int bkd_tree_refit(bkd_tree *b, const plt_record *records) {
    plt_box *below = heap_get((uint64_t)b->places * sizeof *below + 1);
    if (below == NULL) {
        return -1;
    }
    for (uint32_t i = b->places; i-- > 0;) {
        const uint32_t link = b->small != NULL ? i : i << 3;
        if (bkd_is_leaf(b, link)) {
            continue;
        }
        const planes_view v = bkd_view(b, link);
        below[i] = plt_box_empty();
        for (int c = 0; c < 2; c++) {
            const plt_box box = bkd_is_leaf(b, v.link[c])
                                    ? plt_record_box(&records[bkd_leaf_record(b, v.link[c])])
                                    : below[bkd_place(b, v.link[c])];
            put_planes(b, i, c, box.lo[v.axis], box.hi[v.axis]);
            plt_box_add(&below[i], &box);
        }
    }
    heap_drop(below);
    return 0;
}

/* ---- nodes ------------------------------------------------------------------------- */

/* The other tree's nodes stand in pairs, parents first, as small ones do: each has its place. */
static void put_small(bkd_tree *b, planes_source *s) {
    for (uint32_t i = 0; i < s->tree->nodes; i++) {
        const binary_node *n = &s->tree->node[i];
        const int is_leaf = binary_is_leaf(n);
        const uint32_t axis = is_leaf ? 3u : planes_source_cut(s, i).axis;
        memset(&b->small[i], 0, sizeof b->small[i]);
        b->small[i].link = n->first << 2 | axis;
    }
}

/* place[] of a node is known once its parent is made; leaves have none. */
static uint32_t exact_link(const binary_node *child, uint32_t *place, uint32_t *places) {
    if (binary_is_leaf(child)) {
        return child->first << 3 | 1u;
    }
    *place = (*places)++;
    return *place << 3;
}

static void put_exact(bkd_tree *b, planes_source *s, uint32_t *place) {
    uint32_t places = 0;
    b->root = exact_link(&s->tree->node[0], &place[0], &places);
    for (uint32_t i = 0; i < s->tree->nodes; i++) {
        const binary_node *n = &s->tree->node[i];
        if (!binary_is_leaf(n)) {
            const uint32_t axis = planes_source_cut(s, i).axis;
            bkd_exact *to = &b->exact[place[i]];
            for (uint32_t c = 0; c < 2; c++) {
                const uint32_t at = n->first + c;
                to->link[c] = exact_link(&s->tree->node[at], &place[at], &places);
            }
            to->link[0] |= axis << 1;
        }
    }
}

static int make(bkd_tree *b, binary_tree *t, int is_exact) {
    planes_source s;
    uint32_t *place = heap_get((uint64_t)t->nodes * sizeof *place);
    b->inner = t->nodes - t->leaves;
    b->places = is_exact ? b->inner : t->nodes;
    b->exact = is_exact ? heap_get((uint64_t)b->places * sizeof *b->exact + 1) : NULL;
    b->small = is_exact ? NULL : heap_get((uint64_t)b->places * sizeof *b->small);
    int status = planes_source_begin(&s, t, 1);
    if (status != 0 || place == NULL || (is_exact ? b->exact == NULL : b->small == NULL)) {
        status = -1;
    } else if (is_exact) {
        put_exact(b, &s, place);
    } else {
        put_small(b, &s);
    }
    planes_source_end(&s);
    heap_drop(place);
    return status;
}

int bkd_tree_make(bkd_tree *b, binary_tree *t, int is_exact) {
    memset(b, 0, sizeof *b);
    if (make(b, t, is_exact) != 0 || bkd_tree_refit(b, t->record) != 0) {
        bkd_tree_free(b);
        return -1;
    }
    return 0;
}

void bkd_tree_free(bkd_tree *b) {
    heap_drop(b->small);
    heap_drop(b->exact);
    memset(b, 0, sizeof *b);
}

uint64_t bkd_tree_bytes(const bkd_tree *b) {
    return (uint64_t)b->places * (b->small != NULL ? sizeof *b->small : sizeof *b->exact);
}
