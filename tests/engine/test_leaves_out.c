/* test_leaves_out - lanes that flush subnormals leave out no group that others would keep
 *
 * Boxes and triangles around 2^-126, of which flushed sums and operands leave groups out, and rays
 * that are set up otherwise: engine code with lanes that keep subnormals, that flush them, and that
 * flush them and do not say so.
 *
 * SPDX-License-Identifier: MIT */
#undef PLT_LANES
#undef PLT_LANES_FLUSHES
#undef PLT_WITH_HULLS
#define PLT_LANES "tests/lanes/flushing.h"
#define PLT_LANES_FLUSHES 1
#define plt_box_groups flushing_box_groups
#define plt_box_pair flushing_box_pair
#define plt_box_entry flushing_box_entry
#define plt_triangle_may_meet flushing_triangle_may_meet
#define plt_packet_init flushing_init
#define plt_packet_begin flushing_begin
#define plt_packet_set_group flushing_set_group
#define plt_packet_finish flushing_finish
#define plt_packet_set_quickly flushing_set_quickly
#define plt_packet_compare_quickly flushing_compare_quickly
#include "engine/trace/boxes.c"
#include "engine/trace/packet_quick.c"
#include "engine/trace/triangle_cull.c"

/* As packet_set.c has scalar lanes. */
static int set_group_kept(plt_packet *p, unsigned index, const f4 org[3], const f4 dir[3], f4 tmin,
                          f4 tmax, unsigned count) {
    const enum flushing how = flushing.how;
    flushing.how = KEEPS;
    const int has_rays = set_group(p, index, org, dir, tmin, tmax, count);
    flushing.how = how;
    return has_rays;
}
#define set_group set_group_kept
#include "engine/trace/packet_set.c"

#include "tests/reference/random.h"
#include "tests/test.h"

enum { CASES = 20000, GROUPS = 4, ALL = 15 };

#define TINY 1.17549435e-38f /* 2^-126 */

static plt_group_slabs slabs[GROUPS];
static plt_group_rays rays[GROUPS];
static random_state r = {8};
static float unit; /* of all coordinates: TINY, or so large that nothing is flushed */

static float tiny(void) {
    return random_float(&r, -3 * unit, 3 * unit);
}

/* Rays of positive directions, so small that 1 / dir is some 2^100. */
static plt_packet packet_of(enum plt_coherence kind) {
    plt_packet p = {.slabs = {.group = slabs, .coherence = (uint8_t)kind}, .rays = rays};
    for (int a = 0; a < 3; a++) {
        p.slabs.near_org[a] = p.slabs.far_org[a] = p.org[a] = tiny();
    }
    for (unsigned i = 0; i < 4 * GROUPS; i++) {
        plt_group_slabs *s = &slabs[i / 4];
        plt_group_rays *g = &rays[i / 4];
        for (int a = 0; a < 3; a++) {
            const float org = kind == PLT_ONE_ORIGIN ? p.org[a] : tiny();
            s->near_org[a][i % 4] = s->far_org[a][i % 4] = g->org[a][i % 4] = org;
            s->rdir[a][i % 4] = random_float(&r, 1e30f, 2e30f);
        }
        s->tmin[i % 4] = 0;
        s->tmax[i % 4] = 3e38f;
        g->slope[0][i % 4] = random_float(&r, -1, 1);
        g->slope[1][i % 4] = random_float(&r, -1, 1);
        g->axis_lanes[2] = 15;
    }
    p.axis = 2;
    return p;
}

static plt_box box_of(void) {
    plt_box b;
    for (int a = 0; a < 3; a++) {
        const float x = tiny(), y = tiny();
        b.lo[a] = x < y ? x : y;
        b.hi[a] = x < y ? y : x;
    }
    return b;
}

/* Thin in x, and with no slack: edge functions are products of a tiny side and a long one. */
static plt_triangle triangle_of(void) {
    plt_triangle t = {.longest = 0};
    for (int c = 0; c < 3; c++) {
        t.corner[c][0] = tiny();
        t.corner[c][1] = random_float(&r, -1, 1);
        t.corner[c][2] = 0;
    }
    return t;
}

/* Two questions of one pair, one of a box and one of a triangle: a bit per group each. */
typedef struct answers {
    plt_mask box, pair[2], triangle;
} answers;

static answers ask(enum flushing how, const plt_packet *p, const plt_box box[2],
                   const plt_triangle *t) {
    answers a;
    flushing.how = how;
    flushing.status = 0;
    a.box = plt_box_groups(&p->slabs, &box[0], ALL);
    plt_box_pair(&p->slabs, box, ALL, a.pair);
    a.triangle = plt_triangle_may_meet(p, t, ALL);
    return a;
}

/* Of `due` those that are not in `got`. */
static int lacks(const answers *got, const answers *due) {
    return (due->box & ~got->box) != 0 || (due->pair[0] & ~got->pair[0]) != 0 ||
           (due->pair[1] & ~got->pair[1]) != 0;
}

static void test_kind(enum plt_coherence kind, const char *sentence) {
    unsigned boxes = 0, triangles = 0, left_out = 0;
    test(sentence);
    for (int i = 0; i < CASES; i++) {
        unit = i % 4 == 0 ? 0x1p40f * TINY : TINY;
        const plt_packet p = packet_of(kind);
        const plt_box box[2] = {box_of(), box_of()};
        const plt_triangle t = triangle_of();
        const answers due = ask(KEEPS, &p, box, &t), silent = ask(FLUSHES_SILENTLY, &p, box, &t);
        const answers got = ask(FLUSHES, &p, box, &t);
        CHECK(!lacks(&got, &due), "case %d: a box lacks groups", i);
        CHECK((due.triangle & ~got.triangle) == 0, "case %d: a triangle lacks groups", i);
        CHECK(flushing.status == 0, "case %d: a flush is left for the next question", i);
        boxes += (unsigned)lacks(&silent, &due);
        triangles += (due.triangle & ~silent.triangle) != 0;
        left_out += due.box != ALL && got.box == due.box;
    }
    CHECK(boxes > CASES / 400 && triangles > CASES / 400,
          "only %u boxes and %u triangles would lack some if nobody asked", boxes, triangles);
    CHECK(left_out > CASES / 10, "only %u boxes leave any out", left_out);
}

/* ---- rays that are set up --------------------------------------------------------- */

typedef struct set_up {
    plt_group_slabs slabs;
    plt_group_rays rays;
    plt_mask active;
} set_up;

static float tiny_or_not(void) {
    return random_below(&r, 4) == 0 ? random_float(&r, -1, 1) : tiny();
}

static void make_rays(set_up *of) {
    memset(of, 0, sizeof *of);
    for (int lane = 0; lane < 4; lane++) {
        for (int a = 0; a < 3; a++) {
            of->rays.org[a][lane] = tiny_or_not();
            of->rays.dir[a][lane] = tiny_or_not();
        }
        of->slabs.tmin[lane] = random_below(&r, 4) == 0 ? tiny() : 0;
        of->slabs.tmax[lane] = random_below(&r, 4) == 0 ? tiny() : 3e38f;
    }
}

static set_up set(enum flushing how, const set_up *given, const plt_box *scene) {
    const plt_group_rays *g = &given->rays;
    const f4 org[3] = {f4_load(g->org[0]), f4_load(g->org[1]), f4_load(g->org[2])};
    const f4 dir[3] = {f4_load(g->dir[0]), f4_load(g->dir[1]), f4_load(g->dir[2])};
    set_up got = *given;
    plt_packet p = {.slabs = {.group = &got.slabs}, .rays = &got.rays, .scene = scene};
    flushing.how = how;
    flushing.status = 0;
    plt_packet_set_group(&p, 0, org, dir, f4_load(given->slabs.tmin), f4_load(given->slabs.tmax),
                         4);
    got.active = p.active;
    return got;
}

/* A group without a ray holds nothing else. */
static int are_same(const set_up *a, const set_up *b) {
    return a->active == 0 ? b->active == 0 && a->rays.valid == 0 && b->rays.valid == 0
                          : memcmp(a, b, sizeof *a) == 0;
}

/* Whether the lanes that flush do it. */
static int is_quick(const set_up *given, const plt_box *scene) {
    set_up of = *given;
    plt_packet p = {.slabs = {.group = &of.slabs}, .rays = &of.rays, .scene = scene};
    int has_rays;
    flushing.how = FLUSHES;
    flushing.status = 0;
    return plt_packet_set_quickly(&p, 0, 4, &has_rays);
}

static plt_common compare(enum flushing how, set_up *of) {
    const plt_packet p = {.slabs = {.group = &of->slabs}, .rays = &of->rays, .active = 1};
    plt_common c;
    flushing.how = how;
    flushing.status = 0;
    plt_packet_compare_quickly(&p, &c);
    return c;
}

/* Of what the groups of `due` differ in something that those of `got` do not. */
static int has_less(const plt_common *got, const plt_common *due) {
    unsigned less = (due->is_apart & ~got->is_apart) | (due->axes & ~got->axes);
    for (int a = 0; a < 3; a++) {
        less |= due->other_sign[a] & ~got->other_sign[a];
    }
    return less != 0;
}

static void test_set_up(const char *sentence) {
    unsigned quick = 0, otherwise = 0;
    test(sentence);
    for (int i = 0; i < CASES; i++) {
        unit = i % 4 == 0 ? 1 : TINY;
        set_up given;
        make_rays(&given);
        const plt_box scene = box_of();
        const set_up due = set(KEEPS, &given, &scene);
        const set_up silent = set(FLUSHES_SILENTLY, &given, &scene);
        const set_up got = set(FLUSHES, &given, &scene);
        CHECK(are_same(&due, &got), "case %d: another group", i);
        CHECK(flushing.status == 0, "case %d: a flush is left for the next question", i);
        quick += (unsigned)is_quick(&given, &scene);
        otherwise += !are_same(&due, &silent);
    }
    CHECK(quick > CASES / 10, "only %u groups are set up by these lanes", quick);
    CHECK(otherwise > CASES / 400, "only %u groups would be others if nobody asked", otherwise);
}

static void test_compare(const char *sentence) {
    unsigned alike = 0, otherwise = 0;
    test(sentence);
    for (int i = 0; i < CASES; i++) {
        unit = i % 4 == 0 ? 1 : TINY;
        set_up of;
        make_rays(&of);
        of.rays.valid = 15;
        for (int lane = 0; lane < 4 && i % 2 == 0; lane++) { /* one origin, 0, and one sign */
            for (int a = 0; a < 3; a++) {
                of.rays.org[a][lane] = 0;
                of.rays.dir[a][lane] = __builtin_fabsf(of.rays.dir[a][lane]);
            }
        }
        const plt_common due = compare(KEEPS, &of), silent = compare(FLUSHES_SILENTLY, &of);
        const plt_common got = compare(FLUSHES, &of);
        CHECK(!has_less(&got, &due), "case %d: has in common what it has not", i);
        CHECK(flushing.status == 0, "case %d: a flush is left for the next question", i);
        alike += memcmp(&got, &due, sizeof due) == 0;
        otherwise += (unsigned)has_less(&silent, &due);
    }
    CHECK(alike > CASES / 10, "only %u groups have in common what they have", alike);
    CHECK(otherwise > CASES / 400, "only %u groups would be others if nobody asked", otherwise);
}

int main(void) {
    test_set_up("where lanes flush, rays are set up as where they do not");
    test_compare("... and find nothing in common that is not");
    test_kind(PLT_ONE_ORIGIN, "lanes that flush leave out no group: rays of one origin");
    test_kind(PLT_ONE_SIGN, "... of equal signs");
    test_kind(PLT_MIXED, "... of any");
    return test_done();
}
