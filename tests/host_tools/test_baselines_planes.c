/* test_baselines_planes - B-KD trees and bounding interval hierarchies hold what is below them
 *
 * Trees are looked through from the root with the boxes that rays are left with; sizes are those of
 * the thesis; splits of the grid are found again with cells that are handed down. Rays start on
 * planes, run along axes and in them, or are hardly rays. That all hits are the engine's, whatever
 * the switches, test_baselines has, too.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/base/binary_halve.h"
#include "host_tools/baselines/base/triangle_set.h"
#include "host_tools/baselines/bih/bih_tree.h"
#include "host_tools/baselines/bkd/bkd_tree.h"
#include "host_tools/baselines/structure.h"
#include "host_tools/pack/pack.h"
#include "tests/reference/grid_scenes.h"
#include "tests/reference/mover.h"

enum { ROUNDS = 30, RAYS = 256 };

/* ---- one view of three layouts --------------------------------------------------------- */

enum layout { SMALL, EXACT, INTERVALS, LAYOUTS };

typedef struct looked {
    enum layout layout;
    bkd_tree bkd;
    bih_tree bih;
    triangle_set set;
    uint8_t *seen; /* of each record: how often */
    int is_new;    /* built of these triangles, not refitted */
} looked;

static int is_leaf(const looked *t, uint32_t link) {
    return t->layout == INTERVALS ? bih_is_leaf(&t->bih, link) : bkd_is_leaf(&t->bkd, link);
}

static uint32_t record_of(const looked *t, uint32_t link) {
    return t->layout == INTERVALS ? bih_leaf_record(&t->bih, link) : bkd_leaf_record(&t->bkd, link);
}

static planes_view view_of(const looked *t, uint32_t link) {
    return t->layout == INTERVALS ? bih_view(&t->bih, link) : bkd_view(&t->bkd, link);
}

/* What is below a link. */
typedef struct below {
    plt_box box;
    uint32_t count;
} below;

static below below_of(const looked *t, uint32_t link) {
    below b = {plt_box_empty(), 0};
    if (is_leaf(t, link)) {
        const plt_record *r = &t->set.record[record_of(t, link)];
        do {
            const plt_box box = plt_record_box(r);
            plt_box_add(&b.box, &box);
            b.count++;
        } while (!plt_record_is_last(r++));
        return b;
    }
    const planes_view v = view_of(t, link);
    for (int c = 0; c < 2; c++) {
        const below child = below_of(t, v.link[c]);
        plt_box_add(&b.box, &child.box);
        b.count += child.count;
    }
    return b;
}

/* ---- planes ---------------------------------------------------------------------------- */

/* How far a plane may be outside: 24 bits have 15 of a fraction. */
static float slack(const looked *t, float plane) {
    return t->layout == SMALL ? ldexpf(fabsf(plane), -15) + 1e-40f : 0.0f;
}

/* Planes that 24 bits hold are not moved. */
static int is_short(float plane) {
    uint32_t bits;
    memcpy(&bits, &plane, sizeof bits);
    return (bits & 0xFFu) == 0;
}

static void check_planes(const looked *t, const planes_view *v, const below of[2]) {
    const uint32_t a = v->axis;
    for (int c = 0; c < 2; c++) {
        const float lo = of[c].box.lo[a], hi = of[c].box.hi[a];
        if (t->layout != INTERVALS || c == 1) {
            CHECK(v->lo[c] <= lo && lo - v->lo[c] <= slack(t, lo), "lo %a of %a", (double)v->lo[c],
                  (double)lo);
        }
        if (t->layout != INTERVALS || c == 0) {
            CHECK(v->hi[c] >= hi && v->hi[c] - hi <= slack(t, hi), "hi %a of %a", (double)v->hi[c],
                  (double)hi);
            CHECK(v->hi[c] == hi || !is_short(hi), "%a was moved", (double)hi);
        }
    }
}

static plt_box left_of(const looked *t, const plt_box *in, const below *own, uint32_t axis, int c) {
    plt_box b = *in;
    b.lo[axis] = t->layout != INTERVALS || c == 1 ? own->box.lo[axis] : b.lo[axis];
    b.hi[axis] = t->layout != INTERVALS || c == 0 ? own->box.hi[axis] : b.hi[axis];
    return b;
}

static float cost_of(const looked *t, const plt_box *in, const below of[2], uint32_t axis) {
    const float at[2] = {of[0].box.lo[axis] + of[0].box.hi[axis],
                         of[1].box.lo[axis] + of[1].box.hi[axis]};
    float sum = 0.0f;
    for (int c = 0; c < 2; c++) {
        const plt_box left = left_of(t, in, &of[c], axis, c ^ (at[0] > at[1]));
        sum += plt_box_half_area(&left) * (float)of[c].count;
    }
    return sum;
}

static float apart(const below of[2], uint32_t axis) {
    return (of[1].box.lo[axis] + of[1].box.hi[axis]) - (of[0].box.lo[axis] + of[0].box.hi[axis]);
}

/* The least cost along its axis, and the lower child first. (Where none is lower, either may have
 * been thought so.) */
static void check_axis(const looked *t, const planes_view *v, const plt_box *in,
                       const below of[2]) {
    const float cost = cost_of(t, in, of, v->axis);
    for (uint32_t a = 0; a < 3; a++) {
        CHECK(cost <= 1.000001f * cost_of(t, in, of, a) || apart(of, a) == 0.0f,
              "axis %u is better than %u", a, v->axis);
    }
    CHECK(apart(of, v->axis) >= 0.0f, "the upper child is first");
}

static void look(looked *t, uint32_t link, const plt_box *in) {
    if (is_leaf(t, link)) {
        const uint32_t first = record_of(t, link), count = below_of(t, link).count;
        for (uint32_t i = first; i < first + count; i++) {
            t->seen[i]++;
        }
        return;
    }
    const planes_view v = view_of(t, link);
    const below of[2] = {below_of(t, v.link[0]), below_of(t, v.link[1])};
    check_planes(t, &v, of);
    if (t->is_new) {
        check_axis(t, &v, in, of);
    }
    for (int c = 0; c < 2; c++) {
        const plt_box left = left_of(t, in, &of[c], v.axis, c);
        look(t, v.link[c], &left);
    }
}

static void look_through(looked *t, const char *what) {
    memset(t->seen, 0, t->set.count);
    look(t, t->layout == INTERVALS ? 0 : t->bkd.root, &t->set.box);
    for (uint32_t i = 0; i < t->set.count; i++) {
        CHECK(t->seen[i] == 1, "%s: record %u is there %u times", what, i, t->seen[i]);
    }
}

/* ---- trees ------------------------------------------------------------------------------ */

static void make(looked *t, const mesh *m, enum layout layout, const binary_options *o) {
    binary_tree b = {.node = NULL};
    memset(t, 0, sizeof *t);
    t->layout = layout;
    t->is_new = 1;
    int status = triangle_set_fill(&t->set, m);
    t->seen = malloc(t->set.count + 1);
    if (status == 0) {
        status = binary_tree_build(&b, t->set.record, t->set.count, &t->set.box, o);
    }
    if (status == 0) {
        status = layout == INTERVALS ? bih_tree_make(&t->bih, &b)
                                     : bkd_tree_make(&t->bkd, &b, layout == EXACT);
    }
    CHECK(status == 0 && t->seen != NULL, "made");
    binary_tree_free(&b);
}

static void drop(looked *t) {
    bkd_tree_free(&t->bkd);
    bih_tree_free(&t->bih);
    triangle_set_free(&t->set);
    free(t->seen);
}

static void refit(looked *t, const mesh *m) {
    for (uint32_t i = 0; i < t->set.count; i++) {
        plt_record *r = &t->set.record[i];
        pack_record(r, m, plt_primitive_id(plt_get_u32(&r->word[9])));
        plt_record_set_last(r, 1);
    }
    t->set.box = plt_records_box(t->set.record, 0, t->set.count);
    t->is_new = 0;
    CHECK(bkd_tree_refit(&t->bkd, t->set.record) == 0, "refitted");
}

static const binary_options ways[] = {{.splits = PLT_SPLIT_MEDIAN, .leaf = 1},
                                      {.splits = PLT_SPLIT_SAH, .leaf = 1},
                                      {.splits = PLT_SPLIT_SAH, .leaf = 1, .by_grid = 1}};

static void planes_hold(void) {
    random_state r = {4711};
    test("planes hold what is below, axes cost least, every triangle is there once; refitted, too");
    for (unsigned i = 0; i < ROUNDS; i++) {
        mesh m = {0};
        grid_scene_make(&m, &r);
        mesh moved = shape_copy(&m);
        mover_deform(&moved, i % MOVER_WAYS);
        for (unsigned layout = 0; layout < LAYOUTS && m.triangles > 0; layout++) {
            looked t;
            binary_options o = ways[i % 3];
            o.leaf = (uint8_t)(layout == INTERVALS ? 1 + i % 4 : 1);
            make(&t, &m, (enum layout)layout, &o);
            look_through(&t, "new");
            if (layout != INTERVALS) {
                refit(&t, &moved);
                look_through(&t, "moved");
                refit(&t, &m);
                look_through(&t, "back");
            }
            drop(&t);
        }
        mesh_free(&moved);
        mesh_free(&m);
    }
}

/* ---- sizes ------------------------------------------------------------------------------ */

static structure_statistics count_of(const mesh *m, const char *spec) {
    structure_options o;
    structure_statistics q = {.rays = 0};
    fail f = {""};
    const structure_kind *kind = structure_read(spec, "it", &o, &f);
    built_structure *s = kind != NULL ? structure_open(kind, m, &o, "it", &f) : NULL;
    CHECK(s != NULL, "%s: %s", spec, f.text);
    if (s != NULL) {
        q = structure_count(s);
        CHECK(q.bytes == q.thesis_bytes, "%s: as the thesis counts", spec);
    }
    structure_close(s);
    return q;
}

static void sizes(void) {
    test("n triangles take 32 n - 16 bytes of a B-KD tree, 24 n - 24 exact, 16 n - 12 of a BIH");
    for (uint32_t n = 0; n < 70; n = n < 4 ? n + 1 : n * 4) {
        mesh m = {0};
        if (n > 0) {
            shape_soup(&m, n, 0.5f, n);
        }
        CHECK(count_of(&m, "bkd").bytes == (n > 0 ? 32 * n - 16 : 0), "%u", n);
        CHECK(count_of(&m, "bkd:sah").bytes == (n > 0 ? 32 * n - 16 : 0), "%u", n);
        CHECK(count_of(&m, "bkd:exact").bytes == (n > 0 ? 24 * n - 24 : 0), "%u", n);
        CHECK(count_of(&m, "bih").bytes == (n > 0 ? 16 * n - 12 : 0), "%u", n);
        const structure_statistics q = count_of(&m, "bih:leaf-4");
        CHECK(q.leaves <= n && 4 * q.leaves >= n && q.nodes + (n > 0) == q.leaves, "%u", n);
        CHECK(q.bytes == (n > 0 ? 16 * q.leaves - 12 : 0), "%u", n);
        CHECK(n < 16 || q.leaves < n, "%u", n);
        mesh_free(&m);
    }
}

/* ---- the grid ----------------------------------------------------------------------------- */

static float centre_of(const plt_record *r, int axis) {
    const plt_box b = plt_record_box(r);
    return b.lo[axis] + 0.5f * (b.hi[axis] - b.lo[axis]);
}

static uint32_t below_plane(const triangle_set *s, uint32_t begin, uint32_t end, int axis,
                            float at) {
    uint32_t count = 0;
    for (uint32_t i = begin; i < end; i++) {
        count += centre_of(&s->record[i], axis) < at;
    }
    return count;
}

/* Splits a range whose cell of the grid is handed down, as the paper says it, and each half. */
static void halve(triangle_set *s, plt_split_bins *bins, uint32_t begin, uint32_t end, plt_box cell,
                  uint32_t depth) {
    for (unsigned steps = 0; end - begin > 1; steps++) {
        const int x = cell.hi[0] - cell.lo[0] >= cell.hi[1] - cell.lo[1] ? 0 : 1;
        const int axis = cell.hi[2] - cell.lo[2] > cell.hi[x] - cell.lo[x] ? 2 : x;
        const float at = cell.lo[axis] + 0.5f * (cell.hi[axis] - cell.lo[axis]);
        const uint32_t low = below_plane(s, begin, end, axis, at);
        if (!(cell.lo[axis] < at && at < cell.hi[axis]) || steps > 60 ||
            plt_levels_needed(end - begin, 1) + depth >= PLT_DEPTH_MAX) {
            return; /* no float between, or no depth left: by count */
        }
        if (low == 0 || low == end - begin) {
            (low == 0 ? cell.lo : cell.hi)[axis] = at;
            continue;
        }
        const plt_split_range range = {begin, end, depth, 1, PLT_SPLIT_SAH};
        plt_record_items items = {s->record, bins};
        const plt_box box = plt_records_box(s->record, begin, end);
        plt_box half[2], lower = cell, upper = cell;
        const uint32_t middle = binary_halve(&items, &range, &s->box, &box, half);
        CHECK(middle - begin == low, "%u of %u, not %u", middle - begin, end - begin, low);
        CHECK(below_plane(s, begin, middle, axis, at) == low, "others");
        const plt_box left = plt_records_box(s->record, begin, middle);
        CHECK(memcmp(&left, &half[0], sizeof left) == 0, "the left box");
        lower.hi[axis] = upper.lo[axis] = at;
        halve(s, bins, begin, middle, lower, depth + 1);
        halve(s, bins, middle, end, upper, depth + 1);
        return;
    }
}

static void grids(void) {
    random_state r = {99};
    plt_split_bins *bins = heap_get_aligned(sizeof *bins);
    test("splits by the global heuristic are those of cells that are handed down");
    for (unsigned i = 0; i < ROUNDS; i++) {
        mesh m = {0};
        triangle_set s = {.record = NULL};
        grid_scene_make(&m, &r);
        CHECK(triangle_set_fill(&s, &m) == 0, "filled");
        halve(&s, bins, 0, s.count, s.box, 0);
        triangle_set_free(&s);
        mesh_free(&m);
    }
    heap_drop(bins);
}

/* ---- rays --------------------------------------------------------------------------------- */

/* From corners, or beside them by as little as there is, along one axis or two, both ways. */
static void make_rays(plt_ray *rays, const mesh *m, random_state *r) {
    for (uint32_t i = 0; i < RAYS; i++) {
        plt_ray *to = &rays[i];
        const float scale = ldexpf(1.0f, (int)random_below(r, 100) - 50);
        memset(to, 0, sizeof *to);
        for (int a = 0; a < 3; a++) {
            const float *p =
                shape_corner(m, random_below(r, (uint32_t)m->triangles), random_below(r, 3));
            to->org[a] =
                random_below(r, 4) ? p[a] : nextafterf(p[a], random_below(r, 2) ? 1e9f : -1e9f);
            to->dir[a] = random_below(r, 2) ? 0.0f : random_below(r, 2) ? -scale : scale;
            to->dir[a] = to->dir[a] == 0.0f && random_below(r, 2) ? -0.0f : to->dir[a];
        }
        to->tmin = random_below(r, 4) ? 0.0f : -1e30f;
        to->tmax = random_below(r, 4) ? RAYS_FAR : 0.0f;
        if (random_below(r, 16) == 0) {
            to->dir[random_below(r, 3)] = random_below(r, 2) ? NAN : INFINITY;
        }
    }
}

static void compare(const mesh *m, const char *spec, const plt_ray *rays, plt_hit due[2][RAYS]) {
    structure_options o;
    plt_hit got[RAYS];
    fail f = {""};
    const structure_kind *kind = structure_read(spec, "it", &o, &f);
    built_structure *s = kind != NULL ? structure_open(kind, m, &o, "it", &f) : NULL;
    CHECK(s != NULL, "%s: %s", spec, f.text);
    for (int any = 0; any < 2 && s != NULL; any++) {
        CHECK(structure_trace(s, rays, got, RAYS, any, &f) == 0, "%s", f.text);
        for (uint32_t i = 0; i < RAYS; i++) {
            CHECK(memcmp(&got[i], &due[any][i], sizeof got[i]) == 0,
                  "%s: ray %u, any %d: %u at %a, not %u at %a", spec, i, any, got[i].triangle,
                  (double)got[i].t, due[any][i].triangle, (double)due[any][i].t);
        }
    }
    structure_close(s);
}

static void nasty_rays(void) {
    static const char *const specs[] = {"bkd",
                                        "bkd:single",
                                        "bkd:exact,sah,single",
                                        "bih",
                                        "bih:single",
                                        "bih:sah,leaf-3,single",
                                        "bkd:2x2",
                                        "bih:2x2,boxes,early,frustum,range"};
    const rig_config list = rig_config_of(2, 64, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    random_state r = {31};
    uint32_t hits = 0;
    test("rays on planes and along axes, of any length, or of none: the hits of a list");
    for (unsigned i = 0; i < ROUNDS; i++) {
        static plt_ray rays[RAYS];
        static plt_hit due[2][RAYS];
        mesh m = {0};
        rig x;
        if (i % 3 == 0) {
            shape_cube(&m);
        } else if (i % 3 == 1) {
            shape_sheet(&m, rig_is_tiny() ? 2 : 8, (int)(i / 3 % 3));
        } else {
            shape_soup(&m, rig_triangles(60, 1), 0.5f, i);
        }
        make_rays(rays, &m, &r);
        CHECK(rig_open(&x, &m, &list) == PLT_OK, "%s", x.fault.message);
        for (int any = 0; any < 2; any++) {
            CHECK(plt_trace(x.engine, rays, due[any], RAYS, any) == PLT_OK, "the list");
        }
        rig_close(&x);
        for (uint32_t k = 0; k < RAYS; k++) {
            hits += due[0][k].triangle != PLT_MISS;
        }
        for (unsigned k = 0; k < sizeof specs / sizeof *specs; k++) {
            compare(&m, specs[k], rays, due);
        }
        mesh_free(&m);
    }
    CHECK(hits > ROUNDS * RAYS / 16, "%u hits", hits);
}

/* ---- counts -------------------------------------------------------------------------------- */

static structure_statistics traced(const mesh *m, const char *spec, const plt_ray *rays,
                                   uint32_t at_once) {
    structure_options o;
    plt_hit hits[RAYS];
    structure_statistics q = {.rays = 0};
    fail f = {""};
    const structure_kind *kind = structure_read(spec, "it", &o, &f);
    built_structure *s = kind != NULL ? structure_open(kind, m, &o, "it", &f) : NULL;
    CHECK(s != NULL, "%s: %s", spec, f.text);
    for (uint32_t i = 0; i < RAYS && s != NULL; i += at_once) {
        CHECK(structure_trace(s, rays + i, hits + i, at_once, 0, &f) == 0, "%s", f.text);
    }
    if (s != NULL) {
        q = structure_count(s);
    }
    structure_close(s);
    return q;
}

static int is_about(uint64_t a, uint64_t b) {
    return a <= b + b / 20 + 4 && b <= a + a / 20 + 4;
}

/* The same planes clip both, by the same numbers. Lone rays are clipped by others, hardly so. */
static void counts(void) {
    static const char *const kinds[] = {"bkd", "bkd:exact,sah", "bih", "bih:median,leaf-3"};
    random_state r = {8};
    test("intervals and boxes come to the same nodes and triangles, and lone rays to nearly those");
    for (unsigned i = 0; i < 4 * ROUNDS / 5; i++) {
        static plt_ray rays[RAYS];
        char rest[64], room[64], lone[64];
        const char *kind = kinds[i % 4], *more = strchr(kind, ':') != NULL ? "," : ":";
        mesh m = {0};
        shape_soup(&m, rig_triangles(400, 1), 0.1f, i);
        rays_camera(rays, RAYS, &m, &r);
        snprintf(rest, sizeof rest, "%s%s2x2", kind, more);
        snprintf(room, sizeof room, "%s%s2x2,boxes", kind, more);
        snprintf(lone, sizeof lone, "%s%ssingle", kind, more);
        const structure_statistics a = traced(&m, rest, rays, RAYS),
                                   b = traced(&m, room, rays, RAYS);
        CHECK(a.packet_nodes > 0 && a.packet_nodes == b.packet_nodes, "%s: %llu and %llu nodes",
              kind, (unsigned long long)a.packet_nodes, (unsigned long long)b.packet_nodes);
        CHECK(a.packet_triangles == b.packet_triangles && a.masked_at_nodes == b.masked_at_nodes &&
                  a.masked_at_triangles == b.masked_at_triangles,
              "%s: triangles, or rays", kind);
        const structure_statistics one = traced(&m, rest, rays, 1), c = traced(&m, lone, rays, 1);
        CHECK(is_about(one.node_visits, c.node_visits), "%s: %llu and %llu visits", kind,
              (unsigned long long)one.node_visits, (unsigned long long)c.node_visits);
        CHECK(is_about(one.packet_triangles, c.triangle_tests), "%s: tests", kind);
        mesh_free(&m);
    }
}

/* ---- treelets ------------------------------------------------------------------------------ */

static void treelets(void) {
    static const char *const forms[][3] = {{"bvh-treelets:4x4", "bvh:4x4", "56"},
                                           {"bkd-treelets:4x4", "bkd:exact,4x4", "24"},
                                           {"bih-treelets:4x4", "bih:4x4", "16"}};
    static const char *const sizes[] = {"tl2", "tl7", "tl16"};
    static const uint32_t counts[] = {2, 7, 16};
    uint64_t depth = 0, figure = 0, plain = 0;
    random_state r = {12};
    test(
        "other trees in treelets: at most an eighth of slots is free, and depth first costs no "
        "nodes");
    for (unsigned i = 0; i < 9; i++) {
        static plt_ray rays[RAYS];
        char one[64], other[64];
        mesh m = {0};
        shape_soup(&m, rig_triangles(400, 1), 0.1f, i);
        rays_camera(rays, RAYS, &m, &r);
        snprintf(one, sizeof one, "%s,%s,depth", forms[i % 3][0], sizes[i / 3]);
        snprintf(other, sizeof other, "%s,%s", forms[i % 3][0], sizes[i / 3]);
        const structure_statistics a = traced(&m, one, rays, RAYS),
                                   b = traced(&m, other, rays, RAYS),
                                   c = traced(&m, forms[i % 3][1], rays, RAYS);
        const uint64_t node = (uint64_t)atoi(forms[i % 3][2]), block = node * counts[i / 3];
        CHECK(a.nodes == m.triangles - 1 && a.leaves == m.triangles, "%s: nodes", one);
        CHECK(a.bytes % block == 0 && a.bytes >= a.nodes * node, "%s: bytes", one);
        CHECK(a.bytes < a.nodes * node * 9 / 8 + block, "%s: %llu bytes", one,
              (unsigned long long)a.bytes);
        depth += i % 3 > 0 ? a.packet_nodes : 0;
        figure += i % 3 > 0 ? b.packet_nodes : 0;
        plain += i % 3 > 0 ? c.packet_nodes : 0;
        mesh_free(&m);
    }
    CHECK(is_about(depth, plain), "%llu nodes, %llu", (unsigned long long)depth,
          (unsigned long long)plain);
    CHECK(figure > depth || rig_is_tiny(), "%llu nodes in the thesis's order",
          (unsigned long long)figure);
}

/* ---- switches ------------------------------------------------------------------------------ */

static void check_refused(const char *spec, const char *said) {
    structure_options o;
    fail f = {""};
    CHECK(structure_read(spec, "it", &o, &f) == NULL && strstr(f.text, said) != NULL, "%s: %s",
          spec, f.text);
}

static void switches(void) {
    test("switches that make no sense together say which would");
    check_refused("bkd:early", "are for boxes; leave them out, or give boxes");
    check_refused("bih:intervals,range", "are for boxes; leave them out, or give boxes");
    check_refused("bih:single,boxes", "nothing of rays one by one; leave it out");
    check_refused("bkd:leaf-2", "no switch 'leaf-2'");
    check_refused("bkd:boxes,intervals", "give one of intervals or boxes");
}

int main(void) {
    planes_hold();
    sizes();
    grids();
    nasty_rays();
    counts();
    treelets();
    switches();
    return test_done();
}
