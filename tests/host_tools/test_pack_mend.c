/* test_pack_mend - slivers that would become lines on the lattice are mended
 *
 * A tetrahedron 4,094 long: at 12 bits the lattice's step is 1 and its origin 0, and
 * coordinates in the mesh are those on the lattice. An edge gets a corner beside it
 * and a sliver that closes the gap; rounding makes a line of the sliver, and the
 * corner lies on the edge.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "host_tools/pack/lattice_area.h"
#include "host_tools/pack/lattice_snap.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { LONGEST = 4094, ROUNDS = 2000 };

static float corner[4][3] = {{0, 0, 0}, {LONGEST, 0, 0}, {2000, 3000, 0}, {1900, 900, 2800}};
static const uint32_t face[4][3] = {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};

static void vertex(mesh *m, const float p[3]) {
    fail f = {""};
    CHECK(mesh_add_vertex(m, p[0], p[1], p[2], &f) == 0, "%s", f.text);
}

static void triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    fail f = {""};
    CHECK(mesh_add_triangle(m, a, b, c, &f) == 0, "%s", f.text);
}

/* Face `gap` is two, with `beside` on its first edge, and there is a sliver. */
static mesh with_sliver(unsigned gap, const float beside[3]) {
    mesh m = {0};
    for (int i = 0; i < 4; i++) {
        vertex(&m, corner[i]);
    }
    vertex(&m, beside);
    for (unsigned i = 0; i < 4; i++) {
        const uint32_t *t = face[i];
        if (i == gap) {
            triangle(&m, t[0], 4, t[2]);
            triangle(&m, 4, t[1], t[2]);
            triangle(&m, t[0], t[1], 4);
        } else {
            triangle(&m, t[0], t[1], t[2]);
        }
    }
    return m;
}

/* The same triangles, each with three vertices of its own. */
static mesh soup_of(const mesh *m) {
    mesh to = {0};
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        vertex(&to, m->vertex + 3 * (size_t)m->triangle[i]);
        if (i % 3 == 2) {
            triangle(&to, (uint32_t)i - 2, (uint32_t)i - 1, (uint32_t)i);
        }
    }
    return to;
}

static const unsigned char *at(const snapped *s, uint32_t i, uint32_t c) {
    return s->corners + ((size_t)i * 9 + 3 * c) * s->width;
}

/* Edges that are not there as often in the other direction. */
static uint32_t open_edges(const snapped *s) {
    uint32_t open = 0;
    for (uint32_t e = 0; e < 3 * s->count; e++) {
        int balance = 0;
        for (uint32_t o = 0; o < 3 * s->count; o++) {
            const unsigned char *a = at(s, e / 3, e % 3), *b = at(s, e / 3, (e + 1) % 3);
            const unsigned char *c = at(s, o / 3, o % 3), *d = at(s, o / 3, (o + 1) % 3);
            balance += !memcmp(a, c, 3 * s->width) && !memcmp(b, d, 3 * s->width);
            balance -= !memcmp(a, d, 3 * s->width) && !memcmp(b, c, 3 * s->width);
        }
        open += balance != 0;
    }
    return open;
}

static snapped snap(const mesh *m) {
    snapped s;
    fail f = {""};
    CHECK(lattice_snap(&s, m, 12, "test", &f) == 0, "%s", f.text);
    CHECK(s.lattice.step == 1.0f && s.lattice.origin[0] == 0.0f, "a step of %g",
          (double)s.lattice.step);
    CHECK(s.loss.largest_move * LONGEST <= sqrt(0.75), "moved by %g",
          s.loss.largest_move * LONGEST);
    return s;
}

/* `mended` corners, `lines` left: whether vertices are shared or not. */
static void expect(unsigned gap, const float beside[3], uint64_t mended, uint64_t lines,
                   uint32_t count) {
    mesh shared = with_sliver(gap, beside), soup = soup_of(&shared);
    for (int i = 0; i < 2; i++) {
        snapped s = snap(i ? &soup : &shared);
        CHECK(s.loss.mended == mended && s.loss.t_junctions == lines && s.count == count,
              "%s at %g %g %g: %llu mended, %llu T-junctions, %u triangles", i ? "soup" : "mesh",
              (double)beside[0], (double)beside[1], (double)beside[2],
              (unsigned long long)s.loss.mended, (unsigned long long)s.loss.t_junctions, s.count);
        CHECK((open_edges(&s) == 0) == (lines == 0), "%u open edges", open_edges(&s));
        snapped_free(&s);
    }
    mesh_free(&shared);
    mesh_free(&soup);
}

/* Somewhere on a random edge, and up to half a step beside it. */
static void random_slivers(void) {
    random_state r = {1};
    uint32_t mended = 0, left = 0;
    for (int round = 0; round < ROUNDS; round++) {
        static const float lo[3] = {-0.5f, -0.5f, -0.5f}, hi[3] = {0.5f, 0.5f, 0.5f};
        const unsigned gap = random_below(&r, 4);
        const float *a = corner[face[gap][0]], *b = corner[face[gap][1]];
        const float share = random_float(&r, 0.0f, 1.0f);
        float beside[3];
        random_point(&r, lo, hi, beside);
        for (int k = 0; k < 3; k++) {
            beside[k] = fmaxf(0.0f, beside[k] + a[k] + share * (b[k] - a[k]));
        }
        mesh m = with_sliver(gap, beside);
        snapped s = snap(&m);
        mended += s.loss.mended > 0;
        left += s.loss.t_junctions > 0;
        CHECK((open_edges(&s) == 0) == (s.loss.t_junctions == 0), "round %d: %u open edges", round,
              open_edges(&s));
        snapped_free(&s);
        mesh_free(&m);
    }
    printf("    %u of %d mended, %u left\n", mended, (int)ROUNDS, left);
    CHECK(mended > ROUNDS / 4 && left > ROUNDS / 4, "%u mended, %u left", mended, left);
}

/* ---- hubs: vertices of many slivers ------------------------------------------------------ */

/* What lattice_mend.h promises, said once more without any book-keeping. Positions of
 * vertices are different. */
typedef struct plain {
    const mesh *m;
    lattice_position *at;
    uint64_t mended;
} plain;

/* 0: has an area, 1: a line, 2: nothing to mend. */
static int plain_state(const plain *p, size_t i) {
    const uint32_t *t = &p->m->triangle[3 * i];
    const lattice_position corners[3] = {p->at[t[0]], p->at[t[1]], p->at[t[2]]};
    return lattice_has_area(corners) ? 0 : lattice_is_line(corners) ? 1 : 2;
}

static int plain_better(plain *p, uint32_t vertex, lattice_position to) {
    int fewer = 0, lost = 0;
    for (size_t i = 0; i < p->m->triangles; i++) {
        const uint32_t *t = &p->m->triangle[3 * i];
        if (t[0] == vertex || t[1] == vertex || t[2] == vertex) {
            const lattice_position was = p->at[vertex];
            const int before = plain_state(p, i);
            p->at[vertex] = to;
            const int after = plain_state(p, i);
            p->at[vertex] = was;
            lost |= before == 0 && after != 0;
            fewer += (before == 1) - (after == 1);
        }
    }
    return fewer > 0 && !lost;
}

static void plain_move(plain *p, uint32_t vertex) {
    double nearest = 0.75;
    lattice_position best = p->at[vertex];
    for (unsigned c = 0; c < 8; c++) {
        lattice_position to;
        double far2 = 0.0;
        for (int a = 0; a < 3; a++) {
            const double x = (double)p->m->vertex[3 * (size_t)vertex + (size_t)a];
            to.q[a] = (uint32_t)floor(x) + (c >> a & 1u);
            far2 += (x - to.q[a]) * (x - to.q[a]);
        }
        if (far2 < nearest && plain_better(p, vertex, to)) {
            nearest = far2;
            best = to;
        }
    }
    p->mended += nearest < 0.75;
    p->at[vertex] = best;
}

static void plain_mend(plain *p) {
    for (size_t i = 0; i < 3 * p->m->vertices; i++) {
        p->at[i / 3].q[i % 3] = (uint32_t)floor((double)p->m->vertex[i] + 0.5);
    }
    for (size_t i = 0; i < 3 * p->m->triangles; i++) {
        if (plain_state(p, i / 3) == 1) {
            plain_move(p, p->m->triangle[i]);
        }
    }
}

/* Slivers from `hubs` vertices to others along a line, `shared` hubs in each; and a
 * triangle that makes the mesh LONGEST long. */
static mesh hub_mesh(uint32_t hubs, uint32_t shared, uint32_t slivers, float width, uint64_t seed) {
    random_state r = {seed};
    mesh m = {0};
    for (int i = 0; i < 3; i++) {
        vertex(&m, corner[i]);
    }
    triangle(&m, 0, 1, 2);
    for (uint32_t i = 0; i < hubs; i++) {
        vertex(&m, (const float[3]){random_float(&r, 5, 4000), random_float(&r, 5, 5 + width),
                                    random_float(&r, 5, 5 + width)});
    }
    for (uint32_t i = 0; i < slivers; i++) {
        uint32_t t[3];
        for (uint32_t k = 0; k < 3; k++) {
            t[k] = 3 + (i + k) % hubs;
            if (k >= shared) {
                t[k] = (uint32_t)m.vertices;
                vertex(&m,
                       (const float[3]){random_float(&r, 5, 4000), random_float(&r, 5, 5 + width),
                                        random_float(&r, 5, 5 + width)});
            }
        }
        const uint32_t turn = random_below(&r, 3);
        triangle(&m, t[turn], t[(turn + 1) % 3], t[(turn + 2) % 3]);
    }
    return m;
}

static void same_as_plain(const mesh *m, uint64_t *mended) {
    plain p = {.m = m, .at = malloc(m->vertices * sizeof *p.at)};
    snapped s = snap(m);
    uint32_t same = 0;
    plain_mend(&p);
    CHECK(s.loss.mended == p.mended, "%llu mended, not %llu", (unsigned long long)s.loss.mended,
          (unsigned long long)p.mended);
    for (uint32_t i = 0; i < s.count; i++) {
        for (uint32_t k = 0; k < 9; k++) {
            const unsigned char *q = at(&s, i, 0) + (size_t)k * s.width;
            const uint32_t wanted = p.at[m->triangle[3 * (size_t)s.source[i] + k / 3]].q[k % 3];
            same += (q[0] | (uint32_t)q[1] << 8) == wanted;
        }
    }
    CHECK(same == 9 * s.count, "%u of %u coordinates", same, 9 * s.count);
    *mended += s.loss.mended;
    snapped_free(&s);
    free(p.at);
}

static void small_hubs(void) {
    uint64_t mended = 0;
    for (uint32_t i = 0; i < 60; i++) {
        mesh m = hub_mesh(2 + i % 4, 1 + i / 4 % 2, 40 + i, 0.5f + 0.1f * (float)(i % 17), i);
        same_as_plain(&m, &mended);
        mesh_free(&m);
    }
    printf("    %llu mended\n", (unsigned long long)mended);
    CHECK(mended > 60, "%llu mended", (unsigned long long)mended);
}

/* All stay lines, whatever moves. That takes minutes where each is counted anew. */
static void large_hubs(void) {
    for (uint32_t shared = 1; shared <= 2; shared++) {
        mesh m = hub_mesh(2, shared, 100000, 0.002f, 1);
        const clock_t began = clock();
        snapped s = snap(&m);
        const double seconds = (double)(clock() - began) / CLOCKS_PER_SEC;
        printf("    %u shared: %.2f s\n", shared, seconds);
        CHECK(seconds < 10.0, "%g s", seconds);
        CHECK(s.count < 1000, "%u triangles", s.count);
        snapped_free(&s);
        mesh_free(&m);
    }
}

int main(void) {
    test("a corner on its neighbour's edge moves to another grid point around it");
    expect(0, (const float[3]){2000, 0.3f, 0.1f}, 1, 0, 6);
    expect(0, (const float[3]){2000, 0.1f, 0.45f}, 1, 0, 6);
    test("none goes farther than half a diagonal: then the T-junction is reported");
    expect(0, (const float[3]){2000, 0.02f, 0.01f}, 0, 1, 5);
    test("a sliver with an area on the lattice stays, and so does one that the mesh had flat");
    expect(0, (const float[3]){2000, 0.6f, 0.1f}, 0, 0, 6);
    expect(0, (const float[3]){2001, 0, 0}, 0, 1, 5);
    expect(3, (const float[3]){500.25f, 750.375f, 0}, 0, 1, 5);
    expect(3, (const float[3]){500.25f, 750.376f, 0}, 1, 0, 6);
    test("... and no triangle that has an area loses it: the next grid point is chosen");
    corner[2][0] = 4000; /* on a line with corner 0 and the first grid point beside the edge */
    corner[2][1] = 2;
    expect(0, (const float[3]){2000, 0.3f, 0.3f}, 1, 0, 6);
    corner[2][0] = 2000; /* it is that point */
    corner[2][1] = 1;
    expect(0, (const float[3]){2000, 0.3f, 0.3f}, 1, 0, 6);
    corner[2][1] = 3000;
    test("a mesh is closed on the lattice if no T-junction is reported, and only then");
    random_slivers();
    test("vertices of many slivers move as if each was counted anew");
    small_hubs();
    test("... in time that grows with their number, not its square");
    large_hubs();
    return test_done();
}
