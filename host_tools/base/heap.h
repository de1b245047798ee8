/* heap - memory that is counted, and may be limited
 *
 * What grows with the scene comes from here: the bytes in use, the most there were, and a limit
 * that no request gets past. Requests are 64 bits wide, so that a product of a count and a size
 * cannot wrap on a host of 32 bits: there it is refused. The C library's own few bytes per block
 * are not counted; 16 bytes that the counting takes are.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HEAP_H
#define HEAP_H
#include <stdint.h>

/* NULL when there is no such memory, or it is over the limit. Freed by heap_drop alone. */
void *heap_get(uint64_t bytes);
void *heap_get_zeroed(uint64_t bytes);
void *heap_get_aligned(uint64_t bytes); /* to HEAP_ALIGN; cannot be resized */
/* As realloc. Large blocks are taken to grow without a second copy. */
void *heap_resize(void *block, uint64_t bytes);
void heap_drop(void *block); /* NULL is allowed */

#define HEAP_ALIGN 64

/* Counts memory that does not come from here: -1, and nothing is counted, over the limit. */
int heap_count(uint64_t bytes);
void heap_uncount(uint64_t bytes);

/* What heap_get counts for so many bytes. */
uint64_t heap_cost(uint64_t bytes);

uint64_t heap_used(void);
uint64_t heap_peak(void);
void heap_forget_peak(void); /* it is what is in use */

void heap_limit(uint64_t bytes); /* UINT64_MAX, as in the beginning: none */
uint64_t heap_limit_bytes(void);
/* What the first request that the limit refused would have led to; 0: it has refused none. */
uint64_t heap_refused(void);
void heap_forget_refusal(void);

#endif
