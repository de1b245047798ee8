/* counters - see counters.h
 *
 * SPDX-License-Identifier: MIT */
#define _DEFAULT_SOURCE /* syscall */
#include "host_tools/base/counters.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>

static const uint64_t events[COUNTERS] = {[COUNTER_INSTRUCTIONS] = PERF_COUNT_HW_INSTRUCTIONS,
                                          [COUNTER_CYCLES] = PERF_COUNT_HW_CPU_CYCLES,
                                          [COUNTER_BRANCH_MISSES] = PERF_COUNT_HW_BRANCH_MISSES};

static int open_event(uint64_t event) {
    struct perf_event_attr a;
    memset(&a, 0, sizeof a);
    a.type = PERF_TYPE_HARDWARE;
    a.size = sizeof a;
    a.config = event;
    a.disabled = 1;
    a.exclude_kernel = 1;
    a.exclude_hv = 1;
    a.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
    return (int)syscall(SYS_perf_event_open, &a, 0, -1, -1, PERF_FLAG_FD_CLOEXEC);
}

static void control(const counters *c, unsigned long request) {
    for (int i = 0; i < COUNTERS; i++) {
        if (c->file[i] >= 0) {
            ioctl(c->file[i], request, 0);
        }
    }
}

int counters_open(counters *c) {
    int granted = 0;
    memset(c, 0, sizeof *c);
    for (int i = 0; i < COUNTERS; i++) {
        c->file[i] = open_event(events[i]);
        c->why = c->file[i] < 0 && c->why == NULL ? strerror(errno) : c->why;
        granted += c->file[i] >= 0;
    }
    return granted;
}

void counters_go(counters *c) {
    control(c, PERF_EVENT_IOC_ENABLE);
}

/* The count, and for how long it was wanted and ran. */
static int read_event(const counters *c, int i, uint64_t value[3]) {
    const size_t bytes = 3 * sizeof value[0];
    return c->file[i] >= 0 && read(c->file[i], value, bytes) == (ssize_t)bytes;
}

void counters_clear(counters *c) {
    for (int i = 0; i < COUNTERS; i++) {
        c->count[i] = 0;
        if (!read_event(c, i, c->base[i])) {
            memset(c->base[i], 0, sizeof c->base[i]);
        }
    }
}

/* More events than the processor has counters for take turns: the count is scaled up. */
void counters_stop(counters *c) {
    control(c, PERF_EVENT_IOC_DISABLE);
    for (int i = 0; i < COUNTERS; i++) {
        uint64_t now[3];
        if (read_event(c, i, now)) {
            const double counted = (double)(now[0] - c->base[i][0]);
            const double wanted = (double)(now[1] - c->base[i][1]);
            const double ran = (double)(now[2] - c->base[i][2]);
            c->count[i] = (uint64_t)(ran > 0.0 ? counted * (wanted / ran) : counted);
        }
    }
}

#else

int counters_open(counters *c) {
    memset(c, 0, sizeof *c);
    for (int i = 0; i < COUNTERS; i++) {
        c->file[i] = -1;
    }
    c->why = strerror(ENOSYS);
    return 0;
}

void counters_go(counters *c) {
    (void)c;
}

void counters_stop(counters *c) {
    (void)c;
}

void counters_clear(counters *c) {
    (void)c;
}

#endif

void counters_close(counters *c) {
    for (int i = 0; i < COUNTERS; i++) {
        if (c->file[i] >= 0) {
            close(c->file[i]);
        }
        c->file[i] = -1;
    }
}
