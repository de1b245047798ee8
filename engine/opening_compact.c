/* opening_compact - scenes of compact blocks
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/budget.h"
#include "engine/builder/blocks.h"
#include "engine/opening.h"
#include "engine/tree/validate_records.h"

static void describe(const plt_opening *o) {
    plt_engine *e = o->e;
    plt_block_tree *t = &e->walker.blocks.tree;
    t->root = e->header.root;
    t->leaf_triangles = e->header.info.leaf_triangles;
    t->lattice = e->header.lattice;
    t->box = e->header.lattice_box;
    t->ids.bits = e->header.info.primitive_id_bits;
    for (int a = 0; a < 3; a++) {
        e->walker.blocks.origin[a] = t->lattice.origin[a];
    }
    e->walker.tree.box = plt_box_empty();
    for (int a = 0; a < 3 && e->header.info.triangles > 0; a++) {
        e->walker.tree.box.lo[a] = e->header.info.lo[a];
        e->walker.tree.box.hi[a] = e->header.info.hi[a];
    }
}

static int same_counts(const plt_info *a, const plt_info *b) {
    return a->nodes == b->nodes && a->leaf_lists == b->leaf_lists &&
           a->intermediate_lists == b->intermediate_lists && a->treelets == b->treelets &&
           a->triangles == b->triangles && a->node_bytes == b->node_bytes &&
           a->node_slots == b->node_slots && a->local_stack_entries == b->local_stack_entries &&
           a->global_stack_entries == b->global_stack_entries &&
           a->depth_stack_entries == b->depth_stack_entries;
}

/* Numbers of the section are those of the packed mesh. */
static int check_numbers(const plt_opening *o) {
    const plt_info *info = &o->e->header.info;
    const plt_primitive_ids *n = &o->e->walker.blocks.tree.ids;
    for (uint32_t i = 0; i < info->triangles && n->bytes != NULL; i++) {
        const uint32_t word = plt_primitive_word_find(n, i);
        if (plt_primitive_id(word) >= info->source_triangles || plt_primitive_rotation(word) > 2) {
            const uint32_t at = (uint32_t)((uint64_t)i * n->bits >> 3);
            return plt_broken(o->fault, 19,
                              plt_header_section(&o->e->header, PLT_SECTION_PRIMITIVE_IDS)->offset +
                                  at,
                              "a triangle's number is too large");
        }
    }
    return PLT_OK;
}

/* The blocks keep the rules; `found`: what they hold. */
static int survey_blocks(const plt_opening *o, plt_info *found) {
    plt_engine *e = o->e;
    const size_t mark = e->arena.used;
    *found = e->header.info;
    plt_blocks_validate_level *frames = plt_arena_cut(&e->arena, plt_budget_survey(found));
    if (frames == NULL) {
        return plt_opening_short(o);
    }
    const int status = plt_blocks_validate(&e->walker.blocks.tree, frames, found, o->fault);
    plt_arena_release(&e->arena, mark);
    return status;
}

static int check_blocks(const plt_opening *o) {
    const plt_section *s = plt_header_section(&o->e->header, PLT_SECTION_BLOCKS);
    plt_info found;
    int status = survey_blocks(o, &found);
    if (status == PLT_ERR_IMAGE) {
        o->fault->offset += s->offset;
    }
    if (status == PLT_OK && !same_counts(&o->e->header.info, &found)) {
        status = plt_broken(o->fault, 18, 24, "the header's counts are not the blocks'");
    }
    return status == PLT_OK ? check_numbers(o) : status;
}

/* What was read of a source more than once need not have been the same: what became
 * of it is checked like an image. */
static int check_built(const plt_opening *o) {
    plt_info expected = o->e->header.info, found;
    const int status = survey_blocks(o, &found);
    if (expected.triangles == 1) {
        expected.triangles = 2; /* it is there twice */
    }
    if (status == PLT_ERR_ARENA || (status == PLT_OK && same_counts(&expected, &found))) {
        return status;
    }
    return plt_fault_set(o->fault, PLT_ERR_SOURCE,
                         plt_header_section(&o->e->header, PLT_SECTION_CORNERS)->offset,
                         "the source gave other bytes when it was read again");
}

static int take_blocks(const plt_opening *o) {
    plt_block_tree *t = &o->e->walker.blocks.tree;
    const plt_info *info = &o->e->header.info;
    const void *blocks = NULL, *numbers = NULL, *records = NULL;
    int status = plt_opening_section(o, PLT_SECTION_BLOCKS, 0, &blocks);
    if (status == PLT_OK && info->primitive_id_bits > 0) {
        status = plt_opening_section(o, PLT_SECTION_PRIMITIVE_IDS, 0, &numbers);
    }
    if (status == PLT_OK && info->geometry_format == PLT_GEOMETRY_FLOAT) {
        status = plt_opening_section(o, PLT_SECTION_TRIANGLES, 0, &records);
    }
    if (status == PLT_OK && records != NULL) {
        status = plt_records_validate(&o->e->header, records, o->fault);
    }
    t->bytes = blocks;
    t->ids.bytes = numbers;
    t->records = records;
    t->used = info->node_bytes + info->triangle_bytes;
    return status == PLT_OK ? check_blocks(o) : status;
}

/* Corners outside the lattice's box would give boxes and frames that lie. */
static int check_corners(const plt_opening *o, const plt_lattice_triangles *t) {
    const plt_lattice_box *box = &o->e->header.lattice_box;
    for (uint32_t i = 0; i < t->count; i++) {
        const unsigned char *at = plt_lattice_triangle(t, i);
        for (uint32_t k = 0; k < 9; k++) {
            const uint32_t q = plt_lattice_number(t, at, k);
            if (q < box->lo[k % 3] || q > box->hi[k % 3]) {
                return plt_broken(o->fault, 20,
                                  plt_header_section(&o->e->header, PLT_SECTION_CORNERS)->offset +
                                      (9 * i + k) * t->width,
                                  "a corner lies outside the scene's box");
            }
        }
    }
    return PLT_OK;
}

/* What the source said of its failure. */
static int window_status(const plt_opening *o, const plt_record_cache *w) {
    if (w == NULL || w->status == PLT_OK) {
        return PLT_OK;
    }
    *o->fault = w->fault;
    return w->status;
}

/* Corners that are not mapped stay where they are, too; the section's checksum is
 * right when they are read for the first time. */
static int open_window(const plt_opening *o, plt_lattice_triangles *t, void *memory) {
    plt_engine *e = o->e;
    const plt_section *s = plt_header_section(&e->header, PLT_SECTION_CORNERS);
    t->cache = plt_record_cache_init(memory, &e->source, s->offset, 9 * t->width, t->count);
    const uint32_t crc = plt_record_cache_crc(t->cache, s->bytes);
    const int status = window_status(o, t->cache);
    return status != PLT_OK || crc == s->crc
               ? status
               : plt_refused(o->fault, 13, s->offset, "a section is damaged (checksum)");
}

static size_t window_bytes(const plt_engine *e) {
    const uint32_t corners = plt_corners_bytes(e->header.info.lattice_bits);
    return e->source.mapped != NULL ? 0 : plt_arena_cut_bytes(plt_record_cache_bytes(corners));
}

/* Blocks grow over the free arena, scratch and window take its end. */
static int cut_for_build(const plt_opening *o, plt_blocks_job *job) {
    plt_engine *e = o->e;
    const size_t scratch = plt_arena_cut_bytes(plt_blocks_scratch_bytes(e->header.info.triangles));
    const size_t free_bytes = e->arena.bytes - e->arena.used, end = scratch + window_bytes(e);
    if (end + PLT_BITS_BEHIND > free_bytes) {
        return plt_opening_short(o);
    }
    const plt_info worst = plt_budget_worst_tree(&e->header.info);
    const uint64_t most = (uint64_t)worst.node_bytes + worst.triangle_bytes;
    const size_t room = (free_bytes - end) & ~(size_t)(PLT_ALIGN - 1);
    job->bytes = room < most ? room : (size_t)most;
    job->memory = plt_arena_cut(&e->arena, job->bytes);
    job->scratch = plt_arena_cut(&e->arena, scratch);
    return job->memory != NULL && job->scratch != NULL ? PLT_OK : plt_opening_short(o);
}

/* The corners where they lie: mapped, or behind a window. */
static int take_corners(const plt_opening *o, plt_lattice_triangles *t) {
    plt_engine *e = o->e;
    const void *corners = NULL;
    int status;
    if (e->source.mapped != NULL) {
        status = plt_opening_section(o, PLT_SECTION_CORNERS, 0, &corners);
        t->bytes = corners;
    } else {
        status = open_window(o, t, plt_arena_cut(&e->arena, window_bytes(e)));
    }
    return status == PLT_OK ? check_corners(o, t) : status;
}

static int begin_build(const plt_opening *o) {
    plt_engine *e = o->e;
    const plt_info *info = &e->header.info;
    const plt_blocks_job job = {
        .triangles = {NULL, info->triangles, plt_corner_width(info->lattice_bits), 0, NULL},
        .bits = info->lattice_bits,
        .leaf_triangles = info->leaf_triangles,
        .splits = info->splits};
    e->build = job;
    e->build_mark = e->arena.used;
    e->build_peak = e->arena.peak;
    int status = cut_for_build(o, &e->build);
    if (status == PLT_OK) {
        status = take_corners(o, &e->build.triangles);
    }
    if (status == PLT_OK && plt_blocks_begin(&e->build) != PLT_OK) {
        status = plt_opening_short(o);
    }
    if (status == PLT_OK) {
        status = window_status(o, e->build.triangles.cache);
    }
    e->building = status == PLT_OK;
    return status == PLT_OK ? PLT_MORE : status;
}

static void believe(const plt_opening *o, const plt_blocks_job *job) {
    plt_info *info = &o->e->header.info;
    plt_block_tree *t = &o->e->walker.blocks.tree;
    t->bytes = job->memory;
    t->used = job->used;
    t->root = o->e->header.root = job->root;
    info->nodes = info->node_slots = job->nodes;
    info->treelets = job->blocks;
    info->leaf_lists = job->leaves - job->pairs;
    info->intermediate_lists = job->pairs;
    info->node_bytes = job->node_bytes;
    info->triangle_bytes = job->used - job->node_bytes;
    info->depth_stack_entries = job->depth;
}

/* Room that was offered and not needed counts for no peak. */
static int finish_build(const plt_opening *o) {
    plt_engine *e = o->e;
    const size_t scratch = plt_arena_cut_bytes(plt_blocks_scratch_bytes(e->header.info.triangles));
    const size_t needed = e->build_mark + e->build.peak + scratch + window_bytes(e);
    plt_arena_release(&e->arena, e->build_mark);
    e->arena.peak = needed > e->build_peak ? needed : e->build_peak;
    plt_arena_cut(&e->arena, (size_t)e->build.used + PLT_BITS_BEHIND);
    believe(o, &e->build);
    return e->build.triangles.cache != NULL ? check_built(o) : PLT_OK;
}

int plt_opening_step(const plt_opening *o, uint32_t steps) {
    int status = PLT_MORE;
    while (status == PLT_MORE && steps > 0) {
        status = plt_blocks_step(&o->e->build);
        steps--;
    }
    const int source = window_status(o, o->e->build.triangles.cache);
    if (source != PLT_OK) {
        status = source;
    } else if (status == PLT_OK) {
        status = finish_build(o);
    } else if (status == PLT_ERR_ARENA) {
        status = plt_opening_short(o);
    } else if (status != PLT_MORE) {
        status = plt_limit(o->fault, "the scene needs more than PLT_DEPTH_MAX levels");
    }
    return status;
}

int plt_opening_compact(const plt_opening *o) {
    describe(o);
    return o->e->header.info.build == PLT_BUILD_DEVICE ? begin_build(o) : take_blocks(o);
}
