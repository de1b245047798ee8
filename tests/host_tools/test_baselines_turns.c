/* test_baselines_turns - structures in turn: every ray once a pass, by the clock or not, hits alike
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/turns.h"

#include "board/hash.h"
#include "host_tools/base/heap.h"
#include "host_tools/scenes/scenes.h"
#include "tests/test.h"

enum { RAYS = 300, MANY = TURNS_BATCH + 100 };

static mesh knot;
static plt_ray ray[MANY];
static plt_hit due[RAYS];

/* A grid of rays along z, of which some hit the knot. */
static void set_rays(void) {
    for (uint32_t i = 0; i < MANY; i++) {
        const float x = (float)(i % 20) / 4.0f - 2.4f, y = (float)(i / 20 % 15) / 4.0f - 1.8f;
        ray[i] = (plt_ray){.org = {x, y, 9.0f}, .dir = {0.0f, 0.0f, -1.0f}, .tmax = 1e30f};
    }
}

static built_structure *open_one(const char *text, const mesh *m) {
    structure_options options = {.packet_side = 0};
    fail f = {""};
    const structure_kind *kind = structure_read(text, "a test", &options, &f);
    built_structure *s = kind != NULL ? structure_open(kind, m, &options, "knot", &f) : NULL;
    CHECK(s != NULL, "%s: %s", text, f.text);
    return s;
}

static turns two_sides(built_structure *one, built_structure *two, const plt_ray *rays,
                       uint32_t count) {
    return (turns){.side = {{.name = "one", .s = one}, {.name = "two", .s = two}},
                   .sides = 2,
                   .rounds = 4,
                   .is_tried = 1,
                   .rays = turns_rays_of(rays, count),
                   .scene = "knot",
                   .kind = "straight"};
}

static void check_side(const turns_side *s, unsigned rounds) {
    double least = s->seconds[0];
    CHECK(s->counts.rays == RAYS, "%s counts more than the first pass: %llu rays", s->name,
          (unsigned long long)s->counts.rays);
    CHECK(s->hash == hash_bytes((const uint8_t *)due, sizeof due), "%s: another hash", s->name);
    for (unsigned i = 0; i < rounds; i++) {
        CHECK(s->seconds[i] > 0.0, "%s, round %u", s->name, i);
        least = s->seconds[i] < least ? s->seconds[i] : least;
    }
    CHECK(s->best == least, "%s: %g is not the best", s->name, s->best);
    CHECK(s->best_cycles != s->best_cycles, "cycles that nobody counts"); /* NaN */
}

static void check_two(built_structure *one, built_structure *two) {
    fail f = {""};
    uint64_t hits = 0;
    CHECK(structure_trace(one, ray, due, RAYS, 0, &f) == 0, "%s", f.text);
    for (uint32_t i = 0; i < RAYS; i++) {
        hits += due[i].triangle != PLT_MISS;
    }
    test("two structures trace all rays in turn; hits and counts are those of the first pass");
    for (int is_tried = 0; is_tried < 2; is_tried++) {
        turns t = two_sides(one, two, ray, RAYS);
        t.is_tried = is_tried;
        CHECK(turns_run(&t, &f) == 0, "%s", f.text);
        CHECK(hits > 20 && hits < RAYS && t.side[0].hits == hits && t.side[1].hits == hits,
              "%llu and %llu hits", (unsigned long long)t.side[0].hits,
              (unsigned long long)t.side[1].hits);
        CHECK(t.passes == 2u * (4u + (unsigned)is_tried), "%llu passes",
              (unsigned long long)t.passes);
        check_side(&t.side[0], 4);
        check_side(&t.side[1], 4);
    }
    test("any hits are as many, and need no round by the clock");
    turns t = two_sides(one, two, ray, RAYS);
    t.any = 1;
    t.rounds = 0;
    CHECK(turns_run(&t, &f) == 0 && t.side[1].hits == hits, "%s, %llu", f.text,
          (unsigned long long)t.side[1].hits);
    CHECK(t.passes == 2, "%llu passes", (unsigned long long)t.passes);
    test("no rays have no hits");
    t = two_sides(one, two, NULL, 0);
    CHECK(turns_run(&t, &f) == 0 && t.side[0].hits == 0 && t.side[0].best > 0.0, "%s", f.text);
}

/* What was asked for, in turn. */
static uint64_t asked, wrong;

static const plt_ray *next_rays(void *context, uint64_t first, uint32_t count) {
    const uint64_t due_first = asked % MANY, left = MANY - due_first;
    wrong += context != ray || first != due_first || count == 0 || count > left ||
             (count != TURNS_BATCH && count != left);
    asked += count;
    return ray + first;
}

static void check_batches(built_structure *one, built_structure *two) {
    fail f = {""};
    turns t = two_sides(one, two, NULL, 0);
    t.rays = (turns_rays){next_rays, ray, MANY};
    test("rays are asked for batch by batch, in each pass anew");
    CHECK(turns_run(&t, &f) == 0, "%s", f.text);
    CHECK(asked == 10ull * MANY && wrong == 0, "%llu rays, %llu wrong", (unsigned long long)asked,
          (unsigned long long)wrong);
    turns whole = two_sides(one, two, ray, MANY);
    CHECK(turns_run(&whole, &f) == 0 && whole.side[0].hash == t.side[0].hash, "%s", f.text);
    CHECK(whole.side[0].counts.rays == MANY, "%llu", (unsigned long long)whole.side[0].counts.rays);
    test("... so that memory is for the hits of one batch");
    heap_forget_peak();
    const uint64_t before = heap_used();
    CHECK(turns_run(&t, &f) == 0, "%s", f.text);
    CHECK(heap_peak() - before < TURNS_BATCH * sizeof(plt_hit) + 200, "%llu bytes",
          (unsigned long long)(heap_peak() - before));
    heap_limit(before + 1000);
    CHECK(turns_run(&t, &f) == -1 && strstr(f.text, "out of memory") != NULL, "%s", f.text);
    heap_limit(UINT64_MAX);
    CHECK(heap_used() == before, "not given back");
}

/* A knot that stands a bit to one side: of the same rays other hits. */
static void check_other_hits(built_structure *one) {
    fail f = {""};
    mesh other = {0};
    scene_knot(&other, 1500, &f);
    for (size_t i = 0; i < other.vertices; i++) {
        other.vertex[3 * i] += 0.01f;
    }
    built_structure *moved = open_one("wbvh", &other);
    test("other hits end it, in the pass by no clock or in the first round, and both are named");
    for (int is_tried = 0; is_tried < 2; is_tried++) {
        turns t = two_sides(one, moved, ray, RAYS);
        fail g = {""};
        t.is_tried = is_tried;
        CHECK(turns_run(&t, &g) == -1, "not seen");
        CHECK(strcmp(g.text,
                     "knot: hits of straight rays by two differ from those by one; please "
                     "report this") == 0,
              "%s", g.text);
    }
    structure_close(moved);
    mesh_free(&other);
}

static void check_median(void) {
    double odd[] = {5.0, 1.0, 3.0}, even[] = {4.0, 1.0, 3.0, 10.0}, one[] = {7.0};
    test("a median is the middle one, or half way between two");
    CHECK(turns_median(odd, 3) == 3.0 && turns_median(one, 1) == 7.0, "odd");
    CHECK(turns_median(even, 4) == 3.5 && even[0] == 1.0 && even[3] == 10.0, "even");
}

int main(void) {
    fail f = {""};
    test("structures are built");
    scene_knot(&knot, 1500, &f);
    set_rays();
    built_structure *one = open_one("bvh:4x4", &knot), *two = open_one("kd:single", &knot);
    if (one != NULL && two != NULL) {
        check_two(one, two);
        check_batches(one, two);
        check_other_hits(one);
    }
    check_median();
    structure_close(one);
    structure_close(two);
    mesh_free(&knot);
    return test_done();
}
