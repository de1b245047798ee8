/* cmd_make - planelet make: scenes that need no download
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/frame_range.h"
#include "host_tools/app/note.h"
#include "host_tools/app/phase.h"
#include "host_tools/app/quote.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/make_instances.h"
#include "host_tools/cli/make_materials.h"
#include "host_tools/cli/make_poses.h"
#include "host_tools/scenes/scenes.h"
#include "host_tools/scenes/still.h"

static const arg_flag flags[] = {
    {"-o", "FILE",
     "the mesh to write, binary PLY; - is standard output; with --frames a '{}' in it becomes "
     "000, 001 ...; marbles as FILE.obj are finer, and of glass, metal and paint in a wooden tray, "
     "as FILE.mtl says"},
    {"--triangles", "N",
     "about so many: a terrain has 2 to 10000000, a knot 24 to 10000000, a room 24000 to "
     "10000000 (default 100000); marbles 160 to 8800, 80 each and the tray (default 8800); of "
     "FILE.obj four times as many"},
    {"--seed", "N",
     "room: which one; books, chairs, leaves and balls are elsewhere; 0 to 999999 (default 0)"},
    {"--frame", "K",
     "marbles, city, mesh: the frame to write, of the first two 25 per second; 0 to 99999 (default "
     "0)"},
    {"--frames", "N",
     "marbles, city, mesh: write N frames, 1 to 100000, from --frame on; poses: 2 to 1000"},
    {"--instances", NULL,
     "marbles: FILE.txt says where instances of the tray and of a ball are in each frame, for "
     "planelet pack --instances; their meshes, FILE_tray.ply and FILE_ball.ply, lie beside it"},
    {NULL, NULL, NULL}};

const arg_command command_make = {
    .name = "make",
    .synopsis = "ground|marbles|city|terrain|knot|room|mesh|poses [MESH...] -o FILE",
    .about =
        "Writes a mesh that is the same on every machine: ground (12 triangles), marbles "
        "rolling in a tray (8,800), people who leave a lift for all parts of a city (44,844), a "
        "height-field terrain, a closed knot, or a closed room with furniture. mesh MESH writes a "
        "mesh of any format, or what a recipe is made of. poses MESH MESH... "
        "--frames N writes one mesh on its straight ways from pose to pose, N frames that are "
        "evenly spread from the first to the last; all MESHes have the same triangles.",
    .flags = flags,
    .files_least = 1,
    .files_most = 1001};

enum { POSES_MOST = 1000, POSES_FRAMES_MOST = 1000 };

/* What is made: its name, and the numbers that some of the scenes take. */
typedef struct make_order {
    const char *name;
    const char *mesh; /* what a mesh is made of; NULL: nothing */
    uint64_t triangles;
    uint32_t seed;
    unsigned frame;
    int has_frames; /* more than one is asked for, or a later one */
} make_order;

static int read_mesh(mesh *m, const make_order *o, fail *f) {
    char *name = frame_range_file(o->mesh, o->frame);
    mesh_report report = {0};
    int status = name == NULL ? fail_set(f, o->mesh, "out of memory; close other programs")
                              : mesh_read(m, name, o->frame, &report, f);
    if (status == 0 && o->has_frames && report.sequences == 0 && strcmp(name, o->mesh) == 0) {
        status = fail_set(f, name,
                          "has no sequence, so no frames; leave out --frame(s), or name files "
                          "with a '{}'");
    }
    free(name);
    return status;
}

static int make_scene(mesh *m, const make_order *o, fail *f) {
    if (strcmp(o->name, "mesh") == 0) {
        return read_mesh(m, o, f);
    }
    if (strcmp(o->name, "ground") == 0) {
        return scene_ground(m, f);
    }
    if (strcmp(o->name, "marbles") == 0) {
        return scene_marbles(m, o->triangles, o->frame, f);
    }
    if (strcmp(o->name, "city") == 0) {
        return scene_city(m, o->frame, f);
    }
    if (strcmp(o->name, "room") == 0) {
        return scene_room(m, o->triangles, o->seed, f);
    }
    return strcmp(o->name, "terrain") == 0 ? scene_terrain(m, o->triangles, f)
                                           : scene_knot(m, o->triangles, f);
}

/* "name_{}.ply" and 7 to "name_007.ply"; -1 when it does not fit. */
static int frame_path(char *to, size_t room, const char *pattern, unsigned frame) {
    const char *at = strstr(pattern, "{}");
    const int n = snprintf(to, room, "%.*s%03u%s", (int)(at - pattern), pattern, frame, at + 2);
    return n < 0 || (size_t)n >= room ? -1 : 0;
}

/* Marbles in a file of OBJ are of glass, metal and paint. */
static int has_materials(const char *name, const char *path) {
    return strcmp(name, "marbles") == 0 && make_materials_has_name(path);
}

static int write_still(const make_order *o, const char *path, fail *f) {
    painted p = {.paint = NULL};
    const int status = still_marbles(&p, o->triangles, o->frame, f) || make_materials(&p, path, f);
    painted_free(&p);
    return status ? -1 : 0;
}

static int write_plain(const make_order *o, const char *path, fail *f) {
    mesh m = {0};
    const int status = make_scene(&m, o, f) || mesh_write_ply(&m, path, f);
    mesh_free(&m);
    return status ? -1 : 0;
}

static int write_scene(const make_order *o, const char *path, fail *f) {
    phase_begin("making", path);
    const int status =
        has_materials(o->name, path) ? write_still(o, path, f) : write_plain(o, path, f);
    phase_end();
    return status;
}

/* Before any is written, so that none is that is still to be read (base/files.h). */
static int read_all(make_order o, unsigned frames, fail *f) {
    const unsigned first = o.frame;
    progress p;
    int status = 0;
    progress_begin(&p, "reading frames", frames);
    for (unsigned i = 0; i < frames && status == 0; i++) {
        mesh m = {0};
        o.frame = first + i;
        status = read_mesh(&m, &o, f);
        mesh_free(&m);
        progress_show(&p, i + 1);
    }
    progress_end(&p);
    return status;
}

static int write_frames(make_order o, const char *pattern, unsigned frames, fail *f) {
    const unsigned first = o.frame;
    char path[4096];
    progress p;
    int status = strcmp(o.name, "mesh") == 0 ? read_all(o, frames, f) : 0;
    progress_begin(&p, "making frames", frames);
    for (unsigned i = 0; i < frames && status == 0; i++) {
        o.frame = first + i;
        status = frame_path(path, sizeof path, pattern, o.frame) == 0
                     ? write_scene(&o, path, f)
                     : fail_set(f, pattern, "the name is too long; choose a shorter one");
        progress_show(&p, i + 1);
    }
    progress_end(&p);
    return status;
}

/* It has frames. */
static int moves(const char *name) {
    return strcmp(name, "marbles") == 0 || strcmp(name, "city") == 0 || strcmp(name, "mesh") == 0;
}

static int is_scene(const char *name) {
    return strcmp(name, "ground") == 0 || moves(name) || strcmp(name, "terrain") == 0 ||
           strcmp(name, "knot") == 0 || strcmp(name, "room") == 0;
}

static int is_mesh(const char *name) {
    return strcmp(name, "mesh") == 0;
}

static int are_poses(const char *name) {
    return strcmp(name, "poses") == 0;
}

/* What a scene of its own needs is complained about by check_usage. */
static void check_poses(args *a, unsigned frames) {
    if (args_has(a, "--frame") || args_has(a, "--seed") || args_has(a, "--triangles")) {
        args_complain(a, "poses take --frames N, and neither --frame, --seed nor --triangles");
    } else if (a->files < 3 || a->files > POSES_MOST + 1) {
        args_complain(a, "poses are 2 to %d MESHes of the same triangles", POSES_MOST);
    } else if (frames < 2 || frames > POSES_FRAMES_MOST) {
        args_complain(a, "poses take --frames N, 2 to %d", POSES_FRAMES_MOST);
    }
}

static void check_usage(args *a, const char *name, const char *out) {
    const int has_frames = args_has(a, "--frames");
    const int is_fixed = strcmp(name, "city") == 0 || strcmp(name, "ground") == 0 || is_mesh(name);
    if (!is_scene(name) && !are_poses(name)) {
        args_complain(
            a, "there is no scene '%s': ground, marbles, city, terrain, knot, room, mesh or poses",
            name);
    } else if (is_mesh(name) && a->files != 2) {
        args_complain(a, "a mesh is made of one MESH: planelet make mesh MESH -o FILE.ply");
    } else if (is_scene(name) && !is_mesh(name) && a->files > 1) {
        args_complain(a, "only mesh and poses are made of meshes; leave out '%s'", a->file[1]);
    } else if (out == NULL) {
        args_complain(a, "-o FILE says where the mesh goes");
    } else if (args_has(a, "--instances") && strcmp(name, "marbles") != 0) {
        args_complain(a, "only marbles are made as --instances");
    } else if (args_has(a, "--instances") && !make_instances_has_name(out)) {
        args_complain(a, "--instances needs a name that ends in .txt, as in marbles.txt");
    } else if (args_has(a, "--instances") && !make_instances_can_be_named(out)) {
        args_complain(a,
                      "the text of --instances names meshes after itself: no blanks in its "
                      "name, nor # first, as in marbles.txt");
    } else if (has_frames && !args_has(a, "--instances") && strstr(out, "{}") == NULL) {
        args_complain(a, "--frames needs a '{}' in the file's name, as in marbles_{}.ply");
    } else if (is_scene(name) && !moves(name) && (has_frames || args_has(a, "--frame"))) {
        args_complain(a, "only marbles, a city and a mesh have frames");
    } else if (is_scene(name) && strcmp(name, "room") != 0 && args_has(a, "--seed")) {
        args_complain(a, "only a room has a seed");
    } else if (is_fixed && args_has(a, "--triangles")) {
        args_complain(a, "%s has the triangles it has: no --triangles", name);
    }
}

/* What to do with it; a room is looked at from inside. */
static void say_next(const char *name, const char *out, int are_instances) {
    char word[QUOTE_ROOM];
    if (strcmp(out, "-") == 0 || quote_word(word, sizeof word, out) == NULL) {
        return;
    }
    if (are_instances) {
        note("next: planelet pack --instances %s -o %s.plt", word, name);
    } else if (has_materials(name, out)) {
        note("next: planelet pack --materials keep --smooth 40 %s -o %s.plt", word, name);
    } else {
        note("next: planelet pack %s -o %s.plt", word, name);
    }
    if (strcmp(name, "room") == 0) {
        note("then, from inside: planelet render room.plt --show %s", SCENE_ROOM_VIEW);
    }
}

static int write_poses(const args *a, const char *out, unsigned frames, fail *f) {
    return make_poses(a->file + 1, (unsigned)a->files - 1, out, frames, f);
}

int run_make(args *a) {
    const char *out = args_text(a, "-o", NULL);
    const unsigned most = strcmp(a->file[0], "marbles") == 0 ? SCENE_MARBLES_MOST : 100000;
    const unsigned frames = (unsigned)args_number(a, "--frames", 1, 1, 100000);
    const make_order order = {.name = a->file[0],
                              .mesh = a->files > 1 ? a->file[1] : NULL,
                              .triangles = args_number(a, "--triangles", most, 2, 10000000),
                              .seed = (uint32_t)args_number(a, "--seed", 0, 0, 999999),
                              .frame = (unsigned)args_number(a, "--frame", 0, 0, 99999),
                              .has_frames =
                                  frames > 1 || args_number(a, "--frame", 0, 0, 99999) > 0};
    if (!a->wrong) {
        check_usage(a, order.name, out);
        if (are_poses(order.name) && !a->wrong) {
            check_poses(a, frames);
        }
    }
    if (a->wrong) {
        return 2;
    }
    fail f = {""};
    const int many = args_has(a, "--frames"), are_instances = args_has(a, "--instances");
    const int status = are_poses(order.name) ? write_poses(a, out, frames, &f)
                       : are_instances
                           ? make_instances(out, order.triangles, order.frame, frames, &f)
                       : many ? write_frames(order, out, frames, &f)
                              : write_scene(&order, out, &f);
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    if (are_instances || !many) {
        say_next(order.name, out, are_instances);
    }
    return 0;
}
