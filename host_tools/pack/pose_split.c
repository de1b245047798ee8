/* pose_split - see pose_split.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/pose_split.h"

#include <float.h>
#include <string.h>

#include "host_tools/base/heap.h"

#define SAMPLES 1024u   /* of a range above twice as many, that choose its plane */
#define SMALL_RANGE 64u /* has planes along the axes of one pose */
#define AXES_OF 4u      /* poses, for larger ones */

/* Triangles of a range, every `step`-th. */
typedef struct samples {
    uint32_t begin, end, step;
} samples;

/* Below it are the triangles whose bins are: by twice their centres on an axis of a pose. */
typedef struct plane {
    uint32_t pose;
    int axis;
    float lo, scale;
    int bin;
    double cost;
} plane;

/* ---- boxes ------------------------------------------------------------------------ */

static inline pose_box no_box(void) {
    const pose_box b = {f4_all(PLT_BOX_FAR), f4_all(-PLT_BOX_FAR)};
    return b;
}

static inline void add_boxes(pose_box *to, const pose_box *from, uint32_t boxes) {
    for (uint32_t i = 0; i < boxes; i++) {
        to[i].lo = f4_min(to[i].lo, from[i].lo);
        to[i].hi = f4_max(to[i].hi, from[i].hi);
    }
}

static void clear_boxes(pose_box *to, uint32_t boxes) {
    for (uint32_t i = 0; i < boxes; i++) {
        to[i] = no_box();
    }
}

static double area_of(const pose_split *s, const pose_box *box) {
    double sum = 0.0;
    for (uint32_t i = 0; i < s->boxes; i++) {
        const f4 side = f4_sub(box[i].hi, box[i].lo);
        float area[4];
        f4_store(area, f4_mul(side, f4_turn(side)));
        sum += s->weight[i] * ((double)area[0] + (double)area[1] + (double)area[2]);
    }
    return sum;
}

static inline const pose_box *boxes_of(const pose_split *s, uint32_t i) {
    return s->box + (size_t)s->order[i] * s->boxes;
}

static inline f4 centre_of(const pose_box *box) {
    return f4_add(box->lo, box->hi);
}

/* ---- planes ----------------------------------------------------------------------- */

static inline int bin_of(const plane *p, const pose_box *box) {
    float centre[4];
    f4_store(centre, centre_of(&box[p->pose]));
    const float x = (centre[p->axis] - p->lo) * p->scale;
    return x > 0.0f ? (x < (float)POSE_SPLIT_BINS ? (int)x : POSE_SPLIT_BINS - 1) : 0;
}

static void fill_bins(pose_split *s, const samples *r, const plane *p) {
    memset(s->count, 0, sizeof s->count);
    for (int i = 0; i < POSE_SPLIT_BINS; i++) {
        clear_boxes(s->bin[i], s->boxes);
    }
    for (uint32_t i = r->begin; i < r->end; i += r->step) {
        const pose_box *box = boxes_of(s, i);
        const int bin = bin_of(p, box);
        s->count[bin]++;
        add_boxes(s->bin[bin], box, s->boxes);
    }
}

/* Behind bin i, times its triangles; 0 where there are none. */
static void costs_behind(const pose_split *s, double cost[POSE_SPLIT_BINS]) {
    pose_box side[POSE_SPLIT_BOXES];
    uint32_t count = 0;
    clear_boxes(side, s->boxes);
    for (int i = POSE_SPLIT_BINS - 1; i > 0; i--) {
        count += s->count[i];
        add_boxes(side, s->bin[i], s->boxes);
        cost[i] = count > 0 ? count * area_of(s, side) : 0.0;
    }
}

/* The first and the last bin are never empty of those that chose them. */
static void sweep(const pose_split *s, plane *p, plane *best) {
    pose_box side[POSE_SPLIT_BOXES];
    double behind[POSE_SPLIT_BINS];
    uint32_t count = 0;
    costs_behind(s, behind);
    clear_boxes(side, s->boxes);
    for (int i = 1; i < POSE_SPLIT_BINS; i++) {
        count += s->count[i - 1];
        add_boxes(side, s->bin[i - 1], s->boxes);
        if (s->count[i - 1] > 0) {
            p->bin = i;
            p->cost = count * area_of(s, side) + behind[i];
            *best = p->cost < best->cost ? *p : *best;
        }
    }
}

static void look_along(pose_split *s, const samples *r, uint32_t pose, plane *best) {
    f4 least = f4_all(FLT_MAX), most = f4_all(-FLT_MAX);
    float lo[4], hi[4];
    for (uint32_t i = r->begin; i < r->end; i += r->step) {
        const f4 centre = centre_of(&boxes_of(s, i)[pose]);
        least = f4_min(centre, least);
        most = f4_max(centre, most);
    }
    f4_store(lo, least);
    f4_store(hi, most);
    for (int a = 0; a < 3; a++) {
        plane p = {.pose = pose, .axis = a, .lo = lo[a]};
        p.scale = (float)POSE_SPLIT_BINS / (hi[a] - lo[a]);
        if (hi[a] > lo[a] && p.scale <= FLT_MAX) {
            fill_bins(s, r, &p);
            sweep(s, &p, best);
        }
    }
}

static plane best_plane(pose_split *s, const samples *r) {
    const uint32_t few = s->boxes < AXES_OF ? s->boxes : AXES_OF;
    plane best = {.cost = DBL_MAX};
    if (r->end - r->begin <= SMALL_RANGE) {
        look_along(s, r, s->boxes / 2, &best);
    }
    for (uint32_t i = 0, none = best.cost == DBL_MAX; none && i < few; i++) {
        look_along(s, r, few > 1 ? i * (s->boxes - 1) / (few - 1) : 0, &best);
    }
    return best;
}

/* ---- ranges ----------------------------------------------------------------------- */

static uint32_t partition(pose_split *s, uint32_t begin, uint32_t end, const plane *p) {
    while (begin < end) {
        const uint32_t triangle = s->order[begin];
        if (bin_of(p, boxes_of(s, begin)) < p->bin) {
            begin++;
        } else {
            s->order[begin] = s->order[--end];
            s->order[end] = triangle;
        }
    }
    return begin;
}

uint32_t pose_split_range(pose_split *s, uint32_t begin, uint32_t end) {
    const uint32_t count = end - begin;
    samples r = {begin, end, count > 2 * SAMPLES ? count / SAMPLES : 1};
    for (;; r.step = 1) {
        const plane p = best_plane(s, &r);
        if (p.cost < DBL_MAX) {
            return partition(s, begin, end, &p);
        }
        if (r.step == 1) { /* all centres are one */
            return begin + count / 2;
        }
    }
}

static pose_box lanes_of(const plt_box *box) {
    const float lo[4] = {box->lo[0], box->lo[1], box->lo[2], 0.0f};
    const float hi[4] = {box->hi[0], box->hi[1], box->hi[2], 0.0f};
    const pose_box b = {f4_load(lo), f4_load(hi)};
    return b;
}

int pose_split_begin(pose_split *s, const plt_build_job *job, const poses *p) {
    s->boxes = p->count + 1;
    s->weight = p->weight;
    s->box = heap_get_aligned((uint64_t)job->count * s->boxes * sizeof *s->box);
    s->order = heap_get((uint64_t)job->count * sizeof *s->order);
    if (s->box == NULL || s->order == NULL) {
        return -1;
    }
    for (uint32_t i = 0; i < job->count; i++) {
        const plt_record *r = &job->records[i];
        const plt_box own = plt_record_box(r);
        pose_box *to = s->box + (size_t)i * s->boxes;
        s->order[i] = i;
        to[0] = lanes_of(&own);
        for (uint32_t k = 0; k < p->count; k++) {
            const plt_box box = poses_box(p, k, plt_primitive_id(plt_get_u32(&r->word[9])));
            to[k + 1] = lanes_of(&box);
        }
    }
    return 0;
}

void pose_split_free(pose_split *s) {
    heap_drop(s->box);
    heap_drop(s->order);
}
