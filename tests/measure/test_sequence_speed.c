/* test_sequence_speed [MESH...] - triangles per second of frames that an image holds
 *
 * Of thesis nodes, on one core: the best of ten. Blocks decoded and checked; records written from
 * vertices and indices; bounds and nodes; the last two together, which is what is compared with
 * corners that a caller gives (test_refit_speed); in turn with these, compact blocks of the
 * same lists: positions, bounds and nodes; and the same frame without records: bounds and nodes
 * from vertices alone, and what pictures take with records and without. Without a mesh it takes a
 * small one and is one test more; the figures are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/motion/vertices.h"
#include "engine/move.h"
#include "host_tools/base/clock.h"
#include "tests/measure/meshes.h"
#include "tests/measure/two_frames.h"
#include "tests/reference/frames.h"

enum { ROUNDS = 10 };

typedef struct speeds {
    double decode, records, bounds, corners; /* seconds, the best */
    double blocks;                           /* compact blocks, all of them */
    double vertices;                         /* bounds and nodes from them alone */
    double with, without;                    /* a picture */
} speeds;

static double best_of(double best, double began, int round) {
    const double took = clock_processor_seconds() - began;
    return round == 0 || took < best ? took : best;
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

static void take_blocks(plt_engine *e, speeds *best, int round) {
    plt_fault fault;
    int status = plt_sequence_show(e, 0, &fault);
    status += plt_sequence_begin(e, 1, &fault) + plt_sequence_step(e, UINT32_MAX, &fault);
    const double began = clock_processor_seconds();
    status += plt_sequence_show(e, 1, &fault);
    best->blocks = best_of(best->blocks, began, round);
    CHECK(status == PLT_OK, "%s", fault.message);
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

typedef struct opened {
    void *arena;
    plt_engine *engine;
} opened;

/* `records`: enum plt_records; of vertices alone, too, nodes are refitted beside others. */
static opened open_image(const packed *image, uint8_t records) {
    const uint8_t side = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8;
    const plt_options o = {.packet_side = side,
                           .movable = 1,
                           .records = records,
                           .beside = records == PLT_RECORDS_NEVER};
    const plt_source source = rig_source(image);
    const size_t bytes = plt_arena_need(&image->info, 1, &o);
    opened now = {aligned_alloc(PLT_ALIGN, bytes), NULL};
    plt_fault fault;
    CHECK(plt_open(&now.engine, now.arena, bytes, &source, &o, &fault) == PLT_OK, "%s",
          fault.message);
    return now;
}

static void print_blocks(const packed *image, const speeds *best) {
    const plt_info *i = &image->info;
    const double n = (double)i->triangles, millions = 1e-6 * n;
    const plt_options o = {.packet_side = 2}, moving = {.packet_side = 2, .movable = 1};
    printf(
        "        compact: %.1f, %.2f of the last two; bytes per triangle: nodes %.2f, geometry "
        "%.2f, ids %.2f, numbers %.2f, frame %.2f, arena mapped %.2f\n",
        millions / best->blocks, (best->records + best->bounds) / best->blocks, i->node_bytes / n,
        i->triangle_bytes / n, i->primitive_id_bytes / n,
        (double)i->block_vertices * plt_index_bits(i->vertices) / 8 / n,
        (double)i->frame_bytes / i->frames / n,
        ((double)plt_arena_need(i, 1, &moving) - (double)plt_arena_need(i, 1, &o)) / n);
}

static void run(const packed *image, const packed *blocks, const mesh *m, const char *name,
                uint32_t k, uint32_t bits) {
    const double millions = 1e-6 * (double)m->triangles;
    const opened records = open_image(image, PLT_RECORDS_ALWAYS),
                 vertices = open_image(image, PLT_RECORDS_NEVER),
                 compact = open_image(blocks != NULL ? blocks : image, PLT_RECORDS_AUTO);
    const int are_open =
        records.engine != NULL && vertices.engine != NULL && compact.engine != NULL;
    speeds best = {.decode = 0};
    for (int i = 0; i < ROUNDS && are_open; i++) {
        take_frames(records.engine, &best, i);
        take_vertices(vertices.engine, &best, i);
        best_picture(&best.with, records.engine, i);
        best_picture(&best.without, vertices.engine, i);
        take_corners(records.engine, m, &best, i);
        take_blocks(compact.engine, &best, i);
    }
    free(records.arena);
    free(vertices.arena);
    free(compact.arena);
    printf(
        "    %s, K = %u, %s%.0u: million triangles per second: decoded %.1f, records %.1f, bounds "
        "and nodes %.1f, the last two %.1f, from corners %.1f\n",
        name, k, bits > 0 ? "lattice:" : "float", bits, millions / best.decode,
        millions / best.records, millions / best.bounds, millions / (best.records + best.bounds),
        millions / best.corners);
    printf("    ... without records: bounds and nodes %.1f, a picture %.2f of that with them\n",
           millions / best.vertices, best.without / best.with);
    if (blocks != NULL) {
        print_blocks(blocks, &best);
    }
}

static void measure(const mesh *m, const char *name) {
    for (uint32_t k = 1; k <= 4; k *= 2) {
        for (uint32_t bits = 0; bits <= 16; bits += 16) {
            packed image, blocks;
            pack_frames(&image, m, k, bits, 0);
            if (bits > 0) {
                pack_frames(&blocks, m, k, bits, 1);
            }
            run(&image, bits > 0 ? &blocks : NULL, m, name, k, bits);
            pack_free(&image);
            if (bits > 0) {
                pack_free(&blocks);
            }
        }
    }
}

int main(int argc, char **argv) {
    return measure_meshes(argc, argv, "frames of an image, triangles per second on one core",
                          measure);
}
