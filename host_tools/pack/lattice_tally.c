/* lattice_tally - see lattice_tally.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice_tally.h"

#include <math.h>

#include "host_tools/base/heap.h"
#include "host_tools/mesh/extent.h"
#include "host_tools/pack/lattice_area.h"

static uint32_t corner(const lattice_moving *d, size_t triangle, size_t k) {
    return d->around.first[d->m->triangle[3 * triangle + k]];
}

enum lattice_state lattice_state_of(const lattice_moving *d, size_t triangle, uint32_t vertex,
                                    const lattice_position *to) {
    lattice_position p[3];
    for (size_t k = 0; k < 3; k++) {
        const uint32_t at = corner(d, triangle, k);
        p[k] = at == vertex ? *to : d->moved[at];
    }
    if (lattice_has_area(p)) {
        return LATTICE_AREA;
    }
    return lattice_is_line(p) && mesh_has_area(d->m, triangle) ? LATTICE_LINE : LATTICE_POINT;
}

void lattice_targets(const lattice_moving *d, uint32_t vertex, lattice_target target[8]) {
    for (unsigned c = 0; c < 8; c++) {
        lattice_target *t = &target[c];
        *t = (lattice_target){.far2 = 0.0};
        for (int a = 0; a < 3; a++) {
            const double x = lattice_steps(d->s, d->m->vertex + 3 * (size_t)vertex, a);
            const double q = floor(x) + (double)(c >> a & 1u);
            t->at.q[a] = (uint32_t)q;
            t->far2 =
                q <= (double)lattice_most(d->s, a) ? t->far2 + (x - q) * (x - q) : (double)INFINITY;
        }
    }
}

void lattice_target_add(const lattice_moving *d, uint32_t vertex, size_t triangle,
                        lattice_target *target, int times) {
    const enum lattice_state before = lattice_state_of(d, triangle, vertex, &d->moved[vertex]);
    const enum lattice_state after = lattice_state_of(d, triangle, vertex, &target->at);
    target->lost += times * (before == LATTICE_AREA && after != LATTICE_AREA);
    target->fewer += times * ((before == LATTICE_LINE) - (after == LATTICE_LINE));
}

static void add_to_tally(const lattice_moving *d, uint32_t vertex, size_t triangle, int times) {
    lattice_tally *t = &d->tally[d->tally_of[vertex] - 1];
    for (unsigned c = 0; c < 8; c++) {
        lattice_target_add(d, vertex, triangle, &t->target[c], times);
    }
}

static void count(const lattice_moving *d, uint32_t vertex) {
    lattice_targets(d, vertex, d->tally[d->tally_of[vertex] - 1].target);
    for (uint32_t i = d->around.begin[vertex]; i < d->around.begin[vertex + 1]; i++) {
        add_to_tally(d, vertex, d->around.triangle[i], 1);
    }
}

lattice_tally *lattice_tally_for(lattice_moving *d, uint32_t vertex) {
    if (d->tally_of[vertex] == 0) {
        if (d->tallies == d->tally_room) {
            const uint32_t room = 2 * d->tally_room + 16;
            lattice_tally *grown = heap_resize(d->tally, (uint64_t)room * sizeof *grown);
            if (grown == NULL) {
                return NULL;
            }
            d->tally = grown;
            d->tally_room = room;
        }
        d->tally[d->tallies].moves = 0;
        d->tally_of[vertex] = ++d->tallies;
        count(d, vertex);
    }
    return &d->tally[d->tally_of[vertex] - 1];
}

/* Adds what the triangles of a vertex contribute to the tallies of their other corners. */
static void add_to_others(const lattice_moving *d, uint32_t vertex, int times) {
    for (uint32_t i = d->around.begin[vertex]; i < d->around.begin[vertex + 1]; i++) {
        for (size_t k = 0; k < 3; k++) {
            const uint32_t other = corner(d, d->around.triangle[i], k);
            if (other != vertex && d->tally_of[other] != 0) {
                add_to_tally(d, other, d->around.triangle[i], times);
            }
        }
    }
}

void lattice_move_to(lattice_moving *d, uint32_t vertex, const lattice_position *to) {
    add_to_others(d, vertex, -1);
    d->moved[vertex] = *to;
    add_to_others(d, vertex, 1);
    if (d->tally_of[vertex] != 0) {
        d->tally[d->tally_of[vertex] - 1].moves++;
        count(d, vertex);
    }
}
