/* lattice_mend - slivers that the lattice has made lines of get an area again
 *
 * A sliver whose corners fall on one line is dropped, and leaves its middle corner
 * on the long edge of its neighbour: a T-junction, through which a ray may slip.
 * Instead one of its corners moves to another of the eight grid points around it,
 * no farther away than any corner may move. All vertices of that position go with
 * it, so closed surfaces stay closed. Neighbouring triangles keep their area, and
 * each move leaves fewer lines than before. What was a line in the mesh stays one.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/lattice_mend.h"

#include "host_tools/base/heap.h"
#include "host_tools/mesh/extent.h"
#include "host_tools/pack/lattice_area.h"
#include "host_tools/pack/lattice_tally.h"

/* A vertex of more triangles has a tally, and moves no more often than that: this bounds
 * the time by the number of triangles. */
enum { TRIANGLES_MANY = 16, MOVES_MOST = 64 };

static const double FARTHEST2 = 0.75; /* the square of half a diagonal, the bound of all moves */

static int is_better(const lattice_moving *d, uint32_t vertex, lattice_target *target) {
    for (uint32_t i = d->around.begin[vertex]; i < d->around.begin[vertex + 1]; i++) {
        lattice_target_add(d, vertex, d->around.triangle[i], target, 1);
        if (target->lost > 0) {
            return 0;
        }
    }
    return target->fewer > 0;
}

/* Moves a first vertex, and with it all of its position, to the nearest of the eight
 * grid points around it that is better than where it is. */
static int move(lattice_moving *d, uint32_t vertex) {
    const int many = lattice_around_count(&d->around, vertex) > TRIANGLES_MANY;
    lattice_tally *t = many ? lattice_tally_for(d, vertex) : NULL;
    lattice_target local[8], *target = t != NULL ? t->target : local, *best = NULL;
    if (t == NULL) {
        lattice_targets(d, vertex, local);
    } else if (t->moves == MOVES_MOST) {
        return 0;
    }
    for (unsigned c = 0; c < 8; c++) {
        const double nearest = best != NULL ? best->far2 : FARTHEST2;
        if (target[c].far2 < nearest && (t != NULL ? target[c].lost == 0 && target[c].fewer > 0
                                                   : is_better(d, vertex, &target[c]))) {
            best = &target[c];
        }
    }
    if (best != NULL) {
        const lattice_position to = best->at;
        lattice_move_to(d, vertex, &to);
    }
    return best != NULL;
}

static int is_line(const lattice_moving *d, size_t triangle) {
    const uint32_t corner = d->around.first[d->m->triangle[3 * triangle]];
    return lattice_state_of(d, triangle, corner, &d->moved[corner]) == LATTICE_LINE;
}

static uint64_t mend_all(lattice_moving *d) {
    uint64_t mended = 0;
    for (size_t i = 0; i < d->m->triangles; i++) {
        const int counts = mesh_counts(d->m, &d->s->mesh_box, i);
        for (size_t k = 0; k < 3 && counts && is_line(d, i); k++) {
            mended += (uint64_t)move(d, d->around.first[d->m->triangle[3 * i + k]]);
        }
    }
    for (size_t i = 0; i < d->m->vertices; i++) {
        if (d->moved[i].q[0] != LATTICE_UNUSED) {
            d->moved[i] = d->moved[d->around.first[i]];
        }
    }
    return mended;
}

static int any_line(const snapped *s, const mesh *m, const lattice_position *moved) {
    int line = 0;
    for (size_t i = 0; i < m->triangles && !line; i++) {
        const uint32_t *t = &m->triangle[3 * i];
        const lattice_position p[3] = {moved[t[0]], moved[t[1]], moved[t[2]]};
        line = mesh_counts(m, &s->mesh_box, i) && lattice_is_line(p) && mesh_has_area(m, i);
    }
    return line;
}

int lattice_mend(snapped *s, const mesh *m, lattice_position *moved) {
    lattice_moving d = {.s = s, .m = m, .moved = moved};
    if (!any_line(s, m, moved)) {
        return 0;
    }
    d.tally_of = heap_get_zeroed(((uint64_t)m->vertices + 1) * sizeof *d.tally_of);
    const int status =
        d.tally_of == NULL || lattice_around_find(&d.around, s, m, moved) != 0 ? -1 : 0;
    if (status == 0) {
        s->loss.mended = mend_all(&d);
    }
    lattice_around_free(&d.around);
    heap_drop(d.tally_of);
    heap_drop(d.tally);
    return status;
}
