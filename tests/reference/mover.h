/* mover - a scene whose triangles move, in an arena of just its need, against one packed anew
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_MOVER_H
#define REFERENCE_MOVER_H

#include <math.h>
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/compare.h"
#include "tests/reference/guarded.h"
#include "tests/reference/shapes.h"
#include "tests/reference/tree_check.h"
#include "tests/test.h"

enum { MOVER_WAYS = 8 };

typedef struct mover {
    packed image;
    fake_link link; /* not mapped: the image comes through it */
    unsigned char *arena;
    size_t bytes; /* 0 before opening: the need */
    plt_engine *engine;
    plt_fault fault;
} mover;

/* Nodes of a treelet: with tiny limits of few stack entries one. */
static inline uint32_t mover_treelet(uint32_t nodes) {
    return rig_is_tiny() ? 1 : nodes;
}

static inline int mover_pack(mover *v, const mesh *m, const pack_options *o, fail *f) {
    quality_stats stats;
    return o->poses != NULL ? pack_mesh_better(&v->image, m, o, 0, &stats, "test", f)
                            : pack_mesh(&v->image, m, o, "test", f);
}

/* plt_open with config->run, movable: its status. v->bytes says how large the arena is. */
static inline int mover_open(mover *v, const mesh *m, const rig_config *config, int is_mapped) {
    fail f = {""};
    plt_options o = config->run;
    o.movable = 1;
    const size_t bytes = v->bytes;
    memset(v, 0, sizeof *v);
    CHECK(mover_pack(v, m, &config->pack, &f) == 0, "%s", f.text);
    const plt_source source = guarded_source(&v->link, &v->image, is_mapped);
    v->bytes = bytes > 0 ? bytes : plt_arena_need(&v->image.info, is_mapped, &o);
    v->arena = guarded_arena(&v->link, v->bytes);
    const int status = plt_open(&v->engine, v->arena, v->bytes, &source, &o, &v->fault);
    CHECK(status == PLT_OK || bytes > 0, "%s: %s", rig_name(config), v->fault.message);
    return status;
}

/* Also checks that nothing was written behind the arena. */
static inline void mover_close(mover *v) {
    for (unsigned i = 0; i < GUARDED_BYTES; i++) {
        CHECK(v->arena[v->bytes + i] == GUARDED_PATTERN, "written behind the arena");
    }
    free(v->arena);
    pack_free(&v->image);
}

static inline float (*mover_corners(const mesh *m))[9] {
    float(*corners)[9] = malloc((m->triangles + 1) * sizeof *corners);
    for (uint32_t i = 0; i < m->triangles; i++) {
        for (unsigned c = 0; c < 3; c++) {
            memcpy(&corners[i][3 * c], shape_corner(m, i, c), 3 * sizeof(float));
        }
    }
    return corners;
}

static inline int mover_move(mover *v, const mesh *m) {
    float(*corners)[9] = mover_corners(m);
    const int status = plt_move(v->engine, (const float(*)[9])corners, &v->fault);
    free(corners);
    return status;
}

/* ---- ways to move -------------------------------------------------------------- */

static inline void mover_stay(float p[3], random_state *r) {
    (void)p;
    (void)r;
}

static inline void mover_shiver(float p[3], random_state *r) {
    for (int a = 0; a < 3; a++) {
        p[a] += random_float(r, -0.02f, 0.02f);
    }
}

static inline void mover_twist(float p[3], random_state *r) {
    const float c = cosf(2.0f * p[1]), s = sinf(2.0f * p[1]), x = p[0];
    (void)r;
    p[0] = c * x - s * p[2];
    p[2] = s * x + c * p[2];
}

static inline void mover_mirror(float p[3], random_state *r) {
    (void)r;
    p[0] = -p[0];
    p[1] = p[1] * 3.0f + 1.0f;
}

/* Everything into a plane: triangles along it keep an area. */
static inline void mover_flatten(float p[3], random_state *r) {
    (void)r;
    p[1] = 0.25f;
}

static inline void mover_collapse(float p[3], random_state *r) {
    (void)r;
    p[0] = p[1] = p[2] = -0.0f;
}

/* Anywhere: the tree is of no use any more. */
static inline void mover_scatter(float p[3], random_state *r) {
    for (int a = 0; a < 3; a++) {
        p[a] = random_float(r, -50.0f, 50.0f);
    }
}

static inline void mover_far_away(float p[3], random_state *r) {
    (void)r;
    for (int a = 0; a < 3; a++) {
        p[a] = p[a] * 1e6f + 1e11f;
    }
}

static void (*const mover_ways[])(float p[3], random_state *r) = {
    mover_stay,    mover_shiver,  mover_twist,    mover_mirror,
    mover_flatten, mover_scatter, mover_collapse, mover_far_away};
_Static_assert(sizeof mover_ways / sizeof *mover_ways == MOVER_WAYS, "as the header says");

/* Each way to move, from where the vertices are. */
static inline void mover_deform(mesh *m, unsigned way) {
    random_state r = {way};
    for (size_t i = 0; i < m->vertices; i++) {
        mover_ways[way](&m->vertex[3 * i], &r);
    }
}

/* ---- what is to be the same ------------------------------------------------------- */

/* Where subtrees have been rebuilt, stack needs are bounds. */
static inline void mover_check_needs(const plt_info *info, const tree_facts *facts, int are_bounds,
                                     const char *name) {
    if (are_bounds) {
        CHECK(info->depth_stack_entries >= facts->depth &&
                  info->local_stack_entries >= facts->local &&
                  info->global_stack_entries >= facts->global && info->nodes == facts->nodes &&
                  info->treelets == facts->treelets && info->leaf_lists == facts->lists &&
                  info->intermediate_lists == facts->twos,
              "%s: counts are not the tree's, or needs are more: depth %u of %u, %u nodes of %u, "
              "%u treelets of %u",
              name, facts->depth, info->depth_stack_entries, facts->nodes, info->nodes,
              facts->treelets, info->treelets);
        return;
    }
    CHECK(info->depth_stack_entries == (facts->depth > 1 ? facts->depth : 1) &&
              info->local_stack_entries == facts->local &&
              info->global_stack_entries == (facts->global > 1 ? facts->global : 1) &&
              info->nodes == facts->nodes && info->treelets == facts->treelets,
          "%s: counts and needs are not the tree's", name);
}

/* The engine's tree is a good one, its boxes are tight, and it has the needs that are stated. */
static inline void mover_check_tree(const mover *v, const char *name) {
    const plt_engine *e = v->engine;
    const plt_info *info = plt_engine_info(e);
    if (info->build == PLT_BUILD_NONE || info->triangles == 0) {
        return;
    }
    tree_view view = tree_view_of(&v->image);
    view.nodes = (const unsigned char *)e->scene.thesis.nodes;
    view.records = (const unsigned char *)e->scene.thesis.records;
    view.slots = info->node_slots;
    view.root = e->scene.thesis.root;
    memcpy(view.lo, info->lo, sizeof view.lo);
    memcpy(view.hi, info->hi, sizeof view.hi);
    plt_motion motion;
    plt_motion_get(e, &motion);
    view.is_patched = motion.subtrees > 0 && motion.rebuilds > 0;
    const tree_facts facts = tree_check(&view);
    CHECK(facts.broken == 0, "%s: %s", name, facts.sentence);
    mover_check_needs(info, &facts, view.is_patched, name);
}

/* All of it, against `m` packed anew. */
static inline void mover_compare(mover *v, const mesh *m, const rig_config *config,
                                 const char *name) {
    rig fresh;
    rig_config still = *config;
    still.run.movable = still.run.moves_some = still.run.rebuild = 0;
    still.run.rebuild_most = 0;
    mover_check_tree(v, name);
    if (rig_open(&fresh, m, &still) == PLT_OK) {
        compare_scenes(v->engine, fresh.engine, m, name);
        rig_close(&fresh);
    }
}

#endif
