/* test_vertices - frames of scenes without records against the same scenes with them
 *
 * test_sequence compares scenes with records with scenes that are packed from each frame alone.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "tests/reference/compare.h"
#include "tests/reference/sequence_rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { ORDERS = 12 };

/* An image, and an engine of each kind over it. */
typedef struct pair {
    sequence_config config;
    sequence_rig with, without;
    char name[200];
} pair;

static uint32_t treelet(uint32_t nodes) {
    return rig_is_tiny() ? 1 : nodes;
}

/* Shared vertices, where there is room for them; as many triangles as K asks for. */
static void make_mesh(mesh *m, uint32_t leaf_triangles) {
    if (rig_is_tiny() || leaf_triangles > 4) {
        shape_soup(m, rig_triangles(90, leaf_triangles), 0.4f, 5);
    } else {
        shape_icosphere(m, 2); /* 162 vertices, 320 triangles */
    }
}

static sequence_config config_of(uint32_t k, uint32_t bits, int is_mapped) {
    const sequence_config c = {.scene =
                                   rig_config_of(k, treelet(16), PLT_BUILD_HOST, PLT_SPLIT_SAH),
                               .frames = 9,
                               .key_every = 4,
                               .lattice_bits = bits,
                               .is_mapped = is_mapped};
    return c;
}

/* Both, of `first`; those without as `run` says. */
static int start(pair *p, const mesh *first, const sequence_config *config) {
    sequence_config with = *config;
    p->config = *config;
    with.scene.run.records = PLT_RECORDS_ALWAYS;
    with.scene.run.beside = 0;
    snprintf(p->name, sizeof p->name, "%s, bits %u, %s, side %u, order %u, beside %u",
             rig_name(&config->scene), config->lattice_bits,
             config->is_mapped ? "mapped" : "fetched", config->scene.run.packet_side,
             config->scene.run.order, config->scene.run.beside);
    const int had = sequence_rig_start(&p->with, first, &with);
    const int status = sequence_rig_start(&p->without, first, config);
    CHECK(had == PLT_OK && status == PLT_OK, "%s: %d, %d: %s", p->name, had, status,
          p->without.fault.message);
    return had == PLT_OK ? status : had;
}

static void close_both(pair *p) {
    CHECK(sequence_rig_close(&p->with), "%s: with", p->name);
    CHECK(sequence_rig_close(&p->without), "%s: %s", p->name, p->without.link.sentence);
}

/* ---- what is to be the same ------------------------------------------------------- */

/* From outside, from within, where triangles are not projected, and with a field so wide that none
 * is. */
static void compare_frames(pair *p) {
    plt_frame f = compare_view(p->with.engine, 0.3f, PLT_SHADE_EYELIGHT);
    CHECK(frame_hash(p->without.engine, &f, 500) == frame_hash(p->with.engine, &f, 500),
          "%s: picture", p->name);
    for (int a = 0; a < 3; a++) {
        f.camera.eye[a] = f.camera.look[a] + 0.01f * (float)a;
        f.camera.look[a] += 1.0f;
    }
    f.shader = PLT_SHADE_TRIANGLE;
    CHECK(frame_hash(p->without.engine, &f, 60) == frame_hash(p->with.engine, &f, 60),
          "%s: picture from within", p->name);
    f.camera.tan_half_fov = 3.0e4f;
    CHECK(frame_hash(p->without.engine, &f, 60) == frame_hash(p->with.engine, &f, 60),
          "%s: picture of a wide field", p->name);
}

/* Planes are equal floats, and all else is the same bits. */
static void compare_nodes(pair *p) {
    const plt_tree *is = &p->without.engine->scene.thesis, *due = &p->with.engine->scene.thesis;
    for (uint32_t i = 0; i < due->node_slots; i++) {
        for (int k = 0; k < 6; k++) {
            CHECK(plt_get_float(&is->nodes[i].word[k]) == plt_get_float(&due->nodes[i].word[k]),
                  "%s: node %u, plane %d", p->name, i, k);
        }
        CHECK(memcmp(&is->nodes[i].word[6], &due->nodes[i].word[6], 8) == 0, "%s: node %u", p->name,
              i);
    }
    CHECK(memcmp(&p->without.engine->scene.box, &p->with.engine->scene.box, sizeof(plt_box)) == 0,
          "%s: box", p->name);
}

static void compare(pair *p, uint32_t frame) {
    plt_stats is, due;
    plt_stats_reset(p->with.engine);
    plt_stats_reset(p->without.engine);
    compare_nodes(p);
    compare_rays(p->without.engine, p->with.engine, &p->with.frame[frame], p->name);
    compare_frames(p);
    plt_stats_get(p->with.engine, &due);
    plt_stats_get(p->without.engine, &is);
    /* Smaller packets may be a beam with records, and groups without. */
    CHECK(p->config.scene.run.packet_side < PLT_BEAM_BLOCKS_LEAST ||
              (is.node_visits == due.node_visits && is.rays == due.rays),
          "%s: visits", p->name);
}

static void show(pair *p, uint32_t frame) {
    CHECK(plt_sequence_show(p->with.engine, frame, &p->with.fault) == PLT_OK, "%s: %s", p->name,
          p->with.fault.message);
    CHECK(plt_sequence_show(p->without.engine, frame, &p->without.fault) == PLT_OK, "%s: %s",
          p->name, p->without.fault.message);
    compare(p, frame);
}

/* ---- frames in any order ---------------------------------------------------------- */

static void random_order(const sequence_config *c) {
    mesh m = {0};
    pair p = {.name = ""};
    random_state r = {c->lattice_bits + c->scene.pack.leaf_triangles};
    make_mesh(&m, c->scene.pack.leaf_triangles);
    if (start(&p, &m, c) == PLT_OK) {
        plt_motion q;
        plt_motion_get(p.without.engine, &q);
        CHECK(q.over_vertices && q.is_beside == c->scene.run.beside, "%s: %u, %u", p.name,
              q.over_vertices, q.is_beside);
        plt_motion_get(p.with.engine, &q);
        CHECK(!q.over_vertices && !q.is_beside, "%s: records", p.name);
        compare(&p, 0);
        for (uint32_t k = 0; k < c->frames; k++) {
            show(&p, k);
        }
        for (unsigned i = 0; i < ORDERS; i++) {
            show(&p, random_below(&r, c->frames));
        }
        show(&p, 3);
        show(&p, 3);
    }
    close_both(&p);
    mesh_free(&m);
}

static void every_image(void) {
    static const uint32_t bits[] = {0, 12, 16, 21}, lists[] = {1, 2, 4, 7, 19};
    for (unsigned i = 0; i < 5; i++) {
        for (unsigned b = 0; b < 4; b++) {
            sequence_config c = config_of(lists[i], bits[b], (int)(i + b) % 2);
            c.scene.run.records = PLT_RECORDS_NEVER;
            c.scene.run.beside = b % 2;
            random_order(&c);
            c.is_mapped = !c.is_mapped;
            c.scene.run.beside = !c.scene.run.beside;
            random_order(&c);
        }
    }
}

static void every_packet(void) {
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        for (uint8_t order = 0; order <= PLT_ORDER_TWO_STAGE; order++) {
            sequence_config c = config_of(4, 16, order);
            c.scene.run.records = PLT_RECORDS_NEVER;
            c.scene.run.packet_side = side;
            c.scene.run.order = order;
            random_order(&c);
        }
    }
}

/* A list and no node; one vertex of each triangle its own. */
static void few_triangles(void) {
    for (uint32_t count = 1; count < 8; count++) {
        for (int is_mapped = 0; is_mapped < 2; is_mapped++) {
            sequence_config c = config_of(2, 14, is_mapped);
            pair p = {.name = ""};
            mesh m = {0};
            c.scene.run.records = PLT_RECORDS_NEVER;
            c.scene.run.beside = 1;
            shape_soup(&m, count, 0.3f, count);
            if (start(&p, &m, &c) == PLT_OK) {
                for (uint32_t k = 0; k < c.frames; k++) {
                    show(&p, c.frames - 1 - k);
                }
            }
            close_both(&p);
            mesh_free(&m);
        }
    }
}

/* Corners of equal x, and of equal x and y; zeros of either sign. */
static void ties(void) {
    for (int axis = 0; axis < 3; axis++) {
        for (uint32_t bits = 0; bits <= 16; bits += 16) {
            sequence_config c = config_of(2, bits, 1);
            pair p = {.name = ""};
            mesh m = {0};
            c.scene.run.records = PLT_RECORDS_NEVER;
            shape_sheet(&m, rig_is_tiny() ? 2 : 6, axis);
            for (size_t i = 0; i < 3 * m.vertices; i += 2) {
                m.vertex[i] = m.vertex[i] == 0 ? -0.0f : m.vertex[i];
            }
            if (start(&p, &m, &c) == PLT_OK) {
                show(&p, 1);
                show(&p, 0);
            }
            close_both(&p);
            mesh_free(&m);
        }
    }
}

/* ---- while the last frame is rendered --------------------------------------------- */

/* The picture of the frame that is shown, while frame `next` comes in steps; how many of them. */
static unsigned render_beside(pair *p, uint32_t next, uint64_t due) {
    plt_engine *e = p->without.engine;
    const plt_frame view = compare_view(p->with.engine, 0.3f, PLT_SHADE_TRIANGLE);
    unsigned steps = 0;
    int coming = plt_sequence_begin(e, next, &p->without.fault);
    CHECK(coming == PLT_OK, "%s", p->without.fault.message);
    do {
        coming = plt_sequence_step(e, 1, &p->without.fault);
        steps++;
        if (steps % 3 == 1 || coming != PLT_MORE) {
            CHECK(frame_hash(e, &view, 500) == due, "%s: step %u of frame %u", p->name, steps,
                  next);
        }
    } while (coming == PLT_MORE);
    CHECK(coming == PLT_OK, "%s", p->without.fault.message);
    return steps;
}

/* Frames come beside each other. With nodes beside, too, showing touches no more than a swap: the
 * nodes that are on screen are just those that were refitted. */
static void beside_rendering(void) {
    for (int i = 0; i < 4; i++) {
        sequence_config c = config_of(2, i < 2 ? 16 : 0, i % 2);
        mesh m = {0};
        pair p = {.name = ""};
        c.scene.run.records = PLT_RECORDS_NEVER;
        c.scene.run.beside = i % 2 == 0;
        make_mesh(&m, 2);
        if (start(&p, &m, &c) == PLT_OK) {
            const uint32_t blocks = (p.with.image.info.vertices + 63) / 64;
            for (uint32_t k = 0; k < 2 * c.frames; k++) {
                const uint32_t next = (k + 1) % c.frames;
                show(&p, k % c.frames);
                const plt_frame view = compare_view(p.with.engine, 0.3f, PLT_SHADE_TRIANGLE);
                const plt_node *nodes = p.without.engine->scene.thesis.nodes;
                const unsigned steps =
                    render_beside(&p, next, frame_hash(p.with.engine, &view, 500));
                const plt_node *spare = p.without.engine->moving.beside.nodes;
                if (c.scene.run.beside) {
                    CHECK(steps > blocks + 1, "%s: %u steps", p.name, steps);
                    CHECK(p.without.engine->moving.beside.phase == PLT_BESIDE_READY, "%s", p.name);
                    show(&p, next);
                    CHECK(p.without.engine->scene.thesis.nodes == spare &&
                              p.without.engine->moving.beside.nodes == nodes,
                          "%s: nodes have changed places", p.name);
                } else {
                    CHECK(p.without.engine->scene.thesis.nodes == nodes && spare == NULL, "%s",
                          p.name);
                }
            }
        }
        close_both(&p);
        mesh_free(&m);
    }
}

/* Begun, refitted in part or whole, and then another frame is asked for. */
static void changes_of_mind(void) {
    sequence_config c = config_of(2, 16, 1);
    mesh m = {0};
    pair p = {.name = ""};
    random_state r = {7};
    c.scene.run.records = PLT_RECORDS_NEVER;
    c.scene.run.beside = 1;
    make_mesh(&m, 2);
    if (start(&p, &m, &c) == PLT_OK) {
        plt_engine *e = p.without.engine;
        uint32_t shown = 0;
        for (unsigned i = 0; i < 200; i++) {
            CHECK(plt_sequence_begin(e, random_below(&r, c.frames), &p.without.fault) == PLT_OK,
                  "%s", p.without.fault.message);
            for (uint32_t k = random_below(&r, 30); k > 0; k--) {
                CHECK(plt_sequence_step(e, 1, &p.without.fault) >= PLT_OK, "%s",
                      p.without.fault.message);
            }
            if (random_below(&r, 3) == 0) {
                shown = random_below(&r, c.frames);
                show(&p, shown);
            } else if (random_below(&r, 4) == 0) {
                compare(&p, shown);
            }
        }
    }
    close_both(&p);
    mesh_free(&m);
}

/* ---- what is chosen --------------------------------------------------------------- */

/* What an arena of so many bytes is opened with; its need, if it is too small. */
static int open_in(const packed *image, const plt_options *o, size_t bytes, plt_motion *q,
                   size_t *need) {
    unsigned char *arena = aligned_alloc(PLT_ALIGN, bytes / PLT_ALIGN * PLT_ALIGN + PLT_ALIGN);
    const plt_source source = rig_source(image);
    plt_engine *e;
    plt_fault fault;
    const int status = plt_open(&e, arena, bytes, &source, o, &fault);
    *need = fault.need_bytes;
    if (status == PLT_OK) {
        plt_motion_get(e, q);
        CHECK(plt_arena_used(e) <= bytes, "%zu of %zu", plt_arena_used(e), bytes);
    }
    free(arena);
    return status;
}

static void choice(void) {
    const sequence_config c = config_of(4, 16, 1);
    mesh m = {0};
    sequence_rig s;
    plt_motion q;
    size_t need;
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    sequence_rig_pack(&s, &m, &c);
    plt_options o = c.scene.run, with, without, both;
    o.movable = 1;
    with = without = both = o;
    with.records = PLT_RECORDS_ALWAYS;
    without.records = both.records = PLT_RECORDS_NEVER;
    both.beside = 1;
    const size_t most = plt_arena_need(&s.image.info, 1, &with),
                 least = plt_arena_need(&s.image.info, 1, &without),
                 more = plt_arena_need(&s.image.info, 1, &both);
    CHECK(least < more && more < most, "%zu, %zu, %zu", least, more, most);
    CHECK(plt_arena_need(&s.image.info, 1, &o) == most, "a need is that of records");
    CHECK(open_in(&s.image, &o, most, &q, &need) == PLT_OK && !q.over_vertices, "records fit");
    CHECK(open_in(&s.image, &o, most - 16, &q, &need) == PLT_OK && q.over_vertices && !q.is_beside,
          "records do not");
    CHECK(open_in(&s.image, &o, least, &q, &need) == PLT_OK && q.over_vertices, "they just fit");
    CHECK(open_in(&s.image, &o, least - 16, &q, &need) == PLT_ERR_ARENA && need == least,
          "need %zu of %zu", need, least);
    CHECK(open_in(&s.image, &with, most - 16, &q, &need) == PLT_ERR_ARENA && need == most,
          "need %zu of %zu", need, most);
    o.beside = 1;
    CHECK(plt_arena_need(&s.image.info, 1, &o) == more, "a need has nodes beside");
    CHECK(open_in(&s.image, &o, most, &q, &need) == PLT_OK && q.over_vertices && q.is_beside,
          "both fit, and so do records");
    CHECK(open_in(&s.image, &o, more - 16, &q, &need) == PLT_OK && q.over_vertices && !q.is_beside,
          "nodes beside do not fit");
    CHECK(open_in(&s.image, &o, least - 16, &q, &need) == PLT_ERR_ARENA && need == least,
          "need %zu of %zu", need, least);
    sequence_rig_close(&s);
    mesh_free(&m);
}

/* ---- refusals --------------------------------------------------------------------- */

static void refused(const packed *image, plt_options o, const char *what) {
    const plt_source source = rig_source(image);
    unsigned char *arena = aligned_alloc(PLT_ALIGN, 1u << 22);
    plt_engine *e;
    plt_fault fault;
    CHECK(plt_open(&e, arena, 1u << 22, &source, &o, &fault) == PLT_ERR_ARGUMENT, "%s: %s", what,
          fault.message);
    CHECK(plt_arena_need(&image->info, 1, &o) == 0, "%s: a need", what);
    free(arena);
}

/* Whether an engine that may choose does not choose it. */
static void has_records(const packed *image, plt_options o, const char *what) {
    const size_t need = plt_arena_need(&image->info, 1, &o);
    plt_motion q;
    size_t needed;
    o.records = PLT_RECORDS_AUTO;
    CHECK(open_in(image, &o, need, &q, &needed) == PLT_OK && !q.over_vertices, "%s", what);
    CHECK(need < 4096 || open_in(image, &o, need / 2, &q, &needed) == PLT_ERR_ARENA, "%s", what);
}

static void refusals(void) {
    sequence_config c = config_of(2, 16, 1);
    mesh m = {0};
    sequence_rig s;
    make_mesh(&m, 2);
    sequence_rig_pack(&s, &m, &c);
    plt_options o = c.scene.run;
    o.movable = 1;
    o.records = PLT_RECORDS_NEVER;
    plt_options some = o, rebuilt = o, grid = o, still = o, beside = o, unknown = o;
    some.moves_some = 1;
    rebuilt.rebuild = 1;
    grid.structure = PLT_STRUCTURE_GRID;
    still.movable = 0;
    beside.records = PLT_RECORDS_ALWAYS;
    beside.beside = 1;
    unknown.records = 3;
    refused(&s.image, some, "some");
    refused(&s.image, rebuilt, "rebuilt");
    refused(&s.image, grid, "grid");
    refused(&s.image, still, "still");
    refused(&s.image, beside, "beside records");
    refused(&s.image, unknown, "no such choice");
    some.records = rebuilt.records = PLT_RECORDS_AUTO;
    has_records(&s.image, some, "some");
    has_records(&s.image, rebuilt, "rebuilt");
    sequence_rig_close(&s);
    for (uint8_t build = PLT_BUILD_DEVICE; build <= PLT_BUILD_NONE; build++) {
        c.scene.pack.build = build;
        sequence_rig_pack(&s, &m, &c);
        refused(&s.image, o, "not a finished tree");
        sequence_rig_close(&s);
    }
    mesh_free(&m);
}

/* Corners that a caller moves are of records; and a tree that is built anew is. */
static void moves(void) {
    sequence_config c = config_of(2, 0, 1);
    mesh m = {0};
    pair p = {.name = ""};
    c.scene.run.records = PLT_RECORDS_NEVER;
    make_mesh(&m, 2);
    if (start(&p, &m, &c) == PLT_OK) {
        float(*corners)[9] = calloc(m.triangles, sizeof *corners);
        plt_fault fault;
        show(&p, 2);
        CHECK(plt_move(p.without.engine, (const float(*)[9])corners, &fault) == PLT_ERR_ARGUMENT &&
                  strstr(fault.message, "no records") != NULL,
              "%s", fault.message);
        const uint32_t id = 0;
        CHECK(plt_move_some(p.without.engine, &id, (const float(*)[9])corners, 1, &fault) ==
                  PLT_ERR_ARGUMENT,
              "%s", fault.message);
        CHECK(plt_rebuild_begin(p.without.engine, &fault) == PLT_ERR_ARGUMENT &&
                  !plt_rebuild_due(p.without.engine, PLT_REBUILD_ALWAYS, 1),
              "%s", fault.message);
        compare(&p, 2);
        free(corners);
    }
    close_both(&p);
    mesh_free(&m);
}

int main(void) {
    test("without records, frames have the nodes, hits and pictures that they have with them");
    every_image();
    test("packets of any size, both orders");
    every_packet();
    test("a few triangles, and a list without a node");
    few_triangles();
    test("corners that are equal on an axis, and zeros");
    ties();
    test("a frame comes beside the one that is rendered, and is exchanged for it");
    beside_rendering();
    test("frames that are begun and not shown");
    changes_of_mind();
    test("there are records if the arena has room for them, and nodes beside if it has");
    choice();
    test("what needs records is refused without them, and has them otherwise");
    refusals();
    test("nothing moves but by frames");
    moves();
    return test_done();
}
