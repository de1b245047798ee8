/* open - from an image to an engine in an arena
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/base/small_stack.h"
#include "engine/engine.h"
#include "engine/grid_room.h"
#include "engine/image/fetch.h"
#include "engine/image/further.h"
#include "engine/instances_room.h"
#include "engine/layout.h"
#include "engine/motion_room.h"
#include "engine/scene/worst_tree.h"
#include "engine/surface_room.h"
#include "engine/texture_room.h"
#include "engine/trace/wave_state.h"
#include "engine/trace/wide_form.h"
#include "engine/whitted_room.h"

/* Packets of a batch, unless it is said how many: more save little (DESIGN.md, section 3.1), and
 * of fewer than the least the next smaller ones are better. */
enum { BATCH_LEAST = 4, BATCH_USUAL = 256, DISPATCH_USUAL = 16 };

static const plt_fault no_fault = {0, 0, 0, 0, "no fault"};

static int valid_source(const plt_source *s) {
    return s->mapped != NULL ? (uintptr_t)s->mapped % PLT_ALIGN == 0
                             : s->start != NULL && s->wait != NULL;
}

PLT_APART_ON_SMALL_STACKS static int read_header(const plt_source *source, plt_header *header,
                                                 plt_fault *fault) {
    unsigned char bytes[PLT_HEADER_BYTES];
    if (source->bytes < PLT_HEADER_BYTES) {
        return plt_refused(fault, PLT_R1_SHORT, source->bytes,
                           "the image is shorter than its header");
    }
    int status = plt_fetch(source, 0, bytes, PLT_HEADER_BYTES, fault);
    status = status == PLT_OK ? plt_header_read(header, bytes, source->bytes, fault) : status;
#if PLT_WITH_FURTHER
    status = status == PLT_OK ? plt_further_read(source, header, fault) : status;
#endif
    return status;
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

static plt_opening opening_of(plt_engine *e, const plt_layout *layout, plt_fault *fault) {
    const plt_opening o = {.scene = &e->scene,
                           .source = &e->source,
                           .arena = &e->arena,
                           .layout = layout,
                           .fault = fault,
                           .residency = PLT_WITH_STREAMED ? e->options.residency : 0,
                           .structure = PLT_WITH_GRID ? e->options.structure : 0,
                           .movable = PLT_WITH_MOTION ? e->options.movable : 0,
                           .over_vertices =
                               PLT_WITH_VERTICES && e->options.records == PLT_RECORDS_NEVER};
    return o;
}

/* What is needed only once the scene is open is cut last, where scratch was. */
static int cut_running(const plt_opening *o, void *to[PLT_PARTS_COUNT]) {
    for (unsigned i = 0; i < PLT_PARTS_COUNT; i++) {
        to[i] = NULL;
        if (plt_part_lifetime((enum plt_part)i) != PLT_LIFETIME_RUNS) {
            continue;
        }
        to[i] = plt_opening_cut(o, (enum plt_part)i);
        if (to[i] == NULL) {
            return plt_opening_arena_error(o);
        }
    }
    return PLT_OK;
}

/* What all that runs is sized for. */
static plt_info sized_for(const plt_engine *e) {
#if PLT_WITH_REBUILD
    if (plt_layout_rebuilds(&e->scene.info, &e->options)) {
        return plt_rebuilt_tree(&e->scene.info, e->moving.rebuild.room);
    }
#endif
    return e->scene.info;
}

#if PLT_WITH_WAVE
/* Makes the wide form, with the wave's room for scratch; then both take just what they need,
 * which is known only now. They were cut last. */
PLT_APART_ON_SMALL_STACKS static int make_wide_form(plt_engine *e, const plt_opening *o,
                                                    void *const part[PLT_PARTS_COUNT]) {
    const size_t room = o->layout->bytes[PLT_PART_WIDE_FORM] + o->layout->bytes[PLT_PART_WAVE];
    size_t form_bytes = 0;
    e->scene.bvh4 =
        plt_wide_make(&e->traversal, part[PLT_PART_WIDE_FORM], part[PLT_PART_WAVE], &form_bytes);
    const size_t wave_bytes =
        (size_t)plt_wave_bytes(e->options.rays_in_flight, PLT_WAVE_BVH4, e->scene.bvh4->depth);
    plt_arena_release(&e->arena, e->arena.used - room);
    plt_arena_cut(&e->arena, form_bytes);
    e->traversal.wave = plt_arena_cut(&e->arena, wave_bytes);
    if (e->traversal.wave == NULL) {
        return plt_opening_arena_error(o);
    }
    plt_wave_init(e->traversal.wave, e->options.rays_in_flight, PLT_WAVE_BVH4,
                  e->scene.bvh4->depth);
    return PLT_OK;
}

PLT_APART_ON_SMALL_STACKS static void start_own_wave(plt_engine *e, void *memory) {
    e->traversal.wave = memory;
    plt_wave_init(memory, e->options.rays_in_flight,
                  plt_wave_tree_of((enum plt_format)e->scene.format),
                  sized_for(e).depth_stack_entries);
}

static int start_wave(plt_engine *e, const plt_opening *o, void *const part[PLT_PARTS_COUNT]) {
    if (o->layout->bytes[PLT_PART_WIDE_FORM] > 0) {
        return make_wide_form(e, o, part);
    }
    if (o->layout->bytes[PLT_PART_WAVE] > 0) {
        start_own_wave(e, part[PLT_PART_WAVE]);
    }
    return PLT_OK;
}
#else
static int start_wave(plt_engine *e, const plt_opening *o, void *const part[PLT_PARTS_COUNT]) {
    (void)e;
    (void)o;
    (void)part;
    return PLT_OK;
}
#endif

static uint32_t store_bytes_in(uint64_t room) {
    const uint64_t most = room < UINT32_MAX ? room / PLT_ALIGN * PLT_ALIGN : UINT32_MAX - 15u;
    return most > PLT_STORE_LEAST ? (uint32_t)most : PLT_STORE_LEAST;
}

/* Bytes of all that runs, with the options as they are. 1: there is room for it. */
PLT_APART_ON_SMALL_STACKS static int lay_out(const plt_engine *e, plt_layout *layout) {
    const plt_info *info = &e->scene.info, sized = sized_for(e);
    plt_layout_set(layout, info, &sized, e->source.mapped != NULL, &e->options);
    return plt_layout_running(layout) <= e->arena.bytes - e->arena.used;
}

/* Slots for a tree that is rebuilt: of the largest there can be, or a quarter more than now, or
 * what there is room for beside the smallest packets; as many as now at least. */
static void choose_room(plt_engine *e, plt_layout *layout) {
#if PLT_WITH_REBUILD
    const plt_info *info = &e->scene.info;
    uint32_t *room = &e->moving.rebuild.room;
    if (!plt_layout_rebuilds(info, &e->options)) {
        return;
    }
    if (e->options.rebuild_most > 0) {
        *room = plt_layout_rebuild_room(info, &e->options);
        return;
    }
    const uint8_t side = e->options.packet_side;
    e->options.packet_side = side > 0 ? side : 2;
    *room = plt_rebuilt_room(info);
    if (!lay_out(e, layout)) {
        uint32_t most = info->node_slots + info->node_slots / 4, least = info->node_slots;
        *room = most;
        while (most > least) { /* halving: that much fits, or is the least */
            const int fits = lay_out(e, layout);
            least = fits ? *room : least;
            most = fits ? most : *room - 1;
            *room = least + (most - least + 1) / 2;
        }
    }
    e->options.packet_side = side;
#else
    (void)e;
    (void)layout;
#endif
}

/* Batches or a dispatcher are asked for, but not of how many packets. */
static int chooses_batch(const plt_engine *e) {
    return PLT_WITH_BATCH && plt_is_streamed(e->scene.format) &&
           (e->options.schedule == PLT_SCHEDULE_BATCH ||
            e->options.schedule == PLT_SCHEDULE_TASK) &&
           e->options.batch == 0;
}

/* The most packets that there is room for. */
static void choose_batch(plt_engine *e, plt_layout *layout) {
    e->options.batch = e->options.schedule == PLT_SCHEDULE_TASK ? DISPATCH_USUAL : BATCH_USUAL;
    while (!lay_out(e, layout) && e->options.batch > 1) {
        e->options.batch--;
    }
}

/* Bytes of all that runs. What was not said is chosen: packets, beside a store of half the room,
 * and a store as large as the rest. */
PLT_APART_ON_SMALL_STACKS static void set_layout(plt_engine *e, plt_layout *layout) {
    const int chooses = e->options.packet_side == 0, meets = chooses_batch(e);
    const int grows = plt_is_streamed(e->scene.format) && e->options.store_bytes == 0;
    const size_t room = e->arena.bytes - e->arena.used;
    unsigned side = chooses ? PLT_PACKET_SIDE_MAX : e->options.packet_side;
    int fits;
    choose_room(e, layout);
    if (grows) {
        e->options.store_bytes = store_bytes_in(room / 2);
    }
    e->options.batch = meets ? BATCH_LEAST : e->options.batch;
    do {
        e->options.packet_side = (uint8_t)side;
        fits = lay_out(e, layout);
        side /= 2;
    } while (chooses && side > 1 && !fits);
    if (meets) {
        choose_batch(e, layout);
    }
    if (grows) {
        const uint64_t others = plt_layout_running(layout) - layout->bytes[PLT_PART_STORE];
        e->options.store_bytes = store_bytes_in(room > others ? room - others : 0);
        lay_out(e, layout);
    }
}

static void start_batch(plt_engine *e, void *const part[PLT_PARTS_COUNT]) {
#if PLT_WITH_BATCH
    const unsigned side = e->options.packet_side;
    const int meets = plt_is_streamed(e->scene.format) && e->options.schedule == PLT_SCHEDULE_BATCH;
    e->batch.most = 0;
    if (meets) {
        plt_batch_init(&e->batch, e->options.batch, side, part[PLT_PART_BATCH],
                       part[PLT_PART_TASKS]);
        e->rendering.batch = &e->batch;
    }
#else
    (void)e;
    (void)part;
#endif
}

/* What a dispatcher has, and what a worker has: a dispatcher is both. */
static void start_tasks(plt_engine *e, void *const part[PLT_PARTS_COUNT]) {
#if PLT_WITH_TASK
    const uint32_t packets = e->options.batch;
    const unsigned side = e->options.packet_side;
    e->dispatch.most = e->dispatch.rooms = 0;
    e->is_worker = e->options.schedule >= PLT_SCHEDULE_TASK;
    if (e->is_worker) {
        plt_worker_init(&e->worker, part[PLT_PART_EDGES]);
    }
    if (e->options.schedule == PLT_SCHEDULE_TASK) {
        plt_dispatch_init(&e->dispatch, packets, side, part[PLT_PART_BATCH], part[PLT_PART_TASKS]);
        e->colours = part[PLT_PART_COLOURS];
        e->rendering.by_tasks = 1;
    }
#else
    (void)e;
    (void)part;
#endif
}

/* Nodes of a tree that all that runs is sized for. */
PLT_APART_ON_SMALL_STACKS static uint32_t most_nodes(const plt_engine *e) {
    return sized_for(e).nodes;
}

/* The scene is open: a traversal, a packet and a tile buffer over it. `header`: of an image that
 * is opened in one step, as all that have a sequence are. */
PLT_APART_ON_SMALL_STACKS static int start_worker(plt_engine *e, const plt_header *header,
                                                  plt_fault *fault) {
    plt_layout layout;
    void *part[PLT_PARTS_COUNT];
    set_layout(e, &layout);
    const plt_opening o = opening_of(e, &layout, fault);
    int status = cut_running(&o, part);
    if (status == PLT_OK) {
        plt_grid_room_set(e, &layout, part);
        plt_traversal_init(&e->traversal, &e->scene, &e->options, part);
#if PLT_WITH_GROUPS
        plt_packet_init(&e->packet, part[PLT_PART_PACKET], e->options.packet_side);
#else
        plt_beam_state_init(&e->traversal);
#endif
        plt_rendering_init(&e->rendering, part[PLT_PART_TILE_BUFFER], part[PLT_PART_PACKET],
                           e->options.packet_side);
        start_batch(e, part);
        start_tasks(e, part);
        status = start_wave(e, &o, part);
    }
    if (status == PLT_OK) {
        status = plt_whitted_room_set(e, header, part, fault);
    }
    if (status == PLT_OK) {
        status = plt_texture_room_set(e, header, part, fault);
    }
    if (status == PLT_OK) {
        status = plt_motion_room_set(e, &o, most_nodes(e), part);
    }
    if (status == PLT_OK) {
        status = plt_instances_room_set(e, header, part, fault);
    }
    if (status == PLT_OK) {
        status = plt_surface_room_set(e, header, part, fault);
    }
    return status == PLT_OK ? plt_motion_room_sequence(e, header, part, fault) : status;
}

/* An arena that is too small: how many bytes would do. */
static int with_need(const plt_engine *e, int status, plt_fault *fault) {
    if (status == PLT_ERR_ARENA) {
        fault->need_bytes = plt_arena_need(&e->scene.info, e->source.mapped != NULL, &e->options);
    }
    return status;
}

PLT_APART_ON_SMALL_STACKS static int open_scene(plt_engine *e, const plt_header *header,
                                                plt_fault *fault) {
    plt_layout layout;
    plt_layout_of_image(&layout, &header->info, e->source.mapped != NULL, &e->options);
    const plt_opening o = opening_of(e, &layout, fault);
    return plt_scene_open(&o, header, &e->build);
}

/* What no arena helps against. */
static int refuse(const plt_info *info, const plt_options *options, plt_fault *fault) {
    const char *left_out = plt_scene_left_out(info, options->residency, options->structure);
    if (left_out != NULL) {
        return plt_limit(fault, left_out);
    }
    if (!plt_layout_residency_valid(info, options)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             plt_has_instances(info)
                                 ? "bodies of instances are resident, and not streamed"
                                 : "only finished trees are streamed, of compact blocks with "
                                   "lattice geometry or of treelets of at most 256 nodes");
    }
    if (!plt_layout_motion_valid(info, options)) {
        return plt_fault_set(
            fault, PLT_ERR_ARGUMENT, 0,
            plt_has_instances(info) ? "bodies of instances are placed, and cannot be moved"
            : info->nodes_format == PLT_NODES_COMPACT
                ? "triangles of compact blocks move as frames of their image say, "
                  "all together, streamed ones as stills, and others cannot be moved"
                : "of streamed scenes stills of compact blocks move alone");
    }
    if (!plt_layout_structure_valid(info, options)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             plt_has_instances(info)
                                 ? "instances have a tree, and no grid"
                                 : "compact blocks have no records that a grid could refer to");
    }
    if (!plt_layout_records_valid(info, options)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             "without records there are only the frames of a finished tree, no "
                             "grid, and no other triangles that move or are built anew");
    }
    if (!plt_layout_surface_valid(info, options)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             plt_layout_pages_valid(info, options)
                                 ? "normals and colours are of scenes whose triangles stay where "
                                   "they are, of compact blocks of finished ones"
                             : PLT_WITH_STREAMED && options->residency == PLT_RESIDENCY_STREAMED
                                 ? "normals and colours of streamed scenes come in pages, and one "
                                   "packet after the other"
                                 : "pages of normals and colours are of triangles in the order of "
                                   "the image, which grids are not");
    }
    if (!plt_layout_order_valid(info, options)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             !PLT_WITH_GROUPS ? "beams are traversed depth first"
                             : PLT_WITH_STREAMED
                                 ? "compact blocks and streamed scenes are traversed depth first"
                                 : "compact blocks are traversed depth first");
    }
    return PLT_OK;
}

#if PLT_WITH_VERTICES
static int fits(const plt_info *info, int mapped, const plt_options *o, size_t arena_bytes) {
    return plt_arena_need(info, mapped, o) <= arena_bytes;
}

/* With records, or without, as there is room; if there is for neither, whichever takes less. */
PLT_APART_ON_SMALL_STACKS static void choose_records(plt_options *o, const plt_info *info,
                                                     int mapped, size_t arena_bytes) {
    plt_options with = *o, without = *o;
    with.records = PLT_RECORDS_ALWAYS;
    without.records = PLT_RECORDS_NEVER;
    if (o->records == PLT_RECORDS_AUTO && !o->beside && o->movable) {
        const int may =
            plt_layout_records_optional(info, o) && !fits(info, mapped, &with, arena_bytes);
        *o = may && fits(info, mapped, &without, plt_arena_need(info, mapped, &with)) ? without
                                                                                      : with;
    } else if (o->beside) {
        *o = without;
        o->beside = (uint8_t)fits(info, mapped, &without, arena_bytes);
    }
}
#else
static void choose_records(const plt_options *o, const plt_info *info, int mapped,
                           size_t arena_bytes) {
    (void)o;
    (void)info;
    (void)mapped;
    (void)arena_bytes;
}
#endif

/* Not even for an engine. */
PLT_APART_ON_SMALL_STACKS static int no_room(const plt_info *info, const plt_source *source,
                                             const plt_options *options, size_t arena_bytes,
                                             plt_fault *fault) {
    plt_options chosen = *options;
    choose_records(&chosen, info, source->mapped != NULL, arena_bytes);
    return plt_arena_short(fault, plt_arena_need(info, source->mapped != NULL, &chosen));
}

int plt_open_begin(plt_engine **engine, void *arena, size_t arena_bytes, const plt_source *source,
                   const plt_options *options, plt_fault *fault) {
    plt_header header;
    *engine = NULL;
    *fault = no_fault;
    if (!plt_layout_options_valid(options) || !valid_source(source) ||
        (uintptr_t)arena % PLT_ALIGN != 0) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             "an option is out of range, or source or arena are not aligned");
    }
    int status = read_header(source, &header, fault);
    if (status != PLT_OK) {
        return status;
    }
    status = refuse(&header.info, options, fault);
    if (status != PLT_OK) {
        return status;
    }
    plt_arena a = {arena, arena_bytes, 0, 0};
    plt_engine *e = plt_arena_cut(&a, sizeof *e);
    if (e == NULL) {
        return no_room(&header.info, source, options, arena_bytes, fault);
    }
    memset(e, 0, sizeof *e);
    e->arena = a;
    e->source = *source;
    e->options = *options;
    choose_records(&e->options, &header.info, source->mapped != NULL, arena_bytes);
    e->rendering.done = 1;
    status = open_scene(e, &header, fault);
    if (status == PLT_OK) {
        status = start_worker(e, &header, fault);
    }
    if (status >= PLT_OK) {
        *engine = e;
    }
    return with_need(e, status, fault);
}

#if PLT_WITH_WHITTED || PLT_WITH_SURFACE
/* The header once more: rooms are as large as it said the first time. */
static int read_header_again(const plt_engine *e, plt_header *header, plt_fault *fault) {
    const plt_info *before = &e->scene.info, *now = &header->info;
    const int status = read_header(&e->source, header, fault);
    if (status != PLT_OK) {
        return status;
    }
    int same = now->source_triangles == before->source_triangles;
#if PLT_WITH_MATERIALS
    same &= now->material_bytes == before->material_bytes;
#endif
#if PLT_WITH_TEXTURE
    same &= now->texture_bytes == before->texture_bytes && now->tile_bytes == before->tile_bytes;
#endif
#if PLT_WITH_SURFACE
    same &= now->normal_bytes == before->normal_bytes && now->colour_bytes == before->colour_bytes;
#endif
#if PLT_WITH_PAGES
    same &= now->page_bytes == before->page_bytes;
#endif
#if PLT_WITH_TEXCOORDS
    same &= now->texcoord_bytes == before->texcoord_bytes;
#endif
    return same ? PLT_OK
                : plt_fault_set(fault, PLT_ERR_SOURCE, 0, "the source has another header now");
}
#endif

/* Of what was built step by step, whose header is not at hand any more. */
PLT_APART_ON_SMALL_STACKS static int start_built(plt_engine *e, plt_fault *fault) {
#if PLT_WITH_WHITTED || PLT_WITH_SURFACE
    plt_header header;
    if (e->options.whitted > 0 || e->options.surface) {
        const int status = read_header_again(e, &header, fault);
        return status == PLT_OK ? start_worker(e, &header, fault) : status;
    }
#endif
    return start_worker(e, NULL, fault);
}

PLT_APART_ON_SMALL_STACKS static int build_some(plt_engine *e, uint32_t splits, plt_fault *fault) {
    plt_layout layout;
    plt_layout_of_image(&layout, &e->scene.info, e->source.mapped != NULL, &e->options);
    const plt_opening o = opening_of(e, &layout, fault);
    return plt_scene_build_step(&o, e->build, splits);
}

int plt_open_step(plt_engine *e, uint32_t splits, plt_fault *fault) {
    *fault = no_fault;
    if (e->failed != PLT_OK) {
        return with_need(e, plt_fault_set(fault, e->failed, 0, "the opening has failed before"),
                         fault);
    }
    if (e->build == NULL) {
        return PLT_OK;
    }
    int status = build_some(e, splits > 0 ? splits : 1, fault);
    if (status == PLT_OK) {
        status = start_built(e, fault);
    }
    if (status == PLT_OK) {
        e->build = NULL;
    }
    e->failed = (int8_t)(status < 0 ? status : PLT_OK);
    return with_need(e, status, fault);
}

int plt_open(plt_engine **engine, void *arena, size_t arena_bytes, const plt_source *source,
             const plt_options *options, plt_fault *fault) {
    int status = plt_open_begin(engine, arena, arena_bytes, source, options, fault);
    while (status == PLT_MORE) {
        status = plt_open_step(*engine, 0xFFFFFFFFu, fault);
    }
    if (status != PLT_OK) {
        *engine = NULL;
    }
    return status;
}
