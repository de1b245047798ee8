/* bih_structure - see bih_structure.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bih/bih_structure.h"

#include "host_tools/baselines/bih/bih_trace.h"
#include "host_tools/baselines/bih/bih_tree.h"
#include "host_tools/baselines/planes/planes_structure.h"

static int make(void *nodes, binary_tree *t, unsigned form) {
    (void)form;
    return bih_tree_make(nodes, t);
}

static void drop(void *nodes) {
    bih_tree_free(nodes);
}

static uint64_t bytes(const void *nodes) {
    return bih_tree_bytes(nodes);
}

static const planes_layout layout = {.bytes_of_it = sizeof(bih_tree),
                                     .make = make,
                                     .drop = drop,
                                     .bytes = bytes,
                                     .lone = bih_trace_lone,
                                     .packet = bih_trace_packet,
                                     .build = {.leaf = 1, .by_grid = 1}};

static void *open_bih(unsigned variant, const mesh *m, const structure_options *o, const char *name,
                      fail *f) {
    (void)variant;
    return planes_open(&layout, m, o, name, f);
}

static const structure_switch switches[] = {STRUCTURE_SPLIT_SWITCHES, STRUCTURE_LEAF_SWITCHES,
                                            PLANES_WAY_SWITCHES,      STRUCTURE_MASK_SWITCHES,
                                            STRUCTURE_EARLY_SWITCHES, STRUCTURE_FRUSTUM_SWITCHES,
                                            STRUCTURE_SINGLE_SWITCH,  STRUCTURE_SIDE_SWITCHES,
                                            STRUCTURE_SIDE_16_SWITCH, {NULL, NULL, 0, 0}};

const structure_kind structure_bih = {
    .name = "bih",
    .about =
        "bounding interval hierarchy: across one axis, the inner plane of each child, split "
        "on a grid of the scene, unless a switch says how",
    .open = open_bih,
    .move = planes_move,
    .trace = planes_trace,
    .count = planes_count,
    .forget = planes_forget,
    .close = planes_close,
    .switches = switches,
    .suits = planes_suits};
