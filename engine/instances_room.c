/* instances_room - see instances_room.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/instances_room.h"

#include <string.h>

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/trace/instances_state.h"

#if PLT_WITH_INSTANCES

static uint64_t placed_bytes(const plt_info *info) {
    return (uint64_t)info->instances * sizeof(plt_placed);
}

static uint64_t top_bytes(const plt_info *info) {
    return (uint64_t)(info->instances - 1) * sizeof(plt_top_node);
}

uint64_t plt_instances_room_bytes(const plt_info *info) {
    return placed_bytes(info) + top_bytes(info) + (uint64_t)info->instances * sizeof(uint32_t);
}

/* They are in the arena. */
static plt_placed *placed_of(const plt_engine *e) {
    return (plt_placed *)(uintptr_t)e->scene.instanced.placed;
}

static void get_matrix(const plt_engine *e, const float (*matrix)[PLT_MATRIX_FLOATS], uint32_t i,
                       float to[PLT_MATRIX_FLOATS]) {
    if (matrix != NULL) {
        memcpy(to, matrix[i], sizeof matrix[i]);
    } else {
        plt_matrices_get(&e->matrices, i, to);
    }
}

/* Its box and inverse to `to`, which keeps its body and first id. */
static int place(const plt_engine *e, const float (*matrix)[PLT_MATRIX_FLOATS], uint32_t i,
                 plt_placed *to, float *spread) {
    float m[PLT_MATRIX_FLOATS];
    plt_body body;
    plt_body_get(&e->scene.instanced.bodies, placed_of(e)[i].body, &body);
    get_matrix(e, matrix, i, m);
    return plt_placed_set(to, m, &body.box, spread);
}

static void set_box(plt_engine *e) {
    plt_box *box = &e->scene.box;
    *box = plt_box_empty();
    for (uint32_t i = 0; i < e->scene.info.instances; i++) {
        plt_box_add(box, &e->scene.instanced.placed[i].box);
    }
    memcpy(e->scene.info.lo, box->lo, sizeof box->lo);
    memcpy(e->scene.info.hi, box->hi, sizeof box->hi);
}

/* All are looked at before any is placed. */
uint32_t plt_instances_place(plt_engine *e, const float (*matrix)[PLT_MATRIX_FLOATS]) {
    plt_instanced *scene = &e->scene.instanced;
    const uint32_t count = e->scene.info.instances;
    plt_placed *placed = placed_of(e);
    plt_top_node *top = (plt_top_node *)(uintptr_t)scene->top;
    float spread = 0.0f;
    for (uint32_t i = 0; i < count; i++) {
        plt_placed tried;
        if (!place(e, matrix, i, &tried, &spread)) {
            return i;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        place(e, matrix, i, &placed[i], &spread);
    }
    scene->spread = spread;
    scene->root = plt_top_build(top, (uint32_t *)(void *)(top + (count - 1)), placed, count);
    set_box(e);
    e->rendering.done = 1;
    return count;
}

int plt_instances_show(plt_engine *e, plt_fault *fault) {
    plt_matrices *m = &e->matrices;
    const uint32_t refused = plt_instances_place(e, NULL);
    if (refused < e->scene.info.instances) {
        m->failed = m->at;
        return plt_broken(fault, PLT_I29_PLACED,
                          m->section + m->at * m->frame_bytes + PLT_MATRICES_HEAD +
                              refused * PLT_MATRIX_BYTES,
                          "a matrix cannot be inverted, or places a body beyond 2^40");
    }
    return PLT_OK;
}

/* Bodies and ids of all instances, which do not change. */
static void describe(plt_engine *e, void *const part[PLT_PARTS_COUNT]) {
    plt_instanced *scene = &e->scene.instanced;
    plt_placed *placed = part[PLT_PART_INSTANCES];
    uint32_t id = 0;
    for (uint32_t i = 0; i < e->scene.info.instances; i++) {
        plt_body body;
        placed[i].body = plt_body_of(&scene->bodies, i);
        placed[i].first_id = id;
        plt_body_get(&scene->bodies, placed[i].body, &body);
        id += body.records;
    }
    scene->placed = placed;
    scene->top = (plt_top_node *)(void *)((char *)part[PLT_PART_INSTANCES] +
                                          (size_t)placed_bytes(&e->scene.info));
}

int plt_instances_room_set(plt_engine *e, const plt_header *header,
                           void *const part[PLT_PARTS_COUNT], plt_fault *fault) {
    if (e->scene.format != PLT_FORMAT_INSTANCES) {
        return PLT_OK;
    }
    plt_packet_init(&plt_instances_state_of(&e->traversal)->packet, part[PLT_PART_INNER],
                    e->options.packet_side);
    describe(e, part);
    plt_matrices_init(&e->matrices, header, &e->source, part[PLT_PART_MATRICES]);
    plt_matrices_seek(&e->matrices, 0);
    const int status = plt_matrices_read(&e->matrices, UINT32_MAX, fault);
    return status == PLT_OK ? plt_instances_show(e, fault) : status;
}

#endif
