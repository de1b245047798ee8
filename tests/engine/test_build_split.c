/* test_build_split - where the surface area heuristic splits a range of records
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "board/hash.h"
#include "engine/builder/split.h"
#include "engine/image/header.h"
#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

enum { ITEMS = 5000, FEW = PLT_SAH_BINS < 16 ? PLT_SAH_BINS : 16 };

static plt_record record[ITEMS];
static plt_split_bins bins;

/* A triangle about a point, `size` across. */
static void put(uint32_t i, const float at[3], float size, random_state *r) {
    for (int k = 0; k < 9; k++) {
        plt_put_float(&record[i].word[k], at[k % 3] + random_float(r, -size, size));
    }
    plt_put_u32(&record[i].word[9], i);
}

/* In a box of 4 x 2 x 1, half of them near one corner. */
static void scatter(uint32_t count, uint64_t seed) {
    random_state r = {seed};
    const float lo[3] = {0, 0, 0}, hi[3] = {4, 2, 1}, near[3] = {0.4f, 0.2f, 0.1f};
    for (uint32_t i = 0; i < count; i++) {
        float at[3];
        random_point(&r, lo, i % 2 ? hi : near, at);
        put(i, at, i % 7 == 0 ? 0.3f : 0.02f, &r);
    }
}

static uint32_t split(uint32_t count, plt_box child[2]) {
    plt_record_items items = {record, &bins};
    const plt_split_range range = {0, count, 0, 1, PLT_SPLIT_SAH};
    const plt_box box = plt_records_box(record, 0, count);
    return plt_split_records(&items, &range, &box, child);
}

static double cost_of(const plt_box *left, uint32_t n_left, const plt_box *right,
                      uint32_t n_right) {
    return (double)plt_box_half_area(left) * n_left + (double)plt_box_half_area(right) * n_right;
}

static int axis_compared;

static int by_centre(const void *a, const void *b) {
    const plt_box p = plt_record_box(a), q = plt_record_box(b);
    const float x = p.lo[axis_compared] + p.hi[axis_compared];
    const float y = q.lo[axis_compared] + q.hi[axis_compared];
    return (x > y) - (x < y);
}

/* The least cost of all splits in order of centres, on all axes. */
static double least_cost(uint32_t count) {
    static plt_record sorted[ITEMS];
    static plt_box right[ITEMS + 1];
    double least = INFINITY;
    for (axis_compared = 0; axis_compared < 3; axis_compared++) {
        memcpy(sorted, record, count * sizeof *sorted);
        qsort(sorted, count, sizeof *sorted, by_centre);
        right[count] = plt_box_empty();
        for (uint32_t i = count; i-- > 0;) {
            const plt_box b = plt_record_box(&sorted[i]);
            right[i] = right[i + 1];
            plt_box_add(&right[i], &b);
        }
        plt_box left = plt_box_empty();
        for (uint32_t i = 1; i < count; i++) {
            const plt_box b = plt_record_box(&sorted[i - 1]);
            plt_box_add(&left, &b);
            least = fmin(least, cost_of(&left, i, &right[i], count - i));
        }
    }
    return least;
}

/* Each child's box is the tight one of its records, all of which are still there. */
static void check_children(uint32_t count, uint32_t middle, const plt_box child[2]) {
    static uint8_t seen[ITEMS];
    CHECK(middle > 0 && middle < count, "middle %u of %u", (unsigned)middle, (unsigned)count);
    const plt_box tight[2] = {plt_records_box(record, 0, middle),
                              plt_records_box(record, middle, count)};
    CHECK(memcmp(tight, child, sizeof tight) == 0, "%u: boxes that are not tight", (unsigned)count);
    memset(seen, 0, sizeof seen);
    for (uint32_t i = 0; i < count; i++) {
        seen[plt_get_u32(&record[i].word[9])]++;
    }
    for (uint32_t i = 0; i < count; i++) {
        CHECK(seen[i] == 1, "%u: record %u %u times", (unsigned)count, (unsigned)i, seen[i]);
    }
}

static void few(void) {
    test("a few records: the best of all splits in order, children tight");
    for (uint32_t seed = 0; seed < 200; seed++) {
        for (uint32_t count = 2; count <= FEW; count++) {
            plt_box child[2];
            scatter(count, seed);
            const double least = least_cost(count);
            const uint32_t middle = split(count, child);
            check_children(count, middle, child);
            const double cost = cost_of(&child[0], middle, &child[1], count - middle);
            CHECK(cost <= least * (1.0 + 1e-6), "seed %u, %u: cost %g, least %g", (unsigned)seed,
                  (unsigned)count, cost, least);
        }
    }
}

static void many(void) {
    test("many records, in bins and from a sample: within 5 % of the best split");
    static const uint32_t counts[] = {17, 40, 64, 65, 129, 256, 257, 1000, 2047, 2048, 4097, ITEMS};
    for (uint32_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        plt_box child[2];
        scatter(counts[i], i);
        const double least = least_cost(counts[i]);
        const uint32_t middle = split(counts[i], child);
        check_children(counts[i], middle, child);
        const double cost = cost_of(&child[0], middle, &child[1], counts[i] - middle);
        CHECK(cost <= least * (rig_is_tiny() ? 2.0 : 1.05), "%u: cost %g, least %g",
              (unsigned)counts[i], cost, least);
    }
}

/* Of 4,096 records every fourth is in the sample: those lie in one point, or all but one
 * of the others do. */
static void odd_samples(void) {
    test("what a sample does not show is split all the same");
    random_state r = {1};
    const float here[3] = {0, 0, 0}, there[3] = {9, 9, 9}, far[3] = {1e6f, 0, 0};
    for (uint32_t i = 0; i < 4096; i++) {
        put(i, i % 4 == 0 ? here : there, 0.0f, &r);
    }
    plt_box child[2];
    uint32_t middle = split(4096, child);
    check_children(4096, middle, child);
    CHECK(middle == 1024, "%u", (unsigned)middle);
    scatter(4096, 3);
    put(13, far, 0.1f, &r);
    middle = split(4096, child);
    check_children(4096, middle, child);
}

static uint64_t image_hash(const mesh *m, uint32_t k, int compact) {
    packed image = {0};
    fail f = {""};
    lattice_loss loss;
    const pack_options thesis = {.leaf_triangles = k, .treelet_nodes = 64};
    const compact_options blocks = {.lattice_bits = 16, .numbers = 1, .leaf_triangles = k};
    const int status = compact ? pack_compact(&image, m, &blocks, "knot", &loss, &f)
                               : pack_mesh(&image, m, &thesis, "knot", &f);
    CHECK(status == 0, "%s", f.text);
    const uint64_t hash =
        status == 0 ? hash_bytes(image.bytes + PLT_HEADER_BYTES, image.size - PLT_HEADER_BYTES) : 0;
    pack_free(&image);
    return hash;
}

/* Lanes and plain C are two texts of one computation (split_bins.h): `make scalar` runs this
 * test with the other one. */
static void same_everywhere(void) {
    test("the same trees with every lanes header");
    static const uint64_t wanted[2][3] = {
        {0xbaf0837de88fad73, 0x6f0955c5859388e5, 0x6ddaf004502bb3fe},
        {0x8d46d71a2c3b9049, 0xa5e50fd57b8c45df, 0x9917adca719ca843}};
    mesh m = {0};
    fail f = {""};
    CHECK(scene_knot(&m, 20000, &f) == 0, "%s", f.text);
    for (int compact = 0; compact < 2; compact++) {
        for (int i = 0; i < 3; i++) {
            const uint64_t hash = image_hash(&m, 1u << i, compact);
            CHECK(hash == wanted[compact][i], "%s, K %d: 0x%016llx", compact ? "compact" : "thesis",
                  1 << i, (unsigned long long)hash);
        }
    }
    mesh_free(&m);
}

int main(void) {
    few();
    many();
    if (!rig_is_tiny()) { /* in 8 levels so many records are halved by count */
        odd_samples();
        same_everywhere();
    }
    return test_done();
}
