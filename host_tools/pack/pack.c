/* pack - see pack.h
 *
 * The builder is the engine's own (engine/builder), given memory from the heap
 * instead of an arena: an image built here equals what a device builds.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/pack.h"

#include <stdlib.h>
#include <string.h>

#include "engine/builder/build.h"
#include "engine/image/header.h"
#include "engine/planelet_crc32.h"
#include "engine/tree/canonical.h"
#include "engine/tree/thesis/validate.h"

typedef struct packing {
    const mesh *m;
    const pack_options *options;
    const char *name;
    plt_header header;
    plt_record *records;
    plt_node *nodes;
    quality_stats *quality; /* NULL: the tree stays as it is built */
    uint32_t seconds;
} packing;

static int out_of_memory(const packing *p, fail *f) {
    return fail_set(f, p->name, "%zu triangles: out of memory; pack on a larger machine",
                    p->m->triangles);
}

int pack_too_large(const mesh *m, const char *name, fail *f) {
    return fail_set(f, name,
                    "%zu triangles: an image holds at most 2^27 - 1 triangles and 4 GiB; "
                    "leave some out",
                    m->triangles);
}

/* By x, then y, then z. */
static int is_below(const float p[3], const float q[3]) {
    int a = 0;
    while (a < 2 && p[a] == q[a]) {
        a++;
    }
    return p[a] < q[a];
}

void pack_record(plt_record *r, const mesh *m, size_t triangle) {
    float corner[3][3];
    for (size_t c = 0; c < 3; c++) {
        memcpy(corner[c], m->vertex + 3 * (size_t)m->triangle[3 * triangle + c], sizeof corner[c]);
    }
    const uint32_t first =
        plt_canonical_first(is_below(corner[1], corner[0]), is_below(corner[2], corner[0]),
                            is_below(corner[2], corner[1]));
    for (unsigned c = 0; c < 3; c++) {
        plt_put_floats((unsigned char *)&r->word[3 * c], corner[(first + c) % 3], 3);
    }
    plt_put_u32(&r->word[9], (uint32_t)triangle | plt_canonical_rotation(first)
                                                      << PLT_PRIMITIVE_ROTATION_SHIFT);
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
    const uint32_t nodes = plt_build_nodes_bound(info->triangles);
    plt_build_job job = {.records = p->records,
                         .count = info->triangles,
                         .room = plt_build_slots_bound(nodes, info->treelet_nodes),
                         .leaf_triangles = info->leaf_triangles,
                         .treelet_nodes = info->treelet_nodes,
                         .splits = info->splits,
                         .scratch_bytes = plt_build_scratch_bytes(nodes, info->treelet_nodes)};
    p->nodes = malloc((size_t)job.room * sizeof *p->nodes + 1);
    job.nodes = p->nodes;
    job.scratch = malloc(job.scratch_bytes);
    if (p->nodes == NULL || job.scratch == NULL) {
        free(job.scratch);
        return out_of_memory(p, f);
    }
    int status = plt_build(&job);
    const int was_built = status == PLT_OK;
    if (was_built && p->quality != NULL) {
        status = quality_improve(&job, &p->records, p->seconds, p->quality);
    }
    free(job.scratch);
    if (was_built && status != PLT_OK) {
        return out_of_memory(p, f);
    }
    if (status != PLT_OK) {
        return fail_set(
            f, p->name,
            "%zu triangles need more than %d levels; use a larger --leaf, or build with a "
            "larger PLT_DEPTH_MAX",
            p->m->triangles, PLT_DEPTH_MAX);
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

static int assemble(packing *p, packed *image, fail *f) {
    plt_info *info = &p->header.info;
    const uint64_t nodes = plt_section_bytes(info->node_slots, PLT_NODE_BYTES);
    const uint64_t records = plt_section_bytes(info->triangles, PLT_RECORD_BYTES);
    const uint64_t size = PLT_HEADER_BYTES + nodes + records;
    if (size > UINT32_MAX) {
        return pack_too_large(p->m, p->name, f);
    }
    image->bytes = aligned_alloc(PLT_SECTION_ALIGN, (size_t)size);
    if (image->bytes == NULL) {
        return out_of_memory(p, f);
    }
    memset(image->bytes, 0, (size_t)size);
    image->size = (uint32_t)size;
    unsigned char *node_section = image->bytes + PLT_HEADER_BYTES;
    unsigned char *record_section = node_section + nodes;
    if (info->node_slots > 0) {
        memcpy(node_section, p->nodes, (size_t)info->node_slots * PLT_NODE_BYTES);
    }
    if (info->triangles > 0) {
        memcpy(record_section, p->records, (size_t)info->triangles * PLT_RECORD_BYTES);
    }
    p->header.section[0].crc = plt_crc32(0, node_section, (size_t)nodes);
    p->header.section[1].crc = plt_crc32(0, record_section, (size_t)records);
    plt_header_write(image->bytes, &p->header);
    image->info = *info;
    return 0;
}

static int pack(packing *p, packed *image, fail *f) {
    plt_info *info = &p->header.info;
    info->triangles = info->source_triangles = (uint32_t)p->m->triangles;
    info->leaf_triangles = p->options->leaf_triangles;
    info->treelet_nodes = p->options->treelet_nodes;
    info->splits = p->options->splits;
    info->build = p->options->build;
    p->records = malloc(p->m->triangles * sizeof *p->records + 1);
    if (p->records == NULL) {
        return out_of_memory(p, f);
    }
    fill_records(p);
    const plt_box box = plt_records_box(p->records, 0, info->triangles);
    for (int a = 0; a < 3 && info->triangles > 0; a++) {
        info->lo[a] = box.lo[a];
        info->hi[a] = box.hi[a];
    }
    const int status = info->build == PLT_BUILD_HOST ? build(p, f) : leave_unbuilt(p);
    if (status != 0 || (info->build != PLT_BUILD_DEVICE && validate(p, f) != 0)) {
        return -1;
    }
    return assemble(p, image, f);
}

static int pack_all(packing *p, packed *image, fail *f) {
    const packed nothing = {NULL, 0, {0}};
    *image = nothing;
    if (p->m->triangles > PLT_INDEX_MAX) {
        return pack_too_large(p->m, p->name, f);
    }
    const int status = pack(p, image, f);
    free(p->records);
    free(p->nodes);
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
    free(image->bytes);
    image->bytes = NULL;
}
