/* printed - the numbers of the thesis's Tables 5.1 to 5.6, letter by letter
 *
 * Cells are texts as they stand on the page. What is suspected to be a misprint stays as it is
 * printed, and has a remark.
 *
 * Source: R. Karrenberg, "Memory Aware Realtime Ray Tracing: The Bounding Plane Hierarchy",
 * bachelor thesis, Saarland University, 2007, pages 33 to 42.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PRINTED_H
#define PRINTED_H

/* Rows of every table are the scenes in this order; Table 5.3 has the animations below them. */
enum {
    PRINTED_GROUND,
    PRINTED_SHUTTLE,
    PRINTED_WOODDOLL,
    PRINTED_MARBLES,
    PRINTED_TOASTERS,
    PRINTED_HAND,
    PRINTED_BUNNY,
    PRINTED_BEN,
    PRINTED_FAIRY,
    PRINTED_DRAGON,
    PRINTED_BUDDHA,
    PRINTED_SCENES,
    PRINTED_ANIMATIONS = 6,
    PRINTED_TABLES = 6
};

typedef struct printed_scene {
    const char *name;
    unsigned triangles;
} printed_scene;

extern const printed_scene printed_scenes[PRINTED_SCENES];

typedef struct printed_animation {
    const char *name; /* as Table 5.3 spells it */
    unsigned frames;
    unsigned scene; /* its first frame */
} printed_animation;

extern const printed_animation printed_animations[PRINTED_ANIMATIONS];

typedef struct printed_table {
    const char *number, *title;
    unsigned columns, rows;
    const char *const *group;  /* what stands above each column; "": nothing */
    const char *const *column; /* its own head */
    const char *const *cell;   /* rows x columns */
    const char *const *remark; /* NULL ends them */
} printed_table;

/* `table` is 1 .. PRINTED_TABLES, for 5.1 to 5.6. */
const printed_table *printed_of(unsigned table);
const char *printed_cell(unsigned table, unsigned row, unsigned column);

/* "1,285K" is 1285000, "9K(13)" 9000; of one that has no number NaN. */
double printed_value(const char *cell);
/* The unit of its last digit: 1000 of "9K", 100 of "0.5K". */
double printed_step(const char *cell);
/* "9K(13)" is 13, which are incomplete treelets; of one without brackets NaN. */
double printed_in_brackets(const char *cell);

/* Bytes of Table 5.1, `column` 1 to 5: as printed but for the shuttle's BPH2, where 0.8K is taken
 * for a misprint of 8K. */
double printed_bytes(unsigned scene, unsigned column);

/* From Table 5.2: bytes saved over 28, the step between their numbers in all rows. */
unsigned printed_intermediates(unsigned scene);
/* Inner nodes of the BPH: triangles - 1 - intermediates, which times 32 is Table 5.1. */
unsigned printed_nodes(unsigned scene);

enum { PRINTED_INTERMEDIATE_BYTES = 28, PRINTED_NODE_BYTES = 32, PRINTED_TREELET_SIZES = 9 };

/* Of Tables 5.5 and 5.6, in inner nodes. */
extern const unsigned printed_treelet_sizes[PRINTED_TREELET_SIZES];

#endif
