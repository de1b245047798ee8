/* errands - see errands.h
 *
 * The number of a run is written last, and read first; the count of those who are left likewise.
 * Who waits looks for a while before it sleeps, as runs often follow each other at once.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/errands.h"

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>

/* Looks before it sleeps: some ten microseconds. */
enum { LOOKS = 10000 };

typedef struct place {
    struct errands *of;
    pthread_t thread;
    unsigned number;
    int is_started;
} place;

struct errands {
    pthread_mutex_t lock; /* of those who sleep */
    pthread_cond_t begins, ends;
    void (*routine)(void *context, unsigned i); /* NULL: threads end */
    void *context;
    unsigned wanted;          /* of this run, the caller too */
    unsigned started;         /* threads */
    atomic_uint_fast64_t run; /* its number */
    atomic_uint left;         /* threads that have not come back */
    unsigned count;
    place place[]; /* [count], the first the caller's */
};

/* ---- waiting ------------------------------------------------------------------------ */

static void wait_for_run(errands *e, uint_fast64_t last) {
    for (int i = 0; i < LOOKS; i++) {
        if (atomic_load(&e->run) != last) {
            return;
        }
    }
    pthread_mutex_lock(&e->lock);
    while (atomic_load(&e->run) == last) {
        pthread_cond_wait(&e->begins, &e->lock);
    }
    pthread_mutex_unlock(&e->lock);
}

static void wait_for_all(errands *e) {
    for (int i = 0; i < LOOKS; i++) {
        if (atomic_load(&e->left) == 0) {
            return;
        }
    }
    pthread_mutex_lock(&e->lock);
    while (atomic_load(&e->left) > 0) {
        pthread_cond_wait(&e->ends, &e->lock);
    }
    pthread_mutex_unlock(&e->lock);
}

static void come_back(errands *e) {
    if (atomic_fetch_sub(&e->left, 1) == 1) {
        pthread_mutex_lock(&e->lock);
        pthread_cond_signal(&e->ends);
        pthread_mutex_unlock(&e->lock);
    }
}

/* ---- threads -------------------------------------------------------------------------- */

static void *work(void *of) {
    const place *mine = of;
    errands *e = mine->of;
    for (uint_fast64_t last = 0;; last++) {
        wait_for_run(e, last);
        if (e->routine == NULL) {
            return NULL;
        }
        if (mine->number < e->wanted) {
            e->routine(e->context, mine->number);
        }
        come_back(e);
    }
}

/* Signals are for the thread that called: their handlers change what is its own. But for those that
 * a thread provokes itself. */
static void block_signals(sigset_t *before) {
    static const int own[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL};
    sigset_t set;
    sigfillset(&set);
    for (unsigned i = 0; i < sizeof own / sizeof own[0]; i++) {
        sigdelset(&set, own[i]);
    }
    pthread_sigmask(SIG_BLOCK, &set, before);
}

static void start_threads(errands *e) {
    pthread_attr_t small;
    sigset_t before;
    if (pthread_attr_init(&small) != 0) {
        return;
    }
    (void)pthread_attr_setstacksize(&small, ERRANDS_STACK_BYTES); /* else the usual ones */
    block_signals(&before);
    for (unsigned i = 1; i < e->count; i++) {
        place *p = &e->place[i];
        p->of = e;
        p->number = i;
        p->is_started = pthread_create(&p->thread, &small, work, p) == 0;
        e->started += p->is_started != 0;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    pthread_attr_destroy(&small);
}

errands *errands_start(unsigned count) {
    errands *e = calloc(1, sizeof *e + count * sizeof e->place[0]);
    if (e != NULL) {
        pthread_mutex_init(&e->lock, NULL);
        pthread_cond_init(&e->begins, NULL);
        pthread_cond_init(&e->ends, NULL);
        e->count = count;
        start_threads(e);
    }
    return e;
}

/* ---- runs ------------------------------------------------------------------------------ */

static void begin_run(errands *e) {
    atomic_store(&e->left, e->started);
    pthread_mutex_lock(&e->lock);
    atomic_fetch_add(&e->run, 1);
    pthread_cond_broadcast(&e->begins);
    pthread_mutex_unlock(&e->lock);
}

void errands_run(errands *e, unsigned count, void (*routine)(void *context, unsigned i),
                 void *context) {
    if (e != NULL) {
        e->routine = routine;
        e->context = context;
        e->wanted = count;
        begin_run(e);
    }
    for (unsigned i = 0; i < count; i++) {
        if (e == NULL || i >= e->count || !e->place[i].is_started) {
            routine(context, i);
        }
    }
    if (e != NULL) {
        wait_for_all(e);
    }
}

void errands_end(errands *e) {
    if (e == NULL) {
        return;
    }
    e->routine = NULL;
    begin_run(e);
    for (unsigned i = 1; i < e->count; i++) {
        if (e->place[i].is_started) {
            pthread_join(e->place[i].thread, NULL);
        }
    }
    pthread_cond_destroy(&e->ends);
    pthread_cond_destroy(&e->begins);
    pthread_mutex_destroy(&e->lock);
    free(e);
}
