/* engine_structure - the engine's trees and grid as structures
 *
 * A mesh is packed as thesis nodes and opened in an arena that has room for what moving it takes.
 * A frame is plt_move, and a rebuild when one is due, all of it before the frame is traced. An
 * engine that others have opened is traced as it is.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/engine_structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/pack/pack.h"

enum variant { TREE, TREE_NEVER, TREE_ALWAYS, GRID, OPENED };

enum { GRID_BYTES = PLT_GRID_TRIANGLE_BYTES + 8 }; /* per triangle, all that a grid takes */
enum { STEP = 1 << 30 };                           /* a rebuild is one step */

typedef struct engine_structure {
    unsigned variant;
    packed image; /* of OPENED neither this nor an arena */
    void *arena;
    plt_engine *engine;
    float (*corners)[9];
    uint64_t build_work;
    uint32_t triangles;
    char name[64];
} engine_structure;

static const uint8_t rebuilds[] = {[TREE] = PLT_REBUILD_COST,
                                   [TREE_NEVER] = PLT_REBUILD_NEVER,
                                   [TREE_ALWAYS] = PLT_REBUILD_ALWAYS,
                                   [GRID] = PLT_REBUILD_NEVER,
                                   [OPENED] = PLT_REBUILD_NEVER};

static plt_options options_of(const engine_structure *e, const structure_options *o) {
    const int is_tree = e->variant != GRID;
    const uint8_t most = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8;
    plt_options to = {.packet_side = o->packet_side > 0 ? o->packet_side : most,
                      .movable = PLT_WITH_MOTION,
                      .structure = is_tree ? PLT_STRUCTURE_TREE : PLT_STRUCTURE_GRID,
                      .rebuild = is_tree && rebuilds[e->variant] != PLT_REBUILD_NEVER};
    if (is_tree) {
        to.rays_in_flight = 32;
        to.rays = o->one_by_one        ? PLT_RAYS_INCOHERENT
                  : o->packet_side > 0 ? PLT_RAYS_COHERENT
                                       : PLT_RAYS_AUTO;
    }
    return to;
}

static int open_engine(engine_structure *e, const structure_options *o, fail *f) {
    const plt_options options = options_of(e, o);
    const plt_source source = {.mapped = e->image.bytes, .bytes = e->image.size};
    const uint64_t need = plt_arena_need(&e->image.info, 1, &options);
    const uint64_t spare = e->variant == GRID ? (uint64_t)GRID_BYTES * e->triangles : 0;
    const uint64_t bytes = (need + spare) / PLT_ALIGN * PLT_ALIGN;
    plt_fault fault;
    if (need == 0) {
        return fail_set(f, e->name, "this build cannot open it; choose another structure");
    }
    e->arena = heap_get_aligned(bytes);
    if (e->arena == NULL) {
        return fail_set(f, e->name, "out of memory for an arena of %llu bytes; leave out triangles",
                        (unsigned long long)bytes);
    }
    const int status = plt_open(&e->engine, e->arena, (size_t)bytes, &source, &options, &fault);
    return status == PLT_OK ? 0
                            : fail_set(f, e->name, "%s; choose another structure", fault.message);
}

static void close_engine(void *self) {
    engine_structure *e = self;
    heap_drop(e->arena);
    heap_drop(e->corners);
    pack_free(&e->image);
    heap_drop(e);
}

static void *open_tree(unsigned variant, const mesh *m, const structure_options *o,
                       const char *name, fail *f) {
    const pack_options options = {.leaf_triangles = 4,
                                  .treelet_nodes = PLT_GLOBAL_STACK_MAX < 64 ? 1 : 64,
                                  .splits = PLT_SPLIT_SAH,
                                  .build = PLT_BUILD_HOST};
    engine_structure *e = heap_get_zeroed(sizeof *e);
    if (e == NULL) {
        return NULL;
    }
    e->variant = variant;
    e->triangles = (uint32_t)m->triangles;
    strncpy(e->name, name, sizeof e->name - 1);
    if (pack_mesh(&e->image, m, &options, name, f) != 0 || open_engine(e, o, f) != 0) {
        close_engine(e);
        return NULL;
    }
    return e;
}

void *engine_structure_of(plt_engine *engine, const char *name) {
    engine_structure *e = heap_get_zeroed(sizeof *e);
    if (e != NULL) {
        e->variant = OPENED;
        e->engine = engine;
        e->triangles = plt_engine_info(engine)->triangles;
        strncpy(e->name, name, sizeof e->name - 1);
    }
    return e;
}

static int fill_corners(engine_structure *e, const mesh *m, fail *f) {
    if (e->corners == NULL) {
        e->corners = heap_get((uint64_t)e->triangles * sizeof *e->corners + 1);
    }
    if (e->corners == NULL) {
        return fail_set(f, e->name, "out of memory for corners; leave out triangles");
    }
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        memcpy(&e->corners[i / 3][3 * (i % 3)], m->vertex + 3 * (size_t)m->triangle[i],
               3 * sizeof(float));
    }
    return 0;
}

/* One that does not fit goes on with the old tree. */
static void rebuild(engine_structure *e, plt_fault *fault) {
    int status = plt_rebuild_begin(e->engine, fault);
    while (status == PLT_OK && (status = plt_rebuild_step(e->engine, STEP, fault)) == PLT_MORE) {
        status = PLT_OK;
    }
    e->build_work += e->triangles;
}

static int move_tree(void *self, const mesh *m, fail *f) {
    engine_structure *e = self;
    plt_fault fault;
    if (fill_corners(e, m, f) != 0) {
        return -1;
    }
    if (plt_move(e->engine, (const float(*)[9])e->corners, &fault) != PLT_OK) {
        return fail_set(f, e->name, "%s; write numbers within 2^40", fault.message);
    }
    if (plt_rebuild_due(e->engine, rebuilds[e->variant], 0)) {
        rebuild(e, &fault);
    }
    return 0;
}

static int trace_tree(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                      fail *f) {
    engine_structure *e = self;
    if (plt_trace(e->engine, rays, hits, count, any) != PLT_OK) {
        return fail_set(f, e->name, "not traced; choose another structure");
    }
    return 0;
}

static void count_tree(const void *self, structure_statistics *to) {
    const engine_structure *e = self;
    const plt_info *info = plt_engine_info(e->engine);
    plt_stats s;
    plt_stats_get(e->engine, &s);
    const uint64_t used = plt_arena_used(e->engine);
    *to = (structure_statistics){.rays = s.rays,
                                 .node_visits = s.node_visits,
                                 .box_tests = s.group_tests,
                                 .triangle_tests = s.triangle_tests,
                                 .build_work = e->build_work,
                                 .triangle_bytes = (uint64_t)e->triangles * sizeof(plt_record)};
    to->bytes = e->variant == GRID ? used - to->triangle_bytes : (uint64_t)info->node_slots * 32;
    if (info->nodes_format == PLT_NODES_COMPACT) {
        to->bytes = info->node_bytes;
        to->triangle_bytes = info->triangle_bytes;
    }
    if (e->variant != GRID) {
        to->nodes = info->nodes;
        to->leaves = info->leaf_lists + info->intermediate_lists;
        to->references = e->triangles;
    }
}

static void forget_tree(void *self) {
    plt_stats_reset(((engine_structure *)self)->engine);
}

static const structure_switch tree_switches[] = {
    STRUCTURE_SIDE_SWITCHES, STRUCTURE_SIDE_16_SWITCH, STRUCTURE_SINGLE_SWITCH, {NULL, NULL, 0, 0}};

static const structure_switch grid_switches[] = {
    STRUCTURE_SIDE_SWITCHES, STRUCTURE_SIDE_16_SWITCH, {NULL, NULL, 0, 0}};

#define ENGINE_KIND(NAME, VARIANT, ABOUT)                                                          \
    {                                                                                              \
        .name = NAME, .about = ABOUT, .variant = VARIANT, .open = open_tree, .move = move_tree,    \
        .trace = trace_tree, .count = count_tree, .forget = forget_tree, .close = close_engine,    \
        .switches = (VARIANT) == GRID ? grid_switches : tree_switches                              \
    }

const structure_kind structure_tree =
    ENGINE_KIND("tree", TREE, "the engine's tree, refitted, and rebuilt when that has paid");
const structure_kind structure_tree_never =
    ENGINE_KIND("tree-never", TREE_NEVER, "the same, only refitted");
const structure_kind structure_tree_always =
    ENGINE_KIND("tree-always", TREE_ALWAYS, "the same, rebuilt for each frame");
const structure_kind structure_grid = ENGINE_KIND("grid", GRID, "the engine's grid, made anew");
const structure_kind structure_opened = ENGINE_KIND("engine", OPENED, "the engine as it is open");
