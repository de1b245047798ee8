/* cmd_make - planelet make: scenes that need no download
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "host_tools/app/note.h"
#include "host_tools/app/phase.h"
#include "host_tools/app/quote.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/commands.h"
#include "host_tools/scenes/scenes.h"

static const arg_flag flags[] = {
    {"-o", "FILE",
     "the mesh to write, binary PLY; - is standard output; with --frames a '{}' in it becomes "
     "000, 001 ..."},
    {"--triangles", "N",
     "about so many: a terrain has 2 to 10000000, a knot 24 to 10000000 (default 100000)"},
    {"--frame", "K", "marbles: the frame to write, 25 per second; 0 to 99999 (default 0)"},
    {"--frames", "N", "marbles: write N frames, 1 to 100000, from --frame on"},
    {NULL, NULL, NULL}};

const arg_command command_make = {
    .name = "make",
    .synopsis = "ground|marbles|terrain|knot -o FILE.ply",
    .about =
        "Writes a mesh that is the same on every machine: ground (12 triangles), marbles "
        "rolling in a tray (8,800), a height-field terrain, or a closed knot.",
    .flags = flags,
    .files_least = 1,
    .files_most = 1};

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
    const int n = snprintf(to, room, "%.*s%03u%s", (int)(at - pattern), pattern, frame, at + 2);
    return n < 0 || (size_t)n >= room ? -1 : 0;
}

static int write_scene(const char *name, const char *path, uint64_t triangles, unsigned frame,
                       fail *f) {
    mesh m = {0};
    phase_begin("making", path);
    const int status =
        make_scene(&m, name, triangles, frame, f) == 0 ? mesh_write_ply(&m, path, f) : -1;
    phase_end();
    mesh_free(&m);
    return status;
}

static int write_frames(const char *name, const char *pattern, unsigned first, unsigned frames,
                        fail *f) {
    char path[4096];
    progress p;
    int status = 0;
    progress_begin(&p, "making frames", frames);
    for (unsigned i = 0; i < frames && status == 0; i++) {
        status = frame_path(path, sizeof path, pattern, first + i) == 0
                     ? write_scene(name, path, 0, first + i, f)
                     : fail_set(f, pattern, "the name is too long; choose a shorter one");
        progress_show(&p, i + 1);
    }
    progress_end(&p);
    return status;
}

static int is_scene(const char *name) {
    return strcmp(name, "ground") == 0 || strcmp(name, "marbles") == 0 ||
           strcmp(name, "terrain") == 0 || strcmp(name, "knot") == 0;
}

static void check_usage(args *a, const char *name, const char *out) {
    const int has_frames = args_has(a, "--frames");
    const int marbles = strcmp(name, "marbles") == 0, ground = strcmp(name, "ground") == 0;
    if (!is_scene(name)) {
        args_complain(a, "there is no scene '%s': ground, marbles, terrain or knot", name);
    } else if (out == NULL) {
        args_complain(a, "-o FILE says where the mesh goes");
    } else if (has_frames && strstr(out, "{}") == NULL) {
        args_complain(a, "--frames needs a '{}' in the file's name, as in marbles_{}.ply");
    } else if (!marbles && (has_frames || args_has(a, "--frame"))) {
        args_complain(a, "only marbles have frames");
    } else if ((marbles || ground) && args_has(a, "--triangles")) {
        args_complain(a, "%s has the triangles it has: no --triangles", name);
    }
}

int run_make(args *a) {
    const char *name = a->file[0], *out = args_text(a, "-o", NULL);
    const uint64_t triangles = args_number(a, "--triangles", 100000, 2, 10000000);
    const unsigned first = (unsigned)args_number(a, "--frame", 0, 0, 99999);
    const unsigned frames = (unsigned)args_number(a, "--frames", 1, 1, 100000);
    if (!a->wrong) {
        check_usage(a, name, out);
    }
    if (a->wrong) {
        return 2;
    }
    fail f = {""};
    const int many = args_has(a, "--frames");
    const int status = many ? write_frames(name, out, first, frames, &f)
                            : write_scene(name, out, triangles, first, &f);
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    char word[QUOTE_ROOM];
    if (!many && strcmp(out, "-") != 0 && quote_word(word, sizeof word, out) != NULL) {
        note("next: planelet pack %s -o %s.plt", word, name);
    }
    return 0;
}
