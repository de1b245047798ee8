/* build_compact - see build_compact.h
 *
 *     | scene so far | blocks grow ->  ...  <- indices | state | builder | cached corners |
 *                      memory of the blocks              scratch
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/build_compact.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/record_cache.h"
#include "engine/scene/counts.h"
#include "engine/scene/validate_compact.h"

size_t plt_compact_build_bytes(uint32_t triangles) {
    return plt_arena_cut_bytes(sizeof(plt_compact_build)) + plt_blocks_scratch_bytes(triangles);
}

/* What the source said when it failed. */
static int cache_status(const plt_opening *o, const plt_record_cache *cache) {
    if (cache == NULL || cache->status == PLT_OK) {
        return PLT_OK;
    }
    *o->fault = cache->fault;
    return cache->status;
}

/* Corners outside the lattice's box would give boxes that do not hold them. */
static int validate_corners(const plt_opening *o, const plt_compact_build *b) {
    const plt_lattice_triangles *t = &b->job.triangles;
    const plt_lattice_box *box = &o->scene->compact.box;
    for (uint32_t i = 0; i < t->count; i++) {
        const unsigned char *at = plt_lattice_triangle(t, i);
        for (uint32_t k = 0; k < 9; k++) {
            const uint32_t q = plt_lattice_coordinate(t, at, k);
            if (q < box->lo[k % 3] || q > box->hi[k % 3]) {
                return plt_broken(o->fault, PLT_I20_CORNERS,
                                  b->corners_offset + (9 * i + k) * t->width,
                                  "a corner lies outside the scene's box");
            }
        }
    }
    return PLT_OK;
}

/* Corners that are not mapped stay where they are, too; the section's checksum is
 * right when they are read for the first time. */
static int open_cache(const plt_opening *o, plt_lattice_triangles *t, const plt_section *s) {
    void *memory = plt_opening_cut(o, PLT_PART_RECORD_CACHE);
    if (memory == NULL) {
        return plt_opening_arena_error(o);
    }
    t->cache = plt_record_cache_init(memory, o->source, s->offset,
                                     plt_corners_bytes(o->scene->info.lattice_bits), t->count);
    const uint32_t crc = plt_record_cache_crc(t->cache, s->bytes);
    const int status = cache_status(o, t->cache);
    return status != PLT_OK || crc == s->crc ? status
                                             : plt_refused(o->fault, PLT_R13_SECTION_CRC, s->offset,
                                                           "a section is damaged (checksum)");
}

/* The corners where they lie: mapped, or behind a cache. */
static int open_corners(const plt_opening *o, plt_compact_build *b, const plt_section *s) {
    plt_lattice_triangles *t = &b->job.triangles;
    int status;
    if (o->source->mapped != NULL) {
        const void *corners = NULL;
        status = plt_opening_section(o, s, &corners);
        t->bytes = corners;
    } else {
        status = open_cache(o, t, s);
    }
    if (status != PLT_OK) {
        return status;
    }
    /* Corners that a source failed to deliver are zeros: its failure comes first. */
    const int valid = validate_corners(o, b), source = cache_status(o, t->cache);
    return source == PLT_OK ? valid : source;
}

/* Blocks grow over the free arena; state, scratch and cache take its end. */
static plt_compact_build *cut_for_build(const plt_opening *o) {
    const plt_layout *l = o->layout;
    const size_t free_bytes = o->arena->bytes - o->arena->used;
    const uint64_t behind = l->bytes[PLT_PART_BUILDER] + l->bytes[PLT_PART_RECORD_CACHE];
    const uint64_t most = l->bytes[PLT_PART_TREE] - PLT_BITS_BEHIND;
    if (behind + PLT_BITS_BEHIND > free_bytes) {
        return NULL;
    }
    const uint64_t room = (free_bytes - behind) & ~(uint64_t)(PLT_ALIGN - 1);
    const size_t bytes = (size_t)(room < most ? room : most);
    const size_t mark = o->arena->used, peak = o->arena->peak;
    unsigned char *memory = plt_arena_cut(o->arena, bytes);
    unsigned char *scratch = plt_opening_cut(o, PLT_PART_BUILDER);
    if (memory == NULL || scratch == NULL) {
        return NULL;
    }
    const plt_compact_build state = {
        .job = {.memory = memory,
                .bytes = bytes,
                .scratch = scratch + plt_arena_cut_bytes(sizeof(plt_compact_build))},
        .mark = mark,
        .peak = peak,
        .scratch_bytes = (size_t)behind};
    plt_compact_build *b = (void *)scratch;
    *b = state;
    return b;
}

/* A status of the builder, with a fault if it is an error. */
static int blocks_status(const plt_opening *o, const plt_blocks_job *job, int status) {
    switch (status) {
    case PLT_ERR_ARENA:
        return plt_opening_arena_error(o);
    case PLT_ERR_LIMIT:
        return plt_limit(o->fault, plt_blocks_limit_message(job));
    default: /* PLT_OK, PLT_MORE */
        return status;
    }
}

static void describe(const plt_opening *o, const plt_section *corners, plt_compact_build *b) {
    const plt_info *info = &o->scene->info;
    b->corners_offset = corners->offset;
    b->job.triangles.count = info->triangles;
    b->job.triangles.width = plt_corner_width(info->lattice_bits);
    b->job.bits = info->lattice_bits;
    b->job.leaf_triangles = info->leaf_triangles;
    b->job.splits = info->splits;
}

int plt_build_compact_begin(const plt_opening *o, const plt_header *header,
                            plt_compact_build **build) {
    const plt_section *corners = plt_header_section(header, PLT_SECTION_CORNERS);
    plt_compact_build *b = cut_for_build(o);
    if (b == NULL) {
        return plt_opening_arena_error(o);
    }
    describe(o, corners, b);
    int status = open_corners(o, b, corners);
    if (status == PLT_OK) {
        status = blocks_status(o, &b->job, plt_blocks_begin(&b->job));
    }
    if (status == PLT_OK) {
        status = cache_status(o, b->job.triangles.cache);
    }
    if (status != PLT_OK) {
        return status;
    }
    *build = b;
    return PLT_MORE;
}

static void set_tree(plt_scene *scene, const plt_blocks_job *job) {
    plt_info *info = &scene->info;
    plt_block_tree *t = &scene->compact;
    t->bytes = job->memory;
    t->used = job->used;
    t->root = job->root;
    info->nodes = info->node_slots = job->nodes;
    info->treelets = job->blocks;
    info->leaf_lists = job->leaves - job->pairs;
    info->intermediate_lists = job->pairs;
    info->node_bytes = job->node_bytes;
    info->triangle_bytes = job->used - job->node_bytes;
    info->depth_stack_entries = job->depth;
    info->local_stack_entries = info->global_stack_entries = 0;
}

/* A source may return other bytes on a second read, so the finished blocks are validated
 * as if they came from an image. */
static int validate_built(const plt_opening *o, uint32_t corners_offset) {
    plt_info expected = o->scene->info, counted;
    const int status = plt_compact_validate(o, &counted);
    if (expected.triangles == 1) {
        expected.triangles = 2; /* it is there twice */
    }
    if (status == PLT_ERR_ARENA || (status == PLT_OK && plt_counts_agree(&expected, &counted))) {
        return status;
    }
    return plt_fault_set(o->fault, PLT_ERR_SOURCE, corners_offset,
                         "the source gave other bytes when it was read again");
}

/* arena.peak counts what the build used, not the free room it was given. The state is
 * read before what follows the blocks is cut where it lies. */
static int finish(const plt_opening *o, const plt_compact_build *b) {
    const size_t needed = b->mark + b->job.peak + b->scratch_bytes;
    const uint32_t corners_offset = b->corners_offset;
    const int is_cached = b->job.triangles.cache != NULL;
    set_tree(o->scene, &b->job);
    o->arena->peak = needed > b->peak ? needed : b->peak;
    plt_arena_release(o->arena, b->mark);
    plt_arena_cut(o->arena, (size_t)o->scene->compact.used + PLT_BITS_BEHIND);
    return is_cached ? validate_built(o, corners_offset) : PLT_OK;
}

/* One step. What the builder makes of a source that has failed counts for nothing. */
static int step(const plt_opening *o, plt_compact_build *b) {
    const int status = plt_blocks_step(&b->job);
    const int source = cache_status(o, b->job.triangles.cache);
    return source == PLT_OK ? blocks_status(o, &b->job, status) : source;
}

int plt_build_compact_step(const plt_opening *o, plt_compact_build *b, uint32_t steps) {
    int status = PLT_MORE;
    for (; status == PLT_MORE && steps > 0; steps--) {
        status = step(o, b);
    }
    return status == PLT_OK ? finish(o, b) : status;
}
