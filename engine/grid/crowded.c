/* crowded - see crowded.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/grid/crowded.h"

#include <string.h>

#include "engine/grid/level.h"

enum {
    CROWDED_LEAST = 256, /* references; and a sixteenth of all triangles, */
    CROWDED_SURE = 2048, /* or so many */
    CROWDED_MOST = 64,   /* cells */
    SHARES_MOST = 16,    /* references of a level per item: else it has fewer cells; */
    ASKED = 8            /* as one item in so many says, or else all do */
};
#define CROWDED_DENSITY 8.0f /* cells per item */
#define GROWN 1.0e-3f        /* of a cell, and ... */
#define GROWN_FAR 2.4e-7f    /* 4 u of the coordinates: the level's box is larger by that */

static size_t rounded(size_t bytes) {
    return (bytes + PLT_ALIGN - 1) & ~(size_t)(PLT_ALIGN - 1);
}

static uint32_t count_above(const plt_grid_level *top, uint32_t least) {
    const uint32_t cells = plt_grid_cells(top);
    uint32_t count = 0;
    for (uint32_t i = 0; i < cells; i++) {
        count += top->start[i + 1] - top->start[i] > least;
    }
    return count;
}

/* How many references make a cell crowded, so that few are; 0: none is. */
static uint32_t crowded_above(const plt_grid_level *top, uint32_t triangles) {
    const uint32_t share = triangles / 16 < CROWDED_SURE ? triangles / 16 : CROWDED_SURE;
    uint32_t least = share > CROWDED_LEAST ? share : CROWDED_LEAST, count;
    while ((count = count_above(top, least)) > CROWDED_MOST) {
        least *= 2;
    }
    return count > 0 ? least : 0;
}

static plt_box box_of_items(const plt_grid_items *items) {
    plt_box box = plt_box_empty();
    for (uint32_t i = 0; i < items->count; i++) {
        const plt_box b = plt_record_box(&items->records[items->list[i]]);
        plt_box_add(&box, &b);
    }
    return box;
}

/* What of the items' box lies in the cell, grown by more than what both may be off. */
static plt_box box_in_cell(const plt_grid_level *top, uint32_t cell, const plt_grid_items *items) {
    plt_box box = box_of_items(items);
    for (int a = 0; a < 3; a++) {
        const uint32_t at = cell / top->stride[a] % top->cells[a];
        const float lo = top->lo[a] + (float)at * top->size[a], hi = lo + top->size[a];
        const float far =
            __builtin_fabsf(lo) > __builtin_fabsf(hi) ? __builtin_fabsf(lo) : __builtin_fabsf(hi);
        const float grown = GROWN * top->size[a] + GROWN_FAR * far;
        box.lo[a] = at > 0 && lo - grown > box.lo[a] ? lo - grown : box.lo[a];
        box.hi[a] = at + 1 < top->cells[a] && hi + grown < box.hi[a] ? hi + grown : box.hi[a];
    }
    return box;
}

/* Cells of the level, counted; 0: it is not worth it, or there is no room. */
static uint64_t choose_cells(plt_grid_level *l, const plt_grid_items *items, const plt_box *box,
                             unsigned char *room, size_t bytes) {
    for (float wanted = CROWDED_DENSITY * (float)items->count; wanted >= 8.0f; wanted *= 0.5f) {
        plt_grid_level_set(l, box, wanted);
        const size_t starts = rounded(((size_t)plt_grid_cells(l) + 1) * 4);
        if (starts > bytes) {
            continue;
        }
        const uint64_t room_for = (bytes - starts) / 4,
                       shares = SHARES_MOST * (uint64_t)items->count;
        const uint64_t most = room_for < shares ? room_for : shares;
        l->start = (uint32_t *)(void *)room;
        l->reference = (uint32_t *)(void *)(room + starts);
        if (plt_grid_level_count(l, items, most / ASKED, ASKED) > most / ASKED) {
            continue;
        }
        const uint64_t references = plt_grid_level_count(l, items, most, 1);
        if (references <= most) {
            return references;
        }
    }
    return 0;
}

/* 0: the cell stays as it is. */
static int refine_cell(plt_grid *g, const plt_record *records, uint32_t cell, size_t bytes) {
    const uint32_t first = g->top.start[cell];
    const plt_grid_items items = {records, &g->top.reference[first],
                                  g->top.start[cell + 1] - first};
    const plt_box box = box_in_cell(&g->top, cell, &items);
    plt_grid_level *l = &g->crowded[g->crowded_count];
    const uint64_t references =
        choose_cells(l, &items, &box, (unsigned char *)g + g->bytes, bytes - g->bytes);
    if (references == 0) {
        return 0;
    }
    plt_grid_level_fill(l, &items);
    g->bytes += rounded(((size_t)plt_grid_cells(l) + 1) * 4) + rounded((size_t)references * 4);
    g->top.reference[first] = PLT_GRID_CROWDED | g->crowded_count;
    g->top.reference[first + 1] = items.count;
    g->crowded_count++;
    return 1;
}

void plt_grid_refine(plt_grid *g, const plt_record *records, uint32_t count, size_t bytes) {
    const uint32_t cells = plt_grid_cells(&g->top), least = crowded_above(&g->top, count);
    const size_t levels = least > 0 ? count_above(&g->top, least) * sizeof(plt_grid_level) : 0;
    if (least == 0 || levels > bytes - g->bytes) {
        return;
    }
    g->crowded = (plt_grid_level *)(void *)((unsigned char *)g + g->bytes);
    g->bytes += rounded(levels);
    for (uint32_t i = 0; i < cells; i++) {
        if (g->top.start[i + 1] - g->top.start[i] > least) {
            refine_cell(g, records, i, bytes);
        }
    }
}
