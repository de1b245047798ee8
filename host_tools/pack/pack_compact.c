/* pack_compact - from a mesh to an image of compact blocks
 *
 * The builder is the engine's own, as in pack.c; the device builds the same
 * blocks from the corners that --build device packs.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "engine/base/bits.h"
#include "engine/builder/blocks.h"
#include "engine/image/header.h"
#include "engine/image/items.h"
#include "engine/planelet_crc32.h"
#include "engine/tree/compact/block.h"
#include "engine/tree/primitive_id.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/checks.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/lattice_boxes.h"
#include "host_tools/pack/lattice_snap.h"
#include "host_tools/pack/moving.h"
#include "host_tools/pack/pack.h"
#include "host_tools/pack/quality_order.h"

typedef struct compacting {
    const mesh *m;
    const compact_options *options;
    const char *name;
    snapped s;
    plt_header header;
    size_t source_triangles;
    packed *image;      /* blocks are built where they stay in it */
    uint64_t room;      /* of image->bytes */
    uint32_t *order;    /* index in `s` of each triangle in image order; owned; NULL: of no use */
    uint32_t triangles; /* in image order */
    uint16_t *levels;   /* of a better tree; owned; NULL: there is none */
} compacting;

static int out_of_memory(const compacting *c, fail *f) {
    return fail_set(f, c->name, "%zu triangles: out of memory; pack on a larger machine",
                    c->source_triangles);
}

/* The mesh of each triangle on the lattice; NULL when there is nothing to say. */
static uint16_t *mesh_indices(const compacting *c) {
    const compact_options *o = c->options;
    if (o->mesh_end == NULL || o->meshes < 2 || o->meshes > 1022) {
        return NULL;
    }
    uint16_t *of = heap_get((uint64_t)c->s.count * sizeof *of);
    unsigned at = 0;
    for (uint32_t i = 0; i < c->s.count && of != NULL; i++) { /* sources ascend, or are near */
        while (at > 0 && c->s.source[i] < o->mesh_end[at - 1]) {
            at--;
        }
        while (at + 1 < o->meshes && c->s.source[i] >= o->mesh_end[at]) {
            at++;
        }
        of[i] = (uint16_t)at;
    }
    return of;
}

static int over_limit(const compacting *c, const plt_blocks_job *job, fail *f) {
    if (job->limit == PLT_BLOCKS_LIMIT_DEPTH) {
        return fail_set(
            f, c->name,
            "%u triangles need more than %d levels; use a larger --leaf, or build with a "
            "larger PLT_DEPTH_MAX",
            c->s.count, PLT_DEPTH_MAX);
    }
    if (job->limit == PLT_BLOCKS_LIMIT_BYTES) {
        return fail_set(f, c->name,
                        "%u triangles: compact blocks have at most %u bytes, and %u of the "
                        "triangles fill them; use %s--nodes thesis, or --reduce",
                        c->s.count, PLT_BLOCKS_BYTES_MAX, job->written,
                        c->options->leaf_triangles < 4 ? "a larger --leaf, " : "");
    }
    return fail_set(f, c->name, "%u triangles: %s; use --nodes thesis", c->s.count,
                    plt_blocks_limit_message(job));
}

/* Room for the header, the blocks while they are built, and what comes behind them. */
static int make_room(compacting *c, uint64_t blocks, fail *f) {
    const plt_info *info = &c->header.info;
    uint32_t kind[PLT_SECTIONS_MOST];
    const unsigned count = plt_header_kinds(info, kind);
    c->room = PLT_HEADER_BYTES + blocks;
    for (unsigned i = 0; i < count; i++) {
        c->room += plt_header_section_bytes(info, kind[i]) + PLT_SECTION_ALIGN;
    }
    c->image->bytes = heap_get_aligned(c->room);
    return c->image->bytes == NULL ? out_of_memory(c, f) : 0;
}

/* Whether anything is written in image order behind the blocks. */
static int needs_order(const compacting *c) {
    return c->options->floats || c->header.info.primitive_id_bits > 0;
}

static int run_job(compacting *c, plt_blocks_job *job, fail *f) {
    job->bytes = (size_t)image_size_room_blocks(c->s.count);
    if (make_room(c, job->bytes, f) != 0) {
        return -1;
    }
    job->memory = c->image->bytes + PLT_HEADER_BYTES;
    job->scratch = heap_get(plt_blocks_scratch_bytes(c->s.count));
    c->order = needs_order(c) ? heap_get(((uint64_t)c->s.count + 2) * sizeof *c->order) : NULL;
    if (job->scratch == NULL || (c->order == NULL && needs_order(c))) {
        return out_of_memory(c, f);
    }
    int status = plt_blocks_begin(job);
    plt_blocks_record_order(job, c->order);
    for (status = status == PLT_OK ? PLT_MORE : status; status == PLT_MORE;) {
        status = plt_blocks_step(job);
    }
    return status == PLT_OK ? 0 : over_limit(c, job, f);
}

/* A better tree, if it is asked for: triangles come into its order. */
static int improve(compacting *c, fail *f) {
    const compact_options *o = c->options;
    if (o->quality == NULL || c->s.count == 0) {
        return 0;
    }
    c->levels = heap_get((uint64_t)c->s.count * sizeof *c->levels);
    const int status = c->levels == NULL
                           ? PLT_ERR_ARENA
                           : quality_order(&c->s, o->splits, o->leaf_triangles, o->floats,
                                           o->quality_seconds, o->quality, c->levels);
    if (status == PLT_ERR_LIMIT) { /* the builder of blocks says so, or does without */
        heap_drop(c->levels);
        c->levels = NULL;
        return 0;
    }
    return status == PLT_OK ? 0 : out_of_memory(c, f);
}

static int build(compacting *c, fail *f) {
    plt_info *info = &c->header.info;
    if (improve(c, f) != 0) {
        return -1;
    }
    plt_blocks_job job = {.triangles = {c->s.corners, c->s.count, c->s.width, c->options->floats},
                          .bits = c->s.lattice.bits,
                          .leaf_triangles = info->leaf_triangles,
                          .levels = c->levels,
                          .geometry_tail = info->has_checks ? PLT_IDS_CHECK_BYTES : 0,
                          .splits = info->splits};
    uint16_t *meshes = mesh_indices(c);
    job.mesh = meshes;
    moving_vertices *moving = c->options->moving;
    int status = 0;
    if (moving != NULL &&
        moving_begin(&job, &c->s, c->m, moving, info->primitive_id_bits > 0) != 0) {
        status = out_of_memory(c, f);
    }
    status = status == 0 ? run_job(c, &job, f) : status;
    if (moving != NULL) {
        moving_end(&job, moving);
    }
    heap_drop(job.scratch);
    heap_drop(meshes);
    heap_drop(c->s.corners); /* ids and records come of the others */
    c->s.corners = NULL;
    info->nodes = info->node_slots = job.nodes;
    info->treelets = job.blocks;
    info->leaf_lists = job.leaves - job.pairs;
    info->intermediate_lists = job.pairs;
    info->node_bytes = job.node_bytes;
    info->triangle_bytes = job.used - job.node_bytes;
    info->depth_stack_entries = job.depth;
    c->header.root = job.root;
    c->triangles = job.written;
    return status;
}

static void describe(compacting *c) {
    plt_info *info = &c->header.info;
    c->header.lattice = c->s.lattice;
    c->header.lattice_box = c->s.box;
    plt_box box = c->s.mesh_box; /* hits depend on it: of the triangles where they are */
    if (!c->options->floats) {
        plt_lattice_to_box(&c->s.lattice, &c->s.box, &box);
    }
    for (int a = 0; a < 3; a++) {
        c->header.lattice_box.lo[a] = c->s.count > 0 ? c->s.box.lo[a] : 0;
        info->lo[a] = c->s.count > 0 ? box.lo[a] : 0.0f;
        info->hi[a] = c->s.count > 0 ? box.hi[a] : 0.0f;
    }
    info->nodes_format = PLT_NODES_COMPACT;
    info->geometry_format = c->options->floats ? PLT_GEOMETRY_FLOAT : PLT_GEOMETRY_LATTICE;
    info->lattice_bits = (uint8_t)c->s.lattice.bits;
    info->splits = c->options->splits;
    info->build = c->options->build;
    info->leaf_triangles = c->options->leaf_triangles;
    info->treelet_nodes = PLT_BLOCK_NODES_MOST;
    info->source_triangles = (uint32_t)c->source_triangles;
    info->triangles = c->s.count;
    if (c->options->numbers && !c->options->floats && info->build == PLT_BUILD_HOST &&
        c->s.count > 0) {
        info->primitive_id_bits = (uint8_t)(2 + plt_bits_for(info->source_triangles - 1));
        info->has_checks = c->options->checks;
    }
    c->header.root = PLT_LINK_NONE;
}

static void write_primitive_ids(const compacting *c, unsigned char *to) {
    const uint32_t bits = c->header.info.primitive_id_bits;
    for (uint32_t i = 0; i < c->triangles; i++) {
        const uint32_t from = c->order[i];
        const uint64_t at = (uint64_t)i * bits;
        plt_bits_put(to + (at >> 3), (uint32_t)(at & 7), bits,
                     c->s.source[from] << 2 | c->s.rotation[from]);
    }
}

static void write_records(const compacting *c, unsigned char *to) {
    for (uint32_t i = 0; i < c->triangles; i++, to += PLT_RECORD_BYTES) {
        plt_record r;
        pack_record(&r, c->m, c->s.source[c->order[i]]);
        memcpy(to, &r, sizeof r);
    }
}

/* Blocks are there already. Returns the bytes that have been filled. */
static uint64_t fill_section(const compacting *c, uint32_t kind, unsigned char *to) {
    const plt_info *info = &c->header.info;
    const uint64_t blocks = (uint64_t)info->node_bytes + info->triangle_bytes;
    const uint64_t corners = (uint64_t)c->s.count * 9 * c->s.width;
    switch (kind) {
    case PLT_SECTION_CORNERS:
        memcpy(to, c->s.corners, (size_t)corners);
        return corners;
    case PLT_SECTION_TRIANGLES:
        write_records(c, to);
        return (uint64_t)c->triangles * PLT_RECORD_BYTES;
    case PLT_SECTION_PRIMITIVE_IDS:
        write_primitive_ids(c, to);
        return plt_header_section_bytes(info, kind);
    default:
        return blocks;
    }
}

/* The section and its padding; returns its bytes. */
static size_t write_section(const compacting *c, uint32_t kind, unsigned char *at) {
    const size_t bytes = (size_t)plt_header_section_bytes(&c->header.info, kind);
    if (kind == PLT_SECTION_PRIMITIVE_IDS) { /* bits are put into zeros */
        memset(at, 0, bytes);
    }
    const size_t used = (size_t)fill_section(c, kind, at);
    memset(at + used, 0, bytes - used);
    if (kind == PLT_SECTION_PRIMITIVE_IDS && c->header.info.has_checks) {
        checks_put_ids(c->image->bytes + PLT_HEADER_BYTES, at, &c->header);
    }
    return bytes;
}

static uint64_t image_bytes(const compacting *c) {
    uint32_t kind[PLT_SECTIONS_MOST];
    const unsigned count = plt_header_kinds(&c->header.info, kind);
    uint64_t size = PLT_HEADER_BYTES;
    for (unsigned i = 0; i < count; i++) {
        size += plt_header_section_bytes(&c->header.info, kind[i]);
    }
    return size;
}

static int assemble(compacting *c, fail *f) {
    uint32_t kind[PLT_SECTIONS_MOST];
    const unsigned count = plt_header_kinds(&c->header.info, kind);
    const uint64_t size = image_bytes(c);
    if (image_size_check(c->name, c->source_triangles, size, 0,
                         image_size_remedy_compact(c->options), f) != 0 ||
        (c->image->bytes == NULL && make_room(c, 0, f) != 0)) {
        return -1;
    }
    unsigned char *at = c->image->bytes + PLT_HEADER_BYTES;
    for (unsigned i = 0; i < count; i++) {
        at += write_section(c, kind[i], at);
    }
    at = c->image->bytes + PLT_HEADER_BYTES;
    for (unsigned i = 0; i < count; i++) {
        const size_t bytes = (size_t)plt_header_section_bytes(&c->header.info, kind[i]);
        c->header.section[i].crc = plt_crc32(0, at, bytes);
        at += bytes;
    }
    plt_header_write(c->image->bytes, &c->header);
    c->image->size = (uint32_t)size;
    c->image->info = c->header.info;
    return 0;
}

/* Any other step is as fine as the bits allow, but far from the origin floats are coarser. */
static int auto_step_keeps_it(const compacting *c) {
    const lattice_wish wish = {.bits = PLT_LATTICE_BITS_MOST, .fewest = 1};
    snapped s;
    fail ignored = {""};
    const int keeps = lattice_snap_as(&s, c->m, &wish, c->name, &ignored) == 0 &&
                      s.loss.largest_move <= c->options->tolerance;
    snapped_free(&s);
    return keeps;
}

static int power_is_too_coarse(const compacting *c, double moved, fail *f) {
    return fail_set(f, c->name,
                    "--step power keeps no --tolerance %g there, but %.2g; use a larger one, "
                    "--step auto%s, or --geometry float",
                    c->options->tolerance, moved, auto_step_keeps_it(c) ? "" : " with --centre");
}

/* Takes more bits until the tolerance is kept: floats far from the origin, and steps of a
 * power of two, are coarser than the bits alone. */
static int keep_tolerance(compacting *c, lattice_wish *wish, fail *f) {
    while (lattice_snap_as(&c->s, c->m, wish, c->name, f) == 0) {
        if (c->s.loss.largest_move <= c->options->tolerance) {
            return 0;
        }
        const double moved = c->s.loss.largest_move;
        snapped_free(&c->s);
        if (wish->bits++ == PLT_LATTICE_BITS_MOST) {
            return wish->power ? power_is_too_coarse(c, moved, f)
                               : fail_set(f, c->name,
                                          "no lattice keeps --tolerance %g there, but %.2g; use a "
                                          "larger one, --centre, or --geometry float",
                                          c->options->tolerance, moved);
        }
    }
    return -1;
}

static int put_on_lattice(compacting *c, fail *f) {
    const compact_options *o = c->options;
    lattice_wish wish = {.bits = o->lattice_bits,
                         .power = o->power,
                         .fewest = o->tolerance > 0.0,
                         .boxes = o->floats};
    if (o->moving != NULL) {
        return moving_snap(&c->s, c->m, &o->moving->lattice) == 0 ? 0 : out_of_memory(c, f);
    }
    if (o->floats) {
        return lattice_boxes(&c->s, c->m, &wish, c->name, f);
    }
    return o->tolerance > 0.0 ? keep_tolerance(c, &wish, f)
                              : lattice_snap_as(&c->s, c->m, &wish, c->name, f);
}

static int pack(compacting *c, fail *f) {
    const compact_options *o = c->options;
    if (image_size_check_compact(c->name, c->source_triangles, o, f) != 0 ||
        put_on_lattice(c, f) != 0 ||
        image_size_check_lattice(c->name, c->s.count, o, c->s.width, f) != 0) {
        return -1;
    }
    describe(c);
    if (o->spend != NULL && !o->floats) {
        mesh_free(o->spend);
    }
    if (o->build == PLT_BUILD_HOST) {
        if (build(c, f) != 0) {
            return -1;
        }
        c->header.info.triangles = c->triangles;
    }
    return assemble(c, f);
}

int pack_compact(packed *image, const mesh *m, const compact_options *options, const char *name,
                 lattice_loss *loss, fail *f) {
    const packed nothing = {.size = 0};
    compacting c = {
        .m = m, .options = options, .name = name, .source_triangles = m->triangles, .image = image};
    if (options->quality != NULL) {
        *options->quality = (quality_stats){.passes = 0};
    }
    *image = nothing;
    const int status = pack(&c, f);
    if (status != 0) {
        pack_free(image);
    }
    *loss = c.s.loss;
    snapped_free(&c.s);
    heap_drop(c.order);
    heap_drop(c.levels);
    return status;
}
