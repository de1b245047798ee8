/* cmd_info - planelet info: every field and count of an image, and what an
 * arena must hold for it
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "engine/image/header.h"
#include "engine/scene/formats.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"
#include "host_tools/app/played.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/fail.h"
#include "host_tools/cli/arena_parts.h"
#include "host_tools/cli/breakdown.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/texture_list.h"
#include "host_tools/pack/shift.h"

static const arg_flag flags[] = {
    {"--json", NULL, "the same for programs"},
    {"--packet", "auto|2|4|8|16",
     "arena for such packets; auto is 8, and lists what each size takes (default auto)"},
    {"--walk", "depth|two-stage", "arena for this order (default depth)"},
    {NULL, NULL, NULL}};

const arg_command command_info = {
    .name = "info",
    .synopsis = "SCENE.plt [--json]",
    .about =
        "Says what a scene image holds, its bytes per triangle, and the arena it needs, part "
        "by part. SCENE.plt may be - for standard input.",
    .flags = flags,
    .files_least = 1,
    .files_most = 1};

static const char *const split_names[] = {"sah", "median"};
static const char *const node_names[] = {"thesis", "compact"};
static const char *const geometry_names[] = {"float", "lattice", "moving", "stills"};
static const char *const build_names[] = {"host", "device", "none"};

/* What info prints beyond plt_info. */
typedef struct derived {
    breakdown parts;
    texture_list textures;
    int has_parts; /* compact, and opened */
    uint64_t tree_bytes, geometry_bytes, overhead_bytes;
    double tree_each, geometry_each; /* per triangle */
    size_t arena_mapped, arena_fetched;
    size_t arena_streamed;                   /* 0: it cannot be */
    size_t arena_moved, arena_moved_fetched; /* to show frames */
    int lists_packets;                       /* no size was asked for */
    double shift[3];                         /* what pack subtracted from the meshes */
} derived;

static derived derive(const plt_info *i, const plt_options *o) {
    const double n = i->triangles > 0 ? (double)i->triangles : 1.0;
    derived d = {.shift = {0, 0, 0}};
    d.tree_bytes = (uint64_t)i->node_slots * PLT_NODE_BYTES;
    d.geometry_bytes = (uint64_t)i->triangles * PLT_RECORD_BYTES;
    d.overhead_bytes = (uint64_t)(i->node_slots - i->nodes) * PLT_NODE_BYTES;
    if (i->nodes_format == PLT_NODES_COMPACT) {
        d.tree_bytes = i->node_bytes;
        d.geometry_bytes = i->triangle_bytes;
        if (i->geometry_format == PLT_GEOMETRY_FLOAT) {
            d.geometry_bytes += (uint64_t)i->triangles * PLT_RECORD_BYTES;
        }
        d.overhead_bytes = 0;
    }
    d.tree_each = (double)d.tree_bytes / n;
    d.geometry_each = (double)d.geometry_bytes / n;
    d.arena_mapped = plt_arena_need(i, 1, o);
    d.arena_fetched = plt_arena_need(i, 0, o);
    plt_options streamed = *o;
    streamed.residency = PLT_RESIDENCY_STREAMED;
    d.arena_streamed = plt_arena_need(i, 0, &streamed);
    plt_options moved = *o;
    moved.movable = 1;
    d.arena_moved = plt_arena_need(i, 1, &moved);
    d.arena_moved_fetched = plt_arena_need(i, 0, &moved);
    return d;
}

/* A hostile image may hold anything there. */
static int is_shifted(const derived *d) {
    int any = 0, finite = 1;
    for (int a = 0; a < 3; a++) {
        any |= d->shift[a] != 0.0;
        finite &= isfinite(d->shift[a]) != 0;
    }
    return any && finite;
}

static void print_shift_json(const derived *d) {
    const int shifted = is_shifted(d);
    printf("  \"shift\": [%.17g, %.17g, %.17g],\n", shifted ? d->shift[0] : 0.0,
           shifted ? d->shift[1] : 0.0, shifted ? d->shift[2] : 0.0);
}

/* Of a vertex, in a frame: offsets included. */
static double frame_each(const plt_info *i) {
    return (double)i->frame_bytes / ((double)i->frames * i->vertices);
}

/* Stills have none. */
static uint64_t topology_bytes(const plt_info *i) {
    return plt_header_has_stills(i) ? 0 : plt_header_section_bytes(i, PLT_SECTION_TOPOLOGY);
}

static void print_instances_json(const plt_info *i) {
    printf("  \"bodies\": %" PRIu32 ",\n  \"instances\": %" PRIu32
           ",\n  \"placed_triangles\": %" PRIu32 ",\n  \"frame_rate\": %" PRIu32
           ",\n  \"frame_bytes\": %" PRIu32 ",\n",
           i->bodies, i->instances, i->placed_triangles, i->frame_rate, i->frame_bytes);
}

static void print_sequence_json(const plt_info *i) {
    printf("  \"frames\": %" PRIu32 ",\n", i->frames);
    if (i->instances > 0) {
        print_instances_json(i);
    } else if (i->frames > 0) {
        printf("  \"vertices\": %" PRIu32 ",\n  \"frame_rate\": %" PRIu32
               ",\n  \"key_every\": %" PRIu32 ",\n  \"frame_bytes\": %" PRIu32
               ",\n  \"frame_bytes_per_vertex\": %.4f,\n  \"topology_bytes\": %" PRIu64 ",\n",
               i->vertices, i->frame_rate, i->key_every, i->frame_bytes, frame_each(i),
               topology_bytes(i));
    }
}

static void print_parts_json(const plt_info *i, const derived *d) {
    if (!d->has_parts) {
        return;
    }
    printf(",\n  \"bytes_per_triangle\": {");
    for (int p = 0; p < PARTS; p++) {
        printf("%s\n    \"%s\": %.4f", p > 0 ? "," : "", breakdown_names[p],
               d->parts.bytes[p] / (i->triangles > 0 ? i->triangles : 1));
    }
    printf("\n  }");
}

static void print_counts_json(const plt_info *i) {
    printf("  \"triangles\": %" PRIu32 ",\n  \"nodes\": %" PRIu32 ",\n  \"node_slots\": %" PRIu32
           ",\n  \"leaf_lists\": %" PRIu32 ",\n  \"intermediate_lists\": %" PRIu32
           ",\n  \"treelets\": %" PRIu32 ",\n  \"treelet_nodes\": %" PRIu32
           ",\n  \"leaf_triangles\": %" PRIu32 ",\n",
           i->triangles, i->nodes, i->node_slots, i->leaf_lists, i->intermediate_lists, i->treelets,
           i->treelet_nodes, i->leaf_triangles);
}

/* What notices a wrong bit where parts come one by one (SPEC.md, 4.14). */
static const char *checks_of(const plt_info *i) {
    const int has_ids = i->nodes_format == PLT_NODES_COMPACT && i->primitive_id_bits > 0;
    if (!plt_can_stream(i)) {
        return "none";
    }
    return i->has_checks                         ? "all"
           : i->nodes_format == PLT_NODES_THESIS ? "none"
           : has_ids                             ? "all but primitive ids"
                                                 : "all";
}

static void print_format_json(const plt_info *i, const derived *d) {
    printf(
        "  \"splits\": \"%s\",\n  \"build\": \"%s\",\n  \"checks\": \"%s\",\n"
        "  \"node_format\": \"%s\",\n"
        "  \"geometry_format\": \"%s\",\n  \"lattice_bits\": %u,\n"
        "  \"source_triangles\": %" PRIu32 ",\n  \"number_bytes\": %" PRIu32
        ",\n  \"image_bytes\": %" PRIu32 ",\n  \"tree_bytes\": %" PRIu64
        ",\n  \"tree_bytes_per_triangle\": %.3f,\n"
        "  \"geometry_bytes\": %" PRIu64
        ",\n  \"geometry_bytes_per_triangle\": %.3f,\n"
        "  \"slot_overhead_bytes\": %" PRIu64 ",\n",
        split_names[i->splits], build_names[i->build], checks_of(i), node_names[i->nodes_format],
        geometry_names[i->geometry_format], (unsigned)i->lattice_bits, i->source_triangles,
        i->primitive_id_bytes, i->image_bytes, d->tree_bytes, d->tree_each, d->geometry_bytes,
        d->geometry_each, d->overhead_bytes);
}

/* The arena that packets of another size take, the image being mapped. */
static size_t need_with(const plt_info *i, const plt_options *options, unsigned side) {
    plt_options o = *options;
    o.packet_side = (uint8_t)side;
    return plt_arena_need(i, 1, &o);
}

static void print_packets(const plt_info *i, const plt_options *o, const derived *d) {
    for (unsigned side = 2; side <= PLT_PACKET_SIDE_MAX && d->lists_packets; side *= 2) {
        char name[32];
        snprintf(name, sizeof name, "with packets of %ux%u", side, side);
        printf("  %-30s %8zu bytes\n", name, need_with(i, o, side));
    }
}

static void print_arena_json(const plt_info *i, const plt_options *o, const derived *d) {
    printf("  \"local_stack_entries\": %" PRIu32 ",\n  \"global_stack_entries\": %" PRIu32
           ",\n  \"depth_stack_entries\": %" PRIu32
           ",\n  \"arena_bytes_needed\": %zu,\n"
           "  \"arena_bytes_needed_fetched\": %zu,\n",
           i->local_stack_entries, i->global_stack_entries, i->depth_stack_entries, d->arena_mapped,
           d->arena_fetched);
    if (d->arena_streamed > 0) {
        printf("  \"arena_bytes_needed_streamed\": %zu,\n", d->arena_streamed);
    }
    printf("  \"arena_parts\": ");
    arena_parts_print_json(i, 1, o);
    printf(",\n  \"arena_bytes_by_packet\": [");
    for (unsigned side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        printf("%s%zu", side > 2 ? ", " : "", need_with(i, o, side));
    }
    printf("],\n");
}

static void print_box_json(const plt_info *i) {
    if (i->triangles > 0) {
        printf("  \"lo\": [%.9g, %.9g, %.9g],\n  \"hi\": [%.9g, %.9g, %.9g]", (double)i->lo[0],
               (double)i->lo[1], (double)i->lo[2], (double)i->hi[0], (double)i->hi[1],
               (double)i->hi[2]);
    } else {
        printf("  \"lo\": null,\n  \"hi\": null");
    }
}

static void print_surface_json(const plt_info *i) {
    const double n = i->triangles > 0 ? i->triangles : 1;
    printf("  \"normal_bytes\": %" PRIu32
           ",\n  \"normal_bytes_per_triangle\": %.3f,\n"
           "  \"colour_bytes\": %" PRIu32 ",\n  \"colour_bytes_per_triangle\": %.3f,\n",
           i->normal_bytes, i->normal_bytes / n, i->colour_bytes, i->colour_bytes / n);
    printf("  \"page_bytes\": %" PRIu32 ",\n  \"page_bytes_per_triangle\": %.3f,\n", i->page_bytes,
           i->page_bytes / n);
    printf("  \"texcoord_bytes\": %" PRIu32 ",\n  \"texcoord_bytes_per_triangle\": %.3f,\n",
           i->texcoord_bytes, i->texcoord_bytes / n);
    printf("  \"material_bytes\": %" PRIu32 ",\n  \"material_bytes_per_triangle\": %.3f,\n",
           i->material_bytes, i->material_bytes / n);
}

static void print_json(const plt_info *i, const plt_options *o, const derived *d) {
    printf("{\n");
    print_counts_json(i);
    print_format_json(i, d);
    print_surface_json(i);
    texture_list_print_json(&d->textures);
    print_arena_json(i, o, d);
    print_sequence_json(i);
    print_shift_json(d);
    print_box_json(i);
    print_parts_json(i, d);
    printf("\n}\n");
}

static void print_parts_text(const plt_info *i, const derived *d) {
    for (int p = 0; p < PARTS && d->has_parts; p++) {
        printf("  %-16s %9.0f, %.3f per triangle\n", breakdown_names[p], d->parts.bytes[p],
               d->parts.bytes[p] / (i->triangles > 0 ? i->triangles : 1));
    }
}

/* With --build device there is no tree before it is built. */
static int tree_is_known(const plt_info *i) {
    return i->build != PLT_BUILD_DEVICE || i->leaf_lists + i->intermediate_lists > 0;
}

static double share(uint32_t part, uint32_t rest) {
    return part + rest > 0 ? 100.0 * part / ((double)part + rest) : 0.0;
}

static void print_stacks(const plt_info *i) {
    printf("stacks             %" PRIu32 " depth first", i->depth_stack_entries);
    if (i->nodes_format == PLT_NODES_THESIS) {
        printf("; %" PRIu32 " global and %" PRIu32 " local in two stages", i->global_stack_entries,
               i->local_stack_entries);
    }
    putchar('\n');
}

static void print_scene(const plt_info *i, const derived *d) {
    printf("triangles          %" PRIu32 "\n", i->triangles);
    if (i->triangles > 0) {
        printf("box                (%g, %g, %g) to (%g, %g, %g)\n", (double)i->lo[0],
               (double)i->lo[1], (double)i->lo[2], (double)i->hi[0], (double)i->hi[1],
               (double)i->hi[2]);
    }
    if (is_shifted(d)) {
        printf("shift              (%.17g, %.17g, %.17g) was subtracted from the meshes\n",
               d->shift[0], d->shift[1], d->shift[2]);
    }
}

static void print_tree(const plt_info *i, const derived *d) {
    printf("tree               built by %s, %s splits, %" PRIu32
           " triangles per list, treelets of %" PRIu32 "\n",
           build_names[i->build], split_names[i->splits], i->leaf_triangles, i->treelet_nodes);
    if (tree_is_known(i)) {
        printf("inner nodes        %" PRIu32 " in %" PRIu32 " slots, %" PRIu32 " treelets\n",
               i->nodes, i->node_slots, i->treelets);
        printf("lists              %" PRIu32 " single, %" PRIu32
               " intermediate (%.1f %% of the leaves)\n",
               i->leaf_lists, i->intermediate_lists, share(i->intermediate_lists, i->leaf_lists));
        print_stacks(i);
        printf("tree bytes         %" PRIu64 ", %.2f per triangle, %" PRIu64
               " of them free slots\n",
               d->tree_bytes, d->tree_each, d->overhead_bytes);
    }
}

static void print_compact(const plt_info *i, const derived *d) {
    printf("lattice            %u bits; %" PRIu32 " of %" PRIu32 " triangles kept their area\n",
           (unsigned)i->lattice_bits,
           i->triangles < i->source_triangles ? i->triangles : i->source_triangles,
           i->source_triangles); /* a single one is there twice (SPEC, 4.11) */
    printf("primitive ids      %s\n", i->primitive_id_bits > 0
                                          ? "of the packed meshes, kept in a section"
                                          : "positions in the image");
    if (d->has_parts && d->parts.of_one_mesh > 0) {
        printf("blocks of one mesh %" PRIu32 " of %" PRIu32 "\n", d->parts.of_one_mesh,
               i->treelets);
    }
    print_parts_text(i, d);
}

static void print_sequence(const plt_info *i, const derived *d) {
    printf("sequence           %" PRIu32 " frame%s, %" PRIu32 " per second, of %" PRIu32
           " vertices, ",
           i->frames, i->frames == 1 ? "" : "s", i->frame_rate, i->vertices);
    if (i->lattice_bits > 0) {
        printf("on a lattice of %u bits\n", (unsigned)i->lattice_bits);
    } else {
        printf("floats\n");
    }
    if (plt_header_has_stills(i)) {
        printf("frame bytes        %" PRIu64 " each, of tree and geometry\n",
               d->tree_bytes + d->geometry_bytes);
        return;
    }
    printf("key frames         every %" PRIu32 "\n", i->key_every);
    printf("frame bytes        %" PRIu32 ", %.2f per vertex and frame\n", i->frame_bytes,
           frame_each(i));
    printf("topology bytes     %" PRIu64 ", %.2f per triangle\n", topology_bytes(i),
           (double)topology_bytes(i) / i->triangles);
    printf("arena with frames  %zu bytes when the image is mapped, %zu if fetched\n",
           d->arena_moved, d->arena_moved_fetched);
}

static void print_instances(const plt_info *i) {
    printf("bodies             %" PRIu32 ", which have the triangles and the tree above\n",
           i->bodies);
    printf("instances          %" PRIu32 ", of %" PRIu32 " triangles in all\n", i->instances,
           i->placed_triangles);
    printf("frames             %" PRIu32 ", %" PRIu32 " per second\n", i->frames, i->frame_rate);
    printf("frame bytes        %" PRIu32 ", %.2f per instance and frame\n", i->frame_bytes,
           (double)i->frame_bytes / ((double)i->frames * i->instances));
}

static int has_surface(const plt_info *i) {
    return i->normal_bytes > 0 || i->colour_bytes > 0 || i->texcoord_bytes > 0 || i->page_bytes > 0;
}

/* Bytes and bytes per triangle of what hits are shaded or lit by, if there is any. */
static void print_surface(const char *what, uint32_t bytes, const plt_info *i) {
    if (bytes > 0) {
        printf("%s bytes%*s%" PRIu32 ", %.2f per triangle\n", what, (int)(13 - strlen(what)), "",
               bytes, (double)bytes / (i->triangles > 0 ? i->triangles : 1));
    }
}

/* With normals, colours or texture coordinates. */
static void print_smooth_need(const plt_info *i, const plt_options *options) {
    plt_options o = *options;
    o.surface = 1;
    if (has_surface(i)) {
        printf("arena if smooth    %zu bytes when the image is mapped, %zu if fetched\n",
               plt_arena_need(i, 1, &o), plt_arena_need(i, 0, &o));
    }
}

static void print_text(const plt_info *i, const plt_options *o, const derived *d) {
    print_scene(i, d);
    print_tree(i, d);
    printf("geometry bytes     %" PRIu64 ", %.2f per triangle\n", d->geometry_bytes,
           d->geometry_each);
    if (i->nodes_format == PLT_NODES_COMPACT) {
        print_compact(i, d);
    }
    print_surface("normal", i->normal_bytes, i);
    print_surface("colour", i->colour_bytes, i);
    print_surface("page", i->page_bytes, i);
    print_surface("texcoord", i->texcoord_bytes, i);
    print_surface("material", i->material_bytes, i);
    texture_list_print(&d->textures);
    if (i->instances > 0) {
        print_instances(i);
    } else if (i->frames > 0) {
        print_sequence(i, d);
    }
    printf("image bytes        %" PRIu32 "\n", i->image_bytes);
    printf("arena needed       %zu bytes%s\n", d->arena_mapped,
           i->build == PLT_BUILD_DEVICE ? " for the worst tree" : " when the image is mapped");
    arena_parts_print(i, 1, o);
    print_packets(i, o, d);
    if (i->build != PLT_BUILD_DEVICE) {
        printf("arena if fetched   %zu bytes\n", d->arena_fetched);
    }
    print_smooth_need(i, o);
    if (d->arena_streamed > 0) {
        printf("arena if streamed  %zu bytes, and all that is more goes to blocks\n",
               d->arena_streamed);
        printf("checks of parts    %s\n", checks_of(i));
    }
}

/* Checks the whole image, each frame of a sequence, too. The tree of --build device is built here
 * to count it, unless the arena is too small. */
static int inspect(scene *s, const char *path, plt_info *info, fail *f) {
    plt_fault fault;
    int status = plt_image_info(&s->file.source, info, &fault);
    if (status == PLT_OK) {
        s->options.movable = info->frames > 0 && info->instances == 0 &&
                             info->geometry_format != PLT_GEOMETRY_STILLS; /* frame 0 */
        s->options.surface = has_surface(info);
        status = scene_start(s, path, &fault);
        s->options.surface = 0;
    }
    if (status == PLT_ERR_IMAGE || status == PLT_ERR_SOURCE || status == PLT_ERR_ARGUMENT) {
        return scene_refused(s, path, status, &fault, f);
    }
    if (s->engine != NULL) {
        *info = *plt_engine_info(s->engine);
    }
    status = 0;
    for (uint32_t i = 0; s->engine != NULL && s->options.movable && i < info->frames && status == 0;
         i++) {
        status = played_to(s, path, i, f);
    }
    s->options.movable = 0;
    return status;
}

static int list_textures(const scene *s, const char *path, texture_list *to, fail *f) {
    plt_fault fault;
    const int status = texture_list_read(to, &s->file.source, &fault);
    return status == PLT_OK ? 0 : scene_refused(s, path, status, &fault, f);
}

int run_info(args *a) {
    scene s = SCENE_CLOSED;
    texture_list textures = {.section = NULL};
    plt_info info;
    fail f = {""};
    int status = scene_attach(&s, a, a->file[0], &f);
    if (status == 0) {
        status = output_print_standard(&f);
    }
    if (status == 0) {
        status = inspect(&s, a->file[0], &info, &f);
    }
    if (status == 0) {
        status = list_textures(&s, a->file[0], &textures, &f);
    }
    if (status == 0) {
        const int lists_packets = s.options.packet_side == 0;
        s.options.packet_side = lists_packets ? SCENE_USUAL_PACKET : s.options.packet_side;
        derived d = derive(&info, &s.options);
        d.lists_packets = lists_packets;
        d.textures = textures;
        d.has_parts = s.engine != NULL && info.nodes_format == PLT_NODES_COMPACT;
        shift_read(&s.file.source, d.shift);
        if (d.has_parts) {
            breakdown_count(s.engine, &d.parts);
        }
        args_has(a, "--json") ? print_json(&info, &s.options, &d)
                              : print_text(&info, &s.options, &d);
    }
    texture_list_free(&textures);
    scene_close(&s);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    return 0;
}
