/* ring - see ring.h
 *
 * A byte is written before the count that shows it (release, acquire), and read
 * before the count that frees its slot.
 *
 * SPDX-License-Identifier: MIT */
#include "board/ring.h"

void ring_missed(ring *r) {
    const uint32_t lost = atomic_load_explicit(&r->lost, memory_order_relaxed);
    atomic_store_explicit(&r->lost, lost + 1, memory_order_relaxed);
}

void ring_put(ring *r, uint8_t byte) {
    const uint32_t in = atomic_load_explicit(&r->in, memory_order_relaxed);
    if (in - atomic_load_explicit(&r->out, memory_order_acquire) == PLT_RING_BYTES) {
        ring_missed(r);
        return;
    }
    r->bytes[in % PLT_RING_BYTES] = byte;
    atomic_store_explicit(&r->in, in + 1, memory_order_release);
}

int ring_get(ring *r) {
    const uint32_t out = atomic_load_explicit(&r->out, memory_order_relaxed);
    if (out == atomic_load_explicit(&r->in, memory_order_acquire)) {
        return -1;
    }
    const int byte = r->bytes[out % PLT_RING_BYTES];
    atomic_store_explicit(&r->out, out + 1, memory_order_release);
    return byte;
}

uint32_t ring_lost(const ring *r) {
    return atomic_load_explicit(&r->lost, memory_order_relaxed);
}
