/* structure - see structure.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/structure.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/base/kind.h"
#include "host_tools/baselines/bih/bih_structure.h"
#include "host_tools/baselines/bkd/bkd_structure.h"
#include "host_tools/baselines/bph/bph_structure.h"
#include "host_tools/baselines/bvh/bvh_structure.h"
#include "host_tools/baselines/engine_structure.h"
#include "host_tools/baselines/kd/kd_structure.h"
#include "host_tools/baselines/treelet_trees/treelet_trees_structure.h"
#include "host_tools/baselines/treelets/treelets_structure.h"

/* Ids have 27 bits (tree/primitive_id.h). */
enum { MOST_TRIANGLES = 1 << 27 };

struct built_structure {
    const structure_kind *kind;
    void *self;
    size_t triangles;
};

static const structure_kind *const kinds[] = {
    &structure_tree,         &structure_tree_never,   &structure_tree_always,
    &structure_grid,         &structure_kd,           &structure_kd_boxes,
    &structure_kd_fast,      &structure_kd_lazy,      &structure_bvh,
    &structure_wbvh,         &structure_bkd,          &structure_bih,
    &structure_bph,          &structure_treelets,     &structure_bvh_treelets,
    &structure_bkd_treelets, &structure_bih_treelets, NULL};

const structure_kind *const *structure_kinds(void) {
    return kinds;
}

const structure_kind *structure_find(const char *name) {
    unsigned i = 0;
    while (kinds[i] != NULL && strcmp(kinds[i]->name, name) != 0) {
        i++;
    }
    return kinds[i];
}

const char *structure_name(const structure_kind *kind) {
    return kind->name;
}

const char *structure_about(const structure_kind *kind) {
    return kind->about;
}

const structure_switch *structure_switches(const structure_kind *kind) {
    static const structure_switch none[] = {{NULL, NULL, 0, 0}};
    return kind->switches != NULL ? kind->switches : none;
}

built_structure *structure_open(const structure_kind *kind, const mesh *m,
                                const structure_options *options, const char *name, fail *f) {
    if (m->triangles > MOST_TRIANGLES) {
        fail_set(f, name, "%zu triangles: more than %u; leave some out", m->triangles,
                 (unsigned)MOST_TRIANGLES);
        return NULL;
    }
    built_structure *s = heap_get(sizeof *s);
    void *self = s != NULL ? kind->open(kind->variant, m, options, name, f) : NULL;
    if (self == NULL) {
        heap_drop(s);
        fail_set(f, name, "out of memory; close other programs"); /* unless a reason is there */
        return NULL;
    }
    *s = (built_structure){.kind = kind, .self = self, .triangles = m->triangles};
    return s;
}

built_structure *structure_of_engine(plt_engine *engine, const char *name, fail *f) {
    built_structure *s = heap_get(sizeof *s);
    void *self = s != NULL ? engine_structure_of(engine, name) : NULL;
    if (self == NULL) {
        heap_drop(s);
        fail_set(f, name, "out of memory; close other programs");
        return NULL;
    }
    *s = (built_structure){&structure_opened, self, plt_engine_info(engine)->triangles};
    return s;
}

void structure_close(built_structure *s) {
    if (s != NULL) {
        s->kind->close(s->self);
        heap_drop(s);
    }
}

int structure_move(built_structure *s, const mesh *m, fail *f) {
    if (m->triangles != s->triangles) {
        return fail_set(f, s->kind->name, "%zu triangles cannot move to be %zu; open a new one",
                        s->triangles, m->triangles);
    }
    return s->kind->move(s->self, m, f);
}

int structure_trace(built_structure *s, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                    fail *f) {
    return s->kind->trace(s->self, rays, hits, count, any, f);
}

structure_statistics structure_count(const built_structure *s) {
    structure_statistics to;
    memset(&to, 0, sizeof to);
    s->kind->count(s->self, &to);
    return to;
}

void structure_forget(built_structure *s) {
    s->kind->forget(s->self);
}
