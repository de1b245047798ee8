/* test_sequence_speed [MESH...] - triangles per second of frames that an image holds
 *
 * Of thesis nodes, on one core: the best of ten. Blocks decoded and checked; records written from
 * vertices and indices; bounds and nodes; the last two together, which is what is compared with
 * corners that a caller gives (test_refit_speed); and, in turn with these, compact blocks of the
 * same lists: positions, bounds and nodes. Without a mesh it takes a small one and is one
 * test more; the figures are for people.
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
#include "tests/reference/shapes.h"

enum { ROUNDS = 10 };

typedef struct speeds {
    double decode, records, bounds, corners; /* seconds, the best */
    double blocks;                           /* compact blocks, all of them */
} speeds;

static double best_of(double best, double began, int round) {
    const double took = clock_processor_seconds() - began;
    return round == 0 || took < best ? took : best;
}

static int pack_first(packed *image, const mesh *m, uint32_t k, sequence *s, int is_compact,
                      fail *f) {
    rig_config c = rig_config_of(k, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    const compact_options blocks = {.build = PLT_BUILD_HOST,
                                    .lattice_bits = 16,
                                    .numbers = 1,
                                    .leaf_triangles = k,
                                    .moving = &s->moving};
    lattice_loss loss;
    c.pack.checks = 0; /* what moves is not streamed */
    return is_compact ? pack_compact(image, m, &blocks, "test", &loss, f)
                      : pack_mesh(image, m, &c.pack, "test", f);
}

/* Two frames: the mesh, and the mesh half as large again. */
static void pack_frames(packed *image, const mesh *m, uint32_t k, uint32_t bits, int is_compact) {
    sequence_options o = {2, 25, 2, {{0}, 0, 0}};
    mesh frame = *m;
    sequence s;
    fail f = {""};
    lattice_ground ground = {plt_box_empty(), LATTICE_NO_GRAIN};
    shape_box(m, ground.box.lo, ground.box.hi);
    for (int a = 0; a < 3; a++) {
        ground.box.lo[a] *= ground.box.lo[a] < 0 ? 1.5f : 1.0f;
        ground.box.hi[a] *= ground.box.hi[a] > 0 ? 1.5f : 1.0f;
    }
    const lattice_wish wish = {.bits = bits, .power = 1};
    CHECK(bits == 0 || lattice_over(&o.lattice, &ground, &wish, "test", &f) == 0, "%s", f.text);
    mesh first = *m;
    first.vertex = malloc(3 * m->vertices * sizeof(float));
    frame.vertex = malloc(3 * m->vertices * sizeof(float));
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        first.vertex[i] = m->vertex[i];
        frame.vertex[i] = 1.5f * m->vertex[i];
    }
    if (bits > 0) {
        sequence_snap(&first, &o.lattice);
    }
    CHECK(sequence_begin(&s, &first, &o, "test", &f) == 0 &&
              pack_first(image, &first, k, &s, is_compact, &f) == 0 &&
              sequence_add(&s, &first, "test", &f) == 0,
          "%s", f.text);
    CHECK(sequence_add(&s, &frame, "test", &f) == 0 &&
              sequence_finish(&s, image, &first, "test", &f) == 0,
          "%s", f.text);
    free(first.vertex);
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

static void take_blocks(plt_engine *e, speeds *best, int round) {
    plt_fault fault;
    int status = plt_sequence_show(e, 0, &fault);
    status += plt_sequence_begin(e, 1, &fault) + plt_sequence_step(e, UINT32_MAX, &fault);
    const double began = clock_processor_seconds();
    status += plt_sequence_show(e, 1, &fault);
    best->blocks = best_of(best->blocks, began, round);
    CHECK(status == PLT_OK, "%s", fault.message);
}

typedef struct opened {
    void *arena;
    plt_engine *engine;
} opened;

static opened open_image(const packed *image) {
    const plt_options o = {.packet_side = 2, .movable = 1};
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
    const opened records = open_image(image), compact = open_image(blocks != NULL ? blocks : image);
    speeds best = {0, 0, 0, 0, 0};
    for (int i = 0; i < ROUNDS && records.engine != NULL && compact.engine != NULL; i++) {
        take_frames(records.engine, &best, i);
        take_corners(records.engine, m, &best, i);
        take_blocks(compact.engine, &best, i);
    }
    free(records.arena);
    free(compact.arena);
    printf(
        "    %s, K = %u, %s%.0u: million triangles per second: decoded %.1f, records %.1f, bounds "
        "and nodes %.1f, the last two %.1f, from corners %.1f\n",
        name, k, bits > 0 ? "lattice:" : "float", bits, millions / best.decode,
        millions / best.records, millions / best.bounds, millions / (best.records + best.bounds),
        millions / best.corners);
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
