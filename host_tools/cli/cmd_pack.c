/* cmd_pack - planelet pack: meshes to a scene image
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/base/output.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/note.h"
#include "host_tools/cli/phase.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/pack/pack.h"

static const arg_flag flags[] = {
    {"-o", "SCENE.plt", "the image to write; - is standard output"},
    {"--build", "host|device|none",
     "who builds the tree: this program, the engine when it opens the image, or nobody "
     "(default host)"},
    {"--splits", "sah|median", "binned SAH, or the thesis's spatial median (default sah)"},
    {"--leaf", "1|2|4", "most triangles a list (default 2)"},
    {"--nodes", "thesis", "the node format: 32 bytes"},
    {"--treelet", "N", "nodes a treelet, 1 to 1000000 (default 64)"},
    {"--fill", "bfs", "how treelets fill: breadth first"},
    {"--slots", "thesis", "how free slots are reused: exact fit, else the largest"},
    {"--geometry", "float", "the geometry format: 40 bytes a triangle, bit exact"},
    {"--frame", "K", "frame of the sequences in a recipe (default 0)"},
    {"--repair", NULL, "drop what cannot be traced and say how much that was"},
    {NULL, NULL, NULL}};

const arg_command command_pack = {
    .name = "pack",
    .synopsis = "MESH... -o SCENE.plt",
    .about =
        "Packs PLY, OBJ and STL meshes and recipes (.txt) into one scene image; triangles are "
        "numbered from 0 in the order in which they are read. MESH may be - for standard input.",
    .flags = flags,
    .files_least = 1,
    .files_most = 100000};

typedef struct pack_job {
    mesh m;
    mesh_repair repair;
    pack_options options;
    unsigned frame;
    const char *out;
} pack_job;

/* One line on standard error, also for scripts: the scene is not the mesh. */
static void say_what_was_dropped(const mesh_repair *r, const char *name) {
    fail line = {""}; /* hides control characters in the name */
    if (r->bad_triangles > 0 || r->bad_vertices > 0) {
        fail_set(&line, name,
                 "dropped %" PRIu64 " triangle%s; %" PRIu64 " vert%s not finite or too large",
                 r->bad_triangles, r->bad_triangles == 1 ? "" : "s", r->bad_vertices,
                 r->bad_vertices == 1 ? "ex was" : "ices were");
        fprintf(stderr, "%s\n", line.text);
    }
}

static int read_meshes(pack_job *job, const args *a, fail *f) {
    int status = 0;
    for (int i = 0; i < a->files && status == 0; i++) {
        phase_begin("reading", a->file[i]);
        status = mesh_read(&job->m, a->file[i], job->frame, &job->repair, f);
        phase_end();
    }
    return status;
}

static int build(const pack_job *job, const char *name, packed *image, fail *f) {
    char what[64];
    snprintf(what, sizeof what, "of %zu triangles", job->m.triangles);
    phase_begin("building the tree", what);
    const int status = pack_mesh(image, &job->m, &job->options, name, f);
    phase_end();
    return status;
}

static int write_image(const pack_job *job, output *o, const packed *image, fail *f) {
    phase_begin("writing", job->out);
    int status = output_write(o, image->bytes, image->size, f);
    if (status == 0) {
        status = output_commit(o, f);
    } else {
        output_abandon(o);
    }
    phase_end();
    return status;
}

/* The output is opened before the long work, so that none is in vain. */
static int pack_files(pack_job *job, const args *a, packed *image, fail *f) {
    output *o = read_meshes(job, a, f) == 0 ? output_open(job->out, f) : NULL;
    if (o == NULL) {
        return -1;
    }
    if (build(job, a->file[0], image, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return write_image(job, o, image, f);
}

static void say_done(const pack_job *job, const packed *image, double seconds) {
    if (strcmp(job->out, "-") != 0) {
        note("%s: %" PRIu32 " triangle%s, %" PRIu32
             " bytes, %.1f s; next: planelet render %s "
             "--show",
             job->out, image->info.triangles, image->info.triangles == 1 ? "" : "s", image->size,
             seconds, job->out);
    }
}

static void read_flags(pack_job *job, args *a) {
    static const char *const builds[] = {"host", "device", "none", NULL};
    static const char *const splits[] = {"sah", "median", NULL};
    static const char *const leaves[] = {"1", "2", "4", NULL};
    static const char *const thesis[] = {"thesis", NULL}, *const bfs[] = {"bfs", NULL},
                             *const floats[] = {"float", NULL};
    job->options.build = (uint8_t)args_choice(a, "--build", builds, PLT_BUILD_HOST);
    job->options.splits = (uint8_t)args_choice(a, "--splits", splits, PLT_SPLIT_SAH);
    job->options.leaf_triangles = 1u << args_choice(a, "--leaf", leaves, 1);
    job->options.treelet_nodes = (uint32_t)args_number(a, "--treelet", 64, 1, 1000000);
    args_choice(a, "--nodes", thesis, 0);
    args_choice(a, "--fill", bfs, 0);
    args_choice(a, "--slots", thesis, 0);
    args_choice(a, "--geometry", floats, 0);
    job->frame = (unsigned)args_number(a, "--frame", 0, 0, 99999);
    job->repair.wanted = args_has(a, "--repair");
    job->out = args_text(a, "-o", NULL);
    if (job->out == NULL) {
        args_complain(a, "-o SCENE.plt says where the image goes");
    }
}

int run_pack(args *a) {
    pack_job job = {0};
    read_flags(&job, a);
    if (a->wrong) {
        return 2;
    }
    fail f = {""};
    packed image = {0};
    const double began = progress_seconds();
    const int status = pack_files(&job, a, &image, &f);
    if (status == 0) {
        say_what_was_dropped(&job.repair, a->files == 1 ? a->file[0] : "all meshes together");
        say_done(&job, &image, progress_seconds() - began);
    } else {
        fprintf(stderr, "%s\n", f.text);
    }
    pack_free(&image);
    mesh_free(&job.m);
    return status == 0 ? 0 : 1;
}
