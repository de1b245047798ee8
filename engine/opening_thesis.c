/* opening_thesis - scenes of thesis nodes and float records
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/budget.h"
#include "engine/builder/build.h"
#include "engine/opening.h"
#include "engine/tree/thesis/validate.h"
#include "engine/tree/validate_records.h"

static int take_scene(const plt_opening *o) {
    plt_engine *e = o->e;
    plt_tree *tree = &e->walker.tree;
    const void *nodes = NULL, *records = NULL;
    const int build = e->header.info.build == PLT_BUILD_DEVICE;
    int status = plt_opening_section(o, PLT_SECTION_NODES, 0, &nodes);
    if (status == PLT_OK) {
        status = plt_opening_section(o, PLT_SECTION_TRIANGLES, build, &records);
    }
    if (status == PLT_OK) {
        status = plt_records_validate(&e->header, records, o->fault);
    }
    tree->nodes = nodes;
    tree->records = records;
    tree->node_slots = e->header.info.node_slots;
    tree->records_count = e->header.info.triangles;
    tree->treelet_nodes = e->header.info.treelet_nodes;
    tree->root = e->header.root;
    tree->box = plt_box_empty();
    for (int a = 0; a < 3 && tree->records_count > 0; a++) {
        tree->box.lo[a] = e->header.info.lo[a];
        tree->box.hi[a] = e->header.info.hi[a];
    }
    return status;
}

static int survey_or_check(const plt_opening *o, int built) {
    plt_engine *e = o->e;
    const size_t mark = e->arena.used;
    plt_validate_level *frames =
        plt_arena_cut(&e->arena, PLT_VALIDATE_LEVELS * sizeof(plt_validate_level));
    if (frames == NULL) {
        return plt_opening_short(o);
    }
    const uint32_t k = e->header.info.leaf_triangles;
    int status = built ? plt_tree_validate(&e->walker.tree, frames, &e->header.info, o->fault)
                       : plt_planes_validate(&e->header, e->walker.tree.nodes, o->fault);
    if (status == PLT_OK && !built) {
        status = plt_tree_validate_counts(&e->header, &e->walker.tree, frames, o->fault);
    }
    e->header.info.leaf_triangles = k;
    plt_arena_release(&e->arena, mark);
    return status;
}

/* Scratch that goes with as many nodes as fit beside it: 4 bytes a node and 16 a
 * treelet, plus what does not depend on their number. */
static size_t fair_scratch(const plt_info *info, size_t free_bytes) {
    const size_t fixed = plt_build_scratch_bytes(0, info->treelet_nodes);
    const size_t each = 4 + (16 + info->treelet_nodes - 1) / info->treelet_nodes;
    if (fixed > free_bytes) {
        return fixed;
    }
    return plt_arena_cut_bytes(fixed + (free_bytes - fixed) / (PLT_NODE_BYTES + each) * each);
}

/* Nodes grow over the free arena, scratch takes its end. */
static int run_build(const plt_opening *o, plt_build_job *job) {
    plt_engine *e = o->e;
    const plt_info *info = &e->header.info;
    const plt_info worst = plt_budget_worst_tree(info);
    const size_t free_bytes = e->arena.bytes - e->arena.used;
    const size_t most = (size_t)worst.node_slots * PLT_NODE_BYTES;
    size_t scratch = plt_arena_cut_bytes(plt_build_scratch_bytes(worst.nodes, info->treelet_nodes));
    if (most + scratch > free_bytes) { /* less than the bound: mostly still enough */
        scratch = fair_scratch(info, free_bytes);
    }
    if (scratch > free_bytes) {
        return plt_opening_short(o);
    }
    size_t room = (free_bytes - scratch) / PLT_NODE_BYTES;
    room = room < worst.node_slots ? room : worst.node_slots;
    job->nodes = plt_arena_cut(&e->arena, room * PLT_NODE_BYTES);
    job->scratch = plt_arena_cut(&e->arena, scratch);
    job->room = (uint32_t)room;
    job->scratch_bytes = scratch;
    if (job->nodes == NULL || job->scratch == NULL) {
        return plt_opening_short(o);
    }
    const int status = plt_build(job);
    if (status == PLT_ERR_ARENA) {
        return plt_opening_short(o);
    }
    return status == PLT_OK ? PLT_OK
                            : plt_limit(o->fault, "the scene needs more than PLT_DEPTH_MAX levels");
}

static int build_tree(const plt_opening *o) {
    plt_engine *e = o->e;
    plt_tree *tree = &e->walker.tree;
    plt_info *info = &e->header.info;
    /* The records are our copy in the arena: this is the one place that writes them. */
    plt_build_job job = {.records = (plt_record *)(uintptr_t)tree->records,
                         .count = info->triangles,
                         .leaf_triangles = info->leaf_triangles,
                         .treelet_nodes = info->treelet_nodes,
                         .splits = info->splits};
    const size_t mark = e->arena.used;
    const int status = run_build(o, &job);
    if (status != PLT_OK) {
        return status;
    }
    plt_arena_release(&e->arena, mark);
    plt_arena_cut(&e->arena, (size_t)job.node_slots * PLT_NODE_BYTES);
    tree->nodes = job.nodes;
    tree->node_slots = info->node_slots = job.node_slots;
    tree->root = e->header.root = job.root;
    info->node_bytes = job.node_slots * PLT_NODE_BYTES;
    return PLT_OK;
}

int plt_opening_thesis(const plt_opening *o) {
    const int build = o->e->header.info.build == PLT_BUILD_DEVICE;
    int status = take_scene(o);
    if (status == PLT_OK && build) {
        status = build_tree(o);
    }
    return status == PLT_OK ? survey_or_check(o, build) : status;
}
