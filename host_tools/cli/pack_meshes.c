/* pack_meshes - see pack_meshes.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_meshes.h"

#include <inttypes.h>
#include <stdlib.h>

#include "host_tools/app/phase.h"
#include "host_tools/base/heap.h"
#include "host_tools/cli/pack_lines.h"
#include "host_tools/mesh/extent.h"
#include "host_tools/mesh/open_edges.h"
#include "host_tools/mesh/reduce.h"

static int out_of_memory(const char *path, fail *f) {
    return fail_set(f, path, "out of memory; use a larger machine");
}

/* A mesh in memory, with the file, is mostly below eight times the file: OBJ's quadrangles, of 10
 * bytes, are two triangles of 12, in arrays that grow by half, and a face. */
static void explain_reading(const pack_file *file, fail *f) {
    if (heap_refused() > 0) {
        f->text[0] = '\0';
        fail_set(f, pack_shown(file),
                 "reading it takes more than the %" PRIu64
                 " bytes that --memory gives; use "
                 "--memory %" PRIu64 " or more",
                 heap_limit_bytes(), 8 * heap_refused());
        heap_forget_refusal(); /* it has been said */
    }
}

static int read_file(pack_meshes *p, pack_file *file, fail *f) {
    const size_t vertices = p->m.vertices;
    file->first = p->m.triangles;
    file->report.repair = p->repair;
    file->report.centred = p->centre;
    phase_begin("reading", pack_shown(file));
    const int status = mesh_read(&p->m, file->path, p->frame, &file->report, f);
    phase_end();
    if (status != 0) {
        explain_reading(file, f);
    }
    file->end = p->m.triangles;
    file->vertices = p->m.vertices - vertices;
    return status;
}

/* Moves the meshes to their origin, which single precision may need. */
static int settle(pack_meshes *p, fail *f) {
    double centre[3];
    precision_centre(&p->m, centre);
    for (int axis = 0; axis < 3 && p->centre; axis++) {
        p->shift[axis] = centre[axis];
    }
    for (int i = 0; i < p->files; i++) {
        pack_file *file = &p->file[i];
        file->moved = precision_of(&p->m, file->first, file->end, p->shift);
        if (precision_matters(&file->moved)) {
            const precision at_centre = precision_of(&p->m, file->first, file->end, centre);
            file->centre_helps = !precision_matters(&at_centre);
        }
    }
    return precision_settle(&p->m, p->shift, pack_shown(&p->file[0]), f);
}

/* What is beside the point when memory is short. */
static int do_without_edges(pack_file *file) {
    if (heap_refused() == 0) {
        return -1;
    }
    heap_forget_refusal();
    file->edges_unknown = 1;
    file->open_edges = file->open_left = 0;
    file->open_distance = 0;
    return 0;
}

static int find_open(const pack_meshes *p, pack_file *file) {
    open_edges o;
    int status = open_edges_find(&o, &p->m, file->first, file->end);
    file->open_edges = o.count;
    if (status == 0) {
        status = weld_near_suggest(&p->m, file->first, file->end, &o, &file->open_distance,
                                   &file->open_left);
    }
    open_edges_free(&o);
    return status == 0 ? 0 : do_without_edges(file);
}

static int join_seams(pack_meshes *p, pack_file *file) {
    if (p->weld > 0 && weld_near(&p->m, file->first, file->end, p->weld, &file->welded) != 0) {
        return -1;
    }
    for (size_t i = file->first; i < file->end; i++) {
        file->without_area += (uint64_t)!mesh_has_area(&p->m, i);
    }
    return find_open(p, file);
}

static int look_at_files(pack_meshes *p, fail *f) {
    phase_begin("looking at the edges of", pack_shown(&p->file[0]));
    int status = 0;
    for (int i = 0; i < p->files && status == 0; i++) {
        status = join_seams(p, &p->file[i]);
    }
    phase_end();
    return status == 0 ? 0 : out_of_memory(pack_shown(&p->file[0]), f);
}

static int reduce(pack_meshes *p, fail *f) {
    const char *path = pack_shown(&p->file[0]);
    const size_t before = p->m.triangles;
    phase_begin("reducing", path);
    const int status = mesh_reduce(&p->m, p->most, path, f);
    phase_end();
    if (p->m.triangles < before) {
        free(p->mesh_end);
        p->mesh_end = NULL;
    }
    return status;
}

static int make_room(pack_meshes *p, char **path, int files, fail *f) {
    p->files = files;
    p->file = calloc((size_t)files, sizeof *p->file);
    p->mesh_end = calloc((size_t)files, sizeof *p->mesh_end);
    if (p->file == NULL || p->mesh_end == NULL) {
        return out_of_memory(path[0], f);
    }
    for (int i = 0; i < files; i++) {
        p->file[i].path = path[i];
    }
    return 0;
}

static int read_files(pack_meshes *p, fail *f) {
    uint64_t sequences = 0;
    for (int i = 0; i < p->files; i++) {
        if (read_file(p, &p->file[i], f) != 0) {
            return -1;
        }
        p->mesh_end[i] = p->m.triangles;
        sequences += p->file[i].report.sequences;
    }
    return p->has_frame && sequences == 0
               ? fail_set(f, pack_shown(&p->file[0]),
                          "has no sequence, so no frame %u; leave out --frame, or pack a recipe "
                          "that has one",
                          p->frame)
               : 0;
}

int pack_meshes_read(pack_meshes *p, char **path, int files, fail *f) {
    int status = make_room(p, path, files, f);
    if (status == 0) {
        status = read_files(p, f);
    }
    if (status == 0 && p->m.triangles == 0) {
        return pack_nothing_to_trace(&p->file[0], f);
    }
    if (status != 0 || settle(p, f) != 0) {
        return -1;
    }
    mesh_fit(&p->m);
    p->triangles = p->m.triangles;
    return 0;
}

int pack_meshes_prepare(pack_meshes *p, fail *f) {
    int status = look_at_files(p, f);
    if (status == 0 && p->most > 0) {
        status = reduce(p, f);
        mesh_fit(&p->m);
        p->triangles = p->m.triangles;
    }
    return status;
}

void pack_meshes_say(const pack_meshes *p) {
    for (int i = 0; i < p->files; i++) {
        pack_say_lines(&p->file[i]);
    }
}

void pack_meshes_free(pack_meshes *p) {
    mesh_free(&p->m);
    free(p->file);
    free(p->mesh_end);
    p->file = NULL;
    p->mesh_end = NULL;
}
