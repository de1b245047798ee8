/* test_grid_frames [FILE:FRAMES[:EVERY]...] - a grid made anew for every frame against trees
 *
 * FILE is as in animation.h. The tree of the first frame is refitted, and never built anew, or when
 * that has cost as much as a rebuild, or for every frame; so is the tree that is made for all
 * frames (pack --tree-for all); and the grid is made for every frame. All go from frame to frame
 * side by side, round after round, on one core: what moving, building and rendering take is the
 * least of the rounds, processor time, and what is counted is that of the last one. Without a FILE
 * it takes a few frames of marbles.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "host_tools/base/clock.h"
#include "tests/measure/posed.h"
#include "tests/reference/mover.h"

enum { FRAMES_MOST = 500, ROUNDS = 3, SIDE = 512 };

typedef enum policy { NEVER, COST, ALWAYS, FOR_ALL, GRID, POLICIES } policy;

static const char *const names[POLICIES] = {"never", "cost", "always", "--tree-for all", "grid"};

typedef enum part { MOVE, BUILD, RENDER, PARTS } part;

typedef struct runner {
    mover v;
    plt_source source;
    plt_options options;
    double least[FRAMES_MOST][PARTS]; /* seconds */
    plt_stats stats;                  /* of a round */
    uint32_t rebuilds;
} runner;

/* ---- engines ---------------------------------------------------------------------- */

/* A round begins so, with the triangles of frame 0. */
static void open_runner(runner *r) {
    CHECK(plt_open(&r->v.engine, r->v.arena, r->v.bytes, &r->source, &r->options, &r->v.fault) ==
              PLT_OK,
          "%s", r->v.fault.message);
}

static void set_up(runner *r, const posed *f, policy p) {
    rig_config c = rig_config_of(4, mover_treelet(64), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    fail why = {""};
    c.pack.poses = p == FOR_ALL ? &f->poses : NULL;
    c.run.movable = 1;
    c.run.rebuild = p == COST || p == ALWAYS;
    c.run.count_touched = 0;
    c.run.structure = p == GRID ? PLT_STRUCTURE_GRID : PLT_STRUCTURE_TREE;
    CHECK(mover_pack(&r->v, &f->frame[0], &c.pack, &why) == 0, "%s", why.text);
    r->source = rig_source(&r->v.image);
    r->options = c.run;
    r->v.bytes = plt_arena_need(&r->v.image.info, 1, &c.run) +
                 (p == GRID ? (size_t)80 * f->frame[0].triangles / PLT_ALIGN * PLT_ALIGN : 0);
    r->v.arena = guarded_arena(&r->v.link, r->v.bytes);
}

/* ---- frames ------------------------------------------------------------------------ */

static void keep(runner *r, unsigned frame, part p, double began, int round) {
    const double took = clock_processor_seconds() - began;
    double *least = &r->least[frame][p];
    *least = round == 0 || took < *least ? took : *least;
}

static void rebuild(runner *r, policy p, unsigned frame) {
    const int is_due =
        p == ALWAYS ? frame > 0 : p == COST && plt_rebuild_due(r->v.engine, PLT_REBUILD_COST, 0);
    if (is_due) {
        int status = plt_rebuild_begin(r->v.engine, &r->v.fault);
        CHECK(status == PLT_OK, "%s", r->v.fault.message);
        do {
            status = plt_rebuild_step(r->v.engine, UINT32_MAX, &r->v.fault);
        } while (status == PLT_MORE);
        CHECK(status == PLT_OK, "%s", r->v.fault.message);
        r->rebuilds++;
    }
}

/* The hash of its picture. */
static uint64_t one_frame(runner *r, policy p, const plt_frame *view, float (*corners)[9],
                          unsigned frame, int round) {
    double began = clock_processor_seconds();
    CHECK(plt_move(r->v.engine, (const float(*)[9])corners, &r->v.fault) == PLT_OK, "%s",
          r->v.fault.message);
    keep(r, frame, MOVE, began, round);
    began = clock_processor_seconds();
    rebuild(r, p, frame);
    keep(r, frame, BUILD, began, round);
    began = clock_processor_seconds();
    const uint64_t hash = frame_hash(r->v.engine, view, 1000000);
    keep(r, frame, RENDER, began, round);
    return hash;
}

static void one_round(runner *all, const posed *f, const plt_frame *view, int round) {
    for (unsigned p = 0; p < POLICIES; p++) {
        open_runner(&all[p]);
        all[p].rebuilds = 0;
    }
    for (unsigned i = 0; i < f->frames; i++) {
        float(*corners)[9] = mover_corners(&f->frame[i]);
        uint64_t first = 0;
        for (unsigned p = 0; p < POLICIES; p++) {
            const uint64_t hash = one_frame(&all[p], (policy)p, view, corners, i, round);
            first = p == 0 ? hash : first;
            CHECK(hash == first, "frame %u, %s: another picture", i, names[p]);
        }
        free(corners);
    }
    for (unsigned p = 0; p < POLICIES; p++) {
        plt_stats_get(all[p].v.engine, &all[p].stats);
    }
}

/* ---- figures ---------------------------------------------------------------------- */

/* Milliseconds per frame. */
static double mean(const runner *r, part p, unsigned frames) {
    double sum = 0.0;
    for (unsigned i = 0; i < frames; i++) {
        sum += r->least[i][p];
    }
    return 1e3 * sum / frames;
}

static void print(const runner *all, unsigned frames) {
    double whole[POLICIES];
    unsigned best = 0;
    for (unsigned p = 0; p < POLICIES; p++) {
        const runner *r = &all[p];
        const double move = mean(r, MOVE, frames), build = mean(r, BUILD, frames);
        const double render = mean(r, RENDER, frames), rays = (double)r->stats.rays;
        whole[p] = move + build + render;
        best = p < GRID && whole[p] < whole[best] ? p : best;
        printf(
            "    %-15s %7.2f ms per frame: moved %6.2f, rebuilt %6.2f (%u times), rendered "
            "%6.2f; per ray %.3f nodes or cells, %.3f group and %.3f triangle tests\n",
            names[p], whole[p], move, build, r->rebuilds, render,
            (double)r->stats.node_visits / rays, (double)r->stats.group_tests / rays,
            (double)r->stats.triangle_tests / rays);
    }
    printf("    a grid's frame takes %.2f of the time of the best tree's (%s)\n",
           whole[GRID] / whole[best], names[best]);
}

static void compare(const posed *f) {
    runner *all = calloc(POLICIES, sizeof *all);
    const plt_frame view = animation_view(f->lo, f->hi, 0.0, 0, 0, SIDE);
    for (unsigned p = 0; p < POLICIES; p++) {
        set_up(&all[p], f, (policy)p);
    }
    for (int round = 0; round < ROUNDS; round++) {
        one_round(all, f, &view, round);
    }
    print(all, f->frames);
    for (unsigned p = 0; p < POLICIES; p++) {
        mover_close(&all[p].v);
    }
    free(all);
}

static void run(const animation *a) {
    posed f;
    if (posed_read(&f, a) == 0) {
        printf("  %s, %u frames, %zu triangles, %dx%d\n", a->file, a->frames, f.frame[0].triangles,
               SIDE, SIDE);
        compare(&f);
    }
    posed_free(&f);
}

int main(int argc, char **argv) {
    return animations_run(argc, argv, "a grid for every frame against trees: the same pictures",
                          FRAMES_MOST, run);
}
