/* split_median - the thesis's spatial median, and halves by number
 *
 * Source: Karrenberg 2007, section 5.1 (the BVH that the BPH is made from).
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/split.h"

#define ROUNDS_MOST 64

static void boxes_of_halves(const plt_split_range *range, plt_split *split) {
    split->child[0] = plt_records_box(range->records, range->begin, split->middle);
    split->child[1] = plt_records_box(range->records, split->middle, range->end);
}

/* Everything below `limit2` (twice a coordinate) goes left; returns the first of the right. */
static uint32_t partition_below(plt_record *records, uint32_t begin, uint32_t end, int axis,
                                float limit2) {
    while (begin < end) {
        if (plt_centre2(&records[begin], axis) < limit2) {
            begin++;
        } else {
            plt_record_swap(&records[begin], &records[--end]);
        }
    }
    return begin;
}

void plt_split_median(const plt_split_range *range, plt_split *split) {
    const int axis = plt_longest_axis(&range->box);
    const float middle2 = range->box.lo[axis] + range->box.hi[axis];
    split->middle = partition_below(range->records, range->begin, range->end, axis, middle2);
    if (split->middle == range->begin || split->middle == range->end) {
        plt_split_halves(range, split);
    } else {
        boxes_of_halves(range, split);
    }
}

/* One round of quickselect over [begin, end): the pivot's place after
 * everything below it; `*above` is where those greater than it begin. */
static uint32_t partition_three(plt_record *records, uint32_t begin, uint32_t end, int axis,
                                uint32_t *above) {
    const float pivot = plt_centre2(&records[begin + (end - begin) / 2], axis);
    uint32_t below = begin, at = begin;
    while (at < end) {
        const float centre = plt_centre2(&records[at], axis);
        if (centre < pivot) {
            plt_record_swap(&records[at++], &records[below++]);
        } else if (centre > pivot) {
            plt_record_swap(&records[at], &records[--end]);
        } else {
            at++;
        }
    }
    *above = end;
    return below;
}

void plt_split_halves(const plt_split_range *range, plt_split *split) {
    const int axis = plt_longest_axis(&range->box);
    uint32_t begin = range->begin, end = range->end;
    split->middle = begin + (end - begin) / 2;
    /* An order made to be slow stops being sorted: halves they are all the same. */
    for (int round = 0; end - begin > 1 && round < ROUNDS_MOST; round++) {
        uint32_t above;
        const uint32_t below = partition_three(range->records, begin, end, axis, &above);
        if (split->middle < below) {
            end = below;
        } else if (split->middle >= above) {
            begin = above;
        } else {
            break;
        }
    }
    boxes_of_halves(range, split);
}
