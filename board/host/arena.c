/* arena - the host's one arena, which the system gives when it is asked for
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

static void *arena;
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

void *host_arena(size_t bytes) {
    if (bytes > PLT_BOARD_ARENA_BYTES) {
        return NULL;
    }
    if (arena != NULL && bytes > arena_bytes) {
        munmap(arena, arena_bytes); /* before: there may be no room for both */
        arena = NULL;
    }
    if (arena == NULL) {
        arena_bytes = bytes > 0 ? bytes : 1;
        arena = map(arena_bytes);
    }
    return arena;
}

size_t host_arena_bytes(void) {
    return PLT_BOARD_ARENA_BYTES;
}
