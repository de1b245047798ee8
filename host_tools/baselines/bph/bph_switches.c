/* bph_switches - see bph_switches.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bph/bph_switches.h"

#include "engine/planelet.h"

enum group { INTERMEDIATES = STRUCTURE_OWN, CHILDREN, SIGNS, ORDER, MOVING };

enum intermediates { DIRECT = 1, RECOMPUTE, UNMERGED };
enum { CLIP = 1, NAIVE };
enum { EQUAL = 1, MIXED };
enum { NEAR = 1, LEFT };
enum { REFIT = 1, REBUILD };

/* Beyond those that are shared. */
enum { ALL_RAYS = STRUCTURE_BITS + 1, COUNTED = 255 };

const structure_switch bph_switches[] = {
    STRUCTURE_SPLIT_SWITCHES,
    STRUCTURE_LEAF_SWITCHES,
    {"counts", "lists as long as they pay, counted in nodes of 40 bytes", STRUCTURE_LEAF, COUNTED},
    {"direct", "both lists of an intermediate node are tested", INTERMEDIATES, DIRECT},
    {"recompute", "their boxes are first, made anew from the triangles", INTERMEDIATES, RECOMPUTE},
    {"unmerged", "no intermediate nodes: a node has two lists", INTERMEDIATES, UNMERGED},
    {"clip", "rays keep intervals, which both children's planes clip in one pass", CHILDREN, CLIP},
    {"naive", "both children's boxes are reconstructed and tested as boxes", CHILDREN, NAIVE},
    STRUCTURE_MASK_SWITCHES,
    {"all", "every ray goes along while one is active", STRUCTURE_MASKS, ALL_RAYS},
    {"equal", "planes are matched once for packets of equal signs", SIGNS, EQUAL},
    {"mixed", "they are for each ray", SIGNS, MIXED},
    {"near", "the child comes first that is nearer", ORDER, NEAR},
    {"left", "the left one does", ORDER, LEFT},
    STRUCTURE_EARLY_SWITCHES,
    STRUCTURE_FRUSTUM_SWITCHES,
    {"refit", "boxes are fitted to triangles that moved", MOVING, REFIT},
    {"rebuild", "a new tree is built of them", MOVING, REBUILD},
    STRUCTURE_SINGLE_SWITCH,
    STRUCTURE_SIDE_SWITCHES,
    STRUCTURE_SIDE_16_SWITCH,
    {NULL, NULL, 0, 0}};

int bph_switches_suit(const structure_options *o, fail *f) {
    const uint8_t *c = o->choice;
    if (c[STRUCTURE_LEAF] == COUNTED && c[INTERMEDIATES] == RECOMPUTE) {
        return fail_set(f, "bph",
                        "counts and recompute: an intermediate node has the sum of two counts, so "
                        "it is not known where its second list begins; give counts with direct or "
                        "unmerged, or recompute with leaf-1, leaf-2, leaf-3 or leaf-4");
    }
    if (c[STRUCTURE_EARLY] == 1 && c[STRUCTURE_MASKS] == ALL_RAYS) {
        return fail_set(f, "bph",
                        "early and all: of rays that all go along none is the first active one; "
                        "give early with bits or range");
    }
    if (c[STRUCTURE_FRUSTUM] == 1 && c[SIGNS] == MIXED) {
        return fail_set(f, "bph",
                        "frustum and mixed: rays whose signs are not known to be equal have no "
                        "hull; give frustum with equal");
    }
    return 0;
}

bph_way bph_way_of(const structure_options *o) {
    const uint8_t *c = o->choice;
    const uint8_t leaf = c[STRUCTURE_LEAF];
    const bph_way way = {
        .format = {.most = leaf > 0 ? leaf : 1,
                   .has_counts = leaf == COUNTED,
                   .is_unmerged = c[INTERMEDIATES] == UNMERGED},
        .splits = c[STRUCTURE_SPLITS] == STRUCTURE_SAH ? PLT_SPLIT_SAH : PLT_SPLIT_MEDIAN,
        .recomputes = c[INTERMEDIATES] == RECOMPUTE,
        .is_naive = c[CHILDREN] == NAIVE,
        .active = c[STRUCTURE_MASKS] == STRUCTURE_RANGE ? BPH_RANGE
                  : c[STRUCTURE_MASKS] == ALL_RAYS      ? BPH_ALL
                                                        : BPH_MASK,
        .is_mixed = c[SIGNS] == MIXED,
        .is_left_first = c[ORDER] == LEFT,
        .hits_early = c[STRUCTURE_EARLY] == 1,
        .has_frustum = c[STRUCTURE_FRUSTUM] == 1,
        .rebuilds = c[MOVING] == REBUILD,
    };
    return way;
}
