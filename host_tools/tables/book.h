/* book - all figures that the tables are made of, scene by scene
 *
 * SPDX-License-Identifier: MIT */
#ifndef BOOK_H
#define BOOK_H

#include "host_tools/base/progress.h"
#include "host_tools/tables/cache.h"
#include "host_tools/tables/gallery.h"
#include "host_tools/tables/measure.h"
#include "host_tools/tables/printed.h"

enum book_size { BOOK_BVH, BOOK_WBVH, BOOK_BKD, BOOK_BPH, BOOK_BPH2, BOOK_SIZES };
enum book_split { BOOK_MEDIAN, BOOK_SAH, BOOK_SPLITS };
enum book_racer { BOOK_RACE_WBVH, BOOK_RACE_BPH, BOOK_RACE_ENGINE, BOOK_RACERS };
/* In which order edges that leave a treelet are taken (baselines/treelets/treelet_orders.h). */
enum book_order {
    BOOK_ORDER_FIGURE,
    BOOK_ORDER_TEXT,
    BOOK_ORDER_MIRRORED,
    BOOK_ORDER_SORTED,
    BOOK_ORDER_DEPTH,
    BOOK_ORDERS
};
enum { BOOK_SIDES = 3, BOOK_TREELETS = 1 + PRINTED_TREELET_SIZES }; /* 0: without treelets */

extern const char *const book_sides[BOOK_SIDES]; /* "4x4" ... */

typedef struct book_scene {
    int is_there; /* 0: not asked for */
    unsigned triangles;
    gallery_about about;
    figures size[BOOK_SIZES];
    figures traced[BOOK_SPLITS][BOOK_SIDES];
    figures treelets[PRINTED_TREELET_SIZES];
    figures treed[BOOK_ORDERS][BOOK_TREELETS]; /* packets of 4x4 */
    figures race[BOOK_SIDES][BOOK_RACERS];
    picture picture; /* 0: not asked for */
} book_scene;

typedef struct book_animation {
    int is_there;
    unsigned triangles;
    gallery_about about;
    figures race[BOOK_SIDES][BOOK_RACERS];
} book_animation;

typedef struct book_options {
    unsigned tables; /* bit i - 1: Table 5.i */
    unsigned rows;   /* bit i: scene i, and its animation */
    unsigned steps;  /* frames of each animation */
    int pictures;
} book_options;

typedef struct book {
    book_options options;
    gallery gallery;
    meter meter;
    cache *cache; /* NULL: there is none */
    uint64_t program;
    book_scene scene[PRINTED_SCENES];
    book_animation animation[PRINTED_ANIMATIONS];
    unsigned measured, from_cache;
    progress bar;
    unsigned jobs, done;
    char doing[64];
} book;

/* The most memory that writing it takes with meshes as large as those that were printed, whatever
 * the size and number of pictures: rays are not kept. In bytes. */
uint64_t book_bytes(const book *b);

/* Fills the book; options, gallery, meter and cache are set. */
int book_write(book *b, fail *f);
void book_free(book *b);

/* Whether a table, 1 to 6, is in it. */
static inline int book_has(const book *b, unsigned table) {
    return (int)(b->options.tables >> (table - 1) & 1u);
}

#endif
