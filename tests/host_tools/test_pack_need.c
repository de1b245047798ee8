/* test_pack_need - what pack says it needs is what it takes, and images that cannot be are refused
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/pack.h"
#include "host_tools/pack/pack_need.h"
#include "tests/reference/random.h"
#include "tests/test.h"

/* Trees of few levels have few triangles (make tiny). */
enum { IS_TINY = PLT_DEPTH_MAX < 16 };

/* Triangles that share vertices: a height field, some of it so flat that a lattice has to mend
 * slivers. */
static mesh field(uint32_t side) {
    random_state random = {side};
    mesh m = {0};
    fail f = {""};
    for (uint32_t i = 0; i < side * side; i++) {
        const float far = i % 7 == 0 ? 1e-4f : 0.4f;
        mesh_add_vertex(&m, (float)(i % side) + random_float(&random, -far, far),
                        (float)(i / side) + random_float(&random, -far, far),
                        random_float(&random, -1, 1), &f);
    }
    for (uint32_t i = 0; i + side + 1 < side * side; i++) {
        mesh_add_triangle(&m, i, i + 1, i + side, &f);
        mesh_add_triangle(&m, i + 1, i + side + 1, i + side, &f);
    }
    mesh_fit(&m);
    return m;
}

typedef struct way {
    const char *name;
    pack_options thesis;
    compact_options compact; /* with lattice bits: this one */
    int is_high;
} way;

static uint64_t need_of(const way *w, const mesh *m) {
    const pack_counts counts = {m->vertices, m->triangles, heap_used(),
                                12 * (m->vertices + m->triangles)};
    return w->compact.lattice_bits > 0 ? pack_need_compact(&w->compact, &counts)
                                       : pack_need_thesis(&w->thesis, w->is_high, &counts);
}

static int pack_so(const way *w, packed *image, const mesh *m, fail *f) {
    lattice_loss loss;
    quality_stats quality;
    return w->compact.lattice_bits > 0
               ? pack_compact(image, m, &w->compact, "field", &loss, f)
               : (w->is_high ? pack_mesh_better(image, m, &w->thesis, 0, &quality, "field", f)
                             : pack_mesh(image, m, &w->thesis, "field", f));
}

/* Within what it needs, and with the mesh let go, the image is the same. */
static void check_way(way w, uint32_t side, int spends) {
    mesh m = field(side), other = field(side);
    packed image, again;
    fail f = {""};
    CHECK(pack_so(&w, &image, &other, &f) == 0, "%s: %s", w.name, f.text);
    mesh_free(&other);
    w.thesis.spend = w.compact.spend = spends ? &m : NULL;
    const uint64_t need = need_of(&w, &m);
    heap_limit(need);
    heap_forget_peak();
    CHECK(pack_so(&w, &again, &m, &f) == 0, "%s: %s", w.name, f.text);
    const int is_bound = pack_treelets_differ(&w.thesis); /* of which little is known before */
    CHECK(heap_refused() == 0 && heap_peak() <= need &&
              (2 * heap_peak() >= need || side < 40 || is_bound),
          "%s, %u: %llu bytes of %llu", w.name, side, (unsigned long long)heap_peak(),
          (unsigned long long)need);
    heap_limit(UINT64_MAX);
    CHECK(again.size == image.size && memcmp(again.bytes, image.bytes, image.size) == 0, "%s",
          w.name);
    CHECK(spends ? m.triangle == NULL || w.compact.floats : m.triangle != NULL, "%s", w.name);
    pack_free(&image);
    pack_free(&again);
    mesh_free(&m);
    CHECK(heap_used() == 0, "%s: %llu bytes are left", w.name, (unsigned long long)heap_used());
}

static void check_ways(void) {
    static quality_stats quality;
    const pack_options thesis = {.leaf_triangles = 2, .treelet_nodes = 64};
    const compact_options lattice = {.lattice_bits = 14, .numbers = 1, .leaf_triangles = 2};
    way ways[] = {{"thesis", thesis, {0}, 0},         {"leaf 1", thesis, {0}, 0},
                  {"treelets of 3", thesis, {0}, 0},  {"device", thesis, {0}, 0},
                  {"none", thesis, {0}, 0},           {"high", thesis, {0}, 1},
                  {"lattice", thesis, lattice, 0},    {"21 bits", thesis, lattice, 0},
                  {"no numbers", thesis, lattice, 0}, {"float", thesis, lattice, 0},
                  {"corners", thesis, lattice, 0},    {"high on a lattice", thesis, lattice, 0},
                  {"area", thesis, {0}, 0},           {"full", thesis, {0}, 0},
                  {"newest", thesis, {0}, 1},         {"apart", thesis, {0}, 0},
                  {"auto", thesis, {0}, 0},           {"auto and full", thesis, {0}, 1},
                  {"full and large", thesis, {0}, 0}};
    ways[1].thesis.leaf_triangles = 1;
    ways[2].thesis.treelet_nodes = 3;
    ways[3].thesis.build = PLT_BUILD_DEVICE;
    ways[4].thesis.build = PLT_BUILD_NONE;
    ways[7].compact.lattice_bits = 21;
    ways[8].compact.numbers = 0;
    ways[9].compact.floats = 1;
    ways[9].compact.numbers = 0;
    ways[10].compact.build = PLT_BUILD_DEVICE;
    ways[10].compact.numbers = 0;
    ways[11].compact.quality = &quality;
    ways[12].thesis.fill = TREELET_FILL_AREA;
    ways[13].thesis.fill = ways[17].thesis.fill = ways[18].thesis.fill = TREELET_FILL_FULL;
    ways[14].thesis.slots = TREELET_SLOTS_NEWEST;
    ways[15].thesis.slots = TREELET_SLOTS_NONE;
    ways[16].thesis.treelet_nodes = ways[17].thesis.treelet_nodes = PACK_TREELET_AUTO;
    ways[18].thesis.treelet_nodes = 10000;
    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++) {
        for (int spends = 0; spends < 2; spends++) {
            check_way(ways[i], IS_TINY ? 6 : 40, spends);
            check_way(ways[i], IS_TINY ? 7 : 150, spends);
        }
    }
}

/* One byte less than a request, and what is left of it. */
static void check_limit(void) {
    unsigned char *a = heap_get(1000);
    const uint64_t before = heap_used();
    heap_limit(before + heap_cost(500));
    CHECK(a != NULL && heap_get(501) == NULL, "more than the limit");
    CHECK(heap_refused() == before + heap_cost(501), "%llu", (unsigned long long)heap_refused());
    void *b = heap_get_zeroed(500);
    CHECK(b != NULL && heap_used() == heap_limit_bytes(), "just the limit");
    CHECK(heap_resize(a, 1001) == NULL && heap_used() == heap_limit_bytes(), "one byte more");
    memset(a, 7, 1000);
    a = heap_resize(a, 10);
    CHECK(a != NULL && a[9] == 7 && heap_used() == before - 990 + heap_cost(500), "fewer");
    heap_limit(UINT64_MAX);
    CHECK(heap_get(UINT64_MAX) == NULL && heap_get_aligned(UINT64_MAX - 100) == NULL &&
              heap_get_zeroed(UINT64_MAX / 2) == NULL,
          "more than there are addresses");
    void *c = heap_get_aligned(3);
    CHECK(c != NULL && (uintptr_t)c % HEAP_ALIGN == 0, "%p", c);
    heap_drop(a);
    heap_drop(b);
    heap_drop(c);
    heap_drop(NULL);
    heap_forget_refusal();
    CHECK(heap_used() == 0, "%llu bytes are left", (unsigned long long)heap_used());
}

/* What the remedy of a message leads to. */
static int fits(uint64_t triangles, uint8_t build, uint32_t leaf) {
    const pack_options o = {.build = build, .leaf_triangles = leaf, .treelet_nodes = 64};
    fail f = {""};
    return image_size_check_thesis("m.ply", triangles, &o, &f) == 0;
}

static int fits_compact(uint64_t triangles, compact_options o, const char *says) {
    fail f = {""};
    const int fits = image_size_check_compact("m.ply", triangles, &o, &f) == 0 &&
                     image_size_check_lattice("m.ply", triangles, &o, 4, &f) == 0;
    CHECK(fits ? says == NULL : says != NULL && strstr(f.text, says) != NULL, "%s", f.text);
    return fits;
}

static void check_sizes(void) {
    fail f = {""};
    const pack_options o = {.leaf_triangles = 1, .treelet_nodes = 64};
    CHECK(image_size_check_thesis("m.ply", 80000000, &o, &f) != 0, "4,480,000,000 bytes");
    CHECK(strcmp(f.text,
                 "m.ply: 80000000 triangles: the image would have at least 4480000224 "
                 "bytes, and must have fewer than 4294967296; use --nodes compact, a "
                 "larger --leaf, or --reduce") == 0,
          "%s", f.text);
    CHECK(fits(80000000, PLT_BUILD_HOST, 2) && fits(76695840, PLT_BUILD_HOST, 1) &&
              !fits(76695850, PLT_BUILD_HOST, 1),
          "a larger leaf, or fewer");
    CHECK(fits(107374175, PLT_BUILD_NONE, 2) && !fits(107374176, PLT_BUILD_NONE, 2), "records");
    const compact_options lattice = {.lattice_bits = 16, .numbers = 1, .leaf_triangles = 1};
    compact_options other = lattice;
    other.leaf_triangles = 2;
    CHECK(!fits_compact(40000000, lattice,
                        "the blocks would have at least 157499992 bytes, and "
                        "must have at most 134217720"),
          "blocks");
    CHECK(fits_compact(40000000, other, NULL), "a larger leaf");
    other.leaf_triangles = 4;
    other.floats = 1;
    CHECK(!fits_compact(106000000, other, "use --geometry lattice"), "float records");
    other.floats = 0;
    other.build = PLT_BUILD_DEVICE;
    CHECK(!fits_compact(120000000, other, "at most 16 bits"), "corners of 36 bytes");
    CHECK(!fits_compact(134217728, other, "an image holds at most 134217727"), "numbers");
}

int main(void) {
    test("a heap with a limit");
    check_limit();
    test("pack takes what it says, at most, and half of it at least");
    check_ways();
    test("sizes that no image has are refused before it is built");
    check_sizes();
    return test_done();
}
