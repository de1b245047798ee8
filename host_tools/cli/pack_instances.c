/* pack_instances - see pack_instances.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_instances.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/app/phase.h"
#include "host_tools/base/heap.h"
#include "host_tools/cli/pack_meshes.h"
#include "host_tools/pack/instance_list.h"
#include "host_tools/pack/instances.h"

void pack_instances_read(pack_instances_order *o, args *a) {
    static const char *const others[] = {"--sequence", "--frame",   "--centre", "--origin",
                                         "--reduce",   "--memory",  "--json",   "--checks",
                                         "--smooth",   "--normals", "--colours"};
    o->wanted = args_has(a, "--instances");
    if (!o->wanted) {
        return;
    }
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (args_has(a, others[i])) {
            args_complain(a, "%s is not for --instances", others[i]);
        }
    }
    if (a->files != 1) {
        args_complain(a, "--instances takes one text, which names the meshes");
    }
    o->frame_rate = (uint32_t)args_number(a, "--rate", 25, 1, PLT_FRAME_RATE_MOST);
}

/* ---- bodies ----------------------------------------------------------------------- */

static int pack_body(packed *to, pack_meshes *in, const pack_instances_order *o,
                     const pack_options *options, const char *path, fail *f) {
    quality_stats quality;
    phase_begin("building the tree of", path);
    const int status =
        o->is_high ? pack_mesh_better(to, &in->m, options, o->quality_seconds, &quality, path, f)
                   : pack_mesh(to, &in->m, options, path, f);
    phase_end();
    return status;
}

static int read_body(packed *to, const instance_list *l, uint32_t body,
                     const pack_instances_order *o, const pack_options *options, fail *f) {
    pack_meshes in = {.repair = o->repair, .weld = o->weld};
    fail why = {""};
    char *path = instance_list_mesh(l, body);
    if (path == NULL) {
        return fail_set(f, l->in.path, "out of memory; close other programs");
    }
    int status = strcmp(path, "-") == 0 ? fail_set(&why, path, "is standard input; name a file")
                                        : pack_meshes_read(&in, &path, 1, &why);
    if (status == 0) {
        status = pack_meshes_prepare(&in, &why);
    }
    if (status == 0) {
        status = pack_body(to, &in, o, options, path, &why);
    }
    if (status == 0) {
        pack_meshes_say(&in);
    } else {
        fail_set(f, l->in.path, "line %zu: %s", l->mesh[body].line, why.text);
    }
    pack_meshes_free(&in);
    heap_drop(path);
    return status;
}

/* ---- matrices --------------------------------------------------------------------- */

static const float AT_HOME[PLT_MATRIX_FLOATS] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

/* What the engine would refuse, with its line. */
static int check_setting(const instance_list *l, const packed *body, const instance_setting *s,
                         fail *f) {
    const instance_name *n = &l->instance[s->instance];
    plt_box box;
    return instances_place(body, s->matrix, &box)
               ? 0
               : fail_set(f, l->in.path,
                          "line %zu: frame %" PRIu32
                          ": the matrix of '%.*s' cannot be inverted, "
                          "or places its body beyond 2^40; write one that turns, moves and scales",
                          s->line, s->frame, (int)(n->length < 40 ? n->length : 40), n->text);
}

/* The engine would refuse the first frame: a body that no line has moved lies too far out. */
static int check_home(const instance_list *l, const packed *body, uint32_t instance, fail *f) {
    const instance_name *n = &l->instance[instance];
    plt_box box;
    return instances_place(body, AT_HOME, &box)
               ? 0
               : fail_set(f, l->in.path,
                          "line %zu: where it is, the body of '%.*s' is not within 2^40; "
                          "write a frame 0 that moves it closer",
                          n->line, (int)(n->length < 40 ? n->length : 40), n->text);
}

/* Once lines of frame 0 have been read. */
static int check_homes(const instance_list *l, const instance_set *all,
                       const float (*matrix)[PLT_MATRIX_FLOATS], fail *f) {
    int status = 0;
    for (uint32_t i = 0; i < l->instances && status == 0; i++) {
        if (memcmp(matrix[i], AT_HOME, sizeof AT_HOME) == 0) {
            status = check_home(l, &all->body[l->body_of[i]], i, f);
        }
    }
    return status;
}

static int add_frames(packed *image, const instance_list *l, const instance_set *all, fail *f) {
    float(*matrix)[PLT_MATRIX_FLOATS] = heap_get((uint64_t)l->instances * sizeof *matrix);
    size_t at = 0;
    int status = 0;
    if (matrix == NULL) {
        return fail_set(f, l->in.path, "out of memory; close other programs");
    }
    for (uint32_t i = 0; i < l->instances; i++) {
        memcpy(matrix[i], AT_HOME, sizeof AT_HOME);
    }
    for (uint32_t k = 0; k < l->frames && status == 0; k++) {
        for (; at < l->settings && l->setting[at].frame == k && status == 0; at++) {
            const instance_setting *s = &l->setting[at];
            memcpy(matrix[s->instance], s->matrix, sizeof s->matrix);
            status = check_setting(l, &all->body[l->body_of[s->instance]], s, f);
        }
        if (status == 0 && k == 0) {
            status = check_homes(l, all, (const float(*)[PLT_MATRIX_FLOATS])matrix, f);
        }
        if (status == 0) {
            instances_frame(image, all, k, (const float(*)[PLT_MATRIX_FLOATS])matrix);
        }
    }
    heap_drop(matrix);
    return status;
}

static int put_together(packed *image, const instance_list *l, const packed *body,
                        const pack_instances_order *o, fail *f) {
    const instance_set all = {.body = body,
                              .bodies = l->bodies,
                              .body_of = l->body_of,
                              .instances = l->instances,
                              .frames = l->frames,
                              .frame_rate = o->frame_rate};
    int status = instances_begin(image, &all, l->in.path, f);
    if (status == 0) {
        status = add_frames(image, l, &all, f);
    }
    if (status == 0) {
        instances_finish(image);
    }
    return status;
}

int pack_instances(packed *image, const char *path, const pack_instances_order *o,
                   const pack_options *options, fail *f) {
    instance_list l;
    int status = instance_list_read(&l, path, f);
    packed *body = status == 0 ? heap_get_zeroed((uint64_t)l.bodies * sizeof *body) : NULL;
    if (status == 0 && body == NULL) {
        status = fail_set(f, path, "out of memory; close other programs");
    }
    for (uint32_t i = 0; i < l.bodies && status == 0; i++) {
        status = read_body(&body[i], &l, i, o, options, f);
    }
    if (status == 0) {
        status = put_together(image, &l, body, o, f);
    }
    for (uint32_t i = 0; i < l.bodies && body != NULL; i++) {
        pack_free(&body[i]);
    }
    heap_drop(body);
    instance_list_free(&l);
    return status;
}
