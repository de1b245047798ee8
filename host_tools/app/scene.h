/* scene - an image opened as the flags say
 *
 * SPDX-License-Identifier: MIT */
#ifndef SCENE_H
#define SCENE_H

#include "board/host/host.h"
#include "engine/planelet.h"
#include "host_tools/app/args.h"
#include "host_tools/app/crew.h"
#include "host_tools/app/dma.h"
#include "host_tools/base/fail.h"
#include "host_tools/base/input.h"
#include "host_tools/base/output.h"

typedef struct scene {
    host_scene file;
    plt_source source;      /* of the file, or of a simulated board over it */
    dma board;              /* with --source dma:...; outstanding 0: there is none */
    input stream;           /* standard input, in memory */
    plt_options options;    /* by the flags; count_touched and the wave by the command, before
                             * scene_attach; scene_start leaves out the wide form, and then the
                             * wave, where the arena has no room for them */
    uint8_t textures;       /* enum plt_texture_filter, of an image that has some ... */
    uint32_t texture_bytes; /* ... and plt_options.texture_bytes then */
    plt_engine *engine;     /* NULL: not opened; else the first worker's */
    unsigned workers;       /* by --workers; 0 is 1 */
    crew crew;              /* all of them */
    size_t arena_bytes;     /* of each */
    int arena_is_given;     /* by --arena */
    uint64_t spare_bytes;   /* what the command takes from the system after scene_start */
    int arena_is_missing;   /* the system does not give it */
} scene;

/* What an arena is made for if neither packets nor bytes were asked for. */
#define SCENE_USUAL_PACKET (PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8)

#define SCENE_CLOSED                                                                               \
    {                                                                                              \
        .file = {.file = -1 }                                                                      \
    }

/* The flags that say how to open an image, for a command's list. */
#define SCENE_FLAGS                                                                                \
    {"--packet", "auto|2|4|8|16",                                                                  \
     "rays along a packet's side; auto is the largest that the arena has room for (default "       \
     "auto)"},                                                                                     \
        {"--walk", "depth|two-stage", "depth first, or the thesis's two stages (default depth)"},  \
        {"--structure", "tree|grid",                                                               \
         "what rays find triangles by: the image's tree, or cells of one size that are made when " \
         "it is opened (default tree)"},                                                           \
        {"--residency", "resident|streamed",                                                       \
         "the whole scene is in memory, or blocks are fetched from the file when rays need them "  \
         "(default resident)"},                                                                    \
        {"--store", "BYTES",                                                                       \
         "streamed: memory for blocks, from 28672 (default all that the arena has room for)"},     \
        {"--schedule", "branch|batch|task",                                                        \
         "streamed: packet after packet; many packets that meet at a block before it is "          \
         "fetched; or block by block, whichever worker is free (default branch)"},                 \
        {"--batch", "PACKETS",                                                                     \
         "packets that meet or that workers share, 1 to 1024 (default as many as there is room "   \
         "for, 256 at most, of task 16)"},                                                         \
        {"--prefetch", "PARTS",                                                                    \
         "streamed scenes: parts that may be on their way before rays need them, 0 to 8 "          \
         "(default 0)"},                                                                           \
        {"--source", "map|read|dma:LATENCY_US,MB_PER_S[,OUTSTANDING]",                             \
         "the image is mapped like flash, or fetched into the arena (default map); streamed, dma " \
         "counts the cycles that a board works and stalls whose memory has that latency, 0 to "    \
         "1000, and bandwidth, 0.1 to 10000, and takes 1 to 64 transfers at once (default 4)"},    \
    {                                                                                              \
        "--arena", "BYTES",                                                                        \
            "memory of the engine, 1 to 1073741824 (default 1 GiB, or what the scene needs where " \
            "there is less)"                                                                       \
    }

/* For commands whose work a crew can share. */
#define SCENE_WORKERS_FLAGS                                                                        \
    {"--workers", "N",                                                                             \
     "threads that trace, 1 to 64, each with an arena and a store of its own, for the same "       \
     "result; 0 is one per processor (default 1)"},                                                \
    {                                                                                              \
        "--turns", NULL,                                                                           \
            "workers take turns on one thread, as if all were equally fast: for statistics that "  \
            "are the same every time"                                                              \
    }

/* Opens the file as the flags say, without reading it, or reads standard input for "-"; a
 * wrong flag sets a->wrong. */
int scene_attach(scene *s, args *a, const char *path, fail *f);
/* Asks for the arenas, one per worker, and plt_open on that file: its status. Unless --arena says
 * how much, each is all of host_arena_bytes, or, where the system does not give it beside
 * spare_bytes, plt_arena_need. */
int scene_start(scene *s, const char *path, plt_fault *fault);
/* Both. */
int scene_open(scene *s, args *a, const char *path, fail *f);
void scene_close(scene *s);

/* Sets `f` to why the engine refused `path` and what to do. Returns -1. */
int scene_refused(const scene *s, const char *path, int status, const plt_fault *fault, fail *f);

/* Sets `f` to why tracing or rendering a streamed scene has ended. Returns -1. */
int scene_failed(const scene *s, const char *path, int status, fail *f);

/* What messages call it: "-" is standard input. */
const char *scene_name(const char *path);

/* Reads a whole image, "-" is standard input, to where it may be taken for mapped (PLT_ALIGN). */
int scene_read(input *in, const char *path, fail *f);

/* Resets the statistics, and what a simulated board counts. */
void scene_reset_stats(scene *s);

/* The members that `trace` and `render` statistics share, without braces. */
void scene_print_stats(output *o, const scene *s, const crew_times *took, fail *f);

#endif
