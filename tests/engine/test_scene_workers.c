/* test_scene_workers - several traversals, on threads of their own, read one scene
 *
 * A scene is opened alone, without an engine. Each worker has a traversal, a packet and
 * hits of its own. All start at once; in each round a worker traces every fourth packet
 * of the same rays, another slice than the other workers. Hits and statistics are
 * compared with those of an engine over the same image.
 *
 * SPDX-License-Identifier: MIT */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "engine/layout.h"
#include "engine/scene/open.h"
#include "engine/trace/rays.h"
#include "tests/hostile/images.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { WORKERS = 4, RAYS = 2048 };

static plt_ray rays[RAYS];

/* ---- a scene on its own --------------------------------------------------------- */

typedef struct lone_scene {
    plt_scene scene;
    unsigned char *memory; /* what it lies in, unless that is the image */
    size_t used;
    hostile_stream stream;
} lone_scene;

static plt_source source_of(const packed *image, hostile_stream *stream, int mapped) {
    const hostile_stream fresh = {image->bytes, image->size, 0};
    const plt_source fetched = {NULL, image->size, stream, hostile_start, hostile_wait};
    *stream = fresh;
    return mapped ? rig_source(image) : fetched;
}

/* The finished tree of an image, opened once; its memory is freed by the caller. */
static int open_lone(lone_scene *s, const packed *image, const plt_options *options, int mapped) {
    plt_header header;
    plt_layout layout;
    plt_fault fault = {0, 0, 0, 0, "no fault"};
    struct plt_compact_build *build = NULL;
    memset(s, 0, sizeof *s);
    const plt_source source = source_of(image, &s->stream, mapped);
    int status = plt_header_read(&header, image->bytes, image->size, &fault);
    if (status == PLT_OK) {
        const size_t bytes = plt_arena_need(&header.info, mapped, options);
        plt_arena arena = {room_get(bytes), bytes, 0, 0};
        const plt_opening o = {&s->scene, &source, &arena, &layout, &fault, 0, 0, 0, 0};
        plt_layout_of_image(&layout, &header.info, mapped, options);
        status = plt_scene_open(&o, &header, &build);
        s->memory = arena.base;
        s->used = arena.used;
    }
    CHECK(status == PLT_OK && build == NULL, "status %d: %s", status, fault.message);
    return status;
}

/* ---- workers ---------------------------------------------------------------------- */

typedef struct worker {
    const plt_scene *scene;
    plt_options options;
    pthread_barrier_t *start;
    unsigned number;
    int status; /* of the last packet */
    plt_stats stats;
    plt_hit hits[2][RAYS]; /* nearest, any */
} worker;

/* Exactly what the traversal may use: sanitizers see one entry too many. */
static void make_parts(const plt_scene *scene, const plt_options *options,
                       void *part[PLT_PARTS_COUNT]) {
    plt_layout layout;
    plt_layout_set(&layout, &scene->info, &scene->info, 1, options);
    memset(part, 0, PLT_PARTS_COUNT * sizeof *part);
    part[PLT_PART_STACK] = room_get((size_t)layout.bytes[PLT_PART_STACK]);
    part[PLT_PART_LEAVES] = room_get((size_t)layout.bytes[PLT_PART_LEAVES] + 1);
    part[PLT_PART_LOCAL_STACK] = room_get((size_t)layout.bytes[PLT_PART_LOCAL_STACK] + 1);
    part[PLT_PART_FORMAT] = room_get(plt_state_bytes((enum plt_format)scene->format));
    if (options->count_touched) {
        part[PLT_PART_TOUCHED] =
            room_get(4 * (size_t)plt_touched_words((enum plt_format)scene->format, &scene->info));
    }
    part[PLT_PART_PACKET] = room_get(plt_packet_bytes(options->packet_side));
}

static void trace_slice(worker *w, plt_traversal *t, plt_packet *p, unsigned slice) {
    const uint32_t most = (uint32_t)w->options.packet_side * w->options.packet_side;
    for (uint32_t i = slice * most; i < RAYS; i += WORKERS * most) {
        const uint32_t count = RAYS - i < most ? RAYS - i : most;
        for (int any = 0; any < 2 && w->status == PLT_OK; any++) {
            w->status = plt_trace_packet(t, p, rays + i, w->hits[any] + i, count, any);
        }
    }
}

static void *work(void *context) {
    worker *w = context;
    plt_traversal t;
    plt_packet p;
    void *part[PLT_PARTS_COUNT];
    make_parts(w->scene, &w->options, part);
    pthread_barrier_wait(w->start);
    plt_packet_init(&p, part[PLT_PART_PACKET], w->options.packet_side);
    plt_traversal_init(&t, w->scene, &w->options, part);
    for (unsigned round = 0; round < WORKERS; round++) {
        trace_slice(w, &t, &p, (w->number + round) % WORKERS);
    }
    w->stats = t.stats;
    for (unsigned i = 0; i < PLT_PARTS_COUNT; i++) {
        free(part[i]);
    }
    return NULL;
}

static void run_workers(worker w[WORKERS]) {
    pthread_t thread[WORKERS];
    pthread_barrier_t start;
    int error = pthread_barrier_init(&start, NULL, WORKERS);
    for (unsigned i = 0; i < WORKERS && error == 0; i++) {
        w[i].start = &start;
        error = pthread_create(&thread[i], NULL, work, &w[i]);
    }
    if (error != 0) {
        printf("FAIL %d threads cannot be started\n", WORKERS);
        exit(1); /* those that were started wait for the others */
    }
    for (unsigned i = 0; i < WORKERS; i++) {
        pthread_join(thread[i], NULL);
    }
    pthread_barrier_destroy(&start);
}

/* ---- what is compared --------------------------------------------------------------- */

static uint64_t shared, compared, met; /* scenes that workers have read, and rays */

/* What one engine finds. */
typedef struct single {
    plt_hit hits[2][RAYS];
    plt_options options;
    plt_stats stats;
} single;

static single trace_single(const rig *r, const plt_options *options) {
    static single s;
    s.options = *options;
    plt_stats_reset(r->engine);
    for (int any = 0; any < 2; any++) {
        CHECK(plt_trace(r->engine, rays, s.hits[any], RAYS, any) == PLT_OK, "any %d", any);
    }
    plt_stats_get(r->engine, &s.stats);
    return s;
}

static void compare_hits(const worker *w, const single *one, const char *name) {
    for (int any = 0; any < 2; any++) {
        for (uint32_t i = 0; i < RAYS; i++) {
            const plt_hit *found = &w->hits[any][i], *due = &one->hits[any][i];
            CHECK(memcmp(found, due, sizeof *found) == 0,
                  "%s, worker %u, any %d, ray %u: %u, not %u", name, w->number, any, i,
                  found->triangle, due->triangle);
            compared++;
            met += any ? due->triangle : due->triangle != PLT_MISS;
        }
    }
}

/* Every worker has traced all rays, in the engine's packets. */
static void compare_stats(const worker *w, const single *one, const char *name) {
    plt_stats due = one->stats;
    if (w->options.count_touched != one->options.count_touched) {
        due.bytes_touched_once = w->stats.bytes_touched_once;
    }
    const int counts = w->options.count_touched && w->stats.bytes_fetched > 0;
    CHECK((w->stats.bytes_touched_once > 0) == counts, "%s, worker %u: %u bytes touched once", name,
          w->number, (unsigned)w->stats.bytes_touched_once);
    CHECK(w->options.order != one->options.order || memcmp(&w->stats, &due, sizeof due) == 0,
          "%s, worker %u has other statistics", name, w->number);
}

static void compare(worker w[WORKERS], const single *one, const char *name) {
    for (unsigned i = 0; i < WORKERS; i++) {
        CHECK(w[i].status == PLT_OK, "%s, worker %u: status %d", name, i, w[i].status);
        compare_hits(&w[i], one, name);
        compare_stats(&w[i], one, name);
    }
}

/* The bytes that workers share are the same afterwards: structure, memory, image. */
static void share(const rig *r, const lone_scene *s, worker w[WORKERS], const char *name) {
    unsigned char *image = room_get(r->image.size), *memory = room_get(s->used + 1);
    plt_scene scene;
    memcpy(image, r->image.bytes, r->image.size);
    memcpy(memory, s->memory, s->used);
    memcpy(&scene, &s->scene, sizeof scene);
    run_workers(w);
    CHECK(memcmp(&scene, &s->scene, sizeof scene) == 0, "%s: the scene was written", name);
    CHECK(memcmp(memory, s->memory, s->used) == 0, "%s: the scene's memory was written", name);
    CHECK(memcmp(image, r->image.bytes, r->image.size) == 0, "%s: the image was written", name);
    shared++;
    free(image);
    free(memory);
}

/* Every other worker counts touched blocks, and if `mixed` takes the other order. */
static void hire(worker w[WORKERS], const plt_scene *scene, const plt_options *run, int mixed) {
    memset(w, 0xEE, WORKERS * sizeof *w);
    for (unsigned i = 0; i < WORKERS; i++) {
        w[i].scene = scene;
        w[i].options = *run;
        w[i].options.count_touched = (uint8_t)(i % 2);
        w[i].options.order = (uint8_t)(mixed ? i % 2 : run->order);
        w[i].number = i;
        w[i].status = PLT_OK;
    }
}

static void subject(const rig *r, const plt_options *run, int mixed, const char *name) {
    const single one = trace_single(r, run);
    worker *w = malloc(WORKERS * sizeof *w);
    for (int mapped = 0; mapped < 2; mapped++) {
        lone_scene s;
        if (open_lone(&s, &r->image, run, mapped) == PLT_OK) {
            CHECK(mapped ? s.used == 0 : s.used > 0, "%s: %zu bytes of the arena", name, s.used);
            hire(w, &s.scene, run, mixed);
            share(r, &s, w, name);
            compare(w, &one, name);
        }
        CHECK(!s.stream.beyond, "%s: the source was read beyond its end", name);
        free(s.memory);
    }
    free(w);
}

/* ---- scenes --------------------------------------------------------------------------- */

static mesh some_mesh(void) {
    mesh m = {0};
    random_state r = {41};
    shape_soup(&m, rig_is_tiny() ? 100 : 1500, 0.4f, 41);
    shape_sheet(&m, 3, 1);
    shape_coincident(&m, 5);
    rays_mixed(rays, RAYS, &m, &r);
    return m;
}

static void thesis(const mesh *m, uint8_t build, uint8_t order, int mixed) {
    rig r;
    rig_config config = rig_config_of(2, 3, build, PLT_SPLIT_SAH);
    config.run.order = order;
    const int status = rig_open(&r, m, &config);
    CHECK(status == PLT_OK, "%s: %s", rig_name(&config), r.fault.message);
    if (status == PLT_OK) {
        subject(&r, &config.run, mixed, rig_name(&config));
    }
    rig_close(&r);
}

static void compact(const mesh *m, uint32_t k, uint8_t floats) {
    rig r;
    compact_config config = compact_config_of(k, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    config.pack.floats = floats;
    const int status = compact_open(&r, m, &config);
    CHECK(status == PLT_OK, "%s: %s", compact_name(&config), r.fault.message);
    if (status == PLT_OK) {
        subject(&r, &config.run, 0, compact_name(&config));
    }
    rig_close(&r);
}

/* Of each subject, mapped and not, all hits of all workers were compared. */
static void all_shared(uint64_t subjects) {
    CHECK(shared == 2 * subjects && compared == shared * WORKERS * 2 * RAYS, "%u scenes, %u hits",
          (unsigned)shared, (unsigned)compared);
    CHECK(met > compared / 8, "%u of %u rays hit", (unsigned)met, (unsigned)compared);
    shared = compared = met = 0;
}

int main(void) {
    mesh m = some_mesh();
    test("workers on one scene of thesis nodes find an engine's hits, and write nothing of it");
    thesis(&m, PLT_BUILD_HOST, PLT_ORDER_DEPTH_FIRST, 0);
    thesis(&m, PLT_BUILD_HOST, PLT_ORDER_TWO_STAGE, 0);
    all_shared(2);
    test("so do workers of both orders at once");
    thesis(&m, PLT_BUILD_HOST, PLT_ORDER_TWO_STAGE, 1);
    all_shared(1);
    test("so do workers on one scene of compact blocks with strips");
    compact(&m, 1, 0);
    compact(&m, 4, 0);
    all_shared(2);
    test("so do workers on one scene of compact blocks with float records");
    compact(&m, 2, 1);
    all_shared(1);
    test("so do workers on one list of triangles without a tree");
    thesis(&m, PLT_BUILD_NONE, PLT_ORDER_DEPTH_FIRST, 0);
    all_shared(1);
    mesh_free(&m);
    return test_done();
}
