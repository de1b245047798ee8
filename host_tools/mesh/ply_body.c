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

/* Properties of one byte, as colours are: written as floats they take three bytes more. */
static uint64_t byte_properties(const ply_element *e) {
    uint64_t count = 0;
    for (size_t i = 0; i < e->properties; i++) {
        count += !e->property[i].is_list && ply_type_bytes(e->property[i].type) == 1;
    }
    return count;
}

int ply_body_check(const ply_header *h, const input *in, fail *f) {
    const ply_element *vertex = find_element(h, "vertex"), *face = find_element(h, "face");
    if (h->format == PLY_ASCII || vertex == NULL || face == NULL || has_others(h)) {
        return 0;
    }
    unsigned lists, face_lists;
    const uint64_t said = item_bytes(vertex, 0, &lists), bytes = byte_properties(vertex);
    const uint64_t takes = said + 3 * bytes, body = (uint64_t)(h->data.end - h->data.at);
    const uint64_t least = item_bytes(face, 3, &face_lists);
    if (lists > 0 || face_lists != 1 || bytes == 0 || takes > body / vertex->count) {
        return 0;
    }
    /* All triangles, or all quads. */
    const uint64_t left = body - takes * vertex->count, each = left / face->count;
    if (left % face->count != 0 || (each != least && each != item_bytes(face, 4, &face_lists))) {
        return 0;
    }
    return fail_set(f, in->path,
                    "line %zu: the body does not fit the types of the header, by which a vertex "
                    "takes %llu bytes: it takes %llu; write the mesh as ASCII PLY or OBJ",
                    vertex->line, (unsigned long long)said, (unsigned long long)takes);
}
