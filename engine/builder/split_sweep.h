/* split_sweep - the cheapest of all planes between rows, on three axes at once
 *
 * From the right, then from the left, over running unions; in lanes, lane a is axis a. A plane
 * costs half the area of each side's box times the weight of its items (item_weight() of the
 * instance, split_items.h). The first of equals wins, x before y before z.
 *
 * Included by split_items.h alone. SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_SPLIT_SWEEP_H
#define PLT_BUILDER_SPLIT_SWEEP_H

#ifdef items_split

/* A plane in front of row `row` of an axis. */
typedef struct split_choice {
    int axis; /* -1: no plane separates anything */
    uint32_t row;
    float cost;
} split_choice;

#if PLT_LANES_REGISTERS

/* Corners of three boxes and their counts, a lane for each axis. */
typedef struct split_sides {
    f4 lo[3], hi[3];
    u4 count;
} split_sides;

static split_sides split_no_sides(void) {
    const f4 far = f4_all(PLT_BOX_FAR), near = f4_all(-PLT_BOX_FAR);
    const split_sides s = {{far, far, far}, {near, near, near}, u4_all(0)};
    return s;
}

static inline void split_sides_add(split_sides *s, const plt_split_bins *bins, uint32_t k) {
    f4 x = f4_load(bins->lo[0][k]), y = f4_load(bins->lo[1][k]), z = f4_load(bins->lo[2][k]);
    f4 none = z;
    f4_transpose(&x, &y, &z, &none);
    s->lo[0] = f4_min(x, s->lo[0]);
    s->lo[1] = f4_min(y, s->lo[1]);
    s->lo[2] = f4_min(z, s->lo[2]);
    x = f4_load(bins->hi[0][k]);
    y = f4_load(bins->hi[1][k]);
    z = none = f4_load(bins->hi[2][k]);
    f4_transpose(&x, &y, &z, &none);
    s->hi[0] = f4_max(x, s->hi[0]);
    s->hi[1] = f4_max(y, s->hi[1]);
    s->hi[2] = f4_max(z, s->hi[2]);
    s->count = u4_add(s->count, u4_load(bins->count[k]));
}

static inline f4 split_sides_half_area(const split_sides *s) {
    const f4 x = f4_sub(s->hi[0], s->lo[0]), y = f4_sub(s->hi[1], s->lo[1]),
             z = f4_sub(s->hi[2], s->lo[2]);
    return f4_add(f4_add(f4_mul(x, y), f4_mul(y, z)), f4_mul(z, x));
}

static void split_sweep_right(const item_list *items, plt_split_bins *bins, uint32_t rows) {
    split_sides s = split_no_sides();
    for (uint32_t k = rows - 1; k > 0; k--) {
        split_sides_add(&s, bins, k);
        const f4 weight = item_weight(items, f4_of_u4(s.count));
        f4_store(bins->right_cost[k], f4_mul(split_sides_half_area(&s), weight));
    }
}

/* The least of three lanes, the first of equals. */
static split_choice split_least(f4 cost, u4 row) {
    float c[4];
    uint32_t r[4];
    split_choice best = {-1, 0, PLT_BOX_FAR};
    f4_store(c, cost);
    u4_store(r, row);
    for (int a = 0; a < 3; a++) {
        if (r[a] > 0 && c[a] < best.cost) {
            const split_choice better = {a, r[a], c[a]};
            best = better;
        }
    }
    return best;
}

static split_choice split_sweep(const item_list *items, plt_split_bins *bins, uint32_t rows,
                                uint32_t total) {
    split_sides s = split_no_sides();
    f4 best = f4_all(PLT_BOX_FAR);
    u4 best_row = u4_all(0);
    const f4 all = f4_of_u4(u4_all(total));
    split_sweep_right(items, bins, rows);
    for (uint32_t k = 1; k < rows; k++) {
        split_sides_add(&s, bins, k - 1);
        const f4 count = f4_of_u4(s.count);
        const f4 left = f4_mul(split_sides_half_area(&s), item_weight(items, count));
        f4 cost = f4_add(left, f4_load(bins->right_cost[k]));
        cost = item_penalty(items, cost, count, total);
        const m4 splits = m4_and(f4_lt(f4_zero(), count), f4_lt(count, all));
        const m4 better = m4_and(splits, f4_lt(cost, best));
        best = f4_select(better, cost, best);
        best_row = u4_select(better, u4_all(k), best_row);
    }
    return split_least(best, best_row);
}

#else

static void split_sweep_axis(const item_list *items, plt_split_bins *bins, int axis, uint32_t rows,
                             uint32_t total, split_choice *best) {
    plt_split_box box = plt_split_box_empty();
    const float all = (float)(int32_t)total;
    uint32_t count = 0;
    for (uint32_t k = rows - 1; k > 0; k--) {
        const plt_split_box row = plt_split_row(bins, axis, k);
        plt_split_box_add(&box, &row);
        count += bins->count[k][axis];
        const float weight = item_weight(items, (float)(int32_t)count);
        bins->right_cost[k][axis] = plt_box_half_area(&box) * weight;
    }
    box = plt_split_box_empty();
    count = 0;
    for (uint32_t k = 1; k < rows; k++) {
        const plt_split_box row = plt_split_row(bins, axis, k - 1);
        plt_split_box_add(&box, &row);
        count += bins->count[k - 1][axis];
        const float left = (float)(int32_t)count;
        const float mine = plt_box_half_area(&box) * item_weight(items, left);
        const float both = mine + bins->right_cost[k][axis];
        const float cost = item_penalty(items, both, left, total);
        if (0.0f < left && left < all && cost < best->cost) {
            const split_choice better = {axis, k, cost};
            *best = better;
        }
    }
}

static split_choice split_sweep(const item_list *items, plt_split_bins *bins, uint32_t rows,
                                uint32_t total) {
    split_choice best = {-1, 0, PLT_BOX_FAR};
    for (int a = 0; a < 3; a++) {
        split_sweep_axis(items, bins, a, rows, total, &best);
    }
    return best;
}

#endif

#endif
#endif
