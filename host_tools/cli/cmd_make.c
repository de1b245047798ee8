/* cmd_make - planelet make: scenes that need no download
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "host_tools/base/progress.h"
#include "host_tools/cli/commands.h"
#include "host_tools/scenes/scenes.h"

static const arg_flag flags[] = {
    {"-o", "FILE", "the mesh to write, binary PLY; marbles with --frames: a '{}' becomes 000, 001 …"},
    {"--triangles", "N", "terrain, knot: about so many, up to 10000000 (default 100000)"},
    {"--frame", "K", "marbles: the frame to write, 25 a second (default 0)"},
    {"--frames", "N", "marbles: write frames 0 to N - 1"},
    {NULL, NULL, NULL}};

const arg_command command_make = {
    "make",
    "ground|marbles|terrain|knot -o FILE.ply",
    "Writes a mesh that is the same on every machine: ground (12 triangles), marbles rolling\n"
    "in a tray (8,800), a height-field terrain, or a closed knot.",
    flags, 1, 1};

static int make_scene(mesh *m, const char *name, uint64_t triangles, unsigned frame, fail *f) {
    if (strcmp(name, "ground") == 0) {
        return scene_ground(m, f);
    }
    if (strcmp(name, "marbles") == 0) {
        return scene_marbles(m, frame, f);
    }
    return strcmp(name, "terrain") == 0 ? scene_terrain(m, triangles, f)
                                        : scene_knot(m, triangles, f);
}

/* "name_{}.ply" and 7 to "name_007.ply"; -1 when it does not fit. */
static int frame_path(char *to, size_t room, const char *pattern, unsigned frame) {
    const char *at = strstr(pattern, "{}");
    const int n = at == NULL ? snprintf(to, room, "%s", pattern)
                             : snprintf(to, room, "%.*s%03u%s", (int)(at - pattern), pattern,
                                        frame, at + 2);
    return n < 0 || (size_t)n >= room ? -1 : 0;
}

static int write_frame(const char *name, const char *pattern, uint64_t triangles, unsigned frame,
                       fail *f) {
    char path[4096];
    mesh m = {0};
    if (frame_path(path, sizeof path, pattern, frame) != 0) {
        return fail_set(f, pattern, "the name is too long; choose a shorter one");
    }
    const int status = make_scene(&m, name, triangles, frame, f) == 0
                           ? mesh_write_ply(&m, path, f)
                           : -1;
    mesh_free(&m);
    return status;
}

int run_make(args *a) {
    static const char *const names[] = {"ground", "marbles", "terrain", "knot"};
    const char *name = a->file[0];
    const char *out = args_text(a, "-o", NULL);
    const uint64_t triangles = args_number(a, "--triangles", 100000, 2, 10000000);
    const unsigned first = (unsigned)args_number(a, "--frame", 0, 0, 99999);
    const unsigned frames = (unsigned)args_number(a, "--frames", 1, 1, 100000);
    int known = 0;
    for (int i = 0; i < 4; i++) {
        known |= strcmp(name, names[i]) == 0;
    }
    if (!known) {
        args_complain(a, "there is no scene '%s': ground, marbles, terrain or knot", name);
    } else if (out == NULL) {
        args_complain(a, "-o FILE says where the mesh goes");
    } else if (args_has(a, "--frames") && strstr(out, "{}") == NULL) {
        args_complain(a, "--frames needs a '{}' in the file's name, as in marbles_{}.ply");
    } else if ((args_has(a, "--frames") || args_has(a, "--frame")) && strcmp(name, "marbles") != 0) {
        args_complain(a, "only marbles have frames");
    }
    if (a->wrong) {
        return 2;
    }
    fail f = {""};
    progress p;
    progress_begin(&p, "making frames", frames);
    int status = 0;
    for (unsigned i = 0; i < frames && status == 0; i++) {
        status = write_frame(name, out, triangles, first + i, &f);
        progress_show(&p, i + 1);
    }
    progress_end(&p);
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
    }
    return status == 0 ? 0 : 1;
}
