/* blocks_split - ranges of the permutation into two, in whole numbers
 *
 * The same heuristics as split_sah.c and split_median.c, over lattice boxes; the
 * surface area heuristic counts lists instead of triangles, which fills them
 * (fewer nodes, and pairs where they are free), and near the leaves prefers splits
 * that need no unit more.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks_state.h"
#include "engine/builder/levels.h"

#define UNIT_COST 1.03125f

typedef struct lattice_split {
    int axis; /* -1: none */
    uint32_t bin;
    float cost;
    uint32_t left;
    plt_lattice_box child[2];
} lattice_split;

/* Twice a centre to a bin: (centre2 - lo) * PLT_SAH_BINS / (extent + 1). */
typedef struct lattice_bins {
    uint32_t lo[3], span[3];
} lattice_bins;

static uint32_t centre2(const plt_lattice_box *b, int a) {
    return b->lo[a] + b->hi[a];
}

/* Within the bins also for a centre that has changed since they were laid out, as a
 * source that is read again may have it. */
static uint32_t bin_of(const lattice_bins *b, int a, uint32_t c2) {
    const uint32_t bin = (c2 - b->lo[a]) * PLT_SAH_BINS / b->span[a];
    return bin < PLT_SAH_BINS ? bin : PLT_SAH_BINS - 1;
}

static float half_area(const plt_lattice_box *b) {
    const float x = (float)(int32_t)(b->hi[0] - b->lo[0]);
    const float y = (float)(int32_t)(b->hi[1] - b->lo[1]);
    const float z = (float)(int32_t)(b->hi[2] - b->lo[2]);
    return x * y + y * z + z * x;
}

static float lists(const plt_blocks_state *s, uint32_t count) {
    const uint32_t k = s->job->leaf_triangles;
    return (float)(int32_t)((count + k - 1) / k);
}

/* Units that hold so many triangles, if they are full. */
static uint32_t units(const plt_blocks_state *s, uint32_t count) {
    const uint32_t most = 2 * s->job->leaf_triangles;
    return (count + most - 1) / most;
}

/* Sides that together need a unit more than the whole cost a 32nd more: it is a
 * node, whose bytes are worth a split that is nearly as good. Higher up, where
 * counts come from bins, what is left over is shared out further down. */
static float split_cost(const plt_blocks_state *s, const plt_lattice_box *left, uint32_t left_count,
                        const plt_lattice_box *right, uint32_t right_count) {
    const uint32_t total = left_count + right_count;
    const float cost =
        half_area(left) * lists(s, left_count) + half_area(right) * lists(s, right_count);
    const int spills = units(s, left_count) + units(s, right_count) > units(s, total);
    return spills && total <= PLT_SAH_BINS ? cost * UNIT_COST : cost;
}

static plt_lattice_box box_at(const plt_blocks_state *s, uint32_t i) {
    return plt_lattice_triangle_box(&s->job->triangles, plt_permuted(s, i));
}

static plt_lattice_box box_of(const plt_blocks_state *s, uint32_t begin, uint32_t end) {
    plt_lattice_box all = plt_lattice_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const plt_lattice_box b = box_at(s, i);
        plt_lattice_box_add(&all, &b);
    }
    return all;
}

static void exchange(plt_blocks_state *s, uint32_t i, uint32_t k) {
    const uint32_t t = plt_permuted(s, i);
    plt_permute(s, i, plt_permuted(s, k));
    plt_permute(s, k, t);
}

static lattice_bins fill_bins(plt_blocks_state *s, uint32_t begin, uint32_t end) {
    const plt_lattice_bin empty = {plt_lattice_box_empty(), 0};
    plt_lattice_box c = plt_lattice_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const plt_lattice_box b = box_at(s, i);
        const plt_lattice_box centre = {{centre2(&b, 0), centre2(&b, 1), centre2(&b, 2)},
                                        {centre2(&b, 0), centre2(&b, 1), centre2(&b, 2)}};
        plt_lattice_box_add(&c, &centre);
    }
    lattice_bins bins;
    for (int a = 0; a < 3; a++) {
        bins.lo[a] = c.lo[a];
        bins.span[a] = c.hi[a] - c.lo[a] + 1;
        for (int k = 0; k < PLT_SAH_BINS; k++) {
            s->bin[a][k] = empty;
        }
    }
    for (uint32_t i = begin; i < end; i++) {
        const plt_lattice_box b = box_at(s, i);
        for (int a = 0; a < 3; a++) {
            plt_lattice_bin *bin = &s->bin[a][bin_of(&bins, a, centre2(&b, a))];
            plt_lattice_box_add(&bin->box, &b);
            bin->count++;
        }
    }
    return bins;
}

static void sweep_axis(plt_blocks_state *s, int axis, uint32_t total, lattice_split *best) {
    const plt_lattice_bin *bin = s->bin[axis];
    plt_lattice_box box = plt_lattice_box_empty();
    uint32_t count = 0;
    for (uint32_t k = PLT_SAH_BINS - 1; k > 0; k--) {
        plt_lattice_box_add(&box, &bin[k].box);
        count += bin[k].count;
        s->right_box[k] = box;
        s->right_count[k] = count;
    }
    box = plt_lattice_box_empty();
    count = 0;
    for (uint32_t k = 1; k < PLT_SAH_BINS; k++) {
        plt_lattice_box_add(&box, &bin[k - 1].box);
        count += bin[k - 1].count;
        if (count == 0 || count == total || bin[k - 1].count == 0) {
            continue;
        }
        const float cost = split_cost(s, &box, count, &s->right_box[k], s->right_count[k]);
        if (best->axis < 0 || cost < best->cost) {
            const lattice_split better = {axis, k, cost, count, {box, s->right_box[k]}};
            *best = better;
        }
    }
}

/* Ranks of the range's boxes along an axis, by insertion; of equals the first. */
static void rank_boxes(plt_blocks_state *s, int axis, uint32_t count) {
    uint8_t *rank = s->few_rank[axis];
    for (uint32_t i = 0; i < count; i++) {
        uint32_t k = i;
        const uint32_t c = centre2(&s->few_box[i], axis);
        for (; k > 0 && centre2(&s->few_box[rank[k - 1]], axis) > c; k--) {
            rank[k] = rank[k - 1];
        }
        rank[k] = (uint8_t)i;
    }
    for (uint32_t k = 0; k < PLT_SAH_BINS; k++) {
        s->bin[axis][k].count = k < count;
        s->bin[axis][k].box = k < count ? s->few_box[rank[k]] : plt_lattice_box_empty();
    }
}

/* No more triangles than bins: each is a bin of its own, in order, and every
 * split there is gets its cost. */
static uint32_t split_few(plt_blocks_state *s, uint32_t begin, uint32_t count,
                          plt_lattice_box child[2]) {
    lattice_split best = {-1, 0, 0.0f, 0, {{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}};
    for (uint32_t i = 0; i < count; i++) {
        s->few[i] = plt_permuted(s, begin + i);
        s->few_box[i] = plt_lattice_triangle_box(&s->job->triangles, s->few[i]);
    }
    for (int a = 0; a < 3; a++) {
        rank_boxes(s, a, count);
        sweep_axis(s, a, count, &best);
    }
    for (uint32_t i = 0; i < count; i++) {
        plt_permute(s, begin + i, s->few[s->few_rank[best.axis][i]]);
    }
    child[0] = best.child[0];
    child[1] = best.child[1];
    return begin + best.left;
}

static uint32_t split_sah(plt_blocks_state *s, uint32_t begin, uint32_t end,
                          plt_lattice_box child[2]) {
    const lattice_bins bins = fill_bins(s, begin, end);
    lattice_split best = {-1, 0, 0.0f, 0, {{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}};
    for (int a = 0; a < 3; a++) {
        sweep_axis(s, a, end - begin, &best);
    }
    if (best.axis < 0) {
        return begin;
    }
    const uint32_t middle = begin + best.left;
    for (uint32_t last = end; begin < last;) {
        const plt_lattice_box b = box_at(s, begin);
        if (bin_of(&bins, best.axis, centre2(&b, best.axis)) < best.bin) {
            begin++;
        } else {
            exchange(s, begin, --last);
        }
    }
    child[0] = best.child[0];
    child[1] = best.child[1];
    return middle;
}

static uint32_t split_median(plt_blocks_state *s, const plt_block_range *range) {
    uint32_t begin = range->first, end = range->first + range->count;
    int axis = 0;
    for (int a = 1; a < 3; a++) {
        const uint32_t extent = range->tight.hi[a] - range->tight.lo[a];
        axis = extent > range->tight.hi[axis] - range->tight.lo[axis] ? a : axis;
    }
    const uint32_t middle2 = centre2(&range->tight, axis);
    while (begin < end) {
        const plt_lattice_box b = box_at(s, begin);
        if (centre2(&b, axis) < middle2) {
            begin++;
        } else {
            exchange(s, begin, --end);
        }
    }
    return begin;
}

uint32_t plt_blocks_split(plt_blocks_state *s, const plt_block_range *range,
                          plt_lattice_box child[2]) {
    const uint32_t begin = range->first, end = range->first + range->count;
    uint32_t middle = begin;
    if (plt_levels_needed(range->count, s->job->leaf_triangles) + range->depth < PLT_DEPTH_MAX) {
        if (s->job->splits == PLT_SPLIT_SAH) {
            middle = range->count <= PLT_SAH_BINS ? split_few(s, begin, range->count, child)
                                                  : split_sah(s, begin, end, child);
        } else {
            middle = split_median(s, range);
            if (middle != begin && middle != end) {
                child[0] = box_of(s, begin, middle);
                child[1] = box_of(s, middle, end);
            }
        }
    }
    if (middle == begin || middle == end) {
        middle = begin + range->count / 2;
        child[0] = box_of(s, begin, middle);
        child[1] = box_of(s, middle, end);
    }
    return middle;
}
