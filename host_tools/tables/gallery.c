/* gallery - see gallery.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/gallery.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host_tools/app/frame_range.h"
#include "host_tools/scenes/between.h"
#include "host_tools/scenes/scenes.h"
#include "host_tools/tables/twist.h"

enum { PATH_ROOM = 4096 };

typedef struct still {
    const char *file; /* in the folder; NULL: not to be had */
    const char *note; /* NULL: the thesis's own */
} still;

static const still stills[PRINTED_SCENES] = {
    [PRINTED_GROUND] = {NULL, NULL},
    [PRINTED_SHUTTLE] = {"shuttle.ply", NULL},
    [PRINTED_WOODDOLL] = {"wooddoll/wooddoll_000.ply", NULL},
    [PRINTED_MARBLES] = {NULL, NULL},
    [PRINTED_TOASTERS] = {"toasters.ply", NULL},
    [PRINTED_HAND] = {"hand.ply", NULL},
    [PRINTED_BUNNY] = {"bunny.ply", NULL},
    [PRINTED_BEN] = {"ben.ply", NULL},
    [PRINTED_FAIRY] = {"village.txt", "village, frame 0: a diorama with three figures"},
    [PRINTED_DRAGON] = {"dragon.ply", NULL},
    [PRINTED_BUDDHA] = {"statues.ply", "statues: the dragon, a small Buddha and others on a slab"}};

typedef enum way { FRAMES, POSES } way;

typedef struct animation {
    const char *file; /* NULL: not to be had */
    unsigned frames;  /* of the file, or poses */
    way way;
    const char *note; /* NULL: the thesis's own */
} animation;

static const animation animations[PRINTED_ANIMATIONS] = {
    {"wooddoll/wooddoll_{}.ply", 29, FRAMES, NULL},
    {NULL, 500, FRAMES, NULL}, /* made */
    {NULL, 245, FRAMES, NULL},
    {"horse_poses/horse_poses_{}.ply", 11, POSES, "horse_poses: straight ways between 11 poses"},
    {"brainstem/brainstem_{}.ply", 20, FRAMES, "brainstem, 20 frames"},
    {"village.txt", 20, FRAMES, "village, 20 frames"}};

static int path_of(char *to, const gallery *g, const char *file) {
    const int n = snprintf(to, PATH_ROOM, "%s/%s", g->folder, file);
    return n > 0 && n < PATH_ROOM ? 0 : -1;
}

/* Of a pattern its first frame. */
static int is_there(const gallery *g, const char *file) {
    char path[PATH_ROOM];
    if (g->folder == NULL || file == NULL || path_of(path, g, file) != 0) {
        return 0;
    }
    char *first = frame_range_file(path, 0);
    const int there = first != NULL && access(first, F_OK) == 0;
    free(first);
    return there;
}

int gallery_open(gallery *g, const char *folder, fail *f) {
    struct stat about;
    int meshes = 0;
    g->folder = folder;
    if (folder == NULL) {
        return 0;
    }
    if (stat(folder, &about) != 0 || !S_ISDIR(about.st_mode)) {
        return fail_set(f, folder, "there is no such folder; leave out --scenes to make scenes");
    }
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        meshes += is_there(g, stills[i].file);
    }
    return meshes > 0 ? 0
                      : fail_set(f, folder,
                                 "has none of the meshes, such as bunny.ply; choose their folder, "
                                 "or leave out --scenes to make scenes");
}

static int read_file(const gallery *g, const char *file, unsigned frame, mesh *m, fail *f) {
    char path[PATH_ROOM];
    mesh_report report = {0};
    if (path_of(path, g, file) != 0) {
        return fail_set(f, g->folder, "the name is too long; choose a shorter one");
    }
    char *name = frame_range_file(path, frame);
    const int status = name == NULL ? fail_set(f, path, "out of memory; close other programs")
                                    : mesh_read(m, name, frame, &report, f);
    free(name);
    return status;
}

static void say(gallery_about *about, const char *note) {
    about->stands_in = note != NULL;
    snprintf(about->note, sizeof about->note, "%s", note != NULL ? note : "");
}

static int make(unsigned scene, unsigned frame, mesh *m, gallery_about *about, fail *f) {
    const unsigned triangles = printed_scenes[scene].triangles;
    switch (scene) {
    case PRINTED_GROUND:
        say(about, "a slab that planelet makes");
        return scene_ground(m, f);
    case PRINTED_MARBLES:
        say(about, "marbles that planelet makes");
        return scene_marbles(m, triangles, frame, f);
    case PRINTED_TOASTERS:
        say(about, "a terrain that planelet makes");
        return scene_terrain(m, triangles, f);
    case PRINTED_FAIRY:
        say(about, "a room that planelet makes");
        return scene_room(m, triangles, 0, f);
    default:
        say(about, "a knot that planelet makes");
        return scene_knot(m, triangles, f);
    }
}

static int still_or_made(const gallery *g, unsigned scene, unsigned frame, mesh *m,
                         gallery_about *about, fail *f) {
    const still *s = &stills[scene];
    if (!is_there(g, s->file)) {
        return make(scene, frame, m, about, f);
    }
    say(about, s->note);
    return read_file(g, s->file, 0, m, f);
}

static int finish(mesh *m, const char *name, int status, fail *f) {
    if (status == 0 && m->triangles == 0) {
        status = fail_set(f, name, "has no triangles; choose another mesh");
    }
    if (status != 0) {
        mesh_free(m);
        memset(m, 0, sizeof *m);
    }
    return status;
}

int gallery_still(const gallery *g, unsigned scene, mesh *m, gallery_about *about, fail *f) {
    const int status = still_or_made(g, scene, 0, m, about, f);
    return finish(m, printed_scenes[scene].name, status, f);
}

/* Between two of the poses. */
static int read_pose(const gallery *g, const animation *a, unsigned step, unsigned steps, mesh *m,
                     fail *f) {
    const unsigned whole = steps > 1 ? steps - 1 : 1, along = step * (a->frames - 1);
    mesh pose[2] = {{0}, {0}};
    int status = read_file(g, a->file, along / whole, &pose[0], f);
    if (status == 0) {
        status = read_file(g, a->file, along / whole + (along % whole > 0), &pose[1], f);
    }
    if (status == 0 && between_differs(&pose[0], &pose[1]) != SIZE_MAX) {
        status = fail_set(f, a->file, "its poses have other triangles; write them from one mesh");
    }
    if (status == 0) {
        status = between_make(m, &pose[0], &pose[1], along % whole, whole, f);
    }
    mesh_free(&pose[0]);
    mesh_free(&pose[1]);
    return status;
}

static int twist_still(const gallery *g, unsigned scene, unsigned step, unsigned steps, mesh *m,
                       gallery_about *about, fail *f) {
    gallery_about what;
    const int status = still_or_made(g, scene, 0, m, &what, f);
    about->stands_in = 1;
    snprintf(about->note, sizeof about->note, "%.*s, twisted", GALLERY_NOTE - 16,
             what.stands_in ? what.note : "its one frame that is to be had");
    if (status == 0) {
        twist_mesh(m, step, steps);
    }
    return status;
}

int gallery_frame(const gallery *g, unsigned animation_number, unsigned step, unsigned steps,
                  mesh *m, gallery_about *about, fail *f) {
    const animation *a = &animations[animation_number];
    const printed_animation *p = &printed_animations[animation_number];
    const unsigned last = steps > 1 ? steps - 1 : 1;
    const unsigned frame = (step * (a->frames - 1) + last / 2) / last;
    int status;
    if (p->scene == PRINTED_MARBLES) {
        status = make(p->scene, frame, m, about, f);
    } else if (!is_there(g, a->file)) {
        status = twist_still(g, p->scene, step, steps, m, about, f);
    } else {
        say(about, a->note);
        status = a->way == POSES ? read_pose(g, a, step, steps, m, f)
                                 : read_file(g, a->file, frame, m, f);
    }
    return finish(m, p->name, status, f);
}
