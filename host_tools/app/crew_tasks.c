/* crew_tasks - see crew_tasks.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/crew_tasks.h"

#include <pthread.h>

#include "host_tools/base/clock.h"

enum { LOCK_TRIES = 100, PAUSE = 20 };

typedef struct shift {
    crew *c;
    const crew_tasks *work;
    plt_engine *dispatcher;
    pthread_mutex_t lock; /* of the dispatcher, and of what follows */
    pthread_cond_t came_back;
    unsigned waiting;
    uint64_t tiles;
} shift;

static void show_progress(shift *s) {
    const crew_tasks *work = s->work;
    uint64_t done = s->tiles;
    if (work->tile == NULL) {
        plt_task_stats q;
        const unsigned side = plt_packet_side(s->dispatcher);
        plt_task_stats_get(s->dispatcher, &q);
        done = q.packets * side * side;
    }
    progress_show(work->bar, work->before + (done < work->items ? done : work->items));
}

/* As plt_task_next; tiles are fetched. */
static int next_task(shift *s, crew_worker *w) {
    int status;
    while ((status = plt_task_next(s->dispatcher, w->engine)) == PLT_TILE) {
        s->work->tile(s->work->context, s->dispatcher);
        s->tiles++;
    }
    show_progress(s);
    return status;
}

static void run_task(const shift *s, const crew_worker *w) {
    while (plt_task_run(s->dispatcher, w->engine, UINT32_MAX) == PLT_MORE) {
    }
}

/* ---- threads ---------------------------------------------------------------------- */

/* The lock is held for less time than it takes to sleep and be woken. */
static void lock_soon(pthread_mutex_t *lock) {
    for (int i = 0; i < LOCK_TRIES; i++) {
        if (pthread_mutex_trylock(lock) == 0) {
            return;
        }
        for (volatile int pause = 0; pause < PAUSE; pause++) {
        }
    }
    pthread_mutex_lock(lock);
}

/* Waits until there is a task. */
static int wait_for_task(shift *s, crew_worker *w) {
    int status;
    lock_soon(&s->lock);
    while ((status = next_task(s, w)) == PLT_WAIT) {
        s->waiting++;
        pthread_cond_wait(&s->came_back, &s->lock);
        s->waiting--;
    }
    if (s->waiting > 0) {
        pthread_cond_broadcast(&s->came_back);
    }
    pthread_mutex_unlock(&s->lock);
    return status;
}

static void work_on(void *context, crew_worker *w) {
    shift *s = context;
    const double began = clock_thread_seconds();
    while ((w->status = wait_for_task(s, w)) > PLT_OK) {
        run_task(s, w);
    }
    w->seconds = clock_thread_seconds() - began;
}

/* ---- turns ------------------------------------------------------------------------- */

typedef struct turns {
    uint64_t clock[CREW_MOST];
    uint8_t has[CREW_MOST], ended[CREW_MOST];
} turns;

static uint64_t visits_of(const crew_worker *w) {
    plt_stats q;
    plt_stats_get(w->engine, &q);
    return q.node_visits;
}

/* The worker whose clock is behind all others', of several first one with a task, which it gives
 * back; count: all have ended. */
static unsigned find_next(const crew *c, const turns *t) {
    unsigned next = c->count;
    for (unsigned i = 0; i < c->count; i++) {
        if (!t->ended[i] && (next == c->count || t->clock[i] < t->clock[next] ||
                             (t->clock[i] == t->clock[next] && t->has[i] > t->has[next]))) {
            next = i;
        }
    }
    return next;
}

/* When the next of the others comes back. */
static uint64_t next_return(const crew *c, const turns *t) {
    uint64_t first = UINT64_MAX;
    for (unsigned i = 0; i < c->count; i++) {
        if (t->has[i] && t->clock[i] < first) {
            first = t->clock[i];
        }
    }
    return first;
}

static uint64_t tasks_of(const shift *s) {
    plt_task_stats q;
    plt_task_stats_get(s->dispatcher, &q);
    return q.tasks;
}

static void take_turn(shift *s, turns *t, unsigned i) {
    crew_worker *w = &s->c->worker[i];
    const double began = clock_thread_seconds();
    const uint64_t tasks = tasks_of(s); /* none for an edge that it keeps */
    const int status = next_task(s, w);
    t->has[i] = status == PLT_MORE;
    if (status == PLT_MORE) {
        const uint64_t before = visits_of(w);
        t->clock[i] += tasks_of(s) - tasks;
        run_task(s, w);
        t->clock[i] += visits_of(w) - before;
    } else if (status == PLT_WAIT) {
        t->clock[i] = next_return(s->c, t);
    } else {
        t->ended[i] = 1;
        w->status = status;
    }
    w->seconds += clock_thread_seconds() - began;
}

static void take_turns(shift *s, crew_times *took) {
    turns t = {{0}, {0}, {0}};
    uint64_t longest = 0;
    for (unsigned i; (i = find_next(s->c, &t)) < s->c->count;) {
        take_turn(s, &t, i);
        longest = t.clock[i] > longest ? t.clock[i] : longest;
    }
    took->longest[0] += longest;
}

/* ---- both --------------------------------------------------------------------------- */

/* A task is counted as a visit, too. */
static uint64_t all_work(const crew *c) {
    plt_task_stats q;
    plt_task_stats_get(c->worker[0].engine, &q);
    uint64_t sum = q.tasks;
    for (unsigned i = 0; i < c->count; i++) {
        sum += visits_of(&c->worker[i]);
    }
    return sum;
}

static int find_failure(crew *c) {
    c->first = 0;
    for (unsigned i = 0; i < c->count; i++) {
        if (c->worker[i].status < 0) {
            c->first = i;
            break;
        }
    }
    return c->worker[c->first].status;
}

int crew_do_tasks(crew *c, const crew_tasks *work, crew_times *took) {
    shift s = {.c = c, .work = work, .dispatcher = c->worker[0].engine};
    const uint64_t before = all_work(c);
    const double began = clock_seconds();
    crew_prepare(c);
    if (c->in_turns) {
        take_turns(&s, took);
        took->visits += all_work(c) - before;
    } else {
        pthread_mutex_init(&s.lock, NULL);
        pthread_cond_init(&s.came_back, NULL);
        crew_on_threads(c, work_on, &s);
        pthread_cond_destroy(&s.came_back);
        pthread_mutex_destroy(&s.lock);
    }
    crew_add_times(c, took, clock_seconds() - began);
    return find_failure(c);
}
