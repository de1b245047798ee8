/* instances_rig - a few bodies, placed at random in some frames, packed and opened
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_INSTANCES_RIG_H
#define REFERENCE_INSTANCES_RIG_H

#include "board/fake/fake.h"
#include "host_tools/pack/instances.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"

enum {
    INSTANCES_RIG_BODIES = 3,
    INSTANCES_RIG_MOST = 64,
    INSTANCES_RIG_FRAMES = 5,
    INSTANCES_RIG_TRIANGLES = 400 /* of a body, at most */
};

/* What matrices do beside turning and moving. */
enum instances_kind { INSTANCES_RIGID, INSTANCES_SCALED, INSTANCES_SKEWED };

typedef struct instances_config {
    rig_config scene; /* of each body */
    uint32_t instances;
    enum instances_kind kind;
    float apart; /* bodies, of size 2, are that far from 0 at most */
    int is_mapped;
    uint64_t seed;
} instances_config;

typedef struct instances_rig {
    mesh body[INSTANCES_RIG_BODIES];
    packed packed[INSTANCES_RIG_BODIES];
    rig alone[INSTANCES_RIG_BODIES]; /* without a tree: the reference */
    uint32_t body_of[INSTANCES_RIG_MOST];
    float matrix[INSTANCES_RIG_FRAMES][INSTANCES_RIG_MOST][PLT_MATRIX_FLOATS];
    instance_set all;
    packed image;
    fake_link link;
    unsigned char *arena;
    size_t arena_bytes;
    plt_engine *engine;
    plt_fault fault;
} instances_rig;

void instances_rig_matrix(float m[PLT_MATRIX_FLOATS], enum instances_kind kind, float apart,
                          random_state *r);

/* Makes bodies and matrices, and packs them. */
void instances_rig_pack(instances_rig *r, const instances_config *config);

/* The image alone; pack_free() it. */
packed instances_rig_image(const instances_config *config);

/* Opens the image in an arena of just its need, less `short_by` bytes. A status of plt_open. */
int instances_rig_open(instances_rig *r, const instances_config *config, size_t short_by);

/* Both. */
int instances_rig_start(instances_rig *r, const instances_config *config);

/* 1: nothing was written behind the arena. Frees all. */
int instances_rig_close(instances_rig *r);

/* All triangles of a frame where its matrices put them, in the order of ids. */
void instances_rig_flatten(const instances_rig *r, const float (*matrix)[PLT_MATRIX_FLOATS],
                           mesh *to);

/* What a ray hits: each body's list of triangles, as its instances see the ray. */
plt_hit instances_rig_hit(const instances_rig *r, const float (*matrix)[PLT_MATRIX_FLOATS],
                          const plt_ray *ray, int any);

#endif
