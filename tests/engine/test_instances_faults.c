/* test_instances_faults - frames of matrices that come late, short or wrong, once and always
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/instances_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { RAYS = 64, FIRST = 1, WANTED = 3 };

static instances_config config_of(void) {
    const instances_config c = {
        rig_config_of(2, rig_is_tiny() ? 1 : 8, PLT_BUILD_HOST, PLT_SPLIT_SAH),
        INSTANCES_RIG_MOST,
        INSTANCES_RIGID,
        4.0f,
        0,
        11};
    return c;
}

/* What is hit is what bodies have where that frame's matrices put them. */
static int shows(const instances_rig *s, uint32_t frame) {
    static plt_ray rays[RAYS];
    static plt_hit hits[RAYS];
    const float(*matrix)[PLT_MATRIX_FLOATS] = (const float(*)[PLT_MATRIX_FLOATS])s->matrix[frame];
    random_state r = {7};
    mesh flat = {0};
    instances_rig_flatten(s, matrix, &flat);
    rays_mixed(rays, RAYS, &flat, &r);
    mesh_free(&flat);
    int same = plt_trace(s->engine, rays, hits, RAYS, 0) == PLT_OK;
    for (uint32_t i = 0; i < RAYS; i++) {
        const plt_hit due = instances_rig_hit(s, matrix, &rays[i], 0);
        same &= memcmp(&due, &hits[i], sizeof due) == 0;
    }
    return same;
}

/* From frame FIRST, shown, to WANTED, with the link failing at its call `at`; what it has counted
 * by then. */
static int go(instances_rig *s, enum fake_failure failure, uint32_t at) {
    s->link.failure = FAKE_WORKS;
    CHECK(plt_sequence_show(s->engine, FIRST, &s->fault) == PLT_OK, "%s", s->fault.message);
    s->link.starts = s->link.waits = s->link.failed = 0;
    s->link.failure = failure;
    s->link.at_call = at;
    return plt_sequence_show(s->engine, WANTED, &s->fault);
}

static uint32_t calls_of(instances_rig *s) {
    CHECK(go(s, FAKE_WORKS, 0) == PLT_OK, "%s", s->fault.message);
    return s->link.starts + s->link.waits;
}

static void once(enum fake_failure failure) {
    const instances_config c = config_of();
    instances_rig s;
    uint32_t again = 0;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        const uint32_t calls = calls_of(&s);
        for (uint32_t at = 1; at <= calls; at++) {
            const int status = go(&s, failure, at);
            again += s.link.starts + s.link.waits > calls;
            CHECK(status == PLT_OK && shows(&s, WANTED), "failure %d at %u of %u: %s", (int)failure,
                  at, calls, s.fault.message);
        }
        CHECK(again > calls / 4, "failure %d: %u times fetched again", (int)failure, again);
    }
    CHECK(instances_rig_close(&s), "arena or source: %s", s.link.sentence);
}

/* The link is cut at each call: the last frame stays, and comes back with the link. */
static void cut(void) {
    const instances_config c = config_of();
    instances_rig s;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        const uint32_t calls = calls_of(&s);
        for (uint32_t at = 1; at <= calls; at++) {
            const int status = go(&s, FAKE_FAILS_FROM_CALL, at);
            CHECK(status == PLT_ERR_SOURCE && plt_sequence_failed(s.engine) == WANTED &&
                      s.fault.offset >= 256 && s.fault.offset < s.image.size,
                  "at %u: %d, frame %u, byte %u", at, status, plt_sequence_failed(s.engine),
                  s.fault.offset);
            CHECK(shows(&s, FIRST), "at %u: the last frame stays", at);
            CHECK(plt_sequence_step(s.engine, 1, &s.fault) == PLT_ERR_ARGUMENT,
                  "at %u: no frame is on its way", at);
            s.link.failure = FAKE_WORKS;
            CHECK(plt_sequence_show(s.engine, WANTED - at % 3, &s.fault) == PLT_OK &&
                      shows(&s, WANTED - at % 3),
                  "at %u: the link is back: %s", at, s.fault.message);
        }
    }
    CHECK(instances_rig_close(&s), "arena or source: %s", s.link.sentence);
}

/* Every attempt finds it so; and no other frame is concerned. */
static void damaged_source(void) {
    const instances_config c = config_of();
    instances_rig s;
    if (instances_rig_start(&s, &c) == PLT_OK) {
        const uint32_t bytes = PLT_MATRICES_HEAD + c.instances * PLT_MATRIX_BYTES;
        const uint32_t frame = plt_get_u32(s.image.bytes + 104 + 16 * 3 + 4) + WANTED * bytes;
        s.image.bytes[frame + 100] ^= 4;
        CHECK(go(&s, FAKE_WORKS, 0) == PLT_ERR_IMAGE && s.fault.kind == 'I' && s.fault.rule == 28 &&
                  plt_sequence_failed(s.engine) == WANTED && s.fault.offset == frame,
              "frame %u, byte %u: %s", plt_sequence_failed(s.engine), s.fault.offset,
              s.fault.message);
        CHECK(shows(&s, FIRST), "the last frame stays");
        for (uint32_t k = 0; k < INSTANCES_RIG_FRAMES; k++) {
            const int due = k == WANTED ? PLT_ERR_IMAGE : PLT_OK;
            CHECK(plt_sequence_show(s.engine, k, &s.fault) == due, "frame %u", k);
        }
        s.image.bytes[frame + 100] ^= 4;
        CHECK(plt_sequence_show(s.engine, WANTED, &s.fault) == PLT_OK && shows(&s, WANTED),
              "it is whole again: %s", s.fault.message);
    }
    CHECK(instances_rig_close(&s), "arena or source: %s", s.link.sentence);
}

static void opening(void) {
    static const enum fake_failure ways[] = {FAKE_FAILS_FROM_CALL, FAKE_GARBLED_FROM_START};
    const instances_config c = config_of();
    instances_rig s;
    instances_rig_pack(&s, &c);
    CHECK(instances_rig_open(&s, &c, 0) == PLT_OK, "%s", s.fault.message);
    const uint32_t calls = s.link.starts + s.link.waits, starts = s.link.starts;
    for (unsigned way = 0; way < 2; way++) {
        for (uint32_t at = 1; at <= (way == 0 ? calls : starts); at++) {
            s.link.starts = s.link.waits = 0;
            s.link.failure = ways[way];
            s.link.at_call = at;
            const int status = instances_rig_open(&s, &c, 0);
            CHECK(status == (way == 0 ? PLT_ERR_SOURCE : PLT_ERR_IMAGE), "way %u at %u: %d", way,
                  at, status);
        }
    }
    s.link.failure = FAKE_WORKS;
    CHECK(instances_rig_close(&s), "arena or source: %s", s.link.sentence);
}

int main(void) {
    static const enum fake_failure ways[] = {FAKE_FAILS_AT_START,   FAKE_FAILS_AT_WAIT,
                                             FAKE_FAILS_AT_CALL,    FAKE_SHORT_AT_START,
                                             FAKE_GARBLED_AT_START, FAKE_SILENT_AT_START};
    test("a frame that comes late, short or wrong once is fetched again, and is shown");
    for (unsigned way = 0; way < sizeof ways / sizeof ways[0]; way++) {
        once(ways[way]);
    }
    test("a link that is cut: the last frame stays, the error names one, and frames come again");
    cut();
    test("a frame that is damaged is refused, and no other");
    damaged_source();
    test("opening an image with instances fails with each of its transfers");
    opening();
    return test_done();
}
