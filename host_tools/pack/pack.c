/* pack - see pack.h
 *
 * The builder is the engine's own (engine/builder), given memory from the heap
 * instead of an arena: an image built here equals what a device builds.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/pack.h"

#include <string.h>

#include "engine/builder/build.h"
#include "engine/image/header.h"
#include "engine/planelet_crc32.h"
#include "engine/tree/record_put.h"
#include "engine/tree/thesis/validate.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/checks.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/node_tree.h"

typedef struct packing {
    const mesh *m;
    const pack_options *options;
    const char *name;
    size_t triangles;
    plt_header header;
    plt_node *nodes; /* in the image, and behind them the records */
    uint32_t node_room;
    plt_record *records;
    quality_stats *quality; /* NULL: the tree stays as it is built */
    uint32_t seconds;
} packing;

static int out_of_memory(const packing *p, fail *f) {
    return fail_set(f, p->name, "%zu triangles: out of memory; pack on a larger machine",
                    p->triangles);
}

static int no_room(const packing *p, fail *f) {
    return fail_set(f, p->name,
                    "treelets in blocks of their own take more than an image holds; use --slots "
                    "thesis, or a smaller --treelet");
}

void pack_record(plt_record *r, const mesh *m, size_t triangle) {
    float corner[9];
    for (size_t c = 0; c < 3; c++) {
        memcpy(&corner[3 * c], m->vertex + 3 * (size_t)m->triangle[3 * triangle + c],
               3 * sizeof corner[0]);
    }
    plt_put_u32(&r->word[9], (uint32_t)triangle);
    plt_record_put(r, corner);
}

static void fill_records(packing *p) {
    for (size_t i = 0; i < p->m->triangles; i++) {
        pack_record(&p->records[i], p->m, i);
    }
}

/* One list of everything, or nothing at all. */
static int leave_unbuilt(packing *p) {
    plt_info *info = &p->header.info;
    p->header.root = PLT_LINK_NONE;
    if (p->options->build == PLT_BUILD_NONE && info->triangles > 0) {
        plt_record_set_last(&p->records[info->triangles - 1], 1);
        p->header.root = plt_link_make(0, PLT_LINK_LEAF);
        info->leaf_triangles = info->triangles;
    }
    return PLT_OK;
}

static int build(packing *p, fail *f) {
    plt_info *info = &p->header.info;
    plt_build_job job = {.records = p->records,
                         .count = info->triangles,
                         .nodes = p->nodes,
                         .room = p->node_room,
                         .leaf_triangles = info->leaf_triangles,
                         .treelet_nodes = info->treelet_nodes,
                         .splits = info->splits,
                         .scratch_bytes = plt_build_scratch_bytes(
                             plt_build_nodes_bound(info->triangles), info->treelet_nodes)};
    job.scratch = heap_get_aligned(job.scratch_bytes);
    if (job.scratch == NULL) {
        return out_of_memory(p, f);
    }
    int status = plt_build(&job);
    const int was_built = status == PLT_OK;
    if (was_built && p->quality != NULL) {
        status = quality_improve(&job, p->seconds, p->options->poses, p->quality);
    }
    heap_drop(job.scratch);
    if (was_built && status != PLT_OK) {
        return p->options->poses != NULL
                   ? fail_set(f, p->name,
                              "%zu triangles: out of memory for a tree of so many frames; use "
                              "--tree-for first",
                              p->triangles)
                   : out_of_memory(p, f);
    }
    if (status != PLT_OK) {
        return fail_set(
            f, p->name,
            "%zu triangles need more than %d levels; use a larger --leaf, or build with a "
            "larger PLT_DEPTH_MAX",
            p->triangles, PLT_DEPTH_MAX);
    }
    info->node_slots = job.node_slots;
    p->header.root = job.root;
    return 0;
}

/* Counts and stack needs, by the validation that opening relies on. */
static int validate(packing *p, fail *f) {
    plt_validate_level levels[PLT_VALIDATE_LEVELS];
    plt_info *info = &p->header.info;
    const plt_tree tree = {.nodes = p->nodes,
                           .records = p->records,
                           .node_slots = info->node_slots,
                           .records_count = info->triangles,
                           .treelet_nodes = info->treelet_nodes,
                           .root = p->header.root};
    const uint32_t k = info->leaf_triangles;
    plt_fault fault;
    if (plt_tree_validate(&tree, levels, info, &fault) != PLT_OK) {
        return fail_set(f, p->name, "the finished tree is refused: %s; please report this",
                        fault.message);
    }
    info->leaf_triangles = k;
    return 0;
}

/* Room for the most nodes that the triangles can take, and behind it the records. */
static int make_room(packing *p, packed *image, fail *f) {
    const plt_info *info = &p->header.info;
    const uint32_t bound = plt_build_nodes_bound(info->triangles);
    p->node_room = info->build == PLT_BUILD_HOST && info->triangles > 0
                       ? plt_build_slots_bound(bound, info->treelet_nodes)
                       : 0;
    const uint64_t nodes = plt_section_bytes(p->node_room, PLT_NODE_BYTES);
    const uint64_t records = plt_header_section_bytes(info, PLT_SECTION_TRIANGLES);
    const uint64_t checks = info->has_checks ? plt_section_bytes(p->node_room, 1) : 0;
    image->bytes = heap_get_aligned(PLT_HEADER_BYTES + nodes + records + checks);
    if (image->bytes == NULL) {
        return out_of_memory(p, f);
    }
    p->nodes = (plt_node *)(void *)(image->bytes + PLT_HEADER_BYTES);
    p->records = (plt_record *)(void *)(image->bytes + PLT_HEADER_BYTES + nodes);
    return 0;
}

/* What the builder made in treelets of one node goes into others, in an image of that size. */
static int move_nodes(packing *p, packed *image, const node_tree *t, const treelet_layout *l,
                      fail *f) {
    plt_info *info = &p->header.info;
    const uint64_t slots = (uint64_t)l->blocks * info->treelet_nodes;
    const uint64_t nodes = slots * PLT_NODE_BYTES + PLT_ALIGN;
    const uint64_t records = plt_header_section_bytes(info, PLT_SECTION_TRIANGLES);
    const uint64_t size = PLT_HEADER_BYTES + nodes + records + (info->has_checks ? slots : 0);
    if (slots > PLT_INDEX_MAX || size > UINT32_MAX) {
        return no_room(p, f);
    }
    unsigned char *bytes = heap_get_aligned(size + PLT_ALIGN);
    if (bytes == NULL) {
        return out_of_memory(p, f);
    }
    plt_node *to = (plt_node *)(void *)(bytes + PLT_HEADER_BYTES);
    plt_record *behind = (plt_record *)(void *)(bytes + PLT_HEADER_BYTES + nodes);
    node_tree_write(t, l, info->treelet_nodes, NODE_EDGES_DIRECT, p->nodes, to);
    memcpy(behind, p->records, (size_t)info->triangles * PLT_RECORD_BYTES);
    heap_drop(image->bytes);
    image->bytes = bytes;
    p->nodes = to;
    p->records = behind;
    info->node_slots = (uint32_t)slots;
    p->header.root = plt_link_make(l->slot[0], 0);
    return 0;
}

static int form_treelets(packing *p, packed *image, fail *f) {
    plt_info *info = &p->header.info;
    plt_box box;
    memcpy(box.lo, info->lo, sizeof box.lo);
    memcpy(box.hi, info->hi, sizeof box.hi);
    node_tree t = {.slot = NULL};
    treelet_layout l;
    if (info->node_slots == 0) { /* no node, in treelets of any size */
        info->treelet_nodes = p->options->treelet_nodes;
        info->treelet_nodes += info->treelet_nodes == PACK_TREELET_AUTO ? 64 : 0;
        return 0;
    }
    if (node_tree_read(&t, p->nodes, plt_link_index(p->header.root), info->node_slots, &box) != 0) {
        return out_of_memory(p, f);
    }
    int status = pack_treelets_form(&l, &t, p->options, &image->treelets);
    if (status != 0) {
        status = status == TREELETS_NO_ROOM ? no_room(p, f) : out_of_memory(p, f);
    } else {
        info->treelet_nodes = image->treelets.of[image->treelets.best].size;
        status = move_nodes(p, image, &t, &l, f);
    }
    treelets_free(&l);
    node_tree_free(&t);
    return status;
}

/* Fills a section up from `used` bytes to `bytes`; returns its CRC. */
static uint32_t close_section(unsigned char *section, uint64_t used, uint64_t bytes) {
    memset(section + used, 0, (size_t)(bytes - used));
    return plt_crc32(0, section, (size_t)bytes);
}

/* Of nodes in a section behind the records, whose own they hold. */
static void put_checks(packing *p, unsigned char *records, unsigned char *checks) {
    const plt_info *info = &p->header.info;
    checks_put_records((plt_record *)(void *)records, plt_header_records(info));
    checks_put_nodes(checks, p->nodes, info->node_slots);
    p->header.section[2].crc =
        close_section(checks, info->node_slots, plt_header_section_bytes(info, PLT_SECTION_CHECKS));
}

/* Brings the records up to the nodes that there are. */
static int assemble(packing *p, packed *image, fail *f) {
    plt_info *info = &p->header.info;
    const uint64_t nodes = plt_header_section_bytes(info, PLT_SECTION_NODES);
    const uint64_t records = plt_header_section_bytes(info, PLT_SECTION_TRIANGLES);
    const uint64_t checks =
        info->has_checks ? plt_header_section_bytes(info, PLT_SECTION_CHECKS) : 0;
    const uint64_t size = PLT_HEADER_BYTES + nodes + records + checks;
    if (image_size_check(p->name, p->triangles, size, 0, image_size_remedy_thesis(p->options), f) !=
        0) {
        return -1;
    }
    unsigned char *node_section = image->bytes + PLT_HEADER_BYTES;
    unsigned char *record_section = node_section + nodes;
    const uint64_t record_bytes = (uint64_t)info->triangles * PLT_RECORD_BYTES;
    memmove(record_section, p->records, (size_t)record_bytes);
    p->header.section[0].crc =
        close_section(node_section, (uint64_t)info->node_slots * PLT_NODE_BYTES, nodes);
    memset(record_section + record_bytes, 0, (size_t)(records - record_bytes));
    if (info->has_checks) {
        put_checks(p, record_section, record_section + records);
    }
    p->header.section[1].crc = plt_crc32(0, record_section, (size_t)records);
    plt_header_write(image->bytes, &p->header);
    image->size = (uint32_t)size;
    image->info = *info;
    return 0;
}

static int pack(packing *p, packed *image, fail *f) {
    plt_info *info = &p->header.info;
    const int differ = pack_treelets_differ(p->options);
    info->triangles = info->source_triangles = (uint32_t)p->triangles;
    info->leaf_triangles = p->options->leaf_triangles;
    info->treelet_nodes = differ ? 1 : p->options->treelet_nodes;
    info->splits = p->options->splits;
    info->build = p->options->build;
    info->has_checks = p->options->checks && info->build == PLT_BUILD_HOST &&
                       p->options->treelet_nodes <= PLT_STREAMED_TREELET_MOST; /* else no use */
    if (make_room(p, image, f) != 0) {
        return -1;
    }
    fill_records(p);
    if (p->options->spend != NULL) {
        mesh_free(p->options->spend);
    }
    const plt_box box = plt_records_box(p->records, 0, info->triangles);
    for (int a = 0; a < 3 && info->triangles > 0; a++) {
        info->lo[a] = box.lo[a];
        info->hi[a] = box.hi[a];
    }
    int status = info->build == PLT_BUILD_HOST ? build(p, f) : leave_unbuilt(p);
    status = status == 0 && differ ? form_treelets(p, image, f) : status;
    if (status != 0 || (info->build != PLT_BUILD_DEVICE && validate(p, f) != 0)) {
        return -1;
    }
    return assemble(p, image, f);
}

static int pack_all(packing *p, packed *image, fail *f) {
    const packed nothing = {.size = 0};
    *image = nothing;
    p->triangles = p->m->triangles;
    if (image_size_check_thesis(p->name, p->triangles, p->options, f) != 0) {
        return -1;
    }
    const int status = pack(p, image, f);
    if (status != 0) {
        pack_free(image);
    }
    return status;
}

int pack_mesh(packed *image, const mesh *m, const pack_options *options, const char *name,
              fail *f) {
    packing p = {.m = m, .options = options, .name = name};
    return pack_all(&p, image, f);
}

int pack_mesh_better(packed *image, const mesh *m, const pack_options *options, uint32_t seconds,
                     quality_stats *stats, const char *name, fail *f) {
    packing p = {.m = m, .options = options, .name = name, .quality = stats, .seconds = seconds};
    *stats = (quality_stats){.passes = 0};
    return pack_all(&p, image, f);
}

void pack_free(packed *image) {
    heap_drop(image->bytes);
    image->bytes = NULL;
}
