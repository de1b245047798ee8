/* level - see level.h
 *
 * A counting sort in two passes over the triangles' boxes. Between them counts become ends; the
 * second pass goes from the last item to the first and counts ends down, after which they are
 * starts: no second array, and the references of a cell lie in the order of the items.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/grid/level.h"

#include <string.h>

#include "engine/tree/record_rows.h"

#define SIDE_LEAST 8.67361738e-19f /* 2^-60: a shorter axis is one cell */
enum { BISECTIONS = 24 };

static uint32_t cells_along(float side, float size) {
    const float most = (float)PLT_GRID_CELLS_MOST;
    const float cells = side < SIDE_LEAST ? 1.0f : side / size;
    return cells >= most ? PLT_GRID_CELLS_MOST : cells > 1.0f ? (uint32_t)cells : 1u;
}

static float cells_of_size(const float side[3], float size) {
    return (float)cells_along(side[0], size) * (float)cells_along(side[1], size) *
           (float)cells_along(side[2], size);
}

/* The size of a cube, by halving between too small and large enough. */
static float cell_size(const float side[3], float longest, float wanted) {
    float small = longest / (float)PLT_GRID_CELLS_MOST, large = longest;
    if (cells_of_size(side, small) <= wanted) {
        return small;
    }
    for (int i = 0; i < BISECTIONS; i++) {
        const float size = 0.5f * (small + large);
        *(cells_of_size(side, size) <= wanted ? &large : &small) = size;
    }
    return large;
}

void plt_grid_level_set(plt_grid_level *l, const plt_box *box, float wanted) {
    float side[3];
    uint32_t stride = 1;
    memset(l, 0, sizeof *l);
    for (int a = 0; a < 3; a++) {
        side[a] = box->hi[a] - box->lo[a];
    }
    const float size = cell_size(side, plt_box_longest_side(box), wanted);
    for (int a = 0; a < 3; a++) {
        const uint32_t cells = cells_along(side[a], size);
        l->lo[a] = box->lo[a];
        l->cells[a] = cells;
        l->size[a] = side[a] / (float)cells;
        l->scale[a] = cells > 1 ? (float)cells / side[a] : 0.0f;
        l->last[a] = (float)(cells - 1);
        l->stride[a] = stride;
        stride *= cells;
    }
}

/* `single`: it is one cell. The fourth of each means nothing. */
typedef struct range {
    uint32_t from[4], to[4];
    int single;
} range;

#if PLT_LANES_REGISTERS

/* Of cells, in registers. */
typedef struct cells4 {
    f4 lo, scale, last;
} cells4;

static inline cells4 cells4_of(const plt_grid_level *l) {
    const cells4 c = {f4_load(l->lo), f4_load(l->scale), f4_load(l->last)};
    return c;
}

PLT_INLINED range range_of(const cells4 *c, const plt_record *record) {
    f4 corner[3];
    range r;
    plt_record_rows(record, corner);
    const f4 lo = f4_min(f4_min(corner[0], corner[1]), corner[2]);
    const f4 hi = f4_max(f4_max(corner[0], corner[1]), corner[2]);
    const u4 from = plt_grid_cell(lo, c->lo, c->scale, c->last);
    const u4 to = plt_grid_cell(hi, c->lo, c->scale, c->last);
    u4_store(r.from, from);
    u4_store(r.to, to);
    r.single = m4_mask(u4_eq(from, to)) == 15;
    return r;
}

#else /* the same, an axis at a time: four lanes of three are a third more */

typedef plt_grid_level cells4;

static inline cells4 cells4_of(const plt_grid_level *l) {
    return *l;
}

static inline uint32_t cell_at(const cells4 *c, int a, float at) {
    const float cell = (at - c->lo[a]) * c->scale[a];
    return (uint32_t)(int32_t)(cell > c->last[a] ? c->last[a] : cell > 0.0f ? cell : 0.0f);
}

PLT_INLINED range range_of(const cells4 *c, const plt_record *record) {
    range r;
    uint32_t others = 0;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const float p = plt_record_float(record, 0, a), q = plt_record_float(record, 1, a);
        const float s = plt_record_float(record, 2, a);
        const float lo = p < q ? p : q, hi = p < q ? q : p;
        r.from[a] = cell_at(c, a, s < lo ? s : lo);
        r.to[a] = cell_at(c, a, s > hi ? s : hi);
        others |= r.from[a] ^ r.to[a];
    }
    r.single = others == 0;
    return r;
}

#endif

PLT_INLINED const plt_record *item_at(const plt_grid_items *items, uint32_t i) {
    return &items->records[items->list != NULL ? items->list[i] : i];
}

uint64_t plt_grid_level_count(const plt_grid_level *l, const plt_grid_items *items, uint64_t most,
                              uint32_t every) {
    const cells4 c = cells4_of(l);
    const uint32_t row = l->stride[1], layer = l->stride[2];
    uint32_t *count = l->start;
    uint64_t sum = 0;
    memset(count, 0, ((size_t)plt_grid_cells(l) + 1) * sizeof *count);
    for (uint32_t i = 0; i < items->count && sum <= most; i += every) {
        const range r = range_of(&c, item_at(items, i));
        if (r.single) {
            count[r.from[2] * layer + r.from[1] * row + r.from[0]]++;
            sum++;
            continue;
        }
        sum += (uint64_t)(r.to[0] - r.from[0] + 1) * (r.to[1] - r.from[1] + 1) *
               (r.to[2] - r.from[2] + 1);
        for (uint32_t z = r.from[2]; z <= r.to[2]; z++) {
            for (uint32_t y = r.from[1]; y <= r.to[1]; y++) {
                uint32_t *const at = &count[z * layer + y * row];
                for (uint32_t x = r.from[0]; x <= r.to[0]; x++) {
                    at[x]++;
                }
            }
        }
    }
    return sum;
}

static void sum_up(const plt_grid_level *l) {
    const uint32_t cells = plt_grid_cells(l);
    uint32_t sum = 0;
    for (uint32_t i = 0; i < cells; i++) {
        sum += l->start[i];
        l->start[i] = sum;
    }
    l->start[cells] = sum;
}

void plt_grid_level_fill(const plt_grid_level *l, const plt_grid_items *items) {
    const cells4 c = cells4_of(l);
    const uint32_t row = l->stride[1], layer = l->stride[2];
    uint32_t *const end = l->start, *const reference = l->reference;
    sum_up(l);
    for (uint32_t i = items->count; i-- > 0;) {
        const range r = range_of(&c, item_at(items, i));
        const uint32_t item = items->list != NULL ? items->list[i] : i;
        if (r.single) {
            reference[--end[r.from[2] * layer + r.from[1] * row + r.from[0]]] = item;
            continue;
        }
        for (uint32_t z = r.from[2]; z <= r.to[2]; z++) {
            for (uint32_t y = r.from[1]; y <= r.to[1]; y++) {
                uint32_t *const at = &end[z * layer + y * row];
                for (uint32_t x = r.from[0]; x <= r.to[0]; x++) {
                    reference[--at[x]] = item;
                }
            }
        }
    }
}
