/* figures - what was measured of one structure, in one scene, with one set of switches
 *
 * SPDX-License-Identifier: MIT */
#ifndef FIGURES_H
#define FIGURES_H

typedef enum figure {
    FIGURE_TRIANGLES,
    FIGURE_BYTES, /* nodes, and what leads from them to triangles */
    FIGURE_NODES,
    FIGURE_LEAVES,        /* lists that a node leads to by themselves */
    FIGURE_INTERMEDIATES, /* pairs of lists */
    FIGURE_SLOTS,         /* nodes and what is empty between them */
    FIGURE_TREELETS,
    FIGURE_INCOMPLETE, /* with empty slots */
    FIGURE_RAYS,
    FIGURE_PACKETS,
    FIGURE_NODE_ISECTS,     /* all packets together */
    FIGURE_TRIANGLE_ISECTS, /* likewise */
    FIGURE_MASKED,          /* part of their rays that was masked out, 0 .. 1 */
    FIGURE_SECONDS,         /* of the processor, the best run */
    FIGURE_CYCLES,          /* of that run; NaN: the system does not grant them */
    FIGURE_HITS,            /* rays that hit */
    FIGURES
} figure;

/* NaN: not measured. */
typedef struct figures {
    double of[FIGURES];
} figures;

#endif
