/* moved - see moved.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/moved.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/base/clock.h"
#include "host_tools/mesh/mesh.h"

enum { FRAMES_END = 100000 };

/* "A:B" with A < B. */
static int read_range(const char *text, moved *m) {
    unsigned end = 0;
    int length = 0;
    if (strspn(text, "0123456789:") != strlen(text) ||
        sscanf(text, "%6u:%6u%n", &m->first, &end, &length) != 2 || text[length] != '\0' ||
        m->first >= end || end > FRAMES_END) {
        return -1;
    }
    m->count = end - m->first;
    return 0;
}

void moved_read(moved *m, scene *s, args *a) {
    const char *frames = args_text(a, "--frames", NULL);
    m->mesh = args_text(a, "--moved", NULL);
    m->first = 0;
    m->count = 1;
    if (frames != NULL && read_range(frames, m) != 0) {
        args_complain(a, "--frames takes A:B, 0 to %d, A below B, not '%s'", FRAMES_END - 1,
                      frames);
    }
    if (frames != NULL && m->mesh == NULL) {
        args_complain(a, "--frames is for --moved MESH");
    }
    if (m->mesh != NULL && args_has(a, "--orbit")) {
        args_complain(a, "--moved and --orbit are two films; leave out one of them");
    }
    s->options.movable = m->mesh != NULL;
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

/* The file of that frame: a '{}' in the name becomes its number. NULL: out of memory. */
static char *file_of(const moved *m, unsigned frame) {
    const char *at = strstr(m->mesh, "{}");
    const size_t room = strlen(m->mesh) + 16;
    char *name = malloc(room);
    if (name != NULL && at != NULL) {
        snprintf(name, room, "%.*s%03u%s", (int)(at - m->mesh), m->mesh, frame, at + 2);
    } else if (name != NULL) {
        snprintf(name, room, "%s", m->mesh);
    }
    return name;
}

static int read_mesh(mesh *to, const moved *m, unsigned frame, fail *f) {
    mesh_report report = {0};
    char *name = file_of(m, frame);
    if (name == NULL) {
        return fail_set(f, m->mesh, "out of memory; close other programs");
    }
    const int status = mesh_read(to, name, frame, &report, f);
    free(name);
    return status;
}

int moved_to(moved *m, scene *s, unsigned index, fail *f) {
    const unsigned number = m->first + index;
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
