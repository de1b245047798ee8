/* test_sequence_faults - frames that come late, short or wrong, once and always
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/rays.h"
#include "tests/reference/sequence_rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { RAYS = 64, FIRST = 2, WANTED = 6 };

static uint32_t treelet(uint32_t nodes) {
    return rig_is_tiny() ? 1 : nodes;
}

/* Records, or blocks that move; or vertices alone, and with nodes beside. */
enum kind { RECORDS, BLOCKS, VERTICES, BESIDE, KINDS };

static sequence_config config_of(uint32_t bits, uint32_t key_every, enum kind kind) {
    sequence_config c = {.scene = rig_config_of(2, treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH),
                         .frames = 8,
                         .key_every = key_every,
                         .lattice_bits = bits,
                         .is_compact = kind == BLOCKS};
    c.scene.run.records = kind >= VERTICES ? PLT_RECORDS_NEVER : PLT_RECORDS_AUTO;
    c.scene.run.beside = kind == BESIDE;
    return c;
}

static void make_mesh(mesh *m) {
    shape_soup(m, rig_triangles(rig_is_tiny() ? 60 : 400, 2), 0.3f, 5);
}

/* What is hit is what is hit in the mesh alone. */
static int shows(plt_engine *e, const mesh *m, const sequence_config *c) {
    static plt_ray rays[RAYS];
    static plt_hit hits[RAYS], due[RAYS];
    random_state r = {7};
    rig fresh;
    rig_config plain = c->scene;
    plain.run.records = plain.run.beside = 0;
    rays_mixed(rays, RAYS, m, &r);
    int same =
        rig_open(&fresh, m, &plain) == PLT_OK && plt_trace(e, rays, hits, RAYS, 0) == PLT_OK &&
        plt_trace(fresh.engine, rays, due, RAYS, 0) == PLT_OK && memcmp(hits, due, sizeof due) == 0;
    rig_close(&fresh);
    return same;
}

/* From frame FIRST, shown, to WANTED, with the link failing at its call `at`; what it has counted
 * by then. */
static int go(sequence_rig *s, enum fake_failure failure, uint32_t at) {
    s->link.failure = FAKE_WORKS;
    CHECK(plt_sequence_show(s->engine, FIRST, &s->fault) == PLT_OK, "%s", s->fault.message);
    s->link.starts = s->link.waits = s->link.failed = 0;
    s->link.failure = failure;
    s->link.at_call = at;
    return plt_sequence_show(s->engine, WANTED, &s->fault);
}

/* Starts and waits of that without a failure. */
static uint32_t calls_of(sequence_rig *s) {
    CHECK(go(s, FAKE_WORKS, 0) == PLT_OK, "%s", s->fault.message);
    return s->link.starts + s->link.waits;
}

static void once(const sequence_config *c, enum fake_failure failure) {
    mesh m = {0};
    sequence_rig s;
    uint32_t again = 0;
    make_mesh(&m);
    if (sequence_rig_start(&s, &m, c) == PLT_OK) {
        const uint32_t calls = calls_of(&s);
        for (uint32_t at = 1; at <= calls; at++) {
            const int status = go(&s, failure, at);
            again += s.link.starts + s.link.waits > calls;
            CHECK(status == PLT_OK && shows(s.engine, &s.frame[WANTED], c),
                  "failure %d at %u of %u: %s", (int)failure, at, calls, s.fault.message);
        }
        CHECK(again > calls / 4, "failure %d: %u times fetched again", (int)failure, again);
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

static void every_failure_once(void) {
    static const enum fake_failure ways[] = {FAKE_FAILS_AT_START,   FAKE_FAILS_AT_WAIT,
                                             FAKE_FAILS_AT_CALL,    FAKE_SHORT_AT_START,
                                             FAKE_GARBLED_AT_START, FAKE_SILENT_AT_START};
    for (unsigned way = 0; way < sizeof ways / sizeof ways[0]; way++) {
        const sequence_config floats = config_of(0, 4, RECORDS),
                              lattice = config_of(14, 8, RECORDS),
                              blocks = config_of(14, 8, BLOCKS),
                              vertices = config_of(0, 8, VERTICES),
                              beside = config_of(14, 4, BESIDE);
        once(&floats, ways[way]);
        once(&lattice, ways[way]);
        once(&blocks, ways[way]);
        once(&vertices, ways[way]);
        once(&beside, ways[way]);
    }
}

/* The link is cut at each call: the last frame stays, and comes back with the link. */
static void cut(enum kind kind) {
    const sequence_config c = config_of(14, 4, kind);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        const uint32_t calls = calls_of(&s);
        for (uint32_t at = 1; at <= calls; at++) {
            const int status = go(&s, FAKE_FAILS_FROM_CALL, at);
            const uint32_t failed = plt_sequence_failed(s.engine);
            CHECK(status == PLT_ERR_SOURCE && failed >= 4 && failed <= WANTED &&
                      s.fault.offset >= 256 && s.fault.offset < s.image.size,
                  "at %u: %d, frame %u, byte %u", at, status, failed, s.fault.offset);
            CHECK(shows(s.engine, &s.frame[FIRST], &c), "at %u: the last frame stays", at);
            CHECK(plt_sequence_step(s.engine, 1, &s.fault) == PLT_ERR_ARGUMENT,
                  "at %u: no frame is on its way", at);
            s.link.failure = FAKE_WORKS;
            CHECK(plt_sequence_show(s.engine, WANTED - at % 3, &s.fault) == PLT_OK &&
                      shows(s.engine, &s.frame[WANTED - at % 3], &c),
                  "at %u: the link is back: %s", at, s.fault.message);
        }
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

static int start_well(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    const sequence_rig *s = context;
    (void)tag;
    memcpy(to, s->image.bytes + offset, count / 2); /* and the rest never */
    return 0;
}

static int wait_in_vain(void *context, uint32_t tags) {
    (void)context;
    (void)tags;
    return -1;
}

/* Transfers begin, and none ends: it is the source that is to blame. */
static void no_end(enum kind kind) {
    const sequence_config c = config_of(14, 4, kind);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        const plt_source working = s.engine->source;
        CHECK(plt_sequence_show(s.engine, FIRST, &s.fault) == PLT_OK, "%s", s.fault.message);
        s.engine->source = (plt_source){NULL, s.image.size, &s, start_well, wait_in_vain};
        CHECK(plt_sequence_show(s.engine, WANTED, &s.fault) == PLT_ERR_SOURCE, "%s",
              s.fault.message);
        s.engine->source = working;
        CHECK(plt_sequence_show(s.engine, WANTED, &s.fault) == PLT_OK &&
                  shows(s.engine, &s.frame[WANTED], &c),
              "%s", s.fault.message);
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

/* As the image itself is damaged there: every attempt finds it so. */
static void damaged_source(enum kind kind) {
    const sequence_config c = config_of(16, 4, kind);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        const uint32_t section = plt_get_u32(s.image.bytes + 104 + 16 * 3 + 4);
        const uint32_t at = section + plt_get_u32(s.image.bytes + section + 4 * 5) + 100;
        s.image.bytes[at] ^= 4; /* in frame 5 */
        CHECK(go(&s, FAKE_WORKS, 0) == PLT_ERR_IMAGE && s.fault.kind == 'I' && s.fault.rule == 25 &&
                  plt_sequence_failed(s.engine) == 5 && s.fault.offset <= at &&
                  s.fault.offset > at - 788,
              "frame %u, byte %u: %s", plt_sequence_failed(s.engine), s.fault.offset,
              s.fault.message);
        CHECK(shows(s.engine, &s.frame[FIRST], &c), "the last frame stays");
        for (uint32_t k = 0; k < c.frames; k++) {
            const int due = k >= 5 && k < 8 ? PLT_ERR_IMAGE : PLT_OK;
            CHECK(plt_sequence_show(s.engine, k, &s.fault) == due, "frame %u", k);
        }
        s.image.bytes[at] ^= 4;
        CHECK(plt_sequence_show(s.engine, 5, &s.fault) == PLT_OK &&
                  shows(s.engine, &s.frame[5], &c),
              "it is whole again: %s", s.fault.message);
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

/* Every call of opening, too. */
static void opening(enum kind kind) {
    static const enum fake_failure ways[] = {FAKE_FAILS_AT_CALL, FAKE_FAILS_FROM_CALL,
                                             FAKE_GARBLED_AT_START, FAKE_SILENT_AT_START};
    const sequence_config c = config_of(14, 4, kind);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m);
    sequence_rig_pack(&s, &m, &c);
    CHECK(sequence_rig_open(&s, &c, 0) == PLT_OK, "%s", s.fault.message);
    const uint32_t calls = s.link.starts + s.link.waits, starts = s.link.starts;
    uint32_t failed = 0;
    for (unsigned way = 0; way < 4; way++) {
        for (uint32_t at = 1; at <= (way < 2 ? calls : starts); at++) {
            s.link.starts = s.link.waits = 0;
            s.link.failure = ways[way];
            s.link.at_call = at;
            const int status = sequence_rig_open(&s, &c, 0);
            failed += status < PLT_OK;
            /* Frame 0, which is read if there are no records, is fetched again. */
            CHECK(status == (way < 2 ? PLT_ERR_SOURCE : PLT_ERR_IMAGE) ||
                      (kind >= VERTICES && way != 1 && status == PLT_OK &&
                       shows(s.engine, &s.frame[0], &c)),
                  "way %u at %u: %d", way, at, status);
        }
    }
    CHECK(failed > 2 * calls, "%u of %u", failed, 2 * (calls + starts));
    s.link.failure = FAKE_WORKS;
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

int main(void) {
    test("a frame that comes late, short or wrong once is fetched again, and is shown");
    every_failure_once();
    test("a link that is cut: the last frame stays, the error names one, and frames come again");
    for (unsigned kind = 0; kind < KINDS; kind++) {
        cut((enum kind)kind);
        no_end((enum kind)kind);
    }
    test("a frame that is damaged takes those that depend on it along, and no others");
    for (unsigned kind = 0; kind < KINDS; kind++) {
        damaged_source((enum kind)kind);
    }
    test("opening an image with frames fails with each of its transfers");
    for (unsigned kind = 0; kind < KINDS; kind++) {
        opening((enum kind)kind);
    }
    return test_done();
}
