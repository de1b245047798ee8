/* clock - see clock.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/clock.h"

#include <time.h>
#include <unistd.h>

static uint64_t read_ns(clockid_t id) {
    struct timespec t;
    clock_gettime(id, &t);
    return (uint64_t)t.tv_sec * 1000000000u + (uint64_t)t.tv_nsec;
}

uint32_t clock_ms(void) {
    return (uint32_t)(read_ns(CLOCK_MONOTONIC) / 1000000);
}

double clock_seconds(void) {
    return 1e-9 * (double)read_ns(CLOCK_MONOTONIC);
}

void clock_sleep(double seconds) {
    const time_t whole = (time_t)seconds;
    const struct timespec t = {whole, (long)(1e9 * (seconds - (double)whole))};
    nanosleep(&t, NULL);
}

double clock_processor_seconds(void) {
    return 1e-9 * (double)read_ns(CLOCK_PROCESS_CPUTIME_ID);
}

double clock_thread_seconds(void) {
    return 1e-9 * (double)read_ns(CLOCK_THREAD_CPUTIME_ID);
}

unsigned clock_processors(void) {
    const long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count > 0 ? (unsigned)count : 1;
}

uint64_t clock_day_us(void) {
    return read_ns(CLOCK_REALTIME) / 1000;
}
