/* dma - a source that takes as long as a board's would: a DMA engine and a slow memory, simulated
 *
 * A processor starts transfers and goes on; the engine moves them one after the other, in the
 * order in which they were started, each with its latency and at the memory's bandwidth. Latency is
 * time on the bus (a command and an address are sent), so more transfers at once do not hide it.
 * A start beyond the number that may be outstanding waits until one has ended.
 *
 * Time is counted in cycles of the processor, at DMA_CLOCK_MHZ. What passes between two calls is
 * the caller's work: its counters say how much. Waiting for a transfer that has not ended makes
 * the processor stall. Bytes come from another source, at the wait; before that there is garbage
 * where they will be.
 *
 * SPDX-License-Identifier: MIT */
#ifndef DMA_H
#define DMA_H

#include "engine/planelet.h"

enum { DMA_CLOCK_MHZ = 168 }; /* a Cortex-M4F of the larger kind */
enum { DMA_OUTSTANDING_MOST = 64, DMA_OUTSTANDING_USUAL = 4 };

/* Cycles of work on a Cortex-M4F (engine/DESIGN.md, section 3.1, says how they were found). */
enum {
    DMA_CYCLES_PER_RAY = 900,
    DMA_CYCLES_PER_VISIT = 1660,
    DMA_CYCLES_PER_GROUP_TEST = 770,
    DMA_CYCLES_PER_TRIANGLE_TEST = 390,
    DMA_CYCLES_PER_BYTE = 47 /* that is validated */
};

/* How transfer number `at_transfer` fails, from 1. */
enum dma_failure {
    DMA_WORKS = 0,
    DMA_FAILS_AT_START, /* its start returns -1, and nothing comes */
    DMA_FAILS_AT_WAIT,  /* all of it comes, its wait returns -1 */
    DMA_SHORT,          /* half of it comes, its wait returns -1 */
    DMA_SILENT,         /* nothing comes, its wait returns 0 */
    DMA_GARBLED,        /* one bit of it is wrong, its wait returns 0 */
    DMA_LATE            /* it has not ended DMA_LIMIT_US after it was started: its wait breaks it
                         * off and returns -1 */
};

enum { DMA_LIMIT_US = 10000 };

typedef struct dma_config {
    double latency_us, mb_per_s; /* 0 or more; above 0 */
    unsigned outstanding;        /* transfers at once, 1 to DMA_OUTSTANDING_MOST */
    enum dma_failure failure;
    uint32_t at_transfer;
} dma_config;

typedef struct dma_transfer {
    uint32_t tag_bit; /* 0: free */
    uint32_t offset, count, number;
    uint64_t end; /* when it will have ended, in cycles */
    unsigned char *to;
} dma_transfer;

typedef struct dma {
    dma_config config;
    plt_source from;
    const plt_engine *engine;  /* whose counters say what it has worked; NULL: it has not */
    uint64_t now, bus_is_free; /* cycles */
    uint64_t worked, stalled;  /* cycles since dma_reset; their sum is the time that passed */
    uint64_t transfers, bytes, failed; /* since then; bytes that came, right or wrong */
    uint64_t engine_worked; /* cycles that the engine's counters gave when they were read last */
    dma_transfer pending[DMA_OUTSTANDING_MOST];
} dma;

/* A source over `from`, which is not mapped; `dma` must stay where it is. */
plt_source dma_source(dma *d, const plt_source *from, const dma_config *config);

/* From now on time is counted, and work as the engine's counters say; they have just been reset. */
void dma_reset(dma *d, const plt_engine *engine);

/* Brings `worked` up to now. */
void dma_settle(dma *d);

/* Transfers that were started and not waited for. */
unsigned dma_unfinished(const dma *d);

#endif
