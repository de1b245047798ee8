/* bph_switches - what of the thesis is on: `bph:SWITCH,SWITCH`
 *
 * Without any, a BPH is what the thesis measured: lists of one triangle, spatial median,
 * intermediate nodes whose lists are tested directly, intervals of rays clipped by the planes that
 * a node stores, a mask of rays, planes matched to children once for packets of equal signs, the
 * nearer child first, and neither early hits nor a frustum.
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BPH_SWITCHES_H
#define BASELINES_BPH_SWITCHES_H

#include "host_tools/base/fail.h"
#include "host_tools/baselines/base/structure_types.h"
#include "host_tools/baselines/bph/bph_tree.h"

enum bph_active { BPH_MASK, BPH_RANGE, BPH_ALL };

typedef struct bph_way {
    bph_format format;
    uint8_t splits;        /* enum plt_splits */
    uint8_t recomputes;    /* 1: boxes of an intermediate node's lists, from their triangles */
    uint8_t is_naive;      /* 1: both children's boxes are reconstructed and tested as boxes */
    uint8_t active;        /* enum bph_active: the rays that go on below a node */
    uint8_t is_mixed;      /* 1: planes are matched for each ray, whatever its packet's signs */
    uint8_t is_left_first; /* 1: the left child first, not the nearer */
    uint8_t hits_early, has_frustum;
    uint8_t rebuilds; /* 1: triangles that move get a new tree; 0: the old one is refitted */
} bph_way;

extern const structure_switch bph_switches[];

/* -1: switches that make no sense together; `f` says which do. */
int bph_switches_suit(const structure_options *o, fail *f);

bph_way bph_way_of(const structure_options *o);

#endif
