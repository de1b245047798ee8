/* orders - see orders.h
 *
 * SPDX-License-Identifier: MIT */
#include "board/played/orders.h"

#include "board/board.h"
#include "board/number.h"
#include "board/parameters.h"

#if !PLT_WITH_SEQUENCE
#error "PROGRAM=played shows sequences: make PROGRAM=played PARTS='render thesis motion sequence'"
#endif

/* frames=A:B */
static int read_frames(const char *parameters, orders *o) {
    parameter p;
    unsigned colon = 0;
    if (!parameter_find(parameters, "frames", &p)) {
        return 0;
    }
    while (colon < p.length && p.text[colon] != ':') {
        colon++;
    }
    if (colon == p.length || number_u32(p.text, colon, &o->first) < 0 ||
        number_u32(p.text + colon + 1, p.length - colon - 1, &o->end) < 0 || o->first >= o->end) {
        board_print("error: frames= is not A:B, the first frame and the one after the last\n");
        return -1;
    }
    return 0;
}

/* rebuild=, where trees can be. */
static int read_rebuild(const char *parameters, orders *o) {
#if PLT_WITH_REBUILD
    static const char *const words[] = {"never", "always", "cost"};
    static const uint8_t when[] = {PLT_REBUILD_NEVER, PLT_REBUILD_ALWAYS, PLT_REBUILD_COST};
    uint8_t choice = 0;
    if (job_word(parameters, "rebuild", words, 3, &choice) < 0) {
        return -1;
    }
    o->rebuild_when = when[choice];
    o->picture.options.rebuild = choice > 0;
#if PLT_WITH_SUBTREES
    if (job_u32(parameters, "rebuild_most", PLT_SUBTREE_LEAST, UINT32_MAX,
                &o->picture.options.rebuild_most) < 0) {
        return -1;
    }
#endif
#else
    (void)parameters;
    (void)o;
#endif
    return 0;
}

/* records= and beside=, where they need not be. */
static int read_records(const char *parameters, orders *o) {
#if PLT_WITH_VERTICES
    static const char *const words[] = {"auto", "always", "never"};
    uint32_t beside = 0;
    if (job_word(parameters, "records", words, 3, &o->picture.options.records) < 0 ||
        job_u32(parameters, "beside", 0, 1, &beside) < 0) {
        return -1;
    }
    o->picture.options.beside = (uint8_t)beside;
#else
    (void)parameters;
    (void)o;
#endif
    return 0;
}

#if PLT_WITH_SUBTREES
#define KEYS_OF_REBUILDS " rebuild rebuild_most triangles"
#elif PLT_WITH_REBUILD
#define KEYS_OF_REBUILDS " rebuild triangles"
#else
#define KEYS_OF_REBUILDS ""
#endif
#if PLT_WITH_VERTICES
#define KEYS_OF_VERTICES " records beside"
#else
#define KEYS_OF_VERTICES ""
#endif

int orders_read(orders *o, const char *parameters, size_t arena_bytes) {
    *o = (orders){
        .arena_bytes = arena_bytes, .blocks = 8, .triangles = 1000, .parameters = parameters};
    if (job_read(&o->picture, parameters, "frames blocks" KEYS_OF_REBUILDS KEYS_OF_VERTICES,
                 &o->arena_bytes) < 0 ||
        read_frames(parameters, o) < 0 || read_rebuild(parameters, o) < 0 ||
        read_records(parameters, o) < 0 ||
        job_u32(parameters, "blocks", 1, UINT32_MAX, &o->blocks) < 0 ||
        job_u32(parameters, "triangles", 1, UINT32_MAX, &o->triangles) < 0) {
        return -1;
    }
    o->picture.options.movable = 1;
    return 0;
}
