/* stage - see stage.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/stage.h"

#include <string.h>

#include "board/hash.h"
#include "host_tools/app/frame.h"
#include "host_tools/app/scene.h"
#include "host_tools/app/view.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/pack.h"

uint64_t stage_hash(const mesh *m) {
    const uint64_t counts[2] = {m->vertices, m->triangles};
    uint64_t hash = hash_bytes((const uint8_t *)counts, sizeof counts);
    hash = hash_update(hash, (const uint8_t *)m->vertex, 3 * m->vertices * sizeof *m->vertex);
    return hash_update(hash, (const uint8_t *)m->triangle, 3 * m->triangles * sizeof *m->triangle);
}

void stage_set(stage *s, const char *name, mesh *m) {
    memset(s, 0, sizeof *s);
    s->name = name;
    s->m = *m;
    s->hash = stage_hash(m);
    memset(m, 0, sizeof *m);
}

void stage_free(stage *s) {
    mesh_free(&s->m);
    heap_drop(s->look.room);
    picture_free(&s->picture);
    memset(s, 0, sizeof *s);
}

static int failed(const stage *s, int status, fail *f) {
    return fail_set(f, s->name, "the engine ends with status %d; please report this", status);
}

static int render(stage *s, plt_engine *engine, const plt_camera *camera, fail *f) {
    const plt_frame frame = {.width = STAGE_PICTURE_SIDE,
                             .height = STAGE_PICTURE_SIDE,
                             .shader = PLT_SHADE_EYELIGHT,
                             .camera = *camera};
    if (picture_make(&s->picture, frame.width, frame.height, f) != 0) {
        return -1;
    }
    int status = plt_render_begin(engine, &frame);
    while (status >= PLT_OK && (status = plt_render_step(engine, FRAME_STEP_VISITS)) > PLT_OK) {
        if (status == PLT_TILE) {
            frame_copy_tile(engine, &s->picture);
        }
    }
    return status == PLT_OK ? 0 : failed(s, status, f);
}

static int set_view(stage *s, const plt_camera *first, unsigned number, fail *f) {
    plt_frame frame = {.width = (uint16_t)s->look.side, .height = (uint16_t)s->look.side};
    view_orbit(first, (double)number / s->look.views, &frame.camera);
    const int status = plt_view_set(&s->look.view[number], &frame);
    return status == PLT_OK ? 0 : failed(s, status, f);
}

static int set_views(stage *s, plt_engine *engine, const stage_options *o, fail *f) {
    plt_camera first;
    int status = 0;
    view_of_all(plt_engine_info(engine), o->side, o->side, &first);
    s->look.side = o->side;
    s->look.views = o->views;
    s->look.room = heap_get(TURNS_BATCH * sizeof *s->look.room);
    if (s->look.room == NULL) {
        return fail_set(f, "rays", "out of memory; choose a smaller --size");
    }
    for (unsigned i = 0; i < o->views && status == 0; i++) {
        status = set_view(s, &first, i, f);
    }
    return status == 0 ? render(s, engine, &first, f) : status;
}

static const plt_ray *rays_at(void *context, uint64_t first, uint32_t count) {
    return view_rays_make(context, first, count);
}

turns_rays stage_rays(stage *s) {
    return (turns_rays){rays_at, &s->look, view_rays_count(&s->look)};
}

int stage_look(stage *s, const stage_options *o, fail *f) {
    const pack_options options = {.leaf_triangles = 4, .treelet_nodes = 64};
    packed image = {0};
    scene on = SCENE_CLOSED;
    plt_fault fault;
    if (s->look.room != NULL) {
        return 0;
    }
    int status = pack_mesh(&image, &s->m, &options, s->name, f);
    if (status == 0) {
        host_scene_hold(&on.file, image.bytes, image.size, 0);
        on.source = on.file.source;
        on.arena_bytes = host_arena_bytes();
        const int opened = scene_start(&on, s->name, &fault);
        status = opened == PLT_OK ? set_views(s, on.engine, o, f)
                                  : scene_refused(&on, s->name, opened, &fault, f);
    }
    scene_close(&on);
    pack_free(&image);
    return status;
}
