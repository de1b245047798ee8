/* build - see build.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/grid/build.h"

#include "engine/grid/crowded.h"
#include "engine/grid/level.h"
#include "engine/grid/macro.h"

/* Starts have 32 bits. A grid of one cell has fewer, 2^27 at most. */
#define REFERENCES_MOST 0xFFFFFFFFu

static size_t rounded(size_t bytes) {
    return (bytes + PLT_ALIGN - 1) & ~(size_t)(PLT_ALIGN - 1);
}

/* Of the grid, its starts, rectangles and macro cells. */
static size_t front_bytes(const plt_grid_level *l) {
    const uint64_t starts = 4 * ((uint64_t)plt_grid_cells(l) + 1);
    const uint64_t rects =
        sizeof(plt_grid_rect) * ((uint64_t)l->cells[0] + l->cells[1] + l->cells[2]);
    return rounded(sizeof(plt_grid)) + rounded((size_t)starts) + rounded((size_t)rects) +
           rounded(plt_grid_macro_bytes(l));
}

static uint64_t bytes_for(uint64_t per_triangle, uint32_t triangles) {
    const plt_grid_level one = {.cells = {1, 1, 1, 0}};
    const uint64_t bytes = front_bytes(&one) + per_triangle * triangles;
    return (bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN;
}

uint64_t plt_grid_least_bytes(uint32_t triangles) {
    return bytes_for(4, triangles);
}

uint64_t plt_grid_usual_bytes(uint32_t triangles) {
    return bytes_for(4 + PLT_GRID_TRIANGLE_BYTES, triangles);
}

/* Where all lies behind the grid; its references begin behind the result. */
static size_t lay_out(plt_grid *g) {
    unsigned char *const base = (unsigned char *)g;
    const plt_grid_level *top = &g->top;
    const size_t starts = ((size_t)plt_grid_cells(top) + 1) * 4;
    size_t at = rounded(sizeof *g);
    g->top.start = (uint32_t *)(void *)(base + at);
    at += rounded(starts);
    for (int a = 0; a < 3; a++) {
        g->rect[a] = (plt_grid_rect *)(void *)(base + at);
        at += top->cells[a] * sizeof(plt_grid_rect);
    }
    at = rounded(at);
    plt_grid_macro_begin(g, base + at);
    at += rounded(plt_grid_macro_bytes(top));
    g->top.reference = (uint32_t *)(void *)(base + at);
    return at;
}

/* As many cells as are wanted, or as there is room for. */
static size_t choose_cells(plt_grid *g, const plt_grid_job *job, const plt_grid_items *items) {
    float wanted = job->density * (float)job->count;
    for (;; wanted *= 0.5f) {
        plt_grid_level_set(&g->top, job->box, wanted);
        const plt_grid_level *top = &g->top;
        const size_t front = front_bytes(top);
        if (front > job->bytes || (job->bytes - front) / 4 < job->count) {
            continue; /* of one cell, which has each once, it is not */
        }
        const uint64_t fit = (job->bytes - front) / 4;
        const uint64_t most = fit < REFERENCES_MOST ? fit : REFERENCES_MOST;
        lay_out(g);
        const uint64_t references = plt_grid_level_count(top, items, most, 1);
        if (references <= most) {
            g->references = (uint32_t)references;
            return front + 4 * (size_t)references;
        }
    }
}

static inline void take(plt_grid_rect *r, uint32_t x, uint32_t y) {
    r->lo[0] = (uint16_t)(x < r->lo[0] ? x : r->lo[0]);
    r->hi[0] = (uint16_t)(x > r->hi[0] ? x : r->hi[0]);
    r->lo[1] = (uint16_t)(y < r->lo[1] ? y : r->lo[1]);
    r->hi[1] = (uint16_t)(y > r->hi[1] ? y : r->hi[1]);
}

/* The occupied cells of row y, z. */
static void take_row(const plt_grid *g, const uint32_t *start, uint32_t y, uint32_t z) {
    const uint32_t cells = g->top.cells[0];
    uint32_t first = cells, last = 0;
    for (uint32_t x = 0; x < cells; x++) {
        if (start[x] != start[x + 1]) {
            first = x < first ? x : first;
            last = x;
            take(&g->rect[0][x], y, z);
            plt_grid_macro_add(g, x, y, z);
        }
    }
    if (first < cells) {
        take(&g->rect[1][y], z, first);
        take(&g->rect[1][y], z, last);
        take(&g->rect[2][z], first, y);
        take(&g->rect[2][z], last, y);
    }
}

static void set_rects(const plt_grid *g) {
    static const plt_grid_rect none = {{UINT16_MAX, UINT16_MAX}, {0, 0}};
    const plt_grid_level *top = &g->top;
    for (int a = 0; a < 3; a++) {
        for (uint32_t i = 0; i < top->cells[a]; i++) {
            g->rect[a][i] = none;
        }
    }
    for (uint32_t z = 0; z < top->cells[2]; z++) {
        for (uint32_t y = 0; y < top->cells[1]; y++) {
            const uint32_t first = z * top->stride[2] + y * top->stride[1];
            if (top->start[first] != top->start[first + top->cells[0]]) {
                take_row(g, &top->start[first], y, z);
            }
        }
    }
}

const plt_grid *plt_grid_build(const plt_grid_job *job) {
    plt_grid *g = job->room;
    const plt_grid_items items = {job->records, NULL, job->count};
    const size_t used = rounded(choose_cells(g, job, &items));
    plt_grid_level_fill(&g->top, &items);
    set_rects(g);
    g->bytes = used;
    g->crowded_count = 0;
    g->crowded = NULL;
    if (!job->is_plain) {
        plt_grid_refine(g, job->records, job->count, job->bytes);
    }
    return g;
}
