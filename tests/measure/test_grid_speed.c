/* test_grid_speed [MESH...] - grids: how fast they are made, and what rays through them take
 *
 * On one core, the best of five. Without a mesh it takes a small one and is one test more; the
 * figures are for people. Rates of a run can be compared with each other, as all of it shares the
 * machine alike.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/grid/build.h"
#include "engine/trace/grid_state.h"
#include "host_tools/base/clock.h"
#include "tests/measure/grid_single.h"
#include "tests/measure/meshes.h"
#include "tests/reference/frame_rays.h"
#include "tests/reference/grid_rig.h"
#include "tests/reference/shapes.h"

enum { ROUNDS = 5, MOST_BYTES = 600 }; /* per triangle, of a grid of any density */

typedef struct subject {
    const mesh *m;
    grid_rig g;
    rig_config config;
    unsigned char *room; /* for grids of any density */
    size_t bytes;
    uint32_t *mailbox;
} subject;

static double best_of(double best, double began, int round) {
    const double took = clock_processor_seconds() - began;
    return round == 0 || took < best ? took : best;
}

static plt_grid_job job_of(const subject *s, float density, int is_plain) {
    const plt_scene *scene = &s->g.engine->scene;
    const plt_grid_job job = {.records = scene->gridded.records,
                              .count = scene->gridded.count,
                              .box = &scene->box,
                              .density = density,
                              .is_plain = (uint8_t)is_plain,
                              .room = s->room,
                              .bytes = s->bytes};
    return job;
}

/* ---- engines ---------------------------------------------------------------------------- */

static void open_subject(subject *s, unsigned packet) {
    s->config.run.packet_side = (uint8_t)packet;
    CHECK(grid_rig_open(&s->g, s->m, &s->config, (size_t)80 * s->m->triangles), "%s",
          s->g.fault.message);
    s->bytes = ((size_t)MOST_BYTES * s->m->triangles + 65536) / 16 * 16;
    s->room = aligned_alloc(PLT_ALIGN, s->bytes);
    s->mailbox = calloc(s->m->triangles + 1, sizeof *s->mailbox);
}

static void close_subject(subject *s) {
    grid_rig_close(&s->g);
    free(s->room);
    free(s->mailbox);
}

static double trace_seconds(plt_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    double best = 0.0;
    for (int i = 0; i < ROUNDS; i++) {
        plt_stats_reset(e);
        const double began = clock_processor_seconds();
        CHECK(plt_trace(e, rays, hits, count, 0) == PLT_OK, "traced");
        best = best_of(best, began, i);
    }
    return best;
}

/* The best of three densities. */
static double single_seconds(subject *s, const plt_ray *rays, const plt_hit *hits, uint32_t count,
                             float *density) {
    static const float densities[] = {1.0f, 2.0f, 4.0f};
    double best = 0.0;
    for (int k = 0; k < 3; k++) {
        const plt_grid_job job = job_of(s, densities[k], 1);
        single one = {plt_grid_build(&job), job.records, s->mailbox, 0};
        uint32_t others = 0;
        memset(s->mailbox, 0, s->m->triangles * sizeof *s->mailbox);
        for (int i = 0; i < 2; i++) {
            const double began = clock_processor_seconds();
            others = 0;
            for (uint32_t n = 0; n < count; n++) {
                others += single_trace(&one, &rays[n]).triangle != hits[n].triangle;
            }
            const double took = clock_processor_seconds() - began;
            *density = best == 0.0 || took < best ? densities[k] : *density;
            best = best == 0.0 || took < best ? took : best;
        }
        CHECK(others <= count / 200, "single rays hit %u others", others);
    }
    return best;
}

/* ---- figures ---------------------------------------------------------------------------- */

static void build_speed(subject *s) {
    static const float densities[] = {0.25f, 0.5f, 1.0f, 2.0f, 4.0f};
    const double millions = 1e-6 * (double)s->m->triangles;
    for (int k = 0; k < 5; k++) {
        double plain = 0.0, whole = 0.0;
        const plt_grid *g = NULL;
        for (int i = 0; i < 2 * ROUNDS; i++) {
            const plt_grid_job job = job_of(s, densities[k], i % 2);
            const double began = clock_processor_seconds();
            g = plt_grid_build(&job);
            if (i % 2 == 0) {
                whole = best_of(whole, began, i / 2);
            } else {
                plain = best_of(plain, began, i / 2);
            }
        }
        const plt_grid_job job = job_of(s, densities[k], 0);
        g = plt_grid_build(&job);
        printf(
            "    k = %-4g %4ux%4ux%4u cells: %5.1f million triangles per second, without cells "
            "of crowded ones (%u) %5.1f; %.2f references, %.1f bytes per triangle\n",
            (double)densities[k], g->top.cells[0], g->top.cells[1], g->top.cells[2],
            millions / whole, g->crowded_count, millions / plain,
            (double)g->references / (double)s->m->triangles,
            (double)g->bytes / (double)s->m->triangles);
    }
}

static void density_speed(subject *s, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    static const float densities[] = {0.25f, 0.5f, 1.0f, 2.0f, 4.0f};
    const plt_grid *was = s->g.engine->scene.gridded.grid;
    printf("    million rays per second, k = 0.25 to 4 (plain):");
    for (int k = 0; k < 5; k++) {
        for (int plain = 0; plain < 2; plain++) {
            const plt_grid_job job = job_of(s, densities[k], plain);
            s->g.engine->scene.gridded.grid = plt_grid_build(&job);
            const double took = trace_seconds(s->g.engine, rays, hits, count);
            printf(plain ? " (%.1f)" : "  %.1f", 1e-6 * count / took);
        }
    }
    printf("\n");
    s->g.engine->scene.gridded.grid = was;
}

/* Of four rays each, in millions. */
static void without(subject *s, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    static const struct {
        const char *name;
        uint8_t without;
    } kinds[] = {{"neither", 7}, {"mailbox", 6},     {"culling", 5},
                 {"both", 4},    {"groups, too", 0}, {"... without rectangles", 8}};
    plt_grid_state *state = plt_grid_state_of(&s->g.engine->traversal);
    for (int k = 0; k < 6; k++) {
        plt_stats q;
        state->without = kinds[k].without;
        const double took = trace_seconds(s->g.engine, rays, hits, count);
        plt_stats_get(s->g.engine, &q);
        printf(
            "    %-24s %6.2f million tests of a ray and a triangle, %5.2f cells and %5.2f "
            "references per packet ray, %5.1f Mray/s\n",
            kinds[k].name, 4e-6 * (double)q.triangle_tests, (double)q.node_visits / (double)q.rays,
            (double)q.group_tests / (double)q.rays, 1e-6 * count / took);
    }
    state->without = 0;
}

static double frame_speed(subject *s, unsigned side, unsigned packet, double smaller) {
    const uint32_t count = side * side;
    plt_ray *rays = frame_rays(s->m, side, packet);
    plt_hit *hits = malloc(count * sizeof *hits), *due = malloc(count * sizeof *due);
    float density = 0.0f;
    const double tree = trace_seconds(s->g.tree.engine, rays, due, count);
    const double grid = trace_seconds(s->g.engine, rays, hits, count);
    const double one = single_seconds(s, rays, due, count, &density);
    CHECK(memcmp(hits, due, count * sizeof *hits) == 0, "hits of a grid and of a tree");
    printf(
        "    %4ux%-4u in %2ux%-2u: grid %6.2f Mray/s, tree %6.2f (grid %.2f times), single rays "
        "%5.2f at k = %g (grid %.1f times)",
        side, side, packet, packet, 1e-6 * count / grid, 1e-6 * count / tree, tree / grid,
        1e-6 * count / one, (double)density, one / grid);
    printf(smaller > 0.0 ? "; %.2f times the quarter frame\n" : "\n", grid / smaller);
    if (side == 512) {
        density_speed(s, rays, hits, count);
        without(s, rays, hits, count);
    }
    free(rays);
    free(hits);
    free(due);
    return grid;
}

/* A frame of triangles that move: records written, refit or grid, 512 x 512 rays. */
static void moved_frames(subject *s, unsigned packet) {
    const uint32_t count = 512 * 512;
    plt_ray *rays = frame_rays(s->m, 512, packet);
    plt_hit *hits = malloc(count * sizeof *hits);
    float(*corners)[9] = malloc((s->m->triangles + 1) * sizeof *corners);
    double best[2][2] = {{0, 0}, {0, 0}};
    for (uint32_t i = 0; i < 3 * s->m->triangles; i++) {
        memcpy(&corners[i / 3][3 * (i % 3)], shape_corner(s->m, i / 3, i % 3), 12);
    }
    for (int i = 0; i < 2 * ROUNDS; i++) {
        plt_engine *e = i % 2 ? s->g.engine : s->g.tree.engine;
        plt_fault fault;
        double began = clock_processor_seconds();
        CHECK(plt_move(e, (const float(*)[9])corners, &fault) == PLT_OK, "%s", fault.message);
        best[i % 2][0] = best_of(best[i % 2][0], began, i / 2);
        began = clock_processor_seconds();
        CHECK(plt_trace(e, rays, hits, count, 0) == PLT_OK, "traced");
        best[i % 2][1] = best_of(best[i % 2][1], began, i / 2);
    }
    printf(
        "    a moved frame: tree %.2f + %.2f ms, grid %.2f + %.2f ms: the grid's takes %.2f of "
        "the tree's\n",
        1e3 * best[0][0], 1e3 * best[0][1], 1e3 * best[1][0], 1e3 * best[1][1],
        (best[1][0] + best[1][1]) / (best[0][0] + best[0][1]));
    free(corners);
    free(rays);
    free(hits);
}

/* `to` gets the triangles of `m`, too. */
static int append(mesh *to, const mesh *m) {
    const uint32_t first = (uint32_t)to->vertices;
    fail f = {""};
    if (mesh_reserve(to, to->vertices + m->vertices, to->triangles + m->triangles, &f) != 0) {
        return 0;
    }
    memcpy(to->vertex + 3 * to->vertices, m->vertex, 12 * m->vertices);
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        to->triangle[3 * to->triangles + i] = first + m->triangle[i];
    }
    to->vertices += m->vertices;
    to->triangles += m->triangles;
    return 1;
}

/* The mesh is a teapot in a stadium: 0.155 long, on a floor of 100 in 64 x 64 squares. */
static void stadium(const mesh *m, unsigned packet) {
    mesh whole = {0}, small = {0};
    float lo[3], hi[3], longest = 0.0f;
    shape_box(m, lo, hi);
    for (int a = 0; a < 3; a++) {
        longest = fmaxf(longest, hi[a] - lo[a]);
    }
    CHECK(append(&small, m), "out of memory");
    const float scale = 0.155f / longest;
    shape_transform(&small, scale, 3.0f - scale * lo[0], -scale * lo[1], -7.0f - scale * lo[2]);
    shape_sheet(&whole, rig_is_tiny() ? 2 : 64, 1);
    shape_transform(&whole, 50.0f, 0.0f, 0.0f, 0.0f);
    CHECK(append(&whole, &small), "out of memory");
    subject s = {.m = &whole};
    s.config = rig_config_of(4, 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    s.config.run.count_touched = 0;
    open_subject(&s, packet);
    if (s.g.engine != NULL) {
        const uint32_t count = 512 * 512;
        plt_ray *rays = frame_rays(&small, 512, packet);
        plt_hit *hits = malloc(count * sizeof *hits);
        const double tree = trace_seconds(s.g.tree.engine, rays, hits, count);
        const double grid = trace_seconds(s.g.engine, rays, hits, count);
        const uint32_t crowded = grid_of(&s.g)->crowded_count;
        const plt_grid_job job = job_of(&s, 1.0f, 1);
        s.g.engine->scene.gridded.grid = plt_grid_build(&job);
        const double plain = trace_seconds(s.g.engine, rays, hits, count / 16);
        printf(
            "    in a stadium, %2ux%-2u: tree %.2f Mray/s, grid %.2f (%u crowded cells): takes "
            "%.2f "
            "times as long; without cells of crowded ones %.3f\n",
            packet, packet, 1e-6 * count / tree, 1e-6 * count / grid, crowded, grid / tree,
            1e-6 * count / 16 / plain);
        free(rays);
        free(hits);
    }
    close_subject(&s);
    mesh_free(&whole);
    mesh_free(&small);
}

static void measure(const mesh *m, const char *name) {
    printf("  %s, %zu triangles\n", name, m->triangles);
    for (unsigned packet = 8; packet <= 16 && packet <= PLT_PACKET_SIDE_MAX; packet *= 2) {
        subject s = {.m = m};
        s.config = rig_config_of(4, 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
        s.config.run.count_touched = 0;
        s.config.run.movable = 1;
        open_subject(&s, packet);
        if (s.g.engine != NULL) {
            if (packet == 8) {
                build_speed(&s);
            }
            const double half = frame_speed(&s, 512, packet, 0.0);
            frame_speed(&s, 1024, packet, half);
            moved_frames(&s, packet);
        }
        close_subject(&s);
        stadium(m, packet);
    }
}

int main(int argc, char **argv) {
    return measure_meshes(argc, argv, "grids, on one core", measure);
}
