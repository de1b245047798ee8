/* split_steps - a range that is split in steps, for as much of a frame as there is
 *
 * The same passes over the same items as items_split makes, so the same split. Each pass goes on
 * where it stopped; what is between passes, a sweep over the bins, does not depend on the items.
 *
 * Included by split_items.h alone. SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_SPLIT_STEPS_H
#define PLT_BUILDER_SPLIT_STEPS_H

#ifdef items_split_some

static uint32_t split_take(uint32_t most, uint32_t *left) {
    const uint32_t taken = most < *left ? most : *left;
    *left -= taken;
    return taken;
}

static void split_to(plt_split_job *job, uint8_t phase) {
    job->phase = phase;
    job->at = job->range.begin;
    job->seen[0] = job->seen[1] = plt_split_box_empty();
}

static void split_to_halves(plt_split_job *job) {
    const plt_split_range *r = &job->range;
    split_to(job, PLT_SPLITTING_HALVES);
    job->middle = r->begin + (r->end - r->begin) / 2;
    job->sides.begin = r->begin;
    job->sides.end = r->end;
    job->rounds = 0;
    job->is_in_round = 0;
}

static void split_points_some(item_list *items, plt_split_job *job, uint32_t *left) {
    const uint32_t end = job->range.end;
    const uint32_t most = (end - job->at - 1) / job->step + 1;
    const uint32_t taken = split_take(most, left);
    const uint32_t until = taken == most ? end : job->at + taken * job->step;
    split_add_points(items, job->at, until, job->step, &job->seen[0]);
    job->at = until;
    if (until == end) {
        job->grid = split_grid_of(&job->seen[0], end - job->range.begin);
        split_empty_bins(items_bins(items), job->grid.bins);
        split_to(job, PLT_SPLITTING_BINS);
    }
}

/* With the bins of few, no plane may be seen where there is one. */
static void split_bins_some(item_list *items, plt_split_job *job, uint32_t *left) {
    const uint32_t begin = job->range.begin, end = job->range.end;
    const uint32_t until = job->at + split_take(end - job->at, left);
    split_fill_bins(items, job->at, until, &job->grid);
    job->at = until;
    if (until < end) {
        return;
    }
    if (split_choose(items, &job->grid, end - begin, &job->plane, job->child)) {
        const plt_split_sides all = {.begin = begin, .end = end};
        job->sides = all;
        split_to(job, PLT_SPLITTING_SIDES);
    } else if (job->step > 1) {
        job->step = 1;
        split_to(job, PLT_SPLITTING_POINTS);
    } else {
        split_to_halves(job);
    }
}

static void split_sides_some(item_list *items, plt_split_job *job, uint32_t *left) {
    plt_split_sides *s = &job->sides;
    const uint32_t had = s->end - s->begin, taken = split_take(had, left);
    split_partition_blocks(items, s, &job->plane, had - taken);
    if (s->end - s->begin < 2 * PLT_SPLIT_BLOCK) {
        job->middle = split_partition_rest(items, s->begin, s->end, &job->plane);
        job->phase = PLT_SPLITTING_DONE;
    }
}

static void split_median_some(item_list *items, plt_split_job *job, uint32_t *left) {
    const int axis = split_longest_axis(&job->box);
    const item_coordinate middle2 = job->box.lo[axis] + job->box.hi[axis];
    uint32_t begin = job->sides.begin, end = job->sides.end;
    for (uint32_t taken = split_take(end - begin, left); taken > 0; taken--) {
        if (item_centre2_at(items, begin, axis) < middle2) {
            begin++;
        } else {
            items_swap(items, begin, --end);
        }
    }
    job->sides.begin = begin;
    job->sides.end = end;
    if (begin < end) {
        return;
    }
    if (begin == job->range.begin || begin == job->range.end) {
        split_to_halves(job);
    } else {
        split_to(job, PLT_SPLITTING_BOXES);
        job->middle = begin;
    }
}

/* Of a round, the items that are not yet below the pivot, equal or above. */
static void split_round_some(item_list *items, plt_split_job *job, int axis, uint32_t *left) {
    for (uint32_t taken = split_take(job->above - job->at, left); taken > 0; taken--) {
        const item_coordinate centre2 = item_centre2_at(items, job->at, axis);
        if (centre2 < job->pivot) {
            items_swap(items, job->at++, job->below++);
        } else if (centre2 > job->pivot) {
            items_swap(items, job->at, --job->above);
        } else {
            job->at++;
        }
    }
}

/* split_select. */
static void split_halves_some(item_list *items, plt_split_job *job, uint32_t *left) {
    const int axis = split_longest_axis(&job->box);
    uint32_t *begin = &job->sides.begin, *end = &job->sides.end;
    if (!job->is_in_round && *end - *begin > 1 && job->rounds < 64) {
        job->pivot = item_centre2_at(items, *begin + (*end - *begin) / 2, axis);
        job->at = job->below = *begin;
        job->above = *end;
        job->is_in_round = 1;
        job->rounds++;
    }
    split_round_some(items, job, axis, left);
    if (job->is_in_round && job->at < job->above) {
        return;
    }
    const int is_below = job->middle < job->below, is_above = job->middle >= job->above;
    if (job->is_in_round && (is_below || is_above)) {
        *end = is_below ? job->below : *end;
        *begin = is_below ? *begin : job->above;
        job->is_in_round = 0;
        return;
    }
    split_to(job, PLT_SPLITTING_BOXES);
}

static void split_boxes_some(item_list *items, plt_split_job *job, uint32_t *left) {
    const uint32_t end = job->range.end;
    const uint32_t until = job->at + split_take(end - job->at, left);
    for (uint32_t i = job->at; i < until; i++) {
        const plt_split_box b = item_box_at(items, i);
        plt_split_box_add(&job->seen[i >= job->middle], &b);
    }
    job->at = until;
    if (until == end) {
        job->child[0] = item_box_from(&job->seen[0]);
        job->child[1] = item_box_from(&job->seen[1]);
        job->phase = PLT_SPLITTING_DONE;
    }
}

void items_split_begin(plt_split_job *job) {
    const plt_split_range *r = &job->range;
    const uint32_t count = r->end - r->begin;
    if (plt_levels_needed(count, r->leaf_triangles) + r->depth >= PLT_DEPTH_MAX) {
        split_to_halves(job);
        return;
    }
    job->step = split_sample_step(count);
    job->sides.begin = r->begin;
    job->sides.end = r->end;
    split_to(job, r->splits == PLT_SPLIT_MEDIAN ? PLT_SPLITTING_MEDIAN : PLT_SPLITTING_POINTS);
}

int items_split_some(item_list *items, plt_split_job *job, uint32_t *left) {
    while (*left > 0 && job->phase != PLT_SPLITTING_DONE) {
        switch (job->phase) {
        case PLT_SPLITTING_POINTS:
            split_points_some(items, job, left);
            break;
        case PLT_SPLITTING_BINS:
            split_bins_some(items, job, left);
            break;
        case PLT_SPLITTING_SIDES:
            split_sides_some(items, job, left);
            break;
        case PLT_SPLITTING_MEDIAN:
            split_median_some(items, job, left);
            break;
        case PLT_SPLITTING_HALVES:
            split_halves_some(items, job, left);
            break;
        default:
            split_boxes_some(items, job, left);
            break;
        }
    }
    return job->phase == PLT_SPLITTING_DONE ? PLT_OK : PLT_MORE;
}

#endif
#endif
