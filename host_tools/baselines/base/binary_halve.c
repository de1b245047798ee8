/* binary_halve - see binary_halve.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/base/binary_halve.h"

#include "engine/planelet_config.h"

/* Within the record's box. */
static float centre_of(const plt_record *r, int axis) {
    const plt_box b = plt_record_box(r);
    return b.lo[axis] + 0.5f * (b.hi[axis] - b.lo[axis]);
}

static plt_box centres_of(const plt_record *records, uint32_t begin, uint32_t end) {
    plt_box all = plt_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const float at[3] = {centre_of(&records[i], 0), centre_of(&records[i], 1),
                             centre_of(&records[i], 2)};
        plt_box_add_point(&all, at);
    }
    return all;
}

/* The longest axis of those along which there is a float between both sides; below 0: none. */
static int axis_to_halve(const plt_box *cell, float *middle) {
    int best = -1;
    float longest = -1.0f;
    for (int a = 0; a < 3; a++) {
        const float side = cell->hi[a] - cell->lo[a], at = cell->lo[a] + 0.5f * side;
        if (cell->lo[a] < at && at < cell->hi[a] && side > longest) {
            longest = side;
            best = a;
            *middle = at;
        }
    }
    return best;
}

/* The axis of the plane at *middle that parts the centres; below 0: there is none. Each step makes
 * an axis shorter by a half, so that they are less than a thousand. */
static int find_plane(plt_box cell, const plt_box *centres, float *middle) {
    for (;;) {
        const int axis = axis_to_halve(&cell, middle);
        if (axis < 0 || (centres->lo[axis] < *middle && *middle <= centres->hi[axis])) {
            return axis;
        }
        if (centres->hi[axis] < *middle) {
            cell.hi[axis] = *middle;
        } else {
            cell.lo[axis] = *middle;
        }
    }
}

static uint32_t part(plt_record *records, uint32_t begin, uint32_t end, int axis, float middle) {
    uint32_t left = begin, right = end;
    while (left < right) {
        if (centre_of(&records[left], axis) < middle) {
            left++;
        } else {
            const plt_record r = records[left];
            records[left] = records[--right];
            records[right] = r;
        }
    }
    return left;
}

uint32_t binary_halve(plt_record_items *items, const plt_split_range *range, const plt_box *scene,
                      const plt_box *box, plt_box half[2]) {
    const uint32_t begin = range->begin, end = range->end;
    const plt_box centres = centres_of(items->records, begin, end);
    float middle = 0.0f;
    const int axis = find_plane(*scene, &centres, &middle);
    if (axis < 0 ||
        plt_levels_needed(end - begin, range->leaf_triangles) + range->depth >= PLT_DEPTH_MAX) {
        plt_split_range by_count = *range;
        by_count.depth = PLT_DEPTH_MAX;
        return plt_split_records(items, &by_count, box, half);
    }
    const uint32_t at = part(items->records, begin, end, axis, middle);
    half[0] = plt_records_box(items->records, begin, at);
    half[1] = plt_records_box(items->records, at, end);
    return at;
}
