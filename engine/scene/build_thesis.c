/* build_thesis - see build_thesis.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/build_thesis.h"

#include "engine/base/fault.h"
#include "engine/base/small_stack.h"
#include "engine/builder/build.h"
#include "engine/scene/validate_thesis.h"
#include "engine/tree/validate_records.h"

/* Scratch when the free bytes have to be shared between nodes and it: a fixed part comes
 * off first, and what is left is split so that every node has its PLT_NODE_BYTES and the
 * scratch that goes with it, 4 bytes and its share of 16 per treelet, rounded up. */
static size_t shared_scratch(const plt_info *info, size_t free_bytes) {
    const size_t fixed = plt_build_scratch_bytes(0, info->treelet_nodes);
    const size_t each = 4 + (16 + info->treelet_nodes - 1) / info->treelet_nodes;
    if (fixed > free_bytes) {
        return fixed;
    }
    return plt_arena_cut_bytes(fixed + (free_bytes - fixed) / (PLT_NODE_BYTES + each) * each);
}

/* Nodes grow over the free arena, scratch takes its end. */
static int cut_for_build(const plt_opening *o, plt_build_job *job) {
    const plt_info *info = &o->scene->info;
    const uint64_t most = o->layout->bytes[PLT_PART_TREE];
    const size_t free_bytes = o->arena->bytes - o->arena->used;
    uint64_t scratch = o->layout->bytes[PLT_PART_BUILDER];
    if (most + scratch > free_bytes) { /* less than the bound: mostly still enough */
        scratch = shared_scratch(info, free_bytes);
    }
    if (scratch > free_bytes) {
        return plt_opening_arena_error(o);
    }
    const uint64_t left = free_bytes - scratch;
    job->room = (uint32_t)((left < most ? left : most) / PLT_NODE_BYTES);
    job->scratch_bytes = (size_t)scratch;
    job->nodes = plt_arena_cut(o->arena, (size_t)job->room * PLT_NODE_BYTES);
    job->scratch = plt_arena_cut(o->arena, job->scratch_bytes);
    return job->nodes != NULL && job->scratch != NULL ? PLT_OK : plt_opening_arena_error(o);
}

static int run_build(const plt_opening *o, plt_build_job *job) {
    int status = cut_for_build(o, job);
    if (status == PLT_OK) {
        status = plt_build(job);
        if (status == PLT_ERR_ARENA) {
            return plt_opening_arena_error(o);
        }
    }
    return status == PLT_ERR_LIMIT
               ? plt_limit(o->fault, "the scene needs more than PLT_DEPTH_MAX levels")
               : status;
}

static void set_tree(const plt_opening *o, const plt_build_job *job) {
    plt_info *info = &o->scene->info;
    plt_tree *tree = &o->scene->thesis;
    tree->nodes = job->nodes;
    tree->records = job->records;
    tree->node_slots = info->node_slots = job->node_slots;
    tree->root = job->root;
    info->node_bytes = job->node_slots * PLT_NODE_BYTES;
}

/* Counts and stack needs of the new tree, as of one that was read; K stays as it is. */
PLT_APART_ON_SMALL_STACKS static int count(const plt_opening *o) {
    plt_info *info = &o->scene->info, counted;
    const int status = plt_thesis_validate(o, &o->scene->thesis, &counted);
    if (status == PLT_OK) {
        counted.leaf_triangles = info->leaf_triangles;
        *info = counted;
    }
    return status;
}

int plt_build_thesis(const plt_opening *o, const plt_header *header) {
    const void *nodes = NULL; /* an empty section; only its checksum is checked */
    void *records = NULL;
    int status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_NODES), &nodes);
    if (status == PLT_OK) {
        status = plt_opening_copy(o, plt_header_section(header, PLT_SECTION_TRIANGLES), &records);
    }
    if (status == PLT_OK) {
        status = plt_records_validate(header, records, o->fault);
    }
    if (status != PLT_OK) {
        return status;
    }
    const plt_info *info = &o->scene->info;
    plt_build_job job = {.records = records,
                         .count = info->triangles,
                         .leaf_triangles = info->leaf_triangles,
                         .treelet_nodes = info->treelet_nodes,
                         .splits = info->splits};
    const size_t mark = o->arena->used;
    status = run_build(o, &job);
    if (status != PLT_OK) {
        return status;
    }
    plt_arena_release(o->arena, mark);
    plt_arena_cut(o->arena, (size_t)job.node_slots * PLT_NODE_BYTES);
    set_tree(o, &job);
    return count(o);
}
