/* cmd_pack - planelet pack: meshes to a scene image
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/command_line.h"
#include "host_tools/app/destination.h"
#include "host_tools/app/note.h"
#include "host_tools/app/phase.h"
#include "host_tools/app/quote.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/heap.h"
#include "host_tools/base/output.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/pack_frames.h"
#include "host_tools/cli/pack_instances.h"
#include "host_tools/cli/pack_json.h"
#include "host_tools/cli/pack_lines.h"
#include "host_tools/cli/pack_materials.h"
#include "host_tools/cli/pack_memory.h"
#include "host_tools/cli/pack_meshes.h"
#include "host_tools/cli/pack_surface.h"
#include "host_tools/pack/c_array.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/lattice.h"
#include "host_tools/pack/pack.h"
#include "host_tools/pack/shift.h"

static const arg_flag flags[] = {
    {"-o", "SCENE.plt",
     "the image to write; - is standard output; SCENE.h or SCENE.c is a C array of it for a "
     "firmware"},
    {"--build", "host|device|none",
     "who builds the tree: this program, the engine when it opens the image, or nobody "
     "(default host)"},
    {"--splits", "sah|median", "binned SAH, or the thesis's spatial median (default sah)"},
    {"--quality", "fast|high",
     "high: nodes of --build host are moved to where the boxes are smallest, which takes "
     "four times as long and more, and gives up to a third fewer visits where triangles differ "
     "in size; where many overlap, twice the triangles take four times as long (default fast)"},
    {"--quality-time", "N", "of --quality high: stop after N seconds, 1 to 86400"},
    {"--leaf", "1|2|4", "most triangles per list (default 2)"},
    {"--nodes", "thesis|compact",
     "32 bytes per node, or about 7 in compact blocks on a lattice (default thesis)"},
    {"--treelet", "N|auto",
     "nodes per treelet, 1 to 1000000, or those of 8, 16 .. 256 for which rays have least to do "
     "(default 64)"},
    {"--fill", "bfs|area|full",
     "which nodes treelets take: breadth first; those with the largest boxes; or so that most "
     "treelets are complete and are entered seldom, of at most 10000 nodes (default bfs)"},
    {"--slots", "thesis|newest|none",
     "where incomplete treelets go: where they fit exactly, else where most is free; into the "
     "newest block with room, near what leads to them; or into blocks of their own (default "
     "thesis)"},
    {"--geometry", "float|lattice[:BITS]",
     "float, 40 bytes per triangle, bit exact; compact and --sequence also: a lattice of 12 to 21 "
     "bits per axis (default lattice:16)"},
    {"--tolerance", "F",
     "compact: the lattice that moves no vertex by more than F times the longest side, 5.2e-7 and "
     "more"},
    {"--step", "auto|power",
     "compact: the lattice's step is a power of two where that keeps every corner exactly where "
     "it is, or always: costs up to one bit, and corners that are multiples of it stay exact "
     "(default auto)"},
    {"--checks", "on|off",
     "for streaming: what is fetched part by part has checks of its own, a third of a byte per "
     "triangle of thesis nodes, a seventieth of compact ones (default on)"},
    {"--numbers", "keep|none",
     "compact: primitive ids are those of the packed meshes, 2 to 3 bytes per triangle, or "
     "positions in the image (default keep)"},
    {"--reduce", "N", "leave at most N triangles, 1 to 1000000000, by vertex clustering"},
    {"--frame", "K", "frame of the sequences in a recipe, 0 to 99999 (default 0)"},
    PACK_FRAMES_FLAGS,
    PACK_INSTANCES_FLAG,
    {"--centre", NULL,
     "move the middle of the meshes to 0, in double precision, before they are narrowed to "
     "single: for coordinates far from the origin; planelet info prints the shift"},
    {"--origin", "X,Y,Z", "move the meshes so that this point becomes 0, likewise"},
    PACK_SURFACE_FLAGS,
    PACK_MATERIALS_FLAGS,
    {"--weld", "EPS", "make vertices of a file that are as near as EPS one, to close seams"},
    {"--repair", NULL, "drop what cannot be traced and say how much that was"},
    {"--memory", "BYTES",
     "take no more memory than that for meshes and image, 1048576 to 1125899906842624: the image "
     "is the same, or nothing is packed; --json says what it takes (default: any)"},
    {"--json", "STATS", "write what was read, lost and packed to this file; - is standard output"},
    {NULL, NULL, NULL}};

_Static_assert(sizeof flags / sizeof flags[0] <= ARGS_FLAGS_MAX,
               "each flag has room for its value");

const arg_command command_pack = {
    .name = "pack",
    .synopsis = "MESH... -o SCENE.plt",
    .about =
        "Packs PLY, OBJ and STL meshes and recipes (.txt) into one scene image; triangles are "
        "numbered from 0 in the order in which they are read. MESH may be - for standard input.",
    .flags = flags,
    .files_least = 1,
    .files_most = 100000,
    .notes =
        "A recipe (.txt) has a mesh per line, and comments:\n"
        "\n"
        "  # FILE SIZE X Y Z [ANGLE_X ANGLE_Y]\n"
        "  floor.ply    20  0 0 0\n"
        "  knot.ply      4  0 0 -3  90 45   # a quarter about x, half of one about y\n"
        "  walk_{}.ply*3+1  2.5  4 0 2      # one of walk_000.ply to walk_002.ply\n"
        "\n"
        "FILE is relative to the recipe and has no blanks. The mesh is rotated about x by\n"
        "ANGLE_X degrees, then about y by ANGLE_Y (default 0 0), and scaled until the\n"
        "longest side of its box is SIZE; the middle of the box's base, its side of least\n"
        "y, goes to X Y Z. NAME_{}.ply*N+START is a sequence of N files with numbers from\n"
        "000 on, of which --frame K takes number (K + START) modulo N; +START may be\n"
        "left out.\n"
        "\n"
        "With --instances a text says which meshes are bodies, each with a tree of its\n"
        "own, and where instances of them are, frame by frame:\n"
        "\n"
        "  body wheel wheel.ply\n"
        "  instance left wheel\n"
        "  frame 0 left   1 0 0 -2   0 1 0 0   0 0 1 0\n"
        "  frame 1 left   0 -1 0 -2  1 0 0 0   0 0 1 0   # a quarter about z\n"
        "\n"
        "The 12 numbers are the rows of a matrix: x' = 1 x + 0 y + 0 z - 2, and so on; it\n"
        "may turn, move, scale and mirror. Frames count from 0 without gaps; an instance\n"
        "that one does not name stays where it was. Triangles are numbered instance by\n"
        "instance.\n"};

typedef struct pack_job {
    pack_meshes in;
    pack_frames frames; /* --sequence */
    pack_instances_order instances;
    pack_surface surface;
    pack_materials materials;
    pack_options options;
    compact_options compact; /* lattice_bits 0: thesis nodes */
    lattice_loss loss;
    int is_high;              /* --quality */
    uint32_t quality_seconds; /* 0: no limit */
    quality_stats quality;
    pack_memory memory;
    const char *out, *json; /* `json` NULL: none */
    output *image_out, *json_out;
    char *command; /* owned; for a C array */
} pack_job;

/* With floats only boxes are on the lattice. */
static int moves_vertices(const pack_job *job) {
    return job->compact.lattice_bits > 0 && !job->compact.floats && !job->frames.wanted;
}

static const char *s(uint64_t count) {
    return count == 1 ? "" : "s";
}

/* What the lattice cost, and a finer one where triangles were lost. */
static void say_what_was_lost(const pack_job *job, const packed *image) {
    const lattice_loss *l = &job->loss;
    fail line = {""};
    fail_set(&line, pack_shown(&job->in.file[0]),
             "lattice of %u bits: vertices moved by up to %.2g of the longest side, %" PRIu64
             " triangle%s lost %s area (%" PRIu64 " had none), %" PRIu64
             " position%s merged, %" PRIu64 " T-junction%s (%" PRIu64
             " mended); step %.9g, %" PRIu64 " of %" PRIu64
             " vertices stayed exactly where they were%s",
             (unsigned)l->bits, l->largest_move, l->flat_now, s(l->flat_now),
             l->flat_now == 1 ? "its" : "their", l->flat_before, l->merged, s(l->merged),
             l->t_junctions, s(l->t_junctions), l->mended, (double)l->step, l->unmoved, l->vertices,
             image->info.triangles == 0 ? "; nothing is left to trace" : "");
    fprintf(stderr, "%s%s%s\n", line.text,
            job->compact.build == PLT_BUILD_DEVICE ? "; primitive ids are positions in the image"
                                                   : "",
            l->flat_now > 0 && l->bits < PLT_LATTICE_BITS_MOST
                ? "; --geometry lattice:21 keeps more of them, --geometry float all"
                : "");
}

/* With a lattice its own line says it. */
static void say_what_is_never_hit(const pack_meshes *in) {
    for (int i = 0; i < in->files; i++) {
        const uint64_t count = in->file[i].without_area;
        fail line = {""};
        if (count > 0) {
            fail_set(&line, pack_shown(&in->file[i]),
                     "%" PRIu64 " triangle%s no area: never hit, but counted and numbered", count,
                     count == 1 ? " has" : "s have");
            fprintf(stderr, "%s\n", line.text);
        }
    }
}

static int build(pack_job *job, packed *image, fail *f) {
    const char *name = pack_shown(&job->in.file[0]);
    char what[64];
    snprintf(what, sizeof what, "of %zu triangles", job->in.triangles);
    phase_begin("building the tree", what);
    const int compact = job->compact.lattice_bits > 0;
    const mesh *m = &job->in.m;
    int status;
    if (compact) {
        status = pack_compact(image, m, &job->compact, name, &job->loss, f);
    } else if (job->is_high) {
        status =
            pack_mesh_better(image, m, &job->options, job->quality_seconds, &job->quality, name, f);
    } else {
        status = pack_mesh(image, m, &job->options, name, f);
    }
    phase_end();
    if (status == 0 && job->frames.wanted) {
        status = pack_frames_add(&job->frames, &job->in, image, f);
    }
    if (status == 0) {
        shift_write(image->bytes, job->in.shift);
    }
    return status;
}

static int write_all(pack_job *job, const packed *image, fail *f) {
    phase_begin("writing", job->out);
    int status = c_array_wanted(job->out)
                     ? c_array_write(job->image_out, job->out, image, job->command, f)
                     : output_write(job->image_out, image->bytes, image->size, f);
    if (job->frames.wanted && heap_peak() > job->memory.needed) {
        job->memory.needed = heap_peak(); /* frames are not in the plan: what they took */
    }
    if (status == 0 && job->json_out != NULL) {
        status =
            pack_json_write(job->json_out, &job->in, image, moves_vertices(job) ? &job->loss : NULL,
                            &job->quality, &job->surface.stats, &job->memory, f);
    }
    if (status == 0 && job->json_out != NULL) {
        status = output_finish(job->json_out, f); /* before the other gets its name */
    }
    if (status == 0) {
        status = output_commit(job->image_out, f);
        job->image_out = NULL;
    }
    if (status == 0 && job->json_out != NULL) {
        status = output_commit(job->json_out, f);
        job->json_out = NULL;
    }
    phase_end();
    return status;
}

/* The outputs are opened first: a path that cannot be written fails before the long work. */
static int open_outputs(pack_job *job, fail *f) {
    job->image_out = output_open(job->out, f);
    if (job->image_out != NULL && job->json != NULL) {
        job->json_out = output_open_text(job->json, f);
        return job->json_out != NULL ? 0 : -1;
    }
    return job->image_out != NULL ? 0 : -1;
}

/* Before any long work: --reduce leaves so many, and may leave fewer. */
static int check_size(const pack_job *job, fail *f) {
    const pack_meshes *in = &job->in;
    const char *name = pack_shown(&in->file[0]);
    if (in->most > 0 && in->m.triangles > in->most) {
        return 0;
    }
    return job->compact.lattice_bits > 0
               ? image_size_check_compact(name, in->m.triangles, &job->compact, f)
               : image_size_check_thesis(name, in->m.triangles, &job->options, f);
}

static int read_meshes(pack_job *job, const args *a, fail *f) {
    fail why = {""};
    if (!job->frames.wanted) {
        return pack_meshes_read(&job->in, a->file, a->files, f);
    }
    job->in.frame = job->frames.range.first;
    if (pack_meshes_read(&job->in, &job->frames.first, 1, &why) != 0) {
        char name[24];
        snprintf(name, sizeof name, "frame %u", job->in.frame);
        return fail_set(f, name, "%s", why.text); /* which names the file */
    }
    return 0;
}

static int pack_files(pack_job *job, const args *a, packed *image, fail *f) {
    job->in.m.corners = pack_surface_wanted(&job->surface) ? &job->surface.corners : NULL;
    job->in.m.materials = job->materials.wanted ? &job->materials.materials : NULL;
    if (read_meshes(job, a, f) != 0 || pack_materials_check(&job->materials, &job->in, f) != 0) {
        return -1;
    }
    pack_textures_settle(&job->materials.textures, &job->surface.corners,
                         pack_shown(&job->in.file[0]));
    const pack_plan plan = {&job->options, &job->compact, job->is_high};
    job->options.spend = job->compact.spend = job->frames.wanted ? NULL : &job->in.m;
    job->compact.meshes = (unsigned)a->files;
    if (check_size(job, f) != 0 || pack_memory_plan(&job->memory, &job->in, &plan, f) != 0) {
        return -1;
    }
    pack_memory_note(&job->memory, pack_shown(&job->in.file[0]));
    if (pack_meshes_prepare(&job->in, f) != 0 ||
        pack_surface_prepare(&job->surface, &job->in, f) != 0) {
        return -1;
    }
    job->compact.mesh_end = job->in.mesh_end;
    if (job->frames.wanted) {
        job->in.file[0].open_distance = 0; /* seams are not closed in a sequence */
    }
    if (open_outputs(job, f) != 0 ||
        (job->frames.wanted && pack_frames_scan(&job->frames, &job->in, f) != 0) ||
        build(job, image, f) != 0 || pack_surface_add(&job->surface, &job->in, image, f) != 0 ||
        pack_materials_add(&job->materials, &job->in, image, f) != 0) {
        return -1;
    }
    return write_all(job, image, f);
}

/* --instances. */
static int pack_instances_file(pack_job *job, const char *path, packed *image, fail *f) {
    job->instances.is_high = job->is_high;
    job->instances.quality_seconds = job->quality_seconds;
    job->instances.repair = job->in.repair;
    job->instances.weld = job->in.weld;
    if (open_outputs(job, f) != 0 ||
        pack_instances(image, path, &job->instances, &job->options, f) != 0) {
        return -1;
    }
    return write_all(job, image, f);
}

/* What the picture will lack, for scripts as well. */
static void say_losses(const pack_job *job, const packed *image) {
    pack_meshes_say(&job->in);
    if (moves_vertices(job)) {
        say_what_was_lost(job, image);
    } else {
        say_what_is_never_hit(&job->in);
    }
}

/* Of those that are formed here, and what else was tried. */
static void say_treelets(const pack_treelets_stats *t) {
    const pack_treelet_score *s = &t->of[t->best];
    if (t->tried == 0) {
        return;
    }
    note("treelets of %" PRIu32 ", of %" PRIu32 " size%s tried: %" PRIu32 " complete, %" PRIu32
         " incomplete, %" PRIu64 " free slot%s, %.2f entered by a random line",
         s->size, t->tried, t->tried == 1 ? "" : "s", s->complete, s->treelets - s->complete,
         s->free_slots, s->free_slots == 1 ? "" : "s", s->entered);
}

static void say_quality(const quality_stats *q) {
    if (q->passes > 0) {
        char frames[40] = "";
        if (q->frames > 1) {
            snprintf(frames, sizeof frames, " in each of %" PRIu32 " frames", q->frames);
        }
        note("tree: a random line meets %.2f of its boxes%s, before %.2f; %" PRIu32
             " nodes moved, %.1f s%s",
             q->after, frames, q->before, q->moves, q->seconds,
             q->out_of_time ? " and out of time" : "");
    }
}

static void say_done(const pack_job *job, const packed *image, double seconds) {
    char word[QUOTE_ROOM];
    if (c_array_wanted(job->out)) {
        note("%s: %" PRIu32 " triangle%s, %" PRIu32
             " bytes, %.1f s; next: compile it, its head says how to use it",
             job->out, image->info.triangles, image->info.triangles == 1 ? "" : "s", image->size,
             seconds);
        return;
    }
    if (strcmp(job->out, "-") != 0) {
        const int hint = quote_word(word, sizeof word, job->out) != NULL;
        note("%s: %" PRIu32 " triangle%s, %" PRIu32 " bytes, %.1f s%s%s%s", job->out,
             image->info.triangles, image->info.triangles == 1 ? "" : "s", image->size, seconds,
             hint ? "; next: planelet render " : "", hint ? word : "", hint ? " --show" : "");
    }
}

/* --geometry lattice or lattice:BITS; float is on a lattice of 16 bits. */
static uint8_t read_lattice(pack_job *job, args *a, int floats) {
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
        job->compact.tolerance = (double)tolerance;
        if (bits == 0 || floats) {
            args_complain(a, floats ? "--tolerance is for --geometry lattice"
                                    : "--tolerance below 5.2e-07 is finer than any lattice; use "
                                      "--geometry float");
            bits = 16;
        }
    }
    return (uint8_t)bits;
}

static void read_checks(pack_job *job, args *a) {
    static const char *const checks[] = {"on", "off", NULL};
    const int differs = job->frames.wanted && !job->frames.options.stills;
    const int moves = differs || job->instances.wanted;
    const int are_on = args_choice(a, "--checks", checks, moves ? 1 : 0) == 0;
    job->options.checks = job->compact.checks = (uint8_t)are_on;
    if (are_on && args_has(a, "--checks") && job->options.build != PLT_BUILD_HOST) {
        args_complain(a, "--checks on is for --build host: only finished trees are streamed");
    }
    if (are_on && differs) {
        args_complain(a, "--checks on is for a --sequence of --stills: no others are streamed");
    }
}

/* Of compact blocks: they have room for all frames, on the frames' lattice. */
static void read_compact_sequence(pack_job *job, args *a, int floats, uint8_t bits) {
    job->compact.lattice_bits = bits;
    job->compact.moving = &job->frames.code.moving;
    if (floats || job->options.build != PLT_BUILD_HOST || args_has(a, "--treelet")) {
        args_complain(a,
                      "--sequence with --nodes compact takes --geometry lattice and --build "
                      "host, and its blocks are of 64 nodes");
    }
    if (job->frames.for_all) {
        args_complain(a, "--tree-for all takes --nodes thesis");
    }
    if (args_has(a, "--stills") && args_has(a, "--key")) {
        args_complain(a, "--stills has no --key: no frame depends on others");
    }
}

/* --geometry of a sequence: its lattice, or none. */
static void read_sequence_format(pack_job *job, args *a) {
    const int floats = strcmp(args_text(a, "--geometry", ""), "float") == 0;
    const uint8_t bits = read_lattice(job, a, floats);
    const int compact = strcmp(args_text(a, "--nodes", "thesis"), "compact") == 0;
    if (compact) {
        read_compact_sequence(job, a, floats, bits);
    } else if (args_has(a, "--stills")) {
        args_complain(a, "--stills takes --nodes compact");
    } else if (args_has(a, "--numbers")) {
        args_complain(a, "--sequence takes --numbers with --nodes compact alone");
    }
    if (floats && args_has(a, "--step")) {
        args_complain(a, "--sequence takes --step with a lattice alone");
    }
    job->frames.wish = (lattice_wish){.bits = floats ? 0 : bits,
                                      .power = job->compact.power,
                                      .fewest = args_has(a, "--tolerance")};
}

static void read_format(pack_job *job, args *a) {
    static const char *const nodes[] = {"thesis", "compact", NULL};
    static const char *const floats[] = {"float", NULL}, *const numbers[] = {"keep", "none", NULL};
    static const char *const steps[] = {"auto", "power", NULL};
    job->compact.numbers = args_choice(a, "--numbers", numbers, 0) == 0;
    job->compact.power = args_choice(a, "--step", steps, 0) == 1;
    if (job->frames.wanted) {
        read_sequence_format(job, a);
        return;
    }
    if (args_choice(a, "--nodes", nodes, 0) == 1) {
        job->compact.floats = strcmp(args_text(a, "--geometry", ""), "float") == 0;
        job->compact.lattice_bits = read_lattice(job, a, job->compact.floats);
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
    if (args_has(a, "--tolerance") || args_has(a, "--numbers") || args_has(a, "--step")) {
        args_complain(a, "--tolerance, --numbers and --step go with --nodes compact");
    }
}

static void read_quality(pack_job *job, args *a) {
    static const char *const qualities[] = {"fast", "high", NULL};
    const int for_all = job->frames.for_all;
    job->is_high = (int)args_choice(a, "--quality", qualities, for_all);
    job->quality_seconds = (uint32_t)args_number(a, "--quality-time", 0, 1, 86400);
    if (for_all && (!job->is_high || job->options.build != PLT_BUILD_HOST ||
                    job->options.splits != PLT_SPLIT_SAH)) {
        args_complain(a, "--tree-for all takes --build host, --splits sah and --quality high");
    } else if (job->is_high && job->options.build != PLT_BUILD_HOST) {
        args_complain(a, "--quality high improves what this program builds; use --build host");
    } else if (!job->is_high && args_has(a, "--quality-time")) {
        args_complain(a, "--quality-time is for --quality high");
    }
    job->options.poses = for_all ? &job->frames.poses : NULL;
    job->compact.quality = job->is_high ? &job->quality : NULL;
    job->compact.quality_seconds = job->quality_seconds;
}

static void read_mesh_flags(pack_meshes *in, args *a) {
    in->most = (size_t)args_number(a, "--reduce", 0, 1, 1000000000);
    in->frame = (unsigned)args_number(a, "--frame", 0, 0, 99999);
    in->has_frame = in->frame > 0;
    in->repair = args_has(a, "--repair");
    in->centre = args_has(a, "--centre");
    if (args_doubles(a, "--origin", in->shift, 3) && in->centre) {
        args_complain(a, "--centre and --origin both choose the origin; leave one out");
    }
    if (args_doubles(a, "--weld", &in->weld, 1) && !(in->weld > 0)) {
        args_complain(a, "--weld takes a distance above 0");
    }
}

static void read_instances(pack_job *job, args *a) {
    pack_instances_read(&job->instances, a);
    if (job->instances.wanted &&
        (job->compact.lattice_bits > 0 || job->options.build != PLT_BUILD_HOST)) {
        args_complain(a, "--instances takes --nodes thesis and --build host");
    }
}

/* Other treelets than the builder's are formed of the nodes of one tree that stays as it is. */
static void read_treelets(pack_job *job, args *a) {
    static const char *const fills[] = {"bfs", "area", "full", NULL};
    static const char *const rules[] = {"thesis", "newest", "none", NULL};
    pack_options *o = &job->options;
    o->treelet_nodes = strcmp(args_text(a, "--treelet", ""), "auto") == 0
                           ? PACK_TREELET_AUTO
                           : (uint32_t)args_number(a, "--treelet", 64, 1, 1000000);
    o->fill = (uint8_t)args_choice(a, "--fill", fills, TREELET_FILL_BFS);
    o->slots = (uint8_t)args_choice(a, "--slots", rules, TREELET_SLOTS_THESIS);
    const int differ = o->treelet_nodes == PACK_TREELET_AUTO || o->fill != TREELET_FILL_BFS ||
                       o->slots != TREELET_SLOTS_THESIS;
    if (differ &&
        (o->build != PLT_BUILD_HOST || job->frames.wanted ||
         strcmp(args_text(a, "--nodes", "thesis"), "compact") == 0 || args_has(a, "--instances"))) {
        args_complain(a,
                      "--fill area|full, --slots newest|none and --treelet auto take --nodes "
                      "thesis and --build host, without --sequence and --instances");
    } else if (o->fill == TREELET_FILL_FULL && o->treelet_nodes > TREELET_FULL_MOST) {
        args_complain(a, "--fill full takes --treelet 1 to %u or auto; --fill area takes any",
                      TREELET_FULL_MOST);
    }
}

static void read_flags(pack_job *job, args *a) {
    static const char *const builds[] = {"host", "device", "none", NULL};
    static const char *const splits[] = {"sah", "median", NULL};
    static const char *const leaves[] = {"1", "2", "4", NULL};
    job->options.build = (uint8_t)args_choice(a, "--build", builds, PLT_BUILD_HOST);
    job->options.splits = (uint8_t)args_choice(a, "--splits", splits, PLT_SPLIT_SAH);
    job->options.leaf_triangles = 1u << args_choice(a, "--leaf", leaves, 1);
    pack_frames_read(&job->frames, a);
    read_treelets(job, a);
    read_format(job, a);
    read_instances(job, a);
    pack_surface_read(&job->surface, a);
    pack_materials_read(&job->materials, a, &job->surface.corners);
    pack_surface_check(&job->surface, a);
    read_checks(job, a);
    read_quality(job, a);
    job->compact.splits = job->options.splits;
    job->compact.build = job->options.build;
    job->compact.leaf_triangles = job->options.leaf_triangles;
    read_mesh_flags(&job->in, a);
    heap_limit(args_number(a, "--memory", UINT64_MAX, PACK_MEMORY_LEAST, PACK_MEMORY_MOST));
    job->json = args_text(a, "--json", NULL);
    job->out = args_text(a, "-o", NULL);
    if (job->out == NULL) {
        args_complain(a, "-o SCENE.plt says where the image goes");
    }
    destination_differ(a, "-o and --json", job->out, job->json);
}

int run_pack(args *a) {
    pack_job job = {0};
    read_flags(&job, a);
    if (a->wrong) {
        pack_frames_free(&job.frames);
        return 2;
    }
    job.command = command_line(a);
    fail f = {""};
    packed image = {0};
    const double began = clock_seconds();
    const int status = job.instances.wanted ? pack_instances_file(&job, a->file[0], &image, &f)
                                            : pack_files(&job, a, &image, &f);
    if (status == 0 && !job.instances.wanted) {
        say_losses(&job, &image);
    }
    if (status == 0) {
        say_quality(&job.quality);
        say_treelets(&image.treelets);
        pack_surface_say(&job.surface, &image);
        pack_materials_say(&job.materials, &job.in, &image);
        say_done(&job, &image, clock_seconds() - began);
    } else {
        pack_memory_explain(a->file[0], &f);
        fprintf(stderr, "%s\n", f.text);
    }
    output_abandon(job.image_out);
    output_abandon(job.json_out);
    pack_free(&image);
    pack_frames_free(&job.frames);
    pack_meshes_free(&job.in);
    pack_surface_free(&job.surface);
    pack_materials_free(&job.materials);
    free(job.command);
    return status == 0 ? 0 : 1;
}
