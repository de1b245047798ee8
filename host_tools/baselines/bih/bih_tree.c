/* bih_tree - see bih_tree.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bih/bih_tree.h"

#include "host_tools/base/heap.h"
#include "host_tools/baselines/planes/planes_axis.h"

static uint32_t words_of(const binary_node *n) {
    return binary_is_leaf(n) ? BIH_LEAF_WORDS : BIH_INNER_WORDS;
}

static void put_inner(bih_tree *b, planes_source *s, uint32_t node, uint32_t *place) {
    const uint32_t first = s->tree->node[node].first;
    const planes_cut cut = planes_source_cut(s, node);
    uint32_t *to = b->word + place[node];
    for (uint32_t c = 0; c < 2; c++) {
        place[first + c] = b->words;
        b->words += words_of(&s->tree->node[first + c]);
    }
    to[0] = place[first] << 2 | cut.axis;
    memcpy(&to[1], &cut.hi[0], sizeof to[1]);
    memcpy(&to[2], &cut.lo[1], sizeof to[2]);
}

/* place[] of a node is known once its parent is made. */
static void put_nodes(bih_tree *b, planes_source *s, uint32_t *place) {
    place[0] = 0;
    b->words = words_of(&s->tree->node[0]);
    for (uint32_t i = 0; i < s->tree->nodes; i++) {
        const binary_node *n = &s->tree->node[i];
        if (binary_is_leaf(n)) {
            b->word[place[i]] = n->first << 2 | BIH_LEAF;
        } else {
            put_inner(b, s, i, place);
        }
    }
}

int bih_tree_make(bih_tree *b, binary_tree *t) {
    const uint64_t inner = t->nodes - t->leaves;
    const uint64_t words = /* at most 2^29: links have 30 bits */
        BIH_INNER_WORDS * inner + BIH_LEAF_WORDS * (uint64_t)t->leaves;
    uint32_t *place = heap_get((uint64_t)t->nodes * sizeof *place);
    planes_source s;
    int status = planes_source_begin(&s, t, 0);
    *b = (bih_tree){.inner = (uint32_t)inner, .leaves = t->leaves};
    b->word = heap_get(words * sizeof *b->word);
    if (status != 0 || place == NULL || b->word == NULL) {
        bih_tree_free(b);
        status = -1;
    } else {
        put_nodes(b, &s, place);
    }
    planes_source_end(&s);
    heap_drop(place);
    return status;
}

void bih_tree_free(bih_tree *b) {
    heap_drop(b->word);
    memset(b, 0, sizeof *b);
}

uint64_t bih_tree_bytes(const bih_tree *b) {
    return (uint64_t)b->words * sizeof *b->word;
}
