/* top - see top.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/instances/top.h"

#include <string.h>

enum { BINS = 8 };

#define FLAT 7.888609052210118e-31f /* 2^-100: centres that are no farther apart lie together */

typedef struct builder {
    plt_top_node *nodes;
    uint32_t *order;
    const plt_placed *placed;
} builder;

/* Instances order[begin] .. order[end - 1], at least two. */
typedef struct range {
    uint32_t begin, end, level;
} range;

_Static_assert(sizeof(range) <= sizeof(plt_top_node), "it waits where its first node will be");

static float centre(const builder *b, uint32_t at, int axis) {
    const plt_box *box = &b->placed[b->order[at]].box;
    return box->lo[axis] + box->hi[axis];
}

static plt_box box_of(const builder *b, uint32_t begin, uint32_t end) {
    plt_box box = plt_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        plt_box_add(&box, &b->placed[b->order[i]].box);
    }
    return box;
}

/* ---- where to split --------------------------------------------------------------- */

/* The axis on which centres are farthest apart, and their bins there. */
typedef struct bins {
    int axis;
    float least, scale; /* scale 0: they lie together */
    plt_box box[BINS];
    uint32_t count[BINS];
} bins;

static unsigned bin_of(const builder *b, const bins *s, uint32_t at) {
    const float bin = (centre(b, at, s->axis) - s->least) * s->scale;
    return bin < (float)BINS ? (unsigned)bin : BINS - 1;
}

static void choose_axis(const builder *b, const range *r, bins *s) {
    float widest = FLAT;
    s->scale = 0.0f;
    for (int a = 0; a < 3; a++) {
        float lo = centre(b, r->begin, a), hi = lo;
        for (uint32_t i = r->begin + 1; i < r->end; i++) {
            const float c = centre(b, i, a);
            lo = c < lo ? c : lo;
            hi = c > hi ? c : hi;
        }
        if (hi - lo > widest) {
            widest = hi - lo;
            s->axis = a;
            s->least = lo;
            s->scale = (float)BINS / widest;
        }
    }
}

static void fill_bins(const builder *b, const range *r, bins *s) {
    for (unsigned i = 0; i < BINS; i++) {
        s->box[i] = plt_box_empty();
        s->count[i] = 0;
    }
    for (uint32_t i = r->begin; i < r->end; i++) {
        const unsigned bin = bin_of(b, s, i);
        plt_box_add(&s->box[bin], &b->placed[b->order[i]].box);
        s->count[bin]++;
    }
}

/* The first bin of the second side; there are instances on both. */
static unsigned cheapest(const bins *s) {
    float above[BINS], best = PLT_BOX_FAR;
    plt_box box = plt_box_empty();
    uint32_t count = 0;
    unsigned split = 1;
    for (unsigned i = BINS; i-- > 1;) {
        plt_box_add(&box, &s->box[i]);
        count += s->count[i];
        above[i] = count > 0 ? (float)count * plt_box_half_area(&box) : PLT_BOX_FAR;
    }
    box = plt_box_empty();
    count = 0;
    for (unsigned i = 1; i < BINS; i++) {
        plt_box_add(&box, &s->box[i - 1]);
        count += s->count[i - 1];
        const float cost =
            count > 0 ? (float)count * plt_box_half_area(&box) + above[i] : PLT_BOX_FAR;
        if (cost < best) {
            best = cost;
            split = i;
        }
    }
    return split;
}

/* Brings those of bins below `split` to the front; returns where the others begin. */
static uint32_t partition(const builder *b, const range *r, const bins *s, unsigned split) {
    uint32_t begin = r->begin, end = r->end;
    while (begin < end) {
        if (bin_of(b, s, begin) < split) {
            begin++;
        } else {
            const uint32_t other = b->order[--end];
            b->order[end] = b->order[begin];
            b->order[begin] = other;
        }
    }
    return begin;
}

/* Both sides have one at least: the least centre is in the first bin, the greatest in the last. */
static uint32_t split(const builder *b, const range *r) {
    const uint32_t half = r->begin + (r->end - r->begin) / 2;
    bins s;
    if (r->level >= PLT_TOP_SPLIT_LEVELS || r->end - r->begin == 2) {
        return half;
    }
    choose_axis(b, r, &s);
    if (s.scale == 0.0f) {
        return half;
    }
    fill_bins(b, r, &s);
    const uint32_t middle = partition(b, r, &s, cheapest(&s));
    return middle > r->begin && middle < r->end ? middle : half;
}

/* ---- nodes ------------------------------------------------------------------------ */

/* A child of one instance is that; others begin at `node`, and wait there to be split. */
static uint32_t child(const builder *b, uint32_t begin, uint32_t end, uint32_t node,
                      uint32_t level) {
    if (end - begin == 1) {
        return PLT_TOP_LEAF | b->order[begin];
    }
    const range r = {begin, end, level};
    memcpy(&b->nodes[node], &r, sizeof r);
    return node;
}

/* Nodes are in depth-first order, so whatever waits is behind what is split. */
uint32_t plt_top_build(plt_top_node *nodes, uint32_t *order, const plt_placed *placed,
                       uint32_t count) {
    const builder b = {nodes, order, placed};
    for (uint32_t i = 0; i < count; i++) {
        order[i] = i;
    }
    const uint32_t root = child(&b, 0, count, 0, 0);
    for (uint32_t node = 0; node + 1 < count; node++) {
        plt_top_node *n = &nodes[node];
        range r;
        memcpy(&r, n, sizeof r);
        const uint32_t middle = split(&b, &r), right = node + middle - r.begin;
        n->box[0] = box_of(&b, r.begin, middle);
        n->box[1] = box_of(&b, middle, r.end);
        n->child[0] = child(&b, r.begin, middle, node + 1, r.level + 1);
        n->child[1] = child(&b, middle, r.end, right, r.level + 1);
    }
    return root;
}
