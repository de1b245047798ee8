/* test_baselines_bph_trace - every switch of the thesis's BPH, and what each is known to give
 *
 * All combinations that make sense have the hits of a list of all triangles, bit for bit. What they
 * count is not free either: most switches leave some counts as they are, or change them by a rule.
 *
 * Source: Karrenberg 2007, sections 3.2, 3.5, 6.3 and 8.1.1, figure 8.1.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/structure.h"
#include "tests/reference/mover.h"
#include "tests/reference/rays.h"

enum { RAYS = 256 + 120 + 61 }; /* a packet of 16x16; then any; the last is not full */

/* ---- rays, and the hits of a list ----------------------------------------------------- */

typedef struct due {
    plt_ray rays[RAYS];
    plt_hit hits[2][RAYS]; /* nearest, any */
} due;

/* What is no ray at all, or an odd one. */
static void make_odd(plt_ray *ray, random_state *r) {
    static const float odd[] = {NAN, INFINITY, -INFINITY, 0.0f, -0.0f, 3e38f, 1e-38f, -1.0f, 1e12f};
    float *of[4] = {&ray->org[random_below(r, 3)], &ray->dir[random_below(r, 3)], &ray->tmin,
                    &ray->tmax};
    *of[random_below(r, 4)] = odd[random_below(r, sizeof odd / sizeof *odd)];
}

static void make_rays(plt_ray *rays, const mesh *m, random_state *r) {
    memset(rays, 0, RAYS * sizeof *rays);
    rays_camera(rays, 256, m, r);
    rays_mixed(rays + 256, 120, m, r);
    rays_edges(rays + 376, 61, m, r);
    for (unsigned i = 0; i < RAYS / 16; i++) {
        make_odd(&rays[random_below(r, RAYS)], r);
    }
}

static int trace_list(due *d, const mesh *m) {
    const rig_config list = rig_config_of(2, 64, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    rig x;
    const int is_open = rig_open(&x, m, &list) == PLT_OK;
    CHECK(is_open, "%s", x.fault.message);
    for (int any = 0; any < 2 && is_open; any++) {
        CHECK(plt_trace(x.engine, d->rays, d->hits[any], RAYS, any) == PLT_OK, "the list");
    }
    rig_close(&x);
    return is_open;
}

static built_structure *open_by(const char *text, const mesh *m) {
    structure_options o;
    fail f = {""};
    const structure_kind *kind = structure_read(text, "it", &o, &f);
    CHECK(kind != NULL, "%s: %s", text, f.text);
    built_structure *s = kind != NULL ? structure_open(kind, m, &o, "it", &f) : NULL;
    CHECK(s != NULL, "%s: %s", text, f.text);
    return s;
}

static structure_statistics trace_by(built_structure *s, const due *d, uint32_t count, int any,
                                     const char *text) {
    static plt_hit got[RAYS];
    fail f = {""};
    structure_forget(s);
    CHECK(structure_trace(s, d->rays, got, count, any, &f) == 0, "%s: %s", text, f.text);
    for (uint32_t i = 0; i < count; i++) {
        const plt_hit *g = &got[i], *w = &d->hits[any][i];
        CHECK(memcmp(g, w, sizeof *g) == 0, "%s, ray %u, any %d: %u at %a, not %u at %a", text, i,
              any, g->triangle, (double)g->t, w->triangle, (double)w->t);
    }
    return structure_count(s);
}

/* ---- all combinations ------------------------------------------------------------------ */

enum { GROUPS = 10, WORDS = 5, SCENES = 3 };

static const char *const words[GROUPS][WORDS + 1] = {
    {"leaf-1", "leaf-2", "leaf-4", "counts", NULL},
    {"direct", "recompute", "unmerged", NULL},
    {"clip", "naive", NULL},
    {"bits", "range", "all", NULL},
    {"equal", "mixed", NULL},
    {"near", "left", NULL},
    {"no-early", "early", NULL},
    {"no-frustum", "frustum", NULL},
    {"median", "sah", NULL},
    {"8x8", "4x4", "16x16", "2x2", "single"},
};

static unsigned words_of(unsigned group) {
    unsigned n = 0;
    while (n < WORDS && words[group][n] != NULL) {
        n++;
    }
    return n;
}

/* The next combination, as of a counter whose digits are groups; packets change with every one. 0:
 * there is none. */
static int next(unsigned digit[GROUPS]) {
    digit[GROUPS - 1] = (digit[GROUPS - 1] + 1) % words_of(GROUPS - 1);
    for (unsigned g = 0; g < GROUPS - 1; g++) {
        if (++digit[g] < words_of(g)) {
            return 1;
        }
        digit[g] = 0;
    }
    return 0;
}

static void name_of(const unsigned digit[GROUPS], char text[160]) {
    strcpy(text, "bph");
    for (unsigned g = 0; g < GROUPS; g++) {
        strcat(text, g == 0 ? ":" : ",");
        strcat(text, words[g][digit[g]]);
    }
}

/* What BASELINES.md says makes no sense. */
static int makes_sense(const unsigned digit[GROUPS]) {
    const int is_early = digit[6] == 1, is_frustum = digit[7] == 1;
    return !(digit[0] == 3 && digit[1] == 1) && !(is_early && digit[3] == 2) &&
           !(is_frustum && digit[4] == 1);
}

static unsigned tried, refused;

static void run_combinations(const mesh *m, const mesh *moved, const due *before,
                             const due *after) {
    unsigned digit[GROUPS] = {0};
    do {
        structure_options o;
        fail f = {""};
        char text[160];
        name_of(digit, text);
        const structure_kind *kind = structure_read(text, "it", &o, &f);
        CHECK((kind != NULL) == makes_sense(digit), "%s: %s", text, f.text);
        if (kind == NULL) {
            CHECK(strstr(f.text, "; give ") != NULL, "%s", f.text);
            refused++;
            continue;
        }
        built_structure *s = structure_open(kind, m, &o, "it", &f);
        CHECK(s != NULL, "%s: %s", text, f.text);
        trace_by(s, before, RAYS, 0, text);
        trace_by(s, before, RAYS, 1, text);
        if (tried++ % 16 == 0) {
            CHECK(structure_move(s, moved, &f) == 0, "%s", f.text);
            trace_by(s, after, RAYS, 0, text);
        }
        structure_close(s);
    } while (next(digit));
}

static void combinations(void) {
    random_state r = {81};
    test(
        "all combinations of switches that make sense have a list's hits, before and after a move");
    for (unsigned i = 0; i < SCENES; i++) {
        static due before, after;
        mesh m = {0};
        if (i == 0) {
            shape_soup(&m, rig_triangles(60, 1), 0.5f, 7);
        } else if (i == 1) {
            shape_degenerate(&m);
        } else {
            shape_exponential(&m, 24);
        }
        mesh moved = shape_copy(&m);
        mover_deform(&moved, i % 2 == 0 ? 2 : 5);
        make_rays(before.rays, &m, &r);
        make_rays(after.rays, &moved, &r);
        if (trace_list(&before, &m) && trace_list(&after, &moved)) {
            run_combinations(&m, &moved, &before, &after);
        }
        mesh_free(&m);
        mesh_free(&moved);
    }
    CHECK(tried == SCENES * 1320 && refused == SCENES * 984, "%u, %u refused", tried, refused);
}

/* ---- what switches give ------------------------------------------------------------------ */

/* 16x16 pixels of that size, by tiles of 4x4: the axis of the view goes through some of the
 * tiles. */
static void make_view(mesh *m, due *d, float size) {
    static const float eye[3] = {0.0f, 0.1f, -4.0f};
    random_state r = {35};
    shape_icosphere(m, rig_is_tiny() ? 0 : 3);
    shape_soup(m, rig_triangles(300, 1), 0.2f, 11);
    make_rays(d->rays, m, &r);
    for (unsigned i = 0; i < 256; i++) {
        const unsigned x = i / 16 % 4 * 4 + i % 4, y = i / 64 * 4 + i / 4 % 4;
        const float dir[3] = {size * ((float)x - 6.5f), size * ((float)y - 6.5f), 1.0f};
        d->rays[i] = ray_make(eye, dir, 0.0f, RAYS_FAR);
    }
    CHECK(trace_list(d, m), "the list");
}

static structure_statistics count_by(const char *text, const mesh *m, const due *d) {
    built_structure *s = open_by(text, m);
    const structure_statistics c = trace_by(s, d, 256, 0, text);
    structure_close(s);
    return c;
}

static uint64_t active_at_nodes(const structure_statistics *c) {
    return c->rays_at_nodes - c->masked_at_nodes;
}

static int same_visits(const structure_statistics *a, const structure_statistics *b) {
    return a->packet_nodes == b->packet_nodes && a->packet_triangles == b->packet_triangles &&
           active_at_nodes(a) == active_at_nodes(b) && a->triangle_tests == b->triangle_tests;
}

static void one_pass(const mesh *m, const due *d) {
    const structure_statistics clip = count_by("bph:4x4", m, d);
    const structure_statistics naive = count_by("bph:4x4,naive", m, d);
    test("clipping visits what whole boxes do, by six distances per ray and node, not twelve");
    CHECK(same_visits(&clip, &naive), "%llu and %llu nodes", (unsigned long long)clip.packet_nodes,
          (unsigned long long)naive.packet_nodes);
    CHECK(clip.box_tests == 6 * (active_at_nodes(&clip) + 256), "clip: %llu distances",
          (unsigned long long)clip.box_tests);
    CHECK(naive.box_tests >= 12 * active_at_nodes(&clip) + 6 * 256, "naive: %llu distances",
          (unsigned long long)naive.box_tests);
}

static void signs(const mesh *m, const due *d) {
    const structure_statistics equal = count_by("bph:4x4", m, d);
    const structure_statistics mixed = count_by("bph:4x4,mixed", m, d);
    const structure_statistics wide = count_by("bph:16x16", m, d);
    test("planes are matched once per packet of equal signs, and for each ray of others");
    CHECK(same_visits(&equal, &mixed) && equal.box_tests == mixed.box_tests, "visits");
    CHECK(mixed.plane_matches == mixed.box_tests, "mixed");
    CHECK(equal.packets == 16 && 0 < equal.one_sign && equal.one_sign < 16, "%llu of one sign",
          (unsigned long long)equal.one_sign);
    CHECK(equal.plane_matches < mixed.plane_matches, "equal");
    CHECK(wide.packets == 1 && wide.one_sign == 0 && wide.plane_matches == wide.box_tests, "wide");
}

static void masks(const mesh *m, const due *d) {
    const structure_statistics bits = count_by("bph:16x16", m, d);
    const structure_statistics range = count_by("bph:16x16,range", m, d);
    const structure_statistics all = count_by("bph:16x16,all", m, d);
    test("masks leave nodes and triangles as they are, and rays out: a range some, bits more");
    CHECK(bits.packet_nodes == range.packet_nodes && range.packet_nodes == all.packet_nodes,
          "nodes");
    CHECK(bits.packet_triangles == range.packet_triangles &&
              range.packet_triangles == all.packet_triangles,
          "triangles");
    CHECK(active_at_nodes(&bits) < active_at_nodes(&range) &&
              active_at_nodes(&range) < active_at_nodes(&all),
          "active rays");
    CHECK(bits.triangle_tests < range.triangle_tests && range.triangle_tests < all.triangle_tests,
          "tests");
    CHECK(all.masked_at_nodes == 0 && all.rays_at_nodes == 256 * all.packet_nodes, "all");
}

static void intermediates(const mesh *m, const due *d) {
    const structure_statistics direct = count_by("bph:4x4", m, d);
    const structure_statistics boxes = count_by("bph:4x4,recompute", m, d);
    const structure_statistics none = count_by("bph:4x4,unmerged", m, d);
    test("intermediate nodes take 32 bytes each away; recomputed boxes spare triangles alone");
    CHECK(none.nodes == m->triangles - 1 && none.nodes == direct.nodes + direct.intermediates,
          "%u and %u nodes", direct.nodes, none.nodes);
    CHECK(none.bytes - direct.bytes == 32ull * direct.intermediates && none.intermediates == 0,
          "bytes");
    CHECK(direct.leaves + direct.intermediates == m->triangles, "lists");
    CHECK(boxes.packet_nodes == direct.packet_nodes && boxes.nodes == direct.nodes, "nodes");
    CHECK(boxes.packet_triangles < direct.packet_triangles &&
              boxes.triangle_tests < direct.triangle_tests && boxes.recomputed > 0 &&
              boxes.recomputed % 2 == 0,
          "triangles");
    CHECK(boxes.box_tests > direct.box_tests, "distances");
    CHECK(none.packet_nodes > direct.packet_nodes &&
              none.packet_triangles < direct.packet_triangles,
          "unmerged");
}

static void early(const mesh *m, const due *d) {
    const structure_statistics plain = count_by("bph:4x4", m, d);
    const structure_statistics miss = count_by("bph:4x4,frustum", m, d);
    const structure_statistics hit = count_by("bph:4x4,early", m, d);
    const structure_statistics both = count_by("bph:4x4,early,frustum", m, d);
    const structure_statistics naive = count_by("bph:4x4,early,frustum,naive", m, d);
    test("a frustum saves distances alone; early hits with it more, early hits without it none");
    CHECK(same_visits(&plain, &miss) && miss.box_tests < plain.box_tests, "frustum");
    CHECK(0 < miss.frustum_misses && miss.frustum_misses < miss.frustum_tests, "misses");
    CHECK(hit.packet_nodes >= plain.packet_nodes && hit.packet_triangles >= plain.packet_triangles,
          "early: visits");
    CHECK(both.box_tests < miss.box_tests && both.box_tests < hit.box_tests,
          "%llu distances, early %llu, both %llu", (unsigned long long)plain.box_tests,
          (unsigned long long)hit.box_tests, (unsigned long long)both.box_tests);
    CHECK(0 < hit.early_hits && hit.early_hits < hit.early_tests && hit.frustum_tests == 0,
          "early");
    CHECK(both.early_tests - both.early_hits >= both.frustum_tests && both.frustum_misses > 0,
          "both");
    CHECK(0 < both.reconstructions && both.reconstructions <= hit.reconstructions &&
              naive.reconstructions == 0,
          "reconstructions");
    CHECK(plain.early_tests + plain.frustum_tests + plain.reconstructions == 0, "plain");
}

static void order(const mesh *m, const due *d) {
    const structure_statistics near = count_by("bph:4x4", m, d);
    const structure_statistics left = count_by("bph:4x4,left", m, d);
    test("the nearer child first finds hits sooner than the left one");
    CHECK(near.packet_nodes < left.packet_nodes && near.packet_triangles < left.packet_triangles,
          "%llu and %llu nodes", (unsigned long long)near.packet_nodes,
          (unsigned long long)left.packet_nodes);
}

static void any_hit(const mesh *m, const due *d) {
    test("rays that want any hit go on for no more once they have one");
    for (int is_naive = 0; is_naive < 2; is_naive++) {
        const char *text = is_naive ? "bph:4x4,naive" : "bph:4x4";
        built_structure *s = open_by(text, m);
        const structure_statistics near = trace_by(s, d, 256, 0, text);
        const structure_statistics any = trace_by(s, d, 256, 1, text);
        CHECK(any.packet_nodes < near.packet_nodes && any.triangle_tests < near.triangle_tests &&
                  any.masked_at_nodes * near.rays_at_nodes >
                      near.masked_at_nodes * any.rays_at_nodes,
              "%llu and %llu nodes", (unsigned long long)any.packet_nodes,
              (unsigned long long)near.packet_nodes);
        structure_close(s);
    }
}

/* A square, and a soup behind it that no ray comes to. */
static void hidden(void) {
    static const char *const all[] = {"bph:4x4", "bph:4x4,naive", "bph:4x4,early", "bph:4x4,mixed",
                                      "bph:4x4,early,frustum,naive"};
    static due d;
    mesh m = {0}, front = {0};
    fail f = {""};
    test("what has waited is left out when hits have come before it");
    shape_soup(&m, rig_triangles(120, 1) - 2, 0.3f, 21);
    shape_transform(&m, 4.0f, 0.0f, 0.0f, 30.0f); /* the first split is between them */
    shape_sheet(&front, 1, 2);
    for (unsigned i = 0; i < 6; i++) {
        const float *p = shape_corner(&front, i / 3, i % 3);
        CHECK(mesh_add_vertex(&m, p[0], p[1], p[2], &f) == 0, "%s", f.text);
    }
    const uint32_t at = (uint32_t)m.vertices - 6;
    CHECK(mesh_add_triangle(&m, at, at + 1, at + 2, &f) == 0 &&
              mesh_add_triangle(&m, at + 3, at + 4, at + 5, &f) == 0,
          "%s", f.text);
    for (unsigned i = 0; i < RAYS; i++) {
        const float eye[3] = {0.1f, 0.1f, -3.0f};
        const float dir[3] = {(float)(i % 4) / 16.0f, (float)(i / 4 % 4) / 16.0f, 1.0f};
        d.rays[i] = ray_make(eye, dir, 0.0f, RAYS_FAR);
    }
    CHECK(trace_list(&d, &m) && d.hits[0][0].triangle >= m.triangles - 2, "the square is not hit");
    for (unsigned i = 0; i < sizeof all / sizeof *all; i++) {
        built_structure *s = open_by(all[i], &m);
        const structure_statistics c = trace_by(s, &d, 16, 0, all[i]);
        CHECK(c.packet_nodes == 1 && c.packet_triangles == 2, "%s: %llu nodes, %llu triangles",
              all[i], (unsigned long long)c.packet_nodes, (unsigned long long)c.packet_triangles);
        structure_close(s);
    }
    mesh_free(&m);
    mesh_free(&front);
}

static void formats(const mesh *m, const due *d) {
    const structure_statistics one = count_by("bph:4x4", m, d);
    const structure_statistics two = count_by("bph:4x4,leaf-2", m, d);
    const structure_statistics four = count_by("bph:4x4,leaf-4", m, d);
    const structure_statistics any = count_by("bph:4x4,counts", m, d);
    test("longer lists take fewer nodes of 32 bytes, lists that are counted nodes of 40");
    CHECK(one.bytes == 32ull * one.nodes && two.bytes == 32ull * two.nodes &&
              four.bytes == 32ull * four.nodes && any.bytes == 40ull * any.nodes,
          "bytes");
    CHECK(one.nodes > two.nodes && two.nodes > four.nodes && any.nodes < one.nodes, "nodes");
    CHECK(one.packet_triangles < two.packet_triangles &&
              two.packet_triangles < four.packet_triangles,
          "triangles");
}

static void counts(void) {
    static due d;
    mesh m = {0};
    test("a view");
    make_view(&m, &d, 1.0f / 32.0f);
    if (!rig_is_tiny()) {
        one_pass(&m, &d);
        signs(&m, &d);
        masks(&m, &d);
        intermediates(&m, &d);
        order(&m, &d);
        any_hit(&m, &d);
        formats(&m, &d);
    }
    mesh_free(&m);
    test("a view from near by");
    make_view(&m, &d, 1.0f / 400.0f);
    if (!rig_is_tiny()) {
        early(&m, &d);
    }
    mesh_free(&m);
}

/* ---- figure 8.1 --------------------------------------------------------------------------- */

/* A triangle whose box is x .. x + 1, y .. y + 1, and which rays at y + 3/4 miss. */
static void add_corner(mesh *m, float x, float y) {
    fail f = {""};
    const uint32_t first = (uint32_t)m->vertices;
    CHECK(mesh_add_vertex(m, x, y, 0.0f, &f) == 0 && mesh_add_vertex(m, x + 1, y, 0.0f, &f) == 0 &&
              mesh_add_vertex(m, x, y + 1, 0.0f, &f) == 0 &&
              mesh_add_triangle(m, first, first + 1, first + 2, &f) == 0,
          "%s", f.text);
}

/* Three nodes and four leaves: seven boxes. The first of four rays hits the root, its left child,
 * and the lower leaf there; that child's other leaf is beyond all rays. The right child is hit by
 * the third ray, the first active one below it, which hits one leaf; the other is beyond all. */
static void figure_8_1(void) {
    static due d;
    mesh m = {0};
    test("figure 8.1: 7 early hit tests, 4 hits, 2 frustum exits, 1 reconstruction");
    for (unsigned i = 0; i < 4; i++) {
        add_corner(&m, i < 2 ? 0.0f : 20.0f, i % 2 == 0 ? 0.0f : 5.0f);
    }
    for (unsigned i = 0; i < 4; i++) {
        const float org[3] = {i < 2 ? 0.5f : 20.5f, 0.75f, -1.0f}, dir[3] = {0.0f, 0.0f, 1.0f};
        d.rays[i] = ray_make(org, dir, 0.0f, RAYS_FAR);
        d.hits[0][i] = (plt_hit){.triangle = PLT_MISS};
    }
    built_structure *s = open_by("bph:early,frustum,unmerged,2x2", &m);
    const structure_statistics c = trace_by(s, &d, 4, 0, "figure 8.1");
    CHECK(c.nodes == 3 && c.leaves == 4 && c.packet_nodes == 3, "%u nodes", c.nodes);
    CHECK(c.early_tests == 7 && c.early_hits == 4, "%llu early hits of %llu",
          (unsigned long long)c.early_hits, (unsigned long long)c.early_tests);
    CHECK(c.frustum_tests == 3 && c.frustum_misses == 2, "%llu exits of %llu",
          (unsigned long long)c.frustum_misses, (unsigned long long)c.frustum_tests);
    CHECK(c.reconstructions == 1, "%llu reconstructions", (unsigned long long)c.reconstructions);
    /* a ray and seven boxes, three planes of each where the entry was complete: below the right
     * child alone; and all four rays and one box */
    CHECK(c.box_tests == 5 * 6 + 6 + 4 * 6, "%llu distances", (unsigned long long)c.box_tests);
    structure_close(s);
    mesh_free(&m);
}

/* ---- memory --------------------------------------------------------------------------------- */

static void bounded_memory(void) {
    static due d;
    random_state r = {5};
    mesh m = {0};
    unsigned could = 0, could_not = 0;
    test("a BPH that memory runs out for says so, gives all back, and can be built later");
    shape_soup(&m, rig_triangles(90, 1), 0.5f, 9);
    make_rays(d.rays, &m, &r);
    CHECK(trace_list(&d, &m), "the list");
    for (uint64_t bytes = 64; could < 3; bytes += bytes / 16) {
        const uint64_t before = heap_used();
        structure_options o;
        fail f = {""}, g = {""};
        const structure_kind *kind = structure_read("bph:counts", "it", &o, &f);
        heap_limit(before + bytes);
        built_structure *s = structure_open(kind, &m, &o, "it", &f);
        const int is_moved = s != NULL && structure_move(s, &m, &f) == 0;
        heap_limit(UINT64_MAX);
        CHECK(is_moved || (strstr(f.text, "out of memory") != NULL && strchr(f.text, ';') != NULL),
              "%s", f.text);
        CHECK(s == NULL || structure_move(s, &m, &g) == 0, "%s", g.text);
        if (s != NULL) {
            trace_by(s, &d, RAYS, 0, "later");
        }
        structure_close(s);
        CHECK(heap_used() == before, "not given back");
        could += is_moved != 0;
        could_not += is_moved == 0;
    }
    CHECK(could_not > 20, "%u limits were too low", could_not);
    mesh_free(&m);
}

int main(void) {
    figure_8_1();
    combinations();
    counts();
    hidden();
    bounded_memory();
    return test_done();
}
