/* near_grid - see near_grid.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/near_grid.h"
#include "host_tools/base/heap.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where a coordinate is this many distances or more from 0, the next float lies further away
 * than the distance: there only equal coordinates are near, and each is a cell of its own. */
static const double CELLS_MOST = 9007199254740992.0; /* 2^53 */

typedef struct cell {
    double q[3];   /* whole numbers below CELLS_MOST; or a coordinate itself */
    int around[3]; /* neighbours on either side that may hold a near point: 1, or 0 */
} cell;

static size_t slots_for(uint64_t most) {
    size_t slots = 64;
    while (slots < 2 * most && slots <= SIZE_MAX / 2) {
        slots *= 2;
    }
    return slots;
}

uint64_t near_grid_bytes(uint64_t most) {
    return 4 * (uint64_t)slots_for(most) + 8 * most + 3 * heap_cost(0);
}

int near_grid_begin(near_grid *g, const float *vertex, double distance, size_t most) {
    *g = (near_grid){.vertex = vertex, .distance = distance, .slots = slots_for(most)};
    g->first = heap_get_zeroed((uint64_t)g->slots * sizeof *g->first);
    g->next = heap_get((uint64_t)most * sizeof *g->next);
    g->point = heap_get((uint64_t)most * sizeof *g->point);
    return g->first == NULL || g->next == NULL || g->point == NULL ? -1 : 0;
}

void near_grid_free(near_grid *g) {
    heap_drop(g->first);
    heap_drop(g->next);
    heap_drop(g->point);
    *g = (near_grid){0};
}

static cell cell_of(const near_grid *g, uint32_t vertex) {
    cell c;
    for (int axis = 0; axis < 3; axis++) {
        const double x = (double)g->vertex[3 * (size_t)vertex + (size_t)axis];
        const double q = floor(x / g->distance); /* or infinite */
        c.around[axis] = fabs(q) < CELLS_MOST;
        c.q[axis] = c.around[axis] ? q : x;
    }
    return c;
}

static size_t slot_of(const near_grid *g, const cell *c) {
    uint64_t h = 0x9e3779b97f4a7c15u;
    for (int axis = 0; axis < 3; axis++) {
        const double q = c->q[axis] + 0.0; /* -0 is 0 */
        uint64_t bits;
        memcpy(&bits, &q, sizeof bits);
        h = (h ^ bits) * 0xd6e8feb86659fd93u;
        h ^= h >> 32;
    }
    return (size_t)h & (g->slots - 1);
}

void near_grid_add(near_grid *g, uint32_t vertex) {
    const cell c = cell_of(g, vertex);
    uint32_t *first = &g->first[slot_of(g, &c)];
    g->point[g->points] = vertex;
    g->next[g->points] = *first;
    *first = (uint32_t)++g->points;
}

static double distance_between(const near_grid *g, uint32_t a, uint32_t b) {
    double sum = 0;
    for (size_t axis = 0; axis < 3; axis++) {
        const double d =
            (double)g->vertex[3 * (size_t)a + axis] - (double)g->vertex[3 * (size_t)b + axis];
        sum += d * d;
    }
    return sqrt(sum);
}

typedef struct nearest {
    double far;
    uint32_t at; /* index of the point + 1; 0: none yet */
} nearest;

static void look_into(near_grid *g, const cell *c, uint32_t vertex, nearest *n) {
    for (uint32_t i = g->first[slot_of(g, c)]; i != 0; i = g->next[i - 1]) {
        const double d = distance_between(g, g->point[i - 1], vertex);
        g->steps++;
        const int is_nearer = n->at == 0 || d < n->far || (d == n->far && i < n->at);
        if (g->point[i - 1] != vertex && d <= g->distance && is_nearer) {
            *n = (nearest){d, i};
        }
    }
}

uint32_t near_grid_find(near_grid *g, uint32_t vertex, double *far) {
    const cell middle = cell_of(g, vertex);
    nearest n = {0, 0};
    for (int k = 0; k < 27; k++) {
        const int to[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        cell c = middle;
        int reached = 1;
        for (int axis = 0; axis < 3; axis++) {
            c.q[axis] += to[axis];
            reached &= abs(to[axis]) <= c.around[axis];
        }
        if (reached) {
            look_into(g, &c, vertex, &n);
        }
    }
    *far = n.far;
    return n.at != 0 ? g->point[n.at - 1] : NEAR_GRID_NONE;
}
