/* heap - a fixed block for the drivers of displays, which allocate when they open
 *
 * Pieces follow each other; when the last is freed, all of it is free. A driver frees all it has
 * when it is closed. The engine has nothing of it.
 *
 * SPDX-License-Identifier: MIT */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { HEAP_BYTES = 3 << 20, ALIGN = 16 };

static _Alignas(ALIGN) unsigned char heap[HEAP_BYTES];
static size_t used;
static unsigned pieces;

void *malloc(size_t bytes) {
    if (bytes > HEAP_BYTES - ALIGN || used > HEAP_BYTES - ALIGN - bytes) {
        return NULL;
    }
    void *piece = heap + used;
    used += (bytes + ALIGN - 1) / ALIGN * ALIGN;
    pieces++;
    return piece;
}

void *calloc(size_t count, size_t bytes) {
    const uint64_t all = (uint64_t)count * bytes;
    void *piece = all <= HEAP_BYTES ? malloc((size_t)all) : NULL;
    if (piece != NULL) {
        memset(piece, 0, (size_t)all);
    }
    return piece;
}

void free(void *piece) {
    if (piece != NULL && --pieces == 0) {
        used = 0;
    }
}
