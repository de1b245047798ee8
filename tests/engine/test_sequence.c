/* test_sequence - frames of an image against scenes that are packed from each alone
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/compare.h"
#include "tests/reference/frame_decoder.h"
#include "tests/reference/sequence_rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/tree_check.h"
#include "tests/test.h"

enum { ORDERS = 24 };

static uint32_t treelet(uint32_t nodes) {
    return rig_is_tiny() ? 1 : nodes;
}

/* Shared vertices, in blocks of which the last one is not whole; K triangles per list fit. */
static void make_mesh(mesh *m, uint32_t leaf_triangles) {
    if (rig_is_tiny()) {
        shape_soup(m, rig_triangles(60, leaf_triangles), 0.4f, 5);
    } else {
        shape_icosphere(m, 2); /* 162 vertices, 320 triangles */
    }
}

static sequence_config config_of(uint32_t k, uint8_t build, uint32_t bits, uint32_t key_every,
                                 int is_mapped) {
    const sequence_config c = {.scene = rig_config_of(k, treelet(16), build, PLT_SPLIT_SAH),
                               .frames = 9,
                               .key_every = key_every,
                               .lattice_bits = bits,
                               .is_mapped = is_mapped};
    return c;
}

/* ---- what is to be the same ------------------------------------------------------- */

/* Boxes are tight, lists and treelets as before. */
static void check_tree(const sequence_rig *s, const char *name) {
    const plt_engine *e = s->engine;
    const plt_info *info = plt_engine_info(e);
    if (info->build != PLT_BUILD_HOST) {
        return;
    }
    tree_view view = tree_view_of(&s->image);
    view.nodes = (const unsigned char *)e->scene.thesis.nodes;
    view.records = (const unsigned char *)e->scene.thesis.records;
    memcpy(view.lo, info->lo, sizeof view.lo);
    memcpy(view.hi, info->hi, sizeof view.hi);
    const tree_facts facts = tree_check(&view);
    CHECK(facts.broken == 0, "%s: %s", name, facts.sentence);
}

/* Each record has its triangle's corners in canonical order, bit for bit. */
static void check_records(const sequence_rig *s, uint32_t k, const char *name) {
    const plt_engine *e = s->engine;
    const plt_record *records =
        e->scene.format == PLT_FORMAT_LIST ? e->scene.list.records : e->scene.thesis.records;
    for (uint32_t i = 0; i < e->scene.info.triangles; i++) {
        const uint32_t word = plt_get_u32(&records[i].word[9]);
        plt_record due;
        pack_record(&due, &s->frame[k], plt_primitive_id(word));
        CHECK(memcmp(&due, &records[i], 36) == 0 &&
                  plt_primitive_rotation(word) == plt_primitive_rotation(plt_get_u32(&due.word[9])),
              "%s: record %u", name, i);
    }
}

/* The scene shows frame `k`, as it is when that frame is packed alone. */
static void shows(sequence_rig *s, const sequence_config *c, uint32_t k, const char *what) {
    char name[200];
    rig fresh;
    snprintf(name, sizeof name, "%s, bits %u, key %u, %s, frame %u: %s", rig_name(&c->scene),
             c->lattice_bits, c->key_every, c->is_mapped ? "mapped" : "fetched", k, what);
    check_tree(s, name);
    check_records(s, k, name);
    CHECK(rig_open(&fresh, &s->frame[k], &c->scene) == PLT_OK, "%s: %s", name, fresh.fault.message);
    compare_scenes(s->engine, fresh.engine, &s->frame[k], name);
    rig_close(&fresh);
}

static void show(sequence_rig *s, const sequence_config *c, uint32_t k) {
    CHECK(plt_sequence_show(s->engine, k, &s->fault) == PLT_OK, "frame %u: %s", k,
          s->fault.message);
    shows(s, c, k, "shown");
}

/* ---- frames in any order ---------------------------------------------------------- */

static void random_order(const sequence_config *c) {
    mesh m = {0};
    sequence_rig s;
    random_state r = {c->lattice_bits + c->key_every};
    make_mesh(&m, c->scene.pack.leaf_triangles);
    if (sequence_rig_start(&s, &m, c) == PLT_OK) {
        shows(&s, c, 0, "opened");
        for (uint32_t k = 0; k < c->frames; k++) {
            show(&s, c, k);
        }
        for (unsigned i = 0; i < ORDERS; i++) {
            show(&s, c, random_below(&r, c->frames));
        }
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

static void every_image(void) {
    static const uint32_t bits[] = {0, 12, 16, 21}, keys[] = {1, 4, 100};
    for (uint8_t build = PLT_BUILD_HOST; build <= PLT_BUILD_NONE; build++) {
        for (unsigned i = 0; i < 4; i++) {
            const uint32_t k = build == PLT_BUILD_NONE ? 1 : 1u << i % 3;
            for (int is_mapped = 0; is_mapped < 2; is_mapped++) {
                const sequence_config c =
                    config_of(k, build, bits[i], keys[(i + build) % 3], is_mapped);
                random_order(&c);
            }
        }
    }
}

/* A block of one vertex fewer, just full, and one more; one vertex; each bit of an index. */
static void sizes(void) {
    static const uint32_t counts[] = {1, 2, 21, 22, 43};
    for (unsigned i = 0; i < 5; i++) {
        for (uint32_t bits = 0; bits <= 14; bits += 14) {
            const sequence_config c = config_of(2, PLT_BUILD_HOST, bits, 3, (int)i % 2);
            mesh m = {0};
            sequence_rig s;
            shape_soup(&m, rig_triangles(counts[i], 2), 0.3f, i);
            if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
                CHECK(s.image.info.vertices == 3 * m.triangles, "%u", s.image.info.vertices);
                for (uint32_t k = 0; k < c.frames; k++) {
                    show(&s, &c, c.frames - 1 - k);
                }
            }
            CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
            mesh_free(&m);
        }
    }
}

/* Vertices that no triangle uses take nothing, whatever they are. */
static void unused_vertices(void) {
    const sequence_config c = config_of(2, PLT_BUILD_HOST, 0, 3, 1);
    mesh m = {0};
    sequence_rig s;
    fail f = {""};
    make_mesh(&m, 2);
    const size_t used = m.vertices;
    mesh_add_vertex(&m, 3.0e10f, 1.0f, -3.0e10f, &f);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        CHECK(s.image.info.vertices == used, "%u of %zu", s.image.info.vertices, used);
        show(&s, &c, 5);
    }
    CHECK(sequence_rig_close(&s), "arena or source");
    mesh_free(&m);
}

/* Corners of equal x, and of equal x and y; zeros of either sign. */
static void ties(void) {
    for (unsigned axis = 0; axis < 3; axis++) {
        for (uint32_t bits = 0; bits <= 16; bits += 16) {
            const sequence_config c = config_of(2, PLT_BUILD_HOST, bits, 2, 1);
            mesh m = {0};
            sequence_rig s;
            shape_sheet(&m, rig_is_tiny() ? 2 : 6, (int)axis);
            for (size_t i = 0; i < 3 * m.vertices; i += 2) {
                m.vertex[i] = m.vertex[i] == 0 ? -0.0f : m.vertex[i];
            }
            if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
                show(&s, &c, 1);
                show(&s, &c, 0);
            }
            CHECK(sequence_rig_close(&s), "arena or source");
            mesh_free(&m);
        }
    }
}

/* ---- how much is read ------------------------------------------------------------- */

/* Of frames alone. */
static uint64_t bytes_for(sequence_rig *s, uint32_t frame) {
    const uint64_t before = s->link.bytes_moved;
    CHECK(plt_sequence_show(s->engine, frame, &s->fault) == PLT_OK, "%s", s->fault.message);
    return s->link.bytes_moved - before;
}

static void bounded_work(void) {
    const sequence_config c = config_of(1, PLT_BUILD_HOST, 14, 4, 0);
    mesh m = {0};
    sequence_rig s;
    if (rig_is_tiny()) {
        make_mesh(&m, 1);
    } else {
        shape_icosphere(&m, 4); /* 2562 vertices: frames of several halves of the window */
    }
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        const unsigned char *at = s.image.bytes + plt_get_u32(s.image.bytes + 104 + 16 * 3 + 4);
        for (uint32_t from = 0; from < c.frames; from++) {
            for (uint32_t to = 0; to < c.frames; to++) {
                const uint32_t key = to - to % 4;
                const uint32_t begin = from >= key && from <= to ? from + 1 : key;
                bytes_for(&s, from);
                const uint64_t due = plt_get_u32(at + 4 * (to + 1)) - plt_get_u32(at + 4 * begin);
                CHECK(bytes_for(&s, to) == due, "from %u to %u", from, to);
            }
        }
    }
    CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
    mesh_free(&m);
}

/* ---- while the last frame is rendered --------------------------------------------- */

/* Hash of a picture that is rendered while frame `next` comes, block by block. */
static uint64_t render_beside(sequence_rig *s, const plt_frame *view, uint32_t next) {
    const size_t pixels = (size_t)view->width * view->height;
    uint8_t *rgb = calloc(pixels, 3);
    uint64_t hash = 14695981039346656037u;
    int status, coming = plt_sequence_begin(s->engine, next, &s->fault);
    CHECK(coming == PLT_OK && plt_render_begin(s->engine, view) == PLT_OK, "%s", s->fault.message);
    coming = PLT_MORE;
    while ((status = plt_render_step(s->engine, 40)) > PLT_OK) {
        if (coming == PLT_MORE) {
            coming = plt_sequence_step(s->engine, 1, &s->fault);
        }
        plt_tile t;
        plt_render_tile(s->engine, &t);
        for (unsigned y = 0; status == PLT_TILE && y < t.height; y++) {
            memcpy(rgb + 3 * ((t.y + y) * (size_t)view->width + t.x), t.rgb + 3 * y * t.width,
                   3 * (size_t)t.width);
        }
    }
    CHECK(coming == PLT_OK, "frame %u came beside the picture: %d", next, coming);
    for (size_t i = 0; i < 3 * pixels; i++) {
        hash = (hash ^ rgb[i]) * 1099511628211u;
    }
    free(rgb);
    return hash;
}

static void beside_rendering(void) {
    for (int is_mapped = 0; is_mapped < 2; is_mapped++) {
        const sequence_config c = config_of(2, PLT_BUILD_HOST, 16, 4, is_mapped);
        mesh m = {0};
        sequence_rig s;
        make_mesh(&m, 2);
        if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
            for (uint32_t k = 0; k < c.frames; k++) {
                show(&s, &c, k);
                const plt_frame view = compare_view(s.engine, 1.0f, PLT_SHADE_TRIANGLE);
                const uint64_t due = frame_hash(s.engine, &view, 500);
                CHECK(render_beside(&s, &view, (k + 1) % c.frames) == due, "frame %u", k);
            }
            const plt_frame view = compare_view(s.engine, 1.0f, PLT_SHADE_TRIANGLE);
            CHECK(plt_render_begin(s.engine, &view) == PLT_OK &&
                      plt_sequence_show(s.engine, 2, &s.fault) == PLT_OK &&
                      plt_render_step(s.engine, 100) == PLT_OK,
                  "a picture that was begun has ended");
            /* Begun and not shown; another one is asked for. */
            CHECK(plt_sequence_begin(s.engine, 3, &s.fault) == PLT_OK &&
                      plt_sequence_step(s.engine, 1, &s.fault) == PLT_MORE,
                  "%s", s.fault.message);
            show(&s, &c, 7);
            CHECK(plt_sequence_begin(s.engine, 8, &s.fault) == PLT_OK &&
                      plt_sequence_step(s.engine, 1, &s.fault) == PLT_MORE,
                  "%s", s.fault.message);
            shows(&s, &c, 7, "while the next one comes");
            show(&s, &c, 8);
        }
        CHECK(sequence_rig_close(&s), "arena or source: %s", s.link.sentence);
        mesh_free(&m);
    }
}

/* Corners that a caller moves, and frames, one after the other. */
static void beside_moving(void) {
    const sequence_config c = config_of(2, PLT_BUILD_HOST, 0, 4, 1);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        float(*corners)[9] = calloc(m.triangles, sizeof *corners);
        show(&s, &c, 2);
        CHECK(plt_move(s.engine, (const float(*)[9])corners, &s.fault) == PLT_OK, "%s",
              s.fault.message);
        show(&s, &c, 2);
        CHECK(plt_move(s.engine, (const float(*)[9])corners, &s.fault) == PLT_OK, "%s",
              s.fault.message);
        show(&s, &c, 3);
        free(corners);
    }
    CHECK(sequence_rig_close(&s), "arena or source");
    mesh_free(&m);
}

/* ---- the reference decoder -------------------------------------------------------- */

static void decode(const sequence_config *c) {
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    sequence_rig_pack(&s, &m, c);
    frame_decoder d = frame_decoder_of(s.image.bytes, s.image.size);
    float *position = malloc(3 * (d.vertices + 1) * sizeof *position);
    CHECK(d.sentence == NULL && d.frames == c->frames && d.rate == 25, "%s", d.sentence);
    for (uint32_t k = 0; k < c->frames && d.sentence == NULL; k++) {
        CHECK(frame_decode(&d, k, position) > 0, "frame %u: %s", k, d.sentence);
        for (uint32_t i = 0; i < 3 * m.triangles; i++) {
            const float *is = position + 3 * (size_t)frame_vertex(&d, i / 3, i % 3);
            const float *due = shape_corner(&s.frame[k], i / 3, i % 3);
            CHECK(memcmp(is, due, 3 * sizeof *is) == 0, "frame %u, corner %u", k, i);
        }
    }
    free(position);
    sequence_rig_close(&s);
    mesh_free(&m);
}

static void reference_decoder(void) {
    for (uint32_t bits = 11; bits <= 21; bits++) {
        const sequence_config c =
            config_of(2, PLT_BUILD_HOST, bits == 11 ? 0 : bits, 1 + bits % 5, 1);
        decode(&c);
    }
}

/* ---- arenas and refusals ---------------------------------------------------------- */

static void arenas(void) {
    for (int is_mapped = 0; is_mapped < 2; is_mapped++) {
        sequence_config c = config_of(2, PLT_BUILD_HOST, 16, 4, is_mapped);
        mesh m = {0};
        sequence_rig s;
        c.scene.run.records = PLT_RECORDS_ALWAYS;
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

static void refused(sequence_rig *s, uint32_t frame, const char *why) {
    CHECK(plt_sequence_show(s->engine, frame, &s->fault) == PLT_ERR_ARGUMENT &&
              strstr(s->fault.message, why) != NULL && plt_sequence_failed(s->engine) == frame,
          "%s", s->fault.message);
}

static void step_refused(plt_engine *e, const char *what) {
    plt_fault fault;
    CHECK(plt_sequence_step(e, 1, &fault) == PLT_ERR_ARGUMENT &&
              strstr(fault.message, "begun") != NULL,
          "%s: %s", what, fault.message);
}

static void refusals(void) {
    const sequence_config c = config_of(2, PLT_BUILD_HOST, 16, 4, 1);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    if (sequence_rig_start(&s, &m, &c) == PLT_OK) {
        step_refused(s.engine, "at first");
        refused(&s, c.frames, "no such frame");
        refused(&s, UINT32_MAX, "no such frame");
        shows(&s, &c, 0, "after refusals");
        const plt_source source = rig_source(&s.image);
        CHECK(plt_open(&s.engine, s.arena, s.arena_bytes, &source, &c.scene.run, &s.fault) ==
                  PLT_OK,
              "%s", s.fault.message);
        shows(&s, &c, 0, "not opened to be moved");
        refused(&s, 0, "not opened to be moved");
        step_refused(s.engine, "not opened to be moved");
    }
    sequence_rig_close(&s);
    rig r;
    rig_config plain = c.scene;
    plain.run.movable = 1;
    CHECK(rig_open(&r, &m, &plain) == PLT_OK, "%s", r.fault.message);
    CHECK(plt_sequence_show(r.engine, 0, &r.fault) == PLT_ERR_ARGUMENT &&
              strstr(r.fault.message, "no frames") != NULL,
          "%s", r.fault.message);
    step_refused(r.engine, "without frames");
    rig_close(&r);
    mesh_free(&m);
}

int main(void) {
    test("frames in any order: hits and pictures are those of scenes packed from each alone");
    every_image();
    test("... of one vertex to a few blocks");
    sizes();
    test("... whose corners share coordinates");
    ties();
    test("... without vertices that no triangle uses");
    unused_vertices();
    test("a frame takes the bytes of those since the last key frame at most, the next one its own");
    bounded_work();
    test("a frame comes, block by block, while the last one is rendered");
    beside_rendering();
    test("corners that a caller moves and frames may follow each other");
    beside_moving();
    test("frames are what the specification says, read bit by bit");
    reference_decoder();
    test("an arena of just its need is enough, and one that is smaller is refused");
    arenas();
    test("frames that are not there are refused, and nothing has changed");
    refusals();
    return test_done();
}
