/* planes_structure - see planes_structure.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/planes/planes_structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/base/triangle_set.h"
#include "host_tools/baselines/packet/packet_triangles.h"

typedef struct planes_structure {
    const planes_layout *layout;
    binary_options build;
    unsigned form;
    void *nodes;
    triangle_set triangles; /* permuted, as leaves have them */
    planes_tracing tracing;
    uint32_t leaves, inner;
    uint64_t work, rays; /* rays: that went one by one */
    int is_made;         /* there are nodes */
    int is_whole;        /* they fit the triangles */
    char name[64];
} planes_structure;

static int out_of_memory(planes_structure *s, fail *f) {
    s->is_whole = 0;
    return fail_set(f, s->name, "%u triangles: out of memory for a hierarchy; leave some out",
                    (unsigned)s->triangles.count);
}

/* ---- the tree ----------------------------------------------------------------------- */

static float longest_side(const triangle_set *t) {
    float longest = 0.0f;
    for (uint32_t i = 0; i < t->count; i++) {
        const plt_box b = plt_record_box(&t->record[i]);
        const float side = plt_box_longest_side(&b);
        longest = side > longest ? side : longest;
    }
    return longest;
}

static void set_triangles(planes_structure *s) {
    s->tracing.record = s->triangles.record;
    s->tracing.box = s->triangles.box;
    s->tracing.longest = longest_side(&s->triangles);
}

static int make(planes_structure *s) {
    binary_tree t = {.node = NULL};
    int status = binary_tree_build(&t, s->triangles.record, s->triangles.count, &s->triangles.box,
                                   &s->build);
    s->layout->drop(s->nodes);
    s->is_made = 0;
    if (status == 0 && t.nodes > 0) {
        s->work += t.work;
        s->leaves = t.leaves;
        s->inner = t.nodes - t.leaves;
        status = s->layout->make(s->nodes, &t, s->form);
        s->is_made = status == 0;
    }
    binary_tree_free(&t);
    return status;
}

static int build(planes_structure *s, const mesh *m, fail *f) {
    if (triangle_set_fill(&s->triangles, m) != 0 || make(s) != 0) {
        return out_of_memory(s, f);
    }
    set_triangles(s);
    s->is_whole = 1;
    return 0;
}

int planes_move(void *self, const mesh *m, fail *f) {
    planes_structure *s = self;
    if (s->layout->refit == NULL || !s->is_made) {
        return build(s, m, f);
    }
    triangle_set_move(s->triangles.record, s->triangles.count, m);
    s->triangles.box = plt_records_box(s->triangles.record, 0, s->triangles.count);
    set_triangles(s);
    if (s->layout->refit(s->nodes, s->triangles.record) != 0) {
        return out_of_memory(s, f);
    }
    s->is_whole = 1;
    return 0;
}

/* ---- opening ------------------------------------------------------------------------ */

static void choose(planes_structure *s, const structure_options *o) {
    const uint8_t *c = o->choice;
    planes_way *way = &s->tracing.way;
    s->build = s->layout->build;
    if (c[STRUCTURE_SPLITS] != 0) {
        s->build.splits = c[STRUCTURE_SPLITS] == STRUCTURE_SAH ? PLT_SPLIT_SAH : PLT_SPLIT_MEDIAN;
        s->build.by_grid = 0;
    }
    s->build.leaf = c[STRUCTURE_LEAF] != 0 ? c[STRUCTURE_LEAF] : s->build.leaf;
    s->form = c[PLANES_FORM];
    way->boxes = c[PLANES_WAY] == PLANES_BY_ROOM;
    way->bits = c[STRUCTURE_MASKS] != STRUCTURE_RANGE;
    way->steps.early = c[STRUCTURE_EARLY] == 1;
    way->steps.frustum = c[STRUCTURE_FRUSTUM] == 1;
}

static int open_packets(planes_structure *s, uint32_t side) {
    planes_tracing *t = &s->tracing;
    if (packet_open(&t->packet, side) != 0) {
        return -1;
    }
    if (t->way.boxes) {
        t->room = heap_get(PLANES_DEPTH * sizeof *t->room);
    } else {
        t->rest = heap_get_aligned(PLANES_DEPTH * sizeof *t->rest);
    }
    return t->room != NULL || t->rest != NULL ? 0 : -1;
}

void *planes_open(const planes_layout *layout, const mesh *m, const structure_options *o,
                  const char *name, fail *f) {
    planes_structure *s = heap_get_zeroed(sizeof *s);
    if (s == NULL) {
        return NULL;
    }
    s->layout = layout;
    s->nodes = heap_get_zeroed(layout->bytes_of_it);
    s->tracing.nodes = s->nodes;
    strncpy(s->name, name, sizeof s->name - 1);
    choose(s, o);
    if (s->nodes == NULL || (!o->one_by_one && open_packets(s, o->packet_side) != 0)) {
        out_of_memory(s, f);
        planes_close(s);
        return NULL;
    }
    if (build(s, m, f) != 0) {
        planes_close(s);
        return NULL;
    }
    return s;
}

void planes_close(void *self) {
    planes_structure *s = self;
    if (s->nodes != NULL) {
        s->layout->drop(s->nodes);
    }
    packet_close(&s->tracing.packet);
    heap_drop(s->tracing.rest);
    heap_drop(s->tracing.room);
    heap_drop(s->nodes);
    triangle_set_free(&s->triangles);
    heap_drop(s);
}

int planes_suits(const structure_options *o, fail *f) {
    const uint8_t *c = o->choice;
    const int is_single = c[STRUCTURE_SIDE] == 1, has_boxes = c[PLANES_WAY] == PLANES_BY_ROOM;
    if (is_single &&
        (c[PLANES_WAY] | c[STRUCTURE_MASKS] | c[STRUCTURE_EARLY] | c[STRUCTURE_FRUSTUM]) != 0) {
        return fail_set(
            f, "single",
            "how packets go says nothing of rays one by one; leave it out, or give 4x4 instead");
    }
    if (!has_boxes && (c[STRUCTURE_MASKS] | c[STRUCTURE_EARLY] | c[STRUCTURE_FRUSTUM]) != 0) {
        return fail_set(
            f, "intervals",
            "range, bits, early and frustum are for boxes; leave them out, or give boxes");
    }
    return 0;
}

/* ---- tracing ------------------------------------------------------------------------- */

static void trace_alone(planes_structure *s, const plt_ray *ray, plt_hit *hit) {
    lone_ray r;
    lone_ray_store_miss(hit, s->tracing.any);
    if (lone_ray_set(&r, &s->tracing.box, ray)) {
        s->layout->lone(&s->tracing, &r);
        lone_ray_store(&r, hit, s->tracing.any);
    }
}

static void trace_packet(planes_structure *s, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    packet_state *p = &s->tracing.packet;
    if (packet_begin(p, &s->tracing.box, rays, count, s->tracing.any)) {
        s->layout->packet(&s->tracing);
    }
    packet_store(p, hits);
}

int planes_trace(void *self, const plt_ray *rays, plt_hit *hits, uint32_t count, int any, fail *f) {
    planes_structure *s = self;
    const uint32_t side = s->tracing.packet.side, most = side > 0 ? side * side : 1;
    if (!s->is_whole) {
        return out_of_memory(s, f);
    }
    s->tracing.any = any;
    s->rays += count;
    if (!s->is_made) {
        packet_store_misses(hits, count, any);
        return 0;
    }
    for (uint32_t i = 0; i < count; i += most) {
        const uint32_t left = count - i;
        if (side > 0) {
            trace_packet(s, rays + i, hits + i, left < most ? left : most);
        } else {
            trace_alone(s, rays + i, hits + i);
        }
    }
    return 0;
}

/* ---- counts -------------------------------------------------------------------------- */

void planes_count(const void *self, structure_statistics *to) {
    const planes_structure *s = self;
    const planes_counts *c = &s->tracing.counts;
    packet_counts_put(&s->tracing.packet.counts, to);
    to->rays = s->rays;
    to->node_visits += c->visits + c->leaves;
    to->box_tests += c->planes;
    to->triangle_tests += c->tests;
    to->build_work = s->work;
    to->bytes = to->thesis_bytes = s->is_made ? s->layout->bytes(s->nodes) : 0;
    to->triangle_bytes = (uint64_t)s->triangles.count * sizeof(plt_record);
    to->nodes = s->is_made ? s->inner : 0;
    to->leaves = s->is_made ? s->leaves : 0;
    to->references = s->triangles.count;
}

void planes_forget(void *self) {
    planes_structure *s = self;
    s->rays = 0;
    s->tracing.counts = (planes_counts){.visits = 0};
    s->tracing.packet.counts = (packet_counts){.rays = 0};
}
