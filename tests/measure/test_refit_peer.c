/* test_refit_peer [MESH...] - a refit beside that of Embree 3, in turn, on one core
 *
 * Embree (Debian package libembree-dev): a scene of build quality LOW, dynamic, with a geometry of
 * build quality REFIT; its time is that of committing both after every vertex has moved. Ours, of
 * thesis nodes: bounds and nodes alone; plt_move, which looks at corners by triangle and writes the
 * records first; and records and refit of a frame of the image, which is what Embree does: from
 * vertices and indices. The best of so many rounds, each of which has all of them. Where Embree is
 * not installed a line says so, and the rest is measured. Without a mesh it takes a small one and
 * is one test more; the figures are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "engine/motion/refit.h"
#include "engine/motion/vertices.h"
#include "engine/move.h"
#include "host_tools/base/clock.h"
#include "tests/measure/meshes.h"
#include "tests/measure/two_frames.h"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#define HAS_PEER 1
#else
#define HAS_PEER 0
#endif

enum { ROUNDS = 15, LISTS = 3 };

/* Seconds, the best; 0: not yet. */
typedef struct speeds {
    double bounds, moved, shown;
} speeds;

static void keep_least(double *best, double began) {
    const double took = clock_processor_seconds() - began;
    *best = *best == 0.0 || took < *best ? took : *best;
}

/* In round `i` the mesh is that much larger. */
static float scale_of(int i) {
    return i % 2 ? 1.5f : 1.0f;
}

/* ---- the other tracer ------------------------------------------------------------------ */

typedef struct peer {
    float *vertex; /* 16 bytes can be read from the last one */
    double best;
#if HAS_PEER
    RTCDevice device;
    RTCScene scene;
    RTCGeometry geometry;
#endif
} peer;

#if HAS_PEER
static void peer_open(peer *p, const mesh *m) {
    p->vertex = calloc(3 * m->vertices + 4, sizeof *p->vertex);
    memcpy(p->vertex, m->vertex, 3 * m->vertices * sizeof *p->vertex);
    p->device = rtcNewDevice("threads=1,set_affinity=0,isa=sse4.2");
    p->scene = rtcNewScene(p->device);
    rtcSetSceneFlags(p->scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(p->scene, RTC_BUILD_QUALITY_LOW);
    p->geometry = rtcNewGeometry(p->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(p->geometry, RTC_BUILD_QUALITY_REFIT);
    rtcSetSharedGeometryBuffer(p->geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, p->vertex,
                               0, 12, m->vertices);
    rtcSetSharedGeometryBuffer(p->geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, m->triangle,
                               0, 12, m->triangles);
    rtcCommitGeometry(p->geometry);
    rtcAttachGeometry(p->scene, p->geometry);
    rtcCommitScene(p->scene);
}

static void peer_round(peer *p, const mesh *m, int i) {
    for (size_t k = 0; k < 3 * m->vertices; k++) {
        p->vertex[k] = scale_of(i) * m->vertex[k];
    }
    const double began = clock_processor_seconds();
    rtcUpdateGeometryBuffer(p->geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(p->geometry);
    rtcCommitScene(p->scene);
    keep_least(&p->best, began);
}

static void peer_close(peer *p) {
    CHECK(rtcGetDeviceError(p->device) == RTC_ERROR_NONE, "the other tracer has failed");
    rtcReleaseGeometry(p->geometry);
    rtcReleaseScene(p->scene);
    rtcReleaseDevice(p->device);
    free(p->vertex);
}
#else
static void peer_open(peer *p, const mesh *m) {
    (void)p;
    (void)m;
}

static void peer_round(peer *p, const mesh *m, int i) {
    (void)p;
    (void)m;
    (void)i;
}

static void peer_close(peer *p) {
    (void)p;
}
#endif

/* ---- ours --------------------------------------------------------------------------------- */

typedef struct ours {
    packed image;
    void *arena;
    plt_engine *e;
} ours;

static void ours_open(ours *o, const mesh *m, uint32_t k) {
    plt_fault fault;
    pack_frames(&o->image, m, k, 0, 0);
    const plt_options options = {.packet_side = 2, .movable = 1};
    const plt_source source = rig_source(&o->image);
    const size_t bytes = plt_arena_need(&o->image.info, 1, &options);
    o->arena = aligned_alloc(PLT_ALIGN, bytes);
    CHECK(plt_open(&o->e, o->arena, bytes, &source, &options, &fault) == PLT_OK, "%s",
          fault.message);
}

/* From corners, and bounds and nodes of what has moved already. */
static void move_round(ours *o, const mesh *m, speeds *best, int i) {
    plt_fault fault;
    float(*corners)[9] = malloc(m->triangles * sizeof *corners);
    for (size_t k = 0; k < 9 * m->triangles; k++) {
        ((float *)corners)[k] = scale_of(i) * m->vertex[3 * (size_t)m->triangle[k / 3] + k % 3];
    }
    double began = clock_processor_seconds();
    CHECK(plt_move(o->e, (const float(*)[9])corners, &fault) == PLT_OK, "%s", fault.message);
    keep_least(&best->moved, began);
    began = clock_processor_seconds();
    plt_refit_all(o->e);
    keep_least(&best->bounds, began);
    free(corners);
}

/* From vertices and indices, which have come before. */
static void show_round(ours *o, speeds *best, int i) {
    plt_fault fault;
    const int status = plt_sequence_begin(o->e, (uint32_t)i % 2, &fault) +
                       plt_sequence_step(o->e, UINT32_MAX, &fault);
    CHECK(status == PLT_OK, "%s", fault.message);
    const double began = clock_processor_seconds();
    plt_vertices_put(plt_records_of(o->e), o->e->scene.info.triangles, &o->e->sequence.vertices);
    plt_refit_all(o->e);
    keep_least(&best->shown, began);
    plt_moved(o->e);
}

static void ours_close(ours *o) {
    free(o->arena);
    pack_free(&o->image);
}

/* ---- both in turn -------------------------------------------------------------------------- */

static void print_row(const mesh *m, uint32_t k, const speeds *s, double peer_seconds) {
    const double millions = 1e-6 * (double)m->triangles;
    const double row[3] = {s->bounds, s->moved, s->shown};
    printf("    K = %u:", (unsigned)k);
    for (int i = 0; i < 3; i++) {
        static const char *const names[3] = {"bounds and nodes", "from corners",
                                             "from vertices of a frame"};
        printf("%s %s %.1f", i > 0 ? "," : "", names[i], millions / row[i]);
        if (peer_seconds > 0.0) {
            printf(" (%.2f of Embree's)", peer_seconds / row[i]);
        }
    }
    printf("\n");
}

static void measure(const mesh *m, const char *name) {
    ours o[LISTS];
    speeds best[LISTS] = {{0, 0, 0}};
    peer p = {.best = 0};
    peer_open(&p, m);
    for (unsigned j = 0; j < LISTS; j++) {
        ours_open(&o[j], m, 1u << j);
    }
    for (int i = 0; i < ROUNDS; i++) {
        peer_round(&p, m, i);
        for (unsigned j = 0; j < LISTS; j++) {
            move_round(&o[j], m, &best[j], i);
            show_round(&o[j], &best[j], i);
        }
    }
    printf("  %s, %zu triangles, million triangles per second\n", name, m->triangles);
    if (HAS_PEER) {
        printf("    Embree's refit commit %.1f\n", 1e-6 * (double)m->triangles / p.best);
    } else {
        printf("    Embree is left out: it is not installed (Debian package libembree-dev)\n");
    }
    for (unsigned j = 0; j < LISTS; j++) {
        print_row(m, 1u << j, &best[j], p.best);
        ours_close(&o[j]);
    }
    peer_close(&p);
}

int main(int argc, char **argv) {
    return measure_meshes(argc, argv, "a refit beside another tracer's, on one core", measure);
}
