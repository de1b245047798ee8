/* rebuild - see rebuild.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/rebuild.h"

#include "engine/lanes/lanes.h"
#include "engine/motion/subtree_slots.h"
#include "engine/tree/thesis/validate.h"

/* Records whose sources are asked for before their turn: they lie in the order of the old tree. */
enum { AHEAD = 8 };

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

#if PLT_WITH_SUBTREES
static uint32_t first_of(const plt_rebuild *r) {
    return r->part == NULL ? 0 : r->part->first;
}
#else
static uint32_t first_of(const plt_rebuild *r) {
    (void)r;
    return 0;
}
#endif

void plt_rebuild_start(plt_rebuild *r, const plt_info *info) {
    r->info = *info;
    r->at = 0;
    r->phase = PLT_REBUILD_COPIES;
    r->build.records = r->records;
    r->build.nodes = r->nodes;
    r->build.room = r->room;
    r->build.count = info->triangles;
    r->build.leaf_triangles = info->leaf_triangles;
    r->build.treelet_nodes = info->treelet_nodes;
    r->build.splits = info->splits;
    r->build.box = plt_box_empty();
#if PLT_WITH_SUBTREES
    r->part = NULL;
    r->build.depth = r->build.is_paced = r->build.depth_max = 0;
#endif
}

#if PLT_WITH_SUBTREES
void plt_rebuild_start_part(plt_rebuild *r, const plt_info *info, plt_subtree *part, float scale) {
    plt_rebuild_start(r, info);
    r->part = part;
    r->scale = scale;
    r->build.room = part->slots;
    r->build.count = part->count;
    r->build.depth = part->depth;
    r->build.is_paced = 1;
}

void plt_rebuild_swap_part(plt_rebuild *r, plt_tree *tree) {
    plt_subtree_put(r->part, tree, r->nodes, r->build.nodes_used, r->records, r->build.scratch,
                    &r->info);
    r->part->ratios = r->refit.areas.ratios;
    r->part->sum = r->refit.areas.sum;
    r->info.depth_stack_entries = r->build.depth_max > r->info.depth_stack_entries
                                      ? r->build.depth_max
                                      : r->info.depth_stack_entries;
    r->info.local_stack_entries = r->info.depth_stack_entries;
    r->info.global_stack_entries = r->info.nodes + 1; /* as many leaf links there are */
    r->phase = PLT_REBUILD_IDLE;
}
#endif

/* The step goes from record `at` to the one that is returned. */
static uint32_t step_end(const plt_rebuild *r, uint32_t triangles) {
    return r->at + least(triangles, r->build.count - r->at);
}

static int copy(plt_rebuild *r, const plt_tree *tree, uint32_t triangles) {
    const uint32_t end = step_end(r, triangles);
    const plt_record *from = tree->records + first_of(r);
    for (uint32_t i = r->at; i < end; i++) {
        const plt_box box = plt_record_box(&from[i]);
        r->records[i] = from[i];
        plt_put_u32(&r->records[i].word[9], i);
        plt_box_add(&r->build.box, &box);
    }
    r->at = end;
    if (end < r->build.count) {
        return PLT_MORE;
    }
    r->phase = PLT_REBUILD_SPLITS;
    const int status = plt_build_begin(&r->build);
    return status == PLT_OK ? PLT_MORE : status;
}

static void begin_to_collect(plt_rebuild *r) {
    r->phase = PLT_REBUILD_COLLECTS;
    r->at = 0;
}

#if PLT_WITH_SUBTREES
/* Scratch of the builder is free. */
static int find_slots(plt_rebuild *r, const plt_tree *tree) {
    plt_subtree_slots(r->part, tree, r->build.scratch, &r->info);
    r->build.root = 0;
    begin_to_collect(r);
    return PLT_MORE;
}
#endif

static int split(plt_rebuild *r, const plt_tree *tree, uint32_t triangles) {
    const int status = plt_build_split(&r->build, triangles);
    if (status != PLT_OK) {
        return status;
    }
#if PLT_WITH_SUBTREES
    if (r->part != NULL) {
        return find_slots(r, tree);
    }
#endif
    (void)tree;
    r->phase = PLT_REBUILD_TREELETS;
    return plt_build_treelets_begin(&r->build) == PLT_OK ? PLT_MORE : PLT_ERR_ARENA;
}

static plt_tree new_tree(const plt_rebuild *r) {
    const plt_tree tree = {.nodes = r->nodes,
                           .records = r->records,
                           .node_slots = r->build.node_slots,
                           .records_count = r->build.count,
                           .treelet_nodes = r->build.treelet_nodes,
                           .root = r->build.root};
    return tree;
}

/* Lists without a node: there is one link, and no stack holds more. */
static int count_lists(plt_rebuild *r) {
    const int is_intermediate = plt_link_lists(r->build.root) == 2;
    r->info.nodes = r->info.treelets = r->info.local_stack_entries = 0;
    r->info.leaf_lists = is_intermediate ? 0 : 1;
    r->info.intermediate_lists = is_intermediate ? 1 : 0;
    r->info.global_stack_entries = r->info.depth_stack_entries = 1;
    begin_to_collect(r);
    return PLT_MORE;
}

/* Scratch of the builder is free. */
static int begin_to_count(plt_rebuild *r) {
    const plt_tree tree = new_tree(r);
    r->info.node_slots = r->build.node_slots;
    r->info.node_bytes = r->build.node_slots * PLT_NODE_BYTES;
    if (plt_link_is_leaf(tree.root)) {
        return count_lists(r);
    }
    r->counting.levels = r->build.scratch;
    plt_tree_count_begin(&r->counting, &tree, &r->info);
    r->phase = PLT_REBUILD_COUNTS;
    return PLT_MORE;
}

static int form_treelets(plt_rebuild *r, uint32_t triangles) {
    const int status = plt_build_treelets(&r->build, triangles);
    return status == PLT_OK ? begin_to_count(r) : status;
}

/* K stays as it is. */
static int count(plt_rebuild *r, uint32_t triangles) {
    const plt_tree tree = new_tree(r);
    const int status = plt_tree_count(&r->counting, &tree, triangles, &r->info);
    r->info.leaf_triangles = r->build.leaf_triangles;
    if (status == PLT_OK && r->info.global_stack_entries <= PLT_GLOBAL_STACK_MAX) {
        begin_to_collect(r);
        return PLT_MORE;
    }
    return status == PLT_MORE ? PLT_MORE : PLT_ERR_LIMIT;
}

static float scale_of(const plt_rebuild *r) {
#if PLT_WITH_SUBTREES
    if (r->part != NULL) {
        return r->scale;
    }
#endif
    return plt_areas_scale(&r->build.box);
}

/* Corners and ids of the old records, which nobody asks for by their ids from now on; which is the
 * last of its list is the new tree's. */
static int collect(plt_rebuild *r, const plt_tree *tree, uint32_t triangles) {
    const uint32_t end = step_end(r, triangles), first = first_of(r);
    const plt_record *from = tree->records + first;
    for (uint32_t i = r->at; i < end; i++) {
        plt_record *to = &r->records[i];
        const uint32_t word = plt_get_u32(&to->word[9]);
        const uint32_t ahead = least(i + AHEAD, r->build.count - 1);
        plt_prefetch(&from[plt_primitive_id(plt_get_u32(&r->records[ahead].word[9]))]);
        *to = from[plt_primitive_id(word)];
        plt_record_set_last(to, (word & PLT_RECORD_LAST) != 0);
        if (r->places != NULL) {
            r->places[plt_primitive_id(plt_get_u32(&to->word[9]))] = first + i;
        }
    }
    r->at = end;
    if (end == r->build.count) {
        r->phase = PLT_REBUILD_REFITS;
        r->refit.nodes = r->nodes;
        r->refit.records = r->records;
        r->refit.root = r->build.root;
        r->refit.areas.scale = scale_of(r);
        r->refit.areas.is_wanted = 1;
        plt_refit_begin(&r->refit);
    }
    return PLT_MORE;
}

static int refit(plt_rebuild *r, uint32_t triangles) {
    const uint32_t each = 2 * r->info.leaf_triangles; /* of a leaf link, at most */
    const uint32_t lists = triangles > each ? triangles / each : 1;
    const int status = plt_refit_step(&r->refit, lists);
    r->phase = status == PLT_OK ? PLT_REBUILD_READY : PLT_REBUILD_REFITS;
    return status;
}

static int work(plt_rebuild *r, const plt_tree *tree, uint32_t triangles) {
    switch (r->phase) {
    case PLT_REBUILD_COPIES:
        return copy(r, tree, triangles);
    case PLT_REBUILD_SPLITS:
        return split(r, tree, triangles);
    case PLT_REBUILD_TREELETS:
        return form_treelets(r, triangles);
    case PLT_REBUILD_COUNTS:
        return count(r, triangles);
    case PLT_REBUILD_COLLECTS:
        return collect(r, tree, triangles);
    case PLT_REBUILD_REFITS:
        return refit(r, triangles);
    default:
        return PLT_OK;
    }
}

int plt_rebuild_work(plt_rebuild *r, const plt_tree *tree, uint32_t triangles) {
    const int status = work(r, tree, triangles);
    if (status < PLT_OK) {
        r->phase = PLT_REBUILD_IDLE;
    }
    return status;
}

int plt_rebuild_must_end(const plt_rebuild *r) {
    return r->phase >= PLT_REBUILD_COLLECTS;
}

void plt_rebuild_end(plt_rebuild *r, const plt_tree *tree, int refits) {
    const uint8_t last = refits ? PLT_REBUILD_READY : PLT_REBUILD_REFITS;
    while (r->phase < last) {
        (void)plt_rebuild_work(r, tree, UINT32_MAX);
    }
    r->phase = PLT_REBUILD_READY;
}

void plt_rebuild_swap(plt_rebuild *r, plt_tree *tree) {
    const plt_tree old = *tree;
    const uint32_t room = r->room;
    *tree = new_tree(r);
    r->records = (plt_record *)(uintptr_t)old.records;
    r->nodes = (plt_node *)(uintptr_t)old.nodes;
    r->room = r->old_room;
    r->old_room = room;
    r->phase = PLT_REBUILD_IDLE;
}
