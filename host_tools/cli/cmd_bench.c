/* cmd_bench - planelet bench: rays per second, by scene, kind of ray, structure and mode
 *
 * Every mode of one structure must give the same hits, bit for bit: their hashes are compared.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/destination.h"
#include "host_tools/app/phase.h"
#include "host_tools/app/scene.h"
#include "host_tools/app/view.h"
#include "host_tools/cli/baseline.h"
#include "host_tools/cli/bench_against.h"
#include "host_tools/cli/bench_measure.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/pack_meshes.h"
#include "host_tools/pack/pack.h"

enum { SIDE_MOST = 4096, MODES_MOST = 2 * BENCH_SIDES + 2, RAYS_IN_FLIGHT = 32 };

static const arg_flag flags[] = {
    {"--kinds", "LIST",
     "rays: primary, shadow, light, bounce, random, outside, inside, several with commas "
     "between (default all)"},
    {"--hits", "LIST", "closest, any (default closest,any)"},
    {"--nodes", "LIST", "what a mesh is packed as: thesis, compact (default thesis,compact)"},
    {"--packets", "LIST", "rays along a packet's side: 2, 4, 8, 16 (default all)"},
    {"--walks", "LIST",
     "depth, two-stage, of packets; wave, for rays one by one, over the nodes as they are, and "
     "wide, over a wide form of them; structures go without what they do not have (default all)"},
    {"--repeat", "N", "trace so often; 1 to 1000 (default 5)"},
    {"--size", "WxH", "primary rays, each side 1 to 4096 (default 256x256)"},
    {"--structures", "LIST",
     "rows of these, with blanks between: engine, and structures as listed below, with the packets "
     "of --packets that they have (default engine)"},
    AGAINST_FLAG,
    VIEW_FLAGS,
    {"--json", "STATS", "write all figures to this file; - is standard output, without the table"},
    {NULL, NULL, NULL}};

const arg_command command_bench = {
    .name = "bench",
    .synopsis = "SCENE... [--json STATS]",
    .about =
        "Measures rays per second on one core, with rays that it makes for each SCENE: an image, "
        "measured as it is, or a mesh (PLY, OBJ, STL, recipe), packed in memory. SCENE may be - "
        "for an image on standard input.",
    .flags = flags,
    .files_least = 1,
    .files_most = 1000,
    .notes =
        "Rays: primary, one per pixel in Z order; shadow, from their hits to one light;\n"
        "light, the same from the light; bounce, from their hits in random directions\n"
        "by the cosine law, shuffled; random, from side to side of the scene's box;\n"
        "outside, from outside in random directions; inside, from within the box in\n"
        "random directions: from inside a closed room all of them hit.\n"
        "\n"
        "Mray/s is the median of all repetitions, least the slowest; spread is from the\n"
        "slowest to the fastest, as a share of the median. The rest is per ray:\n"
        "instructions, cycles and branch misses, where the system lets a program count\n"
        "them, visits of nodes, tests of groups of four rays against a box, and of\n"
        "groups against a triangle, of those that --structures names as they count\n"
        "them. A star marks the best of each structure.\n"
        "\n"
        "With --against both trace all rays in turns, and hits are compared: Mray/s are\n"
        "the best of all rounds, ratio is how many times as fast the engine is by them,\n"
        "median of the rounds' ratios; visits of nodes are per packet of that side,\n"
        "tests of groups against a triangle per ray, bytes of nodes per triangle.\n",
    .print_notes = baseline_print_notes};

typedef struct bench {
    args *a;
    unsigned kinds, hits, nodes, packets, walks; /* sets of bits */
    plt_frame frame;                             /* of the primary rays */
    bench_meter meter;
    bench_rows rows;
    bench_list structures;
    against against;
    ray_kinds rays; /* of the scene that is measured */
    int has_rays;   /* 0: they are not made yet */
    output *table, *json;
} bench;

/* The engine has just been opened: all structures of a scene are measured with one set. */
static int make_rays(bench *b, plt_engine *engine, const char *name, fail *f) {
    if (b->has_rays) {
        return 0;
    }
    view_camera(b->a, plt_engine_info(engine), b->frame.width, b->frame.height, &b->frame.camera);
    if (b->a->wrong || view_refused(b->a, &b->frame, 1, f) != 0) {
        return -1;
    }
    b->has_rays = 1;
    return ray_kinds_make(&b->rays, b->kinds, engine, &b->frame, name, f);
}

static void free_rays(bench *b) {
    ray_kinds_free(&b->rays);
    b->has_rays = 0;
}

/* The same triangles have given the same hits before, in another mode or structure. */
static int check_hits(const bench *b, unsigned first, fail *f) {
    const bench_row *row = &b->rows.row[b->rows.count - 1];
    for (unsigned i = first; i + 1 < b->rows.count; i++) {
        const bench_row *other = &b->rows.row[i];
        if (other->kind == row->kind && other->any == row->any && other->hash != row->hash) {
            return fail_set(f, row->scene,
                            "hits of %s rays differ between modes; please report this",
                            ray_kind_names[row->kind]);
        }
    }
    return 0;
}

/* One structure: every kind of ray, closest and any hit. `first` row of this image. */
static int measure_kinds(bench *b, built_structure *s, const bench_row *like, unsigned first,
                         fail *f) {
    for (unsigned kind = 0; kind < RAY_KINDS; kind++) {
        for (unsigned any = 0; any < 2; any++) {
            if (!(b->kinds >> kind & 1u) || !(b->hits >> any & 1u)) {
                continue;
            }
            bench_row *row = bench_rows_add(&b->rows);
            if (row == NULL) {
                return fail_set(f, "rays", "out of memory; choose a smaller --size");
            }
            *row = *like;
            row->kind = (uint8_t)kind;
            row->any = (uint8_t)any;
            if (bench_measure(row, s, &b->rays.of[kind], &b->meter, f) != 0 ||
                check_hits(b, first, f) != 0) {
                return -1;
            }
        }
    }
    return 0;
}

/* A way to trace. */
typedef struct bench_mode {
    plt_options options;
    uint8_t walk; /* enum bench_walk */
} bench_mode;

typedef struct mode_list {
    bench_mode mode[MODES_MOST];
    unsigned count;
} mode_list;

/* Unless this build or these nodes do not have it. */
static void add_mode(mode_list *list, const plt_info *info, plt_options options,
                     enum bench_walk walk) {
    if (plt_arena_need(info, 1, &options) > 0) {
        list->mode[list->count++] = (bench_mode){options, (uint8_t)walk};
    }
}

/* A build may have no wave over compact blocks but with a wide form. */
static void add_waves(mode_list *list, const bench *b, const plt_info *info) {
    plt_options o = {.packet_side = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8,
                     .rays_in_flight = RAYS_IN_FLIGHT,
                     .rays = PLT_RAYS_INCOHERENT};
    if ((b->walks >> BENCH_WAVE & 1u) &&
        (info->nodes_format == PLT_NODES_THESIS || PLT_WITH_WAVE_COMPACT)) {
        add_mode(list, info, o, BENCH_WAVE);
    }
    o.wide = 1;
    if (b->walks >> BENCH_WIDE & 1u) {
        add_mode(list, info, o, BENCH_WIDE);
    }
}

static void list_modes(mode_list *list, const bench *b, const plt_info *info) {
    list->count = 0;
    for (unsigned p = 0; p < BENCH_SIDES; p++) {
        for (unsigned walk = BENCH_DEPTH; walk <= BENCH_TWO_STAGE; walk++) {
            const plt_options o = {.packet_side = (uint8_t)(2u << p), .order = (uint8_t)walk};
            if ((b->packets >> p & 1u) && (b->walks >> walk & 1u)) {
                add_mode(list, info, o, (enum bench_walk)walk);
            }
        }
    }
    add_waves(list, b, info);
}

/* Whether the wave was to be there and is not: the arena had no room for it. */
static int is_without(const scene *s, const bench_mode *mode) {
    return s->options.rays_in_flight != mode->options.rays_in_flight ||
           s->options.wide != mode->options.wide;
}

/* Rays are made with an engine that is opened for that, unless they are there. */
static int open_for_rays(bench *b, scene *s, const char *path, fail *f) {
    plt_fault fault;
    s->options = (plt_options){.packet_side = SCENE_USUAL_PACKET};
    const int opened = scene_start(s, path, &fault);
    return opened == PLT_OK ? make_rays(b, s->engine, scene_name(path), f)
                            : scene_refused(s, path, opened, &fault, f);
}

/* The engine against structures. */
static int measure_against(bench *b, scene *s, const char *path, fail *f) {
    return open_for_rays(b, s, path, f) == 0 ? against_measure(&b->against, s, path, &b->rays, f)
                                             : -1;
}

/* The engine as it is open. */
static int measure_engine(bench *b, const scene *s, const bench_row *like, unsigned first,
                          fail *f) {
    built_structure *opened = structure_of_engine(s->engine, like->scene, f);
    const int status = opened != NULL ? measure_kinds(b, opened, like, first, f) : -1;
    structure_close(opened);
    return status;
}

/* Its modes; those that the arena had no room for are left out. */
static int measure_modes(bench *b, scene *s, const char *path, const plt_info *info,
                         const mode_list *modes, unsigned first, fail *f) {
    plt_fault fault;
    int status = 0;
    for (unsigned i = 0; i < modes->count && status == 0; i++) {
        const bench_mode *mode = &modes->mode[i];
        s->options = mode->options;
        const int opened = scene_start(s, path, &fault);
        if (opened != PLT_OK) {
            return scene_refused(s, path, opened, &fault, f);
        }
        if (is_without(s, mode)) {
            continue;
        }
        const bench_row like = {
            .scene = scene_name(path),
            .nodes = info->nodes_format,
            .walk = mode->walk,
            .packet_side = mode->options.rays_in_flight > 0 ? 0 : mode->options.packet_side,
            .triangles = info->triangles,
            .arena_bytes = plt_arena_need(info, 1, &mode->options)};
        status = make_rays(b, s->engine, like.scene, f);
        status = status == 0 ? measure_engine(b, s, &like, first, f) : status;
    }
    return status;
}

/* With packets of that side; 0: rays one by one. */
static int measure_structure(bench *b, const scene *s, const char *path, const bench_wanted *w,
                             unsigned side, unsigned first, fail *f) {
    baseline built = {.kind = w->kind, .options = bench_wanted_options(w, side)};
    int status = baseline_open(&built, s->engine, scene_name(path), f);
    if (status == 0) {
        const bench_row like = {.scene = scene_name(path),
                                .structure = w->name,
                                .packet_side = (uint8_t)side,
                                .triangles = plt_engine_info(s->engine)->triangles,
                                .build_seconds = built.build_seconds};
        status = measure_kinds(b, built.s, &like, first, f);
    }
    baseline_close(&built);
    return status;
}

static int measure_sides(bench *b, const scene *s, const char *path, const bench_wanted *w,
                         unsigned first, fail *f) {
    int status = bench_wanted_has(w, 0) ? measure_structure(b, s, path, w, 0, first, f) : 0;
    for (unsigned i = 0; i < BENCH_SIDES && status == 0; i++) {
        const unsigned side = 2u << i;
        if ((b->packets >> i & 1u) && side <= PLT_PACKET_SIDE_MAX && bench_wanted_has(w, side)) {
            status = measure_structure(b, s, path, w, side, first, f);
        }
    }
    return status;
}

/* Those that are asked for beside the engine, of the triangles of an engine that is opened for
 * that. */
static int measure_structures(bench *b, scene *s, const char *path, unsigned first, fail *f) {
    int status = open_for_rays(b, s, path, f);
    for (unsigned i = 0; i < b->structures.count && status == 0; i++) {
        status = measure_sides(b, s, path, &b->structures.wanted[i], first, f);
    }
    return status;
}

/* Passes over the rays of all that is measured, for the progress. */
static uint64_t count_passes(const bench *b, unsigned modes) {
    unsigned ways = modes;
    for (unsigned i = 0; i < b->structures.count; i++) {
        const bench_wanted *w = &b->structures.wanted[i];
        ways += (unsigned)bench_wanted_has(w, 0);
        for (unsigned k = 0; k < BENCH_SIDES; k++) {
            ways += (b->packets >> k & 1u) && bench_wanted_has(w, 2u << k);
        }
    }
    return (uint64_t)ways * (unsigned)__builtin_popcount(b->kinds) *
           (unsigned)__builtin_popcount(b->hits) * (b->meter.repeat + 1);
}

/* All of an image that is attached or held: modes of the engine, structures of its triangles. */
static int measure_image(bench *b, scene *s, const char *path, fail *f) {
    plt_fault fault;
    plt_info info;
    mode_list modes = {.count = 0};
    const unsigned first = b->rows.count;
    int status = plt_image_info(&s->file.source, &info, &fault);
    if (status != PLT_OK) {
        return scene_refused(s, path, status, &fault, f);
    }
    if (b->against.list.count > 0) {
        return measure_against(b, s, path, f);
    }
    if (b->structures.has_engine) {
        list_modes(&modes, b, &info);
        if (modes.count == 0) {
            return fail_set(f, scene_name(path),
                            "no such mode is for its nodes; add --walks depth");
        }
    }
    b->meter.passes = 0;
    progress_begin(&b->meter.bar, "tracing", count_passes(b, modes.count));
    status = measure_modes(b, s, path, &info, &modes, first, f);
    if (status == 0 && b->structures.count > 0) {
        status = measure_structures(b, s, path, first, f);
    }
    progress_end(&b->meter.bar);
    return status;
}

static int pack_as(packed *image, const pack_meshes *in, unsigned nodes, const char *path,
                   fail *f) {
    const pack_options thesis = {.leaf_triangles = 2, .treelet_nodes = 64, .checks = 1};
    const compact_options compact = {.lattice_bits = 16,
                                     .numbers = 1,
                                     .checks = 1,
                                     .leaf_triangles = 2,
                                     .mesh_end = in->mesh_end,
                                     .meshes = 1};
    lattice_loss loss;
    phase_begin("building the tree of", path);
    const int status = nodes == PLT_NODES_THESIS
                           ? pack_mesh(image, &in->m, &thesis, path, f)
                           : pack_compact(image, &in->m, &compact, path, &loss, f);
    phase_end();
    return status;
}

/* A mesh, packed as pack does by default. */
static int measure_mesh(bench *b, char *path, fail *f) {
    pack_meshes in = {0};
    int status = pack_meshes_read(&in, &path, 1, f) == 0 ? pack_meshes_prepare(&in, f) : -1;
    for (unsigned nodes = 0; bench_nodes_names[nodes] != NULL && status == 0; nodes++) {
        packed image = {0};
        scene s = SCENE_CLOSED;
        if (!(b->nodes >> nodes & 1u)) {
            continue;
        }
        status = pack_as(&image, &in, nodes, path, f);
        if (status == 0) {
            host_scene_hold(&s.file, image.bytes, image.size, 0);
            s.source = s.file.source;
            s.arena_bytes = host_arena_bytes();
            status = measure_image(b, &s, path, f);
        }
        scene_close(&s);
        pack_free(&image);
    }
    pack_meshes_free(&in);
    return status;
}

static int measure_file(bench *b, char *path, fail *f) {
    scene s = SCENE_CLOSED;
    int status = scene_attach(&s, b->a, path, f);
    if (status == 0) {
        status = measure_image(b, &s, path, f);
    }
    scene_close(&s);
    return status;
}

/* An image, by its first bytes (SPEC.md, section 2) or its name; standard input is one. */
static int is_image(const char *path) {
    char head[8] = "";
    const size_t length = strlen(path);
    if (strcmp(path, "-") == 0 || (length > 4 && strcmp(path + length - 4, ".plt") == 0)) {
        return 1;
    }
    FILE *file = fopen(path, "rb");
    const size_t got = file != NULL ? fread(head, 1, sizeof head, file) : 0;
    if (file != NULL) {
        fclose(file);
    }
    return got == sizeof head && memcmp(head, "PLANELET", sizeof head) == 0;
}

static int print_scene(bench *b, const char *path, unsigned first, fail *f) {
    const char *before = ";";
    if (b->table == NULL) {
        return 0;
    }
    fail name = {""}; /* hides control characters */
    fail_set(&name, NULL, "%s", scene_name(path));
    output_print(b->table, f, "%s%s: %" PRIu32 " triangles", first > 0 ? "\n" : "", name.text,
                 b->against.list.count > 0 ? b->against.row[first].triangles
                                           : b->rows.row[first].triangles);
    for (unsigned kind = 0; kind < RAY_KINDS; kind++) {
        if (b->kinds >> kind & 1u) {
            output_print(b->table, f, "%s %" PRIu32 " %s", before, b->rays.of[kind].count,
                         ray_kind_names[kind]);
            before = ",";
        }
    }
    output_print(b->table, f, " rays\n");
    if (b->against.list.count > 0) {
        return against_print(&b->against, first, b->table, f);
    }
    return bench_rows_print(&b->rows, first, &b->meter.counters, b->table, f);
}

static int measure_all(bench *b, fail *f) {
    int status = 0;
    for (int i = 0; i < b->a->files && status == 0; i++) {
        const unsigned first = b->against.list.count > 0 ? b->against.rows : b->rows.count;
        char *path = b->a->file[i];
        status = is_image(path) ? measure_file(b, path, f) : measure_mesh(b, path, f);
        if (status == 0) {
            status = print_scene(b, path, first, f);
        }
        free_rays(b);
    }
    return status;
}

static int write_json(bench *b, fail *f) {
    output *o = b->json;
    if (o == NULL) {
        return 0;
    }
    output_print(o, f, "{\n  \"repeat\": %u,\n  \"width\": %u,\n  \"height\": %u,\n",
                 b->meter.repeat, b->frame.width, b->frame.height);
    if (b->against.list.count > 0) {
        against_json(&b->against, o, f);
    } else {
        bench_rows_json(&b->rows, &b->meter.counters, o, f);
    }
    b->json = NULL;
    if (output_print(o, f, "\n}\n") != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

/* Says what the system does not count for this program. */
static void print_missing(const counters *c, output *o, fail *f) {
    static const char *const names[COUNTERS] = {"instructions", "cycles", "branch misses"};
    const char *before = "\nnot granted by the system: ";
    for (int i = 0; i < COUNTERS; i++) {
        if (c->file[i] < 0) {
            output_print(o, f, "%s%s", before, names[i]);
            before = ", ";
        }
    }
    if (c->why != NULL) {
        output_print(o, f, " (%s)\n", c->why);
    }
}

static int finish_table(bench *b, fail *f) {
    output *o = b->table;
    b->table = NULL;
    if (o == NULL) {
        return 0;
    }
    if (b->against.list.count == 0) {
        print_missing(&b->meter.counters, o, f);
    }
    return output_commit(o, f);
}

/* Outputs are opened first: a path that cannot be written fails before the long run. */
static int run_all(bench *b, fail *f) {
    const char *json = args_text(b->a, "--json", NULL);
    if (json == NULL || strcmp(json, "-") != 0) {
        b->table = output_open_text("-", f);
        if (b->table == NULL) {
            return -1;
        }
    }
    if (json != NULL && (b->json = output_open_text(json, f)) == NULL) {
        return -1;
    }
    counters_open(&b->meter.counters);
    const int status =
        measure_all(b, f) != 0 || write_json(b, f) != 0 || finish_table(b, f) != 0 ? -1 : 0;
    counters_close(&b->meter.counters);
    return status;
}

static void read_against(bench *b, args *a) {
    b->against.kinds = b->kinds;
    b->against.hits = b->hits;
    b->against.packets = b->packets;
    b->against.repeat = b->meter.repeat;
    against_read(&b->against, a);
    if (args_has(a, "--against") && (args_has(a, "--walks") || args_has(a, "--nodes"))) {
        args_complain(a, "--against has one walk and thesis nodes; leave out --walks and --nodes");
    }
}

static void read_structures(bench *b, args *a) {
    bench_list_read(&b->structures, a, "--structures", 1);
    bench_list_check(&b->structures, a, "--structures", b->packets, 0);
    if (!args_has(a, "--structures")) {
        b->structures.has_engine = 1;
    } else if (args_has(a, "--against")) {
        args_complain(a, "--structures and --against are two tables; give one of them");
    } else if (!b->structures.has_engine && args_has(a, "--walks")) {
        args_complain(a, "--walks are the engine's; add engine to --structures");
    } else if (b->structures.count > 0 && args_has(a, "--nodes")) {
        args_complain(a, "--structures are beside thesis nodes; leave out --nodes");
    }
}

static void read_flags(bench *b, args *a) {
    static const char *const packets[] = {"2", "4", "8", "16", NULL};
    unsigned width = 256, height = 256;
    b->a = a;
    b->kinds = args_set(a, "--kinds", ray_kind_names, ~0u) & ((1u << RAY_KINDS) - 1);
    b->hits = args_set(a, "--hits", bench_any_names, 3);
    b->nodes = args_set(a, "--nodes", bench_nodes_names, 3);
    b->packets = args_set(a, "--packets", packets, 15);
    b->walks = args_set(a, "--walks", bench_walk_names, (1u << BENCH_WALKS) - 1);
    b->meter.repeat = (unsigned)args_number(a, "--repeat", 5, 1, TURNS_ROUNDS_MOST);
    args_size(a, "--size", SIDE_MOST, &width, &height);
    b->frame.width = (uint16_t)width;
    b->frame.height = (uint16_t)height;
    read_against(b, a);
    read_structures(b, a);
    if (b->against.list.count + b->structures.count > 0) {
        b->nodes = 1u << PLT_NODES_THESIS; /* structures are of float triangles, which those have */
    }
}

int run_bench(args *a) {
    bench b = {.a = a};
    fail f = {""};
    read_flags(&b, a);
    const int status = a->wrong ? -1 : run_all(&b, &f);
    output_abandon(b.table);
    output_abandon(b.json);
    bench_rows_free(&b.rows);
    against_free(&b.against);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    return 0;
}
