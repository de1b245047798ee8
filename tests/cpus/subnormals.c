/* subnormals - how many of 64 sums a plain loop flushes to zero, in main and in a thread
 *
 * Of itself, and with platform/altivec.c: tests/qemu/test_cpus.sh.
 *
 * SPDX-License-Identifier: MIT */
#include <pthread.h>
#include <stdio.h>

enum { SUMS = 64 };

/* Compilers make vectors of it. */
static void add(float *restrict sum, const float *restrict a, const float *restrict b) {
    for (int i = 0; i < SUMS; i++) {
        sum[i] = a[i] + b[i];
    }
}

static int flushed(void) {
    static volatile const float smallest = 0x1p-149f, zero = 0;
    float a[SUMS], b[SUMS], sum[SUMS];
    for (int i = 0; i < SUMS; i++) {
        a[i] = smallest;
        b[i] = zero;
    }
    add(sum, a, b);
    int count = 0;
    for (int i = 0; i < SUMS; i++) {
        count += sum[i] == 0;
    }
    return count;
}

static void *in_thread(void *count) {
    *(int *)count = flushed();
    return NULL;
}

int main(void) {
    int count = -1;
    pthread_t thread;
    if (pthread_create(&thread, NULL, in_thread, &count) != 0 || pthread_join(thread, NULL) != 0) {
        return 1;
    }
    printf("%d %d\n", flushed(), count);
    return 0;
}
