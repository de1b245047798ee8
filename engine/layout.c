/* layout - see layout.h; the rows are in scene/parts.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/layout.h"

#include "engine/engine.h"
#include "engine/grid/build.h"
#include "engine/image/record_cache.h"
#include "engine/instances_room.h"
#include "engine/memory/stream.h"
#include "engine/motion/block_refit.h"
#include "engine/motion/refit.h"
#include "engine/motion/sequence.h"
#include "engine/scene/build_compact.h"
#include "engine/scene/surface_place.h"
#include "engine/scene/worst_tree.h"
#include "engine/texture_room.h"
#include "engine/trace/block_entry.h"
#include "engine/trace/grid_state.h"
#include "engine/trace/kept.h"
#include "engine/trace/treelet_entry.h"
#include "engine/trace/wave_state.h"
#include "engine/trace/wide_form.h"
#include "engine/tree/compact/validate.h"
#include "engine/tree/thesis/validate.h"
#include "engine/whitted/state.h"

#if PLT_WITH_BUILDER
#include "engine/builder/build.h"
#endif

/* What the sizes of parts depend on. */
typedef struct subject {
    const plt_info *info, *sized_for;
    const plt_options *options;
    int mapped, builds; /* builds: the tree is built here */
    enum plt_format format;
} subject;

static uint64_t rounded(uint64_t bytes) {
    return (bytes + PLT_ALIGN - 1) & ~(uint64_t)(PLT_ALIGN - 1);
}

static uint64_t larger(uint64_t a, uint64_t b) {
    return a > b ? a : b;
}

static int has_grid(const subject *s) {
    return PLT_WITH_GRID && s->format == PLT_FORMAT_GRID;
}

static int is_over_vertices(const subject *s) {
    return PLT_WITH_VERTICES && s->format == PLT_FORMAT_VERTICES;
}

static enum plt_format format_of(const plt_info *info, const plt_options *o) {
#if PLT_WITH_VERTICES
    if (plt_layout_over_vertices(info, o)) {
        return PLT_FORMAT_VERTICES;
    }
#endif
    return plt_format_of(info, o->residency, o->structure);
}

static int is_movable(const subject *s) {
    return PLT_WITH_MOTION && s->options->movable;
}

/* Thesis records are copied even if they are mapped when a builder orders them; corners
 * stay where they are. */
static uint64_t section_bytes(const subject *s) {
    uint32_t kind[PLT_SECTIONS_MOST];
    uint64_t bytes = 0;
    if (plt_is_streamed(s->format)) {
        return 0;
    }
    if (s->builds) {
        return s->format == PLT_FORMAT_THESIS ? s->info->triangle_bytes : 0;
    }
    if (is_over_vertices(s)) {
        return rounded(s->info->node_bytes) + (s->mapped ? 0 : rounded(4ull * s->info->triangles));
    }
    const int stays = s->mapped && !is_movable(s);
    if (has_grid(s)) {
        return stays ? 0 : s->info->triangle_bytes;
    }
    for (unsigned i = stays ? 0 : plt_header_kinds(s->info, kind); i-- > 0;) {
        if (!(PLT_WITH_THESIS || PLT_WITH_SEQUENCE) || kind[i] < PLT_SECTION_CHECKS ||
            kind[i] == PLT_SECTION_STILLS || /* what follows is read bit by bit, if at all */
            (PLT_WITH_INSTANCES && kind[i] == PLT_SECTION_BODIES)) {
            bytes += rounded(plt_header_section_bytes(s->info, kind[i]));
        }
    }
    return bytes;
}

static uint64_t tree_bytes(const subject *s) {
    if (!s->builds) {
        return 0;
    }
    return s->format == PLT_FORMAT_THESIS ? (uint64_t)s->sized_for->node_slots * PLT_NODE_BYTES
                                          : (uint64_t)s->sized_for->node_bytes +
                                                s->sized_for->triangle_bytes + PLT_BITS_BEHIND;
}

/* Blocks built from mapped corners are not validated again. */
static uint64_t validation_bytes(const subject *s) {
    if ((s->builds && s->mapped && s->format == PLT_FORMAT_COMPACT) || plt_is_streamed(s->format) ||
        has_grid(s)) {
        return 0;
    }
    return s->format == PLT_FORMAT_COMPACT ? PLT_DEPTH_MAX * sizeof(plt_blocks_validate_level)
                                           : PLT_VALIDATE_LEVELS * sizeof(plt_validate_level);
}

static uint64_t builder_bytes(const subject *s) {
#if PLT_WITH_BUILDER && PLT_WITH_THESIS
    if (s->builds && s->format == PLT_FORMAT_THESIS) {
        return plt_build_scratch_bytes(s->sized_for->nodes, s->info->treelet_nodes);
    }
#endif
#if PLT_WITH_BUILDER && PLT_WITH_COMPACT
    if (s->builds && s->format == PLT_FORMAT_COMPACT) {
        return plt_compact_build_bytes(s->info->triangles);
    }
#endif
    (void)s;
    return 0;
}

static uint64_t record_cache_bytes(const subject *s) {
    const uint32_t corners = plt_corners_bytes(s->info->lattice_bits);
    return s->builds && !s->mapped && s->format == PLT_FORMAT_COMPACT
               ? plt_record_cache_bytes(corners)
               : 0;
}

/* Of a beam; 0: there are none. */
static size_t beam_entry_bytes(enum plt_format format, unsigned order) {
    const size_t bytes =
        plt_has_blocks(format) ? sizeof(plt_beam_block_entry) : sizeof(plt_beam_entry);
    return order == PLT_ORDER_DEPTH_FIRST && plt_has_beams(format) ? bytes : 0;
}

/* Bytes of a stack entry; 0: not in this order. Beams and groups share the stack. */
static size_t entry_bytes(enum plt_format format, unsigned order) {
    const size_t beam = beam_entry_bytes(format, order);
#if PLT_WITH_GROUPS
    const size_t bytes = plt_entry_bytes(format, order);
    return bytes > beam ? bytes : beam;
#else
    return beam;
#endif
}

/* Of packets with hulls; 0: there are none. */
static size_t hulls_entry_bytes(const subject *s) {
#if PLT_WITH_HULLS
    return s->options->order == PLT_ORDER_DEPTH_FIRST ? plt_entry_bytes(s->format, PLT_ORDER_HULLS)
                                                      : 0;
#else
    (void)s;
    return 0;
#endif
}

/* The largest that there is room for is chosen later (open.c): 2 x 2 is what must fit. */
static unsigned packet_side(const subject *s) {
    return s->options->packet_side > 0 ? s->options->packet_side : 2;
}

static uint64_t stack_bytes(const subject *s) {
    if (has_grid(s)) {
        return 0;
    }
    const int two_stage = s->options->order == PLT_ORDER_TWO_STAGE;
    const uint32_t need =
        two_stage ? s->sized_for->global_stack_entries : s->sized_for->depth_stack_entries;
    const uint64_t slack = plt_is_streamed(s->format) ? PLT_STACK_SLACK : 0;
    const uint64_t entries = (need > 0 ? need : 1) + slack;
    const uint64_t hulls = entries + plt_hull_levels(packet_side(s)) + 1;
    return larger(entries * entry_bytes(s->format, s->options->order),
                  hulls * hulls_entry_bytes(s));
}

static uint64_t leaves_bytes(const subject *s) {
    return (uint64_t)(PLT_LEAVES_WAITING + 2) * hulls_entry_bytes(s);
}

static uint64_t local_stack_bytes(const subject *s) {
    return s->options->order == PLT_ORDER_TWO_STAGE ? (uint64_t)s->sized_for->local_stack_entries *
                                                          entry_bytes(s->format, s->options->order)
                                                    : 0;
}

#if PLT_WITH_BATCH
/* 0: packets come one by one. */
static uint32_t batch_packets(const subject *s) {
    const plt_options *o = s->options;
    const int has_many =
        o->schedule == PLT_SCHEDULE_BATCH || (PLT_WITH_TASK && o->schedule == PLT_SCHEDULE_TASK);
    return !plt_is_streamed(s->format) || !has_many ? 0 : o->batch > 0 ? o->batch : 1;
}

static uint64_t batch_bytes(const subject *s) {
    const uint32_t packets = batch_packets(s);
#if PLT_WITH_TASK
    if (s->options->schedule == PLT_SCHEDULE_TASK) {
        return plt_dispatch_bytes(packets, packet_side(s));
    }
#endif
    return plt_packets_bytes(packets, packet_side(s));
}

static uint64_t tasks_bytes(const subject *s) {
    const uint32_t packets = batch_packets(s);
#if PLT_WITH_TASK
    if (s->options->schedule == PLT_SCHEDULE_TASK && packets > 0) {
        return plt_dispatch_edges_bytes(packets, packet_side(s));
    }
#endif
    return packets > 0 ? plt_batch_tasks_bytes(packets, packet_side(s)) : 0;
}

#if PLT_WITH_TASK
/* A byte for red, green and blue of each pixel that is finished before its turn. */
static uint64_t colours_bytes(const subject *s) {
    const uint64_t side = packet_side(s);
    return s->options->schedule == PLT_SCHEDULE_TASK
               ? 3 * side * side * plt_dispatch_slots(batch_packets(s))
               : 0;
}

static uint64_t edges_bytes(const subject *s) {
    return s->options->schedule >= PLT_SCHEDULE_TASK ? plt_worker_bytes() : 0;
}
#endif
#else
static uint32_t batch_packets(const subject *s) {
    (void)s;
    return 0;
}
#endif

/* Pixels of a beam take less than rays in groups, and lie where those do. */
static uint64_t packet_bytes(const subject *s) {
    const unsigned side = packet_side(s);
    if (batch_packets(s) > 0 || (PLT_WITH_TASK && s->options->schedule == PLT_SCHEDULE_WORKER)) {
        return 0;
    }
    if (PLT_WITH_GROUPS) {
        return plt_packet_bytes(side);
    }
    return plt_has_store(s->format) ? plt_beam_blocks_bytes(side) : plt_beam_bytes(side);
}

/* Of a grid with the mailbox. */
static uint64_t state_bytes(const subject *s) {
#if PLT_WITH_GROUPS
    const uint64_t mailbox = has_grid(s) ? 4ull * s->info->triangles : 0;
    return plt_state_bytes(s->format) + mailbox;
#else
    if (has_grid(s)) {
        return sizeof(plt_grid_state) + 4ull * s->info->triangles;
    }
    return plt_is_streamed(s->format) ? sizeof(plt_stream)
           : plt_has_blocks(s->format) ? sizeof(plt_block_state)
                                       : sizeof(plt_treelet_state);
#endif
}

/* Unless it is said how large it is, the least; opening adds what there is room for. */
static uint64_t store_bytes(const subject *s) {
    const uint32_t asked = s->options->store_bytes;
    return plt_is_streamed(s->format) ? (asked > 0 ? asked : PLT_STORE_LEAST) : 0;
}

#if PLT_WITH_WAVE
static int has_wide_form(const subject *s) {
    return s->options->wide && plt_wide_supports(s->format) &&
           s->info->triangles <= PLT_WIDE_TRIANGLES_MOST;
}
#endif

static uint64_t wide_bytes(const subject *s) {
#if PLT_WITH_WAVE
    return has_wide_form(s) ? plt_wide_bytes(s->sized_for) : 0;
#else
    (void)s;
    return 0;
#endif
}

/* While the wide form is made, its scratch lies there. */
static uint64_t wave_bytes(const subject *s) {
#if PLT_WITH_WAVE
    const plt_options *o = s->options;
    if (has_wide_form(s)) {
        return larger(
            plt_wave_bytes(o->rays_in_flight, PLT_WAVE_BVH4, plt_wide_depth_bound(s->sized_for)),
            plt_wide_scratch_bytes(s->sized_for));
    }
    if (o->rays_in_flight > 0 && plt_wave_supports(s->format)) {
        return plt_wave_bytes(o->rays_in_flight, plt_wave_tree_of(s->format),
                              s->sized_for->depth_stack_entries);
    }
#endif
    (void)s;
    return 0;
}

#if PLT_WITH_MOTION
static uint64_t levels_bytes(const subject *s) {
    return PLT_WITH_THESIS && is_movable(s) && !has_grid(s) && !plt_has_blocks(s->format)
               ? (uint64_t)s->sized_for->depth_stack_entries * sizeof(plt_refit_level)
               : 0;
}
#endif

#if PLT_WITH_SEQUENCE
static int has_frames(const subject *s) {
    return is_movable(s) && s->info->frames > 0 && !plt_is_streamed(s->format);
}

static int fetches_frames(const subject *s) {
    return has_frames(s) && !s->mapped;
}

/* Without records those of the frame that is shown, too. */
static uint64_t vertices_bytes(const subject *s) {
    const uint64_t bytes = has_frames(s) ? plt_sequence_vertices_bytes(s->info) : 0;
    return is_over_vertices(s) ? rounded(bytes) + bytes : bytes;
}
#endif

#if PLT_WITH_MOVE_SOME
static uint64_t dirty_bytes(const subject *s) {
    const uint64_t levels = has_grid(s) ? 0 : s->sized_for->depth_stack_entries;
    return is_movable(s) && s->options->moves_some
               ? rounded(plt_dirty_bytes(s->info->triangles)) + levels * sizeof(plt_dirty_level)
               : 0;
}
#endif

#if PLT_WITH_REBUILD
/* Behind the nodes that are there; until they are built, the tree has that room already. */
static uint64_t room_bytes(const subject *s) {
    const uint32_t slots = s->info->node_slots, room = s->sized_for->node_slots;
    return plt_layout_rebuilds(s->info, s->options) && room > slots &&
                   s->info->depth_stack_entries > 0
               ? (uint64_t)(room - slots) * PLT_NODE_BYTES
               : 0;
}

#if PLT_WITH_SUBTREES
uint64_t plt_layout_part_scratch(uint32_t room) {
    const uint64_t slots = 4ull * room, finding = plt_subtrees_scratch_bytes();
    return rounded(larger(plt_build_scratch_bytes(0, 1), larger(slots, finding)));
}

/* Of one subtree, and what is kept of all. */
static uint64_t part_rebuild_bytes(const subject *s) {
    const uint32_t triangles = s->info->triangles, most = s->options->rebuild_most;
    const uint32_t room = plt_subtree_room(triangles, s->sized_for->nodes, most);
    return rounded((uint64_t)plt_subtree_triangles(triangles, most) * PLT_RECORD_BYTES) +
           (uint64_t)room * PLT_NODE_BYTES + plt_layout_part_scratch(room) +
           (uint64_t)plt_subtrees_most(triangles, most) * sizeof(plt_subtree);
}
#endif

/* Scratch is the builder's, and then that of counting what the new tree needs. */
static uint64_t rebuild_bytes(const subject *s) {
#if PLT_WITH_SUBTREES
    if (s->options->rebuild_most > 0) {
        return plt_layout_rebuilds(s->info, s->options) ? part_rebuild_bytes(s) : 0;
    }
#endif
    const uint64_t records = rounded((uint64_t)s->info->triangles * PLT_RECORD_BYTES);
    const uint64_t nodes = (uint64_t)s->sized_for->node_slots * PLT_NODE_BYTES;
    const uint64_t scratch =
        larger(plt_build_scratch_bytes(s->sized_for->nodes, s->info->treelet_nodes),
               PLT_VALIDATE_LEVELS * sizeof(plt_validate_level));
    return plt_layout_rebuilds(s->info, s->options) ? records + nodes + scratch : 0;
}
#endif

#if PLT_WITH_TEXTURE
static int has_textures(const subject *s) {
    return plt_texture_room_is_wanted(s->info, s->options, s->format);
}
#elif PLT_WITH_MATERIALS
static int has_textures(const subject *s) {
    (void)s;
    return 0;
}
#endif

#if PLT_WITH_MATERIALS
static uint64_t material_bytes(const subject *s) {
    const int is_lit = PLT_WITH_WHITTED && s->options->whitted > 0;
    return !s->mapped && (is_lit || has_textures(s)) ? s->info->material_bytes : 0;
}
#endif

#if PLT_WITH_SURFACE
/* Tables, if there are any; else pages, or of those that stay where they are what they begin with.
 */
static uint64_t surface_bytes(const subject *s) {
    uint64_t bytes = (uint64_t)s->info->normal_bytes + s->info->colour_bytes;
#if PLT_WITH_PAGES
    const uint32_t pages = s->info->page_bytes;
    if (plt_is_streamed(s->format)) {
        return pages < PLT_PAGES_ROOM ? pages : PLT_PAGES_ROOM;
    }
    if (!plt_layout_has_tables(s->info)) {
        bytes += pages;
    }
#endif
#if PLT_WITH_TEXCOORDS
    bytes += s->info->texcoord_bytes;
#endif
    return bytes;
}
#endif

#if PLT_WITH_PAGES
/* A triangle per ray of a packet; of beams, the numbers of those that they share. */
static uint64_t kept_bytes(const subject *s) {
    const uint64_t rays = (uint64_t)packet_side(s) * packet_side(s);
    const int shares = PLT_WITH_BEAMS && plt_has_store(s->format) && s->info->page_bytes > 0;
    if (!s->options->surface || !(plt_is_streamed(s->format) || shares)) {
        return 0;
    }
    return PLT_WITH_GROUPS && plt_is_streamed(s->format)
               ? rays * sizeof(plt_kept)
               : 4ull * plt_beam_store_records(packet_side(s));
}
#endif

/* One line per row of the table in scene/parts.h. */
static uint64_t part_bytes(enum plt_part part, const subject *s) {
    switch (part) {
    case PLT_PART_ENGINE:
        return sizeof(plt_engine);
    case PLT_PART_SECTIONS:
        return section_bytes(s);
    case PLT_PART_TREE:
        return tree_bytes(s);
    case PLT_PART_VALIDATION:
        return validation_bytes(s);
    case PLT_PART_BUILDER:
        return builder_bytes(s);
    case PLT_PART_RECORD_CACHE:
        return record_cache_bytes(s);
    case PLT_PART_TOUCHED:
        return s->options->count_touched ? 4ull * plt_touched_all_words(s->format, s->sized_for)
                                         : 0;
    case PLT_PART_PACKET:
        return packet_bytes(s);
#if PLT_WITH_BATCH
    case PLT_PART_BATCH:
        return batch_bytes(s);
    case PLT_PART_TASKS:
        return tasks_bytes(s);
#endif
#if PLT_WITH_TASK
    case PLT_PART_COLOURS:
        return colours_bytes(s);
    case PLT_PART_EDGES:
        return edges_bytes(s);
#endif
    case PLT_PART_TILE_BUFFER:
        return PLT_TILE_BUFFER_BYTES;
    case PLT_PART_STACK:
        return stack_bytes(s);
    case PLT_PART_LOCAL_STACK:
        return local_stack_bytes(s);
    case PLT_PART_LEAVES:
        return leaves_bytes(s);
    case PLT_PART_FORMAT:
        return state_bytes(s);
    case PLT_PART_STORE:
        return store_bytes(s);
#if PLT_WITH_INSTANCES
    case PLT_PART_INNER:
        return plt_has_instances(s->info) ? plt_packet_bytes(packet_side(s)) : 0;
    case PLT_PART_INSTANCES:
        return plt_has_instances(s->info) ? plt_instances_room_bytes(s->info) : 0;
    case PLT_PART_MATRICES:
        return plt_has_instances(s->info) ? plt_matrices_frame_bytes(s->info) : 0;
#endif
#if PLT_WITH_SURFACE
    case PLT_PART_SURFACE:
        return s->options->surface && !s->mapped ? surface_bytes(s) : 0;
    case PLT_PART_PLACES:
#if PLT_WITH_GROUPS
        return s->options->surface && !plt_is_streamed(s->format)
                   ? plt_surface_places_bytes(s->info)
                   : 0;
#else
        return 0;
#endif
#endif
#if PLT_WITH_PAGES
    case PLT_PART_KEPT:
        return kept_bytes(s);
#endif
#if PLT_WITH_MOTION
    case PLT_PART_REFIT:
        return levels_bytes(s);
#endif
#if PLT_WITH_BLOCK_MOTION
    case PLT_PART_BLOCKS:
        return is_movable(s) && s->format == PLT_FORMAT_COMPACT
                   ? plt_block_refit_bytes(s->info->treelets)
                   : 0;
#endif
#if PLT_WITH_SEQUENCE
    case PLT_PART_TOPOLOGY:
        return fetches_frames(s) ? plt_sequence_topology_bytes(s->info) : 0;
    case PLT_PART_OFFSETS:
        return fetches_frames(s) ? plt_sequence_offsets_bytes(s->info) : 0;
    case PLT_PART_VERTICES:
        return vertices_bytes(s);
    case PLT_PART_WINDOW:
        return fetches_frames(s) ? PLT_FRAME_WINDOW_BYTES : 0;
#endif
#if PLT_WITH_VERTICES
    case PLT_PART_BESIDE:
        return is_over_vertices(s) && s->options->beside ? s->info->node_bytes : 0;
#endif
#if PLT_WITH_MOVE_SOME
    case PLT_PART_DIRTY:
        return dirty_bytes(s);
#endif
#if PLT_WITH_REBUILD
    case PLT_PART_ROOM:
        return room_bytes(s);
    case PLT_PART_REBUILD:
        return rebuild_bytes(s);
#endif
    case PLT_PART_WIDE_FORM:
        return wide_bytes(s);
    case PLT_PART_WAVE:
        return wave_bytes(s);
#if PLT_WITH_WHITTED
    case PLT_PART_WHITTED:
        return s->options->whitted > 0 ? plt_whitted_bytes(packet_side(s), s->options->whitted - 1u)
                                       : 0;
#endif
#if PLT_WITH_MATERIALS
    case PLT_PART_MATERIALS:
        return material_bytes(s);
#endif
#if PLT_WITH_TEXTURE
    case PLT_PART_TEXTURES:
        return has_textures(s) ? plt_texture_room_bytes(s->info, s->mapped) : 0;
    case PLT_PART_TILES:
        return has_textures(s) && !s->mapped ? plt_texture_tiles_bytes(s->options) : 0;
#endif
#if PLT_WITH_GRID
    case PLT_PART_GRID: /* the least; opening adds what there is room for */
        return has_grid(s) ? plt_grid_least_bytes(s->info->triangles) : 0;
#endif
    case PLT_PARTS_COUNT:
        break;
    }
    return 0;
}

void plt_layout_set(plt_layout *layout, const plt_info *info, const plt_info *sized_for, int mapped,
                    const plt_options *options) {
    const enum plt_format format = format_of(info, options);
    const int builds =
        info->build == PLT_BUILD_DEVICE && !(PLT_WITH_GRID && format == PLT_FORMAT_GRID);
    const subject s = {info, sized_for, options, mapped, builds, format};
    for (unsigned i = 0; i < PLT_PARTS_COUNT; i++) {
        const uint64_t bytes = rounded(part_bytes((enum plt_part)i, &s));
        layout->bytes[i] = bytes < SIZE_MAX ? (size_t)bytes : SIZE_MAX - (PLT_ALIGN - 1);
    }
}

#if PLT_WITH_REBUILD
uint32_t plt_layout_rebuild_room(const plt_info *info, const plt_options *options) {
    const int is_built = info->node_slots > 0;
    return options->rebuild_most > 0 && is_built ? info->node_slots : plt_rebuilt_room(info);
}
#endif

void plt_layout_of_image(plt_layout *layout, const plt_info *info, int mapped,
                         const plt_options *options) {
#if PLT_WITH_BUILDER
    plt_info worst = plt_worst_tree(info), image = *info;
    if (info->build == PLT_BUILD_DEVICE) { /* it may be open: its image has no nodes */
        image.node_slots = image.depth_stack_entries = 0;
    }
#if PLT_WITH_REBUILD
    if (plt_layout_rebuilds(info, options)) {
        worst = plt_rebuilt_tree(&image, plt_layout_rebuild_room(&image, options));
    }
#endif
    plt_layout_set(layout, &image, &worst, mapped, options);
#else
    plt_layout_set(layout, info, info, mapped, options);
#endif
}

static void add_up(const plt_layout *layout, uint64_t sum[PLT_LIFETIMES]) {
    for (unsigned i = 0; i < PLT_LIFETIMES; i++) {
        sum[i] = 0;
    }
    for (unsigned i = 0; i < PLT_PARTS_COUNT; i++) {
        sum[plt_part_lifetime((enum plt_part)i)] += layout->bytes[i];
    }
}

uint64_t plt_layout_running(const plt_layout *layout) {
    uint64_t sum[PLT_LIFETIMES];
    add_up(layout, sum);
    return sum[PLT_LIFETIME_RUNS];
}

uint64_t plt_layout_need(const plt_layout *layout) {
    uint64_t sum[PLT_LIFETIMES];
    add_up(layout, sum);
    return sum[PLT_LIFETIME_STAYS] +
           larger(sum[PLT_LIFETIME_RUNS],
                  larger(sum[PLT_LIFETIME_BUILDS], sum[PLT_LIFETIME_VALIDATES]));
}

static int is_wave_valid(const plt_options *o) {
    const unsigned rays = o->rays_in_flight;
    const int has_wave = PLT_WITH_WAVE && rays >= PLT_WAVE_LEAST && rays <= PLT_WAVE_MOST;
    return (rays == 0 || has_wave) && (o->wide == 0 || (o->wide == 1 && rays > 0)) &&
           o->rays <= PLT_RAYS_INCOHERENT;
}

static int is_batch_valid(const plt_options *o) {
    if (!PLT_WITH_BATCH || o->schedule == PLT_SCHEDULE_BRANCH) {
        return o->schedule == PLT_SCHEDULE_BRANCH && (!PLT_WITH_BATCH || o->batch == 0);
    }
    const unsigned last = PLT_WITH_TASK ? PLT_SCHEDULE_WORKER : PLT_SCHEDULE_BATCH;
    return o->schedule <= last && o->residency == PLT_RESIDENCY_STREAMED &&
           o->batch <= (o->schedule == PLT_SCHEDULE_WORKER ? 0 : PLT_BATCH_MOST);
}

static int is_subtree_valid(const plt_options *o) {
#if PLT_WITH_SUBTREES
    return o->rebuild_most == 0 || (o->rebuild_most >= PLT_SUBTREE_LEAST && o->rebuild == 1 &&
                                    o->order == PLT_ORDER_DEPTH_FIRST);
#else
    return o->rebuild_most == 0;
#endif
}

/* A wide form is made once, when a scene is opened. */
static int is_motion_valid(const plt_options *o) {
    return !PLT_WITH_MOTION || (o->movable == 0 && o->moves_some == 0 && o->rebuild == 0) ||
           (o->movable == 1 && o->moves_some <= PLT_WITH_MOVE_SOME &&
            o->rebuild <= PLT_WITH_REBUILD && o->wide == 0 &&
            (PLT_WITH_STILLS ? o->schedule <= PLT_SCHEDULE_BATCH : o->residency == 0));
}

/* Nodes beside others are of no use where records would have to be, too. */
static int is_records_valid(const plt_options *o) {
    return !PLT_WITH_VERTICES || (o->records <= PLT_RECORDS_NEVER && o->beside <= 1 &&
                                  !(o->beside && o->records == PLT_RECORDS_ALWAYS));
}

/* A grid has no wide form, and stays where it was made. */
static int is_structure_valid(const plt_options *o) {
    return !PLT_WITH_GRID || o->structure == PLT_STRUCTURE_TREE ||
           (o->structure == PLT_STRUCTURE_GRID && o->wide == 0 && o->residency == 0);
}

static int is_whitted_valid(const plt_options *o) {
    return !PLT_WITH_WHITTED || o->whitted == 0 ||
           (o->whitted <= 1 + PLT_BOUNCES_MOST && o->schedule == PLT_SCHEDULE_BRANCH);
}

/* Textures lie on surfaces, by the coordinates of corners. */
static int is_textures_valid(const plt_options *o) {
#if PLT_WITH_TEXTURE
    return o->textures == 0 ? o->texture_bytes == 0
                            : o->textures <= PLT_TEXTURES_BILINEAR && o->surface == 1 &&
                                  (o->texture_bytes == 0 || o->texture_bytes >= PLT_TEXTURE_LEAST);
#else
    (void)o;
    return 1;
#endif
}

int plt_layout_options_valid(const plt_options *o) {
    const unsigned side = o->packet_side;
    return (side & (side - 1)) == 0 && side != 1 && side <= PLT_PACKET_SIDE_MAX &&
           o->residency <= PLT_WITH_STREAMED &&
           (!PLT_WITH_STREAMED || o->store_bytes == 0 || o->store_bytes >= PLT_STORE_LEAST) &&
           (!PLT_WITH_PREFETCH || o->prefetch <= PLT_PREFETCH_MOST) && is_batch_valid(o) &&
           o->order <= PLT_ORDER_TWO_STAGE && o->count_touched <= 1 && is_wave_valid(o) &&
           is_motion_valid(o) && (!PLT_WITH_MOTION || is_subtree_valid(o)) &&
           is_structure_valid(o) && is_records_valid(o) && o->surface <= PLT_WITH_SURFACE &&
           is_whitted_valid(o) && is_textures_valid(o);
}

int plt_layout_order_valid(const plt_info *info, const plt_options *o) {
    return entry_bytes(format_of(info, o), o->order) > 0;
}

static int valid(const plt_info *info, const plt_options *o) {
    return plt_layout_options_valid(o) &&
           plt_scene_left_out(info, o->residency, o->structure) == NULL &&
           plt_layout_residency_valid(info, o) && plt_layout_motion_valid(info, o) &&
           plt_layout_structure_valid(info, o) && plt_layout_records_valid(info, o) &&
           plt_layout_surface_valid(info, o) && plt_layout_order_valid(info, o) &&
           info->treelet_nodes > 0;
}

size_t plt_arena_need(const plt_info *info, int mapped, const plt_options *o) {
    plt_layout layout;
    if (!valid(info, o)) {
        return 0;
    }
    plt_layout_of_image(&layout, info, mapped, o);
    const uint64_t need = plt_layout_need(&layout);
    return need < SIZE_MAX ? (size_t)need : SIZE_MAX;
}

/* A switch: a table of pointers would be data that start-up has to fill in. */
static const char *part_name(enum plt_part part) {
    switch (part) {
#define PLT_PART_CASE(name, lifetime, text)                                                        \
    case PLT_PART_##name:                                                                          \
        return text;
        PLT_PARTS(PLT_PART_CASE)
#undef PLT_PART_CASE
    default:
        return "";
    }
}

int plt_arena_part_get(const plt_info *info, int mapped, const plt_options *o, unsigned index,
                       plt_arena_part *part) {
    plt_layout layout;
    if (!valid(info, o) || index >= PLT_PARTS_COUNT) {
        return PLT_ERR_ARGUMENT;
    }
    plt_layout_of_image(&layout, info, mapped, o);
    part->name = part_name((enum plt_part)index);
    part->lifetime = (uint8_t)plt_part_lifetime((enum plt_part)index);
    part->bytes = layout.bytes[index];
    return PLT_OK;
}
