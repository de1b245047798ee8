/* test_policy_times [--json=OUT] [FILE:FRAMES[:EVERY]...] - milliseconds per frame by policy
 *
 * FILE is as in animation.h. Each policy renders all frames at 512x512, packets of 16x16, with
 * the engine as it is: plt_move, then what is due of a rebuild, then rays; of a grid plt_move
 * makes it anew. A camera stands, another goes around. Beside them every tree, built from a frame
 * and refitted to all later ones, is timed, and from that follows the least that the best choice of
 * rebuilds could take (dynamic programming): a policy's regret is its time over that, refits and
 * rebuilds at what they take on average, and rays at what their counted work takes by a line
 * through all of these times, so that no frame is better for luck. Pictures have to be equal.
 *
 * By the cost trigger a tree is to be as fast as a new one again, to 90 %, within the frames that
 * it says: those that its excess work, growing as in the frame before, still needs to reach what a
 * tree costs. That is counted, not timed, and checked of the city. Without a FILE it takes a few
 * frames of marbles, smaller, and is one test more.
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

enum { FRAMES_MOST = 100, CAMERAS = 2 };
enum { ROOM = 1 << 20, ROOM_TRIANGLE = 400 }; /* bytes of an arena with a grid */

typedef struct policy {
    const char *name;
    unsigned when, percent; /* enum plt_rebuild_when */
    uint8_t structure;
} policy;

static const policy policies[] = {{"never", PLT_REBUILD_NEVER, 0, PLT_STRUCTURE_TREE},
                                  {"every frame", PLT_REBUILD_ALWAYS, 0, PLT_STRUCTURE_TREE},
                                  {"threshold 30 %", PLT_REBUILD_THRESHOLD, 30, PLT_STRUCTURE_TREE},
                                  {"threshold 40 %", PLT_REBUILD_THRESHOLD, 40, PLT_STRUCTURE_TREE},
                                  {"cost", PLT_REBUILD_COST, 0, PLT_STRUCTURE_TREE},
                                  {"grid", PLT_REBUILD_NEVER, 0, PLT_STRUCTURE_GRID}};
enum { POLICIES = sizeof policies / sizeof *policies, TREES = POLICIES - 1 };

/* Seconds of a frame, in parts. */
typedef struct parts {
    double refit, rebuild, trace;
} parts;

typedef struct course {
    parts at[FRAMES_MOST];
    uint8_t is_rebuilt[FRAMES_MOST]; /* before its rays */
    uint64_t excess[FRAMES_MOST];    /* work, after its rays */
    uint64_t hash[FRAMES_MOST];
    uint64_t build_work;
} course;

/* Tree of frame r, refitted to frame f: seconds, and group tests, of which a triangle test is two.
 */
typedef struct cell {
    double seconds, work;
} cell;

typedef struct table {
    const animation *of;
    mesh *meshes;
    float lo[3], hi[3];
    uint16_t side;
    course by[POLICIES];
    cell at[FRAMES_MOST][FRAMES_MOST];
} table;

static FILE *json;
static const char *comma = "";

static plt_frame view(const table *t, unsigned camera, unsigned f) {
    return animation_view(t->lo, t->hi, (double)f / t->of->frames, camera, 0, t->side);
}

static int open_scene(mover *v, const table *t, unsigned frame, uint8_t structure) {
    rig_config c = rig_config_of(2, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.run.packet_side = PLT_PACKET_SIDE_MAX < 16 ? PLT_PACKET_SIDE_MAX : 16;
    c.run.structure = structure;
    c.run.rebuild = structure == PLT_STRUCTURE_TREE;
    /* A grid is as fine as there is room for it; a tree takes what it needs. */
    const size_t room = ROOM + ROOM_TRIANGLE * t->meshes[frame].triangles;
    *v = (mover){.bytes = structure == PLT_STRUCTURE_GRID ? room : 0};
    return mover_open(v, &t->meshes[frame], &c, 1);
}

static double move(mover *v, const mesh *m) {
    float(*corners)[9] = mover_corners(m);
    const double began = clock_processor_seconds();
    CHECK(plt_move(v->engine, (const float(*)[9])corners, &v->fault) == PLT_OK, "%s",
          v->fault.message);
    const double took = clock_processor_seconds() - began;
    free(corners);
    return took;
}

static double trace(mover *v, const plt_frame *frame, uint64_t *hash) {
    const double began = clock_processor_seconds();
    *hash = frame_hash(v->engine, frame, 100000);
    return clock_processor_seconds() - began;
}

/* ---- policies ---------------------------------------------------------------------------- */

static double rebuild(mover *v, const policy *p, uint8_t *is_rebuilt) {
    const double began = clock_processor_seconds();
    int status = PLT_OK;
    *is_rebuilt = (uint8_t)plt_rebuild_due(v->engine, p->when, p->percent);
    if (*is_rebuilt) {
        CHECK(plt_rebuild_begin(v->engine, &v->fault) == PLT_OK, "%s", v->fault.message);
        do {
            status = plt_rebuild_step(v->engine, UINT32_MAX, &v->fault);
        } while (status == PLT_MORE);
        CHECK(status == PLT_OK, "%s", v->fault.message);
    }
    return clock_processor_seconds() - began;
}

static void follow(table *t, unsigned which, unsigned camera) {
    const policy *p = &policies[which];
    course *c = &t->by[which];
    mover v;
    if (open_scene(&v, t, 0, p->structure) == PLT_OK) {
        for (unsigned f = 0; f < t->of->frames; f++) {
            const plt_frame frame = view(t, camera, f);
            plt_motion q;
            c->at[f].refit = move(&v, &t->meshes[f]);
            c->at[f].rebuild = p->structure == PLT_STRUCTURE_TREE && f > 0
                                   ? rebuild(&v, p, &c->is_rebuilt[f])
                                   : 0.0;
            c->at[f].trace = trace(&v, &frame, &c->hash[f]);
            CHECK(c->hash[f] == t->by[0].hash[f], "%s, frame %u: another picture", p->name, f);
            plt_motion_get(v.engine, &q);
            c->excess[f] = q.excess_work;
            c->build_work = q.build_work;
        }
    }
    mover_close(&v);
}

/* ---- the best choice --------------------------------------------------------------------- */

static double work_of(const mover *v) {
    plt_stats q;
    plt_stats_get(v->engine, &q);
    return (double)q.group_tests + 2.0 * (double)q.triangle_tests;
}

static void fill_row(table *t, unsigned r, unsigned camera) {
    mover v;
    if (open_scene(&v, t, r, PLT_STRUCTURE_TREE) == PLT_OK) {
        for (unsigned f = r; f < t->of->frames; f++) {
            const plt_frame frame = view(t, camera, f);
            uint64_t hash;
            move(&v, &t->meshes[f]);
            const double before = work_of(&v);
            t->at[r][f].seconds = trace(&v, &frame, &hash);
            t->at[r][f].work = work_of(&v) - before;
            CHECK(hash == t->by[0].hash[f], "tree of frame %u, frame %u: another picture", r, f);
        }
    }
    mover_close(&v);
}

/* Times by a line over work: of all cells, that of least squares, or in proportion. */
static void smooth(table *t) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (unsigned r = 0; r < t->of->frames; r++) {
        for (unsigned f = r; f < t->of->frames; f++) {
            const cell *c = &t->at[r][f];
            n += 1;
            x += c->work;
            y += c->seconds;
            xx += c->work * c->work;
            xy += c->work * c->seconds;
        }
    }
    double slope = (n * xy - x * y) / (n * xx - x * x), base = (y - slope * x) / n;
    if (!(slope > 0.0 && base >= 0.0)) {
        slope = y / x;
        base = 0;
    }
    for (unsigned r = 0; r < t->of->frames; r++) {
        for (unsigned f = r; f < t->of->frames; f++) {
            t->at[r][f].seconds = base + slope * t->at[r][f].work;
        }
    }
}

/* What a refit and a rebuild take, on average: of always. */
static parts average(const table *t) {
    const course *always = &t->by[1];
    parts sum = {0, 0, 0};
    for (unsigned f = 1; f < t->of->frames; f++) {
        sum.refit += always->at[f].refit / (t->of->frames - 1);
        sum.rebuild += always->at[f].rebuild / (t->of->frames - 1);
    }
    return sum;
}

/* Least seconds of all frames, over all choices of rebuilds; frame 0 has a tree. */
static double least(const table *t, const parts *each) {
    double best[FRAMES_MOST + 1];
    for (unsigned r = t->of->frames; r-- > 0;) {
        double sum = 0;
        best[r] = INFINITY;
        for (unsigned f = r; f < t->of->frames; f++) {
            sum += t->at[r][f].seconds + each->refit;
            const double rest = f + 1 < t->of->frames ? each->rebuild + best[f + 1] : 0.0;
            best[r] = fmin(best[r], sum + rest);
        }
    }
    return best[0];
}

/* Seconds of a policy's choice, by the same table. */
static double chosen(const table *t, const course *c, const parts *each) {
    double sum = 0;
    for (unsigned f = 0, r = 0; f < t->of->frames; f++) {
        r = c->is_rebuilt[f] ? f : r;
        sum += t->at[r][f].seconds + each->refit + (c->is_rebuilt[f] ? each->rebuild : 0.0);
    }
    return sum;
}

/* ---- 90 % of a new tree's speed -------------------------------------------------------------- */

/* Frames from `f` on, of which the trigger says that they are enough. */
static double said_at(const course *c, unsigned f) {
    const uint64_t before = f > 0 && !c->is_rebuilt[f] ? c->excess[f - 1] : 0;
    const double gain = (double)(c->excess[f] - (c->excess[f] > before ? before : c->excess[f]));
    const double wants = (double)c->build_work - (double)c->excess[f];
    return wants <= 0.0 ? 1.0 : 1.0 + ceil(wants / gain); /* of a gain of 0 for ever */
}

/* Every row of frames at less than 90 %: not longer than said when it began. */
static void check_recovery(const table *t, unsigned camera) {
    const course *c = &t->by[4];
    unsigned longest = 0, run = 0, is_kept = 1;
    double said = 0, longest_said = 0;
    for (unsigned f = 0, r = 0; f < t->of->frames; f++) {
        r = c->is_rebuilt[f] ? f : r;
        const int is_slow = 0.9 * t->at[r][f].work > t->at[f][f].work;
        said = is_slow && run == 0 ? said_at(c, f) : said;
        run = is_slow ? run + 1 : 0;
        is_kept &= run <= said || run == 0;
        if (run > longest) {
            longest = run;
            longest_said = said;
        }
    }
    CHECK(is_kept || strcmp(t->of->file, "city") != 0,
          "%s: below 90 %% of a new tree's speed for longer than the trigger says", t->of->file);
    printf("    cost, camera %s: below 90 %% of a new tree's speed for %u frames at most%s",
           camera ? "goes around" : "stands", longest, longest > 0 ? "" : "\n");
    if (longest > 0) {
        printf(", of which the trigger said %.0f: %s\n", longest_said,
               is_kept ? "kept" : "not kept");
    }
}

/* ---- what is printed ------------------------------------------------------------------------ */

static void print_list(const char *name, const course *c, unsigned frames, unsigned part) {
    fprintf(json, ",\n    \"%s_ms\": [", name);
    for (unsigned f = 0; f < frames; f++) {
        const double s[3] = {c->at[f].refit, c->at[f].rebuild, c->at[f].trace};
        fprintf(json, "%s%.4f", f > 0 ? ", " : "", 1e3 * s[part]);
    }
    fprintf(json, "]");
}

static void print_json(const table *t, unsigned which, unsigned camera, double regret) {
    fprintf(json,
            "%s  {\n    \"file\": \"%s\",\n    \"camera\": \"%s\",\n    \"policy\": \"%s\",\n"
            "    \"frames\": %u",
            comma, t->of->file, camera ? "goes around" : "stands", policies[which].name,
            t->of->frames);
    if (which < TREES) {
        fprintf(json, ",\n    \"regret\": %.4f", regret);
    }
    print_list("refit", &t->by[which], t->of->frames, 0);
    print_list("rebuild", &t->by[which], t->of->frames, 1);
    print_list("trace", &t->by[which], t->of->frames, 2);
    fprintf(json, "\n  }");
    comma = ",\n";
}

static void print_policy(const table *t, unsigned which, unsigned camera, const parts *each,
                         double best) {
    const course *c = &t->by[which];
    const double ms = 1e3 / t->of->frames;
    const double regret = chosen(t, c, each) / best;
    parts sum = {0, 0, 0};
    unsigned rebuilds = 0;
    for (unsigned f = 0; f < t->of->frames; f++) {
        sum.refit += ms * c->at[f].refit;
        sum.rebuild += ms * c->at[f].rebuild;
        sum.trace += ms * c->at[f].trace;
        rebuilds += c->is_rebuilt[f];
    }
    printf("    %-15s %8.3f %8.3f %8.3f %8.3f", policies[which].name, sum.refit, sum.rebuild,
           sum.trace, sum.refit + sum.rebuild + sum.trace);
    if (which < TREES) {
        printf(" %9u %7.2f\n", rebuilds, regret);
    } else {
        printf("\n");
    }
    if (json != NULL) {
        print_json(t, which, camera, regret);
    }
}

static void run_camera(table *t, unsigned camera) {
    memset(t->by, 0, sizeof t->by);
    for (unsigned p = 0; p < POLICIES; p++) {
        follow(t, p, camera);
    }
    for (unsigned r = 0; r < t->of->frames; r++) {
        fill_row(t, r, camera);
    }
    smooth(t);
    const parts each = average(t);
    const double best = least(t, &each);
    printf("    camera %-9s %7s %8s %8s %8s %9s %7s\n", camera ? "around" : "stands", "refit",
           "rebuild", "trace", "all", "rebuilds", "regret");
    for (unsigned p = 0; p < POLICIES; p++) {
        print_policy(t, p, camera, &each, best);
    }
    printf("    %-15s %35.3f\n", "the best choice", 1e3 * best / t->of->frames);
    check_recovery(t, camera);
}

static int is_small; /* nobody has named an animation */

static void run(const animation *s) {
    table *t = calloc(1, sizeof *t);
    t->of = s;
    t->meshes = calloc(s->frames, sizeof *t->meshes);
    t->side = is_small ? 64 : 512;
    int status = 0;
    for (unsigned f = 0; f < s->frames && status == 0; f++) {
        status = animation_frame(&t->meshes[f], s, f);
    }
    if (status == 0) {
        animation_box(&t->meshes[s->frames / 2], t->lo, t->hi); /* the camera stands */
        printf("  %s, %u frames, %zu triangles, %ux%u, K = 2, milliseconds per frame\n", s->file,
               s->frames, t->meshes[0].triangles, t->side, t->side);
        for (unsigned camera = 0; camera < CAMERAS; camera++) {
            run_camera(t, camera);
        }
    }
    for (unsigned f = 0; f < s->frames; f++) {
        mesh_free(&t->meshes[f]);
    }
    free(t->meshes);
    free(t);
}

/* Opens the file of --json=, if that is the first word; how many words that are. */
static int open_json(int argc, char **argv) {
    if (argc < 2 || strncmp(argv[1], "--json=", 7) != 0) {
        return 0;
    }
    json = fopen(argv[1] + 7, "w");
    CHECK(json != NULL, "%s: cannot be created", argv[1] + 7);
    if (json != NULL) {
        fprintf(json, "[\n");
    }
    return 1;
}

int main(int argc, char **argv) {
    const int words = open_json(argc, argv);
    is_small = argc - words < 2;
    const int status = animations_run(argc - words, argv + words,
                                      "milliseconds per frame of each policy", FRAMES_MOST, run);
    if (json != NULL) {
        fprintf(json, "\n]\n");
        return fclose(json) == 0 ? status : 1;
    }
    return status;
}
