/* book - see book.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/book.h"

#include <stdio.h>
#include <string.h>

#include "board/hash.h"

enum { JOB = 96 };

const char *const book_sides[BOOK_SIDES] = {"4x4", "8x8", "16x16"};

static const char *const size_jobs[BOOK_SIZES] = {[BOOK_BVH] = "size:bvh:median",
                                                  [BOOK_WBVH] = "size:wbvh",
                                                  [BOOK_BKD] = "size:bkd",
                                                  [BOOK_BPH] = "pack:median,leaf-1,treelet-1",
                                                  [BOOK_BPH2] = "pack:median,leaf-2,treelet-1"};

static const char *const traced_jobs[BOOK_SPLITS] = {
    [BOOK_MEDIAN] = "trace:bph:median,leaf-1,%s", [BOOK_SAH] = "trace:bph:sah,leaf-1,%s"};

static const char *const order_jobs[BOOK_ORDERS] = {
    [BOOK_ORDER_FIGURE] = "trace:treelets:figure,4x4,%s",
    [BOOK_ORDER_TEXT] = "trace:treelets:text,4x4,%s",
    [BOOK_ORDER_MIRRORED] = "trace:treelets:mirrored,4x4,%s",
    [BOOK_ORDER_SORTED] = "trace:treelets:sorted,4x4,%s",
    [BOOK_ORDER_DEPTH] = "trace:treelets:depth,4x4,%s"};

static const char *const treelet_words[PRINTED_TREELET_SIZES] = {
    "tl2", "tl3", "tl7", "tl8", "tl16", "tl64", "tl256", "tl512", "tl10k"};

static const char *const race_jobs[BOOK_RACERS] = {[BOOK_RACE_WBVH] = "wbvh:%s",
                                                   [BOOK_RACE_BPH] = "bph:median,leaf-1,%s",
                                                   [BOOK_RACE_ENGINE] = "tree:%s"};

/* Of scenes in motion all are refitted. */
static const char *const moving_jobs[BOOK_RACERS] = {[BOOK_RACE_WBVH] = "wbvh:%s",
                                                     [BOOK_RACE_BPH] = "bph:median,leaf-1,%s",
                                                     [BOOK_RACE_ENGINE] = "tree-never:%s"};

/* What a figure depends on: a mesh, or several, what is done with them, and rays if there are. */
static uint64_t key_of(const book *b, uint64_t meshes, const char *job, const stage_options *look,
                       unsigned rounds) {
    const uint64_t numbers[] = {b->program, meshes, look != NULL ? look->side : 0,
                                look != NULL ? look->views : 0, rounds};
    const uint64_t hash = hash_bytes((const uint8_t *)numbers, sizeof numbers);
    return hash_update(hash, (const uint8_t *)job, strlen(job));
}

static int in_cache(const book *b, uint64_t key, figures *to) {
    return b->cache != NULL && cache_find(b->cache, key, to);
}

static void show(book *b, const stage *s, const char *job) {
    snprintf(b->doing, sizeof b->doing, "%s %.40s", s->name, job);
    progress_show(&b->bar, b->done);
}

static int has_rays(const char *job) {
    return strncmp(job, "trace:", 6) == 0;
}

/* From the cache, or measured. */
static int take(book *b, stage *s, const char *job, figures *to, fail *f) {
    const uint64_t key = key_of(b, s->hash, job, has_rays(job) ? &b->meter.look : NULL, 0);
    b->done++;
    if (in_cache(b, key, to)) {
        b->from_cache++;
        return 0;
    }
    show(b, s, job);
    if (measure_job(&b->meter, s, job, to, f) != 0) {
        return -1;
    }
    b->measured++;
    return b->cache != NULL ? cache_add(b->cache, key, to, f) : 0;
}

/* The format is one of those above. */
static void fill_in(char *to, const char *format, const char *word) {
    const char *at = strstr(format, "%s");
    snprintf(to, JOB, "%.*s%s%s", (int)(at - format), format, word, at + 2);
}

static int take_sizes(book *b, stage *s, book_scene *to, fail *f) {
    int status = 0;
    for (unsigned i = 0; i < BOOK_SIZES && status == 0; i++) {
        status = take(b, s, size_jobs[i], &to->size[i], f);
    }
    return status;
}

static int take_traced(book *b, stage *s, book_scene *to, fail *f) {
    char job[JOB];
    int status = 0;
    for (unsigned i = 0; i < BOOK_SPLITS * BOOK_SIDES && status == 0; i++) {
        fill_in(job, traced_jobs[i / BOOK_SIDES], book_sides[i % BOOK_SIDES]);
        status = take(b, s, job, &to->traced[i / BOOK_SIDES][i % BOOK_SIDES], f);
    }
    return status;
}

static int take_treelets(book *b, stage *s, book_scene *to, fail *f) {
    char job[JOB];
    int status = 0;
    for (unsigned i = 0; i < PRINTED_TREELET_SIZES && status == 0; i++) {
        snprintf(job, sizeof job, "slots:%u", printed_treelet_sizes[i]);
        status = take(b, s, job, &to->treelets[i], f);
    }
    return status;
}

/* Without treelets, in the first column, is the same for all orders. */
static int take_orders(book *b, stage *s, book_scene *to, fail *f) {
    char job[JOB];
    int status = 0;
    for (unsigned i = 0; i < BOOK_ORDERS * BOOK_TREELETS && status == 0; i++) {
        const unsigned order = i / BOOK_TREELETS, column = i % BOOK_TREELETS;
        if (column == 0) {
            fill_in(job, traced_jobs[BOOK_MEDIAN], book_sides[0]);
        } else {
            fill_in(job, order_jobs[order], treelet_words[column - 1]);
        }
        status = take(b, s, job, &to->treed[order][column], f);
    }
    return status;
}

/* All racers of one side are measured together, or none. `meshes`: of all frames. */
static int take_race(book *b, stage *s, const measure_motion *motion, uint64_t meshes,
                     unsigned side, figures to[BOOK_RACERS], fail *f) {
    char job[BOOK_RACERS][JOB], name[JOB + 8];
    const char *racer[BOOK_RACERS];
    uint64_t key[BOOK_RACERS];
    int found = 0, status;
    b->done++;
    for (unsigned i = 0; i < BOOK_RACERS; i++) {
        fill_in(job[i], (motion != NULL ? moving_jobs : race_jobs)[i], book_sides[side]);
        snprintf(name, sizeof name, "race:%s", job[i]);
        racer[i] = job[i];
        key[i] = key_of(b, meshes, name, &b->meter.look, b->meter.rounds);
        found += in_cache(b, key[i], &to[i]);
    }
    if (found == BOOK_RACERS) {
        b->from_cache++;
        return 0;
    }
    snprintf(name, sizeof name, "race %s", book_sides[side]);
    show(b, s, name);
    status = motion != NULL ? measure_moving_race(&b->meter, s, motion, racer, to, f)
                            : measure_race(&b->meter, s, racer, to, f);
    b->measured += status == 0;
    for (unsigned i = 0; i < BOOK_RACERS && status == 0 && b->cache != NULL; i++) {
        status = cache_add(b->cache, key[i], &to[i], f);
    }
    return status;
}

/* Of all frames, so that a cache knows one that has changed; without a cache 0. */
static int hash_frames(const book *b, const stage *s, const measure_motion *motion, uint64_t *to,
                       fail *f) {
    int status = 0;
    *to = b->cache != NULL ? s->hash : 0;
    for (unsigned i = 1; i < motion->steps && b->cache != NULL && status == 0; i++) {
        mesh m = {0};
        status = motion->frame(motion->context, i, &m, f);
        if (status == 0) {
            const uint64_t hash = stage_hash(&m);
            *to = hash_update(*to, (const uint8_t *)&hash, sizeof hash);
        }
        mesh_free(&m);
    }
    return status;
}

static int take_races(book *b, stage *s, const measure_motion *motion,
                      figures to[BOOK_SIDES][BOOK_RACERS], fail *f) {
    uint64_t meshes = s->hash;
    int status = motion != NULL ? hash_frames(b, s, motion, &meshes, f) : 0;
    for (unsigned i = 0; i < BOOK_SIDES && status == 0; i++) {
        status = take_race(b, s, motion, meshes, i, to[i], f);
    }
    return status;
}

static int write_scene(book *b, unsigned number, fail *f) {
    book_scene *to = &b->scene[number];
    mesh m = {0};
    stage s;
    if (gallery_still(&b->gallery, number, &m, &to->about, f) != 0) {
        return -1;
    }
    to->is_there = 1;
    to->triangles = (unsigned)m.triangles;
    stage_set(&s, printed_scenes[number].name, &m);
    int status = book_has(b, 1) || book_has(b, 2) ? take_sizes(b, &s, to, f) : 0;
    if (status == 0 && book_has(b, 3)) {
        status = take_races(b, &s, NULL, to->race, f);
    }
    if (status == 0 && book_has(b, 4)) {
        status = take_traced(b, &s, to, f);
    }
    if (status == 0 && book_has(b, 5)) {
        status = take_treelets(b, &s, to, f);
    }
    if (status == 0 && book_has(b, 6)) {
        status = take_orders(b, &s, to, f);
    }
    if (status == 0 && b->options.pictures && (status = stage_look(&s, &b->meter.look, f)) == 0) {
        to->picture = s.picture;
        memset(&s.picture, 0, sizeof s.picture);
    }
    stage_free(&s);
    return status;
}

/* What makes the frames of an animation. */
typedef struct frames {
    const gallery *gallery;
    unsigned animation, steps;
} frames;

static int make_frame(void *context, unsigned step, mesh *m, fail *f) {
    const frames *of = context;
    gallery_about about;
    return gallery_frame(of->gallery, of->animation, step, of->steps, m, &about, f);
}

static int write_animation(book *b, unsigned number, fail *f) {
    book_animation *to = &b->animation[number];
    frames context = {&b->gallery, number, b->options.steps};
    const measure_motion motion = {b->options.steps, make_frame, &context};
    mesh m = {0};
    stage s;
    if (gallery_frame(&b->gallery, number, 0, b->options.steps, &m, &to->about, f) != 0) {
        return -1;
    }
    to->is_there = 1;
    to->triangles = (unsigned)m.triangles;
    stage_set(&s, printed_animations[number].name, &m);
    const int status = take_races(b, &s, &motion, to->race, f);
    stage_free(&s);
    return status;
}

static int wants_animation(const book *b, unsigned number) {
    return book_has(b, 3) && (b->options.rows >> printed_animations[number].scene & 1u);
}

static unsigned jobs_of(const book *b) {
    const unsigned sizes = book_has(b, 1) || book_has(b, 2) ? BOOK_SIZES : 0;
    const unsigned races = book_has(b, 3) ? BOOK_SIDES : 0;
    const unsigned traced = book_has(b, 4) ? BOOK_SPLITS * BOOK_SIDES : 0;
    const unsigned treelets = book_has(b, 5) ? PRINTED_TREELET_SIZES : 0;
    const unsigned orders = book_has(b, 6) ? BOOK_ORDERS * BOOK_TREELETS : 0;
    const unsigned rows = (unsigned)__builtin_popcount(b->options.rows);
    unsigned jobs = rows * (sizes + races + traced + treelets + orders);
    for (unsigned i = 0; i < PRINTED_ANIMATIONS; i++) {
        jobs += wants_animation(b, i) ? BOOK_SIDES : 0;
    }
    return jobs;
}

static void blank(figures *first, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        first[i] = figures_none();
    }
}

static void forget_all(book *b) {
    memset(b->scene, 0, sizeof b->scene);
    memset(b->animation, 0, sizeof b->animation);
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        book_scene *s = &b->scene[i];
        blank(&s->size[0], BOOK_SIZES);
        blank(&s->traced[0][0], BOOK_SPLITS * BOOK_SIDES);
        blank(&s->treelets[0], PRINTED_TREELET_SIZES);
        blank(&s->treed[0][0], BOOK_ORDERS * BOOK_TREELETS);
        blank(&s->race[0][0], BOOK_SIDES * BOOK_RACERS);
    }
    for (unsigned i = 0; i < PRINTED_ANIMATIONS; i++) {
        blank(&b->animation[i].race[0][0], BOOK_SIDES * BOOK_RACERS);
    }
}

/* Per triangle, measured: meshes of the thesis's sizes take 150 to 215, and 430 to 530 where three
 * structures race. Besides them what does not grow with the scene. */
enum { TRIANGLE_BYTES = 240, RACE_TRIANGLE_BYTES = 600, FEW_BYTES = 1 << 20 };

uint64_t book_bytes(const book *b) {
    unsigned most = 0;
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        const unsigned triangles = printed_scenes[i].triangles;
        most = (b->options.rows >> i & 1u) && triangles > most ? triangles : most;
    }
    return STAGE_RAY_BYTES + FEW_BYTES +
           (uint64_t)most * (book_has(b, 3) ? RACE_TRIANGLE_BYTES : TRIANGLE_BYTES);
}

int book_write(book *b, fail *f) {
    int status = 0;
    forget_all(b);
    b->program = cache_program();
    b->jobs = jobs_of(b);
    snprintf(b->doing, sizeof b->doing, "tables");
    counters_open(&b->meter.counters);
    progress_begin(&b->bar, b->doing, b->jobs);
    for (unsigned i = 0; i < PRINTED_SCENES && status == 0; i++) {
        status = b->options.rows >> i & 1u ? write_scene(b, i, f) : 0;
    }
    for (unsigned i = 0; i < PRINTED_ANIMATIONS && status == 0; i++) {
        status = wants_animation(b, i) ? write_animation(b, i, f) : 0;
    }
    progress_end(&b->bar);
    counters_close(&b->meter.counters);
    return status;
}

void book_free(book *b) {
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        picture_free(&b->scene[i].picture);
    }
}
