/* cmd_pack - planelet pack: meshes to a scene image
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "engine/tree/link.h"
#include "host_tools/base/output.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/commands.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/pack/pack.h"

static const arg_flag flags[] = {
    {"-o", "SCENE.plt", "the image to write"},
    {"--build", "host|device|none", "who builds the tree: this program, the engine when it opens\n"
                                    "                               the image, or nobody (default host)"},
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
    "pack",
    "MESH... -o SCENE.plt",
    "Packs PLY, OBJ and STL meshes and recipes (.txt) into one scene image; triangles are\n"
    "numbered from 0 in the order in which they are read.",
    flags, 1, 100000};

typedef struct pack_job {
    mesh m;
    mesh_repair repair;
    pack_options options;
    unsigned frame;
    const char *out;
} pack_job;

static int read_meshes(pack_job *job, const args *a, fail *f) {
    progress p;
    progress_begin(&p, "reading meshes", (uint64_t)a->files);
    int status = 0;
    for (int i = 0; i < a->files && status == 0; i++) {
        status = mesh_read(&job->m, a->file[i], job->frame, &job->repair, f);
        progress_show(&p, (uint64_t)i + 1);
    }
    progress_end(&p);
    return status;
}

static int write_image(const pack_job *job, const char *name, packed *image, fail *f) {
    progress p;
    progress_begin(&p, "building the tree", 0);
    progress_show(&p, 0);
    int status = pack_mesh(image, &job->m, &job->options, name, f);
    progress_end(&p);
    output *o = status == 0 ? output_open(job->out, f) : NULL;
    if (o == NULL) {
        return -1;
    }
    if (output_write(o, image->bytes, image->size, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

static void say_what_was_repaired(const mesh_repair *r) {
    if (r->bad_vertices > 0 || r->bad_triangles > 0) {
        fprintf(stderr, "dropped %llu triangles; %llu vertices were not finite or too large\n",
                (unsigned long long)r->bad_triangles, (unsigned long long)r->bad_vertices);
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
    const int status = read_meshes(&job, a, &f) == 0 ? write_image(&job, a->file[0], &image, &f) : -1;
    if (status == 0) {
        say_what_was_repaired(&job.repair);
    } else {
        fprintf(stderr, "%s\n", f.text);
    }
    pack_free(&image);
    mesh_free(&job.m);
    return status == 0 ? 0 : 1;
}
