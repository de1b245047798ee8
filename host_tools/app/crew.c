/* crew - see crew.h
 *
 * Threads work for a shift, a frame or a file of rays, and wait for the next. Everything that one
 * thread leaves to another passes through the start or the end of a shift, so the counters need
 * no order of memory.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/crew.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/base/clock.h"

/* ---- threads --------------------------------------------------------------------- */

typedef struct shift_of_all {
    crew *c;
    void (*routine)(void *context, crew_worker *w);
    void *context;
} shift_of_all;

static void go(void *shift, unsigned i) {
    const shift_of_all *s = shift;
    s->routine(s->context, &s->c->worker[i]);
}

void crew_on_threads(crew *c, void (*routine)(void *context, crew_worker *w), void *context) {
    shift_of_all shift = {c, routine, context};
    errands_run(c->threads, c->count, go, &shift);
}

/* ---- opening ----------------------------------------------------------------------- */

typedef struct opening {
    unsigned char *arenas;
    size_t arena_bytes;
    const plt_options *options;
} opening;

/* What a shift is, and what opening is, to the threads of one crew. */
typedef struct crew_shift {
    const crew *c;
    opening open;
    const crew_work *work;
    uint64_t *visits; /* of each run; NULL: they are not kept */
    shares shares;
    atomic_uint_fast64_t done;
} crew_shift;

/* The first hands out tasks, if there are any, to all others. */
static plt_options options_of_others(const crew_shift *s) {
    plt_options o = *s->open.options;
    if (o.schedule == PLT_SCHEDULE_TASK) {
        o.schedule = PLT_SCHEDULE_WORKER;
        o.batch = 0;
        o.packet_side = (uint8_t)plt_packet_side(s->c->worker[0].engine);
    }
    return o;
}

static void open_own(void *context, crew_worker *w) {
    const crew_shift *s = context;
    const size_t number = (size_t)(w - s->c->worker);
    if (number > 0) {
        unsigned char *arena = s->open.arenas + number * host_arena_stride(s->open.arena_bytes);
        const plt_options options = options_of_others(s);
        w->status =
            plt_open(&w->engine, arena, s->open.arena_bytes, &w->file.source, &options, &w->fault);
    }
}

static void give_shift(crew *c, crew_shift *shift) {
    for (unsigned i = 0; i < c->count; i++) {
        c->worker[i].shift = shift;
    }
}

int crew_open(crew *c, unsigned count, plt_engine *engine, const host_scene *file,
              const plt_options *options, unsigned char *arenas, size_t arena_bytes) {
    crew_shift shift = {.c = c, .open = {arenas, arena_bytes, options}};
    memset(c->worker, 0, sizeof c->worker);
    c->count = count;
    c->threads = count > 1 ? errands_start(count) : NULL;
    c->worker[0].engine = engine;
    for (unsigned i = 1; i < count; i++) {
        host_scene_share(&c->worker[i].file, file);
    }
    crew_on_threads(c, open_own, &shift);
    for (unsigned i = count; i-- > 0;) {
        c->first = c->worker[i].status != PLT_OK ? i : c->first;
    }
    return c->worker[c->first].status;
}

void crew_close(crew *c) {
    errands_end(c->threads);
    c->threads = NULL;
    for (unsigned i = 1; i < c->count; i++) {
        host_scene_close(&c->worker[i].file);
    }
    c->count = 0;
}

/* ---- work ---------------------------------------------------------------------------- */

static uint64_t visits_of(const crew_worker *w) {
    plt_stats q;
    plt_stats_get(w->engine, &q);
    return q.node_visits;
}

/* Entries of `visits`. */
static uint32_t entries_of(const crew_work *work) {
    return work->items / work->run + 1;
}

static void do_run(crew_worker *w, uint32_t first, uint32_t run) {
    crew_shift *s = w->shift;
    const uint64_t before = visits_of(w);
    w->first = first;
    w->status = s->work->work(s->work->context, w, first, run);
    w->next = first + run;
    if (s->visits != NULL) {
        s->visits[first / s->work->run] = visits_of(w) - before;
    }
}

/* The next run of a worker; 0: it has none. After a failure only what comes before is done: of
 * several failures the first is found, whoever has which run. */
static int next_run(crew_worker *w) {
    crew_shift *s = w->shift;
    uint32_t first = 0;
    const uint32_t run = shares_take(&s->shares, (unsigned)(w - s->c->worker), &first);
    if (run > 0) {
        do_run(w, first, run);
    }
    if (w->status != PLT_OK) {
        shares_end(&s->shares, first);
    }
    return run > 0 && w->status == PLT_OK;
}

static void work_shift(void *context, crew_worker *w) {
    (void)context;
    const double began = clock_thread_seconds();
    while (next_run(w)) {
    }
    w->seconds = clock_thread_seconds() - began;
}

/* Of those that have not ended. */
static crew_worker *least_busy(crew *c, const int *ended) {
    crew_worker *least = NULL;
    for (unsigned i = 0; i < c->count; i++) {
        crew_worker *w = &c->worker[i];
        if (!ended[i] && (least == NULL || visits_of(w) < visits_of(least))) {
            least = w;
        }
    }
    return least;
}

static void take_turns(crew *c) {
    int ended[CREW_MOST] = {0};
    for (crew_worker *w; (w = least_busy(c, ended)) != NULL;) {
        const double began = clock_thread_seconds();
        ended[w - c->worker] = !next_run(w);
        w->seconds += clock_thread_seconds() - began;
    }
}

void crew_done(crew_worker *w, uint32_t items) {
    crew_shift *s = w->shift;
    const uint64_t done = items + atomic_fetch_add_explicit(&s->done, items, memory_order_relaxed);
    if (w == s->c->worker || s->c->in_turns) {
        progress_show(s->work->bar, s->work->before + done);
    }
}

/* ---- what it took ---------------------------------------------------------------------- */

void crew_add_times(const crew *c, crew_times *took, double elapsed) {
    double longest = 0.0, all = 0.0;
    for (unsigned i = 0; i < c->count; i++) {
        const double seconds = c->worker[i].seconds;
        longest = seconds > longest ? seconds : longest;
        all += seconds;
        took->worker[i] += seconds;
    }
    const double fair = all / (c->in_turns ? 1 : clock_processors());
    took->seconds += longest > fair ? longest : fair;
    took->elapsed += elapsed;
}

static uint64_t deal(const uint64_t *visits, uint32_t count, unsigned workers) {
    uint64_t load[1u << (CREW_MODELS - 1)] = {0}, longest = 0;
    for (uint32_t i = 0; i < count; i++) {
        unsigned idle = 0;
        for (unsigned k = 1; k < workers; k++) {
            idle = load[k] < load[idle] ? k : idle;
        }
        load[idle] += visits[i];
        longest = load[idle] > longest ? load[idle] : longest;
    }
    return longest;
}

static void add_models(const crew_shift *s, crew_times *took) {
    const uint32_t count = entries_of(s->work);
    for (unsigned i = 0; s->visits != NULL && i < CREW_MODELS; i++) {
        took->longest[i] += deal(s->visits, count, 1u << i);
    }
    for (uint32_t i = 0; s->visits != NULL && i < count; i++) {
        took->visits += s->visits[i];
    }
}

void crew_times_keep(crew_times *best, const crew_times *took, int is_first) {
    const double elapsed =
        is_first || took->elapsed < best->elapsed ? took->elapsed : best->elapsed;
    if (is_first || took->seconds < best->seconds) {
        *best = *took;
    }
    best->elapsed = elapsed;
}

static int first_failure(crew *c) {
    c->first = 0;
    for (unsigned i = 1; i < c->count; i++) {
        const crew_worker *w = &c->worker[i], *first = &c->worker[c->first];
        if (w->status != PLT_OK && (first->status == PLT_OK || w->first < first->first)) {
            c->first = i;
        }
    }
    return c->worker[c->first].status;
}

void crew_prepare(crew *c) {
    for (unsigned i = 0; i < c->count; i++) {
        c->worker[i].status = PLT_OK;
        c->worker[i].next = 0;
        c->worker[i].seconds = 0.0;
    }
}

int crew_do(crew *c, const crew_work *work, crew_times *took) {
    crew_shift shift = {.c = c, .work = work};
    const double began = clock_seconds();
    if (c->count > 1) {
        shift.visits = calloc(entries_of(work), sizeof *shift.visits);
    }
    crew_prepare(c);
    shares_split(&shift.shares, work->items, work->run, c->count);
    give_shift(c, &shift);
    if (c->in_turns) {
        take_turns(c);
    } else {
        crew_on_threads(c, work_shift, &shift);
    }
    give_shift(c, NULL);
    crew_add_times(c, took, clock_seconds() - began);
    add_models(&shift, took);
    free(shift.visits);
    return first_failure(c);
}

/* ---- statistics -------------------------------------------------------------------------- */

static void add(plt_stats *sum, const plt_stats *q) {
    sum->rays += q->rays;
    sum->node_visits += q->node_visits;
    sum->group_tests += q->group_tests;
    sum->triangle_tests += q->triangle_tests;
    sum->treelet_fetches += q->treelet_fetches;
    sum->bytes_fetched += q->bytes_fetched;
    sum->bytes_touched_once += q->bytes_touched_once;
    sum->store_evictions += q->store_evictions;
    sum->fetch_retries += q->fetch_retries;
    sum->bytes_validated += q->bytes_validated;
    sum->mixed_packets += q->mixed_packets;
    sum->packets += q->packets;
    sum->wave_rays += q->wave_rays;
}

void crew_stats(const crew *c, plt_stats *sum) {
    memset(sum, 0, sizeof *sum);
    for (unsigned i = 0; i < c->count; i++) {
        plt_stats q;
        plt_stats_get(c->worker[i].engine, &q);
        add(sum, &q);
    }
}

void crew_stats_reset(crew *c) {
    for (unsigned i = 0; i < c->count; i++) {
        plt_stats_reset(c->worker[i].engine);
    }
}
