/* moved - see moved.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/moved.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/played.h"
#include "host_tools/base/clock.h"
#include "host_tools/mesh/mesh.h"

void moved_read(moved *m, scene *s, args *a) {
    const char *frames = args_text(a, "--frames", NULL);
    m->mesh = args_text(a, "--moved", NULL);
    m->is_played = frames != NULL && m->mesh == NULL;
    m->range = (frame_range){0, 1};
    if (frames != NULL && frame_range_read(&m->range, frames) != 0) {
        args_complain(a, "--frames takes A:B, 0 to %d, A below B, not '%s'", FRAME_RANGE_END - 1,
                      frames);
    }
    if (moved_is(m) && args_has(a, "--orbit")) {
        args_complain(a, "%s and --orbit are two films; leave out one of them",
                      m->mesh != NULL ? "--moved" : "--frames");
    }
    s->options.movable = (uint8_t)moved_is(m);
}

/* Nine floats per triangle; NULL: out of memory. */
static float (*corners_of(const mesh *m))[9] {
    float(*corners)[9] = malloc(m->triangles * sizeof *corners + 1);
    for (size_t i = 0; i < 3 * m->triangles && corners != NULL; i++) {
        memcpy((float *)corners + 3 * i, m->vertex + 3 * (size_t)m->triangle[i], 3 * sizeof(float));
    }
    return corners;
}

/* `frame`: its number, for messages. */
static int move_engines(const moved *m, const scene *s, const float (*corners)[9], unsigned frame,
                        fail *f) {
    for (unsigned i = 0; i < s->crew.count; i++) {
        plt_fault fault;
        if (plt_move(s->crew.worker[i].engine, corners, &fault) != PLT_OK) {
            return fail_set(f, m->mesh,
                            "frame %u: triangle %" PRIu32 ": %s; bring the mesh nearer to 0,0,0",
                            frame, fault.offset, fault.message);
        }
    }
    return 0;
}

static int move_mesh(moved *m, const scene *s, const mesh *to, unsigned frame, fail *f) {
    const uint32_t due = plt_engine_info(s->engine)->triangles;
    if (plt_engine_info(s->engine)->instances > 0) {
        return fail_set(f, m->mesh, "the scene has instances, which no mesh moves; use --frames");
    }
    if (plt_engine_info(s->engine)->nodes_format == PLT_NODES_COMPACT) {
        return fail_set(f, m->mesh,
                        "the scene has compact blocks, which no mesh moves; use --frames");
    }
    if (to->triangles != due) {
        return fail_set(f, m->mesh,
                        "frame %u: has %zu triangles, the scene %" PRIu32
                        "; pack the scene from frame 0 of the same mesh",
                        frame, to->triangles, due);
    }
    float(*corners)[9] = corners_of(to);
    if (corners == NULL) {
        return fail_set(f, m->mesh, "out of memory; close other programs");
    }
    const double began = clock_thread_seconds();
    const int status = move_engines(m, s, (const float(*)[9])corners, frame, f);
    m->move_seconds += clock_thread_seconds() - began;
    free(corners);
    return status;
}

static int read_mesh(mesh *to, const moved *m, unsigned frame, fail *f) {
    mesh_report report = {0};
    char *name = frame_range_file(m->mesh, frame);
    if (name == NULL) {
        return fail_set(f, m->mesh, "out of memory; close other programs");
    }
    const int status = mesh_read(to, name, frame, &report, f);
    free(name);
    return status;
}

static int move_to_mesh(moved *m, scene *s, unsigned number, fail *f) {
    mesh frame = {0};
    fail why = {""};
    const double began = clock_thread_seconds();
    int status = read_mesh(&frame, m, number, &why);
    m->read_seconds += clock_thread_seconds() - began;
    if (status != 0) {
        char name[16];
        snprintf(name, sizeof name, "frame %u", number);
        status = fail_set(f, name, "%s", why.text); /* which names the file */
    } else {
        status = move_mesh(m, s, &frame, number, f);
    }
    mesh_free(&frame);
    return status;
}

int moved_to(moved *m, scene *s, const char *path, unsigned index, fail *f) {
    const unsigned number = m->range.first + index;
    if (!m->is_played) {
        return move_to_mesh(m, s, number, f);
    }
    const double began = clock_thread_seconds();
    const int status = played_to(s, path, number, f);
    m->move_seconds += clock_thread_seconds() - began;
    return status;
}

void moved_print(output *o, const moved *m, unsigned repeat, fail *f) {
    output_print(o, f, "  \"move_seconds\": %.9f,\n  \"mesh_seconds\": %.9f,\n",
                 m->move_seconds / repeat, m->read_seconds / repeat);
}
