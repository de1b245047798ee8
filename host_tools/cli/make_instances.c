/* make_instances - see make_instances.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/make_instances.h"

#include <stdio.h>
#include <string.h>

#include "host_tools/base/output.h"
#include "host_tools/base/progress.h"
#include "host_tools/scenes/counts.h"
#include "host_tools/scenes/scenes.h"

enum { PATH_ROOM = 4096, ENDING = 4 };

int make_instances_has_name(const char *out) {
    const size_t length = strlen(out);
    return length > ENDING && strcmp(out + length - ENDING, ".txt") == 0 &&
           out[length - ENDING - 1] != '/';
}

/* Behind the folder. */
static const char *name_of(const char *out) {
    const char *slash = strrchr(out, '/');
    return slash != NULL ? slash + 1 : out;
}

int make_instances_can_be_named(const char *out) {
    const char *name = name_of(out);
    return name[0] != '#' && name[strcspn(name, " \t\n\v\f\r")] == '\0';
}

/* "a/marbles.txt" and "ball" to "a/marbles_ball.ply"; -1 when it does not fit. */
static int mesh_path(char to[PATH_ROOM], const char *out, const char *body) {
    const int stem = (int)strlen(out) - ENDING;
    const int n = snprintf(to, PATH_ROOM, "%.*s_%s.ply", stem, out, body);
    return n < 0 || n >= PATH_ROOM ? -1 : 0;
}

static int write_body(const char *out, const char *body, int (*make)(mesh *m, fail *f), fail *f) {
    mesh m = {0};
    char path[PATH_ROOM];
    if (mesh_path(path, out, body) != 0) {
        return fail_set(f, out, "the name is too long; choose a shorter one");
    }
    const int status = make(&m, f) == 0 ? mesh_write_ply(&m, path, f) : -1;
    mesh_free(&m);
    return status;
}

/* Relative to the text, which lies beside it. */
static int print_body(output *o, const char *out, const char *body, fail *f) {
    const char *name = name_of(out);
    return output_print(o, f, "body %s %.*s_%s.ply\n", body, (int)strlen(name) - ENDING, name,
                        body);
}

static int print_instances(output *o, const char *out, unsigned count, fail *f) {
    int status = output_print(o, f, "# marbles that roll in a tray, 25 frames per second\n");
    status = status == 0 ? print_body(o, out, "tray", f) : status;
    status = status == 0 ? print_body(o, out, "ball", f) : status;
    status = status == 0 ? output_print(o, f, "instance tray tray\n") : status;
    for (unsigned i = 1; i < count && status == 0; i++) {
        status = output_print(o, f, "instance ball_%03u ball\n", i);
    }
    return status;
}

static int print_matrix(output *o, const double m[12], fail *f) {
    int status = 0;
    for (unsigned i = 0; i < 12 && status == 0; i++) {
        status = output_print(o, f, "%s%.9g", i % 4 == 0 ? "  " : " ", (double)(float)m[i]);
    }
    return status == 0 ? output_print(o, f, "\n") : status;
}

static int print_frame(output *o, unsigned frame, const double (*matrix)[12], unsigned count,
                       fail *f) {
    int status = 0;
    for (unsigned i = 0; i < count && status == 0; i++) {
        status = i == 0 ? output_print(o, f, "frame %u tray", frame)
                        : output_print(o, f, "frame %u ball_%03u", frame, i);
        if (status == 0) {
            status = print_matrix(o, matrix[i], f);
        }
    }
    return status;
}

static int print_frames(output *o, const char *out, uint64_t triangles, unsigned first,
                        unsigned frames, fail *f) {
    double matrix[SCENE_MARBLES_INSTANCES][12];
    progress bar;
    int status = 0;
    progress_begin(&bar, "making frames", frames);
    for (unsigned k = 0; k < frames && status == 0; k++) {
        const unsigned count = scene_marbles_matrices(triangles, first + k, matrix);
        status = k == 0 ? print_instances(o, out, count, f) : 0;
        if (status == 0) {
            status = print_frame(o, k, (const double(*)[12])matrix, count, f);
        }
        progress_show(&bar, k + 1);
    }
    progress_end(&bar);
    return status;
}

int make_instances(const char *out, uint64_t triangles, unsigned first, unsigned frames, fail *f) {
    const mesh none = {0};
    if (count_check(&none, "tray of marbles", triangles, SCENE_MARBLES_LEAST, SCENE_MARBLES_MOST,
                    f) != 0 ||
        write_body(out, "tray", scene_marbles_tray, f) != 0 ||
        write_body(out, "ball", scene_marbles_ball, f) != 0) {
        return -1;
    }
    output *o = output_open_text(out, f);
    if (o == NULL) {
        return -1;
    }
    if (print_frames(o, out, triangles, first, frames, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}
