/* host - a computer with an operating system, as a board
 *
 * One arena, or one for each of several workers, of which a caller asks for as much as the device
 * has that it plays; and scene images in files or in memory, mapped or fetched piece by piece.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_HOST_H
#define PLT_BOARD_HOST_H

#include <stddef.h>
#include <stdint.h>

#include "engine/planelet.h"

/* The arena, with at least `bytes`, aligned to a page: the same memory as before unless it has
 * to grow; then what was in it is lost, and what is new is zero. NULL when there are more than
 * host_arena_bytes, or the system does not give so much (ulimit -v); untouched pages cost
 * nothing but room. A program that never asks takes none. */
void *host_arena(size_t bytes);
/* The same for `count` arenas of `bytes` each, one every host_arena_stride(bytes). */
void *host_arenas(unsigned count, size_t bytes);
size_t host_arena_stride(size_t bytes);
size_t host_arena_bytes(void); /* the most there can be: PLT_BOARD_ARENA_BYTES, 1 GiB */

enum { HOST_TRANSFERS = 64 };

/* A transfer begun and not yet waited for. */
typedef struct host_transfer {
    uint32_t tag_bit;
    uint32_t offset, count;
    void *to;
} host_transfer;

/* An open scene. `source` points into it: it stays where it is until closed. */
typedef struct host_scene {
    plt_source source;
    char why[160];      /* after a failure: what is wrong and what to do, no file name */
    int file;           /* -1: none */
    const void *memory; /* of a scene in memory, not owned; else NULL */
    void *map; /* that is unmapped with the scene; NULL: there is none, or it is another's */
    unsigned pending_count;
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

/* A scene in memory, aligned to PLT_ALIGN, as if it were a mapped or a fetched file. The bytes
 * are the caller's, until the scene is closed. */
void host_scene_hold(host_scene *scene, const void *bytes, uint32_t count, int fetched);

/* What `of` has open, for another thread: with transfers and a file of its own, without a lock.
 * Closed before `of` is, whose bytes it may use. */
void host_scene_share(host_scene *scene, const host_scene *of);

/* After an open, failed or not; more than once does no harm. */
void host_scene_close(host_scene *scene);

#endif
