/* cmd_pack - planelet pack: meshes to a scene image
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/note.h"
#include "host_tools/app/phase.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/output.h"
#include "host_tools/cli/commands.h"
#include "host_tools/mesh/mesh.h"
#include "host_tools/mesh/reduce.h"
#include "host_tools/pack/lattice.h"
#include "host_tools/pack/pack.h"

static const arg_flag flags[] = {
    {"-o", "SCENE.plt", "the image to write; - is standard output"},
    {"--build", "host|device|none",
     "who builds the tree: this program, the engine when it opens the image, or nobody "
     "(default host)"},
    {"--splits", "sah|median", "binned SAH, or the thesis's spatial median (default sah)"},
    {"--leaf", "1|2|4", "most triangles per list (default 2)"},
    {"--nodes", "thesis|compact",
     "32 bytes per node, or about 7 in compact blocks on a lattice (default thesis)"},
    {"--treelet", "N", "nodes per treelet, 1 to 1000000 (default 64)"},
    {"--fill", "bfs", "how treelets fill: breadth first"},
    {"--slots", "thesis", "how free slots are reused: exact fit, else the largest"},
    {"--geometry", "float|lattice[:BITS]",
     "float, 40 bytes per triangle, bit exact; compact also: a lattice of 12 to 21 bits per axis "
     "(default lattice:16)"},
    {"--tolerance", "F",
     "compact: the lattice that moves no vertex by more than F times the longest side"},
    {"--numbers", "keep|none",
     "compact: primitive ids are those of the packed meshes, 2 to 3 bytes per triangle, or "
     "positions in the image (default keep)"},
    {"--reduce", "N", "leave at most N triangles, by vertex clustering"},
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
    compact_options compact; /* lattice_bits 0: thesis nodes */
    unsigned frame;
    size_t most;      /* of --reduce; 0: all */
    size_t *mesh_end; /* owned */
    lattice_loss loss;
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
    job->mesh_end = calloc((size_t)a->files, sizeof *job->mesh_end);
    int status = job->mesh_end == NULL ? fail_set(f, a->file[0], "out of memory") : 0;
    for (int i = 0; i < a->files && status == 0; i++) {
        phase_begin("reading", a->file[i]);
        status = mesh_read(&job->m, a->file[i], job->frame, &job->repair, f);
        job->mesh_end[i] = job->m.triangles;
        phase_end();
    }
    job->compact.mesh_end = job->most > 0 ? NULL : job->mesh_end;
    job->compact.meshes = (unsigned)a->files;
    if (status == 0 && job->most > 0) {
        phase_begin("reducing", a->file[0]);
        status = mesh_reduce(&job->m, job->most, a->file[0], f);
        phase_end();
    }
    return status;
}

/* What the lattice cost, and a finer one where triangles were lost. */
static void say_what_was_lost(const pack_job *job, const char *name) {
    const lattice_loss *l = &job->loss;
    fail line = {""};
    fail_set(&line, name,
             "lattice of %u bits: vertices moved by up to %.1e of the longest side, %" PRIu64
             " triangles lost their area (%" PRIu64 " had none), %" PRIu64
             " positions merged, %" PRIu64 " T-junctions (%" PRIu64 " mended)",
             (unsigned)job->compact.lattice_bits, l->largest_move, l->flat_now, l->flat_before,
             l->merged, l->t_junctions, l->mended);
    fprintf(stderr, "%s%s%s\n", line.text,
            job->compact.build == PLT_BUILD_DEVICE ? "; primitive ids are positions in the image"
                                                   : "",
            l->flat_now > 0 && job->compact.lattice_bits < PLT_LATTICE_BITS_MOST
                ? "; try --geometry lattice:21 to keep them"
                : "");
}

static int build(pack_job *job, const char *name, packed *image, fail *f) {
    char what[64];
    snprintf(what, sizeof what, "of %zu triangles", job->m.triangles);
    phase_begin("building the tree", what);
    const int compact = job->compact.lattice_bits > 0;
    const int status = compact ? pack_compact(image, &job->m, &job->compact, name, &job->loss, f)
                               : pack_mesh(image, &job->m, &job->options, name, f);
    phase_end();
    if (status == 0 && compact && !job->compact.floats) {
        say_what_was_lost(job, name);
    }
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

/* The output is opened first: a path that cannot be written fails before the long work. */
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

/* --geometry lattice or lattice:BITS; float is on a lattice of 16 bits. */
static uint8_t read_lattice(args *a, int floats) {
    const char *text = args_text(a, "--geometry", "lattice");
    float tolerance = 0.0f;
    unsigned bits = 16;
    int length = 0;
    if (!floats && strcmp(text, "lattice") != 0 &&
        (sscanf(text, "lattice:%2u%n", &bits, &length) != 1 || text[length] != '\0' ||
         bits < PLT_LATTICE_BITS_LEAST || bits > PLT_LATTICE_BITS_MOST)) {
        args_complain(a, "--geometry is float, lattice, or lattice:12 to lattice:21, not '%s'",
                      text);
        bits = 16;
    }
    if (args_floats(a, "--tolerance", &tolerance, 1)) {
        if (length > 0) {
            args_complain(a, "--tolerance and --geometry %s both choose the lattice; leave one out",
                          text);
        }
        bits = lattice_bits_for((double)tolerance);
        if (bits == 0 || floats) {
            args_complain(a, floats ? "--tolerance is for --geometry lattice"
                                    : "--tolerance below 5.2e-07 is finer than any lattice; use "
                                      "--geometry float");
            bits = 16;
        }
    }
    return (uint8_t)bits;
}

static void read_format(pack_job *job, args *a) {
    static const char *const nodes[] = {"thesis", "compact", NULL};
    static const char *const floats[] = {"float", NULL}, *const numbers[] = {"keep", "none", NULL};
    job->compact.numbers = args_choice(a, "--numbers", numbers, 0) == 0;
    if (args_choice(a, "--nodes", nodes, 0) == 1) {
        job->compact.floats = strcmp(args_text(a, "--geometry", ""), "float") == 0;
        job->compact.lattice_bits = read_lattice(a, job->compact.floats);
        if (job->compact.floats && job->options.build == PLT_BUILD_DEVICE) {
            args_complain(a, "--build device takes --geometry lattice with compact nodes");
        }
        if (job->compact.floats && args_has(a, "--numbers")) {
            args_complain(a, "--numbers is for --geometry lattice; float records hold theirs");
        }
        if (job->options.build == PLT_BUILD_DEVICE && args_has(a, "--numbers") &&
            job->compact.numbers) {
            args_complain(a,
                          "--numbers keep: on a device primitive ids are positions in the image");
        }
        if (job->options.build == PLT_BUILD_NONE || args_has(a, "--treelet")) {
            args_complain(a, "compact nodes come in blocks of 64, built by host or device");
        }
        return;
    }
    args_choice(a, "--geometry", floats, 0);
    if (args_has(a, "--tolerance") || args_has(a, "--numbers")) {
        args_complain(a, "--tolerance and --numbers go with --nodes compact");
    }
}

static void read_flags(pack_job *job, args *a) {
    static const char *const builds[] = {"host", "device", "none", NULL};
    static const char *const splits[] = {"sah", "median", NULL};
    static const char *const leaves[] = {"1", "2", "4", NULL};
    static const char *const thesis[] = {"thesis", NULL}, *const bfs[] = {"bfs", NULL};
    job->options.build = (uint8_t)args_choice(a, "--build", builds, PLT_BUILD_HOST);
    job->options.splits = (uint8_t)args_choice(a, "--splits", splits, PLT_SPLIT_SAH);
    job->options.leaf_triangles = 1u << args_choice(a, "--leaf", leaves, 1);
    job->options.treelet_nodes = (uint32_t)args_number(a, "--treelet", 64, 1, 1000000);
    args_choice(a, "--fill", bfs, 0);
    args_choice(a, "--slots", thesis, 0);
    read_format(job, a);
    job->compact.splits = job->options.splits;
    job->compact.build = job->options.build;
    job->compact.leaf_triangles = job->options.leaf_triangles;
    job->most = (size_t)args_number(a, "--reduce", 0, 1, 1000000000);
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
    const double began = clock_seconds();
    const int status = pack_files(&job, a, &image, &f);
    if (status == 0) {
        say_what_was_dropped(&job.repair, a->files == 1 ? a->file[0] : "all meshes together");
        say_done(&job, &image, clock_seconds() - began);
    } else {
        fprintf(stderr, "%s\n", f.text);
    }
    pack_free(&image);
    mesh_free(&job.m);
    free(job.mesh_end);
    return status == 0 ? 0 : 1;
}
