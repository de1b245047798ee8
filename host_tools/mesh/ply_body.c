/* ply_body - see ply_body.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/ply_body.h"

/* Bytes of one item whose lists, `lists` of them, hold `values` values each. */
static uint64_t item_bytes(const ply_element *e, uint64_t values, unsigned *lists) {
    uint64_t bytes = 0;
    *lists = 0;
    for (size_t i = 0; i < e->properties; i++) {
        const ply_property *p = &e->property[i];
        bytes += p->is_list ? ply_type_bytes(p->count_type) + values * ply_type_bytes(p->type)
                            : ply_type_bytes(p->type);
        *lists += (unsigned)p->is_list;
    }
    return bytes;
}

static const ply_element *find_element(const ply_header *h, const char *name) {
    for (size_t i = 0; i < h->elements; i++) {
        if (word_is(h->element[i].name, name) && h->element[i].count > 0) {
            return &h->element[i];
        }
    }
    return NULL;
}

static int has_others(const ply_header *h) {
    int others = 0;
    for (size_t i = 0; i < h->elements; i++) {
        const ply_element *e = &h->element[i];
        others |= e->count > 0 && !word_is(e->name, "vertex") && !word_is(e->name, "face");
    }
    return others;
}

/* Bytes per vertex that the size leaves when all faces have `corners` corners; 0: none. */
static uint64_t vertex_bytes(const ply_element *vertex, const ply_element *face, uint64_t body,
                             uint64_t corners) {
    unsigned lists;
    const uint64_t each = item_bytes(face, corners, &lists);
    if (lists != 1 || each > body / face->count) {
        return 0;
    }
    const uint64_t left = body - each * face->count;
    return left % vertex->count == 0 ? left / vertex->count : 0;
}

int ply_body_check(const ply_header *h, const input *in, fail *f) {
    const ply_element *vertex = find_element(h, "vertex"), *face = find_element(h, "face");
    unsigned lists;
    if (h->format == PLY_ASCII || vertex == NULL || face == NULL || has_others(h)) {
        return 0;
    }
    const uint64_t said = item_bytes(vertex, 0, &lists);
    for (uint64_t corners = 3; corners <= 4 && lists == 0; corners++) {
        const uint64_t takes =
            vertex_bytes(vertex, face, (uint64_t)(h->data.end - h->data.at), corners);
        if (takes > said) {
            return fail_set(f, in->path,
                            "line %zu: the body does not fit the types of the header, by which a "
                            "vertex takes %llu bytes: it takes %llu; write the mesh as ASCII PLY "
                            "or OBJ",
                            vertex->line, (unsigned long long)said, (unsigned long long)takes);
        }
    }
    return 0;
}
