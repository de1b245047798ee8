/* test_app_errands - each errand is run once, in each of many runs, whatever threads there are
 *
 * SPDX-License-Identifier: MIT */
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>

#include "host_tools/app/errands.h"
#include "tests/test.h"

enum { MOST = 64 };

typedef struct tally {
    unsigned times[MOST];
    pthread_t thread[MOST];
    int is_deaf[MOST]; /* to signals of others, not to its own */
    int sleeps;
} tally;

static void count_one(void *context, unsigned i) {
    tally *t = context;
    const struct timespec pause = {0, 2000000};
    if (t->sleeps && i % 2 == 1) {
        nanosleep(&pause, NULL); /* longer than anyone looks */
    }
    t->times[i]++;
    t->thread[i] = pthread_self();
    sigset_t now;
    pthread_sigmask(SIG_BLOCK, NULL, &now);
    t->is_deaf[i] = sigismember(&now, SIGINT) && !sigismember(&now, SIGSEGV);
}

/* All below `count` were called `times` times, the others never. */
static void expect(const tally *t, unsigned count, unsigned times) {
    unsigned wrong = 0;
    for (unsigned i = 0; i < MOST; i++) {
        wrong += t->times[i] != (i < count ? times : 0);
    }
    CHECK(wrong == 0, "%u of %d errands of %u, %u times each", wrong, MOST, count, times);
}

static void many_runs(unsigned threads, unsigned count, unsigned runs, int sleeps) {
    tally t = {.sleeps = sleeps};
    errands *e = errands_start(threads);
    CHECK(e != NULL, "no memory");
    for (unsigned i = 0; i < runs; i++) {
        errands_run(e, count, count_one, &t);
    }
    expect(&t, count, runs);
    CHECK(pthread_equal(t.thread[0], pthread_self()), "the first is the caller's");
    for (unsigned i = 1; i < count && i < threads; i++) {
        for (unsigned k = 0; k < i; k++) {
            CHECK(!pthread_equal(t.thread[i], t.thread[k]), "%u and %u have one thread", i, k);
        }
        CHECK(t.is_deaf[i], "%u of %u takes the caller's signals", i, threads);
    }
    errands_end(e);
}

/* Threads that cannot be started, as there is no address space for their stacks. */
static void without_room(void) {
    enum { COUNT = 16 };
    tally t = {0};
    struct rlimit before, none;
    void *volatile memory = malloc(4096); /* the heap begins, and has room */
    free(memory);
    CHECK(getrlimit(RLIMIT_AS, &before) == 0, "no limits");
    none = before;
    none.rlim_cur = 1 << 20;
    CHECK(setrlimit(RLIMIT_AS, &none) == 0, "no other limit");
    errands *e = errands_start(COUNT);
    CHECK(setrlimit(RLIMIT_AS, &before) == 0, "the limit stays");
    CHECK(e != NULL, "no memory");
    for (unsigned i = 0; i < 50; i++) {
        errands_run(e, COUNT, count_one, &t);
    }
    expect(&t, COUNT, 50);
    CHECK(pthread_equal(t.thread[COUNT - 1], pthread_self()), "there was room for all threads");
    errands_end(e);
}

int main(void) {
    tally none = {0};
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    printf("    sanitizers end a program without room: that is not tested\n");
#else
    test("what has no thread is done by the caller"); /* first: stacks of threads are kept */
    without_room();
#endif
    test("each errand is run once in each run, by a thread of its own");
    many_runs(1, 1, 100, 0);
    many_runs(2, 2, 3000, 0);
    many_runs(8, 8, 300, 0);
    many_runs(MOST, MOST, 20, 0);
    test("... when those who wait have gone to sleep");
    many_runs(2, 2, 20, 1);
    many_runs(5, 5, 20, 1);
    test("... when there are fewer of them than threads, or more");
    many_runs(8, 3, 100, 0);
    many_runs(2, 7, 100, 0);
    test("without threads the caller does all, and those that had nothing to do end");
    errands_end(errands_start(4));
    errands_end(NULL);
    errands_run(NULL, 5, count_one, &none);
    expect(&none, 5, 1);
    for (unsigned i = 0; i < 5; i++) {
        CHECK(pthread_equal(none.thread[i], pthread_self()), "%u was another's", i);
    }
    return test_done();
}
