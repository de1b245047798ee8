/* counted_engine - see counted_engine.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/counted/counted_engine.h"

#include <string.h>

#include "engine/engine.h"
#include "engine/shade/camera.h"
#include "host_tools/base/heap.h"
#include "host_tools/baselines/counted/counted_traversal.h"

struct counted_engine {
    plt_engine *engine;
    counted_traversal counted;
    char name[64];
};

counted_engine *counted_engine_open(plt_engine *engine, const char *name, fail *f) {
    if (engine->scene.format != PLT_FORMAT_THESIS) {
        fail_set(f, name,
                 "--counts are of resident thesis nodes; leave it out, or pack with --nodes "
                 "thesis and render without --residency or --structure");
        return NULL;
    }
    counted_engine *e = heap_get_zeroed(sizeof *e);
    if (e == NULL) {
        fail_set(f, name, "out of memory; close other programs");
        return NULL;
    }
    e->engine = engine;
    strncpy(e->name, name, sizeof e->name - 1);
    return e;
}

void counted_engine_close(counted_engine *e) {
    if (e != NULL) {
        counted_close(&e->counted);
        heap_drop(e);
    }
}

/* A tree that was rebuilt may have grown. */
static int begin(counted_engine *e, fail *f) {
    return counted_begin(&e->counted, &e->engine->traversal) == 0
               ? 0
               : fail_set(f, e->name, "out of memory for counts; leave out --counts");
}

int counted_engine_trace(counted_engine *e, const plt_ray *rays, plt_hit *hits, uint32_t count,
                         int any, fail *f) {
    const uint32_t side = plt_packet_side(e->engine), most = side * side;
    if (begin(e, f) != 0) {
        return -1;
    }
    for (uint32_t at = 0; at < count; at += most) {
        const uint32_t left = count - at;
        counted_trace(&e->counted, &e->engine->packet, rays + at, hits + at,
                      left < most ? left : most, any);
    }
    return 0;
}

int counted_engine_frame(counted_engine *e, const plt_frame *frame, fail *f) {
    plt_pixels at = {
        .side = plt_packet_side(e->engine), .x_end = frame->width, .y_end = frame->height};
    plt_view view;
    if (plt_view_set(&view, frame) != PLT_OK) {
        return fail_set(f, "engine", "status %d; please report this", PLT_ERR_ARGUMENT);
    }
    if (begin(e, f) != 0) {
        return -1;
    }
    for (at.y = 0; at.y < at.y_end; at.y += at.side) {
        for (at.x = 0; at.x < at.x_end; at.x += at.side) {
            counted_square(&e->counted, &e->engine->packet, &view, &at);
        }
    }
    return 0;
}

structure_statistics counted_engine_count(const counted_engine *e) {
    const plt_stats *stats = &e->counted.t.stats;
    structure_statistics s;
    memset(&s, 0, sizeof s);
    packet_counts_put(&e->counted.counts, &s);
    s.node_visits = stats->node_visits;
    s.box_tests = stats->group_tests;
    s.triangle_tests = stats->triangle_tests;
    return s;
}
