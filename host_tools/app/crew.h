/* crew - workers, each a thread with an engine, an arena and a store of its own
 *
 * As the SPEs of the thesis, section 4.3 (schedule `branch`): each takes work (shares.h) and traces
 * all of it alone. They share the image and nothing else; what they write does not overlap. There
 * is no lock while they work.
 *
 * Keeps: what is made does not depend on how many workers there are, nor on who took which run.
 *
 * SPDX-License-Identifier: MIT */
#ifndef CREW_H
#define CREW_H
#include <stdint.h>

#include "board/host/host.h"
#include "engine/planelet.h"
#include "host_tools/app/errands.h"
#include "host_tools/app/shares.h"
#include "host_tools/base/progress.h"

enum { CREW_MOST = SHARES_MOST };

/* Crews that are simulated besides: 1, 2, 4 and 8 workers. */
enum { CREW_MODELS = 4 };

/* Of each thread: the engine's, some KB, and whatever the system puts there. */
enum { CREW_STACK_BYTES = ERRANDS_STACK_BYTES };

struct crew_shift;

typedef struct crew_worker {
    plt_engine *engine;
    host_scene file;      /* its transfers; the first worker has the scene's own */
    int status;           /* of plt_open, or of its last run */
    plt_fault fault;      /* of plt_open */
    uint32_t first, next; /* items: of the run it took last the first, and, when that is done, the
                           * one behind it, 0 before it took any */
    double seconds;       /* processor time in the last shift */
    struct crew_shift *shift; /* while one lasts */
} crew_worker;

typedef struct crew {
    unsigned count; /* 0: not opened */
    int in_turns; /* no threads: the worker that has visited the fewest nodes takes the next run, as
                   * if all were equally fast; every time the same statistics */
    unsigned first; /* after a failure: the worker whose failure comes first in the work */
    crew_worker worker[CREW_MOST]; /* the first works on the thread that calls */
    errands *threads;              /* of all but the first; NULL: there are none */
} crew;

/* `count` workers (1 .. CREW_MOST), the first with `engine`, which is open on `file`; the others
 * open theirs likewise, all at once, in the arenas of host_arenas behind the first. A status of
 * plt_open; c->first and its fault say whose. Closed in any case. */
int crew_open(crew *c, unsigned count, plt_engine *engine, const host_scene *file,
              const plt_options *options, unsigned char *arenas, size_t arena_bytes);

/* After an opening, failed or not, and of a crew that is all 0: ends its threads. Engines are not
 * used any more. */
void crew_close(crew *c);

/* Items of work of one kind, numbered from 0: tiles, rays. */
typedef struct crew_work {
    uint32_t items;
    uint32_t run; /* that a worker takes at once */
    /* Does items first .. first + count - 1; a status of the engine. */
    int (*work)(void *context, crew_worker *w, uint32_t first, uint32_t count);
    void *context;
    progress *bar;   /* shows before + items done so far */
    uint64_t before; /* items of earlier shifts */
} crew_work;

/* What shifts took. */
typedef struct crew_times {
    double seconds; /* processor time: of the worker that took longest, or, if that is more, of all
                     * over the processors that there are (in turns: of all) */
    double elapsed; /* seconds on the wall */
    double worker[CREW_MOST];
    uint64_t visits;               /* node visits */
    uint64_t longest[CREW_MODELS]; /* ... of the worker that has most, had runs been dealt to 1, 2,
                                    * 4 or 8, each to the one with fewest so far; by tasks, in
                                    * turns, the first: when the last of this crew was done */
} crew_times;

/* Keeps what was faster: the shifts so far, or those that `took` was added to. */
void crew_times_keep(crew_times *best, const crew_times *took, int is_first);

/* All of the work, shared by the crew; adds to `took`. PLT_OK, or the status of the run that
 * failed, of several the first in the work: c->first had it. */
int crew_do(crew *c, const crew_work *work, crew_times *took);

/* For other ways to share work (crew_tasks.h): calls `routine` for every worker, each on a thread
 * of its own but the first; where the system has no thread, the caller's does it, when it is done
 * with the first. */
void crew_on_threads(crew *c, void (*routine)(void *context, crew_worker *w), void *context);

/* ... before: no worker has failed or worked; and after: adds what each took, and all, on the
 * wall. */
void crew_prepare(crew *c);
void crew_add_times(const crew *c, crew_times *took, double elapsed);

/* A worker has done `items` more of its run: the first shows the progress of all. */
void crew_done(crew_worker *w, uint32_t items);

/* Statistics of all workers, summed. */
void crew_stats(const crew *c, plt_stats *sum);
void crew_stats_reset(crew *c);

#endif
