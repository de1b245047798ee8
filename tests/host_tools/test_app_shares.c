/* test_app_shares - every item of work is handed out once, whoever takes it
 *
 * SPDX-License-Identifier: MIT */
#include <pthread.h>
#include <string.h>

#include "host_tools/app/shares.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { ITEMS = 3000, THREADS = 8 };

static unsigned char times[ITEMS];

/* Takes a run and marks it; how many items it has. */
static uint32_t take(shares *s, unsigned who) {
    uint32_t first = 0;
    const uint32_t count = shares_take(s, who, &first);
    CHECK(count <= s->run && first % s->run == 0 && first + count <= ITEMS, "%u from %u", count,
          first);
    for (uint32_t i = first; i < first + count; i++) {
        times[i]++;
    }
    return count;
}

/* Items not marked once from 0 to `items`, or at all behind them. */
static uint32_t wrong(uint32_t items) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < ITEMS; i++) {
        count += times[i] != (i < items);
    }
    return count;
}

static void in_any_order(uint32_t items, uint32_t run, unsigned count) {
    random_state r = {items + run + count};
    shares s;
    memset(times, 0, sizeof times);
    shares_split(&s, items, run, count);
    for (uint32_t taken = 1; taken > 0;) {
        taken = 0;
        for (unsigned i = 0; i < count; i++) {
            const unsigned who = random_below(&r, count);
            taken += take(&s, who);
        }
    }
    CHECK(wrong(items) == 0, "%u items, runs of %u, %u workers: %u are wrong", items, run, count,
          wrong(items));
}

/* One alone has its own share first, and all others in the end. */
static void alone(uint32_t items, unsigned count) {
    shares s;
    uint32_t first, last = 0, jumps = 0;
    shares_split(&s, items, 1, count);
    while (shares_take(&s, count / 2, &first) > 0) {
        jumps += first != last + 1;
        last = first;
    }
    CHECK(jumps < 16 * count, "%u of %u items do not follow the last", jumps, items);
}

/* After shares_end all that comes before is still handed out, and nothing behind it. */
static void ended(uint32_t end, unsigned count) {
    shares s;
    memset(times, 0, sizeof times);
    shares_split(&s, ITEMS, 10, count);
    shares_end(&s, ITEMS - 1);
    shares_end(&s, end);
    shares_end(&s, end + 1);
    for (unsigned i = 0; i < count; i++) {
        while (take(&s, count - 1 - i) > 0) {
        }
    }
    CHECK(wrong(end) == 0, "end at %u, %u workers: %u are wrong", end, count, wrong(end));
}

typedef struct taker {
    shares *s;
    unsigned who;
    uint32_t taken;
} taker;

static void *take_all(void *context) {
    taker *t = context;
    uint32_t first, count;
    while ((count = shares_take(t->s, t->who, &first)) > 0) {
        for (uint32_t i = first; i < first + count; i++) {
            times[i]++; /* nobody else's */
        }
        t->taken += count;
    }
    return NULL;
}

static void on_threads(uint32_t run) {
    shares s;
    pthread_t thread[THREADS];
    taker t[THREADS];
    uint32_t taken = 0;
    memset(times, 0, sizeof times);
    shares_split(&s, ITEMS, run, THREADS);
    for (unsigned i = 0; i < THREADS; i++) {
        t[i] = (taker){&s, i, 0};
        CHECK(pthread_create(&thread[i], NULL, take_all, &t[i]) == 0, "no thread");
    }
    for (unsigned i = 0; i < THREADS; i++) {
        pthread_join(thread[i], NULL);
        taken += t[i].taken;
    }
    CHECK(taken == ITEMS && wrong(ITEMS) == 0, "%u taken, %u are wrong", taken, wrong(ITEMS));
}

int main(void) {
    test("every item is handed out once, in any order of workers");
    for (unsigned count = 1; count <= SHARES_MOST; count += 1 + count / 3) {
        for (uint32_t run = 1; run <= 100; run = 3 * run + 1) {
            in_any_order(0, run, count);
            in_any_order(1, run, count);
            in_any_order(count, run, count);
            in_any_order(997, run, count);
            in_any_order(ITEMS, run, count);
        }
        alone(ITEMS, count);
    }
    test("nothing behind the end is handed out, and all before it");
    for (unsigned count = 1; count <= SHARES_MOST; count *= 4) {
        ended(0, count);
        ended(10, count);
        ended(1500, count);
        ended(ITEMS - 10, count);
    }
    test("threads take every item once");
    for (int i = 0; i < 50; i++) {
        on_threads(1);
        on_threads(7);
    }
    return test_done();
}
