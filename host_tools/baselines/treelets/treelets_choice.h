/* treelets_choice - what switches choose of all trees in treelets
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_TREELETS_CHOICE_H
#define BASELINES_TREELETS_CHOICE_H

#include "host_tools/baselines/base/structure_types.h"
#include "host_tools/baselines/treelets/treelet_orders.h"
#include "host_tools/treelets/treelet_tree.h"

/* Groups of switches; a kind's own begin at TREELETS_OWN. */
enum treelets_choice {
    TREELETS_SIZE = STRUCTURE_OWN, /* the place in treelets_sizes, from 1 on */
    TREELETS_ORDER,                /* enum treelet_order + 1 */
    TREELETS_AGAIN,                /* 1: what comes off a stack is tested again, 2: it is not */
    TREELETS_FILL,                 /* enum treelet_fill + 1 */
    TREELETS_SLOTS,                /* enum treelet_slots + 1 */
    TREELETS_OWN
};

/* Of Tables 5.5 and 5.6. */
enum { TREELETS_SIZES = 9 };
extern const uint32_t treelets_sizes[TREELETS_SIZES];

/* Without a switch: N = 64, breadth first, the thesis's slots, and Figure 4.2. */
void treelets_choose(const structure_options *o, treelet_wish *wish, treelet_tracing *tracing);

#define TREELETS_SWITCHES                                                                          \
    {"tl2", "treelets of 2 nodes", TREELETS_SIZE, 1}, {"tl3", "of 3", TREELETS_SIZE, 2},           \
        {"tl7", "of 7", TREELETS_SIZE, 3}, {"tl8", "of 8", TREELETS_SIZE, 4},                      \
        {"tl16", "of 16", TREELETS_SIZE, 5}, {"tl64", "of 64", TREELETS_SIZE, 6},                  \
        {"tl256", "of 256", TREELETS_SIZE, 7}, {"tl512", "of 512", TREELETS_SIZE, 8},              \
        {"tl10k", "of 10,000", TREELETS_SIZE, 9},                                                  \
        {"figure", "edges as they come, the last first, as the thesis's Figure 4.2 has it",        \
         TREELETS_ORDER, TREELET_FIGURE + 1},                                                      \
        {"text", "likewise, near children first within a treelet, as its text has it",             \
         TREELETS_ORDER, TREELET_TEXT + 1},                                                        \
        {"mirrored", "likewise, far ones first, so that near edges are on top", TREELETS_ORDER,    \
         TREELET_MIRRORED + 1},                                                                    \
        {"sorted", "the edges of a treelet by distance", TREELETS_ORDER, TREELET_SORTED + 1},      \
        {"leaf-first", "likewise, and leaves before nodes", TREELETS_ORDER,                        \
         TREELET_LEAF_FIRST + 1},                                                                  \
        {"heap", "of all edges that wait the nearest", TREELETS_ORDER, TREELET_HEAP + 1},          \
        {"depth", "depth first across treelets", TREELETS_ORDER, TREELET_DEPTH + 1},               \
        {"again", "what comes off a stack is tested again", TREELETS_AGAIN, 1},                    \
        {"once", "it is not", TREELETS_AGAIN, 2},                                                  \
        {"bfs", "treelets fill breadth first", TREELETS_FILL, TREELET_FILL_BFS + 1},               \
        {"area", "with the largest boxes", TREELETS_FILL, TREELET_FILL_AREA + 1},                  \
        {"full", "so that few stay incomplete", TREELETS_FILL, TREELET_FILL_FULL + 1},             \
        {"share", "incomplete ones last, where they fit exactly, else where most is free",         \
         TREELETS_SLOTS, TREELET_SLOTS_THESIS + 1},                                                \
        {"newest", "as they come, into the newest block with room", TREELETS_SLOTS,                \
         TREELET_SLOTS_NEWEST + 1},                                                                \
        {"apart", "into blocks of their own", TREELETS_SLOTS, TREELET_SLOTS_NONE + 1}, {           \
        "come", "as they come, where they fit exactly, else where most is free", TREELETS_SLOTS,   \
            TREELET_SLOTS_COME + 1                                                                 \
    }

#endif
