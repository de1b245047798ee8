/* lattice_snap - see lattice_snap.h; and what the move cost
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice_snap.h"

#include <math.h>

#include "engine/tree/canonical.h"
#include "host_tools/base/heap.h"
#include "host_tools/mesh/extent.h"
#include "host_tools/mesh/position_table.h"
#include "host_tools/pack/lattice_area.h"
#include "host_tools/pack/lattice_mend.h"

static lattice_position snap(const snapped *s, const float p[3]) {
    lattice_position r;
    for (int a = 0; a < 3; a++) {
        const uint32_t most = lattice_most(s, a);
        const double q = floor(lattice_steps(s, p, a) + 0.5);
        r.q[a] = q > (double)most ? most : (uint32_t)q;
    }
    return r;
}

/* The rotation (canonical.h) of these corners. */
static uint8_t rotation_of(const lattice_position p[3]) {
    const uint64_t a = plt_lattice_key(p[0].q), b = plt_lattice_key(p[1].q),
                   c = plt_lattice_key(p[2].q);
    return (uint8_t)plt_canonical_rotation(plt_canonical_first(b < a, c < a, c < b));
}

static void add_if_area(snapped *s, const mesh *m, const lattice_position *moved, size_t i) {
    lattice_position p[3];
    if (!mesh_counts(m, &s->mesh_box, i)) {
        s->loss.flat_before++;
        return;
    }
    for (size_t k = 0; k < 3; k++) {
        p[k] = moved[m->triangle[3 * i + k]];
    }
    if (!lattice_has_area(p)) {
        const int before = !mesh_has_area(m, i);
        s->loss.flat_before += (uint64_t)before;
        s->loss.flat_now += (uint64_t)!before;
        s->loss.t_junctions += (uint64_t)lattice_is_line(p);
        return;
    }
    s->rotation[s->count] = rotation_of(p);
    snapped_add(s, p, 3, (uint32_t)i);
}

/* Counts the positions of those vertices that have one on the lattice. */
static int count_different(const lattice_position *moved, size_t vertices, const void *positions,
                           uint64_t *different) {
    position_table t;
    *different = 0;
    if (position_table_begin(&t, positions, vertices) != 0) {
        return -1;
    }
    for (uint32_t i = 0; i < vertices; i++) {
        *different += moved[i].q[0] != LATTICE_UNUSED && position_table_first(&t, i) == i;
    }
    position_table_free(&t);
    return 0;
}

/* The square of how far a vertex moved: what is traced is the lattice coordinate's float. */
static double move_of(const snapped *s, const float p[3], const lattice_position *to) {
    double far2 = 0.0;
    for (int a = 0; a < 3; a++) {
        const double d = (double)p[a] - (double)plt_lattice_float(&s->lattice, a, to->q[a]);
        far2 += d * d;
    }
    return far2;
}

static int measure(snapped *s, const mesh *m, const lattice_position *moved) {
    double largest = 0.0;
    uint64_t before, after;
    for (size_t i = 0; i < m->vertices; i++) {
        if (moved[i].q[0] != LATTICE_UNUSED) {
            const double far2 = move_of(s, m->vertex + 3 * i, &moved[i]);
            largest = fmax(largest, far2);
            s->loss.unmoved += far2 == 0.0;
            s->loss.vertices++;
        }
    }
    s->loss.largest_move = largest > 0.0 ? sqrt(largest) / lattice_longest(&s->mesh_box) : 0.0;
    if (count_different(moved, m->vertices, m->vertex, &before) != 0 ||
        count_different(moved, m->vertices, moved, &after) != 0) {
        return -1;
    }
    s->loss.merged = before - after;
    return 0;
}

/* Where each vertex goes that a triangle uses which counts. */
static void snap_all(const snapped *s, const mesh *m, lattice_position *moved) {
    for (size_t i = 0; i < m->vertices; i++) {
        moved[i].q[0] = LATTICE_UNUSED;
    }
    for (size_t i = 0; i < m->triangles; i++) {
        for (size_t k = 0; k < 3 && (k > 0 || mesh_counts(m, &s->mesh_box, i)); k++) {
            const size_t vertex = m->triangle[3 * i + k];
            if (moved[vertex].q[0] == LATTICE_UNUSED) {
                moved[vertex] = snap(s, m->vertex + 3 * vertex);
            }
        }
    }
}

int lattice_snap_as(snapped *s, const mesh *m, const lattice_wish *wish, const char *name,
                    fail *f) {
    if (snapped_begin(s, m, wish, 0, name, f) != 0) {
        return -1;
    }
    lattice_position *moved = heap_get((uint64_t)m->vertices * sizeof *moved);
    int status = moved == NULL ? -1 : 0;
    if (status == 0) {
        snap_all(s, m, moved);
        status = lattice_mend(s, m, moved);
    }
    if (status == 0) {
        status = measure(s, m, moved);
    }
    if (status == 0) { /* only now: what mending and measuring take is free again */
        status = snapped_make_room(s, m->triangles, 3);
    }
    for (size_t i = 0; i < m->triangles && status == 0; i++) {
        add_if_area(s, m, moved, i);
    }
    heap_drop(moved);
    return status == 0 ? 0 : fail_set(f, name, "out of memory; pack on a larger machine");
}

int lattice_snap(snapped *s, const mesh *m, uint32_t bits, const char *name, fail *f) {
    const lattice_wish wish = {.bits = bits};
    return lattice_snap_as(s, m, &wish, name, f);
}
