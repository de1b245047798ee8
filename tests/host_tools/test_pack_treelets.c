/* test_pack_treelets - images of treelets that pack forms: valid, and with the hits of all others
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/scenes/scenes.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/tree_check.h"
#include "tests/test.h"

enum { RAYS = 400, SCENES = 5 };

static const uint32_t sizes[] = {1, 2, 3, 7, 16, 64, 256, 10000, PACK_TREELET_AUTO};
#define COUNT(a) (sizeof(a) / sizeof *(a))

static mesh make(int scene) {
    mesh m = {0};
    fail f = {""};
    switch (scene) {
    case 0:
        scene_knot(&m, rig_triangles(3000, 1), &f);
        break;
    case 1:
        shape_soup(&m, rig_triangles(900, 1), 0.3f, 2);
        break;
    case 2:
        shape_exponential(&m, 60);
        break;
    case 3:
        shape_soup(&m, 2, 0.3f, 2); /* no node */
        break;
    default:
        shape_coincident(&m, 70);
    }
    return m;
}

static pack_options options_of(uint32_t size, uint8_t fill, uint8_t slots, uint32_t k) {
    const pack_options o = {.splits = PLT_SPLIT_SAH,
                            .build = PLT_BUILD_HOST,
                            .leaf_triangles = k,
                            .treelet_nodes = size,
                            .checks = 1,
                            .fill = fill,
                            .slots = slots};
    return o;
}

/* 0: tiny limits refuse the image. */
static int hits_of(const mesh *m, const pack_options *o, const plt_ray *rays, plt_hit *hits) {
    rig_config c = rig_config_of(2, 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    rig x;
    c.pack = *o;
    const int status = rig_open(&x, m, &c);
    CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "N %u, fill %u: %s",
          o->treelet_nodes, o->fill, x.fault.message);
    if (status == PLT_OK) {
        CHECK(plt_trace(x.engine, rays, hits, RAYS, 0) == PLT_OK, "the rays");
    }
    rig_close(&x);
    return status == PLT_OK;
}

static void check_image(const packed *image, const pack_options *o, int scene) {
    const tree_view v = tree_view_of(image);
    const tree_facts facts = tree_check(&v);
    const plt_info *i = &image->info;
    const pack_treelet_score *s = &image->treelets.of[image->treelets.best];
    CHECK(facts.broken == 0, "scene %d, N %u, fill %u, slots %u: %s", scene, o->treelet_nodes,
          o->fill, o->slots, facts.sentence);
    CHECK(facts.treelets == i->treelets && facts.nodes == i->nodes &&
              facts.local == i->local_stack_entries && facts.global == i->global_stack_entries &&
              facts.depth == i->depth_stack_entries,
          "scene %d, N %u: counts", scene, o->treelet_nodes);
    CHECK(i->treelet_nodes == o->treelet_nodes || o->treelet_nodes == PACK_TREELET_AUTO, "N is %u",
          i->treelet_nodes);
    if (pack_treelets_differ(o) && i->nodes > 0) {
        CHECK(s->size == i->treelet_nodes && s->treelets == i->treelets &&
                  s->free_slots == i->node_slots - i->nodes && s->entered >= 1.0,
              "scene %d, N %u: what is said of them", scene, o->treelet_nodes);
    } else {
        CHECK(image->treelets.tried == 0, "figures of the builder's treelets");
    }
}

static void all_are_valid(void) {
    for (int scene = 0; scene < SCENES; scene++) {
        mesh m = make(scene);
        plt_ray rays[RAYS];
        static plt_hit due[RAYS], hits[RAYS];
        random_state r = {(uint64_t)scene};
        const pack_options plain = options_of(64, TREELET_FILL_BFS, TREELET_SLOTS_THESIS, 2);
        rays_mixed(rays, RAYS, &m, &r);
        int has_due = hits_of(&m, &plain, rays, due);
        for (size_t n = 0; n < COUNT(sizes) * TREELET_FILLS * 3; n++) {
            const pack_options o =
                options_of(sizes[n % COUNT(sizes)], (uint8_t)(n / COUNT(sizes) % TREELET_FILLS),
                           (uint8_t)(n / COUNT(sizes) / TREELET_FILLS), 1 + (uint32_t)n % 2);
            packed image;
            fail f = {""};
            CHECK(pack_mesh(&image, &m, &o, "test", &f) == 0, "%s", f.text);
            check_image(&image, &o, scene);
            pack_free(&image);
            const int has_hits = hits_of(&m, &o, rays, has_due ? hits : due);
            CHECK(!has_due || !has_hits || memcmp(hits, due, sizeof hits) == 0,
                  "scene %d, N %u, fill %u, slots %u: hits", scene, o.treelet_nodes, o.fill,
                  o.slots);
            has_due |= has_hits;
        }
        CHECK(has_due, "scene %d: refused, whatever its treelets", scene);
        mesh_free(&m);
    }
}

static void auto_takes_the_least(void) {
    mesh m = make(0);
    for (uint8_t fill = 0; fill < TREELET_FILLS; fill++) {
        const pack_options o = options_of(PACK_TREELET_AUTO, fill, TREELET_SLOTS_THESIS, 1);
        packed image;
        fail f = {""};
        CHECK(pack_mesh(&image, &m, &o, "test", &f) == 0, "%s", f.text);
        const pack_treelets_stats *t = &image.treelets;
        CHECK(t->tried == PACK_TREELET_SIZES && t->of[t->best].size == image.info.treelet_nodes,
              "%u sizes", t->tried);
        for (uint32_t i = 0; i < t->tried; i++) {
            CHECK(t->of[i].size == 8u << i && t->of[t->best].cost <= t->of[i].cost,
                  "N %u costs %g, N %u %g", t->of[i].size, t->of[i].cost, t->of[t->best].size,
                  t->of[t->best].cost);
            pack_options one = o;
            packed alone;
            one.treelet_nodes = t->of[i].size;
            one.fill = fill == TREELET_FILL_BFS ? TREELET_FILL_AREA : fill;
            CHECK(pack_mesh(&alone, &m, &one, "test", &f) == 0, "%s", f.text);
            CHECK(one.fill != fill ||
                      memcmp(&alone.treelets.of[0], &t->of[i], sizeof t->of[i]) == 0,
                  "N %u alone", one.treelet_nodes);
            pack_free(&alone);
        }
        pack_free(&image);
    }
    mesh_free(&m);
}

/* A line enters the root's treelet always; every treelet more costs. */
static void costs_are_sums(void) {
    mesh m = make(1);
    const pack_options small = options_of(8, TREELET_FILL_FULL, TREELET_SLOTS_THESIS, 1);
    const pack_options whole = options_of(10000, TREELET_FILL_FULL, TREELET_SLOTS_THESIS, 1);
    packed a, b;
    fail f = {""};
    CHECK(pack_mesh(&a, &m, &small, "test", &f) == 0 && pack_mesh(&b, &m, &whole, "test", &f) == 0,
          "%s", f.text);
    const pack_treelet_score *one = &b.treelets.of[0];
    CHECK(one->treelets == 1 && one->entered == 1.0 &&
              one->cost == (PACK_TREELET_ENTERING + b.info.nodes) * 10000.0 / b.info.nodes,
          "one treelet of all costs %g", one->cost);
    CHECK(a.treelets.of[0].entered > 1.5 || rig_is_tiny(), "%g", a.treelets.of[0].entered);
    CHECK(a.treelets.of[0].cost < one->cost, "%g", a.treelets.of[0].cost);
    pack_free(&a);
    pack_free(&b);
    mesh_free(&m);
}

/* ---- parity ------------------------------------------------------------------------------- */

typedef struct reading {
    const plt_node *direct, *parity;
    uint32_t edges, inner;
} reading;

/* Both below a node that is reached in a treelet of that value. */
static void read_both(reading *r, uint32_t node, uint32_t value) {
    for (int k = 0; k < 2; k++) {
        const uint32_t link = plt_node_link(&r->direct[node], k);
        const uint32_t other = plt_node_link(&r->parity[node], k);
        CHECK((link & ~PLT_LINK_OUT) == (other & ~PLT_LINK_OUT) || plt_link_is_leaf(link),
              "node %u", node);
        if (plt_link_is_leaf(link)) {
            CHECK(link == other, "a leaf of node %u", node);
            continue;
        }
        const uint32_t there = other >> 1 & 1u;
        const int leaves = (link & PLT_LINK_OUT) != 0;
        CHECK((there != value) == leaves, "node %u: parity", node);
        r->edges += (uint32_t)leaves;
        r->inner += (uint32_t)!leaves;
        read_both(r, plt_link_index(link), there);
    }
}

static void parity_says_the_same(void) {
    mesh m = make(0);
    for (uint8_t fill = 0; fill < TREELET_FILLS; fill++) {
        const pack_options o = options_of(1, TREELET_FILL_BFS, TREELET_SLOTS_THESIS, 1);
        const treelet_wish wish = {7, fill, TREELET_SLOTS_THESIS};
        packed image;
        fail f = {""};
        node_tree t;
        treelet_layout l;
        plt_box box;
        CHECK(pack_mesh(&image, &m, &o, "test", &f) == 0, "%s", f.text);
        memcpy(box.lo, image.info.lo, sizeof box.lo);
        memcpy(box.hi, image.info.hi, sizeof box.hi);
        const tree_view v = tree_view_of(&image);
        const plt_node *nodes = (const plt_node *)(const void *)v.nodes;
        CHECK(node_tree_read(&t, nodes, v.root >> 5, image.info.nodes, &box) == 0, "no memory");
        CHECK(treelets_form(&l, &t.tree, &wish) == 0, "no memory");
        plt_node *both = calloc(2 * (size_t)l.blocks * 7, sizeof *both);
        reading r = {both, both + (size_t)l.blocks * 7, 0, 0};
        node_tree_write(&t, &l, 7, NODE_EDGES_DIRECT, nodes, both);
        node_tree_write(&t, &l, 7, NODE_EDGES_PARITY, nodes, both + (size_t)l.blocks * 7);
        read_both(&r, l.slot[0], 0);
        CHECK(r.edges + 1 == l.treelets && r.edges + r.inner + 1 == image.info.nodes,
              "%u edges of %u treelets", r.edges, l.treelets);
        free(both);
        treelets_free(&l);
        node_tree_free(&t);
        pack_free(&image);
    }
    mesh_free(&m);
}

int main(void) {
    test("images of all fills, slots and sizes are valid, and have the same hits");
    all_are_valid();
    test("auto takes the size that costs least, with the figures of that size alone");
    auto_takes_the_least();
    test("the cost counts treelets that are entered, their nodes, and empty slots");
    costs_are_sums();
    test("the thesis's parity bit and the direct one tell the same treelets apart");
    parity_says_the_same();
    return test_done();
}
