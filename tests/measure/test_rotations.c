/* test_rotations [FILE:FRAMES[:EVERY]...] - would rotations while a tree is refitted pay?
 *
 * FILE is as in animation.h. After each move, every node from the bottom up may swap a child for a
 * child of the other one, if that makes the sum of areas less. What rays cost then, against the
 * tree of frame 0 that is refitted alone, one that is built anew when it has cost what it costs,
 * and one that is built for each frame. Swaps break the order of lists, so this is not in the
 * engine: it works upon the nodes of one that does not look at that order.
 *
 * Source: Kopta, Ize, Spjut, Brunvand, Davis, Kensler, "Fast, effective BVH updates for animated
 * scenes", 2012.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/move.h"
#include "host_tools/base/clock.h"
#include "tests/measure/animation.h"
#include "tests/reference/mover.h"
#include "tests/test.h"

enum { FRAMES_MOST = 100, SIDE = 128 };

/* Of a link: its box, and how many nodes are on the longest path. */
typedef struct below {
    plt_box box;
    uint32_t height;
} below;

typedef struct rotating {
    plt_node *nodes;
    const plt_record *records;
    uint32_t treelet_nodes, depth_most, swaps;
    below *known; /* of each node */
} rotating;

static plt_box box_of_lists(const rotating *r, uint32_t link) {
    plt_box b = plt_box_empty();
    uint32_t i = plt_link_index(link);
    for (uint32_t lists = plt_link_lists(link); lists > 0; i++) {
        const plt_box one = plt_record_box(&r->records[i]);
        plt_box_add(&b, &one);
        lists -= (uint32_t)plt_record_is_last(&r->records[i]);
    }
    return b;
}

static below below_of(const rotating *r, uint32_t link) {
    if (plt_link_is_leaf(link)) {
        const below leaf = {box_of_lists(r, link), 0};
        return leaf;
    }
    return r->known[plt_link_index(link)];
}

static float area_of(const plt_box *a, const plt_box *b) {
    plt_box both = *a;
    plt_box_add(&both, b);
    return plt_box_half_area(&both);
}

static void set_link(rotating *r, uint32_t node, int child, uint32_t link) {
    uint32_t kind = link & PLT_LINK_KIND;
    if (!plt_link_is_leaf(link)) {
        const int is_inner = node / r->treelet_nodes == plt_link_index(link) / r->treelet_nodes;
        kind = is_inner ? 0 : PLT_LINK_OUT;
    }
    plt_node_relink(&r->nodes[node], child, plt_link_make(plt_link_index(link), kind));
}

static void know(rotating *r, uint32_t node) {
    const below left = below_of(r, plt_node_link(&r->nodes[node], 0)),
                right = below_of(r, plt_node_link(&r->nodes[node], 1));
    below all = {left.box, 1 + (left.height > right.height ? left.height : right.height)};
    plt_box_add(&all.box, &right.box);
    r->known[node] = all;
}

/* The best of the four swaps of a child with a child of the other; its depth stays in bounds. */
static void rotate(rotating *r, uint32_t node, uint32_t depth) {
    float gain = 0.0f;
    int best_side = -1, best_child = 0;
    for (int side = 0; side < 2; side++) { /* whose child goes up */
        const uint32_t link = plt_node_link(&r->nodes[node], side);
        const below other = below_of(r, plt_node_link(&r->nodes[node], !side));
        if (plt_link_is_leaf(link) || depth + 2 + other.height >= r->depth_most) {
            continue;
        }
        const plt_node *n = &r->nodes[plt_link_index(link)];
        const float now = plt_box_half_area(&r->known[plt_link_index(link)].box);
        for (int child = 0; child < 2; child++) { /* that goes up */
            const below stays = below_of(r, plt_node_link(n, !child));
            const float less = now - area_of(&other.box, &stays.box);
            if (less > gain) {
                gain = less;
                best_side = side;
                best_child = child;
            }
        }
    }
    if (best_side >= 0) {
        const uint32_t lower = plt_link_index(plt_node_link(&r->nodes[node], best_side));
        const uint32_t down = plt_node_link(&r->nodes[node], !best_side);
        const uint32_t up = plt_node_link(&r->nodes[lower], best_child);
        set_link(r, node, !best_side, up);
        set_link(r, lower, best_child, down);
        know(r, lower);
        r->swaps++;
    }
    know(r, node);
}

static void rotate_below(rotating *r, uint32_t link, uint32_t depth) {
    if (plt_link_is_leaf(link)) {
        return;
    }
    const uint32_t node = plt_link_index(link);
    for (int child = 0; child < 2; child++) {
        rotate_below(r, plt_node_link(&r->nodes[node], child), depth + 1);
    }
    rotate(r, node, depth);
}

static uint32_t rotate_all(plt_engine *e, below *known, double *seconds) {
    const double began = clock_processor_seconds();
    rotating r = {.nodes = (plt_node *)(uintptr_t)e->scene.thesis.nodes,
                  .records = e->scene.thesis.records,
                  .treelet_nodes = e->scene.thesis.treelet_nodes,
                  .depth_most = PLT_DEPTH_MAX,
                  .known = known};
    rotate_below(&r, e->scene.thesis.root, 0);
    *seconds += clock_processor_seconds() - began;
    plt_refit_all(e);
    return r.swaps;
}

static double work_of(plt_engine *e, const float lo[3], const float hi[3], double time) {
    plt_stats before, after;
    plt_stats_get(e, &before);
    for (unsigned camera = 0; camera < 2; camera++) {
        const plt_frame f = animation_view(lo, hi, time, camera, 0, SIDE);
        (void)frame_hash(e, &f, 100000);
    }
    plt_stats_get(e, &after);
    return (double)(after.group_tests - before.group_tests) +
           2.0 * (double)(after.triangle_tests - before.triangle_tests);
}

enum { ALONE, ROTATED, REBUILT, ANEW, WAYS };
static const char *const names[] = {"refitted alone", "rotated after each refit",
                                    "built anew by cost", "built for each frame"};

static void run_way(const animation *s, const mesh *meshes, int way, double *work, double *refits,
                    double *rotations, double *swaps) {
    float lo[3], hi[3];
    rig_config c = rig_config_of(4, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.rebuild = 1;
    mover v = {.bytes = 0};
    animation_box(&meshes[s->frames / 2], lo, hi);
    if (mover_open(&v, &meshes[0], &c, 1) == PLT_OK) {
        below *known = calloc(v.engine->scene.thesis.node_slots + 1, sizeof *known);
        for (unsigned f = 0; f < s->frames; f++) {
            CHECK(mover_move(&v, &meshes[f]) == PLT_OK, "%s", v.fault.message);
            const double began = clock_processor_seconds();
            plt_refit_all(v.engine);
            *refits += clock_processor_seconds() - began;
            if (way == ROTATED) {
                *swaps += rotate_all(v.engine, known, rotations);
            } else if (way == ANEW ||
                       (way == REBUILT && plt_rebuild_due(v.engine, PLT_REBUILD_COST, 0))) {
                plt_rebuild_begin(v.engine, &v.fault);
                while (plt_rebuild_step(v.engine, UINT32_MAX, &v.fault) == PLT_MORE) {
                }
            }
            *work += work_of(v.engine, lo, hi, (double)f / s->frames);
        }
        free(known);
    }
    mover_close(&v);
}

static void run(const animation *s) {
    mesh *meshes = calloc(s->frames, sizeof *meshes);
    double work[WAYS] = {0}, refits = 0, rotations = 0, swaps = 0, other = 0, none = 0;
    int status = 0;
    for (unsigned f = 0; f < s->frames && status == 0; f++) {
        status = animation_frame(&meshes[f], s, f);
    }
    if (status == 0) {
        printf("  %s, %u frames, %zu triangles\n", s->file, s->frames, meshes[0].triangles);
        for (int way = 0; way < WAYS; way++) {
            run_way(s, meshes, way, &work[way], way == ROTATED ? &refits : &other,
                    way == ROTATED ? &rotations : &none, &swaps);
        }
        for (int way = 0; way < WAYS; way++) {
            printf("    %-26s %.3f of the work\n", names[way], work[way] / work[ANEW]);
        }
        printf("    %.0f swaps per frame; a pass for them takes %.1f refits\n", swaps / s->frames,
               rotations / refits);
        CHECK(work[ROTATED] < 1.05 * work[ALONE], "rotations make it worse: %g, %g", work[ROTATED],
              work[ALONE]);
    }
    for (unsigned f = 0; f < s->frames; f++) {
        mesh_free(&meshes[f]);
    }
    free(meshes);
}

int main(int argc, char **argv) {
    return animations_run(argc, argv, "rotations while a tree is refitted: work of rays",
                          FRAMES_MOST, run);
}
