/* test_pack_quality - a tree that was improved is a tree, is better, and gives the same hits
 *
 * Its cost is computed here once more, by recursion over the finished image.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"
#include "host_tools/pack/list_tree.h"
#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/tree_check.h"
#include "tests/test.h"

enum { RAYS = 3000 };

typedef struct whole {
    const plt_node *nodes;
    const plt_record *records;
} whole;

/* Areas of all inner nodes, intermediate ones included; lists have none. */
static double areas_below(const whole *w, uint32_t link, const plt_box *box) {
    if (plt_link_is_leaf(link)) {
        return plt_link_lists(link) == 2 ? list_tree_half_area(box) : 0.0;
    }
    const plt_node *node = &w->nodes[plt_link_index(link)];
    plt_box child[2];
    plt_node_decode(node, box, child);
    return list_tree_half_area(box) + areas_below(w, plt_node_link(node, 0), &child[0]) +
           areas_below(w, plt_node_link(node, 1), &child[1]);
}

static double cost_of(const packed *image) {
    const tree_view v = tree_view_of(image);
    const whole w = {(const plt_node *)(const void *)v.nodes,
                     (const plt_record *)(const void *)v.records};
    plt_box box;
    memcpy(box.lo, v.lo, sizeof box.lo);
    memcpy(box.hi, v.hi, sizeof box.hi);
    const double root = list_tree_half_area(&box);
    return root > 0.0 ? areas_below(&w, v.root, &box) / root : 0.0;
}

static void check_tree(const packed *image, const char *name) {
    const tree_view view = tree_view_of(image);
    const tree_facts facts = tree_check(&view);
    CHECK(facts.broken == 0, "%s: %u rules broken, first: %s", name, facts.broken, facts.sentence);
    CHECK(facts.levels <= PLT_DEPTH_MAX, "%s: %u levels", name, facts.levels);
}

static void check_hits(const rig *fast, const rig *high, const mesh *m, const char *name) {
    plt_ray *rays = malloc(RAYS * sizeof *rays);
    plt_hit *hits[2] = {calloc(RAYS, sizeof *hits[0]), calloc(RAYS, sizeof *hits[1])};
    random_state random = {77};
    void (*const kinds[])(plt_ray *, uint32_t, const mesh *, random_state *) = {rays_mixed,
                                                                                rays_edges};
    for (int k = 0; k < 2; k++) {
        kinds[k](rays, RAYS, m, &random);
        const int one = plt_trace(fast->engine, rays, hits[0], RAYS, 0);
        const int two = plt_trace(high->engine, rays, hits[1], RAYS, 0);
        CHECK(one == two && memcmp(hits[0], hits[1], RAYS * sizeof *hits[0]) == 0,
              "%s: hits differ", name);
    }
    free(hits[0]);
    free(hits[1]);
    free(rays);
}

/* As rig_open, but for the packer. */
static int open_better(rig *r, const mesh *m, const rig_config *config, quality_stats *stats) {
    fail f = {""};
    memset(r, 0, sizeof *r);
    if (pack_mesh_better(&r->image, m, &config->pack, 0, stats, "test", &f) != 0) {
        return PLT_ERR_LIMIT;
    }
    const plt_source source = rig_source(&r->image);
    r->arena_bytes = plt_arena_need(&r->image.info, 1, &config->run);
    r->arena = aligned_alloc(PLT_ALIGN, r->arena_bytes);
    return plt_open(&r->engine, r->arena, r->arena_bytes, &source, &config->run, &r->fault);
}

/* Returns the share of the cost that remains. */
static double check_mesh(const mesh *m, uint32_t k, uint32_t n, uint8_t splits, const char *name) {
    rig_config config = rig_config_of(k, n, PLT_BUILD_HOST, splits);
    rig fast, high;
    packed again;
    quality_stats stats, *const q = &stats;
    fail f = {""};
    config.run.rays_in_flight = 16;
    const int opened = rig_open(&fast, m, &config);
    const int status = open_better(&high, m, &config, q);
    CHECK(high.image.bytes != NULL, "%s: not packed", name);
    /* Trees may need more of the global stack than a build of small limits has. */
    const int is_limited = rig_is_tiny() && (opened == PLT_ERR_LIMIT || status == PLT_ERR_LIMIT);
    CHECK(is_limited || (opened == PLT_OK && status == PLT_OK), "%s: not opened", name);
    check_tree(&high.image, name);
    const double before = cost_of(&fast.image), after = cost_of(&high.image);
    /* Short lists may become one, which takes an intermediate node away. */
    CHECK(after <= before && (q->passes == 0 || after <= q->after * (1.0 + 1e-9)),
          "%s, K = %u: cost %.9g, was %.9g", name, (unsigned)k, after, before);
    CHECK(q->passes == 0 || (q->after <= q->before && fabs(q->before / before - 1.0) < 1e-9),
          "%s: before %g, by the image %g", name, q->before, before);
    if (!is_limited) {
        check_hits(&fast, &high, m, name);
    }
    CHECK(pack_mesh_better(&again, m, &config.pack, 0, &stats, name, &f) == 0, "%s", f.text);
    CHECK(again.size == high.image.size && memcmp(again.bytes, high.image.bytes, again.size) == 0,
          "%s: another image the second time", name);
    pack_free(&again);
    rig_close(&fast);
    rig_close(&high);
    return before > 0.0 ? after / before : 1.0;
}

/* The same as compact blocks; opening validates them. */
static void check_compact(mesh *m, uint32_t k, uint8_t floats, const char *name) {
    compact_config config = compact_config_of(k, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    rig fast, high;
    quality_stats stats;
    config.pack.floats = floats;
    config.pack.numbers = !floats;
    const int opened = compact_open(&fast, m, &config);
    config.pack.quality = &stats;
    const int status = compact_open(&high, m, &config);
    if (rig_is_tiny() && (opened == PLT_ERR_LIMIT || status == PLT_ERR_LIMIT)) {
        return; /* too deep for so few levels */
    }
    CHECK(opened == PLT_OK && status == PLT_OK, "%s: not opened: %d, %d %s", name, opened, status,
          high.fault.message);
    CHECK(high.image.info.triangles == fast.image.info.triangles, "%s: triangles are lost", name);
    CHECK(stats.after <= stats.before, "%s: cost %g, was %g", name, stats.after, stats.before);
    if (opened == PLT_OK && status == PLT_OK && high.image.info.triangles > 0) {
        check_hits(&fast, &high, m, name);
    }
    rig_close(&fast);
    rig_close(&high);
}

static void check_shape(mesh *m, const char *name) {
    static const uint32_t k[] = {1, 2, 4, 2}, n[] = {64, 64, 1, 3};
    test(name);
    for (int i = 0; i < 4; i++) {
        check_mesh(m, k[i], n[i], i == 3 ? PLT_SPLIT_MEDIAN : PLT_SPLIT_SAH, name);
    }
    for (int i = 0; i < 3; i++) {
        check_compact(m, k[i], 0, name);
    }
    check_compact(m, 2, 1, name);
    mesh_free(m);
}

static void test_shapes(void) {
    mesh m = {0};
    shape_soup(&m, rig_triangles(900, 1), 0.7f, 5);
    check_shape(&m, "a soup of large triangles");
    m = (mesh){0};
    shape_sheet(&m, rig_is_tiny() ? 8 : 20, 1);
    check_shape(&m, "a flat sheet");
    m = (mesh){0};
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    check_shape(&m, "a ball");
    m = (mesh){0};
    shape_needles(&m, rig_triangles(200, 1) / 2);
    check_shape(&m, "needles");
    m = (mesh){0};
    shape_coincident(&m, rig_triangles(100, 1) - 2);
    check_shape(&m, "the same triangle many times");
    m = (mesh){0};
    shape_degenerate(&m);
    check_shape(&m, "points and lines among a few triangles");
    m = (mesh){0};
    shape_exponential(&m, rig_triangles(120, 1));
    check_shape(&m, "every triangle half as large as the one before: as deep as may be");
    for (uint32_t few = 1; few < 8; few++) {
        m = (mesh){0};
        shape_soup(&m, few, 0.7f, few);
        check_shape(&m, "few triangles");
    }
}

static void test_gain(void) {
    mesh m = {0};
    fail f = {""};
    if (rig_is_tiny()) {
        return;
    }
    test("a room's tree costs at most four fifths of what it did");
    CHECK(scene_room(&m, 24000, 0, &f) == 0, "%s", f.text);
    const double share = check_mesh(&m, 2, 64, PLT_SPLIT_SAH, "room");
    CHECK(share < 0.8, "%.3f of the cost remains", share);
    check_compact(&m, 2, 0, "room");
    mesh_free(&m);
}

int main(void) {
    test_shapes();
    test_gain();
    return test_done();
}
