/* kd_structure - kd-trees as structures: built exactly or by samples, whole or on demand
 *
 * A frame is a new tree, in the memory of the last one.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/kd/kd_packet.h"

enum variant { KD, BOXES, FAST, LAZY };

static const kd_way ways[] = {{1, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 1}};

typedef struct kd_structure {
    kd_way way;
    triangle_set triangles;
    kd_scene scene;
    kd_tree tree;
    kd_tracing tracing;
    uint32_t packet;  /* rays; 1: they go one by one */
    kd_packet *group; /* NULL when there are none */
    uint64_t *tested; /* likewise */
    uint64_t rays;
    int is_whole; /* 0: memory ran out, and there is no tree to trace */
    char name[64];
} kd_structure;

static int out_of_memory(kd_structure *k, fail *f) {
    k->is_whole = 0;
    return fail_set(f, k->name,
                    "%u triangles: out of memory for a kd-tree, which had %llu bytes; leave some "
                    "out, or take another structure",
                    (unsigned)k->triangles.count, (unsigned long long)kd_tree_bytes(&k->tree));
}

static int build(kd_structure *k, const mesh *m, fail *f) {
    k->is_whole = triangle_set_fill(&k->triangles, m) == 0 &&
                  kd_scene_set(&k->scene, &k->triangles, k->way.is_clipped) == 0;
    if (k->is_whole && k->tracing.mailbox == NULL) {
        k->tracing.mailbox = heap_get_zeroed((uint64_t)k->triangles.count * 4 + 1);
        k->is_whole = k->tracing.mailbox != NULL;
    }
    if (k->is_whole && k->packet > 1 && k->tested == NULL) {
        heap_drop(k->group);
        k->group = heap_get(sizeof *k->group);
        k->tested = heap_get((uint64_t)k->triangles.count * sizeof *k->tested + 1);
        k->is_whole = k->group != NULL && k->tested != NULL;
    }
    if (!k->is_whole || (m->triangles > 0 && kd_build(&k->tree, &k->scene, &k->way) != 0)) {
        return out_of_memory(k, f);
    }
    k->tracing.tree = &k->tree;
    k->tracing.scene = &k->scene;
    return 0;
}

static void close_kd(void *self) {
    kd_structure *k = self;
    triangle_set_free(&k->triangles);
    kd_scene_free(&k->scene);
    kd_tree_free(&k->tree);
    heap_drop(k->tracing.mailbox);
    heap_drop(k->group);
    heap_drop(k->tested);
    heap_drop(k);
}

static void *open_kd(unsigned variant, const mesh *m, const structure_options *o, const char *name,
                     fail *f) {
    kd_structure *k = heap_get_zeroed(sizeof *k);
    if (k == NULL) {
        return NULL;
    }
    const uint32_t side = o->packet_side > 0 && o->packet_side < 8 ? o->packet_side : 8;
    k->packet = o->one_by_one ? 1 : side * side;
    k->way = ways[variant];
    strncpy(k->name, name, sizeof k->name - 1);
    if (build(k, m, f) != 0) {
        close_kd(k);
        return NULL;
    }
    return k;
}

static int move_kd(void *self, const mesh *m, fail *f) {
    return build(self, m, f);
}

/* Numbers come round after 2^32 rays. */
static void next_number(kd_structure *k) {
    if (++k->tracing.number == 0) {
        memset(k->tracing.mailbox, 0, (size_t)k->triangles.count * 4);
        k->tracing.number = 1;
    }
}

static int trace_alone(kd_structure *k, lone_ray *r) {
    next_number(k);
    return kd_trace(&k->tracing, r);
}

static int trace_one(kd_structure *k, const plt_ray *ray, plt_hit *hit) {
    lone_ray r;
    lone_ray_store_miss(hit, k->tracing.any);
    if (lone_ray_set(&r, &k->triangles.box, ray)) {
        if (trace_alone(k, &r) != 0) {
            return -1;
        }
        lone_ray_store(&r, hit, k->tracing.any);
    }
    return 0;
}

/* Rays that cannot go together go one by one. */
static int trace_together(kd_structure *k, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    kd_packet *p = k->group;
    uint8_t of[KD_PACKET]; /* places of those that are rays */
    int status = 0;
    p->count = 0;
    for (uint32_t i = 0; i < count; i++) {
        lone_ray_store_miss(&hits[i], k->tracing.any);
        of[p->count] = (uint8_t)i;
        p->count += lone_ray_set(&p->ray[p->count], &k->triangles.box, &rays[i]) != 0;
    }
    if (p->count > 0 && kd_packet_fits(p, &k->scene)) {
        next_number(k);
        k->tracing.packets.packets++;
        k->tracing.packets.signs++;
        status = kd_packet_trace(p, &k->tracing, k->tested);
    } else {
        for (uint32_t i = 0; i < p->count && status == 0; i++) {
            status = trace_alone(k, &p->ray[i]);
        }
    }
    for (uint32_t i = 0; i < p->count; i++) {
        lone_ray_store(&p->ray[i], &hits[of[i]], k->tracing.any);
    }
    return status;
}

static int trace_kd(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                    fail *f) {
    kd_structure *k = self;
    if (!k->is_whole) {
        return out_of_memory(k, f);
    }
    k->tracing.any = any;
    k->rays += count;
    for (uint32_t i = 0; i < count; i += k->packet) {
        const uint32_t left = count - i, now = left < k->packet ? left : k->packet;
        int status = 0;
        if (k->triangles.count == 0) {
            for (uint32_t n = 0; n < now; n++) {
                lone_ray_store_miss(&hits[i + n], any);
            }
        } else {
            status = k->packet > 1 ? trace_together(k, rays + i, hits + i, now)
                                   : trace_one(k, rays + i, hits + i);
        }
        if (status != 0) {
            return out_of_memory(k, f);
        }
    }
    return 0;
}

static void count_kd(const void *self, structure_statistics *to) {
    const kd_structure *k = self;
    const uint64_t each = sizeof(plt_record) + sizeof *k->tracing.mailbox +
                          (k->way.is_clipped ? sizeof *k->scene.plane : 0);
    const packet_counts *p = &k->tracing.packets;
    *to = (structure_statistics){.rays = k->rays,
                                 .packets = p->packets,
                                 .one_sign = p->signs,
                                 .packet_nodes = p->nodes,
                                 .rays_at_nodes = p->node_rays,
                                 .masked_at_nodes = p->node_rays_out,
                                 .packet_triangles = p->triangles,
                                 .rays_at_triangles = p->triangle_rays,
                                 .masked_at_triangles = p->triangle_rays_out,
                                 .node_visits = k->tracing.counts.visits,
                                 .box_tests = k->tracing.counts.planes,
                                 .triangle_tests = k->tracing.counts.tests,
                                 .sieved = k->tracing.counts.sieved,
                                 .build_work = k->tree.work,
                                 .bytes = kd_tree_bytes(&k->tree),
                                 .triangle_bytes = each * k->triangles.count,
                                 .nodes = k->tree.inner,
                                 .leaves = k->tree.leaves,
                                 .unsplit = k->tree.unsplit,
                                 .references = k->tree.references,
                                 .strays = k->tree.strays};
}

static void forget_kd(void *self) {
    kd_structure *k = self;
    k->rays = 0;
    k->tracing.counts = (kd_counts){0, 0, 0, 0};
    k->tracing.packets = (packet_counts){.rays = 0};
}

static const structure_switch switches[] = {
    STRUCTURE_SIDE_SWITCHES, STRUCTURE_SINGLE_SWITCH, {NULL, NULL, 0, 0}};

#define KD_KIND(NAME, VARIANT, ABOUT)                                                              \
    {                                                                                              \
        .name = NAME, .about = ABOUT, .variant = VARIANT, .open = open_kd, .move = move_kd,        \
        .trace = trace_kd, .count = count_kd, .forget = forget_kd, .close = close_kd,              \
        .switches = switches, .one_by_one = 1                                                      \
    }

const structure_kind structure_kd =
    KD_KIND("kd", KD, "kd-tree by the surface area heuristic, of parts of triangles");
const structure_kind structure_kd_boxes = KD_KIND("kd-boxes", BOXES, "the same, of their boxes");
const structure_kind structure_kd_fast =
    KD_KIND("kd-fast", FAST, "kd-tree by samples of the heuristic, of boxes");
const structure_kind structure_kd_lazy =
    KD_KIND("kd-lazy", LAZY, "the same, node by node as rays come to them");
