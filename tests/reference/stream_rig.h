/* stream_rig - an image in a source that is small, slow or cut, and what it gives when resident
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_STREAM_RIG_H
#define REFERENCE_STREAM_RIG_H

#include <stdlib.h>

#include "board/fake/fake.h"
#include "engine/base/rules.h"
#include "engine/engine.h"
#include "engine/memory/prefetch.h"
#include "host_tools/pack/pack.h"
#include "tests/reference/rays.h"
#include "tests/test.h"

enum { RAYS = 1024, WIDTH = 40, HEIGHT = 28, GUARD = 64 };

typedef struct run {
    unsigned char *arena;
    size_t bytes;
    plt_engine *engine;
    plt_fault fault;
    fake_link link;
} run;

typedef struct subject {
    packed image;
    plt_ray rays[RAYS];
    plt_hit due[2][RAYS]; /* nearest, any */
    uint8_t frame[3 * WIDTH * HEIGHT];
} subject;

/* How what follows is traced: packets of a batch, 0: none; handed out one by one instead; and with
 * no more tasks than that. */
static uint16_t batch;
static int are_handed_out;
static int has_few_tasks;
static uint8_t parts_ahead; /* plt_options.prefetch of all that follows */
static int by_beams;        /* frames that follow, also where they would go by groups of rays */

static inline plt_options options_of(uint8_t residency, uint8_t packet_side, uint32_t store_bytes) {
    const int meets = batch > 0 && residency == PLT_RESIDENCY_STREAMED;
    const plt_options o = {.packet_side = packet_side,
                           .count_touched = 1,
                           .residency = residency,
                           .prefetch = parts_ahead,
                           .store_bytes = store_bytes,
                           .schedule = !meets           ? PLT_SCHEDULE_BRANCH
                                       : are_handed_out ? PLT_SCHEDULE_TASK
                                                        : PLT_SCHEDULE_BATCH,
                           .batch = meets ? batch : 0};
    return o;
}

static inline int open_run(run *x, const packed *image, const plt_options *o) {
    x->bytes = plt_arena_need(&image->info, 0, o);
    x->arena = aligned_alloc(PLT_ALIGN, x->bytes + GUARD);
    memset(x->arena, 0x5A, x->bytes + GUARD);
    x->link.image = image->bytes;
    x->link.bytes = image->size;
    x->link.arena = x->arena;
    x->link.arena_bytes = x->bytes;
    const plt_source source = fake_source(&x->link);
    const int status = plt_open(&x->engine, x->arena, x->bytes, &source, o, &x->fault);
    if (status == PLT_OK && has_few_tasks && o->batch > 0) {
        plt_tasks *tasks = are_handed_out ? &x->engine->dispatch.edges : &x->engine->batch.tasks;
        plt_tasks_init(tasks, tasks->queue, o->batch, 1 + o->batch / 2);
    }
    return status;
}

static inline void close_run(run *x) {
    CHECK(x->link.broken == 0, "%s", x->link.sentence);
    CHECK(fake_unfinished(&x->link) == 0, "transfers are pending");
    for (unsigned i = 0; i < GUARD; i++) {
        CHECK(x->arena[x->bytes + i] == 0x5A, "written behind the arena");
    }
    free(x->arena);
}

static inline plt_frame frame_of(const plt_info *info) {
    plt_frame f = {.width = WIDTH, .height = HEIGHT, .camera = {{0}, {0}, {0, 1, 0}, 0.6f}};
    for (int a = 0; a < 3; a++) {
        f.camera.look[a] = 0.5f * (info->lo[a] + info->hi[a]);
        f.camera.eye[a] = f.camera.look[a] + (a == 2 ? 1.8f : 0.4f) * (info->hi[2] - info->lo[2]);
    }
    return f;
}

static inline int render(plt_engine *e, uint8_t frame[3 * WIDTH * HEIGHT]) {
    const plt_frame f = frame_of(plt_engine_info(e));
    int status = plt_render_begin(e, &f);
    if (by_beams && status == PLT_OK && e->rendering.side >= PLT_BEAM_BLOCKS_LEAST) {
        plt_beam_init(e->rendering.beam, &e->rendering.view, &f, &e->scene, e->rendering.side);
        e->rendering.beams = 1;
    }
    while (status >= PLT_OK && (status = plt_render_step(e, 50)) > PLT_OK) {
        plt_tile tile;
        plt_render_tile(e, &tile);
        for (unsigned y = 0; status == PLT_TILE && y < tile.height; y++) {
            memcpy(frame + 3 * ((tile.y + y) * WIDTH + tile.x), tile.rgb + 3 * y * tile.width,
                   3u * tile.width);
        }
    }
    return status;
}

/* What the same image gives when it is resident. */
static inline void set_due(subject *s) {
    run x = {0};
    const plt_options o = options_of(PLT_RESIDENCY_WHOLE, 2, 0);
    CHECK(open_run(&x, &s->image, &o) == PLT_OK, "%s", x.fault.message);
    plt_trace(x.engine, s->rays, s->due[0], RAYS, 0);
    plt_trace(x.engine, s->rays, s->due[1], RAYS, 1);
    if (s->image.info.triangles > 0) { /* else there is nothing to look at */
        CHECK(render(x.engine, s->frame) == PLT_OK, "the frame");
    }
    close_run(&x);
}

/* ---- sources that fail ------------------------------------------------------ */

static inline int trace_all(run *x, const subject *s, plt_hit hits[RAYS]) {
    return plt_trace(x->engine, s->rays, hits, RAYS, 0);
}

/* Of packets that fail: beams over blocks are of 4x4 rays at least. */
static inline uint8_t least_side(void) {
    return by_beams ? PLT_BEAM_BLOCKS_LEAST : 2;
}

/* Traces all rays, or renders the frame by beams; *same: what came of it is what is due. */
static inline int trace_or_render(run *x, const subject *s, int *same) {
    plt_hit hits[RAYS];
    uint8_t frame[3 * WIDTH * HEIGHT];
    if (by_beams) {
        const int status = render(x->engine, frame);
        *same = status == PLT_OK && memcmp(frame, s->frame, sizeof frame) == 0;
        return status;
    }
    const int status = trace_all(x, s, hits);
    *same = status == PLT_OK && memcmp(hits, s->due[0], sizeof hits) == 0;
    return status;
}

/* One failure is got over: the same hits, one retry. */
static inline uint32_t fails_once(const subject *s, enum fake_failure kind, uint32_t call) {
    run x = {.link = {.failure = kind, .at_call = call, .at_once = call % 2}};
    int same = 0;
    plt_stats q;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, least_side(), 0);
    const int status = open_run(&x, &s->image, &o);
    if (status != PLT_OK) { /* of the header: nothing is tried again */
        free(x.arena);
        return 1;
    }
    CHECK(trace_or_render(&x, s, &same) == PLT_OK, "kind %d, call %u", (int)kind, call);
    CHECK(same, "kind %d, call %u: hits", (int)kind, call);
    plt_stats_get(x.engine, &q);
    const uint32_t retries = (uint32_t)q.fetch_retries;
    const uint32_t calls = kind == FAKE_FAILS_AT_WAIT ? x.link.waits : x.link.starts;
    close_run(&x);
    if (call > calls) {
        return 0;
    }
    /* What came ahead and was not needed is not looked at. */
    const int is_unseen = parts_ahead > 0 && retries == 0 &&
                          (kind == FAKE_SILENT_AT_START || kind == FAKE_GARBLED_AT_START);
    return is_unseen ? 1 : retries;
}

static inline void every_call_fails_once(const subject *s, enum fake_failure kind, uint32_t step) {
    uint32_t call = 1, failed = 0;
    for (; call < 100000; call += call < 40 ? 1 : call < 100 ? 17 : step) {
        const uint32_t retries = fails_once(s, kind, call);
        if (retries == 0) {
            break;
        }
        CHECK(retries == 1, "kind %d, call %u: %u retries", (int)kind, call, retries);
        failed++;
    }
    CHECK(failed > 40, "kind %d: %u failures", (int)kind, failed);
}

/* A link that is cut: the status says so, the fault where; and when it is mended all goes on. */
static inline int is_cut_and_mended(const subject *s, uint32_t call) {
    run x = {.link = {.failure = FAKE_FAILS_FROM_CALL, .at_call = call}};
    plt_hit hits[RAYS];
    uint8_t frame[3 * WIDTH * HEIGHT];
    plt_fault fault;
    const int traces = call % 2 && !by_beams;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, least_side(), 0);
    if (open_run(&x, &s->image, &o) == PLT_OK) {
        memset(hits, 0x77, sizeof hits);
        const int status = traces ? trace_all(&x, s, hits) : render(x.engine, frame);
        plt_fault_get(x.engine, &fault);
        const int was_needed = parts_ahead == 0 || status != PLT_OK; /* what failed */
        if (x.link.failed == 0 || !was_needed) { /* there were fewer calls that matter */
            CHECK(status == PLT_OK, "call %u: status %d", call, status);
            CHECK(call % 2 == 0 || memcmp(hits, s->due[0], sizeof hits) == 0, "call %u", call);
            close_run(&x);
            return 0;
        }
        CHECK(status == PLT_ERR_SOURCE, "call %u: status %d", call, status);
        CHECK(fault.offset >= PLT_HEADER_BYTES && fault.offset < s->image.size &&
                  strstr(fault.message, "source") != NULL,
              "call %u: byte %u, %s", call, (unsigned)fault.offset, fault.message);
        int ended = 0;
        for (uint32_t i = 0; i < RAYS && traces; i++) {
            ended |= hits[i].triangle == 0x77777777u;
            CHECK(ended || memcmp(&hits[i], &s->due[0][i], sizeof hits[i]) == 0,
                  "call %u: hit %u before the failure is wrong", call, i);
        }
        x.link.failure = FAKE_WORKS;
        CHECK(trace_all(&x, s, hits) == PLT_OK && memcmp(hits, s->due[0], sizeof hits) == 0,
              "call %u: hits after it was mended", call);
        CHECK(render(x.engine, frame) == PLT_OK && memcmp(frame, s->frame, sizeof frame) == 0,
              "call %u: the frame after it was mended", call);
        close_run(&x);
        return 1;
    }
    free(x.arena);
    return 0;
}

/* Calls that the header takes, before any part comes. */
enum { HEADER_CALLS = (PLT_HEADER_BYTES + PLT_TRANSFER_BYTES - 1) / PLT_TRANSFER_BYTES };

/* A link that garbles every transfer from one on, the header's not counted: the status says so, the
 * fault where, and by which rule; and when it is mended all goes on. Returns which section's part
 * it was that came wrong, from 0; -1: there were fewer transfers. */
static inline int is_garbled_and_mended(const subject *s, uint32_t behind) {
    const uint32_t call = HEADER_CALLS + behind;
    run x = {.link = {.failure = FAKE_GARBLED_FROM_START, .at_call = call, .at_once = call % 2}};
    int same = 0, section = -1;
    plt_fault fault;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, least_side(), 0);
    CHECK(open_run(&x, &s->image, &o) == PLT_OK, "%s", x.fault.message);
    const int status = trace_or_render(&x, s, &same);
    plt_fault_get(x.engine, &fault);
    if (x.link.starts < call || (status == PLT_OK && parts_ahead > 0)) {
        CHECK(status == PLT_OK && same, "call %u: status %d", call, status);
        close_run(&x);
        return -1;
    }
    /* What makes nodes of a block no tree is seen before their check is looked at. */
    const int is_check = fault.rule == PLT_I13_CHECK || fault.rule == PLT_I22_CHECKS;
    const int is_block = fault.rule >= PLT_I10_SIZES && fault.rule <= PLT_I12_BOUNDS;
    CHECK(status == PLT_ERR_IMAGE && fault.kind == 'I' && (is_check || is_block),
          "call %u: status %d, rule %u", call, status, fault.rule);
    for (const unsigned char *entry = s->image.bytes + 104; section < 2; entry += 16) {
        section++;
        if (fault.offset - plt_get_u32(entry + 4) < plt_get_u32(entry + 8)) {
            break;
        }
    }
    x.link.failure = FAKE_WORKS;
    CHECK(trace_or_render(&x, s, &same) == PLT_OK && same, "call %u: after it was mended", call);
    close_run(&x);
    return section;
}

/* One bit of each transfer behind the header is wrong, first once and then whenever it comes; in
 * steps, of which the first 40 are 1. What comes is of the first `sections` of the image, of each
 * of which something is told. */
static inline void every_transfer_is_garbled(const subject *s, uint32_t sections, uint32_t step) {
    uint32_t of[4] = {0, 0, 0, 0};
    int section = 0;
    for (uint32_t call = 1; section >= 0; call += call < 41 ? 1 : step) {
        const uint32_t retries = fails_once(s, FAKE_GARBLED_AT_START, HEADER_CALLS + call);
        section = is_garbled_and_mended(s, call);
        of[section >= 0 ? section : 0] += section >= 0;
        CHECK(retries == (section >= 0), "call %u: %u retries", call, retries);
    }
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t least = rig_is_tiny() ? 1 : 6;
        CHECK(i < sections ? of[i] >= least : of[i] == 0, "%u faults in section %u", of[i], i);
    }
}

/* ---- a source that changes --------------------------------------------------- */

enum { VERSIONS = 6 };

typedef struct changing {
    plt_source source; /* of the link */
    fake_link *link;
    unsigned char *version[VERSIONS]; /* of the image, each from malloc */
    random_state random;
} changing;

static inline int change_start(void *context, unsigned tag, uint32_t offset, void *to,
                               uint32_t count) {
    changing *c = context;
    c->link->image = c->version[offset < PLT_HEADER_BYTES ? 0 : random_below(&c->random, VERSIONS)];
    return c->source.start(c->source.context, tag, offset, to, count);
}

static inline int change_wait(void *context, uint32_t tags) {
    changing *c = context;
    return c->source.wait(c->source.context, tags);
}

/* Every part comes from one of the versions, which are freed. */
static inline void trace_changing(changing *c, const subject *s, uint8_t side, uint32_t *ended) {
    run x = {.link = {.bytes = s->image.size, .at_once = 1, .image = c->version[0]}};
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, 0);
    int same;
    x.bytes = plt_arena_need(&s->image.info, 0, &o);
    x.arena = aligned_alloc(PLT_ALIGN, x.bytes + GUARD);
    memset(x.arena, 0x5A, x.bytes + GUARD);
    x.link.arena = x.arena;
    x.link.arena_bytes = x.bytes;
    c->link = &x.link;
    c->source = fake_source(&x.link);
    const plt_source source = {
        .bytes = s->image.size, .context = c, .start = change_start, .wait = change_wait};
    CHECK(plt_open(&x.engine, x.arena, x.bytes, &source, &o, &x.fault) == PLT_OK, "%s",
          x.fault.message);
    for (int tries = 0; tries < 20; tries++) {
        const int status = trace_or_render(&x, s, &same);
        *ended += status == PLT_OK;
        CHECK(status == PLT_OK || status == PLT_ERR_IMAGE, "status %d", status);
    }
    close_run(&x);
    for (unsigned i = 0; i < VERSIONS; i++) {
        free(c->version[i]);
    }
}

/* ---- parts on their way ------------------------------------------------------- */

/* How many bytes came with those parts ahead, and, in *most, transfers at once. */
static inline uint64_t fetched_ahead(const subject *s, uint8_t ahead, uint32_t *most) {
    run x = {.link = {.at_once = 0}};
    plt_hit hits[RAYS];
    plt_stats q;
    plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 40000);
    o.prefetch = ahead;
    CHECK(open_run(&x, &s->image, &o) == PLT_OK, "%s", x.fault.message);
    CHECK(trace_all(&x, s, hits) == PLT_OK && memcmp(hits, s->due[0], sizeof hits) == 0,
          "%u ahead: hits", ahead);
    plt_stats_get(x.engine, &q);
    *most = x.link.pending_most;
    close_run(&x);
    return q.bytes_fetched;
}

/* What comes ahead is wanted but for so many per cent, and several parts are on their way at once.
 */
static inline void all_distances(const subject *s, unsigned percent) {
    uint32_t most = 0;
    const uint64_t bytes = fetched_ahead(s, 0, &most);
    CHECK(most <= 2, "%u transfers at once without prefetch", most);
    for (uint8_t ahead = 1; ahead <= PLT_PREFETCH_MOST; ahead++) {
        const uint64_t more = fetched_ahead(s, ahead, &most);
        CHECK(more < bytes + bytes * percent / 100, "%u ahead: %u bytes, without %u", ahead,
              (unsigned)more, (unsigned)bytes);
        CHECK(most >= ahead || most >= 3, "%u ahead: %u at once", ahead, most);
        CHECK(most <= 2 + ahead * PLT_PREFETCH_TRANSFERS, "%u ahead: %u at once", ahead, most);
    }
}

/* Packet after packet, and by batches. */
static inline void every_distance(const subject *s, unsigned percent) {
    all_distances(s, percent);
    batch = 64;
    all_distances(s, percent);
    batch = 0;
}

/* ---- schedules --------------------------------------------------------------- */

/* Runs all that depends on the schedule: packet after packet, by batches, by tasks, and by batches
 * and tasks where no more can wait than there are packets. Each run begins with a sentence of its
 * own. */
static inline void every_schedule(void (*all)(const char *sentence, int is_soak),
                                  const char *sentence, int is_soak) {
    all(sentence, is_soak);
    batch = 5;
    all("the same of five packets at a time", is_soak);
    has_few_tasks = 1;
    all("the same when there are no more tasks than packets", is_soak);
    are_handed_out = 1;
    all("the same of packets that are handed out, edge by edge, of which few can wait", is_soak);
    has_few_tasks = 0;
    all("the same of packets that are handed out", is_soak);
    are_handed_out = batch = 0;
}

#endif
