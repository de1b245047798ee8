/* pack_frames - see pack_frames.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_frames.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "host_tools/base/progress.h"
#include "host_tools/pack/lattice.h"

/* ---- which frames ----------------------------------------------------------------- */

static int is_recipe(const char *path) {
    const size_t length = strlen(path);
    return length > 4 && strcasecmp(path + length - 4, ".txt") == 0;
}

static void read_range(pack_frames *p, args *a) {
    const char *frames = args_text(a, "--frames", NULL);
    const int one = a->files == 1 && (is_recipe(a->file[0]) || frame_range_is_pattern(a->file[0]));
    p->range = (frame_range){0, (unsigned)a->files};
    p->is_numbered = one && frames != NULL;
    if (frames != NULL && frame_range_read(&p->range, frames) != 0) {
        args_complain(a, "--frames takes A:B, 0 to %d, A below B, not '%s'", FRAME_RANGE_END - 1,
                      frames);
    } else if (frames != NULL && !one) {
        args_complain(a, "--frames A:B is for one MESH: a recipe, or a name with '{}'");
    } else if (frames == NULL && one) {
        args_complain(a, "--sequence of one MESH takes --frames A:B, too");
    }
}

static void refuse_others(args *a) {
    static const char *const others[] = {"--weld", "--reduce", "--memory", "--frame"};
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (args_has(a, others[i])) {
            args_complain(a, "%s is for one mesh, not for --sequence", others[i]);
        }
    }
    for (int i = 0; i < a->files; i++) {
        if (strcmp(a->file[i], "-") == 0) {
            args_complain(a, "--sequence reads its files twice, and standard input cannot be");
        }
    }
}

void pack_frames_read(pack_frames *p, args *a) {
    static const char *const trees[] = {"first", "all", NULL};
    p->wanted = args_has(a, "--sequence");
    if (!p->wanted) {
        if (args_has(a, "--frames") || args_has(a, "--key") || args_has(a, "--tree-for") ||
            args_has(a, "--stills") || (args_has(a, "--rate") && !args_has(a, "--instances"))) {
            args_complain(a, "--frames, --rate, --key, --stills and --tree-for go with --sequence");
        }
        return;
    }
    p->path = a->file;
    p->for_all = args_choice(a, "--tree-for", trees, 0) == 1;
    p->options.frame_rate = (uint32_t)args_number(a, "--rate", 25, 1, PLT_FRAME_RATE_MOST);
    p->options.stills = (uint8_t)args_has(a, "--stills");
    p->options.key_every = (uint32_t)args_number(a, "--key", 16, 1, 100000);
    read_range(p, a);
    refuse_others(a);
    p->options.frames = p->range.count;
    if (!a->wrong) {
        p->first = frame_range_file(a->file[0], p->range.first);
    }
}

/* ---- their meshes ----------------------------------------------------------------- */

static unsigned number_of(const pack_frames *p, unsigned i) {
    return p->range.first + i;
}

static int out_of_memory(const char *name, fail *f) {
    return fail_set(f, name, "out of memory; close other programs");
}

/* Triangles of the first frame, vertex by vertex. */
static int compare(const mesh *first, const mesh *now, const char *file, unsigned number, fail *f) {
    char name[24];
    snprintf(name, sizeof name, "frame %u", number);
    if (now->vertices != first->vertices || now->triangles != first->triangles) {
        return fail_set(f, name,
                        "%s: has %zu vertices and %zu triangles, the first frame %zu and %zu; "
                        "write all frames from one mesh",
                        file, now->vertices, now->triangles, first->vertices, first->triangles);
    }
    for (size_t i = 0; i < 3 * now->triangles; i++) {
        if (now->triangle[i] != first->triangle[i]) {
            return fail_set(f, name,
                            "%s: triangle %zu has other vertices than in the first frame; write "
                            "all frames from one mesh",
                            file, i / 3);
        }
    }
    return 0;
}

static int read_file(const pack_meshes *in, mesh *m, const char *file, unsigned number, fail *f) {
    mesh_report report = {.repair = in->repair, .centred = in->centre};
    fail why = {""};
    if (mesh_read(m, file, number, &report, &why) != 0 ||
        precision_settle(m, in->shift, file, &why) != 0) {
        char name[24];
        snprintf(name, sizeof name, "frame %u", number);
        return fail_set(f, name, "%s", why.text); /* which names the file */
    }
    return compare(&in->m, m, file, number, f);
}

/* Frame `i` of the sequence, 1 and on. */
static int read_frame(const pack_frames *p, const pack_meshes *in, unsigned i, mesh *m, fail *f) {
    char *file = frame_range_file(p->path[p->is_numbered ? 0 : i], number_of(p, i));
    const int status =
        file == NULL ? out_of_memory(p->path[0], f) : read_file(in, m, file, number_of(p, i), f);
    free(file);
    return status;
}

/* ---- the lattice ------------------------------------------------------------------ */

static void add_ground(lattice_ground *g, const mesh *m) {
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        const float *at = m->vertex + 3 * (size_t)m->triangle[i];
        for (int a = 0; a < 3; a++) {
            const int grain = lattice_grain(at[a]);
            g->box.lo[a] = at[a] < g->box.lo[a] ? at[a] : g->box.lo[a];
            g->box.hi[a] = at[a] > g->box.hi[a] ? at[a] : g->box.hi[a];
            g->grain = grain < g->grain ? grain : g->grain;
        }
    }
}

/* Beyond the meshes there are points that only a forged image has; they must be in range, too. */
static int choose_lattice(pack_frames *p, const lattice_ground *g, const char *name, fail *f) {
    plt_lattice *l = &p->options.lattice;
    if (p->wish.bits == 0) {
        *l = (plt_lattice){.bits = 0};
        return 0;
    }
    if (lattice_over(l, g, &p->wish, name, f) != 0) {
        return -1;
    }
    for (int a = 0; a < 3; a++) {
        if (!(plt_lattice_float(l, a, (1u << l->bits) - 1u) <= PLT_COORD_MAX)) {
            return fail_set(f, name,
                            "a lattice over all frames would reach beyond 2^40; use "
                            "--geometry float");
        }
    }
    return 0;
}

/* ---- poses ------------------------------------------------------------------------ */

/* Frame `i`, if it is to be one. */
static int add_pose(pack_frames *p, const mesh *m, unsigned i, fail *f) {
    const uint32_t wanted = p->for_all ? poses_wanted(p->range.count, m->triangles) : 0;
    const int is_next =
        p->poses.count < wanted && poses_frame(p->poses.count, wanted, p->range.count) == i;
    if (is_next && poses_add(&p->poses, m) != 0) {
        return fail_set(f, p->first,
                        "out of memory for the frames of --tree-for all; use --tree-for first");
    }
    return 0;
}

static void snap_all(pack_frames *p, mesh *first) {
    sequence_snap(first, &p->options.lattice);
    for (uint32_t i = 0; i < p->poses.count; i++) {
        mesh pose = {.vertex = p->poses.vertex[i], .vertices = first->vertices};
        sequence_snap(&pose, &p->options.lattice);
    }
}

int pack_frames_scan(pack_frames *p, pack_meshes *in, fail *f) {
    lattice_ground ground = {plt_box_empty(), LATTICE_NO_GRAIN};
    progress bar;
    int status = 0;
    add_ground(&ground, &in->m);
    poses_begin(&p->poses, &in->m);
    progress_begin(&bar, "reading frames", p->range.count);
    for (unsigned i = 1; i < p->range.count && status == 0; i++) {
        mesh m = {0};
        status = read_frame(p, in, i, &m, f);
        if (status == 0) {
            add_ground(&ground, &m);
            status = add_pose(p, &m, i, f);
        }
        mesh_free(&m);
        progress_show(&bar, i);
    }
    progress_end(&bar);
    if (status == 0) {
        status = choose_lattice(p, &ground, p->first, f);
    }
    if (status == 0 && p->options.lattice.bits > 0) {
        snap_all(p, &in->m);
    }
    poses_weigh(&p->poses);
    return status == 0 ? sequence_begin(&p->code, &in->m, &p->options, p->first, f) : status;
}

int pack_frames_add(pack_frames *p, const pack_meshes *in, packed *image, fail *f) {
    progress bar;
    int status = sequence_add(&p->code, &in->m, p->first, f);
    progress_begin(&bar, "coding frames", p->range.count);
    for (unsigned i = 1; i < p->range.count && status == 0; i++) {
        mesh m = {0};
        status = read_frame(p, in, i, &m, f);
        if (status == 0) {
            status = sequence_add(&p->code, &m, p->first, f);
        }
        mesh_free(&m);
        progress_show(&bar, i);
    }
    progress_end(&bar);
    return status == 0 ? sequence_finish(&p->code, image, &in->m, p->first, f) : status;
}

void pack_frames_free(pack_frames *p) {
    sequence_free(&p->code);
    poses_free(&p->poses);
    free(p->first);
    p->first = NULL;
}
