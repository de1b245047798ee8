/* host - a computer with an operating system, as a board
 *
 * One static arena, of which a caller uses as much as the device has that it plays; and scene
 * images in files, mapped or fetched piece by piece.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_HOST_H
#define PLT_BOARD_HOST_H

#include <stddef.h>
#include <stdint.h>

#include "engine/planelet.h"

/* The first `bytes` of the arena, aligned to a page: always the same memory.
 * NULL when there are fewer (PLT_BOARD_ARENA_BYTES: 1 GiB). Untouched pages
 * cost nothing. */
void *host_arena(size_t bytes);
size_t host_arena_bytes(void);

enum { HOST_TRANSFERS = 64 };

/* A transfer begun and not yet waited for. */
typedef struct host_transfer {
    uint32_t tag_bit; /* 0: free */
    uint32_t offset, count;
    void *to;
} host_transfer;

/* An open scene file. `source` points into it: it stays where it is until
 * closed. */
typedef struct host_scene {
    plt_source source;
    char why[160]; /* after a failure: what is wrong and what to do, no file name */
    int file;
    host_transfer pending[HOST_TRANSFERS];
    uint64_t transfers, bytes_moved; /* of a fetched file */
} host_scene;

/* Maps `path` read-only. -1 and `why` for what is no readable file, is empty,
 * or is 4 GiB and more. Someone who shortens the file while it is mapped
 * ends the program (SIGBUS). */
int host_scene_map(host_scene *scene, const char *path);

/* The same file behind start and wait: bytes are moved by reads, at the wait,
 * as late as a device may. Errors as above; at most HOST_TRANSFERS at a time. */
int host_scene_fetch(host_scene *scene, const char *path);

/* After an open, failed or not; more than once does no harm. */
void host_scene_close(host_scene *scene);

#endif
