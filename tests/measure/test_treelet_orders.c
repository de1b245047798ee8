/* test_treelet_orders [MESH...] - visits per packet of every order over treelets: Table 5.6
 *
 * Packets of 4x4 rays of a frame of 512x512, spatial median, one triangle per list, as in the
 * thesis. The first column has no treelets at all: two boxes per node, depth first (bvh). Hits are
 * the same in all of them. Without a MESH it takes three small scenes, fewer pixels, and is one
 * test more.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/ray_kinds.h"
#include "host_tools/baselines/structure.h"
#include "host_tools/baselines/treelets/treelets_structure.h"
#include "host_tools/scenes/scenes.h"
#include "tests/measure/animation.h"
#include "tests/reference/rig.h"

enum { ORDERS = 9 };

static uint16_t side = 512; /* of the frame, as the thesis has it */

static const char *const sizes[TREELETS_SIZES] = {"tl2",  "tl3",   "tl7",   "tl8",  "tl16",
                                                  "tl64", "tl256", "tl512", "tl10k"};
static const char *const orders[ORDERS] = {"figure",       "text",        "mirrored",
                                           "figure,again", "sorted,once", "sorted",
                                           "leaf-first",   "heap",        "depth"};
enum { FIGURE = 0, SORTED = 5, DEPTH = 8 };

/* Sums over scenes, of what is 1.0 where it costs nothing: over a hierarchy without treelets, and
 * over one that tests again what has waited, which is depth first. */
static double overhead[ORDERS][TREELETS_SIZES], over_again[ORDERS][TREELETS_SIZES];
static unsigned scenes;

typedef struct subject {
    const mesh *m;
    ray_kinds rays;
    plt_hit *due, *got;
} subject;

/* Visits per packet. */
static double visits(subject *s, const char *words) {
    const ray_set *r = &s->rays.of[RAYS_PRIMARY];
    structure_options o;
    fail f = {""};
    const structure_kind *kind = structure_read(words, "measure", &o, &f);
    o.packet_side = rig_is_tiny() ? 2 : 4;
    built_structure *b = kind != NULL ? structure_open(kind, s->m, &o, words, &f) : NULL;
    CHECK(b != NULL, "%s", f.text);
    if (b == NULL) {
        return 1.0;
    }
    CHECK(structure_trace(b, r->rays, s->got, r->count, 0, &f) == 0, "%s", f.text);
    CHECK(memcmp(s->got, s->due, r->count * sizeof *s->got) == 0, "%s: hits", words);
    const structure_statistics q = structure_count(b);
    structure_close(b);
    return (double)q.packet_nodes / (double)q.packets;
}

/* The rays of the frame, and the engine's hits. */
static int set_up(subject *s, const mesh *m) {
    rig_config c = rig_config_of(2, 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    rig x;
    fail f = {""};
    c.run.packet_side = 2;
    s->m = m;
    int is_set = rig_open(&x, m, &c) == PLT_OK;
    if (is_set) {
        const plt_frame frame = animation_view(x.image.info.lo, x.image.info.hi, 0.0, 0, 0, side);
        is_set = ray_kinds_make(&s->rays, 1u << RAYS_PRIMARY, x.engine, &frame, "frame", &f) == 0;
    }
    const uint32_t count = s->rays.of[RAYS_PRIMARY].count;
    s->due = calloc(count + 1, sizeof *s->due);
    s->got = calloc(count + 1, sizeof *s->got);
    if (is_set) {
        CHECK(plt_trace(x.engine, s->rays.of[RAYS_PRIMARY].rays, s->due, count, 0) == PLT_OK,
              "the rays");
    }
    CHECK(is_set || rig_is_tiny(), "%s %s", x.fault.message, f.text);
    rig_close(&x);
    return is_set;
}

static void measure(const mesh *m, const char *name) {
    subject s = {.m = m};
    if (set_up(&s, m)) {
        const double none = visits(&s, "bvh"), again = visits(&s, "treelets:depth");
        printf("    %s, %zu triangles\n    %-14s %8s", name, m->triangles, "visits", "none");
        for (int n = 0; n < TREELETS_SIZES; n++) {
            printf(" %8s", sizes[n]);
        }
        scenes++;
        for (int order = 0; order < ORDERS; order++) {
            printf("\n    %-14s %8.2f", orders[order], none);
            for (int n = 0; n < TREELETS_SIZES; n++) {
                char words[64];
                snprintf(words, sizeof words, "treelets:%s,%s", sizes[n], orders[order]);
                const double got = visits(&s, words);
                overhead[order][n] += got / none;
                over_again[order][n] += got / again;
                printf(" %8.2f", got);
            }
        }
        printf("\n");
    }
    ray_kinds_free(&s.rays);
    free(s.due);
    free(s.got);
}

static void print_means_over(double means[ORDERS][TREELETS_SIZES], const char *what) {
    printf("    over %s, mean of %u scenes, in per cent\n", what, scenes);
    for (int order = 0; order < ORDERS; order++) {
        printf("    %-14s %8s", orders[order], "");
        for (int n = 0; n < TREELETS_SIZES; n++) {
            printf(" %+8.1f", 100.0 * (means[order][n] / scenes - 1.0));
        }
        printf("\n");
    }
}

static void print_means(void) {
    print_means_over(overhead, "none");
    print_means_over(over_again, "none, with what waited tested again");
}

static void check_means(void) {
    for (int n = 0; n < TREELETS_SIZES; n++) {
        const double figure = overhead[FIGURE][n] / scenes, depth = overhead[DEPTH][n] / scenes;
        const double sorted = overhead[SORTED][n] / scenes;
        CHECK(depth <= 1.01, "%s: depth first %g", sizes[n], depth);
        CHECK(sorted < figure && figure > 1.03, "%s: sorted %g, as they come %g", sizes[n], sorted,
              figure);
    }
}

static int make_scene(mesh *m, int scene, const char **name) {
    static const char *const names[] = {"knot", "terrain", "marbles"};
    const uint32_t triangles = rig_is_tiny() ? 100 : 6000;
    fail f = {""};
    *name = names[scene];
    return scene == 0   ? scene_knot(m, triangles, &f)
           : scene == 1 ? scene_terrain(m, triangles, &f)
                        : scene_marbles(m, rig_is_tiny() ? 160 : triangles, 10, &f);
}

int main(int argc, char **argv) {
    test("orders over treelets have the same hits; depth first costs nothing, others do");
    side = argc > 1 ? side : 128;
    for (int i = 0; i < (argc > 1 ? argc - 1 : 3); i++) {
        mesh m = {0};
        mesh_report report = {0};
        fail f = {""};
        const char *name = argc > 1 ? argv[i + 1] : "";
        const int status =
            argc > 1 ? mesh_read(&m, name, 0, &report, &f) : make_scene(&m, i, &name);
        CHECK(status == 0, "%s", f.text);
        if (status == 0) {
            measure(&m, name);
        }
        mesh_free(&m);
    }
    if (scenes > 0) {
        print_means();
    }
    if (scenes > 0 && !rig_is_tiny()) {
        check_means();
    }
    return test_done();
}
