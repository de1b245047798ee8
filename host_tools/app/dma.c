/* dma - see dma.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/dma.h"

#include <string.h>

enum { GARBAGE = 0xA5 };

static uint64_t engine_cycles(const plt_engine *engine) {
    plt_stats q;
    plt_stats_get(engine, &q);
    return DMA_CYCLES_PER_RAY * q.rays + DMA_CYCLES_PER_VISIT * q.node_visits +
           DMA_CYCLES_PER_GROUP_TEST * q.group_tests +
           DMA_CYCLES_PER_TRIANGLE_TEST * q.triangle_tests +
           DMA_CYCLES_PER_BYTE * q.bytes_validated;
}

void dma_settle(dma *d) {
    if (d->engine == NULL) {
        return;
    }
    const uint64_t cycles = engine_cycles(d->engine);
    const uint64_t worked = cycles - d->engine_worked;
    d->engine_worked = cycles;
    d->worked += worked;
    d->now += worked;
}

static void stall_until(dma *d, uint64_t end) {
    if (end > d->now) {
        d->stalled += end - d->now;
        d->now = end;
    }
}

/* ---- starts -------------------------------------------------------------- */

static int is_ordered(const dma *d, const dma_transfer *t, enum dma_failure failure) {
    return d->config.failure == failure && t->number == d->config.at_transfer;
}

static uint64_t limit_cycles(void) {
    return (uint64_t)DMA_CLOCK_MHZ * DMA_LIMIT_US;
}

static uint64_t cycles_of(const dma_config *c, uint32_t count) {
    return (uint64_t)(DMA_CLOCK_MHZ * (c->latency_us + count / c->mb_per_s) + 0.5);
}

/* Those that have not ended, and the first that will; one slot must be free beside. */
static dma_transfer *free_slot(dma *d) {
    unsigned outstanding = 0;
    uint64_t first = UINT64_MAX;
    dma_transfer *slot = NULL;
    for (unsigned i = 0; i < DMA_OUTSTANDING_MOST; i++) {
        dma_transfer *t = &d->pending[i];
        if (t->tag_bit == 0) {
            slot = t;
        } else if (t->end > d->now) {
            outstanding++;
            first = t->end < first ? t->end : first;
        }
    }
    if (outstanding >= d->config.outstanding) {
        stall_until(d, first);
    }
    return slot;
}

static int start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    dma *d = context;
    dma_settle(d);
    dma_transfer *slot = free_slot(d);
    dma_transfer t = {.tag_bit = UINT32_C(1) << (tag & 31),
                      .offset = offset,
                      .count = count,
                      .number = (uint32_t)++d->transfers,
                      .to = to};
    if (slot == NULL || is_ordered(d, &t, DMA_FAILS_AT_START)) {
        d->failed++;
        return -1;
    }
    const uint64_t begin = d->bus_is_free > d->now ? d->bus_is_free : d->now;
    t.end = begin + cycles_of(&d->config, count);
    d->bus_is_free = t.end;
    if (is_ordered(d, &t, DMA_LATE)) {
        t.end = d->now + limit_cycles();
    }
    memset(to, GARBAGE, count);
    *slot = t;
    return 0;
}

/* ---- waits --------------------------------------------------------------- */

static int move(const dma *d, const dma_transfer *t, uint32_t count) {
    const plt_source *from = &d->from;
    return count == 0 || (from->start(from->context, 0, t->offset, t->to, count) >= 0 &&
                          from->wait(from->context, 1) >= 0)
               ? 0
               : -1;
}

static int deliver(dma *d, const dma_transfer *t) {
    const int nothing = is_ordered(d, t, DMA_SILENT) || is_ordered(d, t, DMA_LATE);
    const int half = is_ordered(d, t, DMA_SHORT);
    const uint32_t count = nothing ? 0 : half ? t->count / 2 : t->count;
    int status = move(d, t, count);
    d->bytes += count;
    if (is_ordered(d, t, DMA_GARBLED)) {
        t->to[count / 2] ^= 0x10;
    }
    if (half || is_ordered(d, t, DMA_LATE) || is_ordered(d, t, DMA_FAILS_AT_WAIT)) {
        status = -1;
    }
    d->failed += status < 0;
    return status;
}

static int wait(void *context, uint32_t tags) {
    dma *d = context;
    int status = 0;
    dma_settle(d);
    for (unsigned i = 0; i < DMA_OUTSTANDING_MOST; i++) {
        dma_transfer *t = &d->pending[i];
        if ((t->tag_bit & tags) != 0) {
            stall_until(d, t->end);
            status |= deliver(d, t);
            t->tag_bit = 0;
        }
    }
    return status;
}

plt_source dma_source(dma *d, const plt_source *from, const dma_config *config) {
    const plt_source source = {.bytes = from->bytes, .context = d, .start = start, .wait = wait};
    *d = (dma){.config = *config, .from = *from};
    return source;
}

void dma_reset(dma *d, const plt_engine *engine) {
    d->engine = engine;
    d->engine_worked = engine_cycles(engine);
    d->worked = d->stalled = d->transfers = d->bytes = d->failed = 0;
}

unsigned dma_unfinished(const dma *d) {
    unsigned count = 0;
    for (unsigned i = 0; i < DMA_OUTSTANDING_MOST; i++) {
        count += d->pending[i].tag_bit != 0;
    }
    return count;
}
