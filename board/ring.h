/* ring - bytes from an interrupt to the program, in static memory
 *
 * One side puts, one side gets, and neither waits: an interrupt and the program
 * below it, or two processors. What comes while the ring is full is lost and
 * counted; what is in it stays whole and in order.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_RING_H
#define PLT_BOARD_RING_H

#include <stdint.h>
#ifdef __cplusplus
#include <atomic>
typedef std::atomic<uint32_t> ring_count;
#else
#include <stdatomic.h>
typedef _Atomic uint32_t ring_count;
#endif

/* Bytes it holds: a power of two, 16 .. 65536. */
#ifndef PLT_RING_BYTES
#define PLT_RING_BYTES 4096
#endif
_Static_assert(PLT_RING_BYTES >= 16 && PLT_RING_BYTES <= 65536 &&
                   (PLT_RING_BYTES & (PLT_RING_BYTES - 1)) == 0,
               "PLT_RING_BYTES is a power of two, 16 .. 65536");

/* All zero is an empty ring. Counts only grow and wrap at 2^32; in - out is what the
 * ring holds. `in` and `lost` are written only by the side that puts, `out` only
 * by the side that gets. */
typedef struct ring {
    ring_count in, out, lost;
    uint8_t bytes[PLT_RING_BYTES];
} ring;

/* The side that puts: a byte that came, and one that the hardware lost. */
void ring_put(ring *r, uint8_t byte);
void ring_missed(ring *r);

/* The side that gets: the oldest byte, or -1: there is none. */
int ring_get(ring *r);

/* Either side: bytes lost so far. */
uint32_t ring_lost(const ring *r);

#endif
