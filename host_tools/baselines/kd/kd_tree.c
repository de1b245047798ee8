/* kd_tree - see kd_tree.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_tree.h"

#include <string.h>

#include "host_tools/base/heap.h"

/* Room for `more` behind `count`; doubles it. */
static int grow(void **block, uint32_t *room, uint64_t count, uint64_t more, uint64_t size) {
    uint64_t wanted = *room > 0 ? *room : 64;
    if (count + more <= *room) {
        return 0;
    }
    while (wanted < count + more) {
        wanted *= 2;
    }
    void *larger = wanted <= UINT32_MAX ? heap_resize(*block, wanted * size) : NULL;
    if (larger == NULL) {
        return -1;
    }
    *block = larger;
    *room = (uint32_t)wanted;
    return 0;
}

static int grow_nodes(kd_tree *t, uint32_t more) {
    void *block = t->node;
    const int status = t->nodes + more > KD_LINK_MOST
                           ? -1
                           : grow(&block, &t->node_room, t->nodes, more, sizeof *t->node);
    t->node = block;
    return status;
}

static int grow_items(kd_tree *t, uint64_t more) {
    void *block = t->item;
    const int status = grow(&block, &t->item_room, t->items, more, sizeof *t->item);
    t->item = block;
    return status;
}

/* ---- cells ------------------------------------------------------------------------ */

static int keep_cell(kd_tree *t, uint32_t node, const kd_cell *c) {
    void *block = t->cell;
    const int status = grow(&block, &t->cell_room, t->cells, 1, sizeof *t->cell);
    t->cell = block;
    if (status != 0) {
        return -1;
    }
    t->node[node].at.first = t->cells;
    t->node[node].link = KD_UNSPLIT;
    t->cell[t->cells++] = *c;
    t->cell_bytes += kd_cell_bytes(c);
    t->unsplit++;
    return 0;
}

/* Cells that are taken in the order of a stack give their places back. */
kd_cell kd_tree_take(kd_tree *t, uint32_t node) {
    const uint32_t at = t->node[node].at.first;
    const kd_cell c = t->cell[at];
    t->cell[at].reference = NULL;
    t->cell[at].stray = NULL;
    t->cells -= at + 1 == t->cells;
    t->cell_bytes -= kd_cell_bytes(&c);
    t->unsplit--;
    return c;
}

static int put_child(kd_tree *t, uint32_t node, const kd_cell *c) {
    kd_cell mine = *c;
    if (c->count == 0 && c->strays == 0) {
        kd_cell_free(&mine);
        return kd_tree_set_leaf(t, node, &mine);
    }
    if (keep_cell(t, node, &mine) != 0) {
        kd_cell_free(&mine);
        return -1;
    }
    return 0;
}

/* ---- nodes ------------------------------------------------------------------------ */

int kd_tree_begin(kd_tree *t, const kd_cell *root) {
    for (uint32_t i = 0; i < t->cells; i++) {
        kd_cell_free(&t->cell[i]);
    }
    t->nodes = t->items = t->cells = 0;
    t->inner = t->leaves = t->unsplit = t->references = t->strays = 0;
    t->cell_bytes = 0;
    memcpy(t->lo, root->lo, sizeof t->lo);
    memcpy(t->hi, root->hi, sizeof t->hi);
    if (grow_nodes(t, 1) != 0 || grow_items(t, 1) != 0) {
        kd_cell mine = *root;
        kd_cell_free(&mine);
        return -1;
    }
    t->item[t->items++] = 0; /* of all leaves that have nothing: no strays */
    t->nodes = 1;
    return put_child(t, 0, root);
}

void kd_tree_free(kd_tree *t) {
    for (uint32_t i = 0; i < t->cells; i++) {
        kd_cell_free(&t->cell[i]);
    }
    heap_drop(t->node);
    heap_drop(t->item);
    heap_drop(t->cell);
    memset(t, 0, sizeof *t);
}

uint64_t kd_tree_bytes(const kd_tree *t) {
    return (uint64_t)t->nodes * sizeof *t->node + (uint64_t)t->items * sizeof *t->item +
           (uint64_t)t->cells * sizeof *t->cell + t->cell_bytes;
}

int kd_tree_set_leaf(kd_tree *t, uint32_t node, const kd_cell *c) {
    kd_node *to = &t->node[node];
    if (c->count == 0 && c->strays == 0) {
        *to = (kd_node){.at.first = 0, .link = KD_LEAF};
        return 0;
    }
    if (c->count > KD_LINK_MOST / 4 || grow_items(t, (uint64_t)c->count + c->strays + 1) != 0) {
        return -1;
    }
    *to = (kd_node){.at.first = t->items, .link = c->count << 2 | KD_LEAF};
    for (uint32_t i = 0; i < c->count; i++) {
        t->item[t->items++] = c->reference[i].triangle;
    }
    t->item[t->items++] = c->strays;
    for (uint32_t i = 0; i < c->strays; i++) {
        t->item[t->items++] = c->stray[i];
    }
    t->leaves++;
    t->references += c->count;
    t->strays += c->strays;
    return 0;
}

int kd_tree_set_inner(kd_tree *t, uint32_t node, const kd_cut *cut, const kd_cell children[2]) {
    if (grow_nodes(t, 2) != 0) {
        for (int i = 0; i < 2; i++) {
            kd_cell mine = children[i];
            kd_cell_free(&mine);
        }
        return -1;
    }
    const uint32_t first = t->nodes;
    t->nodes += 2;
    t->node[node] = (kd_node){.at.plane = cut->at, .link = first << 2 | cut->axis};
    t->inner++;
    /* the upper one first: the lower one is then the last cell, as a stack has it */
    t->node[first] = (kd_node){.at.first = 0, .link = KD_LEAF};
    if (put_child(t, first + 1, &children[1]) != 0) {
        kd_cell mine = children[0];
        kd_cell_free(&mine);
        t->node[first + 1] = t->node[first];
        return -1;
    }
    return put_child(t, first, &children[0]);
}
