/* test_block_motion - frames of compact blocks against scenes that are packed from each alone
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/block_refit_check.h"
#include "tests/reference/compare.h"
#include "tests/reference/room.h"
#include "tests/reference/sequence_rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { RAYS = 192, ORDERS = 16 };

static sequence_config config_of(uint32_t k, uint32_t bits, uint32_t key_every, int is_mapped) {
    const uint32_t treelet = rig_is_tiny() ? 1 : 16;
    const sequence_config c = {.scene = rig_config_of(k, treelet, PLT_BUILD_HOST, PLT_SPLIT_SAH),
                               .frames = 9,
                               .key_every = key_every,
                               .lattice_bits = bits,
                               .is_mapped = is_mapped,
                               .is_compact = 1};
    return c;
}

/* Shared vertices, and some blocks. */
static void make_mesh(mesh *m, uint32_t leaf_triangles) {
    if (rig_is_tiny()) {
        shape_soup(m, rig_triangles(60, leaf_triangles), 0.4f, 5);
    } else {
        shape_icosphere(m, 3); /* 642 vertices, 1,280 triangles */
    }
}

/* ---- what is to be the same ------------------------------------------------------- */

static void check_blocks(const sequence_rig *s, uint32_t k, const char *name) {
    const plt_engine *e = s->engine;
    plt_block_tree tree = e->scene.compact;
    if (e->scene.format == PLT_FORMAT_STREAMED) { /* as it lies in the image, with ids of frame 0 */
        tree.bytes = s->image.bytes + e->scene.stream.blocks_at;
        tree.ids.bytes = NULL;
    }
    const block_refit_facts facts = block_refit_check(&tree, &s->frame[k]);
    CHECK(facts.broken == 0, "%s: %s, %u times", name, facts.sentence, facts.broken);
    CHECK(facts.triangles == e->scene.info.triangles && facts.nodes == e->scene.info.nodes &&
              facts.blocks == e->scene.info.treelets,
          "%s: %u triangles, %u nodes, %u blocks", name, facts.triangles, facts.nodes,
          facts.blocks);
}

/* The scene shows frame `k`, as it is when that frame is packed alone. */
static void shows(sequence_rig *s, const sequence_config *c, uint32_t k, const char *what) {
    char name[200];
    rig fresh;
    snprintf(name, sizeof name, "%s, bits %u, key %u, %s, frame %u: %s", rig_name(&c->scene),
             c->lattice_bits, c->key_every, c->is_mapped ? "mapped" : "fetched", k, what);
    check_blocks(s, k, name);
    rig_config resident = c->scene;
    resident.run.schedule = PLT_SCHEDULE_BRANCH;
    resident.run.prefetch = 0;
    resident.run.store_bytes = 0;
    CHECK(rig_open(&fresh, &s->frame[k], &resident) == PLT_OK, "%s: %s", name, fresh.fault.message);
    compare_scenes(s->engine, fresh.engine, &s->frame[k], name);
    rig_close(&fresh);
}

static void show(sequence_rig *s, const sequence_config *c, uint32_t k) {
    CHECK(plt_sequence_show(s->engine, k, &s->fault) == PLT_OK, "frame %u: %s", k,
          s->fault.message);
    shows(s, c, k, "shown");
}

/* ---- frames in any order ---------------------------------------------------------- */

static void in_any_order(const sequence_config *c, const mesh *m) {
    sequence_rig s;
    random_state r = {c->lattice_bits + c->key_every};
    if (sequence_rig_start(&s, m, c) == PLT_OK) {
        shows(&s, c, 0, "opened");
        for (uint32_t k = 0; k < c->frames; k++) {
            show(&s, c, k);
        }
        for (unsigned i = 0; i < ORDERS; i++) {
            show(&s, c, random_below(&r, c->frames));
        }
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
}

static void every_image(void) {
    static const uint32_t bits[] = {12, 16, 17, 21}, keys[] = {1, 4, 100};
    for (uint32_t k = 1; k <= 4; k *= 2) {
        for (unsigned i = 0; i < 4; i++) {
            const sequence_config c = config_of(k, bits[i], keys[(i + k) % 3], (int)(i + k) % 2);
            mesh m = {0};
            make_mesh(&m, k);
            in_any_order(&c, &m);
            mesh_free(&m);
        }
    }
}

static void small_scenes(void) {
    for (uint32_t triangles = 1; triangles <= 9; triangles++) {
        const sequence_config c = config_of(1 + triangles % 2, 14, 3, (int)triangles % 2);
        mesh m = {0};
        shape_soup(&m, triangles, 0.3f, triangles);
        in_any_order(&c, &m);
        mesh_free(&m);
    }
}

/* Rays in flight look at blocks as they lie. */
static void in_a_wave(void) {
    sequence_config c = config_of(2, 16, 4, 1);
    mesh m = {0};
    c.scene.run.rays_in_flight = 32;
    c.scene.run.rays = PLT_RAYS_INCOHERENT;
    make_mesh(&m, 2);
    in_any_order(&c, &m);
    mesh_free(&m);
}

/* In the first frame most vertices are at one point of the lattice, later they part. */
static void merged_at_first(void) {
    const sequence_config c = config_of(2, 12, 4, 1);
    mesh m = {0};
    make_mesh(&m, 2);
    for (size_t i = 0; i < 3 * m.vertices; i++) {
        m.vertex[i] *= i < 60 ? 1.0f : 0.0009f;
    }
    in_any_order(&c, &m);
    mesh_free(&m);
}

static void ties(void) {
    for (int axis = 0; axis < 3; axis++) {
        const sequence_config c = config_of(2, 16, 2, 1);
        mesh m = {0};
        shape_sheet(&m, rig_is_tiny() ? 2 : 12, axis);
        in_any_order(&c, &m);
        mesh_free(&m);
    }
}

/* ---- streamed --------------------------------------------------------------------- */

static void streamed(void) {
    static const uint32_t bits[] = {12, 16, 21};
    for (uint32_t k = 1; k <= 4; k *= 2) {
        for (unsigned i = 0; i < 3; i++) {
            sequence_config c = config_of(k, bits[i], 1, (int)(i + k) % 2);
            mesh m = {0};
            c.is_stills = 1;
            c.scene.run.store_bytes = i == 0 ? 0 : 32768;
            c.scene.run.schedule = i == 2 ? PLT_SCHEDULE_BATCH : PLT_SCHEDULE_BRANCH;
            c.scene.run.prefetch = i == 1 ? 4 : 0;
            make_mesh(&m, k);
            in_any_order(&c, &m);
            mesh_free(&m);
        }
    }
}

/* Showing a frame fetches its root, and nothing else; and takes no more of the arena. */
static void shows_at_once(void) {
    sequence_config c = config_of(2, 16, 1, 0);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    c.is_stills = 1;
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        const uint32_t root = s.engine->scene.compact.root >> 24;
        const size_t peak = plt_arena_peak(s.engine);
        CHECK(s.link.bytes_moved == PLT_HEADER_BYTES, "opening moves the header alone");
        for (uint32_t k = 0; k < c.frames; k++) {
            const uint64_t before = s.link.bytes_moved;
            CHECK(plt_sequence_begin(s.engine, k, &s.fault) == PLT_OK &&
                      plt_sequence_step(s.engine, 1, &s.fault) == PLT_OK,
                  "%s", s.fault.message);
            CHECK(s.link.bytes_moved == before, "nothing is read beforehand");
            CHECK(plt_sequence_show(s.engine, k, &s.fault) == PLT_OK, "%s", s.fault.message);
            CHECK(s.link.bytes_moved - before == 4 * root, "%u bytes",
                  (unsigned)(s.link.bytes_moved - before));
        }
        CHECK(plt_arena_peak(s.engine) == peak, "the arena is what it was");
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

/* The root of another frame does not come, in every way: the last frame stays, hits and all. */
static void stays(enum fake_failure failure, int for_good) {
    sequence_config c = config_of(2, 16, 1, 0);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    c.is_stills = 1;
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        for (uint32_t k = 0; k + 1 < c.frames; k++) {
            CHECK(plt_sequence_show(s.engine, k, &s.fault) == PLT_OK, "%s", s.fault.message);
            for (unsigned at = 1; at <= (for_good ? 1u : PLT_FETCH_TRIES); at++) {
                s.link.starts = s.link.waits = s.link.failed = 0;
                s.link.failure = failure;
                s.link.at_call = at;
                const int status = plt_sequence_show(s.engine, k + 1, &s.fault);
                s.link.failure = FAKE_WORKS;
                if (for_good) {
                    CHECK(status == PLT_ERR_SOURCE && plt_sequence_failed(s.engine) == k + 1,
                          "%d, frame %u", status, plt_sequence_failed(s.engine));
                    shows(&s, &c, k, "the last frame stays");
                } else {
                    CHECK(status == PLT_OK, "failure %d at %u: %s", (int)failure, at,
                          s.fault.message);
                    shows(&s, &c, k + 1, "fetched again");
                    CHECK(plt_sequence_show(s.engine, k, &s.fault) == PLT_OK, "back");
                }
            }
        }
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

static uint64_t retries(const plt_engine *e) {
    plt_stats q;
    plt_stats_get(e, &q);
    return q.fetch_retries;
}

/* Each transfer of a trace is silent or garbled once. If it leaves what is there, these are blocks
 * of the frame before, of just the same size; ids may be the right ones. */
static void not_what_was_there(enum fake_failure failure) {
    static plt_ray rays[RAYS];
    static plt_hit hits[RAYS], due[RAYS];
    sequence_config c = config_of(2, 16, 1, 0);
    mesh m = {0};
    sequence_rig s;
    random_state r = {3};
    make_mesh(&m, 2);
    c.is_stills = 1;
    c.scene.run.packet_side = 2;
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        rays_mixed(rays, RAYS, &m, &r);
        for (unsigned at = 1; at < 40; at++) {
            for (uint32_t k = 0; k < 9; k += 8) {
                s.link.failure = k == 8 ? failure : FAKE_WORKS;
                s.link.starts = s.link.waits = 0;
                s.link.at_call = at;
                plt_stats_reset(s.engine);
                CHECK(plt_sequence_show(s.engine, k, &s.fault) == PLT_OK &&
                          plt_trace(s.engine, rays, hits, RAYS, 0) == PLT_OK,
                      "%s", s.fault.message);
            }
            CHECK(failure == FAKE_STALE_AT_START || s.link.starts < at || retries(s.engine) == 1,
                  "failure %d at %u is not noticed", (int)failure, at);
            s.link.failure = FAKE_WORKS;
            CHECK(plt_sequence_show(s.engine, 8, &s.fault) == PLT_OK &&
                      plt_trace(s.engine, rays, due, RAYS, 0) == PLT_OK &&
                      memcmp(hits, due, sizeof due) == 0,
                  "failure %d at %u", (int)failure, at);
        }
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

/* A frame of the sequence shows, or does not come, while a picture is being rendered, which ends:
 * nothing of it waits or is on its way. */
static void while_rendering(sequence_config c) {
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        show(&s, &c, 0);
        for (uint32_t k = 0; k + 1 < c.frames; k++) {
            const plt_frame f = compare_view(s.engine, 1.0f, PLT_SHADE_TRIANGLE);
            for (int fails = (int)c.is_stills; fails >= 0; fails--) {
                CHECK(plt_render_begin(s.engine, &f) == PLT_OK, "begun");
                for (uint32_t i = 0; i <= 3 * k; i++) {
                    CHECK(plt_render_step(s.engine, 10) > PLT_OK || i > 0, "step %u", i);
                }
                s.link.starts = s.link.waits = s.link.failed = 0;
                s.link.failure = fails ? FAKE_FAILS_FROM_CALL : FAKE_WORKS;
                s.link.at_call = 1;
                const int status = plt_sequence_show(s.engine, k + 1, &s.fault);
                s.link.failure = FAKE_WORKS;
                CHECK(status == (fails ? PLT_ERR_SOURCE : PLT_OK), "status %d: %s", status,
                      s.fault.message);
                CHECK(plt_render_step(s.engine, 10) == PLT_OK, "it has ended");
                shows(&s, &c, fails ? k : k + 1, "while rendering");
            }
        }
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

static void in_the_middle(void) {
    sequence_config c = config_of(2, 16, 3, 0);
    while_rendering(c);
    c.is_stills = 1;
    c.key_every = 1;
    for (unsigned i = 0; i < 4; i++) {
        c.scene.run.schedule = i % 2 ? PLT_SCHEDULE_BATCH : PLT_SCHEDULE_BRANCH;
        c.scene.run.prefetch = i < 2 ? 0 : 4;
        while_rendering(c);
    }
}

static void streamed_faults(void) {
    stays(FAKE_FAILS_FROM_CALL, 1);
    stays(FAKE_FAILS_AT_CALL, 0);
    stays(FAKE_SHORT_AT_START, 0);
    stays(FAKE_GARBLED_AT_START, 0);
    stays(FAKE_SILENT_AT_START, 0);
    stays(FAKE_STALE_AT_START, 0);
    not_what_was_there(FAKE_STALE_AT_START);
    not_what_was_there(FAKE_SILENT_AT_START);
    not_what_was_there(FAKE_GARBLED_AT_START);
}

/* ---- what does not move ----------------------------------------------------------- */

static void same_bytes(const sequence_rig *s, unsigned char *blocks, size_t used,
                       const unsigned char *ids, size_t id_bytes, const char *what) {
    const plt_block_tree *t = &s->engine->scene.compact;
    CHECK(memcmp(blocks, t->bytes, used) == 0, "%s: blocks", what);
    CHECK(ids == NULL || memcmp(ids, t->ids.bytes, id_bytes) == 0, "%s: ids", what);
}

/* Frame 0 is what the image holds, as it was packed, checks and all; and so is any frame that is
 * shown again. */
static void unchanged(void) {
    for (uint32_t k = 1; k <= 4; k *= 2) {
        const sequence_config c = config_of(k, 12 + 2 * k, 4, 1);
        mesh m = {0};
        sequence_rig s;
        make_mesh(&m, k);
        if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
            unsigned char *blocks = s.image.bytes + 256;
            const size_t used = s.engine->scene.compact.used;
            const unsigned char *ids = blocks + plt_get_u32(s.image.bytes + 104 + 8);
            const size_t id_bytes = s.image.info.primitive_id_bytes;
            same_bytes(&s, blocks, used, ids, id_bytes, "opened");
            CHECK(plt_sequence_show(s.engine, 0, &s.fault) == PLT_OK, "%s", s.fault.message);
            same_bytes(&s, blocks, used, ids, id_bytes, "shown");
            CHECK(plt_sequence_show(s.engine, 5, &s.fault) == PLT_OK, "%s", s.fault.message);
            CHECK(memcmp(blocks, s.engine->scene.compact.bytes, used) != 0, "it moves");
            unsigned char *copy = room_get(used);
            memcpy(copy, s.engine->scene.compact.bytes, used);
            CHECK(plt_sequence_show(s.engine, 5, &s.fault) == PLT_OK, "%s", s.fault.message);
            same_bytes(&s, copy, used, NULL, 0, "shown again");
            CHECK(plt_sequence_show(s.engine, 0, &s.fault) == PLT_OK, "%s", s.fault.message);
            same_bytes(&s, blocks, used, ids, id_bytes, "shown at last");
            free(copy);
        }
        CHECK(sequence_rig_close(&s), "arena or source");
        mesh_free(&m);
    }
}

/* Nodes are those that the builder makes: of the same triangles where they do not move. */
static void nodes_as_built(void) {
    const sequence_config c = config_of(2, 16, 4, 1);
    const compact_options still = {
        .build = PLT_BUILD_HOST, .lattice_bits = 16, .numbers = 1, .leaf_triangles = 2};
    mesh m = {0};
    sequence_rig s;
    packed built;
    lattice_loss loss;
    fail f = {""};
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        plt_lattice *l = &s.engine->scene.compact.lattice;
        CHECK(pack_compact(&built, &s.frame[0], &still, "test", &loss, &f) == 0, "%s", f.text);
        const int is_same = loss.step == l->step && built.info.treelets == s.image.info.treelets;
        const unsigned char *a = built.bytes + 256, *b = s.image.bytes + 256;
        CHECK(built.info.treelets == s.image.info.treelets, "%u and %u blocks", built.info.treelets,
              s.image.info.treelets);
        for (uint32_t i = 0; is_same && i < built.info.treelets; i++) {
            plt_block x, y;
            plt_block_open(&x, a, 16);
            plt_block_open(&y, b, 16);
            CHECK(x.nodes == y.nodes && memcmp(x.planes, y.planes, 6 * x.nodes) == 0 &&
                      memcmp(x.owners, y.owners, (5 * x.nodes + 7) / 8) == 0,
                  "block %u", i);
            a += plt_block_bytes(&x);
            b += plt_block_bytes(&y);
        }
        pack_free(&built);
    }
    sequence_rig_close(&s);
    mesh_free(&m);
}

/* ---- without ids ------------------------------------------------------------------ */

static void without_ids(void) {
    static plt_ray rays[RAYS];
    static plt_hit hits[RAYS], due[RAYS];
    sequence_config c = config_of(2, 16, 4, 0);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    c.without_ids = 1;
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        for (uint32_t k = 0; k < c.frames; k += 3) {
            rig fresh;
            random_state r = {k};
            CHECK(plt_sequence_show(s.engine, k, &s.fault) == PLT_OK, "%s", s.fault.message);
            check_blocks(&s, k, "without ids");
            CHECK(rig_open(&fresh, &s.frame[k], &c.scene) == PLT_OK, "%s", fresh.fault.message);
            rays_mixed(rays, RAYS, &s.frame[k], &r);
            CHECK(plt_trace(s.engine, rays, hits, RAYS, 0) == PLT_OK &&
                      plt_trace(fresh.engine, rays, due, RAYS, 0) == PLT_OK,
                  "traced");
            for (unsigned i = 0; i < RAYS; i++) {
                CHECK(memcmp(&hits[i].t, &due[i].t, sizeof hits[i].t) == 0, "frame %u, ray %u", k,
                      i);
            }
            rig_close(&fresh);
        }
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

/* ---- arenas and refusals ---------------------------------------------------------- */

static void arenas(void) {
    for (int is_mapped = 0; is_mapped < 2; is_mapped++) {
        const sequence_config c = config_of(2, 16, 4, is_mapped);
        mesh m = {0};
        sequence_rig s;
        make_mesh(&m, 2);
        sequence_rig_pack(&s, &m, &c);
        const int status = sequence_rig_open(&s, &c, PLT_ALIGN);
        CHECK(status == PLT_ERR_ARENA && s.fault.need_bytes == s.arena_bytes + PLT_ALIGN,
              "status %d, need %zu, had %zu", status, s.fault.need_bytes, s.arena_bytes);
        CHECK(sequence_rig_open(&s, &c, 0) == PLT_OK, "%s", s.fault.message);
        CHECK(plt_arena_peak(s.engine) == s.arena_bytes, "the need is what is used");
        CHECK(sequence_rig_close(&s), "arena or source");
        mesh_free(&m);
    }
}

static void cannot_be_opened(const sequence_config *c, const plt_options *run, const char *what) {
    mesh m = {0};
    sequence_rig s;
    sequence_config with = *c;
    with.scene.run = *run;
    make_mesh(&m, 2);
    sequence_rig_pack(&s, &m, &with);
    CHECK(plt_arena_need(&s.image.info, 1, run) == 0, "%s: there is no need", what);
    s.arena_bytes = 1 << 20;
    s.arena = aligned_alloc(PLT_ALIGN, s.arena_bytes);
    const plt_source source = rig_source(&s.image);
    CHECK(plt_open(&s.engine, s.arena, s.arena_bytes, &source, run, &s.fault) == PLT_ERR_ARGUMENT &&
              strstr(s.fault.message, "compact blocks") != NULL,
          "%s: %s", what, s.fault.message);
    free(s.arena);
    s.arena = NULL;
    sequence_rig_close(&s);
    mesh_free(&m);
}

static void refusals(void) {
    const sequence_config c = config_of(2, 16, 4, 1);
    plt_options run = c.scene.run;
    run.movable = run.moves_some = 1;
    cannot_be_opened(&c, &run, "some triangles");
    run.moves_some = 0;
    run.rebuild = 1;
    cannot_be_opened(&c, &run, "rebuilds");
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        float(*corners)[9] = calloc(m.triangles, sizeof *corners);
        show(&s, &c, 3);
        CHECK(plt_move(s.engine, (const float(*)[9])corners, &s.fault) == PLT_ERR_ARGUMENT &&
                  strstr(s.fault.message, "frames") != NULL,
              "%s", s.fault.message);
        shows(&s, &c, 3, "after a refusal");
        CHECK(plt_sequence_show(s.engine, c.frames, &s.fault) == PLT_ERR_ARGUMENT, "%s",
              s.fault.message);
        plt_motion motion;
        plt_motion_get(s.engine, &motion);
        CHECK(motion.moves == 1 && motion.degradation == 0 && motion.growth == 0, "%u moves",
              motion.moves);
        free(corners);
        const plt_source source = rig_source(&s.image);
        CHECK(plt_open(&s.engine, s.arena, s.arena_bytes, &source, &c.scene.run, &s.fault) ==
                  PLT_OK,
              "%s", s.fault.message);
        shows(&s, &c, 0, "not opened to be moved");
        CHECK(plt_sequence_show(s.engine, 0, &s.fault) == PLT_ERR_ARGUMENT, "%s", s.fault.message);
    }
    sequence_rig_close(&s);
    mesh_free(&m);
}

int main(void) {
    test(
        "frames in any order: hits and pictures are those of scenes packed from each alone, and "
        "boxes contain their triangles as tightly as a step allows");
    every_image();
    test("... of one triangle to nine");
    small_scenes();
    test("... whose corners share coordinates");
    ties();
    test("... met by rays in flight");
    in_a_wave();
    test("... whose vertices lie at one point at first");
    merged_at_first();
    test("... streamed, with any store, in batches and asked for ahead");
    streamed();
    test("a streamed frame shows at once: its root is fetched");
    shows_at_once();
    test("one whose root does not come leaves the last frame, and blocks of another are noticed");
    streamed_faults();
    test("a frame that comes, or does not, while a picture is being rendered");
    in_the_middle();
    test("what has not moved has not changed by one bit");
    unchanged();
    test("nodes are those that the builder makes");
    nodes_as_built();
    test("without primitive ids the same triangles are met");
    without_ids();
    test("an arena of just its need is enough, and one that is smaller is refused");
    arenas();
    test("what compact blocks cannot do is refused, and nothing has changed");
    refusals();
    return test_done();
}
