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

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/pack/lattice_area.h"

enum { AREA, LINE, POINT }; /* POINT: also of two, or a line in the mesh */

typedef struct mending {
    const snapped *s;
    const mesh *m;
    lattice_position *moved;
    uint32_t *first; /* of each vertex: the first vertex with the same position */
    uint32_t *begin; /* triangles of each first vertex v: around[begin[v] .. begin[v + 1] - 1] */
    uint32_t *around;
    uint64_t mended;
} mending;

/* ---- vertices by position --------------------------------------------------------------- */

typedef struct vertex_at {
    float p[3];
    uint32_t vertex;
} vertex_at;

static int compare_positions(const void *a, const void *b) {
    const vertex_at *x = a, *y = b;
    const int order = memcmp(x->p, y->p, sizeof x->p);
    return order != 0 ? order : (x->vertex > y->vertex) - (x->vertex < y->vertex);
}

static int find_first(mending *d) {
    vertex_at *v = malloc(d->m->vertices * sizeof *v + 1);
    if (v == NULL) {
        return -1;
    }
    size_t used = 0;
    for (size_t i = 0; i < d->m->vertices; i++) {
        if (d->moved[i].q[0] != LATTICE_UNUSED) {
            for (size_t a = 0; a < 3; a++) {
                v[used].p[a] = d->m->vertex[3 * i + a] + 0.0f; /* -0 is 0 */
            }
            v[used++].vertex = (uint32_t)i;
        }
    }
    qsort(v, used, sizeof *v, compare_positions);
    for (size_t i = 0; i < used; i++) {
        const int same = i > 0 && memcmp(v[i].p, v[i - 1].p, sizeof v[i].p) == 0;
        d->first[v[i].vertex] = same ? d->first[v[i - 1].vertex] : v[i].vertex;
    }
    free(v);
    return 0;
}

static void find_triangles(mending *d) {
    memset(d->begin, 0, (d->m->vertices + 1) * sizeof *d->begin);
    for (size_t i = 0; i < 3 * d->m->triangles; i++) {
        d->begin[d->first[d->m->triangle[i]] + 1]++;
    }
    for (size_t i = 0; i < d->m->vertices; i++) {
        d->begin[i + 1] += d->begin[i];
    }
    for (size_t i = 3 * d->m->triangles; i-- > 0;) { /* begin[p + 1] counts down to its own start */
        d->around[--d->begin[d->first[d->m->triangle[i]] + 1]] = (uint32_t)(i / 3);
    }
    memmove(d->begin, d->begin + 1, d->m->vertices * sizeof *d->begin);
    d->begin[d->m->vertices] = (uint32_t)(3 * d->m->triangles);
}

/* ---- moving -------------------------------------------------------------------------- */

/* What becomes of a triangle when the vertices of `moving` go to `to`. */
static int state(const mending *d, size_t triangle, uint32_t moving, const lattice_position *to) {
    lattice_position p[3];
    for (size_t k = 0; k < 3; k++) {
        const uint32_t at = d->first[d->m->triangle[3 * triangle + k]];
        p[k] = at == moving ? *to : d->moved[at];
    }
    if (lattice_has_area(p)) {
        return AREA;
    }
    return lattice_is_line(p) && lattice_had_area(d->m, triangle) ? LINE : POINT;
}

static int is_better(const mending *d, uint32_t moving, const lattice_position *to) {
    int fewer = 0;
    for (uint32_t i = d->begin[moving]; i < d->begin[moving + 1]; i++) {
        const int before = state(d, d->around[i], moving, &d->moved[moving]);
        const int after = state(d, d->around[i], moving, to);
        if (before == AREA && after != AREA) {
            return 0;
        }
        fewer += (before == LINE) - (after == LINE);
    }
    return fewer > 0;
}

/* Moves a first vertex, and with it all of its position, to the nearest of the eight
 * grid points around it that is better than where it is. */
static int move(mending *d, uint32_t vertex) {
    const uint32_t most = (1u << d->s->lattice.bits) - 1u;
    lattice_position best = {{0, 0, 0}};
    double nearest = 0.75; /* the square of half a diagonal, the bound of all moves */
    int found = 0;
    for (unsigned corner = 0; corner < 8; corner++) {
        lattice_position to;
        double far2 = 0.0;
        int inside = 1;
        for (int a = 0; a < 3; a++) {
            const double x = lattice_steps(d->s, d->m->vertex + 3 * (size_t)vertex, a);
            const double q = floor(x) + (double)(corner >> a & 1u);
            inside &= q <= (double)most;
            to.q[a] = (uint32_t)q;
            far2 += (x - q) * (x - q);
        }
        if (inside && far2 < nearest && is_better(d, vertex, &to)) {
            nearest = far2;
            best = to;
            found = 1;
        }
    }
    if (found) {
        d->moved[vertex] = best;
    }
    return found;
}

static void mend_all(mending *d) {
    for (size_t i = 0; i < d->m->triangles; i++) {
        const uint32_t corner = d->first[d->m->triangle[3 * i]];
        for (size_t k = 0; k < 3 && state(d, i, corner, &d->moved[corner]) == LINE; k++) {
            d->mended += (uint64_t)move(d, d->first[d->m->triangle[3 * i + k]]);
        }
    }
    for (size_t i = 0; i < 3 * d->m->triangles; i++) {
        d->moved[d->m->triangle[i]] = d->moved[d->first[d->m->triangle[i]]];
    }
}

static int any_line(const mesh *m, const lattice_position *moved) {
    int line = 0;
    for (size_t i = 0; i < m->triangles && !line; i++) {
        const uint32_t *t = &m->triangle[3 * i];
        const lattice_position p[3] = {moved[t[0]], moved[t[1]], moved[t[2]]};
        line = lattice_is_line(p) && lattice_had_area(m, i);
    }
    return line;
}

int lattice_mend(snapped *s, const mesh *m, lattice_position *moved) {
    mending d = {.s = s, .m = m, .moved = moved};
    if (!any_line(m, moved)) {
        return 0;
    }
    d.first = malloc(m->vertices * sizeof *d.first + 1);
    d.begin = malloc((m->vertices + 1) * sizeof *d.begin);
    d.around = malloc(3 * m->triangles * sizeof *d.around + 1);
    int status = d.first == NULL || d.begin == NULL || d.around == NULL ? -1 : find_first(&d);
    if (status == 0) {
        find_triangles(&d);
        mend_all(&d);
        s->loss.mended = d.mended;
    }
    free(d.first);
    free(d.begin);
    free(d.around);
    return status;
}
