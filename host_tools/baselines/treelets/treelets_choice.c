/* treelets_choice - see treelets_choice.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/treelets/treelets_choice.h"

const uint32_t treelets_sizes[TREELETS_SIZES] = {2, 3, 7, 8, 16, 64, 256, 512, 10000};

enum { PLACE_OF_64 = 5 };

/* What a switch of a group chose, or else. */
static uint8_t chosen(const structure_options *o, unsigned group, uint8_t otherwise) {
    return o->choice[group] != 0 ? (uint8_t)(o->choice[group] - 1) : otherwise;
}

void treelets_choose(const structure_options *o, treelet_wish *wish, treelet_tracing *tracing) {
    const uint8_t order = chosen(o, TREELETS_ORDER, TREELET_FIGURE);
    wish->size = treelets_sizes[chosen(o, TREELETS_SIZE, PLACE_OF_64)];
    wish->fill = chosen(o, TREELETS_FILL, TREELET_FILL_BFS);
    wish->slots = chosen(o, TREELETS_SLOTS, TREELET_SLOTS_THESIS);
    tracing->order = (enum treelet_order)order;
    tracing->tests_again = chosen(o, TREELETS_AGAIN, order <= TREELET_MIRRORED) == 0;
}
