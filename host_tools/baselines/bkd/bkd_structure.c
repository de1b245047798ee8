/* bkd_structure - see bkd_structure.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bkd/bkd_structure.h"

#include "host_tools/baselines/bkd/bkd_trace.h"
#include "host_tools/baselines/bkd/bkd_tree.h"
#include "host_tools/baselines/planes/planes_structure.h"

enum form { SMALL, EXACT };

static int make(void *nodes, binary_tree *t, unsigned form) {
    return bkd_tree_make(nodes, t, form == EXACT);
}

static int refit(void *nodes, const plt_record *records) {
    return bkd_tree_refit(nodes, records);
}

static void drop(void *nodes) {
    bkd_tree_free(nodes);
}

static uint64_t bytes(const void *nodes) {
    return bkd_tree_bytes(nodes);
}

static const planes_layout layout = {.bytes_of_it = sizeof(bkd_tree),
                                     .make = make,
                                     .refit = refit,
                                     .drop = drop,
                                     .bytes = bytes,
                                     .lone = bkd_trace_lone,
                                     .packet = bkd_trace_packet,
                                     .build = {.splits = PLT_SPLIT_MEDIAN, .leaf = 1}};

static void *open_bkd(unsigned variant, const mesh *m, const structure_options *o, const char *name,
                      fail *f) {
    (void)variant;
    return planes_open(&layout, m, o, name, f);
}

static const structure_switch switches[] = {
    STRUCTURE_SPLIT_SWITCHES,
    {"exact", "planes are floats, 24 bytes per node, and not of 24 bits, rounded outwards",
     PLANES_FORM, EXACT},
    PLANES_WAY_SWITCHES,
    STRUCTURE_MASK_SWITCHES,
    STRUCTURE_EARLY_SWITCHES,
    STRUCTURE_FRUSTUM_SWITCHES,
    STRUCTURE_SINGLE_SWITCH,
    STRUCTURE_SIDE_SWITCHES,
    STRUCTURE_SIDE_16_SWITCH,
    {NULL, NULL, 0, 0}};

const structure_kind structure_bkd = {
    .name = "bkd",
    .about = "B-KD tree: across one axis, both planes of each child, refitted when triangles move",
    .open = open_bkd,
    .move = planes_move,
    .trace = planes_trace,
    .count = planes_count,
    .forget = planes_forget,
    .close = planes_close,
    .switches = switches,
    .suits = planes_suits};
