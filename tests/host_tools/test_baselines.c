/* test_baselines - every structure against a list of all triangles, bit for bit
 *
 * The list is the engine's own, without a tree; some of its hits are judged in double as well
 * (reference/brute.h). Scenes are flat, thin, huge, tiny, crowded, of no area, of no triangle, or
 * have moved; rays start anywhere, graze triangles, run along axes, or are no rays.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/structure.h"
#include "host_tools/pack/pack.h"
#include "tests/reference/brute.h"
#include "tests/reference/grid_scenes.h"
#include "tests/reference/mover.h"

enum { RAYS = 200, ROUNDS = 24, SOAK = 100 };

static const structure_options by_rays = {.one_by_one = 1}, by_few = {.packet_side = 2},
                               by_many = {.packet_side = 0};

/* ---- rays -------------------------------------------------------------------------- */

/* Nearly in the plane of a triangle, towards a point of it or beside it, from near or far. */
static void rays_grazing(plt_ray *rays, uint32_t count, const mesh *m, random_state *r) {
    float lo[3], hi[3], size = 0.0f;
    shape_box(m, lo, hi);
    for (int a = 0; a < 3; a++) {
        size = fmaxf(size, hi[a] - lo[a]);
    }
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t triangle = random_below(r, (uint32_t)m->triangles);
        const float *p = shape_corner(m, triangle, 0), *q = shape_corner(m, triangle, 1),
                    *s = shape_corner(m, triangle, 2);
        const float u = random_float(r, -0.1f, 1.0f), v = random_float(r, -0.1f, 1.0f);
        const float off = ldexpf(size, -4 - (int)random_below(r, 18));
        const float along = ldexpf(1.0f, (int)random_below(r, 6)) * random_float(r, -2.0f, 2.0f);
        float to[3], from[3];
        for (int a = 0; a < 3; a++) {
            to[a] = p[a] + u * (q[a] - p[a]) + v * (s[a] - p[a]);
            from[a] = to[a] + along * (q[a] - s[a]) + 3.0f * along * (q[a] - p[a]) +
                      off * random_float(r, -1.0f, 1.0f);
        }
        rays[i] = ray_between(from, to);
        rays[i].tmax = random_below(r, 4) ? RAYS_FAR : random_float(r, 0.9f, 1.1f);
        rays[i].tmin = random_below(r, 4) ? 0.0f : random_float(r, 0.9f, 1.0f);
    }
}

/* From up to 2^12 sizes away. */
static void rays_far(plt_ray *rays, uint32_t count, const mesh *m, random_state *r) {
    rays_edges(rays, count, m, r);
    for (uint32_t i = 0; i < count; i++) {
        const float back = ldexpf(1.0f, (int)random_below(r, 13));
        for (int a = 0; a < 3; a++) {
            rays[i].org[a] -= back * rays[i].dir[a];
        }
        rays[i].tmax = RAYS_FAR;
    }
}

/* What is no ray at all, or an odd one. */
static void make_odd(plt_ray *ray, random_state *r) {
    static const float odd[] = {NAN, INFINITY, -INFINITY, 0.0f, -0.0f, 3e38f, 1e-38f, -1.0f, 1e12f};
    float *of[4] = {&ray->org[random_below(r, 3)], &ray->dir[random_below(r, 3)], &ray->tmin,
                    &ray->tmax};
    *of[random_below(r, 4)] = odd[random_below(r, sizeof odd / sizeof *odd)];
}

/* The first 64 from one point, so that they are a packet now and then. */
static void make_rays(plt_ray *rays, const mesh *m, random_state *r) {
    static void (*const kinds[])(plt_ray *, uint32_t, const mesh *,
                                 random_state *) = {rays_mixed, rays_edges, rays_grazing, rays_far};
    const uint32_t each = (RAYS - 64) / 4;
    memset(rays, 0, RAYS * sizeof *rays);
    rays_camera(rays, 64, m, r);
    for (uint32_t i = 0; i < 4; i++) {
        kinds[i](rays + 64 + i * each, each, m, r);
    }
    for (uint32_t i = 0; i < RAYS / 16; i++) {
        make_odd(&rays[random_below(r, RAYS)], r);
    }
}

/* ---- the comparison ------------------------------------------------------------------ */

typedef struct due {
    plt_ray rays[RAYS];
    plt_hit hits[2][RAYS]; /* nearest, any */
} due;

static uint64_t hits, sieved, strays;

static int make_due(due *d, const mesh *m, random_state *r) {
    const rig_config list = rig_config_of(2, 64, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    rig x;
    if (m->triangles > 0) {
        make_rays(d->rays, m, r);
    }
    const int is_open = rig_open(&x, m, &list) == PLT_OK;
    CHECK(is_open, "%s", x.fault.message);
    for (int any = 0; any < 2 && is_open; any++) {
        CHECK(plt_trace(x.engine, d->rays, d->hits[any], RAYS, any) == PLT_OK, "the list");
    }
    for (uint32_t i = 0; i < RAYS; i++) {
        hits += d->hits[0][i].triangle != PLT_MISS;
    }
    rig_close(&x);
    return is_open;
}

static void compare(built_structure *s, const due *d, const char *name, unsigned scene) {
    static plt_hit got[RAYS];
    for (int any = 0; any < 2; any++) {
        fail f = {""};
        structure_forget(s);
        CHECK(structure_trace(s, d->rays, got, RAYS, any, &f) == 0, "%s: %s", name, f.text);
        for (uint32_t i = 0; i < RAYS; i++) {
            const plt_hit *g = &got[i], *w = &d->hits[any][i];
            const int is_same = memcmp(g, w, sizeof *g) == 0;
            CHECK(is_same, "scene %u, %s, ray %u, any %d: %u at %a, not %u at %a", scene, name, i,
                  any, g->triangle, (double)g->t, w->triangle, (double)w->t);
        }
        const structure_statistics q = structure_count(s);
        sieved += q.sieved;
        strays += q.strays;
    }
}

/* What is counted of packets; nothing of those that have none. */
static void check_packets(const structure_statistics *q, const mesh *m, const char *name) {
    CHECK(q->packets <= q->rays && q->one_sign <= q->packets, "%s: packets", name);
    CHECK(q->masked_at_nodes <= q->rays_at_nodes, "%s: masked at nodes", name);
    CHECK(q->masked_at_triangles <= q->rays_at_triangles, "%s: masked at triangles", name);
    CHECK(q->packet_nodes <= q->rays_at_nodes, "%s: rays at nodes", name);
    CHECK(q->packet_triangles <= q->rays_at_triangles, "%s: rays at triangles", name);
    const uint64_t again = 2 * q->packet_nodes + q->packets + q->recomputed; /* what has waited */
    const uint64_t boxes = 2 * q->packet_nodes + (q->plane_matches > 0 ? again : 0);
    CHECK(q->early_hits + q->frustum_misses <= boxes, "%s: short cuts", name);
    CHECK(q->packets == 0 || q->unsplit > 0 || q->references >= m->triangles, "%s: references",
          name);
}

static void check_counts(const built_structure *s, const mesh *m, const char *name) {
    const structure_statistics q = structure_count(s);
    check_packets(&q, m, name);
    const int is_kd = strncmp(name, "kd", 2) == 0;
    CHECK(q.rays > 0 && q.bytes + q.triangle_bytes >= 40 * m->triangles, "%s: counts", name);
    CHECK(!is_kd || q.unsplit > 0 || q.leaves <= q.nodes + 1, "%s: leaves", name);
    CHECK(!is_kd || strcmp(name, "kd-lazy") == 0 || q.unsplit == 0, "%s: not whole", name);
    CHECK(strcmp(name, "kd") == 0 || q.strays == 0, "%s: strays", name);
}

/* Of each group of switches one, or none. */
static structure_options choose(const structure_kind *kind, random_state *r) {
    structure_options o = {.packet_side = 0};
    for (const structure_switch *s = structure_switches(kind); s->name != NULL; s++) {
        if (random_below(r, 2)) {
            o.choice[s->group] = s->value;
        }
    }
    o.packet_side = o.choice[STRUCTURE_SIDE] > 1 ? o.choice[STRUCTURE_SIDE] : 0;
    o.packet_side = o.packet_side <= PLT_PACKET_SIDE_MAX ? o.packet_side : PLT_PACKET_SIDE_MAX;
    o.one_by_one = o.choice[STRUCTURE_SIDE] == 1;
    return o;
}

static int are_suited(const structure_kind *kind, const structure_options *o) {
    fail f = {""};
    return structure_suits(kind, o, &f) == 0;
}

/* One kind, opened with the mesh and moved to others: as it is by itself, and by its switches. */
static void run_kind(const structure_kind *kind, const mesh *m, const mesh *moved,
                     const due *before, const due *after, unsigned scene) {
    const char *name = structure_name(kind);
    const int has_own = structure_switches(kind)->group != STRUCTURE_SIDE;
    random_state r = {scene + 9};
    for (int way = 0; way < (has_own ? 6 : 2); way++) {
        fail f = {""};
        const structure_options o = way == 0    ? by_rays
                                    : way > 1   ? choose(kind, &r)
                                    : scene % 2 ? by_few
                                                : by_many;
        if (!are_suited(kind, &o)) {
            continue;
        }
        built_structure *s = structure_open(kind, m, &o, "it", &f);
        CHECK(s != NULL || rig_is_tiny(), "scene %u, %s: %s", scene, name, f.text);
        if (s == NULL) {
            continue;
        }
        compare(s, before, name, scene);
        check_counts(s, m, name);
        CHECK(structure_move(s, moved, &f) == 0, "%s: %s", name, f.text);
        compare(s, after, name, scene);
        CHECK(structure_move(s, m, &f) == 0, "%s: %s", name, f.text);
        compare(s, before, name, scene);
        structure_close(s);
    }
}

static int is_too_far(const mesh *m) {
    int is_far = 0;
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        is_far |= fabsf(m->vertex[i]) > PLT_COORD_MAX;
    }
    return is_far;
}

static void run(mesh *m, unsigned way, random_state *r, unsigned scene) {
    static due before, after;
    mesh moved = shape_copy(m);
    mover_deform(&moved, way);
    if (is_too_far(&moved)) {
        memcpy(moved.vertex, m->vertex, 12 * m->vertices);
    }
    if (make_due(&before, m, r) && make_due(&after, &moved, r)) {
        for (const structure_kind *const *kind = structure_kinds(); *kind != NULL; kind++) {
            run_kind(*kind, m, &moved, &before, &after, scene);
        }
    }
    mesh_free(&moved);
    mesh_free(m);
}

/* ---- scenes -------------------------------------------------------------------------- */

static void random_scenes(int is_soak) {
    random_state r = {20061};
    test("random scenes of every kind: all structures have the hits of a list");
    for (unsigned i = 0; i < (is_soak ? ROUNDS * SOAK : ROUNDS); i++) {
        mesh m = {0};
        grid_scene_make(&m, &r);
        run(&m, i % MOVER_WAYS, &r, i);
    }
    CHECK(hits > ROUNDS * RAYS / 8, "%llu hits", (unsigned long long)hits);
    CHECK(strays > 0 && sieved > 0, "no strays");
}

static void named_scenes(void) {
    random_state r = {77};
    test("no triangle, one, a cube, needles, all coincident, of no area, exponential, sheets");
    for (unsigned i = 0; i < 10; i++) {
        mesh m = {0};
        static due nothing;
        switch (i) {
        case 0:
            memset(&nothing, 0, sizeof nothing);
            break;
        case 1:
            shape_soup(&m, 1, 1.0f, 3);
            break;
        case 2:
            shape_cube(&m);
            break;
        case 3:
            shape_needles(&m, rig_triangles(90, 1) / 2);
            break;
        case 4:
            shape_coincident(&m, rig_triangles(200, 1) / 2);
            break;
        case 5:
            shape_degenerate(&m);
            break;
        case 6:
            shape_exponential(&m, 60);
            break;
        default:
            shape_sheet(&m, rig_is_tiny() ? 2 : 14, (int)i - 7);
        }
        run(&m, i % MOVER_WAYS, &r, 1000 + i);
    }
}

/* ---- memory ------------------------------------------------------------------------- */

/* Traces with no more than `bytes` beyond what there is; 1: it could. */
static int trace_within(const structure_kind *kind, const mesh *m, const due *d, uint64_t bytes) {
    static plt_hit got[RAYS];
    const uint64_t before = heap_used();
    fail f = {""};
    heap_limit(before + bytes);
    built_structure *s = structure_open(kind, m, &by_rays, "it", &f);
    const int could = s != NULL && structure_trace(s, d->rays, got, RAYS, 0, &f) == 0;
    heap_limit(UINT64_MAX);
    CHECK(could == (f.text[0] == 0), "%s: %s", structure_name(kind), f.text);
    if (could) {
        CHECK(memcmp(got, d->hits[0], sizeof got) == 0, "%s: hits", structure_name(kind));
    } else {
        CHECK(strstr(f.text, "out of memory") != NULL && strchr(f.text, ';') != NULL, "%s", f.text);
    }
    if (s != NULL && !could) { /* no tree, until there is one again */
        fail g = {""};
        CHECK(structure_trace(s, d->rays, got, RAYS, 0, &g) != 0, "traced without a tree");
        fail h = {""};
        CHECK(structure_move(s, m, &h) == 0, "%s", h.text);
        compare(s, d, structure_name(kind), 2000);
    }
    structure_close(s);
    CHECK(heap_used() == before, "%s: not given back", structure_name(kind));
    return could;
}

static void bounded_memory(void) {
    static const char *const names[] = {"kd",       "kd-boxes",     "kd-fast", "kd-lazy",
                                        "bvh",      "wbvh",         "bkd",     "bih",
                                        "treelets", "bih-treelets", "bph",     "bkd-treelets"};
    static due d;
    random_state r = {5};
    mesh m = {0};
    test("structures that memory runs out for say so, give all back, and can be built later");
    shape_soup(&m, rig_triangles(90, 1), 0.5f, 9);
    CHECK(make_due(&d, &m, &r), "the list");
    for (unsigned i = 0; i < sizeof names / sizeof *names; i++) {
        unsigned could = 0, could_not = 0;
        for (uint64_t bytes = 64; could < 3; bytes += bytes / 16) {
            const int is_done = trace_within(structure_find(names[i]), &m, &d, bytes);
            could += is_done != 0;
            could_not += is_done == 0;
        }
        CHECK(could_not > 20, "%s: %u limits were too low", names[i], could_not);
    }
    mesh_free(&m);
}

static void refusals(void) {
    static const structure_options o = {.packet_side = 0};
    mesh m = {0}, n = {0};
    fail f = {""};
    test("another number of triangles is not a move, and no other name is a structure");
    shape_cube(&m);
    shape_cube(&n);
    n.triangles--;
    CHECK(structure_find("kd-tree") == NULL && structure_find("") == NULL, "found");
    for (const structure_kind *const *kind = structure_kinds(); *kind != NULL; kind++) {
        built_structure *s = structure_open(*kind, &m, &o, "it", &f);
        CHECK(structure_find(structure_name(*kind)) == *kind, "not found by its name");
        CHECK(structure_about(*kind)[0] != 0, "nothing about it");
        CHECK(s != NULL || rig_is_tiny(), "%s", f.text);
        if (s != NULL) {
            fail g = {""};
            CHECK(structure_move(s, &n, &g) != 0 && strstr(g.text, "12") != NULL, "%s", g.text);
        }
        structure_close(s);
    }
    mesh_free(&m);
    mesh_free(&n);
}

/* ---- hierarchies ------------------------------------------------------------------------ */

static structure_statistics count_of(const char *text, const mesh *m) {
    structure_options o;
    fail f = {""};
    structure_statistics none;
    memset(&none, 0, sizeof none);
    const structure_kind *kind = structure_read(text, "it", &o, &f);
    CHECK(kind != NULL, "%s", f.text);
    built_structure *s = kind != NULL ? structure_open(kind, m, &o, "it", &f) : NULL;
    CHECK(s != NULL, "%s", f.text);
    const structure_statistics q = s != NULL ? structure_count(s) : none;
    structure_close(s);
    return q;
}

/* The engine's tree of the same splits: nodes of the BPH, and its lists. */
static void check_against_bph(const mesh *m, uint8_t splits, uint8_t leaf, const char *text) {
    const pack_options o = {
        .leaf_triangles = leaf, .treelet_nodes = 1, .splits = splits, .build = PLT_BUILD_HOST};
    packed image = {0};
    fail f = {""};
    CHECK(pack_mesh(&image, m, &o, "it", &f) == 0, "%s", f.text);
    const structure_statistics q = count_of(text, m);
    const uint32_t lists = image.info.leaf_lists + image.info.intermediate_lists;
    CHECK(q.nodes == image.info.nodes, "%s: %u nodes, not %u", text, q.nodes, image.info.nodes);
    CHECK(q.leaves == q.nodes + 1 && lists > q.nodes, "%s: %u lists", text, q.leaves);
    CHECK(q.thesis_bytes == 84 * (uint64_t)q.nodes, "%s: bytes", text);
    pack_free(&image);
}

static void hierarchies(void) {
    static const uint32_t sizes[] = {1, 2, 3, 5, 12, 60, 300};
    test("the thesis's hierarchy has the nodes of its BPH; by cost leaves have 1 to 4 triangles");
    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        mesh m = {0};
        shape_soup(&m, rig_triangles(sizes[i], 1), 0.2f, 40 + i);
        check_against_bph(&m, PLT_SPLIT_MEDIAN, 1, "bvh");
        check_against_bph(&m, PLT_SPLIT_SAH, 1, "bvh:sah");
        check_against_bph(&m, PLT_SPLIT_MEDIAN, 2, "bvh:leaf-2");
        const uint32_t n = (uint32_t)m.triangles;
        const structure_statistics one = count_of("wbvh:leaf-1,median", &m),
                                   four = count_of("wbvh", &m);
        CHECK(one.leaves == n && one.nodes == n - 1, "one: %u leaves", one.leaves);
        CHECK(one.bytes == 32 * (2 * (uint64_t)n - 1), "one: bytes");
        CHECK(4 * four.leaves >= n && (n < 60 || four.leaves < n), "four: %u", four.leaves);
        CHECK(four.nodes + 1 == four.leaves && four.references == n, "four: nodes");
        mesh_free(&m);
    }
}

/* Rays side by side from one point to a square, which a packet is the same as. */
static void counted(void) {
    static plt_ray rays[64];
    static plt_hit got[64];
    mesh m = {0};
    structure_options o;
    fail f = {""};
    test("of a packet that meets two triangles' boxes all visits, tests and masks are known");
    const float corners[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 4, 0, 0, 5, 0, 0, 4, 1, 0};
    CHECK(mesh_reserve(&m, 6, 2, &f) == 0, "%s", f.text);
    memcpy(m.vertex, corners, sizeof corners);
    for (unsigned i = 0; i < 6; i++) {
        m.triangle[i] = i;
    }
    m.vertices = 6;
    m.triangles = 2;
    for (unsigned i = 0; i < 64; i++) { /* groups 0 to 7 over the first box, the others beside it */
        const float x = i < 32 ? 0.5f : 2.5f;
        rays[i] = (plt_ray){.org = {x, 0.1f, 9.0f}, .dir = {0.0f, 0.0f, -1.0f}, .tmax = 99.0f};
    }
    const structure_kind *kind = structure_read("wbvh:leaf-1,no-early,8x8", "it", &o, &f);
    built_structure *s = kind != NULL ? structure_open(kind, &m, &o, "it", &f) : NULL;
    CHECK(s != NULL && structure_trace(s, rays, got, 64, 0, &f) == 0, "%s", f.text);
    const structure_statistics q = structure_count(s);
    const int is_whole = !rig_is_tiny();
    CHECK(got[0].triangle == 0 && got[63].triangle == PLT_MISS, "hits");
    CHECK(!is_whole || (q.packets == 1 && q.one_sign == 1), "packets");
    CHECK(!is_whole || q.packet_nodes == 3, "%u nodes", (unsigned)q.packet_nodes);
    CHECK(!is_whole || q.packet_triangles == 1, "%u triangles", (unsigned)q.packet_triangles);
    CHECK(!is_whole || (q.rays_at_nodes == 192 && q.masked_at_nodes == 0), "%u masked",
          (unsigned)q.masked_at_nodes);
    CHECK(!is_whole || (q.rays_at_triangles == 64 && q.masked_at_triangles == 32), "%u masked",
          (unsigned)q.masked_at_triangles);
    CHECK(!is_whole || (q.frustum_misses == 1 && q.early_hits == 0), "short cuts");
    CHECK(!is_whole || q.triangle_tests == 8, "%u tests", (unsigned)q.triangle_tests);
    structure_close(s);
    mesh_free(&m);
}

/* A packet of 6 rays, whose second group has two. */
static void counted_odd(void) {
    static plt_ray rays[6];
    plt_hit got[6];
    mesh m = {0};
    structure_options o;
    fail f = {""};
    test("of a packet whose last group is not full no more rays are counted than there are");
    shape_cube(&m);
    for (unsigned i = 0; i < 6; i++) {
        rays[i] = (plt_ray){.org = {0.0f, 0.1f, 9.0f}, .dir = {0.0f, 0.0f, -1.0f}, .tmax = 99.0f};
    }
    for (unsigned i = 0; i < 2; i++) {
        const char *text = i == 0 ? "wbvh:leaf-1,range,8x8" : "wbvh:leaf-1,bits,8x8";
        const structure_kind *kind = structure_read(text, "it", &o, &f);
        built_structure *s = kind != NULL ? structure_open(kind, &m, &o, "it", &f) : NULL;
        CHECK(s != NULL && structure_trace(s, rays, got, 6, 0, &f) == 0, "%s", f.text);
        const structure_statistics q = structure_count(s);
        CHECK(got[0].triangle != PLT_MISS && got[5].triangle == got[0].triangle, "hits");
        CHECK(q.rays_at_triangles > 0 && q.masked_at_triangles == 0, "%s: %llu masked", text,
              (unsigned long long)q.masked_at_triangles);
        CHECK(q.rays_at_nodes > 0 && q.masked_at_nodes == 0, "%s: %llu masked at nodes", text,
              (unsigned long long)q.masked_at_nodes);
        CHECK(rig_is_tiny() || q.rays_at_triangles == 6 * q.packet_triangles, "%s: rays", text);
        structure_close(s);
    }
    mesh_free(&m);
}

/* ---- words ---------------------------------------------------------------------------- */

static void check_word(const char *text, const char *said) {
    structure_options o;
    fail f = {""};
    const structure_kind *kind = structure_read(text, "it", &o, &f);
    CHECK(kind == NULL && strstr(f.text, said) != NULL, "%s: %s", text, f.text);
}

/* What the first kind that has it says of a switch. */
static const char *meaning_of(const char *name) {
    for (const structure_kind *const *k = structure_kinds(); *k != NULL; k++) {
        for (const structure_switch *s = structure_switches(*k); s->name != NULL; s++) {
            if (strcmp(s->name, name) == 0) {
                return s->about;
            }
        }
    }
    return "";
}

static void meanings(void) {
    test("a switch means the same for every kind that has it");
    for (const structure_kind *const *k = structure_kinds(); *k != NULL; k++) {
        for (const structure_switch *s = structure_switches(*k); s->name != NULL; s++) {
            const char *first = meaning_of(s->name);
            CHECK(strcmp(first, s->about) == 0, "%s:%s: \"%s\", not \"%s\"", structure_name(*k),
                  s->name, s->about, first);
            CHECK(s->group < STRUCTURE_CHOICES && s->value > 0, "%s:%s", structure_name(*k),
                  s->name);
        }
    }
}

static void words(void) {
    structure_options o = {.packet_side = 9};
    fail f = {""};
    test("names and switches are read, and what does not go says what does");
    CHECK(structure_read("kd", "it", &o, &f) == structure_find("kd"), "%s", f.text);
    CHECK(o.one_by_one == 1 && o.packet_side == 0, "kd: rays go one by one");
    CHECK(structure_read("kd:4x4", "it", &o, &f) == structure_find("kd"), "%s", f.text);
    CHECK(o.one_by_one == 0 && o.packet_side == 4, "kd: packets");
    CHECK(structure_read("wbvh:bits,leaf-3,16x16", "it", &o, &f) == structure_find("wbvh"), "%s",
          f.text);
    CHECK(o.packet_side == 16 && o.choice[STRUCTURE_LEAF] == 3 &&
              o.choice[STRUCTURE_MASKS] == STRUCTURE_BITS && o.choice[STRUCTURE_SPLITS] == 0,
          "wbvh: switches");
    check_word("wbv", "no structure is called 'wbv'; choose tree, tree-never, ");
    check_word("", "no structure is called ''");
    check_word("wbvh:", "wbvh has no switch ''; choose median, sah, ");
    check_word("wbvh:leaf-1,", "no switch ''");
    check_word("wbvh:leaf-12", "no switch 'leaf-12'");
    check_word("kd:sah", "kd has no switch 'sah'; choose 2x2, 4x4, 8x8 or single");
    check_word("bvh:4x4,sah,8x8",
               "'8x8' is a second choice of one kind; give one of 2x2, 4x4, 8x8 "
               "or 16x16");
    check_word("bvh:sah,sah", "give one of median or sah");
}

int main(int argc, char **argv) {
    const int is_soak = argc > 1 && strcmp(argv[1], "soak") == 0;
    refusals();
    words();
    meanings();
    hierarchies();
    counted();
    counted_odd();
    bounded_memory();
    named_scenes();
    random_scenes(is_soak);
    return test_done();
}
