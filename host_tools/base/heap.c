/* heap - see heap.h
 *
 * A block lies behind a head with its size. One thread.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/heap.h"

#include <stddef.h>
#include <stdlib.h>

/* As large as the strictest alignment of any type. */
typedef union head {
    struct {
        uint64_t bytes; /* counted: the head and the block */
        void *start;    /* of what the C library gave */
    } is;
    unsigned char room[16];
} head;

static uint64_t used, peak, refused, limit = UINT64_MAX;

int heap_count(uint64_t bytes) {
    if (used > limit || bytes > limit - used) {
        refused = refused > 0 ? refused : used + bytes;
        return -1;
    }
    used += bytes;
    peak = used > peak ? used : peak;
    return 0;
}

void heap_uncount(uint64_t bytes) {
    used -= bytes;
}

uint64_t heap_cost(uint64_t bytes) {
    return bytes > UINT64_MAX - HEAP_ALIGN ? UINT64_MAX : bytes + sizeof(head);
}

/* The request with `more` bytes of head; 0 when it is past all bounds. */
static size_t with_head(uint64_t bytes, size_t more) {
    return bytes > SIZE_MAX / 2 - more ? 0 : (size_t)bytes + more;
}

static head *head_of(void *block) {
    return (head *)block - 1;
}

static void *begin(unsigned char *start, size_t offset, uint64_t counted) {
    if (start == NULL) {
        heap_uncount(counted);
        return NULL;
    }
    head *h = head_of(start + offset);
    h->is.bytes = counted;
    h->is.start = start;
    return start + offset;
}

void *heap_get(uint64_t bytes) {
    const size_t all = with_head(bytes, sizeof(head));
    return all == 0 || heap_count(all) != 0 ? NULL : begin(malloc(all), sizeof(head), all);
}

void *heap_get_zeroed(uint64_t bytes) {
    const size_t all = with_head(bytes, sizeof(head));
    return all == 0 || heap_count(all) != 0 ? NULL : begin(calloc(all, 1), sizeof(head), all);
}

void *heap_get_aligned(uint64_t bytes) {
    const size_t asked = with_head(bytes, 2 * HEAP_ALIGN);
    const size_t all = asked / HEAP_ALIGN * HEAP_ALIGN;
    return all == 0 || heap_count(all) != 0
               ? NULL
               : begin(aligned_alloc(HEAP_ALIGN, all), HEAP_ALIGN, all);
}

void *heap_resize(void *block, uint64_t bytes) {
    if (block == NULL) {
        return heap_get(bytes);
    }
    const uint64_t before = head_of(block)->is.bytes;
    const size_t all = with_head(bytes, sizeof(head));
    if (all == 0 || (all > before && heap_count(all - before) != 0)) {
        return NULL;
    }
    unsigned char *start = realloc(head_of(block)->is.start, all);
    if (start == NULL) {
        heap_uncount(all > before ? all - before : 0);
        return NULL;
    }
    heap_uncount(all < before ? before - all : 0);
    return begin(start, sizeof(head), all);
}

void heap_drop(void *block) {
    if (block != NULL) {
        heap_uncount(head_of(block)->is.bytes);
        free(head_of(block)->is.start);
    }
}

void heap_limit(uint64_t bytes) {
    limit = bytes;
}

uint64_t heap_limit_bytes(void) {
    return limit;
}

uint64_t heap_used(void) {
    return used;
}

uint64_t heap_peak(void) {
    return peak;
}

void heap_forget_peak(void) {
    peak = used;
}

uint64_t heap_refused(void) {
    return refused;
}

void heap_forget_refusal(void) {
    refused = 0;
}
