/* test_board_ring - bytes from an interrupt to the program
 *
 * SPDX-License-Identifier: MIT */
#include <pthread.h>

#include "board/ring.h"
#include "tests/test.h"

enum { STREAM_BYTES = 4000000 };

static void in_order(uint32_t begin) {
    ring r = {.in = begin, .out = begin};
    uint32_t put = 0, got = 0;
    for (uint32_t step = 1; put < 5 * PLT_RING_BYTES; step = step * 7 % 1009) {
        for (uint32_t i = 0; i < step % 97 && put - got < PLT_RING_BYTES; i++) {
            ring_put(&r, (uint8_t)(put++ * 31));
        }
        for (uint32_t i = 0; i < step % 89 && got < put; i++) {
            const int byte = ring_get(&r);
            CHECK(byte == (uint8_t)(got * 31), "byte %u is %d", got, byte);
            got++;
        }
    }
    while (got < put) {
        const int byte = ring_get(&r);
        CHECK(byte == (uint8_t)(got * 31), "byte %u is %d", got, byte);
        got++;
    }
    CHECK(ring_get(&r) == -1 && ring_lost(&r) == 0, "%u lost", ring_lost(&r));
}

static void overflow(void) {
    test("of what does not fit the first bytes stay, the rest is counted");
    ring r = {.in = UINT32_MAX - 5, .out = UINT32_MAX - 5};
    for (unsigned i = 0; i < PLT_RING_BYTES + 300; i++) {
        ring_put(&r, (uint8_t)i);
    }
    ring_missed(&r);
    CHECK(ring_lost(&r) == 301, "%u lost", ring_lost(&r));
    for (unsigned i = 0; i < PLT_RING_BYTES; i++) {
        CHECK(ring_get(&r) == (uint8_t)i, "byte %u", i);
    }
    CHECK(ring_get(&r) == -1, "more than was kept");
    ring_put(&r, 7);
    CHECK(ring_get(&r) == 7 && ring_get(&r) == -1 && ring_lost(&r) == 301, "it goes on");
}

static ring shared;

/* Instead of the interrupt, which waits for no one. The first half comes at a
 * speed at which the ring is empty most of the time, the second floods it. */
static void *put_all(void *context) {
    (void)context;
    for (uint32_t i = 0; i < STREAM_BYTES; i++) {
        ring_put(&shared, (uint8_t)(i % 251));
        for (volatile unsigned wait = i < STREAM_BYTES / 2 ? 20 : 0; wait > 0; wait--) {
        }
    }
    return NULL;
}

/* What was lost is missing, and nothing else is: a gap of 251 n bytes is not seen,
 * the sum of all shows it. */
static void threads(void) {
    pthread_t putting;
    uint32_t got = 0, gaps = 0;
    test("two threads: every byte comes or is counted as lost, none twice or changed");
    const int error = pthread_create(&putting, NULL, put_all, NULL);
    CHECK(error == 0, "no thread: error %d", error);
    if (error != 0) {
        return;
    }
    for (unsigned next = 0; got + ring_lost(&shared) < STREAM_BYTES;) {
        const int byte = ring_get(&shared);
        if (byte < 0) {
            continue;
        }
        gaps += ((unsigned)byte + 251 - next) % 251;
        next = ((unsigned)byte + 1) % 251;
        got++;
    }
    pthread_join(putting, NULL);
    CHECK(ring_get(&shared) == -1 && got + ring_lost(&shared) == STREAM_BYTES, "%u came, %u lost",
          got, ring_lost(&shared));
    CHECK(got >= PLT_RING_BYTES, "%u came", got);
    CHECK(gaps <= ring_lost(&shared), "%u bytes missing, %u lost", gaps, ring_lost(&shared));
    printf("    %u of %u bytes came, %u found no room\n", got, (unsigned)STREAM_BYTES,
           ring_lost(&shared));
}

int main(void) {
    test("bytes come in order, across the end of the ring and of its counts");
    in_order(0);
    in_order(UINT32_MAX - 2 * PLT_RING_BYTES - 3);
    overflow();
    threads();
    return test_done();
}
