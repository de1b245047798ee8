/* arena - the host's arenas, which the system gives when it is asked for
 *
 * SPDX-License-Identifier: MIT */
#define _DEFAULT_SOURCE  /* MAP_ANONYMOUS, MAP_NORESERVE, madvise: POSIX has none of them yet */
#define _DARWIN_C_SOURCE /* the same elsewhere */
#include <sys/mman.h>

#include "board/host/host.h"

#ifndef MAP_ANONYMOUS
#define MAP_ANONYMOUS MAP_ANON
#endif
#ifndef MAP_NORESERVE
#define MAP_NORESERVE 0
#endif

enum { ARENA_STEP = 1 << 16 }; /* bytes: a whole number of pages of every size in use */

static void *arena; /* all of them */
static size_t arena_bytes;

/* In large pages where the system has them to spare: rays that point anywhere touch more small
 * ones than a processor remembers. */
static void *map(size_t bytes) {
    void *p = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                   -1, 0);
    if (p == MAP_FAILED) {
        return NULL;
    }
#ifdef MADV_HUGEPAGE
    (void)madvise(p, bytes, MADV_HUGEPAGE); /* a wish; without it the same happens, slower */
#endif
    return p;
}

size_t host_arena_stride(size_t bytes) {
    return (bytes + ARENA_STEP - 1) / ARENA_STEP * ARENA_STEP;
}

void *host_arenas(unsigned count, size_t bytes) {
    const size_t stride = host_arena_stride(bytes);
    if (bytes > PLT_BOARD_ARENA_BYTES || (count > 1 && stride > SIZE_MAX / count)) {
        return NULL;
    }
    const size_t all = count > 1 ? count * stride : bytes;
    if (arena != NULL && all > arena_bytes) {
        munmap(arena, arena_bytes); /* before: there may be no room for both */
        arena = NULL;
    }
    if (arena == NULL) {
        arena_bytes = all > 0 ? all : 1;
        arena = map(arena_bytes);
    }
    return arena;
}

void *host_arena(size_t bytes) {
    return host_arenas(1, bytes);
}

size_t host_arena_bytes(void) {
    return PLT_BOARD_ARENA_BYTES;
}
