/* split_sah - the binned surface area heuristic
 *
 * Triangles are counted into bins by the centres of their boxes on all three
 * axes in one pass; the cheapest of the 3 * (bins - 1) planes wins, the first
 * of equals. Cost of a side: half the area of its box * its triangles.
 *
 * Source: Wald, "On fast construction of SAH-based bounding volume
 * hierarchies", 2007; thesis, section 6.4.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/split.h"

/* From twice a centre to a bin: bin = (centre2 - lo) * scale. */
typedef struct binning {
    float lo[3], scale[3];
} binning;

typedef struct candidate {
    float cost;
    int axis; /* -1: none */
    int bin;  /* first bin of the right side */
    plt_split split;
} candidate;

static int bin_of(const binning *b, int axis, float centre2) {
    const int bin = (int)((centre2 - b->lo[axis]) * b->scale[axis]);
    return bin < PLT_SAH_BINS ? bin : PLT_SAH_BINS - 1;
}

static binning centre_bounds(const plt_split_range *range) {
    plt_box c = plt_box_empty();
    for (uint32_t i = range->begin; i < range->end; i++) {
        float centre2[3];
        for (int a = 0; a < 3; a++) {
            centre2[a] = plt_centre2(&range->records[i], a);
        }
        plt_box_add_point(&c, centre2);
    }
    binning b;
    for (int a = 0; a < 3; a++) {
        const float extent = c.hi[a] - c.lo[a];
        const float scale = (float)PLT_SAH_BINS / extent;
        b.lo[a] = c.lo[a];
        b.scale[a] = extent > 0.0f && scale < PLT_BOX_FAR ? scale : 0.0f;
    }
    return b;
}

static void fill_bins(const plt_split_range *range, const binning *b, plt_sah_bins *bins) {
    const plt_sah_bin empty = {plt_box_empty(), 0};
    for (int a = 0; a < 3; a++) {
        for (int k = 0; k < PLT_SAH_BINS; k++) {
            bins->bin[a][k] = empty;
        }
    }
    for (uint32_t i = range->begin; i < range->end; i++) {
        const plt_box box = plt_record_box(&range->records[i]);
        for (int a = 0; a < 3; a++) {
            plt_sah_bin *bin = &bins->bin[a][bin_of(b, a, box.lo[a] + box.hi[a])];
            plt_box_add(&bin->box, &box);
            bin->count++;
        }
    }
}

/* Sweeps an axis from the right, then from the left, over running unions. */
static void sweep_axis(plt_sah_bins *bins, int axis, uint32_t begin, uint32_t end,
                       candidate *best) {
    const plt_sah_bin *bin = bins->bin[axis];
    plt_box box = plt_box_empty();
    uint32_t count = 0;
    for (int k = PLT_SAH_BINS - 1; k > 0; k--) {
        plt_box_add(&box, &bin[k].box);
        count += bin[k].count;
        bins->right_box[k] = box;
        bins->right_cost[k] = count > 0 ? plt_box_half_area(&box) * (float)count : 0.0f;
    }
    box = plt_box_empty();
    count = 0;
    for (int k = 1; k < PLT_SAH_BINS; k++) {
        plt_box_add(&box, &bin[k - 1].box);
        count += bin[k - 1].count;
        if (count == 0 || count == end - begin) {
            continue;
        }
        const float cost = plt_box_half_area(&box) * (float)count + bins->right_cost[k];
        if (best->axis < 0 || cost < best->cost) {
            const plt_split split = {begin + count, {box, bins->right_box[k]}};
            const candidate better = {cost, axis, k, split};
            *best = better;
        }
    }
}

static void partition_bins(const plt_split_range *range, const binning *b, const candidate *best) {
    uint32_t begin = range->begin, end = range->end;
    while (begin < end) {
        const float centre2 = plt_centre2(&range->records[begin], best->axis);
        if (bin_of(b, best->axis, centre2) < best->bin) {
            begin++;
        } else {
            plt_record_swap(&range->records[begin], &range->records[--end]);
        }
    }
}

void plt_split_sah(const plt_split_range *range, plt_sah_bins *bins, plt_split *split) {
    const binning b = centre_bounds(range);
    fill_bins(range, &b, bins);
    candidate best = {0.0f, -1, 0, {0, {plt_box_empty(), plt_box_empty()}}};
    for (int a = 0; a < 3; a++) {
        sweep_axis(bins, a, range->begin, range->end, &best);
    }
    if (best.axis < 0) {
        plt_split_halves(range, split);
    } else {
        partition_bins(range, &b, &best);
        *split = best.split;
    }
}
