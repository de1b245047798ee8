/* test_baselines_treelets - orders over treelets, step by step, and beside the engine's own
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/tree/record_put.h"
#include "host_tools/baselines/structure.h"
#include "host_tools/baselines/treelets/treelet_orders.h"
#include "host_tools/baselines/treelets/treelets_structure.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* ---- stacks -------------------------------------------------------------------------- */

static void fill(treelet_stack *s, uint32_t count, random_state *r, int as_heap) {
    for (uint32_t i = 0; i < count; i++) {
        const treelet_entry e = {.link = plt_link_make(i, random_below(r, 2)),
                                 .distance = (float)random_below(r, 20)};
        if (as_heap) {
            treelet_heap_push(s, &e);
        } else {
            treelet_push(s, &e);
        }
    }
}

static void are_sorted(void) {
    random_state r = {4};
    for (uint32_t round = 0; round < 200; round++) {
        treelet_stack s = {.count = 0}, heap = {.count = 0};
        const uint32_t count = random_below(&r, 150), first = random_below(&r, count + 1);
        const int leaf_first = (int)(round % 2);
        fill(&s, count, &r, 0);
        fill(&heap, count, &r, 1);
        treelet_sort(&s, first, leaf_first);
        for (uint32_t i = 0; i < first; i++) {
            CHECK(plt_link_index(s.entry[i].link) == i, "entry %u below", i);
        }
        for (uint32_t i = first + 1; i < count; i++) {
            const treelet_entry *a = &s.entry[i], *b = &s.entry[i - 1]; /* a is on top */
            const int a_leaf = plt_link_is_leaf(a->link), b_leaf = plt_link_is_leaf(b->link);
            CHECK(leaf_first && a_leaf != b_leaf
                      ? a_leaf
                      : a->distance < b->distance ||
                            (a->distance == b->distance &&
                             plt_link_index(a->link) < plt_link_index(b->link)),
                  "entry %u", i);
        }
        float last = -1.0f;
        for (uint32_t i = 0; i < count; i++) {
            const treelet_entry e = treelet_heap_pop(&heap);
            CHECK(e.distance >= last, "%g after %g", (double)e.distance, (double)last);
            last = e.distance;
        }
        treelet_stack_free(&s);
        treelet_stack_free(&heap);
    }
}

/* ---- a tree by hand ------------------------------------------------------------------- */

/*             1           nodes by number; treelets {1 2 3}, and each of the others alone
 *          /     \        A ray goes along x. Boxes begin at: 2: 0, 3: 4, 4: 0, 5: 2, 6: 4,
 *        2         3      7: 6, and that of 8 at 6.5. What is not drawn are leaves that the
 *       / \       / \     ray's packet meets in vain, but for L, where it hits.
 *      4   5     6   7
 *     / \           / \
 *    8   .         L   .
 */
enum { NODES = 9, VAIN = 0, HITS = 1 };

typedef struct by_hand {
    unsigned bit_is_parity;
    char visited[64]; /* the digits of nodes, in order */
} by_hand;

static const float begins[NODES] = {0, 0, 0, 4, 0, 2, 4, 6, 6.5f};
static const uint8_t below[NODES][2] = {{0, 0}, {2, 3}, {4, 5}, {6, 7}, {8, 0},
                                        {0, 0}, {0, 0}, {0, 0}, {0, 0}};
/* Treelets {1 2 3} 0, 4 to 7 1, 8 0. */
static const uint8_t parities[NODES] = {0, 0, 0, 0, 1, 1, 1, 1, 0};
static const uint8_t is_out[NODES] = {0, 0, 0, 0, 1, 1, 1, 1, 1};

static void children_by_hand(const void *self, uint32_t slot, const plt_box *box,
                             treelet_child child[2]) {
    by_hand *h = (by_hand *)(uintptr_t)self;
    (void)box;
    h->visited[strlen(h->visited)] = (char)('0' + slot);
    for (int k = 0; k < 2; k++) {
        const uint32_t to = below[slot][k];
        const float from = to > 0 ? begins[to] : slot == 7 && k == 0 ? 6.75f : begins[slot];
        child[k].box = (plt_box){{from, -1, -1}, {from + 0.25f, 1, 1}};
        child[k].link = to == 0 ? plt_link_make(slot == 7 && k == 0 ? HITS : VAIN, PLT_LINK_LEAF)
                                : plt_link_make(to, (h->bit_is_parity ? parities[to] : is_out[to])
                                                        ? PLT_LINK_OUT
                                                        : 0);
    }
}

/* What is visited, in order. */
static const char *visit_by_hand(by_hand *h, enum treelet_order order, int again, unsigned parity,
                                 int any) {
    static plt_record records[2];
    static const float vain[9] = {0, 5, 5, 0, 6, 5, 0, 5, 6},
                       hits[9] = {6.8f, -1, -1, 6.8f, 3, -1, 6.8f, -1, 3};
    const plt_box scene = {{0, -1, -1}, {8, 6, 6}};
    const treelet_nodes nodes = {.self = h,
                                 .children = children_by_hand,
                                 .record = records,
                                 .box = scene,
                                 .root = plt_link_make(1, 0),
                                 .edges = parity ? NODE_EDGES_PARITY : NODE_EDGES_DIRECT};
    plt_ray rays[4];
    packet_state p;
    memset(records, 0, sizeof records);
    for (uint32_t i = 0; i < 2; i++) {
        plt_put_u32(&records[i].word[9], i);
        plt_record_put(&records[i], i == HITS ? hits : vain);
        plt_record_set_last(&records[i], 1);
    }
    for (int i = 0; i < 4; i++) {
        const float org[3] = {-1, 0, 0}, dir[3] = {1, 0.001f * (float)i, 0.001f};
        rays[i] = ray_make(org, dir, 0, RAYS_FAR);
    }
    *h = (by_hand){.bit_is_parity = parity};
    treelet_tracing t = {
        .nodes = &nodes, .packet = &p, .order = order, .tests_again = (uint8_t)again};
    CHECK(packet_open(&p, 2) == 0 && packet_begin(&p, &scene, rays, 4, any), "the packet");
    CHECK(treelet_trace(&t) == 0, "no memory");
    plt_hit hit[4];
    packet_store(&p, hit);
    CHECK(hit[0].triangle == (any ? 1u : (unsigned)HITS), "the hit is %u", hit[0].triangle);
    treelet_tracing_free(&t);
    packet_close(&p);
    return h->visited;
}

static void expect(enum treelet_order order, int again, int any, const char *visited) {
    for (unsigned parity = 0; parity < 2; parity++) {
        by_hand h;
        const char *got = visit_by_hand(&h, order, again, parity, any);
        CHECK(strcmp(got, visited) == 0, "order %d, again %d, any %d, parity %u: %s, not %s", order,
              again, any, parity, got, visited);
    }
}

/* As they come the right subtree is visited first, its edges lie below those of the left one, and
 * of these the right one is on top (checklist of the thesis: text and Figure 4.2 do not agree). */
static void figure_as_printed(void) {
    expect(TREELET_FIGURE, 0, 0, "13254876");
    expect(TREELET_TEXT, 0, 0, "12367485");
    expect(TREELET_MIRRORED, 0, 0, "13254876"); /* left is near here */
    expect(TREELET_SORTED, 1, 0, "12348567");
    expect(TREELET_LEAF_FIRST, 1, 0, "12348567");
    expect(TREELET_HEAP, 1, 0, "12345678");
    expect(TREELET_DEPTH, 1, 0, "12485367");
}

/* Any hit ends it: the one behind 7. */
static void any_hit_ends_it(void) {
    expect(TREELET_FIGURE, 0, 1, "1325487"); /* and 6 still waits */
    expect(TREELET_SORTED, 1, 1, "12348567");
    expect(TREELET_DEPTH, 1, 1, "12485367");
}

/* ---- beside the engine's ------------------------------------------------------------------ */

static uint64_t engine_visits(const mesh *m, uint32_t n, uint8_t splits, const plt_ray *rays,
                              uint32_t count, plt_hit *hits) {
    rig_config c = rig_config_of(1, n, PLT_BUILD_HOST, splits);
    rig x;
    plt_stats q = {0};
    c.run.packet_side = PLT_PACKET_SIDE_MAX < 4 ? PLT_PACKET_SIDE_MAX : 4;
    c.run.order = PLT_ORDER_TWO_STAGE;
    c.run.rays = PLT_RAYS_COHERENT;
    const int status = rig_open(&x, m, &c);
    CHECK(status == PLT_OK || rig_is_tiny(), "%s", x.fault.message);
    if (status == PLT_OK) {
        CHECK(plt_trace(x.engine, rays, hits, count, 0) == PLT_OK, "the rays");
        plt_stats_get(x.engine, &q);
    }
    rig_close(&x);
    return q.node_visits;
}

/* Edges at equal distances may come in another order: the engine's sort is not stable. */
static void visits_are_the_engines(void) {
    enum { COUNT = 4096 };
    unsigned same = 0;
    static plt_ray rays[COUNT];
    static plt_hit due[COUNT], got[COUNT];
    for (int i = 0; i < 36; i++) {
        const uint32_t place = (uint32_t)i % TREELETS_SIZES, n = treelets_sizes[place];
        const uint8_t splits = (uint8_t)(i % 2);
        random_state r = {(uint64_t)i};
        mesh m = {0};
        fail f = {""};
        scene_knot(&m, rig_triangles(2500, 1), &f);
        rays_camera(rays, COUNT, &m, &r);
        const uint64_t visits = engine_visits(&m, n, splits, rays, COUNT, due);
        structure_options o = {.packet_side = PLT_PACKET_SIDE_MAX < 4 ? PLT_PACKET_SIDE_MAX : 4};
        o.choice[STRUCTURE_SPLITS] = splits == PLT_SPLIT_SAH ? STRUCTURE_SAH : STRUCTURE_MEDIAN;
        o.choice[TREELETS_SIZE] = (uint8_t)(place + 1);
        o.choice[TREELETS_ORDER] = TREELET_SORTED + 1;
        o.choice[TREELETS_BIT] = (uint8_t)(1 + i / 2 % 2);
        built_structure *s =
            visits > 0 ? structure_open(&structure_treelets, &m, &o, "it", &f) : NULL;
        if (s != NULL) {
            CHECK(structure_trace(s, rays, got, COUNT, 0, &f) == 0, "%s", f.text);
            CHECK(memcmp(got, due, sizeof got) == 0, "N %u: hits", n);
            const structure_statistics q = structure_count(s);
            const uint64_t more = q.node_visits > visits ? q.node_visits - visits : 0;
            const uint64_t fewer = visits > q.node_visits ? visits - q.node_visits : 0;
            CHECK(32 * (more + fewer) <= visits, "N %u, splits %u: %llu visits, the engine's %llu",
                  n, splits, (unsigned long long)q.node_visits, (unsigned long long)visits);
            same += more + fewer == 0;
        }
        CHECK(s != NULL || rig_is_tiny(), "%s", f.text);
        structure_close(s);
        mesh_free(&m);
    }
    CHECK(same >= 3 || rig_is_tiny(), "%u the same", same);
}

int main(void) {
    test("edges are sorted, the nearest or leaves on top, and a heap gives the nearest first");
    are_sorted();
    test("a tree by hand is visited as Figure 4.2 says, and as the other orders do");
    figure_as_printed();
    test("any hit ends a traversal");
    any_hit_ends_it();
    test("sorted edges that are tested again are visited as often as the engine's two stages do");
    visits_are_the_engines();
    return test_done();
}
