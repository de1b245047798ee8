/* grid_scenes - see grid_scenes.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/grid_scenes.h"

#include <math.h>

#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"

/* ---- shapes in the cube -1 .. 1 ------------------------------------------------------ */

static float of_size(random_state *r, int least, int most) {
    return ldexpf(1.0f, least + (int)random_below(r, (uint32_t)(most - least + 1)));
}

/* Soups of triangles from far smaller than cells to as long as the scene. */
static void soup(mesh *m, uint32_t triangles, random_state *r) {
    shape_soup(m, triangles, of_size(r, -9, 1), random_bits(r));
}

/* Each vertex on a lattice of few numbers: in faces of cells, coplanar, many the same. */
static void on_lattice(mesh *m, uint32_t triangles, random_state *r) {
    const float step = of_size(r, -5, 0);
    shape_soup(m, triangles, of_size(r, -4, 1), random_bits(r));
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        m->vertex[i] = step * rintf(m->vertex[i] / step);
    }
}

/* Long and thin, some along an axis. */
static void needles(mesh *m, uint32_t triangles, random_state *r) {
    const float width = of_size(r, -20, -6);
    shape_soup(m, triangles, width, random_bits(r));
    for (size_t i = 0; i < m->triangles; i++) {
        float *v = m->vertex + 3 * (size_t)m->triangle[3 * i];
        const unsigned axis = random_below(r, 4);
        for (unsigned a = 0; a < 3; a++) {
            v[a] = axis == 3 || axis == a ? random_float(r, -1.0f, 1.0f) : v[a];
        }
    }
}

/* All but a few in one place, or in some: crowded cells. */
static void clusters(mesh *m, uint32_t triangles, random_state *r) {
    triangles += rig_triangles(350, 1); /* fewer crowd no cell */
    const uint32_t places = 1 + random_below(r, 4), loose = triangles / 8 + 2;
    const float size = of_size(r, -22, -5);
    float at[4][3];
    static const float lo[3] = {-1.0f, -1.0f, -1.0f}, hi[3] = {1.0f, 1.0f, 1.0f};
    for (uint32_t i = 0; i < places; i++) {
        random_point(r, lo, hi, at[i]);
        for (int a = 0; a < 3 && random_below(r, 3) == 0; a++) {
            at[i][a] = rintf(4.0f * at[i][a]) / 4.0f; /* at a corner of cells, maybe */
        }
    }
    shape_soup(m, triangles, of_size(r, -6, 0), random_bits(r));
    for (size_t i = loose; i < m->triangles; i++) {
        const float *to = at[random_below(r, places)];
        for (unsigned k = 0; k < 9; k++) {
            float *v = m->vertex + 3 * (size_t)m->triangle[3 * i + k / 3] + k % 3;
            *v = to[k % 3] + size * *v;
        }
    }
}

/* Points, lines and proper triangles, mixed. */
static void degenerate(mesh *m, uint32_t triangles, random_state *r) {
    shape_soup(m, triangles, of_size(r, -5, 1), random_bits(r));
    for (size_t i = 0; i < m->triangles; i++) {
        float *v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = m->vertex + 3 * (size_t)m->triangle[3 * i + (size_t)k];
        }
        const unsigned way = random_below(r, 5);
        for (unsigned a = 0; a < 3; a++) {
            v[1][a] = way == 0 || way == 1 ? v[0][a] : v[1][a];
            v[2][a] = way == 0 ? v[0][a] : way == 2 ? 2.0f * v[1][a] - v[0][a] : v[2][a];
        }
    }
}

/* No size along one axis, or along two. */
static void flat(mesh *m, uint32_t triangles, random_state *r) {
    const unsigned axis = random_below(r, 3), is_line = random_below(r, 6) == 0;
    const float at = random_float(r, -1.0f, 1.0f);
    const float thick = random_below(r, 2) ? 0.0f : of_size(r, -24, -8);
    shape_soup(m, triangles, of_size(r, -6, 1), random_bits(r));
    for (size_t i = 0; i < m->vertices; i++) {
        float *v = m->vertex + 3 * i;
        v[axis] = at + thick * v[axis];
        v[(axis + 1) % 3] = is_line ? at : v[(axis + 1) % 3];
    }
}

static void exponential(mesh *m, uint32_t triangles, random_state *r) {
    shape_exponential(m, triangles < 60 ? triangles : 20 + random_below(r, 40));
}

static void coincident(mesh *m, uint32_t triangles, random_state *r) {
    (void)r;
    shape_coincident(m, triangles);
}

static void closed(mesh *m, uint32_t triangles, random_state *r) {
    if (rig_is_tiny() || random_below(r, 4) == 0) {
        shape_cube(m);
    } else {
        shape_icosphere(m, triangles > 400 ? 3 : 1 + random_below(r, 2));
    }
}

static void (*const shapes[])(mesh *, uint32_t, random_state *) = {
    soup, soup, on_lattice, on_lattice,  needles,    clusters, clusters,
    flat, flat, degenerate, exponential, coincident, closed};
enum { SHAPES = sizeof shapes / sizeof *shapes };

/* ---- scenes -------------------------------------------------------------------------- */

/* Where corners are coarse, they become equal, and sides nothing. */
static void put(mesh *m, random_state *r) {
    const int power = (int)random_below(r, 61) - 30, far = power < 21 ? 16 : 38 - power;
    const float scale = ldexpf(1.0f, power);
    float move[3];
    for (int a = 0; a < 3; a++) {
        const float off = random_below(r, 4) ? 0.0f : of_size(r, -1, far);
        move[a] = (random_below(r, 2) ? -off : off) * scale;
    }
    if (random_below(r, 8) != 0) {
        shape_transform(m, scale, move[0], move[1], move[2]);
    }
}

unsigned grid_scene_make(mesh *m, random_state *r) {
    const unsigned kind = random_below(r, SHAPES);
    static const uint32_t most[4] = {4, 40, 250, 1000};
    const uint32_t triangles = rig_triangles(1 + random_below(r, most[random_below(r, 4)]), 1);
    shapes[kind](m, triangles, r);
    put(m, r);
    return kind;
}

/* Corners on faces of cells, as exactly as they are computed. */
static void snap(mesh *m, const plt_grid *grid, random_state *r) {
    const plt_grid_level *l = &grid->top;
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        const size_t a = i % 3;
        if (l->size[a] > 0.0f && random_below(r, 4) != 0) {
            m->vertex[i] = l->lo[a] + rintf((m->vertex[i] - l->lo[a]) / l->size[a]) * l->size[a];
        }
    }
}

void grid_scene_deform(mesh *m, const plt_grid *grid, random_state *r) {
    const unsigned way = random_below(r, 6);
    float lo[3], hi[3], center[3];
    shape_box(m, lo, hi);
    random_point(r, lo, hi, center);
    if (way == 0) {
        snap(m, grid, r);
        return;
    }
    const unsigned axis = random_below(r, 3);
    const float size = of_size(r, -24, 3);
    for (size_t i = 0; i < m->vertices; i++) {
        float *v = m->vertex + 3 * i;
        for (unsigned a = 0; a < 3; a++) {
            switch (way) {
            case 1: /* a little */
                v[a] += random_float(r, -0.02f, 0.02f) * (hi[a] - lo[a]);
                break;
            case 2: /* anywhere */
                v[a] = random_float(r, lo[a], hi[a]);
                break;
            case 3: /* flat */
                v[a] = a == axis ? center[a] : v[a];
                break;
            case 4: /* half of it in one place */
                v[a] = i % 2 ? center[a] + (v[a] - center[a]) * size : v[a];
                break;
            default: /* smaller or larger */
                v[a] = center[a] + (v[a] - center[a]) * size;
            }
        }
    }
}
