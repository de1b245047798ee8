/* test_rebuild_policies [FILE:FRAMES[:EVERY]...] - when to rebuild a tree of triangles that move
 *
 * FILE is as in animation.h. A tree is built from each frame and refitted to all later ones; what
 * rays then cost, by plt_stats and with a camera that stands or goes around, is a table from which
 * the cost of any choice of rebuilds follows, and by dynamic programming that of the best. A
 * policy's regret is its cost over that. As a build costs as much as few frames or many, six prices
 * are taken, and the worst regret counts. Without a FILE it takes a few frames of marbles and is
 * one test more.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "engine/engine.h"
#include "host_tools/base/clock.h"
#include "tests/measure/animation.h"
#include "tests/reference/mover.h"
#include "tests/test.h"

enum { FRAMES_MOST = 100, SIDE = 128, PRICES = 6, CAMERAS = 3 };

/* What a refit of all costs against a build, K = 4 (test_refit_speed, test_build_speed). */
#define REFIT 0.08

/* Cost of a frame in builds. */
static const double prices[PRICES] = {0.03, 0.1, 0.3, 1.0, 3.0, 10.0};

/* Of the tree of frame r, refitted to frame f. */
typedef struct cell {
    double work[CAMERAS]; /* group tests, a triangle test is two */
    double degradation, growth;
} cell;

typedef struct table {
    unsigned frames;
    cell at[FRAMES_MOST][FRAMES_MOST];
    double refit_seconds, rebuild_seconds, longest_seconds, longest_work, trace_seconds, traced;
    uint32_t triangles;
} table;

static double work_of(plt_engine *e, const plt_frame *frame) {
    plt_stats before, after;
    plt_stats_get(e, &before);
    (void)frame_hash(e, frame, 100000);
    plt_stats_get(e, &after);
    return (double)(after.group_tests - before.group_tests) +
           2.0 * (double)(after.triangle_tests - before.triangle_tests);
}

static void trace(table *t, cell *c, plt_engine *e, const float lo[3], const float hi[3],
                  double time) {
    const double began = clock_processor_seconds();
    for (unsigned camera = 0; camera < CAMERAS; camera++) {
        for (unsigned view = 0; view < 2; view++) {
            const plt_frame f = animation_view(lo, hi, time, camera, view, SIDE);
            c->work[camera] += work_of(e, &f);
        }
        t->traced += c->work[camera];
    }
    t->trace_seconds += clock_processor_seconds() - began;
}

static void keep_least(double *least, double seconds) {
    *least = *least == 0.0 || seconds < *least ? seconds : *least;
}

/* A row of the table: the tree of frame `r`. */
static void fill_row(table *t, const mesh *meshes, unsigned r, const float lo[3],
                     const float hi[3]) {
    rig_config c = rig_config_of(4, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.rebuild = 1; /* so that areas are counted */
    mover v = {.bytes = 0};
    if (mover_open(&v, &meshes[r], &c, 1) == PLT_OK) {
        for (unsigned f = r; f < t->frames; f++) {
            cell *to = &t->at[r][f];
            plt_motion q;
            float(*corners)[9] = mover_corners(&meshes[f]);
            const double began = clock_processor_seconds();
            CHECK(plt_move(v.engine, (const float(*)[9])corners, &v.fault) == PLT_OK, "%s",
                  v.fault.message);
            keep_least(&t->refit_seconds, clock_processor_seconds() - began);
            free(corners);
            plt_motion_get(v.engine, &q);
            to->degradation = (double)q.degradation;
            to->growth = (double)q.growth;
            trace(t, to, v.engine, lo, hi, (double)f / t->frames);
        }
    }
    mover_close(&v);
}

/* ---- policies ---------------------------------------------------------------------- */

typedef struct choice {
    const char *name;
    char kind; /* n never, a always, t threshold, w by work, d by degradation, g by growth */
    double number;
} choice;

static const choice choices[] = {{"never", 'n', 0},
                                 {"always", 'a', 0},
                                 {"threshold 6 %", 't', 0.06},
                                 {"threshold 30 %", 't', 0.30},
                                 {"threshold 40 %", 't', 0.40},
                                 {"growth 30 %", 'T', 0.30},
                                 {"cost, work counted", 'w', 0},
                                 {"cost, 5 x degradation", 'd', 5},
                                 {"cost, 0.3 x growth", 'g', 0.3},
                                 {"cost, 0.5 x growth", 'g', 0.5},
                                 {"cost, 1 x growth", 'g', 1.0},
                                 {"cost, 2 x growth", 'g', 2.0}};
enum { CHOICES = sizeof choices / sizeof *choices };

/* What a new tree would have saved of frame f. */
static double excess_of(const table *t, const choice *c, unsigned camera, unsigned r, unsigned f) {
    const cell *now = &t->at[r][f];
    const double work = now->work[camera];
    if (c->kind == 'w') {
        return fmax(0.0, work - t->at[r][r].work[camera]);
    }
    const double worse = fmax(0.0, c->number * (c->kind == 'd' ? now->degradation : now->growth));
    return work * worse / (1.0 + worse);
}

/* What a policy has done. */
typedef struct outcome {
    double cost; /* in work */
    unsigned rebuilds;
    unsigned slow_run; /* most frames in a row at less than 90 % of a new tree's speed */
} outcome;

/* `build`: its cost in work. Frame 0 has a tree. */
static outcome follow(const table *t, const choice *c, unsigned camera, double build) {
    outcome o = {.cost = t->at[0][0].work[camera]};
    double excess = 0;
    unsigned r = 0, slow = 0;
    for (unsigned f = 1; f < t->frames; f++) {
        excess += excess_of(t, c, camera, r, f - 1);
        const cell *refitted = &t->at[r][f];
        const int is_due = c->kind == 'n'   ? 0
                           : c->kind == 'a' ? 1
                           : c->kind == 't' ? refitted->degradation >= c->number
                           : c->kind == 'T' ? refitted->growth >= c->number
                                            : excess >= build;
        o.cost += REFIT * build;
        if (is_due) {
            o.cost += build;
            r = f;
            excess = 0;
            o.rebuilds++;
        }
        o.cost += t->at[r][f].work[camera];
        slow = 0.9 * t->at[r][f].work[camera] > t->at[f][f].work[camera] ? slow + 1 : 0;
        o.slow_run = slow > o.slow_run ? slow : o.slow_run;
    }
    return o;
}

/* best[r]: the least cost of frames r and later with a tree of frame r. */
static double least_cost(const table *t, unsigned camera, double build) {
    double best[FRAMES_MOST];
    for (unsigned r = t->frames; r-- > 0;) {
        double sum = 0;
        best[r] = INFINITY;
        for (unsigned f = r; f < t->frames; f++) { /* refitted up to f, then built anew */
            sum += t->at[r][f].work[camera] + (f > 0 ? REFIT * build : 0.0);
            const double rest = f + 1 < t->frames ? build + best[f + 1] : 0.0;
            best[r] = fmin(best[r], sum + rest);
        }
    }
    return best[0];
}

static double regret(const table *t, const choice *c, unsigned camera) {
    double worst = 0;
    for (unsigned i = 0; i < PRICES; i++) {
        const double build = t->at[0][0].work[camera] / prices[i];
        worst = fmax(worst, follow(t, c, camera, build).cost / least_cost(t, camera, build));
    }
    return worst;
}

static void print_regrets(const table *t) {
    for (unsigned i = 0; i < CHOICES; i++) {
        printf("    %-22s regret %.3f, camera that goes around %.3f, comes near %.3f\n",
               choices[i].name, regret(t, &choices[i], 0), regret(t, &choices[i], 1),
               regret(t, &choices[i], 2));
    }
}

/* At the price that the engine takes. */
static void print_recovery(const table *t) {
    for (unsigned i = 0; i < CHOICES; i++) {
        if (choices[i].kind == 'n' || (choices[i].kind == 'g' && choices[i].number == 1.0)) {
            const outcome o = follow(t, &choices[i], 0, (double)PLT_REBUILD_WORK * t->triangles);
            printf(
                "    %s, by the engine's price: %u rebuilds, %u frames in a row below 90 %% of "
                "a new tree's speed\n",
                choices[i].name, o.rebuilds, o.slow_run);
        }
    }
}

static void print_trees(const table *t) {
    for (unsigned f = 1; f<t->frames; f += t->frames> 8 ? t->frames / 6 : 1) {
        const cell *old = &t->at[0][f], *anew = &t->at[f][f];
        printf(
            "    frame %u, tree of frame 0: %.2f, %.2f and %.2f times the work, degradation "
            "%.3f, growth %.3f\n",
            f, old->work[0] / anew->work[0], old->work[1] / anew->work[1],
            old->work[2] / anew->work[2], old->degradation, old->growth);
    }
}

/* ---- subtrees, as the engine rebuilds them ------------------------------------------- */

/* All frames with subtrees of at most `most` triangles, rebuilt whenever one has cost what it
 * costs; a tree is `build`. */
static outcome follow_subtrees(const table *t, const mesh *meshes, uint32_t most, unsigned camera,
                               double build, const float lo[3], const float hi[3]) {
    rig_config c = rig_config_of(4, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.rebuild = 1;
    c.run.rebuild_most = most;
    outcome o = {.cost = 0};
    mover v = {.bytes = 0};
    unsigned slow = 0;
    if (mover_open(&v, &meshes[0], &c, 1) == PLT_OK) {
        for (unsigned f = 0; f < t->frames; f++) {
            CHECK(mover_move(&v, &meshes[f]) == PLT_OK, "%s", v.fault.message);
            o.cost += f > 0 ? REFIT * build : 0.0;
            for (;;) {
                plt_motion q;
                plt_motion_get(v.engine, &q);
                const double count = (double)q.build_work / PLT_REBUILD_WORK;
                const double price = build * count / t->triangles;
                if (q.subtrees == 0 || (double)q.excess_work < price) {
                    break;
                }
                CHECK(plt_rebuild_begin(v.engine, &v.fault) == PLT_OK, "%s", v.fault.message);
                while (plt_rebuild_step(v.engine, UINT32_MAX, &v.fault) == PLT_MORE) {
                }
                o.cost += price;
                o.rebuilds++;
            }
            double work = 0;
            for (unsigned view = 0; view < 2; view++) {
                const plt_frame frame =
                    animation_view(lo, hi, (double)f / t->frames, camera, view, SIDE);
                work += work_of(v.engine, &frame);
            }
            o.cost += work;
            slow = 0.9 * work > t->at[f][f].work[camera] ? slow + 1 : 0;
            o.slow_run = slow > o.slow_run ? slow : o.slow_run;
        }
    }
    mover_close(&v);
    return o;
}

static void print_subtrees(const table *t, const mesh *meshes, const float lo[3],
                           const float hi[3]) {
    static const uint32_t parts[] = {1, 4, 16};
    for (unsigned i = 0; i < sizeof parts / sizeof *parts; i++) {
        const uint32_t share = t->triangles / parts[i] + 1;
        const uint32_t most = share > PLT_SUBTREE_LEAST ? share : PLT_SUBTREE_LEAST;
        double worst[CAMERAS] = {0};
        for (unsigned camera = 0; camera < CAMERAS; camera++) {
            for (unsigned price = 0; price < PRICES; price++) {
                const double build = t->at[0][0].work[camera] / prices[price];
                const outcome o = follow_subtrees(t, meshes, most, camera, build, lo, hi);
                worst[camera] = fmax(worst[camera], o.cost / least_cost(t, camera, build));
            }
        }
        const outcome o =
            follow_subtrees(t, meshes, most, 0, (double)PLT_REBUILD_WORK * t->triangles, lo, hi);
        printf(
            "    subtrees, 1/%-10u regret %.3f, camera that goes around %.3f, comes near "
            "%.3f; by the engine's price %u rebuilds, %u frames in a row below 90 %%\n",
            parts[i], worst[0], worst[1], worst[2], o.rebuilds, o.slow_run);
    }
}

/* ---- rebuilds as they are ------------------------------------------------------------- */

/* In steps of a tenth of the triangles. */
static void time_rebuild(table *t, const mesh *first, const mesh *last) {
    rig_config c = rig_config_of(4, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.rebuild = 1;
    mover v = {.bytes = 0};
    if (mover_open(&v, first, &c, 1) == PLT_OK) {
        CHECK(mover_move(&v, last) == PLT_OK, "%s", v.fault.message);
        for (int round = 0; round < 5; round++) {
            double sum = 0, longest = 0;
            int status = plt_rebuild_begin(v.engine, &v.fault);
            CHECK(status == PLT_OK, "%s", v.fault.message);
            do {
                const double began = clock_processor_seconds();
                status = plt_rebuild_step(v.engine, t->triangles / 10 + 1, &v.fault);
                const double took = clock_processor_seconds() - began;
                sum += took;
                longest = took > longest ? took : longest;
            } while (status == PLT_MORE);
            CHECK(status == PLT_OK, "%s", v.fault.message);
            keep_least(&t->rebuild_seconds, sum);
            keep_least(&t->longest_seconds, longest);
        }
    }
    mover_close(&v);
}

static void run(const animation *s) {
    table *t = calloc(1, sizeof *t);
    mesh *meshes = calloc(s->frames, sizeof *meshes);
    float lo[3], hi[3];
    t->frames = s->frames;
    int status = 0;
    for (unsigned f = 0; f < s->frames && status == 0; f++) {
        status = animation_frame(&meshes[f], s, f);
    }
    if (status == 0) {
        t->triangles = (uint32_t)meshes[0].triangles;
        animation_box(&meshes[s->frames / 2], lo, hi); /* the camera stands */
        for (unsigned r = 0; r < s->frames; r++) {
            fill_row(t, meshes, r, lo, hi);
        }
        time_rebuild(t, &meshes[0], &meshes[s->frames - 1]);
        printf("  %s, %u frames, %u triangles\n", s->file, s->frames, t->triangles);
        printf(
            "    million triangles per second: refit with records %.1f, rebuild %.2f; longest "
            "step of a rebuild %.2f refits\n",
            1e-6 * t->triangles / t->refit_seconds, 1e-6 * t->triangles / t->rebuild_seconds,
            t->longest_seconds / t->refit_seconds);
        printf("    a rebuild takes as long as %.0f group tests per triangle\n",
               t->rebuild_seconds / t->triangles / (t->trace_seconds / t->traced));
        print_trees(t);
        print_regrets(t);
        print_recovery(t);
        print_subtrees(t, meshes, lo, hi);
    }
    for (unsigned f = 0; f < s->frames; f++) {
        mesh_free(&meshes[f]);
    }
    free(meshes);
    free(t);
}

int main(int argc, char **argv) {
    return animations_run(argc, argv, "when to rebuild: costs of policies over the least",
                          FRAMES_MOST, run);
}
