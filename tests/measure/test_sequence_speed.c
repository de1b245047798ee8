/* test_sequence_speed [MESH...] - triangles per second of frames that an image holds
 *
 * Of thesis nodes, on one core: the best of ten. Blocks decoded and checked; records written from
 * vertices and indices; bounds and nodes; the last two together, which is what is compared with
 * corners that a caller gives (test_refit_speed). Then the same frame without records: bounds and
 * nodes from vertices alone, and what pictures take with records and without. Without a mesh it
 * takes a small one and is one test more; the figures are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/motion/vertices.h"
#include "engine/move.h"
#include "host_tools/base/clock.h"
#include "host_tools/pack/lattice.h"
#include "host_tools/pack/sequence.h"
#include "tests/measure/meshes.h"
#include "tests/reference/frames.h"
#include "tests/reference/shapes.h"

enum { ROUNDS = 10 };

typedef struct speeds {
    double decode, records, bounds, corners; /* seconds, the best */
    double vertices;                         /* bounds and nodes from them alone */
    double with, without;                    /* a picture */
} speeds;

static double best_of(double best, double began, int round) {
    const double took = clock_processor_seconds() - began;
    return round == 0 || took < best ? took : best;
}

/* Two frames: the mesh, and the mesh half as large again. */
static void pack_frames(packed *image, const mesh *m, uint32_t k, uint32_t bits) {
    sequence_options o = {2, 25, 2, {{0}, 0, 0}};
    mesh frame = *m;
    sequence s;
    fail f = {""};
    lattice_ground ground = {plt_box_empty(), LATTICE_NO_GRAIN};
    rig_config c = rig_config_of(k, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_box(m, ground.box.lo, ground.box.hi);
    for (int a = 0; a < 3; a++) {
        ground.box.lo[a] *= ground.box.lo[a] < 0 ? 1.5f : 1.0f;
        ground.box.hi[a] *= ground.box.hi[a] > 0 ? 1.5f : 1.0f;
    }
    const lattice_wish wish = {.bits = bits, .power = 1};
    CHECK(bits == 0 || lattice_over(&o.lattice, &ground, &wish, "test", &f) == 0, "%s", f.text);
    c.pack.checks = 0; /* what moves is not streamed */
    CHECK(pack_mesh(image, m, &c.pack, "test", &f) == 0 &&
              sequence_begin(&s, m, &o, "test", &f) == 0 && sequence_add(&s, m, "test", &f) == 0,
          "%s", f.text);
    frame.vertex = malloc(3 * m->vertices * sizeof(float));
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        frame.vertex[i] = 1.5f * m->vertex[i];
    }
    CHECK(sequence_add(&s, &frame, "test", &f) == 0 &&
              sequence_finish(&s, image, m, "test", &f) == 0,
          "%s", f.text);
    free(frame.vertex);
    sequence_free(&s);
}

static void take_corners(plt_engine *e, const mesh *m, speeds *best, int round) {
    float(*corners)[9] = malloc(m->triangles * sizeof *corners);
    plt_fault fault;
    for (size_t i = 0; i < 9 * m->triangles; i++) {
        ((float *)corners)[i] = m->vertex[3 * (size_t)m->triangle[i / 3] + i % 3];
    }
    const double began = clock_processor_seconds();
    CHECK(plt_move(e, (const float(*)[9])corners, &fault) == PLT_OK, "%s", fault.message);
    best->corners = best_of(best->corners, began, round);
    free(corners);
}

static void take_frames(plt_engine *e, speeds *best, int round) {
    plt_fault fault;
    int status = plt_sequence_show(e, 0, &fault);
    double began = clock_processor_seconds();
    status += plt_sequence_begin(e, 1, &fault) + plt_sequence_step(e, UINT32_MAX, &fault);
    best->decode = best_of(best->decode, began, round);
    CHECK(status == PLT_OK, "%s", fault.message);
    began = clock_processor_seconds();
    plt_vertices_put(plt_records_of(e), e->scene.info.triangles, &e->sequence.vertices);
    best->records = best_of(best->records, began, round);
    began = clock_processor_seconds();
    plt_refit_all(e);
    plt_moved(e);
    best->bounds = best_of(best->bounds, began, round);
}

/* A picture of all, 256 x 256. */
static double picture(plt_engine *e) {
    const plt_info *info = plt_engine_info(e);
    float eye[3], look[3];
    for (int a = 0; a < 3; a++) {
        look[a] = 0.5f * (info->lo[a] + info->hi[a]);
        eye[a] = look[a] + (a == 2 ? 1.4f : 0.2f) * (info->hi[1] - info->lo[1]);
    }
    const plt_frame f = frame_of(eye, look, 256, 256, PLT_SHADE_EYELIGHT);
    const double began = clock_processor_seconds();
    CHECK(plt_render_begin(e, &f) == PLT_OK, "no picture");
    while (plt_render_step(e, 100000) > PLT_OK) {
    }
    return clock_processor_seconds() - began;
}

/* Frame 1 has come: its nodes, beside those of frame 0. */
static void take_vertices(plt_engine *e, speeds *best, int round) {
    plt_fault fault;
    int status = plt_sequence_show(e, 0, &fault);
    status += plt_sequence_begin(e, 1, &fault);
    status += plt_sequence_step(e, UINT32_MAX, &fault) - PLT_MORE;
    const double began = clock_processor_seconds();
    status += plt_sequence_step(e, UINT32_MAX, &fault);
    best->vertices = best_of(best->vertices, began, round);
    CHECK(status == PLT_OK && plt_sequence_show(e, 1, &fault) == PLT_OK, "%s", fault.message);
}

static void best_picture(double *best, plt_engine *e, int round) {
    const double took = picture(e);
    *best = round == 0 || took < *best ? took : *best;
}

static plt_engine *open_engine(const packed *image, const plt_options *o, void **arena) {
    const plt_source source = rig_source(image);
    const size_t bytes = plt_arena_need(&image->info, 1, o);
    plt_engine *e;
    plt_fault fault;
    *arena = aligned_alloc(PLT_ALIGN, bytes);
    CHECK(plt_open(&e, *arena, bytes, &source, o, &fault) == PLT_OK, "%s", fault.message);
    return e;
}

static void run(const packed *image, const mesh *m, const char *name, uint32_t k, uint32_t bits) {
    const uint8_t side = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8;
    const plt_options o = {.packet_side = side, .movable = 1};
    const plt_options no = {
        .packet_side = side, .movable = 1, .records = PLT_RECORDS_NEVER, .beside = 1};
    const double millions = 1e-6 * (double)m->triangles;
    void *arena, *other;
    plt_engine *e = open_engine(image, &o, &arena), *v = open_engine(image, &no, &other);
    speeds best = {0, 0, 0, 0, 0, 0, 0};
    for (int i = 0; i < ROUNDS && e != NULL && v != NULL; i++) {
        take_frames(e, &best, i);
        take_vertices(v, &best, i);
        best_picture(&best.with, e, i);
        best_picture(&best.without, v, i);
        take_corners(e, m, &best, i);
    }
    free(arena);
    free(other);
    printf(
        "    %s, K = %u, %s%.0u: million triangles per second: decoded %.1f, records %.1f, bounds "
        "and nodes %.1f, the last two %.1f, from corners %.1f\n",
        name, k, bits > 0 ? "lattice:" : "float", bits, millions / best.decode,
        millions / best.records, millions / best.bounds, millions / (best.records + best.bounds),
        millions / best.corners);
    printf("    ... without records: bounds and nodes %.1f, a picture %.2f of that with them\n",
           millions / best.vertices, best.without / best.with);
}

static void measure(const mesh *m, const char *name) {
    for (uint32_t k = 1; k <= 4; k *= 2) {
        for (uint32_t bits = 0; bits <= 16; bits += 16) {
            packed image;
            pack_frames(&image, m, k, bits);
            run(&image, m, name, k, bits);
            pack_free(&image);
        }
    }
}

int main(int argc, char **argv) {
    return measure_meshes(argc, argv, "frames of an image, triangles per second on one core",
                          measure);
}
