/* test_animation_trees [FILE:FRAMES[:EVERY]...] - one tree for all frames against others
 *
 * FILE is as in animation.h. Trees of the first frame, as fast and as well as pack builds them, and
 * one for all frames (pack --tree-for all) are refitted to each frame, and stand beside trees that
 * are built for it alone. Counted is what rays cost, the mean over all frames: those of two
 * views, in packets, and rays from points of the triangles in all directions, one by one. Without
 * a FILE it takes a few frames of marbles.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "host_tools/base/clock.h"
#include "tests/measure/posed.h"
#include "tests/reference/mover.h"

enum { FRAMES_MOST = 1000, SIDE = 128, RAYS = 2000 };

typedef enum tree { FIRST, FIRST_HIGH, ALL, ANEW, ANEW_HIGH, TREES } tree;

static const char *const names[TREES] = {"of the first frame", "... --quality high",
                                         "--tree-for all", "of each frame", "... --quality high"};

/* Per ray. */
typedef struct cost {
    double packet_visits, packet_tests, visits, tests;
} cost;

/* ---- trees ------------------------------------------------------------------------ */

static int is_high(tree t) {
    return t == FIRST_HIGH || t == ALL || t == ANEW_HIGH;
}

static int open_tree(mover *v, const posed *f, tree t, unsigned frame, double *seconds) {
    rig_config c = rig_config_of(2, mover_treelet(64), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    quality_stats stats;
    fail why = {""};
    memset(v, 0, sizeof *v);
    c.pack.poses = t == ALL ? &f->poses : NULL;
    c.run.movable = 1;
    const double began = clock_processor_seconds();
    const mesh *m = &f->frame[frame];
    const int status = is_high(t) ? pack_mesh_better(&v->image, m, &c.pack, 0, &stats, "it", &why)
                                  : pack_mesh(&v->image, m, &c.pack, "it", &why);
    *seconds = clock_processor_seconds() - began;
    CHECK(status == 0, "%s", why.text);
    const plt_source source = rig_source(&v->image);
    v->bytes = plt_arena_need(&v->image.info, 1, &c.run);
    v->arena = guarded_arena(&v->link, v->bytes);
    return plt_open(&v->engine, v->arena, v->bytes, &source, &c.run, &v->fault);
}

/* ---- what rays cost --------------------------------------------------------------- */

static plt_stats stats_of(plt_engine *e) {
    plt_stats s;
    plt_stats_get(e, &s);
    return s;
}

/* The same rays for every tree of a frame. */
static uint64_t trace(plt_engine *e, const posed *f, unsigned frame, cost *sum) {
    const plt_stats before = stats_of(e);
    uint64_t hash = 0;
    for (unsigned view = 0; view < 2; view++) {
        const plt_frame p = animation_view(f->lo, f->hi, 0.0, 0, view, SIDE);
        hash ^= frame_hash(e, &p, 100000) + view;
    }
    const plt_stats between = stats_of(e);
    random_state random = {frame + 1};
    for (unsigned i = 0; i < RAYS; i++) {
        const plt_ray ray = animation_ray(&f->frame[frame], &random);
        plt_hit hit;
        CHECK(plt_trace(e, &ray, &hit, 1, 0) == PLT_OK, "not traced");
        hash = 31 * hash + hit.triangle;
    }
    const plt_stats after = stats_of(e);
    const double pixels = 2.0 * SIDE * SIDE, rays = RAYS;
    sum->packet_visits += (double)(between.node_visits - before.node_visits) / pixels;
    sum->packet_tests += (double)(between.triangle_tests - before.triangle_tests) / pixels;
    sum->visits += (double)(after.node_visits - between.node_visits) / rays;
    sum->tests += (double)(after.triangle_tests - between.triangle_tests) / rays;
    return hash;
}

/* ---- animations ------------------------------------------------------------------------ */

/* `hash[frame]`: of its hits, by the first tree; all others have the same. */
static void follow(const posed *f, tree t, uint64_t *hash) {
    const int is_anew = t == ANEW || t == ANEW_HIGH;
    cost c = {0};
    double seconds = 0.0;
    mover v;
    for (unsigned i = 0; i < f->frames; i++) {
        if (i == 0 || is_anew) {
            CHECK(open_tree(&v, f, t, i, &seconds) == PLT_OK, "%s", v.fault.message);
        }
        CHECK(is_anew || mover_move(&v, &f->frame[i]) == PLT_OK, "%s", v.fault.message);
        const uint64_t hits = trace(v.engine, f, i, &c);
        CHECK(t == FIRST || hits == hash[i], "frame %u: other hits", i);
        hash[i] = hits;
        if (is_anew || i + 1 == f->frames) {
            mover_close(&v);
        }
    }
    printf(
        "    %-20s packets: %.3f visits, %.3f tests per ray; single rays: %.2f visits, "
        "%.2f tests; built in %.2f s\n",
        names[t], c.packet_visits / f->frames, c.packet_tests / f->frames, c.visits / f->frames,
        c.tests / f->frames, seconds);
}

static void run(const animation *a) {
    posed f;
    uint64_t *hash = calloc(a->frames, sizeof *hash);
    if (posed_read(&f, a) == 0) {
        printf("  %s, %u frames, %zu triangles, a tree for %u of them\n", a->file, a->frames,
               f.frame[0].triangles, (unsigned)f.poses.count + 1);
        for (int t = 0; t < TREES; t++) {
            follow(&f, (tree)t, hash);
        }
    }
    posed_free(&f);
    free(hash);
}

int main(int argc, char **argv) {
    return animations_run(argc, argv, "what rays cost with one tree for all frames", FRAMES_MOST,
                          run);
}
