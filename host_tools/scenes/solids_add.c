/* solids_add - see solids_add.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/solids_add.h"

#define DETAIL_ONE 32u

unsigned solid_divisions(const solids *s, unsigned normal) {
    const unsigned divisions = (unsigned)((uint64_t)normal * s->detail / DETAIL_ONE);
    return divisions < 1 ? 1 : divisions;
}

uint32_t solids_first(const solids *s) {
    return (uint32_t)s->m->vertices;
}

int solids_only_count(solids *s, uint64_t triangles) {
    s->triangles += triangles;
    return s->m == NULL || s->wrong;
}

void solids_vertex(solids *s, const place *at, const double local[3]) {
    double p[3];
    place_point(at, local, p);
    s->wrong |= mesh_add_vertex(s->m, (float)p[0], (float)p[1], (float)p[2], s->f) != 0;
}

void solids_triangle(solids *s, uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t second = s->is_hollow ? c : b, third = s->is_hollow ? b : c;
    s->wrong |= mesh_add_triangle(s->m, a, second, third, s->f) != 0;
}

void solids_quad(solids *s, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    solids_triangle(s, a, b, c);
    solids_triangle(s, a, c, d);
}
