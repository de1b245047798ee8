/* make_poses - see make_poses.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/make_poses.h"

#include <stdlib.h>

#include "host_tools/app/frame_range.h"
#include "host_tools/base/input.h"
#include "host_tools/base/progress.h"
#include "host_tools/scenes/between.h"

/* Two poses that follow each other; the second is there when it is needed. */
typedef struct poses {
    char *const *path;
    unsigned count, at; /* number of the first */
    mesh pose[2];
} poses;

static int read_pose(const poses *p, mesh *m, unsigned number, fail *f) {
    const mesh *due = number > 0 ? &p->pose[0] : m;
    mesh_report report = {0};
    if (mesh_read(m, p->path[number], 0, &report, f) != 0) {
        return -1;
    }
    const size_t at = between_differs(due, m);
    if (at != SIZE_MAX && (m->vertices != due->vertices || m->triangles != due->triangles)) {
        return fail_set(f, p->path[number],
                        "has %zu vertices and %zu triangles, the pose before %zu and %zu; write "
                        "all poses from one mesh",
                        m->vertices, m->triangles, due->vertices, due->triangles);
    }
    return at == SIZE_MAX
               ? 0
               : fail_set(f, p->path[number],
                          "triangle %zu has other vertices than in the pose before; write all "
                          "poses from one mesh",
                          at);
}

/* Poses `at` and `at` + 1, if there are so many. */
static int go_to(poses *p, unsigned at, fail *f) {
    while (p->at < at) {
        mesh_free(&p->pose[0]);
        p->pose[0] = p->pose[1];
        p->pose[1] = (mesh){.vertices = 0};
        p->at++;
        if (p->at + 1 < p->count && read_pose(p, &p->pose[1], p->at + 1, f) != 0) {
            return -1;
        }
    }
    return 0;
}

static int write_frame(poses *p, const char *pattern, unsigned frame, unsigned frames, fail *f) {
    const unsigned whole = frames - 1, along = frame * (p->count - 1);
    mesh m = {0};
    if (go_to(p, along / whole, f) != 0) {
        return -1;
    }
    const mesh *next = &p->pose[along % whole > 0];
    char *file = frame_range_file(pattern, frame);
    int status = file == NULL ? fail_set(f, pattern, "out of memory; close other programs") : 0;
    status = status == 0 ? between_make(&m, &p->pose[0], next, along % whole, whole, f) : status;
    status = status == 0 ? mesh_write_ply(&m, file, f) : status;
    mesh_free(&m);
    free(file);
    return status;
}

/* Most are read when frames have been written: over none of them. */
static int claim_all(const poses *p, fail *f) {
    int status = 0;
    for (unsigned i = 0; i < p->count && status == 0; i++) {
        status = input_claim(p->path[i], f);
    }
    return status;
}

int make_poses(char *const *path, unsigned count, const char *pattern, unsigned frames, fail *f) {
    poses p = {.path = path, .count = count};
    progress bar;
    int status = claim_all(&p, f);
    status = status == 0 ? read_pose(&p, &p.pose[0], 0, f) : status;
    status = status == 0 ? read_pose(&p, &p.pose[1], 1, f) : status;
    progress_begin(&bar, "making frames", frames);
    for (unsigned i = 0; i < frames && status == 0; i++) {
        status = write_frame(&p, pattern, i, frames, f);
        progress_show(&bar, i + 1);
    }
    progress_end(&bar);
    mesh_free(&p.pose[0]);
    mesh_free(&p.pose[1]);
    return status;
}
