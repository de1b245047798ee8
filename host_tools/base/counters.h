/* counters - what the processor counts while a piece of this program runs
 *
 * The program's own instructions, cycles and mispredicted branches, without those of the
 * system. Only Linux has them here; a virtual machine, a container or the settings of the
 * system (kernel.perf_event_paranoid) may not grant some or all.
 *
 * Source: perf_event_open(2), Linux manual pages.
 *
 * SPDX-License-Identifier: MIT */
#ifndef COUNTERS_H
#define COUNTERS_H
#include <stdint.h>

enum counter { COUNTER_INSTRUCTIONS, COUNTER_CYCLES, COUNTER_BRANCH_MISSES, COUNTERS };

typedef struct counters {
    int file[COUNTERS];         /* -1: not granted */
    const char *why;            /* not granted: what the system says; NULL: all are */
    uint64_t count[COUNTERS];   /* since they were cleared, up to the last stop */
    uint64_t base[COUNTERS][3]; /* what they stood at when they were cleared */
} counters;

/* Never fails: what is not granted counts nothing. Returns how many are granted. */
int counters_open(counters *c);
void counters_close(counters *c);

void counters_clear(counters *c);
/* What runs between go and stop is added. */
void counters_go(counters *c);
void counters_stop(counters *c);

#endif
