/* open_instances - scenes of bodies that instances place
 *
 * Each body is validated as a tree of its own; that they lie one behind the other and fill the
 * sections is what ranges are checked for. Matrices come later (instances_room.c).
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header_at.h"
#include "engine/scene/counts.h"
#include "engine/scene/open_formats.h"
#include "engine/scene/validate_thesis.h"
#include "engine/tree/thesis/validate.h"
#include "engine/tree/validate_records.h"

#if PLT_WITH_INSTANCES

/* What has been checked so far. */
typedef struct progress {
    const plt_opening *o;
    const plt_header *header;
    plt_info counted;
    uint32_t slots, records; /* of the bodies before */
    plt_validate_level *levels;
} progress;

static int broken(const progress *p, uint32_t at, const char *message) {
    const plt_section *bodies = plt_header_section(p->header, PLT_SECTION_BODIES);
    return plt_broken(p->o->fault, PLT_I27_BODIES, bodies->offset + at, message);
}

/* Its box is one, and its ranges follow those before and lie within the sections. */
static int is_in_range(const progress *p, const plt_body *b) {
    const plt_info *info = &p->header->info;
    int good = b->first_slot == p->slots && b->slots <= info->node_slots - p->slots &&
               b->slots % info->treelet_nodes == 0 && b->first_record == p->records &&
               b->records > 0 && b->records <= info->triangles - p->records;
    for (int a = 0; a < 3; a++) {
        const float lo = b->box.lo[a], hi = b->box.hi[a];
        good &= lo >= -PLT_COORD_MAX && lo <= hi && hi <= PLT_COORD_MAX;
    }
    return good;
}

/* A header as if the body were a scene. */
static void describe_alone(const progress *p, const plt_body *b, plt_header *alone) {
    *alone = *p->header;
    alone->root = b->root;
    alone->info.triangles = b->records;
    alone->info.node_slots = b->slots;
    memcpy(alone->info.lo, b->box.lo, sizeof b->box.lo);
    memcpy(alone->info.hi, b->box.hi, sizeof b->box.hi);
    alone->section[0].offset += b->first_slot * PLT_NODE_BYTES;
    alone->section[1].offset += b->first_record * PLT_RECORD_BYTES;
}

static int check_body(progress *p, uint32_t index) {
    const plt_instanced *scene = &p->o->scene->instanced;
    plt_info counted = {0};
    plt_header alone;
    plt_body b;
    plt_body_get(&scene->bodies, index, &b);
    const uint32_t reserved = plt_get_u32(plt_body_at(&scene->bodies, index) + PLT_BODY_RESERVED);
    if (!is_in_range(p, &b) || b.root == PLT_LINK_NONE || reserved != 0) {
        return broken(p, index * PLT_BODY_BYTES, "a body is not where or what it must be");
    }
    describe_alone(p, &b, &alone);
    const plt_tree tree = {.nodes = scene->nodes + b.first_slot,
                           .records = scene->records + b.first_record,
                           .node_slots = b.slots,
                           .records_count = b.records,
                           .treelet_nodes = alone.info.treelet_nodes,
                           .root = b.root};
    int status = plt_records_validate(&alone, tree.records, p->o->fault);
    if (status == PLT_OK) {
        status = plt_planes_validate(&alone, tree.nodes, p->o->fault);
    }
    if (status == PLT_OK) {
        status = plt_tree_validate(&tree, p->levels, &counted, p->o->fault);
        if (status == PLT_ERR_IMAGE) {
            p->o->fault->offset = plt_thesis_offset_in_image(
                &alone, p->o->fault,
                plt_header_section(p->header, PLT_SECTION_BODIES)->offset + index * PLT_BODY_BYTES);
        }
    }
    plt_counts_add(&p->counted, &counted);
    p->slots += b.slots;
    p->records += b.records;
    return status;
}

static int check_instances(const progress *p) {
    const plt_bodies *bodies = &p->o->scene->instanced.bodies;
    uint64_t triangles = 0;
    for (uint32_t i = 0; i < bodies->instances; i++) {
        const uint32_t body = plt_body_of(bodies, i);
        plt_body b;
        if (body >= bodies->bodies) {
            return broken(p, bodies->bodies * PLT_BODY_BYTES + 4 * i,
                          "an instance has a body that is not there");
        }
        plt_body_get(bodies, body, &b);
        triangles += b.records;
    }
    return triangles == p->header->info.placed_triangles
               ? PLT_OK
               : broken(p, 0, "instances do not have the triangles that the header says");
}

static int check_counts(const progress *p) {
    const plt_info *info = &p->header->info;
    if (p->slots != info->node_slots || p->records != info->triangles ||
        !plt_counts_agree(info, &p->counted)) {
        return plt_broken(p->o->fault, PLT_I8_COUNTS, PLT_AT_COUNTS + 4,
                          "the header's counts are not the trees'");
    }
    return p->counted.global_stack_entries > PLT_GLOBAL_STACK_MAX
               ? plt_limit(p->o->fault, "the scene needs more than PLT_GLOBAL_STACK_MAX entries")
               : PLT_OK;
}

static int check(const plt_opening *o, const plt_header *header) {
    progress p = {.o = o, .header = header, .counted = header->info};
    const plt_info *info = &header->info;
    int status = PLT_OK;
    p.counted.nodes = p.counted.leaf_lists = p.counted.intermediate_lists = 0;
    p.counted.treelets = p.counted.leaf_triangles = 0;
    p.counted.local_stack_entries = p.counted.global_stack_entries = 0;
    p.counted.depth_stack_entries = 0;
    p.levels = plt_opening_cut(o, PLT_PART_VALIDATION);
    if (p.levels == NULL) {
        return plt_opening_arena_error(o);
    }
    for (uint32_t i = 0; i < info->bodies && status == PLT_OK; i++) {
        status = check_body(&p, i);
    }
    if (status == PLT_OK) {
        status = check_instances(&p);
    }
    return status == PLT_OK ? check_counts(&p) : status;
}

int plt_open_instances(const plt_opening *o, const plt_header *header,
                       struct plt_compact_build **build) {
    plt_instanced *scene = &o->scene->instanced;
    const void *records = NULL, *nodes = NULL, *bodies = NULL;
    (void)build;
    int status =
        plt_opening_section(o, plt_header_section(header, PLT_SECTION_TRIANGLES), &records);
    if (status == PLT_OK) {
        status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_NODES), &nodes);
    }
    if (status == PLT_OK) {
        status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_BODIES), &bodies);
    }
    scene->nodes = nodes;
    scene->records = records;
    scene->bodies = (plt_bodies){bodies, header->info.bodies, header->info.instances};
    scene->treelet_nodes = header->info.treelet_nodes;
    const size_t mark = o->arena->used;
    if (status == PLT_OK) {
        status = check(o, header);
    }
    plt_arena_release(o->arena, mark);
    return status;
}

#endif
