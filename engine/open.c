/* open - from an image to an engine in an arena
 *
 * SPDX-License-Identifier: MIT */
#include "engine/build/build.h"
#include "engine/engine.h"
#include "engine/image/bytes.h"
#include "engine/image/check.h"
#include "engine/image/crc32.h"
#include "engine/image/fault.h"
#include "engine/memory/fetch.h"

static const plt_fault no_fault = {0, 0, 0, 0, "no fault"};

static int valid_options(const plt_options *o) {
    const unsigned side = o->packet_side;
    return (side == 2 || side == 4 || side == 8 || side == 16) && side <= PLT_PACKET_SIDE_MAX &&
           o->walk <= PLT_WALK_TWO_STAGE;
}

static int valid_source(const plt_source *s) {
    return s->mapped != NULL ? (uintptr_t)s->mapped % PLT_ALIGN == 0
                             : s->start != NULL && s->wait != NULL;
}

static int read_header(const plt_source *source, plt_header *header, plt_fault *fault) {
    unsigned char bytes[PLT_HEADER_BYTES];
    if (source->bytes < PLT_HEADER_BYTES) {
        return plt_refused(fault, 1, source->bytes, "the image is shorter than its header");
    }
    const int status = plt_fetch(source, 0, bytes, PLT_HEADER_BYTES, fault);
    return status == PLT_OK ? plt_header_read(header, bytes, source->bytes, fault) : status;
}

int plt_image_info(const plt_source *source, plt_info *info, plt_fault *fault) {
    plt_header header;
    *fault = no_fault;
    if (!valid_source(source)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "the source is not aligned or not whole");
    }
    const int status = read_header(source, &header, fault);
    if (status == PLT_OK) {
        *info = header.info;
    }
    return status;
}

/* ---- sizes: every cut of the arena, once ------------------------------ */

static size_t groups_bytes(const plt_options *o) {
    return (size_t)o->packet_side * o->packet_side / 4 * sizeof(plt_group);
}

static uint32_t touched_words(uint32_t node_slots, uint32_t treelet_nodes) {
    return node_slots / treelet_nodes / 32 + 1;
}

static uint32_t main_stack_entries(const plt_info *info, const plt_options *o) {
    const uint32_t need =
        o->walk == PLT_WALK_TWO_STAGE ? info->global_stack_entries : info->depth_stack_entries;
    return need > 0 ? need : 1;
}

static uint32_t local_stack_entries(const plt_info *info, const plt_options *o) {
    return o->walk == PLT_WALK_TWO_STAGE ? info->local_stack_entries : 0;
}

/* What is cut when the scratch of opening has been given back. */
static size_t stacks_bytes(const plt_info *info, const plt_options *o) {
    return plt_arena_cut_bytes(4 * touched_words(info->node_slots, info->treelet_nodes)) +
           plt_arena_cut_bytes(main_stack_entries(info, o) * sizeof(plt_entry)) +
           plt_arena_cut_bytes(local_stack_entries(info, o) * sizeof(plt_entry));
}

static size_t fixed_bytes(const plt_options *o) {
    return plt_arena_cut_bytes(sizeof(plt_engine)) + plt_arena_cut_bytes(groups_bytes(o)) +
           plt_arena_cut_bytes(3 * PLT_TILE_SIDE * PLT_TILE_SIDE);
}

static size_t larger(size_t a, size_t b) {
    return a > b ? a : b;
}

/* The worst tree that the engine may have to build of the image. */
static plt_info bound_of_build(const plt_info *info) {
    plt_info worst = *info;
    worst.nodes = plt_build_nodes_bound(info->triangles);
    worst.node_slots = plt_build_slots_bound(worst.nodes, info->treelet_nodes);
    worst.depth_stack_entries = PLT_DEPTH_MAX;
    worst.local_stack_entries = PLT_DEPTH_MAX;
    worst.global_stack_entries =
        info->triangles < PLT_GLOBAL_STACK_MAX ? info->triangles : PLT_GLOBAL_STACK_MAX;
    return worst;
}

size_t plt_arena_need(const plt_info *info, int mapped, const plt_options *o) {
    if (!valid_options(o) || info->treelet_nodes == 0) {
        return 0;
    }
    const size_t frames = plt_arena_cut_bytes(PLT_SURVEY_FRAMES * sizeof(plt_survey_frame));
    if (info->build == PLT_BUILD_DEVICE) {
        const plt_info worst = bound_of_build(info);
        const size_t scene = plt_arena_cut_bytes(info->triangle_bytes) +
                             plt_arena_cut_bytes((size_t)worst.node_slots * PLT_NODE_BYTES);
        const size_t scratch =
            plt_arena_cut_bytes(plt_build_scratch_bytes(worst.nodes, info->treelet_nodes));
        return fixed_bytes(o) + scene + larger(larger(scratch, frames), stacks_bytes(&worst, o));
    }
    const size_t scene =
        mapped ? 0
               : plt_arena_cut_bytes(info->node_bytes) + plt_arena_cut_bytes(info->triangle_bytes);
    return fixed_bytes(o) + scene + larger(frames, stacks_bytes(info, o));
}

/* ---- laying out ------------------------------------------------------- */

typedef struct opening {
    plt_engine *e;
    plt_fault *fault;
} opening;

static int no_room(const opening *o) {
    const plt_engine *e = o->e;
    return plt_arena_short(o->fault,
                           plt_arena_need(&e->header.info, e->source.mapped != NULL, &e->options));
}

/* A section where it lies, or fetched into the arena; its checksum is right. */
static int take_section(const opening *o, int number, int copy, const void **bytes) {
    plt_engine *e = o->e;
    const plt_section *s = &e->header.section[number];
    if (e->source.mapped != NULL && !copy) {
        *bytes = (const unsigned char *)e->source.mapped + s->offset;
    } else {
        void *to = plt_arena_cut(&e->arena, s->bytes);
        if (to == NULL) {
            return no_room(o);
        }
        const int status = plt_fetch(&e->source, s->offset, to, s->bytes, o->fault);
        if (status != PLT_OK) {
            return status;
        }
        *bytes = to;
    }
    if (plt_crc32(0, *bytes, s->bytes) != s->crc) {
        return plt_refused(o->fault, 13, s->offset, "a section is damaged (checksum)");
    }
    return PLT_OK;
}

static int take_scene(const opening *o) {
    plt_engine *e = o->e;
    plt_tree *tree = &e->walker.tree;
    const void *nodes = NULL, *records = NULL;
    const int build = e->header.info.build == PLT_BUILD_DEVICE;
    int status = take_section(o, 0, 0, &nodes);
    if (status == PLT_OK) {
        status = take_section(o, 1, build, &records);
    }
    if (status == PLT_OK) {
        status = plt_check_records(&e->header, records, o->fault);
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

static int survey_or_check(const opening *o, int built) {
    plt_engine *e = o->e;
    const size_t mark = e->arena.used;
    plt_survey_frame *frames =
        plt_arena_cut(&e->arena, PLT_SURVEY_FRAMES * sizeof(plt_survey_frame));
    if (frames == NULL) {
        return no_room(o);
    }
    const uint32_t k = e->header.info.leaf_triangles;
    int status = built ? plt_tree_survey(&e->walker.tree, frames, &e->header.info, o->fault)
                       : plt_check_planes(&e->header, e->walker.tree.nodes, o->fault);
    if (status == PLT_OK && !built) {
        status = plt_check_tree(&e->header, &e->walker.tree, frames, o->fault);
    }
    e->header.info.leaf_triangles = k;
    plt_arena_release(&e->arena, mark);
    return status;
}

/* Nodes grow over the free arena, scratch takes its end. */
static int run_build(const opening *o, plt_build_job *job) {
    plt_engine *e = o->e;
    const plt_info *info = &e->header.info;
    const plt_info worst = bound_of_build(info);
    const size_t free_bytes = e->arena.bytes - e->arena.used;
    const size_t most = (size_t)worst.node_slots * PLT_NODE_BYTES;
    size_t scratch = plt_arena_cut_bytes(plt_build_scratch_bytes(worst.nodes, info->treelet_nodes));
    if (most + scratch > free_bytes) { /* less than the bound: mostly still enough */
        scratch = larger(plt_arena_cut_bytes(plt_build_scratch_bytes(0, info->treelet_nodes)),
                         plt_arena_cut_bytes(free_bytes / 8));
    }
    if (scratch > free_bytes) {
        return no_room(o);
    }
    size_t room = (free_bytes - scratch) / PLT_NODE_BYTES;
    room = room < worst.node_slots ? room : worst.node_slots;
    job->nodes = plt_arena_cut(&e->arena, room * PLT_NODE_BYTES);
    job->scratch = plt_arena_cut(&e->arena, scratch);
    job->room = (uint32_t)room;
    job->scratch_bytes = scratch;
    if (job->nodes == NULL || job->scratch == NULL) {
        return no_room(o);
    }
    const int status = plt_build(job);
    if (status == PLT_ERR_ARENA) {
        return no_room(o);
    }
    return status == PLT_OK ? PLT_OK
                            : plt_limit(o->fault, "the scene needs more than PLT_DEPTH_MAX levels");
}

static int build_tree(const opening *o) {
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

static int cut_stacks(const opening *o) {
    plt_engine *e = o->e;
    plt_walker *w = &e->walker;
    const plt_info *info = &e->header.info;
    if (info->global_stack_entries > PLT_GLOBAL_STACK_MAX) {
        return plt_limit(o->fault, "the scene needs more than PLT_GLOBAL_STACK_MAX entries");
    }
    e->touched_words = touched_words(info->node_slots, info->treelet_nodes);
    w->touched = plt_arena_cut(&e->arena, 4 * (size_t)e->touched_words);
    w->stack = plt_arena_cut(&e->arena, main_stack_entries(info, &e->options) * sizeof(plt_entry));
    w->local = plt_arena_cut(&e->arena, local_stack_entries(info, &e->options) * sizeof(plt_entry));
    return w->touched != NULL && w->stack != NULL && w->local != NULL ? PLT_OK : no_room(o);
}

static int lay_out(const opening *o) {
    plt_engine *e = o->e;
    e->walker.packet.group = plt_arena_cut(&e->arena, groups_bytes(&e->options));
    e->film = plt_arena_cut(&e->arena, 3 * PLT_TILE_SIDE * PLT_TILE_SIDE);
    if (e->walker.packet.group == NULL || e->film == NULL) {
        return no_room(o);
    }
    const int build = e->header.info.build == PLT_BUILD_DEVICE;
    int status = take_scene(o);
    if (status == PLT_OK && build) {
        status = build_tree(o);
    }
    if (status == PLT_OK) {
        status = survey_or_check(o, build);
    }
    return status == PLT_OK ? cut_stacks(o) : status;
}

int plt_open(plt_engine **engine, void *arena, size_t arena_bytes, const plt_source *source,
             const plt_options *options, plt_fault *fault) {
    plt_header header;
    *engine = NULL;
    *fault = no_fault;
    if (!valid_options(options) || !valid_source(source) || (uintptr_t)arena % PLT_ALIGN != 0) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "an option, the source or the arena");
    }
    int status = read_header(source, &header, fault);
    if (status != PLT_OK) {
        return status;
    }
    plt_arena a = {arena, arena_bytes, 0, 0};
    plt_engine *e = plt_arena_cut(&a, sizeof *e);
    if (e == NULL) {
        return plt_arena_short(fault,
                               plt_arena_need(&header.info, source->mapped != NULL, options));
    }
    memset(e, 0, sizeof *e);
    e->arena = a;
    e->source = *source;
    e->options = *options;
    e->header = header;
    e->rendering.done = 1;
    const opening o = {e, fault};
    status = lay_out(&o);
    if (status == PLT_OK) {
        plt_stats_reset(e);
        *engine = e;
    }
    return status;
}

/* ---- figures ---------------------------------------------------------- */

const plt_info *plt_engine_info(const plt_engine *e) {
    return &e->header.info;
}

void plt_stats_get(const plt_engine *e, plt_stats *stats) {
    *stats = e->walker.stats;
}

void plt_stats_reset(plt_engine *e) {
    memset(&e->walker.stats, 0, sizeof e->walker.stats);
    memset(e->walker.touched, 0, 4 * (size_t)e->touched_words);
}

size_t plt_arena_used(const plt_engine *e) {
    return e->arena.used;
}

size_t plt_arena_peak(const plt_engine *e) {
    return e->arena.peak;
}
